//! The tables of a mesh and the pointers in them.
//!
//! Every halfedge stores its five pointers and its twin side by side (one cache line
//! holds two and a half halfedges); vertices, edges and faces each store one halfedge
//! of theirs. Whether an element lives is written inside its own record, so asking
//! costs no further memory access.
//!
//! This file keeps tables, not laws: a writer writes one pointer and the mesh may be
//! broken until the last of a group of writes. `validate` tells whether it is in
//! order. The plain readers and writers take ids that are in range; the `get_`
//! readers take anything and answer `None` for what does not live.

use glam::DVec3;

use super::attribute::Columns;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::slots::Slots;

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
    pub(super) const UNSET: Self = Self {
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
}

/// A face as its table has it: one halfedge of its loop, and whether it is a hole.
#[derive(Clone, Debug)]
pub(super) struct FaceRecord {
    pub(super) halfedge: HalfedgeId,
    pub(super) hole: bool,
}

/// A halfedge mesh: connectivity, positions and attribute columns.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub(super) halfedges: Vec<HalfedgeRecord>,
    pub(super) vertices: Vec<HalfedgeId>,
    pub(super) edges: Vec<HalfedgeId>,
    pub(super) faces: Vec<FaceRecord>,
    pub(super) positions: Vec<DVec3>,
    pub(super) holes: usize,
    pub(super) slots: [Slots; 4],
    pub(super) columns: [Columns; 4],
}

/// Counts.
impl Mesh {
    /// The number of living elements. For faces, those that are not holes.
    pub fn count(&self, kind: ElementKind) -> usize {
        let living = self.capacity(kind) - self.slots[kind as usize].unused();
        match kind {
            ElementKind::Face => living - self.holes,
            _ => living,
        }
    }

    /// The number of slots, living or dead; every living id is below it. For faces it
    /// spans faces and holes.
    #[inline]
    pub fn capacity(&self, kind: ElementKind) -> usize {
        match kind {
            ElementKind::Vertex => self.vertices.len(),
            ElementKind::Halfedge => self.halfedges.len(),
            ElementKind::Edge => self.edges.len(),
            ElementKind::Face => self.faces.len(),
        }
    }

    pub fn vertex_count(&self) -> usize {
        self.count(ElementKind::Vertex)
    }

    pub fn halfedge_count(&self) -> usize {
        self.count(ElementKind::Halfedge)
    }

    pub fn edge_count(&self) -> usize {
        self.count(ElementKind::Edge)
    }

    /// The number of faces that are not holes.
    pub fn face_count(&self) -> usize {
        self.count(ElementKind::Face)
    }

    pub fn hole_count(&self) -> usize {
        self.holes
    }
}

/// Life.
impl Mesh {
    /// Whether `index` is the number of a living element. Holes count as faces here.
    pub fn is_alive(&self, kind: ElementKind, index: u32) -> bool {
        match kind {
            ElementKind::Vertex => self.vertex_alive(VertexId(index)),
            ElementKind::Halfedge => self.halfedge_alive(HalfedgeId(index)),
            ElementKind::Edge => self.edge_alive(EdgeId(index)),
            ElementKind::Face => self.face_alive(FaceId(index)),
        }
    }

    #[inline]
    pub fn vertex_alive(&self, v: VertexId) -> bool {
        self.get_vertex_halfedge(v).is_some()
    }

    #[inline]
    pub fn halfedge_alive(&self, h: HalfedgeId) -> bool {
        self.get_halfedge(h).is_some()
    }

    #[inline]
    pub fn edge_alive(&self, e: EdgeId) -> bool {
        self.get_edge_halfedge(e).is_some()
    }

    #[inline]
    pub fn face_alive(&self, f: FaceId) -> bool {
        self.get_face_halfedge(f).is_some()
    }
}

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
        self.faces[f.index()].halfedge
    }

    #[inline]
    pub fn is_hole(&self, f: FaceId) -> bool {
        self.faces[f.index()].hole
    }

    #[inline]
    pub fn position(&self, v: VertexId) -> DVec3 {
        self.positions[v.index()]
    }
}

/// Readers of any id: `None` when it is out of range or erased, or leads there.
impl Mesh {
    #[inline]
    pub fn get_halfedge(&self, h: HalfedgeId) -> Option<&HalfedgeRecord> {
        self.halfedges
            .get(h.index())
            .filter(|record| record.lives())
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
        let h = self.faces.get(f.index())?.halfedge;
        (h != HalfedgeId::DEAD).then_some(h)
    }

    #[inline]
    pub fn get_is_hole(&self, f: FaceId) -> Option<bool> {
        let record = self.faces.get(f.index())?;
        (record.halfedge != HalfedgeId::DEAD).then_some(record.hole)
    }

    #[inline]
    pub fn get_position(&self, v: VertexId) -> Option<DVec3> {
        self.get_vertex_halfedge(v)?;
        Some(self.positions[v.index()])
    }
}

/// Writers: each writes one field of a living element, and nothing follows it.
impl Mesh {
    #[inline]
    fn halfedge_mut(&mut self, h: HalfedgeId) -> &mut HalfedgeRecord {
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
        self.vertices[v.index()] = h;
    }

    #[inline]
    pub fn set_edge_halfedge(&mut self, e: EdgeId, h: HalfedgeId) {
        self.edges[e.index()] = h;
    }

    #[inline]
    pub fn set_face_halfedge(&mut self, f: FaceId, h: HalfedgeId) {
        self.faces[f.index()].halfedge = h;
    }

    /// Turns a living face into a hole, or a hole into a face.
    #[inline]
    pub fn set_hole(&mut self, f: FaceId, hole: bool) {
        let record = &mut self.faces[f.index()];
        self.holes -= usize::from(record.hole);
        record.hole = hole;
        self.holes += usize::from(hole);
    }

    #[inline]
    pub fn set_position(&mut self, v: VertexId, position: DVec3) {
        self.positions[v.index()] = position;
    }
}

/// Iteration, in the order of the ids.
impl Mesh {
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + Clone + '_ {
        living(&self.vertices, |h| *h != HalfedgeId::DEAD).map(VertexId)
    }

    pub fn halfedges(&self) -> impl Iterator<Item = HalfedgeId> + Clone + '_ {
        living(&self.halfedges, HalfedgeRecord::lives).map(HalfedgeId)
    }

    pub fn edges(&self) -> impl Iterator<Item = EdgeId> + Clone + '_ {
        living(&self.edges, |h| *h != HalfedgeId::DEAD).map(EdgeId)
    }

    /// All faces, holes included.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        living(&self.faces, |f| f.halfedge != HalfedgeId::DEAD).map(FaceId)
    }

    pub fn holes(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.faces().filter(|&f| self.is_hole(f))
    }
}

fn living<T>(table: &[T], lives: impl Fn(&T) -> bool + Clone) -> impl Iterator<Item = u32> + Clone {
    // Ids fit in u32 because no slot is added past the id space.
    table
        .iter()
        .enumerate()
        .filter(move |(_, record)| lives(record))
        .map(|(i, _)| i as u32)
}
