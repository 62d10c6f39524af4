//! Instructions that the machine takes: those that trap, and those that native code does not spell.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::facts::ends;
use super::stubs;
use super::translate::Translator;
use crate::rewrite::Inst;

impl Translator<'_, '_> {
    /// Goes on if a condition holds; else the machine takes the instruction, which traps.
    pub(super) fn or_fault(&mut self, condition: Value) {
        let fault = match self.fault {
            Some(fault) => fault,
            None => {
                let fault = self.b.create_block();
                self.b.set_cold_block(fault);
                self.faults.push((fault, self.at, self.set.clone()));
                *self.fault.insert(fault)
            }
        };
        let on = self.b.create_block();
        self.b.ins().brif(condition, on, &[], fault, &[]);
        self.b.switch_to_block(on);
    }

    /// The blocks of what traps: the machine takes the instruction and says why.
    pub(super) fn faults(&mut self) {
        for (block, at, set) in std::mem::take(&mut self.faults) {
            self.b.switch_to_block(block);
            let inst = self.text.code.insts[at];
            self.spill_operands(&inst);
            let number = self.b.ins().iconst(I64, at as i64);
            let signature = self.signature(&[I64, I64], &[]);
            let context = self.context;
            self.call(stubs::fault as *const () as usize, signature, &[context, number]);
            self.put_back(&set);
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
    }

    /// Lets the machine take the instruction.
    pub(super) fn step(&mut self, inst: &Inst) {
        let on = self.take(std::slice::from_ref(inst));
        let mut jump = *inst;
        if let Some(&mut to) = jump.target_mut() {
            let elsewhere = self.b.ins().icmp_imm_s(IntCC::NotEqual, on, self.at as i64 + 1);
            self.jump_if(elsewhere, to);
        } else if ends(inst) {
            // What ends the code by a trap has been left before.
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
    }

    /// The same, with those that follow it and are the machine's.
    pub(super) fn steps(&mut self, inst: &Inst) {
        let (first, code) = (self.at, self.text.code);
        let end = self.end_of_run(is_always_a_step);
        if end < first + 2 || !is_always_a_step(inst) {
            return self.step(inst);
        }
        self.take(&code.insts[first..end]);
        self.skip = end - first - 1;
    }

    /// Lets the machine take these instructions, of which this is the first; the place where the code
    /// goes on.
    fn take(&mut self, all: &[Inst]) -> Value {
        all.iter().for_each(|inst| self.spill_operands(inst));
        let span = self.b.ins().iconst(I64, (self.at | all.len() << 32) as i64);
        let on = self.call_stub(stubs::step as *const () as usize, &[span]);
        self.leave_if_negative(on);
        all.iter().for_each(|inst| self.reload_written(inst));
        on
    }

    /// The registers that the paths of a drain may read go to the window.
    pub(super) fn spill_for_drain(&mut self) {
        let all = self.live_at_drains.iter().find(|(at, _)| *at == self.at);
        let all = all.map_or_else(Vec::new, |(_, all)| all.clone());
        all.into_iter().for_each(|reg| self.spill(reg));
    }

    /// The end of the instructions of a sort from this one on, none of which but the first is
    /// jumped to.
    pub(super) fn end_of_run(&self, is_one: impl Fn(&Inst) -> bool) -> usize {
        let first = self.at;
        let insts = self.text.code.insts.iter().enumerate().skip(first);
        let mut run = insts
            .take_while(|&(at, inst)| is_one(inst) && (at == first || self.blocks[at].is_none()));
        run.by_ref().last().map_or(first, |(at, _)| at + 1)
    }

    pub(super) fn leave_if(&mut self, condition: Value) {
        let (leave, on) = (self.leave, self.b.create_block());
        self.b.ins().brif(condition, leave, &[], on, &[]);
        self.b.switch_to_block(on);
    }
}

/// True for what the machine takes, whatever it is about, and what goes on with the following.
fn is_always_a_step(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::PreviewStoreSpan { .. }
            | Inst::ForeseeAlong { .. }
            | Inst::StoreAll { .. }
            | Inst::StoreSpan { .. }
            | Inst::BufferAppend { .. }
            | Inst::BufferDeal { .. }
            | Inst::PrintText { .. }
            | Inst::PrintTextOf { .. }
            | Inst::PrintBool { .. }
            | Inst::PrintInt { .. }
            | Inst::PrintReal { .. }
            | Inst::PrintVec { .. }
            | Inst::PrintWide { .. }
            | Inst::PrintElement { .. }
            | Inst::PrintEnd
    )
}
