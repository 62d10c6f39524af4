//! Calls of operations in the code of a script.

use super::lower::Lowering;
use crate::compile::width;
use crate::diagram::Expr;
use crate::rewrite::{Inst, Reg};
use crate::source::Span;

impl Lowering<'_> {
    /// A call; gives the registers of whether it was applied, and of its result.
    pub(super) fn apply(&mut self, op: usize, args: &[Expr], span: Span) -> (Reg, Reg) {
        if !self.called.iter().any(|&(known, _)| known == op) {
            self.called.push((op, span));
        }
        let (applied, result) = (self.asm.reg(), self.asm.reg());
        let mark = self.asm.mark();
        let widths = args.iter().map(|arg| width(arg.ty));
        let all = widths.clone().fold(0, u16::saturating_add);
        let slots = self.asm.block(all);
        let mut offset = 0;
        for (arg, width) in args.iter().zip(widths) {
            // A block too wide to be had is no block; the code is not used then.
            let to = Reg(slots.0.saturating_add(offset));
            self.value_into(arg, to);
            offset = offset.saturating_add(width);
        }
        let inst = Inst::Apply {
            op: number(op),
            args: slots,
            applied,
            result,
        };
        self.trap_at(span, inst);
        self.asm.release(mark);
        (applied, result)
    }

    /// The script ends here if the operation just called has refused.
    pub(super) fn insist(&mut self, op: usize, applied: Reg, span: Span) {
        let to = self.asm.label();
        self.asm.emit(Inst::JumpIf {
            condition: applied,
            to,
        });
        self.trap_at(span, Inst::Refused { op: number(op) });
        self.asm.bind(to);
    }
}

/// The number by which code calls an operation. One too large is rejected before the
/// code is used.
fn number(op: usize) -> u16 {
    u16::try_from(op).unwrap_or(u16::MAX)
}
