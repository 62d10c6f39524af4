//! Calls of functions and of operations.
//!
//! A function that has native code is called directly: its window is behind that of the caller,
//! which stores the arguments there and loads the value from there. Otherwise the machine calls it.

use std::mem::offset_of;
use std::sync::atomic::AtomicUsize;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I32, I64};
use cranelift_codegen::ir::{Block, InstBuilder, Value};

use super::compile::{Expected, is_flat};
use super::context::{Context, NOTHING};
use super::facts::reached;
use super::operands::Environment;
use super::translate::{REFUSED, Region, TRAPPED, Translator};
use super::{Variant, stubs};
use crate::rewrite::engine::CodeKind;
use crate::rewrite::known_level::KnownLevel;
use crate::rewrite::watch::{ITERATIONS_PER_POLL, Progress};
use crate::rewrite::{Code, Count, Inst, List, Reg};

/// The number of slots that a function gives, if it is always the same.
pub(super) fn gives(code: &Code) -> Option<u16> {
    let reached = reached(code);
    let mut widths = code.insts.iter().zip(reached).filter_map(|(inst, reached)| match inst {
        Inst::ReturnValue { width, .. } if reached => Some(*width),
        _ => None,
    });
    let first = widths.next()?;
    widths.all(|width| width == first).then_some(first)
}

/// An operation that may be called directly.
struct Operation {
    /// The place of its entry address.
    entry: *const AtomicUsize,
    number: u16,
    params: u16,
    /// The states of the known level in which no validation or tracking is needed.
    states: u64,
    may_lower: bool,
    has_result: bool,
}

/// A function that may be called directly.
struct Callee {
    /// The place of its entry address.
    entry: *const AtomicUsize,
    params: u16,
    gives: u16,
}

impl Translator<'_, '_> {
    /// Ends a function: its value goes to the start of its window.
    pub(super) fn give(&mut self, from: Reg, width: u16) {
        let values: Vec<Value> = (0..width)
            .map(|part| {
                let variable = self.variable(Reg(from.0.wrapping_add(part)));
                self.b.use_var(variable)
            })
            .collect();
        let window = self.field(offset_of!(Context, window));
        for (part, value) in (0..).zip(values) {
            self.store(Region::Window, value, window, part * 8);
        }
        let given = self.b.ins().iconst(I32, i64::from(width));
        self.store(Region::Context, given, self.context, offset_of!(Context, given));
    }

    pub(super) fn call_function(
        &mut self,
        inst: &Inst,
        function: u16,
        [args, to]: [Reg; 2],
        holds: bool,
    ) {
        if self.inline(inst, function, [args, to], holds) {
            return;
        }
        let Some(callee) = self.callee(function) else { return self.call_by_machine(inst) };
        let [slow, on] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(slow);
        // The machine makes the call if too many calls are nested, the watcher is due, there is no
        // native code yet, or the stack of registers has to grow.
        let left = self.field(offset_of!(Context, left));
        self.or_slow(left, slow);
        let progress = self.field(offset_of!(Context, progress));
        let iterations = offset_of!(Progress, iterations);
        let now = self.load(I32, Region::Progress, progress, iterations);
        let now = self.b.ins().iadd_imm_s(now, 1);
        let rest = self.b.ins().band_imm_u(now, i64::from(ITERATIONS_PER_POLL - 1));
        self.or_slow(rest, slow);
        let (entry, next) = self.callable(callee.entry, slow);

        self.store(Region::Progress, now, progress, iterations);
        self.pass(args, callee.params, next);
        self.begin_callee(left, next, i64::from(function) + 1);
        if holds {
            self.hold(1);
        }
        let answer = self.enter(entry, left);
        self.go_on_unless(answer, REFUSED);
        if holds {
            self.hold(-1);
        }
        let window = self.field(offset_of!(Context, window));
        for part in 0..callee.gives {
            let reg = Reg(to.0.wrapping_add(part));
            let ty = if self.is_real(reg) { F64 } else { I64 };
            let place = usize::from(self.unit.code.registers) + usize::from(part);
            let value = self.load(ty, Region::Window, window, place * 8);
            let variable = self.variable(reg);
            self.b.def_var(variable, value);
        }
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(slow);
        self.call_by_machine(inst);
        self.join(on);
    }

    pub(super) fn call_by_machine(&mut self, inst: &Inst) {
        self.execute_by(stubs::call as *const () as usize, inst);
    }

    /// A function that may be called directly, if it was compiled for what this code expects.
    fn callee(&self, function: u16) -> Option<Callee> {
        let environment = &self.unit.environment;
        let called = environment.functions.get(usize::from(function))?;
        let gives = gives(&called.code)?;
        let compilation = called.code.native.compilation(&called.code);
        let expected = Expected::of(&called.code, environment);
        if compilation.expected.get_or_init(|| expected.clone()) != &expected {
            return None;
        }
        let variant = compilation.variant(self.variant_of_function());
        let entry = &raw const compilation.entries[variant as usize];
        Some(Callee { entry, params: called.params, gives })
    }

