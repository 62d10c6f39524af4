//! The machine: a stack of registers, buffers, and counts.
//!
//! It runs any code on any mesh and does not panic: every number that should be that of an element
//! is tested where it is used. It does not guarantee that a trap leaves the mesh unchanged: in the
//! code of an operation everything that can trap or refuse must come before the first write, which
//! the compiler has to ensure; a script that traps keeps its effects so far.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::attempt::Interner;
use super::drain::Drains;
use super::key_paths::KeyPaths;
use super::known_level::KnownLevel;
use super::native::Scratch;
use super::neighbors::Listed;
use super::preview::Preview;
use super::random::RandomNumbers;
use super::watch::Progress;
use super::window::reserve;
use super::{
    Call, Code, Engine, Holder, List, Matched, Message, Outcome, Plan, Plans, Reg, Trap, Unwatched,
    Watch,
};
use crate::mesh::{Adjacency, AttributeType, Bookmark, ColumnId, ElementKind, Level, Mesh};

/// The greatest depth of nested calls of operations.
const DEPTH: usize = 64;

/// Runs code on meshes.
#[derive(Debug)]
pub struct Machine {
    pub(super) plans: Plans,
    /// The columns of the mesh for the attributes of the program, by number.
    pub(super) columns: Vec<Option<ColumnId>>,
    pub(super) stack: Vec<u64>,
    pub(super) buffers: Vec<List>,
    /// The slots that the part of a loop has kept; there is room for all values that it will keep,
    /// and for the writes of most parts.
    pub(super) kept: List,
    /// The preview that guards query.
    pub(super) preview: Preview,
    pub(super) drains: Drains,
    /// The paths of the keys of the drains.
    pub(super) paths: KeyPaths,
    pub(super) progress: Progress,
    /// The line that is being printed.
    pub(super) line: String,
    pub(super) counts: Vec<Count>,
    /// The level that the mesh is known to have.
    pub(super) known: KnownLevel,
    /// The operation called last that refused, and its reason.
    pub(super) last_refusal: Option<(u16, Option<u16>)>,
    /// Whether the running operation is only asked: it ends at its first write.
    pub(super) is_dry: bool,
    /// The instruction at which the operation that was asked last has stopped.
    pub(super) stopped_at: usize,
    /// The source of `random`.
    pub(super) random: RandomNumbers,
    /// The texts that code has made while it ran.
    pub(super) interner: Interner,
    /// The number of running calls that require that no id is reused.
    pub(super) holding: u32,
    /// Meshes to compare with, by number.
    pub(super) meshes: Vec<Mesh>,
    /// The elements that were created, if they are to be recorded.
    pub(super) created: Option<Vec<(ElementKind, u32)>>,
    /// The limit of the memory of mesh and lists, in bytes.
    pub(super) memory: usize,
    pub(super) engine: Engine,
    /// The number of functions that native code has called and that have not returned, in the
    /// running operation or script.
    pub(super) frames: usize,
    /// The number of times that native code has been entered and not yet left.
    pub(super) depth: usize,
    /// The value of the function that returned last: the base of its window, the first register,
    /// the width.
    pub(super) given: (usize, Reg, u16),
    /// The kinds and types of the attributes on the mesh of this run, by number.
    #[cfg_attr(not(feature = "native"), expect(dead_code, reason = "for native code"))]
    pub(super) types: Vec<Option<(ElementKind, AttributeType)>>,
    /// Lists for runs of native code, kept for reuse.
    #[cfg_attr(not(feature = "native"), expect(dead_code, reason = "for native code"))]
    pub(super) scratch: Vec<Scratch>,
    /// The time spent on compiling native code.
    pub(super) compiling: Duration,
    /// Whether other threads read the mesh at the same time; then nobody writes to it.
    pub(super) is_beside_others: bool,
    /// The lists of neighbors that loops read, while nothing is written.
    pub(super) neighbors: Option<Arc<Adjacency>>,
    /// The lists of neighbors for loops over all vertices, valid until an operation is applied.
    pub(super) listed: Listed,
    /// The machines of other threads, kept for reuse.
    pub(super) workers: Vec<Machine>,
}

/// A name, the kind of the elements that it denotes, and their ids.
pub type NamedElements<'p> = (&'p str, ElementKind, Vec<u32>);

