//! Running loops in parts, on several threads if there are some.
//!
//! Each thread has a machine of its own, and takes ranges of slots until none is left. The caller
//! waits, reports the progress to the watcher, and stops the threads if the watcher interrupts.
//! The slots that they keep are put together when all are done. A single thread also runs an
//! `update` in parts, since it may read lists of neighbors then, and native code keeps its writes
//! without calling a stub.

#![allow(unsafe_code)]

use std::mem::ManuallyDrop;
use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use super::engine::CodeKind;
use super::memory::Budget;
use super::watch::ITERATIONS_PER_POLL;
use super::{Call, Machine, Message, Part, Task, Trap, Watch, attribute, neighbors};
use crate::mesh::{Adjacency, Mesh, parallel};

/// The least number of slots for which parts are worth it; small in debug builds, so that tests
/// reach it.
fn least(task: Task) -> usize {
    match task {
        _ if cfg!(debug_assertions) => 64,
        Task::Update | Task::Filter => 10_000,
        Task::Aggregate | Task::Keys => 40_000,
    }
}

/// The greatest number of slots of a first range that shows how many elements a loop visits.
const SAMPLE: usize = 4096;

/// The time between two calls of the watcher.
const LOOK: Duration = Duration::from_millis(20);

/// The outcome of a range: its number, what it keeps, and the trap that ended it, if any.
type Done = (usize, Vec<u64>, Option<Trap>);

impl Machine {
    /// Runs a loop in parts. `None` if the loop itself is to be run: it is short, calls functions
    /// that do more than read, or threads or memory are lacking, or a value or key has trapped.
    pub(super) fn spread(
        &mut self,
        mesh: &mut Mesh,
        call: &Call<'_>,
        (part, frames): (u16, usize),
        watch: &mut dyn Watch,
    ) -> Option<Result<(), Trap>> {
        let part = call.code.parts.get(usize::from(part))?.as_ref()?;
        let slots = mesh.capacity(part.of.kind());
        if !self.may_spread(mesh, part, call) || parallel::is_at_work() {
            return None;
        }
        let threads = parallel::threads();
        if threads == 1 && part.task != Task::Update {
            return None;
        }
        let codes = part.code.with_called_of(call.functions);
        let reads_neighbors = codes.iter().any(|code| neighbors::are_read_by(code));
        // In debug builds, so that tests use lists, loops that read more count as well.
        let reads_no_more = cfg!(debug_assertions)
            || codes.iter().all(|code| neighbors::are_all_that_is_read_by(code));
        let mut neighbors = reads_neighbors.then(|| self.neighbors_of(mesh, false)).flatten();
        let mut ranges = parallel::cut(slots, (4 * threads).min(slots / (least(part.task) / 8)));
        let is_sampled = reads_neighbors && reads_no_more && self.listed.may_be_made();
        if is_sampled {
            let Range { start, end } = ranges[0];
            let middle = start + SAMPLE.min(ranges[0].len() / 4);
            ranges.splice(..1, [start..middle, middle..end]);
        }
        let next = AtomicUsize::new(0);
        // The first range that has trapped: no range after it is started.
        let trapped = AtomicUsize::new(ranges.len());
        let (stop, iterations) = (AtomicBool::new(false), AtomicUsize::new(0));
        let done: Mutex<Vec<Done>> = Mutex::default();
        let mut workers = self.workers_of(mesh, call, (threads, frames));
        let shared: &Mesh = mesh;
        // A part has no function number.
        let inner = Call {
            code: &part.code,
            function: None,
            kind: CodeKind::Function,
            base: 0,
            buffers: 0,
            depth: 0,
            ..*call
        };
        // Takes the next range; returns how many elements it visited, if there was one.
        let take = |machine: &mut Machine, mesh: &mut Mesh, watch: &mut dyn Watch| {
            let range = next.fetch_add(1, Relaxed);
            if range >= ranges.len() || range > trapped.load(Relaxed) {
                return None;
            }
            let (held, trap) = machine.take_range(mesh, (part, inner), &ranges[range], watch);
            if trap.is_some() {
                trapped.fetch_min(range, Relaxed);
            }
            let visits = held.len() / part.keeps().max(1);
            done.lock().unwrap_or_else(PoisonError::into_inner).push((range, held, trap));
            Some(visits)
        };
        // SAFETY: only the code of a part, and of functions that only read, runs on it.
        let head = || unsafe { head(shared) };
        let take_all = |machine: &mut Machine, watch: &mut dyn Watch| {
            let mut mesh = head();
            while take(machine, &mut mesh, watch).is_some() {}
        };
        let worker_watch = || WorkerWatch { stop: &stop, iterations: &iterations };
        if is_sampled {
            let visits = take(&mut workers[0], &mut head(), &mut worker_watch());
            if visits.is_some_and(|visits| 2 * visits >= ranges[0].len()) {
                neighbors = self.neighbors_of(shared, true);
            }
        }
        workers.iter_mut().for_each(|machine| machine.neighbors = neighbors.clone());
        let progress = &mut self.progress;
        let mut look = |watch: &mut dyn Watch| match part.task {
            Task::Update => progress.show(watch, part.depth, [iterations.load(Relaxed), slots]),
            Task::Aggregate | Task::Filter | Task::Keys => watch.tick(),
        };
        if let [machine] = workers.as_mut_slice() {
            take_all(
                machine,
                &mut Alone { worker_watch: worker_watch(), look: &mut || look(watch) },
            );
        } else {
            let take_all = |machine: &mut Machine| take_all(machine, &mut worker_watch());
            // A watcher that has interrupted is not called again.
            let meanwhile = || {
                if !stop.load(Relaxed) && look(watch).is_break() {
                    stop.store(true, Relaxed);
                }
            };
            parallel::each_at_work(&mut workers, take_all, LOOK, meanwhile);
        }
        for machine in &mut workers {
            machine.neighbors = None;
            self.compiling += std::mem::take(&mut machine.compiling);
        }
        self.workers = workers;
        let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
        done.sort_unstable_by_key(|(range, ..)| *range);
        // Traps of values and keys do not count: the loop on one thread traps again.
        let counts =
            |trap: &Trap| part.task == Task::Update || matches!(trap.message, Message::Interrupted);
        if let Some(at) = done.iter().position(|(.., trap)| trap.as_ref().is_some_and(counts)) {
            let mut trap = done.swap_remove(at).2?;
            if let Some(site) = trap.trace.last_mut() {
                site.function = call.function;
            }
            return Some(Err(trap));
        }
        if stop.load(Relaxed) || part.task != Task::Update && watch.tick().is_break() {
            // All threads were done before they could be stopped.
            return Some(Err(Trap::new(Message::Interrupted).through(call, usize::MAX)));
        }
        if done.iter().any(|(.., trap)| trap.is_some()) {
            return None;
        }
        let kept = done.into_iter().map(|(range, held, _)| (ranges[range].clone(), held));
        self.merge(mesh, (part, call), kept.collect())
    }

