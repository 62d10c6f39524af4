//! The ids of elements: newtypes over `u32`, one per kind.
//!
//! An id is only a number, also as serde writes it: it does not say which mesh it belongs to or
//! whether the element is alive. Two numbers are reserved: that of [`VertexId::NONE`] and its
//! counterparts stands for "no element", and the one before it marks the slot of an erased element
//! inside the tables of a mesh, where no reader can see it.

use std::fmt;

use serde::{Deserialize, Serialize};

/// The kinds of elements of a halfedge mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ElementKind {
    Vertex,
    Halfedge,
    Edge,
    Face,
}

impl ElementKind {
    /// All kinds, in the order in which tables over kinds are laid out.
    pub const ALL: [Self; 4] = [Self::Vertex, Self::Halfedge, Self::Edge, Self::Face];

    /// The kind of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    pub fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::Halfedge => "halfedge",
            Self::Edge => "edge",
            Self::Face => "face",
        }
    }

    pub fn plural(self) -> &'static str {
        match self {
            Self::Vertex => "vertices",
            Self::Halfedge => "halfedges",
            Self::Edge => "edges",
            Self::Face => "faces",
        }
    }
}

/// The elements that a loop over the whole mesh visits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elements {
    Vertices,
    Halfedges,
    Edges,
    /// The faces that are not holes.
    Faces,
    Holes,
}

impl Elements {
    /// All elements of a kind, except holes.
    pub(crate) fn of(kind: ElementKind) -> Self {
        match kind {
            ElementKind::Vertex => Self::Vertices,
            ElementKind::Halfedge => Self::Halfedges,
            ElementKind::Edge => Self::Edges,
            ElementKind::Face => Self::Faces,
        }
    }

    /// The kind of the elements.
    pub fn kind(self) -> ElementKind {
        match self {
            Self::Vertices => ElementKind::Vertex,
            Self::Halfedges => ElementKind::Halfedge,
            Self::Edges => ElementKind::Edge,
            Self::Faces | Self::Holes => ElementKind::Face,
        }
    }
}

impl fmt::Display for ElementKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

macro_rules! element_id {
    ($(#[$doc:meta])* $id:ident, $kind:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[repr(transparent)]
        pub struct $id(pub u32);

        impl $id {
            pub const KIND: ElementKind = ElementKind::$kind;

            /// Stands for "no element".
            pub const NONE: Self = Self(u32::MAX);

            #[inline]
            pub fn index(self) -> usize {
                self.0 as usize
            }

            #[inline]
            pub fn is_none(self) -> bool {
                self == Self::NONE
            }
        }

        impl From<$id> for Element {
            fn from(id: $id) -> Self {
                Self { kind: $id::KIND, index: id.0 }
            }
        }

        impl TryFrom<Element> for $id {
            type Error = OtherKind;

            fn try_from(element: Element) -> Result<Self, OtherKind> {
                match element.kind {
                    ElementKind::$kind => Ok(Self(element.index)),
                    _ => Err(OtherKind { element, wanted: $id::KIND }),
                }
            }
        }

        /// `vertex 3`, or `no vertex`.
        impl fmt::Display for $id {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                Element::from(*self).fmt(f)
            }
        }

        impl fmt::Debug for $id {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }
    };
}

element_id!(
    /// A vertex.
    VertexId,
    Vertex
);
element_id!(
    /// A halfedge: one side of an edge, running from its origin along a face.
    HalfedgeId,
    Halfedge
);
element_id!(
    /// An edge: two halfedges that are twins.
    EdgeId,
    Edge
);
element_id!(
    /// A face or a hole: a cycle of `next`.
    FaceId,
    Face
);

impl HalfedgeId {
    /// Written over the first pointer of an erased element, whatever its kind.
    pub(super) const DEAD: Self = Self(u32::MAX - 1);
}

/// The number of ids that a kind can have: all of `u32` but the two reserved.
pub(super) const ID_SPACE: usize = u32::MAX as usize - 1;

/// An element of any kind.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
pub struct Element {
    pub kind: ElementKind,
    pub index: u32,
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.index == u32::MAX {
            write!(f, "no {}", self.kind)
        } else {
            write!(f, "{} {}", self.kind, self.index)
        }
    }
}

impl fmt::Debug for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The error for an element of another kind than the wanted one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OtherKind {
    pub element: Element,
    pub wanted: ElementKind,
}

impl fmt::Display for OtherKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is not of kind {}", self.element, self.wanted)
    }
}

impl std::error::Error for OtherKind {}