/// The counts of the calls of an operation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// The number of applied calls.
    pub applied: u64,
    /// The number of refused calls, by the number of the reason.
    pub refused: Vec<u64>,
}

impl Default for Machine {
    /// A machine for code that calls no operation.
    fn default() -> Self {
        Self::new(&Plans::default())
    }
}

impl Machine {
    /// Creates a machine for code that calls these operations. `None` stands for an operation that
    /// has not been proved; calling it traps.
    pub fn new(plans: &Plans) -> Self {
        let refusals = |plan: &Option<Plan>| plan.as_ref().map_or(0, |plan| plan.refusals.len());
        let count = |plan| Count { applied: 0, refused: vec![0; refusals(plan)] };
        Self {
            plans: Plans::clone(plans),
            columns: Vec::new(),
            stack: Vec::new(),
            buffers: Vec::new(),
            kept: List::default(),
            preview: Preview::default(),
            drains: Drains::default(),
            paths: KeyPaths::default(),
            progress: Progress::default(),
            line: String::new(),
            counts: plans.iter().map(count).collect(),
            known: KnownLevel::new(Level::Map),
            last_refusal: None,
            is_dry: false,
            stopped_at: 0,
            random: RandomNumbers::new(0),
            interner: Interner::default(),
            holding: 0,
            meshes: Vec::new(),
            created: None,
            memory: usize::MAX,
            engine: Engine::default(),
            frames: 0,
            depth: 0,
            given: (0, Reg(0), 0),
            types: Vec::new(),
            scratch: Vec::new(),
            compiling: Duration::ZERO,
            is_beside_others: false,
            neighbors: None,
            listed: Listed::default(),
            workers: Vec::new(),
        }
    }

    /// Sets the columns that the mesh of the next run has for the attributes of the program, by
    /// number. Code that uses an attribute without a column traps.
    pub fn use_columns(&mut self, columns: Vec<Option<ColumnId>>) {
        self.columns = columns;
    }

    /// Sets the engine for the next runs.
    pub fn use_engine(&mut self, engine: Engine) {
        self.engine = engine;
    }

    /// Declares that the mesh of the next run has a level. Where an operation for meshes of a
    /// higher level is called, or an operation has been applied that may have lowered the level,
    /// the mesh is validated; the call traps if it does not have the level.
    pub fn trust_level(&mut self, level: Level) {
        self.known = KnownLevel::new(level);
    }

    /// Declares that the mesh of the next run has a level before anything is written to it.
    pub(crate) fn begin_at_level(&mut self, level: Level) {
        self.known = KnownLevel::at_start(level);
    }

    /// Sets the seed of the random numbers of the next runs; without it, it is 0.
    pub fn seed(&mut self, seed: u64) {
        self.random = RandomNumbers::new(seed);
    }

    /// True if its random numbers begin at a seed.
    pub fn is_at_seed(&self, seed: u64) -> bool {
        self.random == RandomNumbers::new(seed)
    }

    /// Gives the next runs the random numbers that another one would have.
    pub fn go_on_from(&mut self, other: &Self) {
        self.random = other.random.clone();
    }

    /// Sets the meshes that the next run compares with, by number; the run may replace them.
    pub fn use_meshes(&mut self, meshes: Vec<Mesh>) {
        self.meshes = meshes;
    }

    /// Starts to record the elements that each run creates.
    pub fn remember_created(&mut self) {
        self.created.get_or_insert_default();
    }

    /// Stops recording created elements.
    pub fn forget_created(&mut self) {
        self.created = None;
    }

    /// The elements that the last run created, in order of creation, if this is recorded. Some may
    /// have been erased since.
    pub fn created(&self) -> &[(ElementKind, u32)] {
        self.created.as_deref().unwrap_or_default()
    }

    /// The total time spent on compiling native code.
    pub fn compiling(&self) -> Duration {
        self.compiling
    }

    /// The window of the last run: the values of its registers. They are unspecified after a script
    /// with loops.
    pub fn window(&self) -> &[u64] {
        &self.stack
    }

