//! The element that an instruction that trapped is about, for its message.

use super::{Call, Inst, Machine, Reg, attribute};
use crate::mesh::ElementKind;

impl Machine {
    /// The kind and number of the element that the instruction at `at` reads or writes, or with
    /// which it called an operation that refused; `None` if there is none.
    #[cold]
    pub(super) fn about(&self, call: &Call<'_>, at: usize) -> Option<(ElementKind, u32)> {
        let inst = call.code.insts.get(at)?;
        let (kind, base, reg) = match *inst {
            Inst::DrainKey { .. } => return self.drains.in_progress(),
            // The arguments of the last call are still behind the window.
            Inst::Refused { op } => {
                let plan = call.plans.get(usize::from(op))?.as_ref()?;
                (plan.of?, call.base + usize::from(call.code.registers), Reg(0))
            }
            _ => {
                let (kind, reg) = self.element_of(inst)?;
                (kind, call.base, reg)
            }
        };
        let id = *self.stack.get(base + usize::from(reg.0))? as u32;
        (id != u32::MAX).then_some((kind, id))
    }

    fn element_of(&self, inst: &Inst) -> Option<(ElementKind, Reg)> {
        Some(match *inst {
            Inst::Load { halfedge, .. } | Inst::Store { halfedge, .. } => {
                (ElementKind::Halfedge, halfedge)
            }
            Inst::LoadHalfedge { of, element, .. } | Inst::StoreHalfedge { of, element, .. } => {
                (of.kind(), element)
            }
            Inst::LoadHole { face, .. } => (ElementKind::Face, face),
            Inst::LoadPosition { vertex, .. }
            | Inst::StorePosition { vertex, .. }
            | Inst::DeferPosition { vertex, .. }
            | Inst::NeighborsBegin { vertex, .. } => (ElementKind::Vertex, vertex),
            Inst::LoadAttribute { attribute, element, .. }
            | Inst::StoreAttribute { attribute, element, .. }
            | Inst::DeferAttribute { attribute, element, .. } => {
                (attribute::column(&self.columns, attribute).ok()?.kind, element)
            }
            Inst::Ask { question, elements: [element, _], .. } => (question.kind(), element),
            Inst::ExpectAlive { kind, from } => (kind, from),
            _ => return None,
        })
    }
}