    /// The variant of a function that is called here: one that an operation calls before its first
    /// write writes nothing.
    pub(super) fn variant_of_function(&self) -> Variant {
        if self.variant == Variant::Dry { Variant::Plain } else { self.variant }
    }

    pub(super) fn hold(&mut self, by: i64) {
        let place = self.field(offset_of!(Context, holding));
        let count = self.load(I32, Region::Holding, place, 0);
        let count = self.b.ins().iadd_imm_s(count, by);
        self.store(Region::Holding, count, place, 0);
    }

    /// Calls an operation.
    pub(super) fn apply(&mut self, inst: &Inst, op: u16, args: Reg, [applied, result]: [Reg; 2]) {
        let Some(callee) = self.operation(op, self.variant) else {
            return self.apply_by_machine(inst, [applied, result]);
        };
        let [slow, on] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(slow);
        let refuses = self.call_op(&callee, args, slow);
        let [done, refused] = [(); 2].map(|()| self.b.create_block());
        self.b.ins().brif(refuses, refused, &[], done, &[]);

        self.b.switch_to_block(done);
        let counts = self.field(offset_of!(Context, counts));
        let place = usize::from(op) * size_of::<Count>() + offset_of!(Count, applied);
        let count = self.load(I64, Region::Counts, counts, place);
        let count = self.b.ins().iadd_imm_s(count, 1);
        self.store(Region::Counts, count, counts, place);
        if callee.may_lower {
            let lowered = self.field(offset_of!(Context, lowered));
            let number = self.b.ins().iconst(I32, i64::from(op) + 1);
            self.store(Region::Counts, number, lowered, 0);
        }
        if callee.has_result {
            let made = self.field(offset_of!(Context, result));
            let nothing = self.b.ins().iconst(I64, NOTHING as i64);
            self.set_field(offset_of!(Context, result), nothing);
            let before = self.whole(result);
            let is_given = self.b.ins().icmp(IntCC::NotEqual, made, nothing);
            let made = self.b.ins().select(is_given, made, before);
            self.set_whole(result, made);
        }
        let one = self.b.ins().iconst(I64, 1);
        self.set_whole(applied, one);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(refused);
        let number = self.b.ins().iconst(I64, i64::from(op));
        self.call_stub(stubs::refused as *const () as usize, &[number]);
        let zero = self.b.ins().iconst(I64, 0);
        self.set_whole(applied, zero);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(slow);
        self.apply_by_machine(inst, [applied, result]);
        self.join(on);
    }

    fn apply_by_machine(&mut self, inst: &Inst, [applied, result]: [Reg; 2]) {
        self.spill_read(inst);
        let done = self.call_here(stubs::calls::apply as *const () as usize);
        let before = self.whole(result);
        let is_given = self.b.ins().band_imm_u(done, 2);
        let made = self.b.ins().ushr_imm_u(done, 32);
        let made = self.b.ins().select(is_given, made, before);
        self.set_whole(result, made);
        let is_applied = self.b.ins().band_imm_u(done, 1);
        self.set_whole(applied, is_applied);
    }

    /// Asks an operation whether it would apply.
    pub(super) fn ask_op(&mut self, inst: &Inst, op: u16, args: Reg, to: Reg) {
        let Some(callee) = self.operation(op, Variant::Dry) else { return self.step(inst) };
        let [slow, on] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(slow);
        let refuses = self.call_op(&callee, args, slow);
        let applies = self.b.ins().icmp_imm_u(IntCC::Equal, refuses, 0);
        let applies = self.b.ins().uextend(I64, applies);
        self.set_whole(to, applies);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(slow);
        self.step(inst);
        self.join(on);
    }

    /// An operation that may be called directly, if it was compiled for what this code expects and
    /// calls nothing itself.
    fn operation(&self, op: u16, wanted: Variant) -> Option<Operation> {
        let environment = &self.unit.environment;
        let is_of_script = matches!(self.unit.kind, CodeKind::Script | CodeKind::Function);
        let plan = environment.plans.get(usize::from(op))?.as_ref()?;
        if !is_of_script || plan.steps.is_some() || !is_flat(&plan.code) {
            return None;
        }
        let functions = &plan.code.functions;
        let expected = Expected::of(&plan.code, &Environment { functions, ..*environment });
        let compilation = plan.code.native.compilation(&plan.code);
        if compilation.expected.get_or_init(|| expected.clone()) != &expected {
            return None;
        }
        Some(Operation {
            entry: &raw const compilation.entries[compilation.variant(wanted) as usize],
            number: op,
            params: environment.params_of_op(op),
            states: KnownLevel::quiet_states(plan, wanted == Variant::Dry),
            may_lower: plan.may_lower(),
            has_result: plan.result.is_some(),
        })
    }

