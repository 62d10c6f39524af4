//! The tables of a mesh in memory, for code that is generated at run time.
//!
//! Addresses are handed out, and nothing is read or written through them here. They are valid until
//! an element is added or the mesh is moved.

use glam::DVec3;

use super::attribute::{Column, ColumnData, ColumnId};
use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId, ID_SPACE};
pub(crate) use super::records::FaceState;
use super::records::HalfedgeRecord;

/// The addresses of the tables, and their numbers of records.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Tables {
    pub(crate) halfedges: *mut HalfedgeRecord,
    pub(crate) halfedge_count: usize,
    pub(crate) vertices: *mut HalfedgeId,
    pub(crate) vertex_count: usize,
    pub(crate) edges: *mut HalfedgeId,
    pub(crate) edge_count: usize,
    pub(crate) faces: *mut HalfedgeId,
    pub(crate) face_count: usize,
    pub(crate) face_states: *mut FaceState,
    pub(crate) positions: *mut DVec3,
    /// The number of holes.
    pub(crate) holes: *mut usize,
    /// By kind, a number of further elements that fit without allocation.
    pub(crate) room: [usize; 4],
}

/// The first pointer of an erased element.
pub(crate) const DEAD: u32 = HalfedgeId::DEAD.0;

impl Mesh {
    /// The tables of the mesh.
    #[inline]
    pub(crate) fn tables(&mut self) -> Tables {
        Tables {
            halfedges: self.halfedges.as_mut_ptr(),
            halfedge_count: self.halfedges.len(),
            vertices: self.vertices.as_mut_ptr(),
            // Each vertex has a position.
            vertex_count: self.vertices.len().min(self.positions.len()),
            edges: self.edges.as_mut_ptr(),
            edge_count: self.edges.len(),
            faces: self.faces.as_mut_ptr(),
            // Each face has a state.
            face_count: self.faces.len().min(self.face_states.len()),
            face_states: self.face_states.as_mut_ptr(),
            positions: self.positions.as_mut_ptr(),
            holes: &raw mut self.holes,
            room: ElementKind::ALL.map(|kind| self.room(kind)),
        }
    }

    /// The address of the values of a column, and their number.
    #[inline]
    pub(crate) fn values_in_memory(&mut self, column: ColumnId) -> (*mut u8, usize) {
        self.column_data_mut(column).map_or((std::ptr::null_mut(), 0), ColumnData::memory_mut)
    }

    /// As [`Mesh::values_in_memory`], for reading only.
    #[inline]
    pub(crate) fn values_to_read(&self, column: ColumnId) -> (*mut u8, usize) {
        let data = self.column(column).map(Column::data);
        let (start, count) = data.map_or((std::ptr::null(), 0), ColumnData::memory);
        (start.cast_mut(), count)
    }

    /// The number of further elements of a kind that fit without allocation.
    #[inline]
    fn room(&self, kind: ElementKind) -> usize {
        let reserved = self.reserved(kind).min(ID_SPACE - self.capacity(kind));
        self.slots[kind as usize].free.len() + reserved
    }
}

impl Tables {
    /// True if `more` further elements of each kind fit without allocation.
    #[inline]
    pub(crate) fn has_room(&self, more: [usize; 4]) -> bool {
        self.room.iter().zip(more).all(|(&room, more)| more <= room)
    }

    /// Updates the numbers after elements have been appended without allocation.
    #[inline]
    pub(crate) fn appended(&mut self, counts: [usize; 4]) {
        for (room, count) in self.room.iter_mut().zip(counts) {
            *room -= count;
        }
        let [vertices, halfedges, edges, faces] = counts;
        self.vertex_count += vertices;
        self.halfedge_count += halfedges;
        self.edge_count += edges;
        self.face_count += faces;
    }
}
