//! Native code, made by Cranelift from register code while the program runs.
//!
//! It decides nothing again: an instruction is spelled in those of the processor, or the machine
//! takes it ([`stubs::step`]). So results are the same, bit for bit, on both.
//!
//! # Safety
//!
//! This is the only place of the crate with `unsafe`. Why it is sound:
//!
//! * Native code reads and writes the window of its call, its context, and the tables of the mesh.
//!   A register is a constant offset into the window, which is never shorter than a register can
//!   name. The number of an element is tested against the length of its table before an address is
//!   computed from it, unless the same number has been tested in this call; tables do not become
//!   shorter while code runs that uses such a number. Nothing depends on a proof or on the mesh
//!   being valid.
//! * What native code is not given, the machine does, in safe code. After each such call the
//!   addresses of window and tables are taken anew, since they may have moved.
//! * While native code runs, nobody else has the machine and the mesh: it is entered with `&mut` of
//!   both, which are not used until it returns but by the functions that it calls.
//! * Its memory is written, then executable, never both. It is freed with the value that owns it,
//!   which is borrowed while it runs.
//! * No panic crosses it: the functions that it calls keep one, and it goes on behind.

#![allow(unsafe_code)]

mod compile;
mod context;
mod elements;
mod facts;
mod liveness;
mod operands;
mod stubs;
mod translate;
mod values;

use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering};

use compile::Compiled;
use context::{Context, NOTHING, Run};
use operands::Surroundings;
use translate::Text;

use super::call::MOST_CALLS;
use super::engine::Way;
use super::{Call, Engine, Inst, Machine, Message, Outcome, Reg, Trap, Watch};
use crate::mesh::{ColumnId, Mesh};

/// The ways in which a code is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variant {
    /// Nobody is told what is written.
    Plain,
    /// The machine writes, and tells the journal and the drains.
    Careful,
    /// It ends at its first write.
    Dry,
}

/// How often a code runs on the machine before it is compiled, which takes as long as some
/// thousand runs do.
const RUNS: u32 = 500;

/// How deep native code may be nested: beyond, the machine runs what is called, which takes no
/// more of the stack for functions that call each other.
const DEPTH: usize = 64;

/// The native code of a code, made when it has run often enough.
#[derive(Default)]
pub struct Native(OnceLock<Box<Made>>);

#[derive(Default)]
struct Made {
    runs: AtomicU32,
    variants: [OnceLock<Option<Compiled>>; 3],
}

impl Clone for Native {
    /// Nothing: who copies a code may change it.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for Native {
    /// Code is the same whether it has been compiled or not.
    fn eq(&self, _other: &Self) -> bool {
        true
    }
}

impl std::fmt::Debug for Native {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Native")
    }
}

impl Native {
    /// True if it pays to compile a code now: an operation, or a function that it calls, that has run
    /// often, where nobody is told what it writes.
    #[inline]
    fn is_due(&self, way: Way, variant: Variant) -> bool {
        if way == Way::Script || variant == Variant::Careful {
            return false;
        }
        let made = self.0.get_or_init(Box::default);
        let runs = made.runs.load(Ordering::Relaxed);
        if runs < RUNS {
            made.runs.store(runs + 1, Ordering::Relaxed);
        }
        runs >= RUNS
    }

    /// The native code in a variant.
    #[inline]
    fn get(&self, variant: Variant, make: impl FnOnce() -> Option<Compiled>) -> Option<&Compiled> {
        let made = self.0.get_or_init(Box::default);
        made.variants[variant as usize].get_or_init(make).as_ref()
    }
}

impl Machine {
    /// Runs the code of a call as native code; `None` where the machine is to run it.
    #[inline]
    pub(super) fn run_native(
        &mut self,
        mesh: &mut Mesh,
        call: Call<'_>,
        way: Way,
        watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        if self.engine == Engine::Machine || self.depth >= DEPTH || self.drains.is_reading() {
            return None;
        }
        let variant = match (way, mesh.is_journaled() || !self.drains.is_empty()) {
            (Way::Dry, _) => Variant::Dry,
            (_, true) => Variant::Careful,
            (_, false) => Variant::Plain,
        };
        let types = std::mem::take(&mut self.types);
        let surroundings =
            Surroundings { plans: call.plans, functions: call.functions, types: &types };
        let text = Text { code: call.code, refusals: call.refusals, way, surroundings };
        let native = &call.code.native;
        let compiled = match self.engine == Engine::NativeAtOnce || native.is_due(way, variant) {
            true => native.get(variant, || Compiled::make(text, variant)),
            false => None,
        };
        let compiled = compiled.filter(|compiled| compiled.fits(&surroundings));
        self.types = types;
        let compiled = compiled?;
        self.depth += 1;
        let outer = match way {
            Way::Function => self.frames,
            _ => std::mem::take(&mut self.frames),
        };
        let outcome = self.enter(mesh, call, compiled, watch);
        self.frames = outer;
        self.depth -= 1;
        Some(outcome)
    }

    /// Calls a function from native code: what it gives goes to the window of the caller.
    fn call_function(
        &mut self,
        mesh: &mut Mesh,
        caller: &Call<'_>,
        inst: usize,
        watch: &mut dyn Watch,
    ) -> Result<(), Trap> {
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
        let outcome = match self.run_native(mesh, call, Way::Function, watch) {
            Some(outcome) => outcome,
            // A function that it calls may drain.
            None => self.execute::<true>(mesh, call, watch),
        };
        self.frames -= 1;
        outcome.map_err(|trap| trap.through(caller, inst))?;
        self.holding -= u32::from(holds);
        let (base, from, width) = self.given;
        self.pass(base, from, caller.base + usize::from(to.0), width);
        Ok(())
    }

    fn enter(
        &mut self,
        mesh: &mut Mesh,
        call: Call<'_>,
        compiled: &Compiled,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.clear_buffers(&call);
        let mut run = Run {
            machine: self,
            mesh,
            call,
            watch,
            columns: Vec::new(),
            trap: None,
            refused: None,
            panic: None,
        };
        let mut context = Context::new(&mut run);
        // SAFETY: the context and its run outlive the call, and are not touched meanwhile but by
        // the functions that native code calls.
        let answer = unsafe { (compiled.entry)(&raw mut context) };
        if let Some(panic) = run.panic {
            resume_unwind(panic);
        }
        match answer {
            translate::APPLIED => {
                let (from, width) = (context.given as u16, (context.given >> 16) as u16);
                run.machine.given = (call.base, Reg(from), width);
                let result = (context.result != NOTHING).then_some(context.result as u32);
                Ok(Outcome::Applied { result })
            }
            translate::REFUSED => {
                let reason = context.place(0).noted.map(|(_, reason)| reason);
                Ok(Outcome::Refused { reason })
            }
            _ => match (run.trap, run.refused) {
                (Some(trap), _) => Err(trap),
                (None, Some(reason)) => Ok(Outcome::Refused { reason }),
                (None, None) => Err(Trap::new(Message::Malformed)),
            },
        }
    }

    /// Looks up the types of the attributes of the program on a mesh.
    pub(super) fn find_types(&mut self, mesh: &Mesh) {
        let attribute = |column: &Option<ColumnId>| {
            let column = (*column)?;
            Some((column.kind, mesh.column(column)?.data().attribute_type()))
        };
        self.types.clear();
        self.types.extend(self.columns.iter().map(attribute));
    }
}
