//! Targets of the writes of phase 3: the mesh, or before that a preview for a guard to look at.

use crate::diagram::Pointer;
use crate::lower::{PreviewReads, StarWalk};
use crate::rewrite::{ElementField, HalfedgeField, Inst};

/// The target on which pointers are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WriteTarget {
    Mesh,
    /// A preview of the mesh, as far as guards read it.
    Preview(PreviewReads),
}

impl WriteTarget {
    /// The same store on this target; `None` if nothing reads it.
    pub fn aim(self, inst: Inst) -> Option<Inst> {
        let Self::Preview(reads) = self else { return Some(inst) };
        let pointer = |field| match field {
            HalfedgeField::Next => Pointer::Next,
            HalfedgeField::Prev => Pointer::Prev,
            HalfedgeField::Twin => Pointer::Twin,
            HalfedgeField::Vertex => Pointer::Vertex,
            HalfedgeField::Edge => Pointer::Edge,
            HalfedgeField::Face => Pointer::Face,
        };
        let first_of = |of| match of {
            ElementField::Vertex => Pointer::VertexHalfedge,
            ElementField::Edge => Pointer::EdgeHalfedge,
            ElementField::Face => Pointer::FaceHalfedge,
        };
        let keep = |pointer| reads.reads(pointer, StarWalk::Counterclockwise);
        match inst {
            Inst::Store { field, halfedge, value } => {
                keep(pointer(field)).then_some(Inst::PreviewStore { field, halfedge, value })
            }
            Inst::StoreHalfedge { of, element, value } => {
                keep(first_of(of)).then_some(Inst::PreviewStoreHalfedge { of, element, value })
            }
            Inst::StoreHole { face, hole } => {
                reads.reads_holes().then_some(Inst::PreviewStoreHole { face, hole })
            }
            Inst::StoreAll { field, buffer, value } => {
                keep(pointer(field)).then_some(Inst::PreviewStoreAll { field, buffer, value })
            }
            Inst::StoreSpan { field, span, index, value } => {
                keep(pointer(field)).then_some(Inst::PreviewStoreSpan { field, span, index, value })
            }
            inst => Some(inst),
        }
    }
}
