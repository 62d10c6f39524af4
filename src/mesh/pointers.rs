//! Reading and writing single fields of a mesh.
//!
//! The plain readers and writers take ids that are in range; the `get_` readers take any id and
//! return `None` for elements that are not alive. A writer writes one field, and the mesh may be
//! broken until the last of a group of writes.

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::records::{FaceState, HalfedgeRecord};

/// Defines the readers and the writer of each pointer of a halfedge.
macro_rules! pointers_of_halfedges {
    ($($(#[$doc:meta])* $pointer:ident, $get:ident, $set:ident: $id:ty;)*) => {
        impl Mesh {$(
            $(#[$doc])*
            #[inline]
            pub fn $pointer(&self, h: HalfedgeId) -> $id {
                self.halfedge(h).$pointer
            }

            /// The same for any id: `None` if it is out of range or erased.
            #[inline]
            pub fn $get(&self, h: HalfedgeId) -> Option<$id> {
                Some(self.get_halfedge(h)?.$pointer)
            }

            #[inline]
            pub fn $set(&mut self, h: HalfedgeId, $pointer: $id) {
                self.halfedge_mut(h).$pointer = $pointer;
            }
        )*}
    };
}

pointers_of_halfedges! {
    next, get_next, set_next: HalfedgeId;
    prev, get_prev, set_prev: HalfedgeId;
    twin, get_twin, set_twin: HalfedgeId;
    /// The origin.
    vertex, get_vertex, set_vertex: VertexId;
    edge, get_edge, set_edge: EdgeId;
    face, get_face, set_face: FaceId;
}

/// Defines the readers and the writer of the halfedge of a vertex, edge or face, which is in a
/// column, and which a journal is told of by a method.
macro_rules! pointers_to_halfedges {
    ($($(#[$doc:meta])* $first:ident, $get:ident, $set:ident: $id:ty, $column:ident, $note:ident;)*) => {
        impl Mesh {$(
            $(#[$doc])*
            #[inline]
            pub fn $first(&self, of: $id) -> HalfedgeId {
                self.$column[of.index()]
            }

            /// The same for any id: `None` if it is out of range or erased.
            #[inline]
            pub fn $get(&self, of: $id) -> Option<HalfedgeId> {
                self.$column.get(of.index()).copied().filter(|h| *h != HalfedgeId::DEAD)
            }

            #[inline]
            pub fn $set(&mut self, of: $id, h: HalfedgeId) {
                if self.journal.is_open() {
                    self.$note(of);
                }
                self.$column[of.index()] = h;
            }
        )*}
    };
}

pointers_to_halfedges! {
    /// A halfedge that starts at the vertex, or `NONE` when it is isolated.
    vertex_halfedge, get_vertex_halfedge, set_vertex_halfedge: VertexId, vertices, note_vertex;
    edge_halfedge, get_edge_halfedge, set_edge_halfedge: EdgeId, edges, note_edge;
    face_halfedge, get_face_halfedge, set_face_halfedge: FaceId, faces, note_face;
}

/// Readers of ids known to be in range.
impl Mesh {
    #[inline]
    pub fn halfedge(&self, h: HalfedgeId) -> &HalfedgeRecord {
        &self.halfedges[h.index()]
    }

    /// The vertex where the halfedge ends: the origin of its twin.
    #[inline]
    pub fn target(&self, h: HalfedgeId) -> VertexId {
        self.vertex(self.twin(h))
    }

    #[inline]
    pub fn is_hole(&self, f: FaceId) -> bool {
        self.face_states[f.index()] == FaceState::Hole
    }

    #[inline]
    pub fn position(&self, v: VertexId) -> DVec3 {
        self.positions[v.index()]
    }
}

/// Readers of any id: `None` if it is out of range or erased, or, for a target, if the twin is.
impl Mesh {
    #[inline]
    pub fn get_halfedge(&self, h: HalfedgeId) -> Option<&HalfedgeRecord> {
        self.halfedges.get(h.index()).filter(|record| record.lives())
    }

    #[inline]
    pub fn get_target(&self, h: HalfedgeId) -> Option<VertexId> {
        self.get_vertex(self.get_twin(h)?)
    }

    #[inline]
    pub fn get_is_hole(&self, f: FaceId) -> Option<bool> {
        self.face_states.get(f.index())?.is_hole()
    }

    #[inline]
    pub fn get_position(&self, v: VertexId) -> Option<DVec3> {
        self.get_vertex_halfedge(v)?;
        Some(self.positions[v.index()])
    }
}

/// Writers: each writes one field of a living element, and nothing else.
impl Mesh {
    #[inline]
    fn halfedge_mut(&mut self, h: HalfedgeId) -> &mut HalfedgeRecord {
        if self.journal.is_open() {
            self.note_halfedge(h);
        }
        &mut self.halfedges[h.index()]
    }

    /// Turns a living face into a hole, or a hole into a face.
    #[inline]
    pub fn set_hole(&mut self, f: FaceId, hole: bool) {
        if self.journal.is_open() {
            self.note_face(f);
        }
        self.set_face_state(f, FaceState::of_living(hole));
    }

    /// Sets the state of a face, and updates the number of holes.
    #[inline]
    pub(super) fn set_face_state(&mut self, f: FaceId, state: FaceState) {
        let before = std::mem::replace(&mut self.face_states[f.index()], state);
        self.holes -= usize::from(before == FaceState::Hole);
        self.holes += usize::from(state == FaceState::Hole);
    }

    #[inline]
    pub fn set_position(&mut self, v: VertexId, position: DVec3) {
        if self.journal.is_open() {
            self.note_position(v);
        }
        self.positions[v.index()] = position;
    }
}

/// Exchanges without notes in a journal, for writes that are undone before anything else reads
/// them. Each returns the previous value; `None`, with nothing written, if the element is out of
/// range or erased, or if the value is the mark of an erased one.
impl Mesh {
    /// Sets a pointer, by its index in [`HalfedgeRecord::pointers`].
    #[inline]
    pub(crate) fn exchange_pointer(
        &mut self,
        h: HalfedgeId,
        pointer: usize,
        value: u32,
    ) -> Option<u32> {
        let record = self.halfedges.get_mut(h.index())?;
        if !record.lives() || value == HalfedgeId::DEAD.0 {
            return None;
        }
        Some(std::mem::replace(record.pointer_mut(pointer), value))
    }

    /// Sets the halfedge of a vertex, edge or face.
    #[inline]
    pub(crate) fn exchange_halfedge(
        &mut self,
        kind: ElementKind,
        id: u32,
        value: HalfedgeId,
    ) -> Option<HalfedgeId> {
        let place = match kind {
            ElementKind::Vertex => self.vertices.get_mut(id as usize),
            ElementKind::Edge => self.edges.get_mut(id as usize),
            ElementKind::Face => self.faces.get_mut(id as usize),
            ElementKind::Halfedge => None,
        };
        let place = place.filter(|place| ![**place, value].contains(&HalfedgeId::DEAD))?;
        Some(std::mem::replace(place, value))
    }

    /// Sets whether a face is a hole.
    #[inline]
    pub(crate) fn exchange_hole(&mut self, f: FaceId, hole: bool) -> Option<bool> {
        let state = self.face_states.get_mut(f.index())?;
        let before = state.is_hole()?;
        *state = FaceState::of_living(hole);
        self.holes -= usize::from(before);
        self.holes += usize::from(hole);
        Some(before)
    }
}
