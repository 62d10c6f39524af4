//! Memory of a mesh, and room reserved for further elements.
//!
//! The memory of the tables, the columns and the journal is counted by capacity, used or not. To
//! approach a limit without passing it, a table takes no more than half of what is left, unless it
//! needs more.

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};
use super::records::{FaceState, HalfedgeRecord};

impl Mesh {
    /// The memory that the mesh takes, in bytes.
    pub fn bytes(&self) -> usize {
        let tables = self.halfedges.capacity() * size_of::<HalfedgeRecord>()
            + [&self.vertices, &self.edges, &self.faces].map(Vec::capacity).iter().sum::<usize>()
                * size_of::<HalfedgeId>()
            + self.face_states.capacity() * size_of::<FaceState>()
            + self.positions.capacity() * size_of::<DVec3>();
        let slots = self.slots.iter().map(|slots| slots.free.capacity() + slots.pending.capacity());
        let columns = self.columns.iter().map(|columns| columns.bytes());
        tables
            + slots.sum::<usize>() * size_of::<u32>()
            + columns.sum::<usize>()
            + self.journal.bytes()
    }

    /// Makes room for `more` further elements of each kind, without taking more than `limit` bytes
    /// in total. Returns whether there is room.
    #[inline]
    pub fn make_room(&mut self, more: [usize; 4], limit: impl FnOnce() -> usize) -> bool {
        let fits = ElementKind::ALL.into_iter().zip(more).all(|(kind, more)| {
            let free = self.slots[kind as usize].free.len();
            more <= free || more - free <= self.reserved(kind)
        });
        fits || self.grow(more, limit())
    }

    #[cold]
    fn grow(&mut self, more: [usize; 4], limit: usize) -> bool {
        for (kind, more) in ElementKind::ALL.into_iter().zip(more) {
            let more = more.saturating_sub(self.slots[kind as usize].free.len());
            let len = self.capacity(kind);
            if more <= self.reserved(kind) {
                continue;
            }
            let record = match kind {
                ElementKind::Vertex => size_of::<HalfedgeId>() + size_of::<DVec3>(),
                ElementKind::Halfedge => size_of::<HalfedgeRecord>(),
                ElementKind::Edge => size_of::<HalfedgeId>(),
                ElementKind::Face => size_of::<HalfedgeId>() + size_of::<FaceState>(),
            };
            let each = record + self.columns[kind as usize].bytes_of_one();
            let left = limit.saturating_sub(self.bytes()) / each;
            if left < more {
                return false;
            }
            let wanted = len.max(more).max(64).min((left / 2).max(more));
            if !self.reserve(kind, wanted) {
                return false;
            }
        }
        true
    }

    /// The number of further slots that fit without allocation.
    #[inline]
    pub(super) fn reserved(&self, kind: ElementKind) -> usize {
        let room = match kind {
            ElementKind::Vertex => self.vertices.capacity().min(self.positions.capacity()),
            ElementKind::Halfedge => self.halfedges.capacity(),
            ElementKind::Edge => self.edges.capacity(),
            ElementKind::Face => self.faces.capacity().min(self.face_states.capacity()),
        };
        room - self.capacity(kind)
    }

    fn reserve(&mut self, kind: ElementKind, more: usize) -> bool {
        let table = match kind {
            ElementKind::Vertex => {
                let table = self.vertices.try_reserve_exact(more);
                table.and_then(|()| self.positions.try_reserve_exact(more))
            }
            ElementKind::Halfedge => self.halfedges.try_reserve_exact(more),
            ElementKind::Edge => self.edges.try_reserve_exact(more),
            ElementKind::Face => {
                let table = self.faces.try_reserve_exact(more);
                table.and_then(|()| self.face_states.try_reserve_exact(more))
            }
        };
        table.is_ok() && self.columns[kind as usize].reserve(more)
    }
}
