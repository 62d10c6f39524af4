//! Lowering of calls of operations and functions.

use super::lower::Lowering;
use crate::compile::{arguments, narrow};
use crate::diagram::Expr;
use crate::rewrite::{Inst, Reg};
use crate::source::Span;

pub(super) struct FunctionCall<'e> {
    pub(super) function: u32,
    pub(super) args: &'e [Expr],
    pub(super) to: Reg,
    pub(super) holds: bool,
}

impl Lowering<'_> {
    /// Lowers a call of an operation; returns the registers of whether it was applied, and of its
    /// result.
    pub(super) fn apply(&mut self, op: usize, args: &[Expr], span: Span) -> (Reg, Reg) {
        let (applied, result) = (self.asm.reg(), self.asm.reg());
        let mark = self.asm.mark();
        let slots = self.arguments(args);
        self.trap_at(span, Inst::Apply { op: narrow(op), args: slots, applied, result });
        self.asm.release(mark);
        (applied, result)
    }

    fn arguments(&mut self, args: &[Expr]) -> Reg {
        arguments(&mut self.asm, &mut self.names, args)
    }

    /// Lowers a call of a function, which puts its value into a register. If the call `holds`, the
    /// caller still needs ids, so the function must not recycle erased elements.
    pub(super) fn call(&mut self, call: FunctionCall, span: Span) {
        let mark = self.asm.mark();
        let args = self.arguments(call.args);
        let inst =
            Inst::Call { function: narrow(call.function), args, to: call.to, holds: call.holds };
        self.trap_at(span, inst);
        self.asm.release(mark);
    }
}
