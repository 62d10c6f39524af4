//! Operands of instructions: pointers, walks, sorts of elements, functions.

use crate::mesh::ElementKind;

/// A pointer of a halfedge, in the order of its record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum HalfedgeField {
    Next,
    Prev,
    Twin,
    Vertex,
    Edge,
    Face,
}

/// The `halfedge` pointer of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ElementField {
    Vertex,
    Edge,
    Face,
}

/// The part of a buffer that belongs to an index: another buffer tells where the parts end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The buffer of all parts.
    pub buffer: u16,
    /// For each index the end of its part.
    pub ends: u16,
    /// The shift of the index, around the cycle.
    pub shift: i16,
}

/// So many new elements of each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Room {
    pub vertices: u16,
    pub halfedges: u16,
    pub edges: u16,
    pub faces: u16,
}

/// The way in which a run of halfedges is walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Walk {
    /// Along a loop: `h.next`.
    Loop,
    /// Around a vertex, counterclockwise: `h.prev.twin`.
    Star,
}

/// The elements a loop over the whole mesh visits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elements {
    Vertices,
    Halfedges,
    Edges,
    /// Faces that are not holes.
    Faces,
    Holes,
}

impl Elements {
    /// Their kind.
    pub fn kind(self) -> ElementKind {
        match self {
            Elements::Vertices => ElementKind::Vertex,
            Elements::Halfedges => ElementKind::Halfedge,
            Elements::Edges => ElementKind::Edge,
            Elements::Faces | Elements::Holes => ElementKind::Face,
        }
    }
}

/// Which triangles a face is cut into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Triangles {
    /// The best shaped ear first.
    BestShape,
    /// Those that bend the least, if the face has few sides.
    LeastBend,
}

/// A function of reals: `f64 -> f64`, or with two or three operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Math {
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Log,
    Floor,
    Ceil,
    Abs,
    Negate,
}
