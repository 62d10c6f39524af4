//! Calls of functions and of operations.
//!
//! A function is called directly where it is there as native code: its window lies behind that of
//! the caller, which puts the arguments there and finds there what it gives. Else the machine calls
//! it.

use std::mem::offset_of;
use std::sync::atomic::AtomicUsize;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::compile::Expected;
use super::context::{Context, Slice};
use super::facts::reached;
use super::translate::{APPLIED, Region, Translator};
use super::{Variant, stubs};
use crate::rewrite::watch::{Progress, TURNS_PER_LOOK};
use crate::rewrite::{Code, Inst, Reg};

/// The number of slots that a function gives, if always the same.
pub(super) fn gives(code: &Code) -> Option<u16> {
    let reached = reached(code);
    let mut widths = code.insts.iter().zip(reached).filter_map(|(inst, reached)| match inst {
        Inst::Give { width, .. } if reached => Some(*width),
        _ => None,
    });
    let first = widths.next()?;
    widths.all(|width| width == first).then_some(first)
}

/// A function that may be called directly.
struct Callee {
    /// Where its address stands.
    entry: *const AtomicUsize,
    params: u16,
    gives: u16,
}

impl Translator<'_, '_> {
    /// Ends a function: what it gives goes to the start of its window.
    pub(super) fn give(&mut self, from: Reg, width: u16) {
        let values: Vec<Value> = (0..width)
            .map(|part| {
                let variable = self.variable(Reg(from.0.wrapping_add(part)));
                self.b.use_var(variable)
            })
            .collect();
        let window = self.field(offset_of!(Context, window));
        let flags = self.flags(Region::Window);
        for (part, value) in (0..).zip(values) {
            self.b.ins().store(flags, value, window, part * 8);
        }
        let given = self.b.ins().iconst(I32, i64::from(width));
        let flags = self.flags(Region::Context);
        self.b.ins().store(flags, given, self.context, offset_of!(Context, given) as i32);
    }

    pub(super) fn call_function(
        &mut self,
        inst: &Inst,
        function: u16,
        [args, to]: [Reg; 2],
        holds: bool,
    ) {
        let Some(callee) = self.callee(function) else {
            return self.call_by_machine(inst);
        };
        let (slow, on) = (self.b.create_block(), self.b.create_block());
        self.b.set_cold_block(slow);
        let or_slow = |this: &mut Self, condition: Value| {
            let on = this.b.create_block();
            this.b.ins().brif(condition, on, &[], slow, &[]);
            this.b.switch_to_block(on);
        };
        // So many calls are nested, or the watcher looks, or there is no native code yet, or the
        // stack of registers has to grow: the machine sees to it.
        let left = self.field(offset_of!(Context, left));
        or_slow(self, left);
        let progress = self.field(offset_of!(Context, progress));
        let turns = self.flags(Region::Progress);
        let turns_at = offset_of!(Progress, turns) as i32;
        let now = self.b.ins().load(I32, turns, progress, turns_at);
        let now = self.b.ins().iadd_imm_s(now, 1);
        let rest = self.b.ins().band_imm_u(now, i64::from(TURNS_PER_LOOK - 1));
        or_slow(self, rest);
        let flags = self.flags(Region::Entries);
        let place = self.b.ins().iconst(I64, callee.entry.addr() as i64);
        let entry = self.b.ins().load(I64, flags, place, 0);
        or_slow(self, entry);
        let size = i64::from(self.text.code.registers) * 8;
        let window = self.field(offset_of!(Context, window));
        let next = self.b.ins().iadd_imm_s(window, size);
        let last = self.field(offset_of!(Context, last));
        let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, next, last);
        or_slow(self, fits);

