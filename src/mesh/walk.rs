//! Walking around faces and vertices.
//!
//! Every walk is bounded by the number of halfedge slots and stops at a pointer to nothing living,
//! so that it ends on a broken mesh too. On a valid mesh a walk visits its orbit once.

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};

/// The halfedges of a loop, by `next`.
#[derive(Clone, Debug)]
pub struct LoopWalk<'m>(Walk<'m>);

/// The halfedges that start at a vertex, counterclockwise: `h`, `h.prev.twin`, …
#[derive(Clone, Debug)]
pub struct SpokeWalk<'m>(Walk<'m>);

#[derive(Clone, Debug)]
struct Walk<'m> {
    mesh: &'m Mesh,
    start: HalfedgeId,
    at: HalfedgeId,
    left: usize,
}

impl<'m> Walk<'m> {
    fn new(mesh: &'m Mesh, start: HalfedgeId) -> Self {
        Self { mesh, start, at: start, left: mesh.halfedges.len() }
    }

    #[inline]
    fn step(&mut self, successor: impl Fn(&Mesh, HalfedgeId) -> HalfedgeId) -> Option<HalfedgeId> {
        let at = self.at;
        if self.left == 0 || !self.mesh.halfedge_alive(at) {
            return None;
        }
        self.left -= 1;
        let to = successor(self.mesh, at);
        self.at = if to == self.start { HalfedgeId::NONE } else { to };
        Some(at)
    }
}

impl Iterator for LoopWalk<'_> {
    type Item = HalfedgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfedgeId> {
        self.0.step(Mesh::next)
    }
}

impl Iterator for SpokeWalk<'_> {
    type Item = HalfedgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfedgeId> {
        self.0.step(|mesh, h| mesh.get_twin(mesh.prev(h)).unwrap_or(HalfedgeId::NONE))
    }
}

impl Mesh {
    /// The loop of `h`, from `h` on.
    #[inline]
    pub fn loop_from(&self, h: HalfedgeId) -> LoopWalk<'_> {
        LoopWalk(Walk::new(self, h))
    }

    /// The loop of a face or hole, from its halfedge on.
    #[inline]
    pub fn face_halfedges(&self, f: FaceId) -> LoopWalk<'_> {
        self.loop_from(self.get_face_halfedge(f).unwrap_or(HalfedgeId::NONE))
    }

    pub fn face_vertices(&self, f: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        self.face_halfedges(f).map(|h| self.vertex(h))
    }

    /// The spokes of the vertex of `h`, from `h` on.
    #[inline]
    pub fn spokes_from(&self, h: HalfedgeId) -> SpokeWalk<'_> {
        SpokeWalk(Walk::new(self, h))
    }

    /// The spokes of `v`, from its halfedge on; none if it is isolated.
    #[inline]
    pub fn spokes(&self, v: VertexId) -> SpokeWalk<'_> {
        self.spokes_from(self.get_vertex_halfedge(v).unwrap_or(HalfedgeId::NONE))
    }

    /// The targets of the spokes, in their order.
    pub fn neighbors(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.spokes(v).filter_map(|h| self.get_target(h))
    }

    /// The number of spokes.
    pub fn degree(&self, v: VertexId) -> usize {
        self.spokes(v).count()
    }

    /// The number of halfedges of a face or hole.
    pub fn face_size(&self, f: FaceId) -> usize {
        self.face_halfedges(f).count()
    }

    /// True if `h` runs along a hole.
    #[inline]
    pub fn is_boundary_halfedge(&self, h: HalfedgeId) -> bool {
        self.get_face(h).and_then(|f| self.get_is_hole(f)).unwrap_or(false)
    }

    /// True if a hole lies on one side of `e`.
    pub fn is_boundary_edge(&self, e: EdgeId) -> bool {
        let Some(h) = self.get_edge_halfedge(e) else { return false };
        let twin = self.get_twin(h).unwrap_or(HalfedgeId::NONE);
        self.holes > 0 && (self.is_boundary_halfedge(h) || self.is_boundary_halfedge(twin))
    }

    /// True if a hole lies around `v`. An isolated vertex has no hole around it.
    pub fn is_boundary_vertex(&self, v: VertexId) -> bool {
        self.holes > 0 && self.spokes(v).any(|h| self.is_boundary_halfedge(h))
    }

    /// A halfedge from `v` to `w`. Both stars are walked in step, so the cost is that
    /// of the smaller one.
    pub fn halfedge_between(&self, v: VertexId, w: VertexId) -> Option<HalfedgeId> {
        let mut from_v = self.spokes(v);
        let mut from_w = self.spokes(w);
        loop {
            let h = from_v.next()?;
            if self.get_target(h) == Some(w) {
                return Some(h);
            }
            let h = from_w.next()?;
            if self.get_target(h) == Some(v) {
                return self.get_twin(h);
            }
        }
    }

    /// True if an edge joins `v` and `w`.
    pub fn adjacent(&self, v: VertexId, w: VertexId) -> bool {
        self.halfedge_between(v, w).is_some()
    }

    /// An edge that joins `v` and `w`; of several, the first that a walk around both in step finds.
    pub fn edge_between(&self, v: VertexId, w: VertexId) -> Option<EdgeId> {
        self.get_edge(self.halfedge_between(v, w)?)
    }
}
