//! How a rule is matched: an order of pointer loads and tests that binds every name.
//!
//! Matching never searches. Starting from the parameters, each name follows from one that
//! is bound by one pointer; what the drawing claims beyond that is tested. The proof holds
//! for every place where these tests pass.

use crate::diagram::{LoopKind, NameId};

/// Something that gets bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bound {
    /// An element.
    Element(NameId),
    /// The first halfedge of a path; of an empty one, what follows it.
    First(NameId),
    /// The last halfedge of a path; of an empty one, what precedes it.
    Last(NameId),
}

/// One pointer away from something bound. Halfedges, but for the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// `h.next`
    Next(Bound),
    /// `h.prev`
    Prev(Bound),
    /// `h.twin`
    Twin(Bound),
    /// `h.vertex`, the origin.
    Origin(Bound),
    /// `h.next.vertex`
    Target(Bound),
    /// `h.edge`
    Edge(Bound),
    /// `h.face`
    Face(Bound),
    /// `h.prev.twin`, the next spoke counterclockwise.
    Counterclockwise(Bound),
    /// `h.twin.next`, the next spoke clockwise.
    Clockwise(Bound),
    /// `f.halfedge`
    FaceHalfedge(NameId),
}

/// One step of matching.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A parameter whose element is drawn binds the name.
    Parameter {
        /// Which parameter.
        parameter: usize,
        /// The name.
        name: NameId,
    },
    /// The halfedge to begin with at an edge, vertex or face that a parameter gives; if
    /// what follows fails, the next one is tried.
    Attempt {
        /// The edge, vertex or face.
        element: NameId,
        /// The halfedge that is bound.
        halfedge: NameId,
    },
    /// Binds a name.
    Bind {
        /// The name.
        name: Bound,
        /// Where it comes from.
        source: Source,
    },
    /// What must hold.
    Test(Claim),
}

/// What a drawing claims.
#[derive(Clone, Debug, PartialEq)]
pub enum Claim {
    /// The pointer leads to the name.
    Leads(Source, Bound),
    /// Two names are two elements.
    Distinct(NameId, NameId),
    /// The loop is a face, or a hole.
    Kind(NameId, LoopKind),
    /// Going along the loop, or around the vertex counterclockwise, from the first halfedge,
    /// the second comes before the third.
    InOrder {
        /// Whether along a loop; else around a vertex.
        along_loop: bool,
        /// From, goal, stop.
        halfedges: [NameId; 3],
    },
    /// Not all of these paths are empty.
    NotAllEmpty(Vec<NameId>),
}
