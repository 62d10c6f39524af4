//! Whether all laws hold, in one pass over the halfedges and a walk around each face and vertex.

use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};
use super::records::HalfedgeRecord;

impl Mesh {
    /// True if every law of [`super::validate`] holds.
    ///
    /// If adjacent halfedges name the same element, each orbit names a single one. If moreover the
    /// orbits of the elements' own halfedges have as many halfedges in total as the mesh, there are
    /// no other orbits.
    pub(super) fn is_in_order(&self) -> bool {
        let mut halfedges = 0;
        for (id, record) in (0..).zip(&self.halfedges) {
            if record.lives() {
                halfedges += 1;
                if !self.agrees(HalfedgeId(id), record) {
                    return false;
                }
            }
        }
        self.edges_have_all(halfedges)
            && self.faces_have_all(halfedges)
            && self.vertices_have_all(halfedges)
            && self.vertices().all(|v| self.positions.get(v.index()).is_some_and(|p| p.is_finite()))
    }

    #[inline]
    fn agrees(&self, h: HalfedgeId, record: &HalfedgeRecord) -> bool {
        let (Some(next), Some(prev), Some(twin)) = (
            self.get_halfedge(record.next),
            self.get_halfedge(record.prev),
            self.get_halfedge(record.twin),
        ) else {
            return false;
        };
        next.prev == h
            && prev.next == h
            && twin.twin == h
            && record.twin != h
            && next.face == record.face
            && twin.edge == record.edge
            // The twin is the spoke after the next halfedge.
            && next.vertex == twin.vertex
            && self.vertex_alive(record.vertex)
            && self.edge_alive(record.edge)
            && self.face_alive(record.face)
    }

    fn edges_have_all(&self, halfedges: usize) -> bool {
        let mut edges = 0;
        self.edges().map(|e| (e, self.edge_halfedge(e))).all(|(edge, h)| {
            edges += 1;
            self.get_edge(h) == Some(edge)
        }) && 2 * edges == halfedges
    }

    fn faces_have_all(&self, halfedges: usize) -> bool {
        let mut sides = 0;
        self.faces().all(|face| {
            let h = self.face_halfedge(face);
            self.get_face(h) == Some(face) && self.orbit(h, &mut sides, |record| record.next)
        }) && sides == halfedges
    }

    fn vertices_have_all(&self, halfedges: usize) -> bool {
        let mut spokes = 0;
        let spoke =
            |record: &HalfedgeRecord| self.get_twin(record.prev).unwrap_or(HalfedgeId::NONE);
        self.vertices().all(|vertex| {
            let h = self.vertex_halfedge(vertex);
            h.is_none() || self.get_vertex(h) == Some(vertex) && self.orbit(h, &mut spokes, spoke)
        }) && spokes == halfedges
    }

    /// Counts the halfedges of an orbit; returns false if it does not close.
    #[inline]
    fn orbit(
        &self,
        start: HalfedgeId,
        count: &mut usize,
        successor: impl Fn(&HalfedgeRecord) -> HalfedgeId,
    ) -> bool {
        let most = self.capacity(ElementKind::Halfedge);
        let mut at = start;
        while let Some(record) = self.get_halfedge(at).filter(|_| *count < most) {
            *count += 1;
            at = successor(record);
            if at == start {
                return true;
            }
        }
        false
    }
}