        self.b.ins().store(turns, now, progress, turns_at);
        let fewer = self.b.ins().iadd_imm_s(left, -1);
        self.set_field(offset_of!(Context, left), fewer);
        for part in 0..callee.params {
            let variable = self.variable(Reg(args.0.wrapping_add(part)));
            let value = self.b.use_var(variable);
            let flags = self.flags(Region::Window);
            self.b.ins().store(flags, value, next, i32::from(part) * 8);
        }
        self.set_field(offset_of!(Context, window), next);
        let number = self.b.ins().iconst(I64, i64::from(function) + 1);
        self.set_field(offset_of!(Context, function), number);
        let lists = i64::from(self.text.code.buffers) * size_of::<Slice>() as i64;
        self.move_field(offset_of!(Context, lists), lists);
        if holds {
            self.hold(1);
        }
        let signature = self.signature(&[I64, I64], &[I64]);
        let zero = self.b.ins().iconst(I64, 0);
        let call = self.b.ins().call_indirect(signature, entry, &[self.context, zero]);
        let answer = self.b.inst_results(call)[0];
        // The stack may have moved.
        self.move_field(offset_of!(Context, window), -size);
        self.move_field(offset_of!(Context, lists), -lists);
        let own = self.text.function.map_or(0, |number| i64::from(number) + 1);
        let own = self.b.ins().iconst(I64, own);
        self.set_field(offset_of!(Context, function), own);
        self.set_field(offset_of!(Context, left), left);
        let (done, trapped) = (self.b.create_block(), self.b.create_block());
        self.b.set_cold_block(trapped);
        let failed = self.b.ins().icmp_imm_s(IntCC::NotEqual, answer, APPLIED);
        self.b.ins().brif(failed, trapped, &[], done, &[]);
        self.b.switch_to_block(trapped);
        let number = self.b.ins().iconst(I64, self.at as i64);
        self.call_stub(stubs::calls::left as *const () as usize, &[number]);
        self.b.ins().jump(self.leave, &[]);
        self.b.switch_to_block(done);
        if holds {
            self.hold(-1);
        }
        let window = self.field(offset_of!(Context, window));
        for part in 0..callee.gives {
            let reg = Reg(to.0.wrapping_add(part));
            let flags = self.flags(Region::Window);
            let ty = if self.is_real(reg) { F64 } else { I64 };
            let place = i32::from(self.text.code.registers) + i32::from(part);
            let value = self.b.ins().load(ty, flags, window, place * 8);
            let variable = self.variable(reg);
            self.b.def_var(variable, value);
        }
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(slow);
        self.call_by_machine(inst);
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(on);
    }

    fn call_by_machine(&mut self, inst: &Inst) {
        self.spill_operands(inst);
        let number = self.b.ins().iconst(I64, self.at as i64);
        let done = self.call_stub(stubs::calls::call as *const () as usize, &[number]);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, done, 0);
        self.leave_if(failed);
        self.reload_written(inst);
    }

    /// A function that may be called directly, if it has been made for what this code expects.
    fn callee(&self, function: u16) -> Option<Callee> {
        let surroundings = &self.text.surroundings;
        let called = surroundings.functions.get(usize::from(function))?;
        let gives = gives(&called.code)?;
        let made = called.code.native.made(&called.code);
        let expected = Expected::of(&called.code, surroundings);
        if made.expected.get_or_init(|| expected.clone()) != &expected {
            return None;
        }
        // A function that an operation asks before its first write writes nothing.
        let wanted = match self.variant {
            Variant::Dry => Variant::Plain,
            variant => variant,
        };
        let entry = &raw const made.entries[made.variant(wanted) as usize];
        Some(Callee { entry, params: called.params, gives })
    }

    fn hold(&mut self, by: i64) {
        let place = self.field(offset_of!(Context, holding));
        let flags = self.flags(Region::Holding);
        let count = self.b.ins().load(I32, flags, place, 0);
        let count = self.b.ins().iadd_imm_s(count, by);
        self.b.ins().store(flags, count, place, 0);
    }

    /// Calls an operation.
    pub(super) fn apply(&mut self, inst: &Inst, applied: Reg, result: Reg) {
        self.spill_read(inst);
        let number = self.b.ins().iconst(I64, self.at as i64);
        let done = self.call_stub(stubs::calls::apply as *const () as usize, &[number]);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, done, 0);
        self.leave_if(failed);
        let before = self.whole(result);
        let is_given = self.b.ins().band_imm_u(done, 2);
        let made = self.b.ins().ushr_imm_u(done, 32);
        let made = self.b.ins().select(is_given, made, before);
        self.set_whole(result, made);
        let is_applied = self.b.ins().band_imm_u(done, 1);
        self.set_whole(applied, is_applied);
    }
}
