//! What is done for each index of a cycle.

use super::registers::Registers;
use crate::rewrite::{Assembler, Inst, Label, Mark, Reg};

/// What is being done for each index, to be ended.
pub(super) struct Turns {
    begin: Label,
    end: Label,
    mark: Mark,
    outer: Option<Reg>,
}

impl Registers {
    /// Begins what is done for each index. The registers taken inside are given back.
    pub fn begin_turns(&mut self, asm: &mut Assembler) -> Turns {
        let turns =
            Turns { begin: asm.label(), end: asm.label(), mark: asm.mark(), outer: self.index() };
        let index = asm.reg();
        asm.emit(Inst::Const { to: index, bits: -1_i64 as u64 });
        asm.bind(turns.begin);
        let buffer = self.cycle.unwrap_or_default();
        asm.emit(Inst::NextIndex { buffer, index, otherwise: turns.end });
        self.set_index(Some(index));
        turns
    }

    /// Ends what is done for each index.
    pub fn end_turns(&mut self, asm: &mut Assembler, turns: Turns) {
        asm.emit(Inst::Jump { to: turns.begin });
        asm.bind(turns.end);
        asm.release(turns.mark);
        self.set_index(turns.outer);
    }
}
