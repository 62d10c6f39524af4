//! The pieces of a mesh: its connected components, sets of halfedges connected by `next` and
//! `twin`.
//!
//! An isolated vertex belongs to no piece.

use super::connectivity::Mesh;
use super::id::{ElementKind, HalfedgeId};

/// The halfedges of each piece, also of a broken mesh. Pieces are in the order of their first
/// halfedges.
pub(super) fn components(mesh: &Mesh) -> Vec<Vec<HalfedgeId>> {
    let mut seen = vec![false; mesh.capacity(ElementKind::Halfedge)];
    let mut pieces = Vec::new();
    for seed in mesh.halfedges() {
        if std::mem::replace(&mut seen[seed.index()], true) {
            continue;
        }
        let mut piece = vec![seed];
        let mut done = 0;
        while let Some(&h) = piece.get(done) {
            done += 1;
            for to in [mesh.next(h), mesh.prev(h), mesh.twin(h)] {
                if mesh.halfedge_alive(to) && !std::mem::replace(&mut seen[to.index()], true) {
                    piece.push(to);
                }
            }
        }
        pieces.push(piece);
    }
    pieces
}

impl Mesh {
    /// The number of pieces.
    pub fn component_count(&self) -> usize {
        components(self).len()
    }
}
