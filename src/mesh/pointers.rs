//! Reading and writing single fields of a mesh.
//!
//! The plain readers and writers take ids that are in range; the `get_` readers take any id and
//! return `None` for elements that are not alive. A writer writes one field, and the mesh may be
//! broken until the last of a group of writes.

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::records::{FaceState, HalfedgeRecord};

/// Readers of ids known to be in range.
impl Mesh {
    #[inline]
    pub fn halfedge(&self, h: HalfedgeId) -> &HalfedgeRecord {
        &self.halfedges[h.index()]
    }

    #[inline]
    pub fn next(&self, h: HalfedgeId) -> HalfedgeId {
        self.halfedge(h).next
    }

    #[inline]
    pub fn prev(&self, h: HalfedgeId) -> HalfedgeId {
        self.halfedge(h).prev
    }

    #[inline]
    pub fn twin(&self, h: HalfedgeId) -> HalfedgeId {
        self.halfedge(h).twin
    }

    /// The origin.
    #[inline]
    pub fn vertex(&self, h: HalfedgeId) -> VertexId {
        self.halfedge(h).vertex
    }

    #[inline]
    pub fn edge(&self, h: HalfedgeId) -> EdgeId {
        self.halfedge(h).edge
    }

    #[inline]
    pub fn face(&self, h: HalfedgeId) -> FaceId {
        self.halfedge(h).face
    }

    /// The vertex where the halfedge ends: the origin of its twin.
    #[inline]
    pub fn target(&self, h: HalfedgeId) -> VertexId {
        self.vertex(self.twin(h))
    }

    /// A halfedge that starts at `v`, or `NONE` when `v` is isolated.
    #[inline]
    pub fn vertex_halfedge(&self, v: VertexId) -> HalfedgeId {
        self.vertices[v.index()]
    }

    #[inline]
    pub fn edge_halfedge(&self, e: EdgeId) -> HalfedgeId {
        self.edges[e.index()]
    }

    #[inline]
    pub fn face_halfedge(&self, f: FaceId) -> HalfedgeId {
        self.faces[f.index()]
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
    pub fn get_next(&self, h: HalfedgeId) -> Option<HalfedgeId> {
        Some(self.get_halfedge(h)?.next)
    }

    #[inline]
    pub fn get_prev(&self, h: HalfedgeId) -> Option<HalfedgeId> {
        Some(self.get_halfedge(h)?.prev)
    }

    #[inline]
    pub fn get_twin(&self, h: HalfedgeId) -> Option<HalfedgeId> {
        Some(self.get_halfedge(h)?.twin)
    }

    #[inline]
    pub fn get_vertex(&self, h: HalfedgeId) -> Option<VertexId> {
        Some(self.get_halfedge(h)?.vertex)
    }

    #[inline]
    pub fn get_edge(&self, h: HalfedgeId) -> Option<EdgeId> {
        Some(self.get_halfedge(h)?.edge)
    }

    #[inline]
    pub fn get_face(&self, h: HalfedgeId) -> Option<FaceId> {
        Some(self.get_halfedge(h)?.face)
    }

    #[inline]
    pub fn get_target(&self, h: HalfedgeId) -> Option<VertexId> {
        self.get_vertex(self.get_twin(h)?)
    }

    /// `Some(NONE)` for an isolated vertex.
    #[inline]
    pub fn get_vertex_halfedge(&self, v: VertexId) -> Option<HalfedgeId> {
        let h = *self.vertices.get(v.index())?;
        (h != HalfedgeId::DEAD).then_some(h)
    }

    #[inline]
    pub fn get_edge_halfedge(&self, e: EdgeId) -> Option<HalfedgeId> {
        let h = *self.edges.get(e.index())?;
        (h != HalfedgeId::DEAD).then_some(h)
    }

    #[inline]
    pub fn get_face_halfedge(&self, f: FaceId) -> Option<HalfedgeId> {
        let h = *self.faces.get(f.index())?;
        (h != HalfedgeId::DEAD).then_some(h)
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

    #[inline]
    pub fn set_next(&mut self, h: HalfedgeId, next: HalfedgeId) {
        self.halfedge_mut(h).next = next;
    }

    #[inline]
    pub fn set_prev(&mut self, h: HalfedgeId, prev: HalfedgeId) {
        self.halfedge_mut(h).prev = prev;
    }

    #[inline]
    pub fn set_twin(&mut self, h: HalfedgeId, twin: HalfedgeId) {
        self.halfedge_mut(h).twin = twin;
    }

    #[inline]
    pub fn set_vertex(&mut self, h: HalfedgeId, origin: VertexId) {
        self.halfedge_mut(h).vertex = origin;
    }

    #[inline]
    pub fn set_edge(&mut self, h: HalfedgeId, edge: EdgeId) {
        self.halfedge_mut(h).edge = edge;
    }

    #[inline]
    pub fn set_face(&mut self, h: HalfedgeId, face: FaceId) {
        self.halfedge_mut(h).face = face;
    }

    #[inline]
    pub fn set_vertex_halfedge(&mut self, v: VertexId, h: HalfedgeId) {
        if self.journal.is_open() {
            self.note_vertex(v);
        }
        self.vertices[v.index()] = h;
    }

    #[inline]
    pub fn set_edge_halfedge(&mut self, e: EdgeId, h: HalfedgeId) {
        if self.journal.is_open() {
            self.note_edge(e);
        }
        self.edges[e.index()] = h;
    }

    #[inline]
    pub fn set_face_halfedge(&mut self, f: FaceId, h: HalfedgeId) {
        if self.journal.is_open() {
            self.note_face(f);
        }
        self.faces[f.index()] = h;
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
