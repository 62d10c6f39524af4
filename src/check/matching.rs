//! Matching: an order of pointer loads and tests that binds every name.
//!
//! Matching never searches. Starting from the parameters, each name follows from one that
//! is bound by one pointer; what the drawing claims beyond that is tested. The proof holds
//! for every place where these tests pass.
//!
//! For a rule with families, the names are those of the rule unrolled; a step with members of
//! families stands for one at each index, written out for index 0.

use crate::diagram::{LoopKind, NameId, Pointer, Rule};

/// A name, or an end of a path, that is bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bound {
    Element(NameId),
    /// The first halfedge of a path; of an empty one, what follows it.
    First(NameId),
    /// The last halfedge of a path; of an empty one, what precedes it.
    Last(NameId),
}

/// One or two pointers from something bound: a halfedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Source {
    pub way: Way,
    pub from: Bound,
}

/// One or two pointers from a halfedge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// `h.next`
    Next,
    /// `h.prev`
    Prev,
    /// `h.twin`
    Twin,
    /// `h.vertex`, the origin.
    Origin,
    /// `h.next.vertex`
    Target,
    /// `h.edge`
    Edge,
    /// `h.face`
    Face,
    /// `h.prev.twin`, the next spoke counterclockwise.
    Counterclockwise,
    /// `h.twin.next`, the next spoke clockwise.
    Clockwise,
}

/// One step of matching.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A parameter whose element is drawn binds the name.
    Parameter {
        parameter: usize,
        name: NameId,
    },
    /// The halfedge to begin with at an edge, vertex or face that a parameter gives; if
    /// what follows fails, the next one is tried.
    Attempt {
        /// The edge, vertex or face.
        element: NameId,
        /// The halfedge that is bound, or the path whose first halfedge is, if it is the whole
        /// loop.
        halfedge: NameId,
        /// The number that are tried, if not all: further ones would match alike.
        tries: Option<u16>,
    },
    /// Walks an orbit that is drawn with `each`, once around, from a halfedge that is known.
    /// The halfedges are those of one period; they bind their families.
    Walk {
        /// The face or vertex.
        orbit: NameId,
        /// One period, the known halfedge first.
        halfedges: Vec<NameId>,
    },
    /// Binds a name.
    Bind {
        name: Bound,
        source: Source,
    },
    Test(Claim),
}

/// A claim of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Claim {
    /// The pointer leads to the name.
    Leads(Source, Bound),
    /// Two names are different elements.
    Distinct(NameId, NameId),
    /// The loop is a face, or a hole.
    Kind(NameId, LoopKind),
    /// Going along the loop, or around the vertex counterclockwise, from the first halfedge,
    /// the second comes before the third.
    InOrder {
        /// True if along a loop; else around a vertex.
        along_loop: bool,
        /// From, goal, stop.
        halfedges: [NameId; 3],
    },
    /// Not all of these paths are empty.
    NotAllEmpty(Vec<NameId>),
    /// If the vertex of the halfedge is the same as another one, the halfedge is one of the spokes
    /// that the statement of that one lists.
    Listed {
        halfedge: NameId,
        /// Its vertex, and the one that has a statement.
        vertices: [NameId; 2],
        /// The spokes it lists.
        spokes: Vec<NameId>,
    },
    /// The member at index 0 of a family is the halfedge that was given.
    Begins(NameId),
    /// All these names, and all members of the families among them, are different elements.
    AllDistinct(Vec<NameId>),
    /// Going along the loop, or around the vertex, the halfedges of a period follow each other
    /// index by index, once around.
    AroundInOrder {
        /// True if along a loop; else around a vertex.
        along_loop: bool,
        /// Those of one period.
        halfedges: Vec<NameId>,
    },
    /// Not all members of these families of paths are empty.
    NotAllEmptyAround(Vec<NameId>),
}

impl Bound {
    pub fn name(self) -> NameId {
        match self {
            Bound::Element(name) | Bound::First(name) | Bound::Last(name) => name,
        }
    }

    /// The same for another name.
    pub fn map(self, image: impl FnOnce(NameId) -> NameId) -> Self {
        match self {
            Bound::Element(name) => Bound::Element(image(name)),
            Bound::First(name) => Bound::First(image(name)),
            Bound::Last(name) => Bound::Last(image(name)),
        }
    }
}

impl Way {
    /// The way from a halfedge that is bound.
    pub fn of(self, from: Bound) -> Source {
        Source { way: self, from }
    }
}

impl Source {
    /// The pointers that lead from there.
    pub fn pointers(self) -> &'static [Pointer] {
        match self.way {
            Way::Next => &[Pointer::Next],
            Way::Prev => &[Pointer::Prev],
            Way::Twin => &[Pointer::Twin],
            Way::Origin => &[Pointer::Vertex],
            Way::Target => &[Pointer::Next, Pointer::Vertex],
            Way::Edge => &[Pointer::Edge],
            Way::Face => &[Pointer::Face],
            Way::Counterclockwise => &[Pointer::Prev, Pointer::Twin],
            Way::Clockwise => &[Pointer::Twin, Pointer::Next],
        }
    }

    /// The same from another name.
    pub fn map(self, image: impl FnOnce(NameId) -> NameId) -> Self {
        self.way.of(self.from.map(image))
    }

    /// The same for the member that is `by` further around the cycle.
    pub fn turned(self, rule: &Rule, by: i64) -> Self {
        self.map(|name| rule.turned(name, by))
    }
}

impl Claim {
    /// The names that it is about, in order.
    pub fn names(&self) -> Vec<NameId> {
        match self {
            Claim::Leads(source, to) => vec![source.from.name(), to.name()],
            Claim::Distinct(left, right) => vec![*left, *right],
            Claim::Kind(face, _) => vec![*face],
            Claim::InOrder { halfedges, .. } => halfedges.to_vec(),
            Claim::NotAllEmpty(names)
            | Claim::AllDistinct(names)
            | Claim::AroundInOrder { halfedges: names, .. }
            | Claim::NotAllEmptyAround(names) => names.clone(),
            Claim::Listed { halfedge, .. } => vec![*halfedge],
            Claim::Begins(name) => vec![*name],
        }
    }

    /// True if it is made once for every index, though its names are members at one index.
    pub fn is_repeated(&self, rule: &Rule) -> bool {
        match self {
            Claim::Begins(_)
            | Claim::AllDistinct(_)
            | Claim::AroundInOrder { .. }
            | Claim::NotAllEmptyAround(_) => false,
            _ => self.names().iter().any(|&name| rule.is_member(name)),
        }
    }
}
