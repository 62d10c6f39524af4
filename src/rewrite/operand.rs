//! Operands of instructions: pointers, walks, kinds of elements, functions.

/// A pointer of a halfedge, in the order of the fields of its record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum HalfedgeField {
    Next,
    Prev,
    Twin,
    Vertex,
    Edge,
    Face,
}

impl HalfedgeField {
    pub(super) const ALL: [Self; 6] =
        [Self::Next, Self::Prev, Self::Twin, Self::Vertex, Self::Edge, Self::Face];
}

/// The `halfedge` pointer of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ElementField {
    Vertex,
    Edge,
    Face,
}

/// The part of a buffer that belongs to an index: another buffer holds the ends of the parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// The buffer of all parts.
    pub buffer: u16,
    /// The buffer of the ends, one for each index.
    pub ends: u16,
    /// The offset that is added to the index, modulo the length of the cycle.
    pub shift: i16,
}

/// The number of new elements of each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Room {
    pub vertices: u16,
    pub halfedges: u16,
    pub edges: u16,
    pub faces: u16,
}

/// The direction in which halfedges are walked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Walk {
    /// Along a loop: `h.next`.
    Loop,
    /// Around a vertex, counterclockwise: `h.prev.twin`.
    Star,
}

/// The way in which a face is triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Triangles {
    /// Cuts off the ear of the best shape first.
    BestShape,
    /// Minimizes the bending, if the face has few sides.
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
