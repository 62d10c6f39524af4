//! The tables of a mesh and the pointers in them.
//!
//! Nothing is checked here; `validate` tells whether the tables are in order.

use glam::DVec3;

use super::attribute::Columns;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::notes::Journal;
use super::records::{FaceState, HalfedgeRecord, Slots};

/// A halfedge mesh: connectivity, positions and attribute columns.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub(super) halfedges: Vec<HalfedgeRecord>,
    pub(super) vertices: Vec<HalfedgeId>,
    pub(super) edges: Vec<HalfedgeId>,
    pub(super) faces: Vec<HalfedgeId>,
    pub(super) face_states: Vec<FaceState>,
    pub(super) positions: Vec<DVec3>,
    pub(super) holes: usize,
    pub(super) slots: [Slots; 4],
    pub(super) columns: [Columns; 4],
    pub(super) journal: Journal,
}

/// Counts.
impl Mesh {
    /// The number of living elements. For faces, those that are not holes.
    pub fn count(&self, kind: ElementKind) -> usize {
        let living = self.capacity(kind) - self.slots[kind as usize].unused();
        if kind == ElementKind::Face { living - self.holes } else { living }
    }

    /// The number of slots, living or dead; every living id is below it. For faces it includes
    /// holes.
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

/// Which elements are alive.
impl Mesh {
    /// True if `index` is the number of a living element. Holes count as faces here.
    #[inline]
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
        living(&self.face_states, |&state| state != FaceState::Dead).map(FaceId)
    }

    /// The numbers of all elements of a kind; holes count as faces.
    pub fn elements(&self, kind: ElementKind) -> impl Iterator<Item = u32> + '_ {
        (0..self.capacity(kind) as u32).filter(move |&index| self.is_alive(kind, index))
    }

    pub fn holes(&self) -> impl Iterator<Item = FaceId> + Clone + '_ {
        self.faces().filter(|&f| self.is_hole(f))
    }
}

fn living<T>(table: &[T], lives: impl Fn(&T) -> bool + Clone) -> impl Iterator<Item = u32> + Clone {
    // Ids fit in u32 because no slot is added past the id space.
    table.iter().enumerate().filter(move |(_, record)| lives(record)).map(|(i, _)| i as u32)
}