    /// The alternative of an operation that matched when it was last [asked](Self::ask) and would
    /// be applied, and the elements that its names denote; `None` for an operation in steps.
    pub fn matched<'p>(&self, plan: &'p Plan) -> Option<(usize, Vec<NamedElements<'p>>)> {
        let stopped = |matched: &Matched| matched.from as usize <= self.stopped_at;
        let rule = plan.matched.iter().rposition(stopped)?;
        let ids = |slots: &[u64]| slots.iter().map(|&slot| slot as u32).collect();
        let names = plan.matched[rule].names.iter().map(|(name, kind, holder)| {
            let slots = match *holder {
                Holder::Reg(reg) => self.stack.get(usize::from(reg.0)).map(std::slice::from_ref),
                Holder::Buffer(buffer) => self.buffers.get(usize::from(buffer)).map(|list| &**list),
            };
            (name.as_str(), *kind, slots.map_or_else(Vec::new, ids))
        });
        Some((rule, names.collect()))
    }

    /// The text of a number in the [window](Self::window); the code is that of the run.
    pub fn text<'t>(&'t self, code: &'t Code, number: u64) -> Option<&'t str> {
        self.interner.text(&code.texts, u32::try_from(number).ok()?)
    }

    /// The level that the mesh of the last run is known to have.
    pub fn level(&self) -> Level {
        self.known.now()
    }

    /// Resets all counts to zero.
    pub fn clear_counts(&mut self) {
        for count in &mut self.counts {
            count.applied = 0;
            count.refused.fill(0);
        }
    }

    /// The counts of the calls of each operation so far.
    pub fn counts(&self) -> &[Count] {
        &self.counts
    }

    /// Runs code with the arguments at the start of its window.
    pub fn run(
        &mut self,
        mesh: &mut Mesh,
        code: &Code,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start(mesh, args);
        let plans = Plans::clone(&self.plans);
        if let Some(outcome) = self.run_native(mesh, Call::top(code, &plans), watch) {
            return outcome;
        }
        match code.drains() {
            true => self.execute::<true>(mesh, Call::top(code, &plans), watch),
            false => self.execute::<false>(mesh, Call::top(code, &plans), watch),
        }
    }

    /// Runs code in which no drain runs, as [`Code::drains`] tells, on the machine.
    pub fn run_without_drains(
        &mut self,
        mesh: &mut Mesh,
        code: &Code,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start(mesh, args);
        let plans = Plans::clone(&self.plans);
        self.execute::<false>(mesh, Call::top(code, &plans), watch)
    }

    /// Applies an operation with the arguments in slots. The call is not counted.
    pub fn apply(&mut self, mesh: &mut Mesh, plan: &Plan, args: &[u64]) -> Result<Outcome, Trap> {
        self.apply_watched(mesh, plan, args, &mut Unwatched)
    }

    /// [`apply`](Self::apply) with a watcher.
    pub fn apply_watched(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start_watched(mesh, args, watch)?;
        let plans = Plans::clone(&self.plans);
        self.carry_out::<false>(mesh, plan, Call::of(plan, &plans), watch)
    }

    /// Asks whether an operation would be applied with the arguments in slots, and if not, why. The
    /// mesh is left unchanged, nothing is printed or counted, and there is no result.
    pub fn ask(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start_watched(mesh, args, watch)?;
        let plans = Plans::clone(&self.plans);
        // Native code would not leave the matched elements in the window.
        let engine = std::mem::replace(&mut self.engine, Engine::Machine);
        let outcome = self.consider(mesh, plan, Call::of(plan, &plans), watch);
        self.engine = engine;
        outcome
    }

    /// The start of a call that is one of many: the watcher is called now and then.
    pub(super) fn start_watched(
        &mut self,
        mesh: &Mesh,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<(), Trap> {
        self.start(mesh, args);
        match self.progress.tick(watch) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(Trap::new(Message::Interrupted)),
        }
    }

    pub(super) fn start(&mut self, mesh: &Mesh, args: &[u64]) {
        self.find_types(mesh);
        self.line.clear();
        self.drains.clear();
        self.paths.clear();
        self.last_refusal = None;
        self.is_dry = false;
        self.holding = 0;
        (self.neighbors, self.listed) = (None, Listed::default());
        (self.frames, self.depth) = (0, 0);
        if let Some(created) = &mut self.created {
            created.clear();
        }
        reserve(&mut self.stack, 0);
        for (slot, arg) in self.stack.iter_mut().zip(args) {
            *slot = *arg;
        }
    }

    /// The common start of calling and of asking an operation: returns its plan, and the call, with
    /// the arguments in its window.
    #[inline]
    pub(super) fn begin_call<'c>(
        &mut self,
        mesh: &Mesh,
        caller: &Call<'c>,
        [op, args]: [u16; 2],
    ) -> Result<(&'c Plan, Call<'c>), Trap> {
        let Some(plan) = caller.plans.get(usize::from(op)).and_then(Option::as_ref) else {
            return Err(Trap::new(Message::Unproved));
        };
        if caller.depth >= DEPTH {
            return Err(Trap::new(Message::TooDeep));
        }
        self.expect_level(mesh, plan).map_err(Trap::new)?;
        let call = caller.calling(op, plan);
        reserve(&mut self.stack, call.base);
        let from = caller.base + usize::from(args);
        let width: u16 = plan.params.iter().fold(0, |sum, &one| sum.saturating_add(one));
        let end = self.stack.len().min(from + usize::from(width));
        self.stack.copy_within(from.min(end)..end, call.base);
        Ok((plan, call))
    }

    /// Calls an operation from running code, and counts the outcome.
    #[inline]
    pub(super) fn call<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        caller: &Call<'_>,
        [op, args]: [u16; 2],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        let (plan, call) = self.begin_call(mesh, caller, [op, args])?;
        let mark = self.begin_op(mesh, plan);
        let outcome = self.carry_out::<OBSERVED>(mesh, plan, call, watch);
        let Ok(outcome) = outcome else {
            self.end_op(mesh, (op, plan), mark, false);
            return outcome;
        };
        self.conclude(mesh, caller, op, mark, outcome, watch)?;
        Ok(outcome)
    }

    /// Ends a call of an operation that has not trapped.
    #[inline]
    pub(super) fn conclude(
        &mut self,
        mesh: &mut Mesh,
        caller: &Call<'_>,
        op: u16,
        mark: Option<Bookmark>,
        outcome: Outcome,
        watch: &mut dyn Watch,
    ) -> Result<(), Trap> {
        let applied = matches!(outcome, Outcome::Applied { .. });
        if let Some(Some(plan)) = caller.plans.get(usize::from(op)) {
            self.end_op(mesh, (op, plan), mark, applied);
        }
        if let Outcome::Refused { reason } = outcome {
            self.last_refusal = Some((op, reason));
        }
        // The effects of a step may still be undone.
        if caller.op.is_none() && caller.steps.is_none() {
            self.count(op, outcome);
            if applied {
                mesh.end_step();
                if watch.applied(op).is_break() {
                    return Err(Trap::new(Message::Interrupted));
                }
            }
        }
        Ok(())
    }

    #[inline]
    pub(super) fn count(&mut self, op: u16, outcome: Outcome) {
        let Some(count) = self.counts.get_mut(usize::from(op)) else { return };
        match outcome {
            Outcome::Applied { .. } => count.applied += 1,
            Outcome::Refused { reason } => {
                let reason = reason.map(usize::from);
                if let Some(times) = reason.and_then(|reason| count.refused.get_mut(reason)) {
                    *times += 1;
                }
            }
        }
    }

    /// The reason of the last refusal, as one of the reasons of this operation.
    pub(super) fn last_reason(&self, op: u16) -> Option<&str> {
        let plan = self.plans.get(usize::from(op))?.as_ref()?;
        let (_, reason) = self.last_refusal?;
        Some(&plan.refusals.get(usize::from(reason?))?.reason)
    }

    /// The name of the operation that refused last in this run, and its reason.
    pub fn last_refusal(&self) -> Option<(&str, &str)> {
        let (op, _) = self.last_refusal?;
        Some((&self.plans.get(usize::from(op))?.as_ref()?.name, self.last_reason(op)?))
    }

    /// The trap of an operation that refused although the script said `must`.
    #[cold]
    pub(super) fn must_not_refuse(&self, op: u16) -> Message {
        let plan = self.plans.get(usize::from(op)).and_then(Option::as_ref);
        let reason = self.last_reason(op).unwrap_or("it gives no reason");
        Message::Refused {
            op: plan.map_or_else(String::new, |plan| plan.name.clone()),
            reason: reason.to_owned(),
        }
    }
}

impl Trap {
    /// A trap with an empty trace: no call has added its place yet.
    pub(crate) fn new(message: Message) -> Self {
        Self { message, trace: Vec::new(), about: None }
    }
}
