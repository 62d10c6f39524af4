//! Loads of pointers, and questions about one element; an element that no longer exists stops the
//! program at that place.

use crate::rewrite::{Assembler, ElementField, HalfedgeField, Inst, Question, Reg};

/// Loads a pointer of a halfedge.
pub(super) fn load(
    asm: &mut Assembler,
    place: u32,
    field: HalfedgeField,
    [to, halfedge]: [Reg; 2],
) {
    asm.trap_at(place, Inst::Load { field, to, halfedge });
}

/// Loads the halfedge of a vertex, an edge or a face.
pub(super) fn first(asm: &mut Assembler, place: u32, of: ElementField, [to, element]: [Reg; 2]) {
    asm.trap_at(place, Inst::LoadHalfedge { of, to, element });
}

/// A question about one element.
pub(super) fn ask(question: Question, to: Reg, element: Reg) -> Inst {
    Inst::Ask { question, to, elements: [element; 2] }
}