    /// Whether running a loop in parts is worth it and possible: its iterations only read, and
    /// there is memory for what they keep.
    fn may_spread(&self, mesh: &Mesh, part: &Part, call: &Call<'_>) -> bool {
        let slots = mesh.capacity(part.of.kind());
        let is_noted = match part.task {
            Task::Keys => !self.drains.takes_keys(),
            Task::Update | Task::Aggregate | Task::Filter => !self.drains.is_empty(),
        };
        let is_alone = self.is_dry || is_noted || call.op.is_some() || call.steps.is_some();
        slots >= least(part.task)
            && !is_alone
            && part.is_costly()
            && self.has_room_for(mesh, part, slots)
            && part.reads_only(call.functions)
    }

    /// Combines what the ranges keep, in their order; the result is that of a single thread.
    fn merge(
        &mut self,
        mesh: &mut Mesh,
        (part, call): (&Part, &Call<'_>),
        kept: Vec<(Range<usize>, Vec<u64>)>,
    ) -> Option<Result<(), Trap>> {
        let columns = &self.columns;
        let all =
            |kept: Vec<(_, _)>| parallel::joined(kept.into_iter().map(|(_, list)| list).collect());
        match part.task {
            Task::Update => {
                let written = match part.own_writes() {
                    Some(writes) if !mesh.keeps_journal() => {
                        attribute::release_ranges(mesh, columns, &writes, &kept)
                    }
                    _ => kept
                        .into_iter()
                        .try_for_each(|(_, mut held)| attribute::release(mesh, columns, &mut held)),
                };
                Some(written.map_err(|_| Trap::new(Message::Malformed)))
            }
            Task::Aggregate | Task::Filter => {
                let list = self.buffers.get_mut(call.buffers + usize::from(part.held))?;
                *list = all(kept).into();
                Some(Ok(()))
            }
            // A key that is not a number, or too little memory, traps on one thread.
            Task::Keys => {
                self.drains.set_keys(&all(kept)).ok()?;
                if self.budget().is_passed(mesh) {
                    return None;
                }
                self.drains.make_none_stale();
                Some(Ok(()))
            }
        }
    }

    /// The lists of neighbors, if a loop that reads them is worth it, or made `at_once`.
    fn neighbors_of(&mut self, mesh: &Mesh, at_once: bool) -> Option<Arc<Adjacency>> {
        let taken = mesh.bytes().saturating_add(self.budget().taken());
        let room = self.memory.saturating_sub(taken);
        self.listed.wanted(mesh, &self.counts, room, at_once)
    }

    fn budget(&self) -> Budget<'_> {
        Budget { buffers: &self.buffers, drains: &self.drains, limit: self.memory }
    }

