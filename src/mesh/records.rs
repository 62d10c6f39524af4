//! The rows of the tables of a mesh.
//!
//! A halfedge stores its six pointers side by side (24 bytes); vertices, edges and faces each store
//! one of their halfedges. Whether an element is alive is written inside its own record, so testing
//! it costs no further memory access. Which faces are holes is a table of bytes, small enough to
//! stay in a cache; it also tells which are alive.

use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};

/// The pointers of a halfedge. `vertex` is its origin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfedgeRecord {
    pub next: HalfedgeId,
    pub prev: HalfedgeId,
    pub twin: HalfedgeId,
    pub vertex: VertexId,
    pub edge: EdgeId,
    pub face: FaceId,
}

impl HalfedgeRecord {
    pub(crate) const UNSET: Self = Self {
        next: HalfedgeId::NONE,
        prev: HalfedgeId::NONE,
        twin: HalfedgeId::NONE,
        vertex: VertexId::NONE,
        edge: EdgeId::NONE,
        face: FaceId::NONE,
    };

    #[inline]
    pub(super) fn lives(&self) -> bool {
        self.next != HalfedgeId::DEAD
    }

    /// The pointers, in the order in which they are declared.
    #[inline]
    pub(crate) fn pointers(&self) -> [u32; 6] {
        let Self { next, prev, twin, vertex, edge, face } = self;
        [next.0, prev.0, twin.0, vertex.0, edge.0, face.0]
    }

    /// A pointer, by its index in [`pointers`](Self::pointers).
    #[inline]
    pub(crate) fn pointer_mut(&mut self, index: usize) -> &mut u32 {
        match index {
            0 => &mut self.next.0,
            1 => &mut self.prev.0,
            2 => &mut self.twin.0,
            3 => &mut self.vertex.0,
            4 => &mut self.edge.0,
            _ => &mut self.face.0,
        }
    }
}

/// The state of a slot of the table of faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum FaceState {
    Face = 0,
    Hole = 1,
    Dead = 2,
}

impl FaceState {
    #[inline]
    pub(crate) fn of_living(hole: bool) -> Self {
        if hole { Self::Hole } else { Self::Face }
    }

    /// Whether it is a hole; `None` if it is dead.
    #[inline]
    pub(super) fn is_hole(self) -> Option<bool> {
        (self != Self::Dead).then_some(self == Self::Hole)
    }
}

/// The dead slots of one kind.
#[derive(Clone, Debug, Default)]
pub(super) struct Slots {
    pub(super) free: Vec<u32>,
    pub(super) pending: Vec<u32>,
}

impl Slots {
    pub(super) fn unused(&self) -> usize {
        self.free.len() + self.pending.len()
    }
}
