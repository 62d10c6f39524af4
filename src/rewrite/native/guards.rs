//! Instructions that look ahead: stubs set what would be written, ask about it, and put it back.

use cranelift_codegen::ir::InstBuilder;
use cranelift_codegen::ir::types::I64;

use super::stubs::guards;
use super::translate::Translator;
use crate::rewrite::Inst;

impl Translator<'_, '_> {
    /// Spells an instruction that looks ahead; false if it is none, or one for the machine.
    pub(super) fn guard(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::Foresee { condition, to, element, at } => {
                let number = self.b.ins().iconst(I64, condition as i64);
                let [element, at] = [element, at].map(|reg| self.id(reg));
                let stub = guards::foresee as *const () as usize;
                let holds = self.call_stub(stub, &[number, element, at]);
                self.or_fault_if_negative(holds);
                self.set_whole(to, holds);
            }
            _ if sets(inst) => {
                let (first, code) = (self.at, self.text.code);
                let end = self.end_of_run(sets);
                let all = &code.insts[first..end];
                all.iter().for_each(|inst| self.spill_operands(inst));
                let span = self.b.ins().iconst(I64, (first | end << 32) as i64);
                let done = self.call_stub(guards::set as *const () as usize, &[span]);
                self.leave_if_negative(done);
                all.iter().for_each(|inst| self.reload_written(inst));
                self.skip = end - first - 1;
            }
            _ => return false,
        }
        true
    }
}

/// Whether an instruction sets or puts back what is looked at.
fn sets(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::PreviewClear
            | Inst::PreviewNew { .. }
            | Inst::PreviewStore { .. }
            | Inst::PreviewStoreHalfedge { .. }
            | Inst::PreviewStoreHole { .. }
            | Inst::PreviewStoreAll { .. }
            | Inst::PreviewUndo
    )
}
