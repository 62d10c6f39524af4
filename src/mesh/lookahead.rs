//! Prefetching of the surroundings of elements that are needed soon.
//!
//! Scattered accesses to a large mesh wait for memory, one pointer after the other. Around several
//! elements at once the waits overlap, and what has been requested is in the caches when it is
//! needed.

use super::attribute::ColumnId;
use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};
use super::prefetch::prefetch;
use super::records::HalfedgeRecord;

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

    /// Requests the memory around the elements of a list from an index on, in stages, so that
    /// nothing is waited for: of the last of five groups the slots in the tables, of the group
    /// before it the records to which the slots lead, and so on to the loops on both sides of the
    /// first group. It is to be called once for each group.
    pub(crate) fn prefetch_list(&self, kind: ElementKind, list: &[u64], index: usize) {
        let group = |number: usize| {
            let start = index.saturating_add(number * Self::TOGETHER);
            list.get(start..).unwrap_or_default().iter().take(Self::TOGETHER).map(|&id| id as usize)
        };
        let record = |h: HalfedgeId| self.halfedges.get(h.index());
        let record_of = |id: usize| record(self.halfedge_of(kind, id)?);
        let twin_of = |id: usize| record(record_of(id)?.twin);
        group(4).for_each(|id| match kind {
            ElementKind::Halfedge => {}
            ElementKind::Vertex => prefetch(&self.vertices, id),
            ElementKind::Edge => prefetch(&self.edges, id),
            ElementKind::Face => prefetch(&self.faces, id),
        });
        for halfedge in group(3).filter_map(|id| self.halfedge_of(kind, id)) {
            prefetch(&self.halfedges, halfedge.index());
        }
        group(2).filter_map(record_of).for_each(|record| {
            prefetch(&self.halfedges, record.twin.index());
            self.prefetch_around(record);
        });
        group(1).filter_map(twin_of).for_each(|twin| self.prefetch_around(twin));
        group(1).filter_map(record_of).for_each(|record| self.prefetch_neighbors(record));
        group(0).filter_map(twin_of).for_each(|twin| self.prefetch_neighbors(twin));
    }

    /// The halfedge of an element; it itself, if it is one.
    fn halfedge_of(&self, kind: ElementKind, id: usize) -> Option<HalfedgeId> {
        match kind {
            ElementKind::Halfedge => Some(HalfedgeId(id as u32)),
            ElementKind::Vertex => self.vertices.get(id).copied(),
            ElementKind::Edge => self.edges.get(id).copied(),
            ElementKind::Face => self.faces.get(id).copied(),
        }
    }

    /// Requests what the pointers of a halfedge lead to, except its twin and edge.
    fn prefetch_around(&self, record: &HalfedgeRecord) {
        prefetch(&self.halfedges, record.next.index());
        prefetch(&self.halfedges, record.prev.index());
        prefetch(&self.vertices, record.vertex.index());
        prefetch(&self.positions, record.vertex.index());
        prefetch(&self.faces, record.face.index());
    }

    /// Requests what the next and the previous halfedge lead to outside their loop.
    fn prefetch_neighbors(&self, record: &HalfedgeRecord) {
        for side in [record.next, record.prev] {
            let Some(side) = self.halfedges.get(side.index()) else { continue };
            prefetch(&self.halfedges, side.twin.index());
            prefetch(&self.vertices, side.vertex.index());
            prefetch(&self.edges, side.edge.index());
        }
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
            start[0] = self.halfedge_of(kind, id as usize).unwrap_or(HalfedgeId::NONE);
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
                let Some(record) = self.halfedges.get(spoke.index()) else { continue };
                *before = record.prev;
                prefetch(&self.edges, record.edge.index());
                prefetch(&self.face_states, record.face.index());
                self.prefetch_values(ElementKind::Edge, record.edge.index(), columns);
                see(ElementKind::Halfedge, spoke.0);
                see(ElementKind::Edge, record.edge.0);
                see(ElementKind::Face, record.face.0);
            }
            for ((spoke, before), start) in spokes.iter_mut().zip(before).zip(starts) {
                *spoke = HalfedgeId::NONE;
                let Some(record) = self.halfedges.get(before.index()) else { continue };
                if record.twin != *start {
                    *spoke = record.twin;
                }
                let vertex = record.vertex.index();
                prefetch(&self.vertices, vertex);
                prefetch(&self.positions, vertex);
                self.prefetch_values(ElementKind::Vertex, vertex, columns);
                see(ElementKind::Vertex, record.vertex.0);
            }
        }
    }

    fn prefetch_values(&self, kind: ElementKind, index: usize, columns: &[ColumnId]) {
        for &column in columns.iter().filter(|column| column.kind == kind) {
            if let Some(column) = self.column(column) {
                column.data().prefetch(index);
            }
        }
    }
}
