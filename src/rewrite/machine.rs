//! The machine: a stack of registers, buffers, and what it counts.
//!
//! It runs any code on any mesh and does not panic: every number that should name an
//! element is tested where it is used. What it cannot promise is that a trap leaves the
//! mesh alone: in an operation all that can trap or refuse comes before the first write,
//! which is the duty of whoever makes the code; a script that traps has done what it did
//! so far.

use std::time::Duration;

use super::attempt::Said;
use super::drain::Drains;
use super::key_paths::KeyPaths;
use super::known_level::KnownLevel;
use super::native::{Neighbors, Scratch};
use super::preview::Preview;
use super::random::RandomNumbers;
use super::watch::Progress;
use super::window::reserve;
use super::{
    Call, Code, Engine, Holder, Matched, Message, Outcome, Plan, Plans, Reg, Trap, Unwatched, Watch,
};
use crate::mesh::{AttributeType, Bookmark, ColumnId, ElementKind, Level, Mesh};

/// The greatest depth of nested calls.
const DEPTH: usize = 16;

/// Runs code on meshes.
#[derive(Debug)]
pub struct Machine {
    pub(super) plans: Plans,
    /// The columns of the attributes of the program in the mesh, by number.
    pub(super) columns: Vec<Option<ColumnId>>,
    pub(super) stack: Vec<u64>,
    pub(super) buffers: Vec<Vec<u64>>,
    /// What the part of a loop has kept; there is room for all values that it will keep, and for the
    /// writes of most.
    pub(super) kept: Vec<u64>,
    /// The preview that guards look at.
    pub(super) preview: Preview,
    pub(super) drains: Drains,
    /// The paths of their keys.
    pub(super) paths: KeyPaths,
    pub(super) progress: Progress,
    /// The line that is being printed.
    pub(super) line: String,
    pub(super) counts: Vec<Count>,
    /// The level that the mesh is known to have.
    pub(super) known: KnownLevel,
    /// The reason why the op called last refused.
    pub(super) last_reason: Option<u16>,
    /// True if the operation that runs is only asked: it ends at its first write.
    pub(super) is_dry: bool,
    /// The instruction at which the operation ended that was asked last.
    pub(super) stopped_at: usize,
    /// The source of `random`.
    pub(super) random: RandomNumbers,
    /// The texts that code has made.
    pub(super) said: Said,
    /// The number of running calls that need that no id is given out again.
    pub(super) holding: u32,
    /// Meshes to compare with, by number.
    pub(super) meshes: Vec<Mesh>,
    /// The elements that were created, if anybody wants to know.
    pub(super) created: Option<Vec<(ElementKind, u32)>>,
    /// The greatest number of bytes of mesh and lists.
    pub(super) memory: usize,
    pub(super) engine: Engine,
    /// The number of functions that native code has called and that are not done, in the operation
    /// or script that runs.
    pub(super) frames: usize,
    /// The depth of native code that runs.
    pub(super) depth: usize,
    /// What the function gave that was done last: its window, the first register, the width.
    pub(super) given: (usize, Reg, u16),
    /// The kinds and types of the attributes on the mesh of this run, by number, for native code.
    #[cfg_attr(not(feature = "native"), expect(dead_code, reason = "for native code"))]
    pub(super) types: Vec<Option<(ElementKind, AttributeType)>>,
    /// Lists for runs of native code, kept to be used again.
    #[cfg_attr(not(feature = "native"), expect(dead_code, reason = "for native code"))]
    pub(super) scratch: Vec<Scratch>,
    /// The time that native code has taken to compile.
    pub(super) compiling: Duration,
    /// True if other threads read the mesh meanwhile, and nobody writes to it.
    pub(super) is_beside_others: bool,
    /// The lists of neighbors for loops over all vertices, while no operation is applied.
    pub(super) neighbors: Neighbors,
    /// The machines of other threads, kept to be used again.
    #[cfg_attr(not(feature = "native"), expect(dead_code))]
    pub(super) crew: Vec<Machine>,
}

