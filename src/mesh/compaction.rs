//! Renumbering without gaps.

use super::attribute::{Column, Columns};
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::records::{FaceState, HalfedgeRecord};

impl Mesh {
    /// The same mesh in tables without dead slots. Elements keep their order, but holes come behind
    /// all faces. Attributes go along, with their defaults; columns that are scratch or bookkeeping
    /// do not.
    pub fn compacted(&self) -> Self {
        let faces = self.faces().filter(|&f| !self.is_hole(f)).chain(self.holes());
        let old: [Vec<u32>; 4] = [
            self.vertices().map(|v| v.0).collect(),
            self.halfedges().map(|h| h.0).collect(),
            self.edges().map(|e| e.0).collect(),
            faces.map(|f| f.0).collect(),
        ];
        let new = ElementKind::ALL.map(|kind| {
            let mut new = vec![HalfedgeId::NONE.0; self.capacity(kind)];
            for (number, &slot) in (0..).zip(&old[kind as usize]) {
                new[slot as usize] = number;
            }
            new
        });
        // What leads nowhere, as from a vertex without edges, leads nowhere afterwards.
        let number = |kind: ElementKind, slot: u32| {
            new[kind as usize].get(slot as usize).copied().unwrap_or(HalfedgeId::NONE.0)
        };
        let halfedge = |h: HalfedgeId| HalfedgeId(number(ElementKind::Halfedge, h.0));
        let record = |&slot: &u32| {
            let record = &self.halfedges[slot as usize];
            HalfedgeRecord {
                next: halfedge(record.next),
                prev: halfedge(record.prev),
                twin: halfedge(record.twin),
                vertex: VertexId(number(ElementKind::Vertex, record.vertex.0)),
                edge: EdgeId(number(ElementKind::Edge, record.edge.0)),
                face: FaceId(number(ElementKind::Face, record.face.0)),
            }
        };
        let first = |table: &[HalfedgeId], kind: ElementKind| {
            old[kind as usize].iter().map(|&slot| halfedge(table[slot as usize])).collect()
        };
        let columns = ElementKind::ALL.map(|kind| {
            let kept = self.columns(kind).filter(|(_, column)| column.is_public());
            let moved = |column: &Column| Column {
                name: column.name.clone(),
                default: column.default,
                data: column.data.gathered(&old[kind as usize]),
            };
            Columns(kept.map(|(_, column)| moved(column)).collect())
        });
        let is_hole = (0..old[ElementKind::Face as usize].len()).map(|at| at >= self.face_count());
        Self {
            halfedges: old[ElementKind::Halfedge as usize].iter().map(record).collect(),
            vertices: first(&self.vertices, ElementKind::Vertex),
            edges: first(&self.edges, ElementKind::Edge),
            faces: first(&self.faces, ElementKind::Face),
            face_states: is_hole.map(FaceState::of_living).collect(),
            positions: self.vertices().map(|v| self.position(v)).collect(),
            holes: self.holes,
            columns,
            ..Self::default()
        }
    }
}
