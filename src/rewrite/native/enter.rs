//! The machine's ways into native code.

use std::panic::resume_unwind;
use std::time::Instant;

use super::compile::Compiled;
use super::context::{Context, Run, noted};
use super::operands::Environment;
use super::translate::Unit;
use super::{DEPTH, LEAST_STACK, MORE_STACK, Variant};
use crate::mesh::{ColumnId, Mesh};
use crate::rewrite::call::MOST_CALLS;
use crate::rewrite::dispatch::Place;
use crate::rewrite::engine::CodeKind;
use crate::rewrite::{Call, Engine, Function, Inst, Machine, Message, Outcome, Reg, Trap, Watch};

impl Call<'_> {
    /// Counts an iteration of a loop of code that the machine runs. Returns whether native code may
    /// take over the rest.
    #[inline]
    pub(in super::super) fn has_looped(&self) -> bool {
        self.code.native.compilation(self.code).count()
    }
}

impl Machine {
    /// Runs the code of a call as native code; `None` if the machine has to run it.
    #[inline]
    pub(in super::super) fn run_native(
        &mut self,
        mesh: &mut Mesh,
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        let compiled = self.compiled(mesh, &call)?;
        Some(self.enter(mesh, call, (compiled, 0, 0), watch))
    }

    /// Whether a function is to be called as native code by code that the machine runs.
    #[inline]
    pub(in super::super) fn is_native_due(
        &mut self,
        mesh: &Mesh,
        caller: &Call<'_>,
        (number, function): (u16, &Function),
    ) -> bool {
        if self.engine == Engine::Machine || self.is_dry {
            return false;
        }
        let mut call = *caller;
        call.become_function(number, function);
        self.compiled(mesh, &call).is_some()
    }

    /// Runs the rest of the code of a call, from after an iteration of a loop, as native code;
    /// `None` if the machine has to run it.
    pub(in super::super) fn go_on_native(
        &mut self,
        mesh: &mut Mesh,
        call: Call<'_>,
        place: Place,
        watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        let compiled = self.compiled(mesh, &call)?;
        let entry = compiled.entry_at(place.at)?;
        Some(self.enter(mesh, call, (compiled, entry, noted(place.noted)), watch))
    }

