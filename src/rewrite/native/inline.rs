//! Inlining: functions that are translated where they are called.
//!
//! Within the inlined code the context is that of the function, as if it were called: stubs and
//! traps see the same. Arguments and results stay variables.

use std::mem::{offset_of, replace, take};

use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, InstBuilder, Value};
use cranelift_frontend::Variable;

use super::calls::gives;
use super::compile::entries;
use super::context::Context;
use super::facts::{Fact, Facts, KnownAt, Walk, targets};
use super::liveness::Liveness;
use super::registers::reals;
use super::stubs;
use super::translate::{Translator, Unit};
use crate::rewrite::engine::CodeKind;
use crate::rewrite::{Function, Inst, Reg};

/// The greatest number of instructions of an inlined function, of all inlined functions in one
/// code, and the greatest depth of inlining.
const MOST: usize = 120;
const MOST_IN_ALL: usize = 1200;
const DEPTH: usize = 4;

/// The place where an inlined function continues when it returns.
pub(super) struct Continuation {
    exit: Block,
    /// The variables of the caller for its value, and whether they hold reals.
    results: Vec<(Variable, bool)>,
}

/// The functions that are being inlined in a code, and the number of instructions inlined so far.
#[derive(Default)]
pub(super) struct Inlined {
    running: Vec<u16>,
    insts: usize,
}

impl<'a> Translator<'a, '_> {
    /// A function that may be inlined here, and the number of slots that it gives.
    fn inlined(&self, number: u16) -> Option<(&'a Function, u16)> {
        let called = self.unit.environment.functions.get(usize::from(number))?;
        let code = &called.code;
        let is_running =
            self.inlined.running.contains(&number) || self.unit.function == Some(number);
        let fits = code.insts.len() <= MOST
            && self.inlined.insts + code.insts.len() <= MOST_IN_ALL
            && self.inlined.running.len() < DEPTH;
        let is_plain = code.buffers == 0 && !code.opens_drain() && entries(code).is_empty();
        let ends_else =
            |inst: &Inst| matches!(inst, Inst::Return { .. } | Inst::Refuse | Inst::PreviewClear);
        if is_running || !fits || !is_plain || code.insts.iter().any(ends_else) {
            return None;
        }
        Some((called, gives(code)?))
    }

    /// Inlines a function instead of a call; false if it may not be inlined.
    pub(super) fn inline(
        &mut self,
        inst: &Inst,
        number: u16,
        [args, to]: [Reg; 2],
        holds: bool,
    ) -> bool {
        let Some((called, gives)) = self.inlined(number) else { return false };
        let [slow, on, exit, trapped] = [(); 4].map(|()| self.b.create_block());
        [slow, trapped].into_iter().for_each(|block| self.b.set_cold_block(block));
        let left = self.field(offset_of!(Context, left));
        self.or_slow(left, slow);
        let next = self.next_window(slow);
        self.begin_callee(left, next, i64::from(number) + 1);
        if holds {
            self.hold(1);
        }

        let params = (0..called.params).map(|part| Reg(args.0.wrapping_add(part)));
        let params: Vec<(Value, bool, Fact)> = params
            .map(|reg| {
                let variable = self.variable(reg);
                (self.b.use_var(variable), self.is_real(reg), self.fact(reg).elsewhere())
            })
            .collect();
        let results = (0..gives).map(|part| Reg(to.0.wrapping_add(part)));
        let results =
            results.map(|reg| (self.variable(reg), self.is_real(reg))).collect::<Vec<_>>();
        self.inline_body(number, called, &params, Continuation { exit, results }, trapped);

        self.b.switch_to_block(exit);
        self.return_to_caller(left);
        if holds {
            self.hold(-1);
        }
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(trapped);
        self.return_to_caller(left);
        let at = self.b.ins().iconst(I64, self.at as i64);
        self.call_stub(stubs::left as *const () as usize, &[at]);
        self.b.ins().jump(self.leave, &[]);

        self.b.switch_to_block(slow);
        self.call_by_machine(inst);
        self.join(on);
        true
    }

    /// Translates the code of an inlined function.
    fn inline_body(
        &mut self,
        number: u16,
        called: &'a Function,
        params: &[(Value, bool, Fact)],
        continuation: Continuation,
        trapped: Block,
    ) {
        let code = &called.code;
        let environment = self.unit.environment;
        let registers = usize::from(code.registers);
        let unit = Unit { code, kind: CodeKind::Function, function: Some(number), ..self.unit };
        let is_target = targets(code);
        let blocks = is_target.iter().map(|&is| is.then(|| self.b.create_block())).collect();
        let facts = Facts::of_params(registers, params.iter().map(|(_, _, fact)| *fact));
        let known_at = KnownAt::of(code, &facts, &environment);
        let variant = self.variant_of_function();
        self.inlined.running.push(number);
        self.inlined.insts += code.insts.len();
        let outer_unit = replace(&mut self.unit, unit);
        let outer_variant = replace(&mut self.variant, variant);
        let outer_variables = replace(&mut self.variables, vec![None; registers]);
        let is_real = reals(&code.insts, registers, &environment);
        let outer_real = replace(&mut self.is_real, is_real);
        let outer_blocks = replace(&mut self.blocks, blocks);
        let outer_known = replace(&mut self.known, Walk::with(facts));
        let outer_place = (self.at, self.skip, self.fault);
        let outer_faults = take(&mut self.faults);
        let outer_guards = take(&mut self.guards);
        let outer_set = take(&mut self.set);
        let outer_leave = replace(&mut self.leave, trapped);
        let outer_keeps = replace(&mut self.keeps_window, false);
        let outer_drains = take(&mut self.live_at_drains);
        let outer_continuation = self.continuation.replace(continuation);

        let live = Liveness::of(code, registers, &environment).at(0);
        let (passed, others): (Vec<Reg>, Vec<Reg>) =
            live.into_iter().partition(|reg| usize::from(reg.0) < params.len());
        others.into_iter().for_each(|reg| self.reload(reg));
        for reg in passed {
            let (value, is_real, _) = params[usize::from(reg.0)];
            if is_real { self.set_real(reg, value) } else { self.set_whole(reg, value) }
        }
        self.body(&known_at);
        self.faults();

        self.unit = outer_unit;
        self.variant = outer_variant;
        self.variables = outer_variables;
        self.is_real = outer_real;
        self.blocks = outer_blocks;
        self.known = outer_known;
        (self.at, self.skip, self.fault) = outer_place;
        self.faults = outer_faults;
        self.guards = outer_guards;
        self.set = outer_set;
        self.leave = outer_leave;
        self.keeps_window = outer_keeps;
        self.live_at_drains = outer_drains;
        self.continuation = outer_continuation;
        self.inlined.running.pop();
    }

    /// Sets the value of an inlined function in its caller; false if the function is not inlined.
    pub(super) fn give_back(&mut self, from: Reg) -> bool {
        let Some(Continuation { results, .. }) = &self.continuation else { return false };
        let results = results.clone();
        for (part, (variable, is_real)) in (0..).zip(results) {
            let reg = Reg(from.0.wrapping_add(part));
            let value = if is_real { self.real(reg) } else { self.whole(reg) };
            self.b.def_var(variable, value);
        }
        true
    }

    /// Returns from an inlined function to its caller; false if the function is not inlined.
    pub(super) fn go_back(&mut self) -> bool {
        let exit = self.continuation.as_ref().map(|to| to.exit);
        if let Some(exit) = exit {
            self.b.ins().jump(exit, &[]);
        }
        exit.is_some()
    }
}
