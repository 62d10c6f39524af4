//! Prefetching of the surroundings of elements that are needed soon.
//!
//! Scattered accesses to a large mesh wait for memory, one pointer after the other. Around several
//! elements at once the waits overlap, and what has been read is in the caches when it is needed.

use std::hint::black_box;

use super::attribute::ColumnId;
use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};

/// The number of halfedges from which on a mesh is larger than the caches of a core.
const LARGE: usize = 50_000;

/// The number of spokes of a star that are read at most.
const FEW: usize = 12;

/// The halfedge of an element, and one at which the star of a second vertex begins.
type Starts = [HalfedgeId; 2];

impl Mesh {
    /// The number of elements that are looked at together.
    pub(crate) const TOGETHER: usize = 8;

    /// True if the mesh is larger than the caches of a core, so that looking ahead pays.
    pub(crate) fn is_large(&self) -> bool {
        self.halfedges.len() >= LARGE
    }

    /// Reads around elements: the stars of their vertices (of two of a face) and the attributes
    /// there in `columns`. `see` is called with the elements there. Ids without a slot and erased
    /// vertices, edges and faces are skipped; for an erased halfedge, the pointers that it had are
    /// followed.
    pub(crate) fn look_around(
        &self,
        kind: ElementKind,
        ids: &[u32; Self::TOGETHER],
        columns: &[ColumnId],
        mut see: impl FnMut(ElementKind, u32),
    ) {
        let mut starts = [[HalfedgeId::NONE; 2]; Mesh::TOGETHER];
        for (start, &id) in starts.iter_mut().zip(ids) {
            start[0] = match kind {
                ElementKind::Halfedge => Some(HalfedgeId(id)),
                ElementKind::Vertex => self.vertices.get(id as usize).copied(),
                ElementKind::Edge => self.edges.get(id as usize).copied(),
                ElementKind::Face => self.faces.get(id as usize).copied(),
            }
            .unwrap_or(HalfedgeId::NONE);
        }
        for start in &mut starts {
            start[1] = match (kind, self.halfedges.get(start[0].index())) {
                (ElementKind::Vertex, _) | (_, None) => HalfedgeId::NONE,
                (ElementKind::Face, Some(record)) => record.next,
                (ElementKind::Halfedge | ElementKind::Edge, Some(record)) => record.twin,
            };
        }
        self.look_at_stars(&starts, columns, &mut see);
    }

    /// Walks around the origins of the halfedges, all in step.
    fn look_at_stars(
        &self,
        starts: &[Starts; Mesh::TOGETHER],
        columns: &[ColumnId],
        see: &mut impl FnMut(ElementKind, u32),
    ) {
        let starts = starts.as_flattened();
        let mut spokes = [HalfedgeId::NONE; 2 * Mesh::TOGETHER];
        spokes.copy_from_slice(starts);
        for _ in 0..FEW {
            let mut before = [HalfedgeId::NONE; 2 * Mesh::TOGETHER];
            for (spoke, before) in spokes.iter().zip(&mut before) {
                let Some(record) = self.halfedges.get(spoke.index()) else {
                    continue;
                };
                *before = record.prev;
                black_box(self.edges.get(record.edge.index()).copied());
                black_box(self.face_states.get(record.face.index()).copied());
                self.look_at_values(ElementKind::Edge, record.edge.index(), columns);
                see(ElementKind::Halfedge, spoke.0);
                see(ElementKind::Edge, record.edge.0);
                see(ElementKind::Face, record.face.0);
            }
            for ((spoke, before), start) in spokes.iter_mut().zip(before).zip(starts) {
                *spoke = HalfedgeId::NONE;
                let Some(record) = self.halfedges.get(before.index()) else {
                    continue;
                };
                if record.twin != *start {
                    *spoke = record.twin;
                }
                let vertex = record.vertex.index();
                black_box(self.vertices.get(vertex).copied());
                black_box(self.positions.get(vertex).copied());
                self.look_at_values(ElementKind::Vertex, vertex, columns);
                see(ElementKind::Vertex, record.vertex.0);
            }
        }
    }

    fn look_at_values(&self, kind: ElementKind, index: usize, columns: &[ColumnId]) {
        for &column in columns.iter().filter(|column| column.kind == kind) {
            if let Some(column) = self.column(column) {
                column.data().touch(index);
            }
        }
    }
}
