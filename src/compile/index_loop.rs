//! Loops over the indices of a cycle.

use super::registers::Registers;
use crate::rewrite::{Assembler, Inst, Label, Mark, Reg};

/// A loop over the indices that has been begun.
pub(super) struct IndexLoop {
    begin: Label,
    end: Label,
    mark: Mark,
    outer: Option<Reg>,
}

impl Registers {
    /// Begins a loop over the indices. The registers taken inside are released at its end.
    pub fn begin_index_loop(&mut self, asm: &mut Assembler) -> IndexLoop {
        let indices = IndexLoop {
            begin: asm.label(),
            end: asm.label(),
            mark: asm.mark(),
            outer: self.index(),
        };
        let index = asm.reg();
        asm.emit(Inst::Const { to: index, bits: -1_i64 as u64 });
        asm.bind(indices.begin);
        let buffer = self.cycle.unwrap_or_default();
        asm.emit(Inst::NextIndex { buffer, index, otherwise: indices.end });
        self.set_index(Some(index));
        indices
    }

    /// Ends a loop over the indices.
    pub fn end_index_loop(&mut self, asm: &mut Assembler, indices: IndexLoop) {
        asm.emit(Inst::Jump { to: indices.begin });
        asm.bind(indices.end);
        asm.release(indices.mark);
        self.set_index(indices.outer);
    }
}
