//! Targets of the writes of phase 3: the mesh, or before that a preview for a guard to look at.

use crate::diagram::Pointer;
use crate::lower::{PreviewReads, StarWalk};
use crate::rewrite::Inst;

/// The target on which pointers are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WriteTarget {
    Mesh,
    /// A preview of the mesh, as far as guards read it.
    Preview(PreviewReads),
}

impl WriteTarget {
    /// The same store of a pointer, or of whether a face is a hole, on this target; `None` if nothing
    /// reads it.
    pub fn aim(self, pointer: Option<Pointer>, inst: Inst) -> Option<Inst> {
        let Self::Preview(reads) = self else { return Some(inst) };
        let is_read = match pointer {
            Some(pointer) => reads.reads(pointer, StarWalk::Counterclockwise),
            None => reads.reads_holes(),
        };
        is_read.then_some(match inst {
            Inst::Store { field, halfedge, value } => Inst::PreviewStore { field, halfedge, value },
            Inst::StoreHalfedge { of, element, value } => {
                Inst::PreviewStoreHalfedge { of, element, value }
            }
            Inst::StoreHole { face, hole } => Inst::PreviewStoreHole { face, hole },
            Inst::StoreAll { field, buffer, value } => {
                Inst::PreviewStoreAll { field, buffer, value }
            }
            Inst::StoreSpan { field, span, index, value } => {
                Inst::PreviewStoreSpan { field, span, index, value }
            }
            inst => inst,
        })
    }
}