    /// The native code for a call, which is compiled if it pays now.
    #[inline]
    pub(super) fn compiled<'c>(&mut self, mesh: &Mesh, call: &Call<'c>) -> Option<&'c Compiled> {
        if self.engine == Engine::Machine || self.depth >= DEPTH || self.drains.is_reading() {
            return None;
        }
        let wanted = match (call.kind, mesh.keeps_journal() || !self.drains.is_empty()) {
            (CodeKind::Dry, _) => Variant::Dry,
            (_, true) => Variant::Careful,
            (_, false) => Variant::Plain,
        };
        let compilation = call.code.native.compilation(call.code);
        let variant = compilation.variant(wanted);
        let compiled = match compilation.variants[variant as usize].get() {
            Some(compiled) => compiled,
            None if self.engine == Engine::NativeAtOnce || compilation.count() => {
                compilation.variants[variant as usize].get_or_init(|| self.compile(call, variant))
            }
            None => return None,
        };
        let environment =
            Environment { plans: call.plans, functions: call.functions, types: &self.types };
        compiled.as_ref().filter(|compiled| compiled.fits(&environment))
    }

    #[cold]
    fn compile(&mut self, call: &Call<'_>, variant: Variant) -> Option<Compiled> {
        let started = Instant::now();
        let environment =
            Environment { plans: call.plans, functions: call.functions, types: &self.types };
        let Call { code, refusals, kind, function, .. } = *call;
        let unit = Unit { code, refusals, kind, function, environment };
        let compiled = Compiled::make(unit, variant, &self.plans);
        if let Some(compiled) = &compiled {
            code.native.compilation(code).publish(variant, compiled);
        }
        self.compiling += started.elapsed();
        compiled
    }

    /// Calls a function from running code and copies its value to the window of the caller. If an
    /// operation in steps refuses, the function does not return, and the outcome is the refusal.
    pub(in super::super) fn call_function(
        &mut self,
        mesh: &mut Mesh,
        caller: &Call<'_>,
        inst: usize,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let failed = |message| Err(Trap::new(message).through(caller, inst));
        let Some(&Inst::Call { function, args, to, holds }) = caller.code.insts.get(inst) else {
            return failed(Message::Malformed);
        };
        let Some(called) = caller.functions.get(usize::from(function)) else {
            return failed(Message::Malformed);
        };
        if self.frames >= MOST_CALLS {
            return failed(Message::TooDeep);
        }
        if self.progress.tick(watch).is_break() {
            return failed(Message::Interrupted);
        }
        let mut call = *caller;
        call.enter(function, called);
        self.pass(caller.base, args, call.base, called.params);
        self.holding += u32::from(holds);
        self.frames += 1;
        let outcome = match self.run_native(mesh, call, watch) {
            Some(outcome) => outcome,
            // The function, or one that it calls, may drain.
            None => self.execute::<true>(mesh, call, watch),
        };
        self.frames -= 1;
        let outcome = outcome.map_err(|trap| trap.through(caller, inst))?;
        if let Outcome::Applied { .. } = outcome {
            self.holding -= u32::from(holds);
            let (base, from, width) = self.given;
            self.pass(base, from, caller.base + usize::from(to.0), width);
        }
        Ok(outcome)
    }

    /// Enters native code at one of its entries.
    fn enter(
        &mut self,
        mesh: &mut Mesh,
        call: Call<'_>,
        (compiled, entry, noted): (&Compiled, i64, u32),
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let (frames, depth) = (self.frames, self.depth);
        // An operation or script counts its own functions.
        if call.kind != CodeKind::Function {
            self.frames = 0;
        }
        self.depth += 1;
        let left = DEPTH.min(MOST_CALLS.saturating_sub(self.frames)).saturating_sub(1);
        let is_of_script = call.op.is_none() && call.steps.is_none() && call.depth == 0;
        let calls_directly = is_of_script && !watch.follows_operations();
        let mut run = Run {
            scratch: self.scratch.pop().unwrap_or_default(),
            frames: self.frames,
            machine: self,
            mesh,
            call,
            watch,
            attributes: &compiled.attributes,
            calls_directly,
            left: left as u64,
            trap: None,
            refused: None,
            panic: None,
        };
        let mut context = Context::new(&mut run, noted);
        let context_at = &raw mut context;
        // SAFETY: the context and its run outlive the call, and are accessed during it only by
        // native code and the functions that it calls.
        let enter = || unsafe { (compiled.entry)(context_at, entry) };
        let answer = stacker::maybe_grow(LEAST_STACK, MORE_STACK, enter);
        context.settle(&mut run);
        let Run { machine, scratch, trap, refused, panic, .. } = run;
        machine.scratch.push(scratch);
        (machine.frames, machine.depth) = (frames, depth);
        if let Some(panic) = panic {
            resume_unwind(panic);
        }
        machine.given = (call.base, Reg(0), context.given as u16);
        match (context.outcome(answer), trap, refused) {
            (Some(outcome), _, _) => Ok(outcome),
            (None, Some(trap), _) => Err(trap),
            (None, None, Some(reason)) => Ok(Outcome::Refused { reason }),
            (None, None, None) => Err(Trap::new(Message::Malformed)),
        }
    }

    /// Looks up the types of the attributes of the program on a mesh.
    pub(in super::super) fn find_types(&mut self, mesh: &Mesh) {
        let attribute = |column: &Option<ColumnId>| {
            let column = (*column)?;
            Some((column.kind, mesh.column(column)?.data().attribute_type()))
        };
        self.types.clear();
        self.types.extend(self.columns.iter().map(attribute));
    }
}
