//! Instructions that the machine executes: those that trap, and those that are not translated.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::facts::ends;
use super::stubs;
use super::translate::Translator;
use crate::rewrite::Inst;
use crate::rewrite::inst::group;

impl Translator<'_, '_> {
    /// Continues if a condition holds; else the machine executes the instruction, which traps.
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
        self.go_on(on);
    }

    /// Emits the blocks of faults: the machine executes the instruction and determines the trap.
    pub(super) fn faults(&mut self) {
        for (block, at, set) in std::mem::take(&mut self.faults) {
            self.b.switch_to_block(block);
            self.spill_operands(&self.unit.code.insts[at]);
            let number = self.b.ins().iconst(I64, at as i64);
            let signature = self.signature(&[I64, I64], &[]);
            let context = self.context;
            self.call(stubs::fault as *const () as usize, signature, &[context, number]);
            self.put_back(&set);
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
    }

    /// Lets the machine execute the instruction.
    pub(super) fn step(&mut self, inst: &Inst) {
        let on = self.take(std::slice::from_ref(inst));
        let mut jump = *inst;
        if let Some(&mut to) = jump.target_mut() {
            let elsewhere = self.b.ins().icmp_imm_s(IntCC::NotEqual, on, self.at as i64 + 1);
            self.jump_if(elsewhere, to);
        } else if ends(inst) {
            // An instruction that ends the code by a trap has already left it.
            let leave = self.leave;
            self.b.ins().jump(leave, &[]);
        }
    }

    /// Lets the machine execute the instruction, and those that follow it and always need the
    /// machine.
    pub(super) fn steps(&mut self, inst: &Inst) {
        let (first, code) = (self.at, self.unit.code);
        let end = self.end_of_run(is_always_a_step);
        if end < first + 2 || !is_always_a_step(inst) {
            return self.step(inst);
        }
        self.take(&code.insts[first..end]);
        self.skip = end - first - 1;
    }

    /// Lets the machine execute these instructions, the first of which is the current one; returns
    /// the place where the code continues.
    fn take(&mut self, all: &[Inst]) -> Value {
        all.iter().for_each(|inst| self.spill_operands(inst));
        let span = self.b.ins().iconst(I64, (self.at | all.len() << 32) as i64);
        let on = self.call_stub(stubs::step as *const () as usize, &[span]);
        self.leave_if_negative(on);
        all.iter().for_each(|inst| self.reload_written(inst));
        on
    }

    /// Spills the registers that the paths of a drain may read to the window.
    pub(super) fn spill_for_drain(&mut self) {
        let all = self.live_at_drains.iter().find(|(at, _)| *at == self.at);
        let all = all.map_or_else(Vec::new, |(_, all)| all.clone());
        all.into_iter().for_each(|reg| self.spill(reg));
    }

    /// The end of the run of instructions for which `is_one` holds from this one on, of which only
    /// the first may be the target of a jump.
    pub(super) fn end_of_run(&self, is_one: impl Fn(&Inst) -> bool) -> usize {
        let first = self.at;
        let insts = self.unit.code.insts.iter().enumerate().skip(first);
        let mut run = insts
            .take_while(|&(at, inst)| is_one(inst) && (at == first || self.blocks[at].is_none()));
        run.by_ref().last().map_or(first, |(at, _)| at + 1)
    }

    /// Lets a stub execute the current instruction.
    pub(super) fn execute_by(&mut self, stub: usize, inst: &Inst) {
        self.spill_operands(inst);
        self.call_here(stub);
        self.reload_written(inst);
    }
}

/// Whether the machine executes an instruction in any case, and the next instruction follows it.
fn is_always_a_step(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::PreviewStoreSpan { .. }
            | Inst::ForeseeAlong { .. }
            | Inst::StoreSpan { .. }
            | group!(prints)
            | Inst::PrintEnd
    )
}