/// A name, the kind of the elements that it stands for, and their ids.
pub type NamedElements<'p> = (&'p str, ElementKind, Vec<u32>);

/// The counts of the calls of an operation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// The number that were applied.
    pub applied: u64,
    /// The number that were refused, by the number of the reason.
    pub refused: Vec<u64>,
}

impl Default for Machine {
    /// A machine for code that calls no operation.
    fn default() -> Self {
        Self::new(&Plans::default())
    }
}

impl Machine {
    /// A machine for code that calls these operations. `None` stands for one that has
    /// not been proved; calling it traps.
    pub fn new(plans: &Plans) -> Self {
        let refusals = |plan: &Option<Plan>| plan.as_ref().map_or(0, |plan| plan.refusals.len());
        let count = |plan| Count { applied: 0, refused: vec![0; refusals(plan)] };
        Self {
            plans: Plans::clone(plans),
            columns: Vec::new(),
            stack: Vec::new(),
            buffers: Vec::new(),
            kept: Vec::new(),
            preview: Preview::default(),
            drains: Drains::default(),
            paths: KeyPaths::default(),
            progress: Progress::default(),
            line: String::new(),
            counts: plans.iter().map(count).collect(),
            known: KnownLevel::new(Level::Map),
            last_reason: None,
            is_dry: false,
            stopped_at: 0,
            random: RandomNumbers::new(0),
            said: Said::default(),
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
            neighbors: Neighbors::default(),
            crew: Vec::new(),
        }
    }

    /// Says where the mesh of the next run has the attributes of the program, by number.
    /// Code that uses another attribute traps.
    pub fn use_columns(&mut self, columns: Vec<Option<ColumnId>>) {
        self.columns = columns;
    }

    /// Says what runs code from now on.
    pub fn use_engine(&mut self, engine: Engine) {
        self.engine = engine;
    }

    /// Says that the mesh of the next run has a level. Where an operation for meshes of a higher
    /// one is called, or another has been applied that may have left a lower one, the mesh is
    /// asked; the call traps if it has not got the level.
    pub fn trust_level(&mut self, level: Level) {
        self.known = KnownLevel::new(level);
    }

    /// Says that the mesh of the next run has a level before anything is written to it.
    pub(crate) fn begin_at_level(&mut self, level: Level) {
        self.known = KnownLevel::at_start(level);
    }

    /// Sets the seed of the random numbers of the next runs; without it, it is 0.
    pub fn seed(&mut self, seed: u64) {
        self.random = RandomNumbers::new(seed);
    }

    /// Gives the meshes that the next run compares with, by number; it may replace them.
    pub fn use_meshes(&mut self, meshes: Vec<Mesh>) {
        self.meshes = meshes;
    }

    /// From now on remembers what each run creates.
    pub fn remember_created(&mut self) {
        self.created.get_or_insert_default();
    }

    /// From now on remembers that no more.
    pub fn forget_created(&mut self) {
        self.created = None;
    }

    /// The elements that the last run created, in that order, if that is remembered. Some of it may
    /// have been erased since.
    pub fn created(&self) -> &[(ElementKind, u32)] {
        self.created.as_deref().unwrap_or_default()
    }

    /// The time that it has taken to compile native code so far.
    pub fn compiling(&self) -> Duration {
        self.compiling
    }

    /// The window of the last run: what its registers hold; of a script with loops, nothing to rely
    /// on.
    pub fn window(&self) -> &[u64] {
        &self.stack
    }

