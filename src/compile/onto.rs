//! Where phase 3 writes: on the mesh, or first on a sheet over it, for a guard to look at.

use crate::rewrite::Inst;

/// Where pointers are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Onto {
    /// On the mesh.
    Mesh,
    /// On the sheet over the mesh that guards look at.
    Preview,
}

impl Onto {
    /// The same store, there.
    pub fn aim(self, inst: Inst) -> Inst {
        match (self, inst) {
            (Onto::Preview, Inst::Store { field, halfedge, value }) => {
                Inst::PreviewStore { field, halfedge, value }
            }
            (Onto::Preview, Inst::StoreHalfedge { of, element, value }) => {
                Inst::PreviewStoreHalfedge { of, element, value }
            }
            (Onto::Preview, Inst::StoreHole { face, hole }) => {
                Inst::PreviewStoreHole { face, hole }
            }
            (Onto::Preview, Inst::StoreAll { field, buffer, value }) => {
                Inst::PreviewStoreAll { field, buffer, value }
            }
            (Onto::Preview, Inst::StoreSpan { field, span, index, value }) => {
                Inst::PreviewStoreSpan { field, span, index, value }
            }
            (_, inst) => inst,
        }
    }
}