    /// Whether what the iterations may keep is within the memory limit.
    fn has_room_for(&self, mesh: &Mesh, part: &Part, slots: usize) -> bool {
        let wanted = slots.saturating_mul(part.keeps() * size_of::<u64>() * 2);
        mesh.bytes().saturating_add(self.budget().taken()).saturating_add(wanted) <= self.memory
    }

    /// Machines for `threads` threads, with the current values of the registers.
    fn workers_of(
        &mut self,
        mesh: &Mesh,
        call: &Call<'_>,
        (threads, frames): (usize, usize),
    ) -> Vec<Machine> {
        let mut workers = std::mem::take(&mut self.workers);
        workers.resize_with(threads, || Machine::new(&self.plans));
        let registers = usize::from(call.code.registers);
        let window = self.stack.get(call.base..call.base + registers).unwrap_or_default();
        for machine in &mut workers {
            machine.plans = self.plans.clone();
            machine.columns.clone_from(&self.columns);
            machine.is_beside_others = true;
            (machine.engine, machine.memory) = (self.engine, self.memory);
            machine.start(mesh, window);
            machine.frames = frames;
        }
        workers
    }

    /// Runs the iterations of a range.
    fn take_range(
        &mut self,
        mesh: &mut Mesh,
        (part, call): (&Part, Call<'_>),
        range: &Range<usize>,
        watch: &mut dyn Watch,
    ) -> (Vec<u64>, Option<Trap>) {
        let frames = self.frames;
        for (reg, bound) in part.bounds.into_iter().zip([range.start, range.end]) {
            self.stack[usize::from(reg.0)] = bound as u64;
        }
        self.kept.clear();
        // If this fails, the iteration traps that cannot keep its value.
        let _ = self.kept.grow().try_reserve_exact(part.keeps() * range.len());
        let outcome = match self.run_native(mesh, call, watch) {
            Some(outcome) => outcome,
            None => self.execute::<false>(mesh, call, watch),
        };
        self.frames = frames;
        let mut kept: Vec<u64> = std::mem::take(&mut self.kept).into();
        // The machine keeps writes in the buffer. Native code may take over from it, but not the
        // reverse: the writes in the buffer come first.
        if part.task == Task::Update
            && let Some(held) = self.buffers.get_mut(usize::from(part.held))
            && !held.is_empty()
        {
            held.grow().append(&mut kept);
            kept = std::mem::take(held).into();
        }
        (kept, outcome.err())
    }
}

/// A copy of the head of a mesh, for code that needs a `&mut Mesh` but only reads.
///
/// # Safety
/// The copy must not be used to write to a table of the mesh, nor to allocate or free memory of it.
/// It must not be dropped.
unsafe fn head(mesh: &Mesh) -> ManuallyDrop<Mesh> {
    // SAFETY: the bits are those of a mesh. It stays borrowed, so its tables are neither moved nor
    // written while they are read through the copy. Since the copy is not dropped, nothing is freed
    // twice.
    ManuallyDrop::new(unsafe { std::ptr::read(mesh) })
}

/// The watcher of the only thread, which also calls the caller's watcher.
struct Alone<'s> {
    worker_watch: WorkerWatch<'s>,
    look: &'s mut dyn FnMut() -> ControlFlow<()>,
}

impl Watch for Alone<'_> {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        (self.look)()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.worker_watch.tick()?;
        (self.look)()
    }
}

/// The watcher of one of the threads, which counts iterations for the waiting caller.
struct WorkerWatch<'s> {
    stop: &'s AtomicBool,
    iterations: &'s AtomicUsize,
}

impl WorkerWatch<'_> {
    fn answer(&self) -> ControlFlow<()> {
        if self.stop.load(Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Watch for WorkerWatch<'_> {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.answer()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.iterations.fetch_add(ITERATIONS_PER_POLL as usize, Relaxed);
        self.answer()
    }
}