    /// Calls an operation directly, or jumps to `slow` if that is not possible; returns whether it
    /// refuses.
    fn call_op(&mut self, callee: &Operation, args: Reg, slow: Block) -> Value {
        let state = self.field(offset_of!(Context, level));
        let states = self.b.ins().iconst(I64, callee.states as i64);
        let is_quiet = self.b.ins().ushr(states, state);
        let is_quiet = self.b.ins().band_imm_u(is_quiet, 1);
        self.or_slow(is_quiet, slow);
        let left = self.field(offset_of!(Context, left));
        self.or_slow(left, slow);
        let (entry, next) = self.callable(callee.entry, slow);
        self.pass(args, callee.params, next);
        self.begin_callee(left, next, 0);
        let number = self.b.ins().iconst(I64, i64::from(callee.number) + 1);
        self.set_field(offset_of!(Context, op), number);
        // Refusals noted by an earlier operation do not count.
        let none = self.b.ins().iconst(I32, 0);
        self.store(Region::Context, none, self.context, offset_of!(Context, noted));
        let answer = self.enter(entry, left);
        let zero = self.b.ins().iconst(I64, 0);
        self.set_field(offset_of!(Context, op), zero);
        self.set_field(offset_of!(Context, level), state);
        self.go_on_unless(answer, TRAPPED);
        answer
    }

    /// The entry address and the start of the window of a callee; jumps to `slow` if it has no
    /// native code or the stack has no room.
    fn callable(&mut self, entry: *const AtomicUsize, slow: Block) -> (Value, Value) {
        let place = self.b.ins().iconst(I64, entry.addr() as i64);
        let entry = self.load(I64, Region::Entries, place, 0);
        self.or_slow(entry, slow);
        (entry, self.next_window(slow))
    }

    /// The start of the window of a callee; jumps to `slow` if the stack has no room.
    pub(super) fn next_window(&mut self, slow: Block) -> Value {
        let size = i64::from(self.unit.code.registers) * 8;
        let window = self.field(offset_of!(Context, window));
        let next = self.b.ins().iadd_imm_s(window, size);
        let last = self.field(offset_of!(Context, last));
        let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, next, last);
        self.or_slow(fits, slow);
        next
    }

    /// Stores arguments in the window of the callee.
    fn pass(&mut self, args: Reg, params: u16, window: Value) {
        for part in 0..params {
            let variable = self.variable(Reg(args.0.wrapping_add(part)));
            let value = self.b.use_var(variable);
            self.store(Region::Window, value, window, usize::from(part) * 8);
        }
    }

    /// Makes the context that of a callee: with a window, and the number of its function plus 1, or
    /// 0 if it is an operation. `left` is the number of calls that may be nested in the caller.
    pub(super) fn begin_callee(&mut self, left: Value, window: Value, function: i64) {
        let fewer = self.b.ins().iadd_imm_s(left, -1);
        self.set_field(offset_of!(Context, left), fewer);
        self.set_field(offset_of!(Context, window), window);
        let function = self.b.ins().iconst(I64, function);
        self.set_field(offset_of!(Context, function), function);
        self.move_field(offset_of!(Context, lists), self.size_of_lists());
    }

    /// Makes the context that of the caller again.
    pub(super) fn return_to_caller(&mut self, left: Value) {
        // The stack may have moved.
        let size = i64::from(self.unit.code.registers) * 8;
        self.move_field(offset_of!(Context, window), -size);
        self.move_field(offset_of!(Context, lists), -self.size_of_lists());
        self.set_field(offset_of!(Context, left), left);
        let own = self.unit.function.map_or(0, |number| i64::from(number) + 1);
        let own = self.b.ins().iconst(I64, own);
        self.set_field(offset_of!(Context, function), own);
    }

    fn size_of_lists(&self) -> i64 {
        i64::from(self.unit.code.buffers) * size_of::<List>() as i64
    }

    /// Enters the callee, whose context has begun; afterwards the context is that of the caller.
    fn enter(&mut self, entry: Value, left: Value) -> Value {
        let signature = self.signature(&[I64, I64], &[I64]);
        let zero = self.b.ins().iconst(I64, 0);
        let call = self.b.ins().call_indirect(signature, entry, &[self.context, zero]);
        let answer = self.b.inst_results(call)[0];
        self.return_to_caller(left);
        answer
    }

    /// Continues unless the answer of the callee is `least` or more: then it was left by a trap,
    /// whose trace gets the place of this call.
    fn go_on_unless(&mut self, answer: Value, least: i64) {
        let [on, trapped] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(trapped);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, answer, least);
        self.b.ins().brif(failed, trapped, &[], on, &[]);
        self.b.switch_to_block(trapped);
        let number = self.b.ins().iconst(I64, self.at as i64);
        self.call_stub(stubs::left as *const () as usize, &[number]);
        self.b.ins().jump(self.leave, &[]);
        self.go_on(on);
    }
}