    /// The alternative of an operation that matched where it was [asked](Self::ask) last and would
    /// be applied, and the elements that its names stand for; nothing of an operation in steps.
    pub fn matched<'p>(&self, plan: &'p Plan) -> Option<(usize, Vec<NamedElements<'p>>)> {
        let stopped = |matched: &Matched| matched.from as usize <= self.stopped_at;
        let rule = plan.matched.iter().rposition(stopped)?;
        let ids = |slots: &[u64]| slots.iter().map(|&slot| slot as u32).collect();
        let names = plan.matched[rule].names.iter().map(|(name, kind, holder)| {
            let slots = match *holder {
                Holder::Reg(reg) => self.stack.get(usize::from(reg.0)).map(std::slice::from_ref),
                Holder::Buffer(buffer) => self.buffers.get(usize::from(buffer)).map(Vec::as_slice),
            };
            (name.as_str(), *kind, slots.map_or_else(Vec::new, ids))
        });
        Some((rule, names.collect()))
    }

    /// The text of a number in that window; the code is that of the run.
    pub fn text<'t>(&'t self, code: &'t Code, number: u64) -> Option<&'t str> {
        self.said.text(&code.texts, u32::try_from(number).ok()?)
    }

    /// The level that the mesh of the last run surely has now.
    pub fn level(&self) -> Level {
        self.known.now()
    }

    /// Counts anew from here on.
    pub fn clear_counts(&mut self) {
        for count in &mut self.counts {
            count.applied = 0;
            count.refused.fill(0);
        }
    }

    /// For each operation what became of the calls so far.
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

    /// The same for code of which it is known that no drain runs in it, as [`Code::drains`] tells.
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

    /// Applies an operation with the arguments in slots. It is not counted.
    pub fn apply(&mut self, mesh: &mut Mesh, plan: &Plan, args: &[u64]) -> Result<Outcome, Trap> {
        self.apply_watched(mesh, plan, args, &mut Unwatched)
    }

    /// The same, while somebody looks on.
    pub fn apply_watched(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start(mesh, args);
        let plans = Plans::clone(&self.plans);
        self.carry_out::<false>(mesh, plan, Call::of(plan, &plans), watch)
    }

    /// Asks if an operation would be applied with the arguments in slots, and if not, why. The mesh
    /// is as it was, nothing is printed or counted, and there is no result.
    pub fn ask(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        args: &[u64],
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start(mesh, args);
        let plans = Plans::clone(&self.plans);
        // Native code would not leave what has matched in the window.
        let engine = std::mem::replace(&mut self.engine, Engine::Machine);
        let outcome = self.consider(mesh, plan, Call::of(plan, &plans), watch);
        self.engine = engine;
        outcome
    }

    pub(super) fn start(&mut self, mesh: &Mesh, args: &[u64]) {
        self.find_types(mesh);
        self.line.clear();
        self.drains.clear();
        self.paths.clear();
        self.last_reason = None;
        self.is_dry = false;
        self.holding = 0;
        self.neighbors = Neighbors::default();
        (self.frames, self.depth) = (0, 0);
        if let Some(created) = &mut self.created {
            created.clear();
        }
        reserve(&mut self.stack, 0);
        for (slot, arg) in self.stack.iter_mut().zip(args) {
            *slot = *arg;
        }
    }

    /// The beginning that is the same for an operation that is called and for one that is asked:
    /// its plan, and the call with the arguments at their place.
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

    /// Calls an operation from running code, and counts what becomes of it.
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
            self.last_reason = reason;
        }
        // What a step does may yet be undone.
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
        let Some(count) = self.counts.get_mut(usize::from(op)) else {
            return;
        };
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

    /// The reason why an operation refused, if it was the last to do so.
    pub(super) fn last_reason(&self, op: u16) -> Option<&str> {
        let plan = self.plans.get(usize::from(op))?.as_ref()?;
        let refusal = plan.refusals.get(usize::from(self.last_reason?))?;
        Some(&refusal.reason)
    }

    /// The trap of an operation that refused and must not.
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
    /// A trap that no call has put its place to yet.
    pub(super) fn new(message: Message) -> Self {
        Self { message, trace: Vec::new() }
    }
}
