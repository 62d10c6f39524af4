//! The memory that native code and the machine share during a run of native code.

use std::any::Any;
use std::ffi::c_void;

use super::translate::{APPLIED, REFUSED};
use crate::mesh::tables::Tables;
use crate::mesh::{ElementKind, Mesh};
use crate::rewrite::dispatch::Place;
use crate::rewrite::paths::Fields;
use crate::rewrite::watch::Progress;
use crate::rewrite::window::{SLOTS, reserve};
use crate::rewrite::{Call, Count, Inst, List, Machine, Outcome, Phase, Trap, Watch};

/// The part that native code reads and writes itself.
#[repr(C)]
pub(super) struct Context {
    pub(super) tables: Tables,
    /// The columns of the attributes of the program, by number.
    pub(super) columns: *const Slice,
    /// The progress of the running loops.
    pub(super) progress: *mut Progress,
    /// The window of the running code: of the code that was entered, or of a function that native
    /// code has called since.
    pub(super) window: *mut u64,
    /// The start of the stack of registers, and the last place in it where a window may begin.
    pub(super) stack: *mut u64,
    pub(super) last: *mut u64,
    /// The buffers of the running code, by number, those of the code that was entered, and the end
    /// of all buffers of the machine.
    pub(super) lists: *mut List,
    pub(super) first_list: *mut List,
    pub(super) last_list: *mut List,
    /// The number of the running function, plus 1; 0 if none runs.
    pub(super) function: u64,
    /// The number of the running operation, plus 1, if it is not the code that was entered; else 0.
    pub(super) op: u64,
    /// The number of further nested calls that native code may make without the machine.
    pub(super) left: u64,
    /// The number of running calls that require that no id is reused.
    pub(super) holding: *mut u32,
    /// The machine's counts of calls of operations, by number.
    pub(super) counts: *mut Count,
    /// The machine's number of the operation that may have lowered the level last.
    pub(super) lowered: *mut u32,
    /// The state of the known level; [`NOT_DIRECTLY`] if native code must not call operations
    /// directly.
    pub(super) level: u64,
    /// The slots that the part of a loop keeps.
    pub(super) kept: *mut List,
    /// The starts of the lists of neighbors, and the neighbors in them; null if there are none.
    pub(super) neighbors: [*const u32; 2],
    /// By kind, the fields whose writes are reported, as bits of [`Fields`].
    pub(super) listens: [u32; 4],
    /// The machine's [`Run`].
    pub(super) run: *mut c_void,
    /// The element that is returned, or [`NOTHING`].
    pub(super) result: u64,
    /// By kind, the first of the elements that have been appended last.
    pub(super) appended: [u32; 4],
    /// By kind, the number of slots behind the last element that are ready for new ones: native
    /// code takes them without a stub. The mesh counts them as elements, so they are given back
    /// before the machine looks at it ([`Context::settle`]).
    pub(super) spare: [u64; 4],
    /// The number of times that slots have been appended since the machine has looked at the mesh.
    pub(super) appends: u32,
    /// The number of slots that a function gives, which are at the start of its window.
    pub(super) given: u32,
    /// The refusal noted so far, as encoded by [`noted`].
    pub(super) noted: u32,
}

/// The address and number of the values of a column. Addresses are integers here, since the machine
/// keeps a list of these for reuse.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(crate) struct Slice {
    pub(super) start: usize,
    pub(super) count: usize,
}

/// The level state where native code must not call operations directly: a watcher follows
/// operations, or an operation is the caller.
pub(super) const NOT_DIRECTLY: u64 = 63;

/// The result of an operation that returns nothing.
pub(super) const NOTHING: u64 = u64::MAX;

/// The most slots of a kind that are appended to be spare.
const MOST_SPARE: usize = 1024;

/// The list of columns that a run needs, kept for reuse.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    columns: Vec<Slice>,
}

/// The part of a run that only the machine accesses.
pub(super) struct Run<'r> {
    pub(super) machine: &'r mut Machine,
    pub(super) mesh: &'r mut Mesh,
    /// The call of the code that was entered.
    pub(super) call: Call<'r>,
    pub(super) watch: &'r mut dyn Watch,
    pub(super) scratch: Scratch,
    /// The attributes that the code uses.
    pub(super) attributes: &'r [u16],
    /// The initial value of [`Context::left`].
    pub(super) left: u64,
    /// Whether native code may call operations directly.
    pub(super) calls_directly: bool,
    /// The machine's `frames` when native code was entered.
    pub(super) frames: usize,
    /// The trap by which native code was left, if any.
    pub(super) trap: Option<Trap>,
    /// The reason of the refusal of an operation in steps by which it was left, if any.
    pub(super) refused: Option<Option<u16>>,
    /// The panic of a function of the machine; it is resumed when native code has been left.
    pub(super) panic: Option<Box<dyn Any + Send>>,
}

impl Context {
    /// The context of a run, which must outlive it. The code may be entered anywhere, so the
    /// buffers keep their contents.
    pub(super) fn new(run: &mut Run<'_>, noted: u32) -> Self {
        let Call { base, function, .. } = run.call;
        let lists = run.machine.neighbors.as_ref();
        let neighbors = lists.map_or([std::ptr::null(); 2], |lists| lists.tables());
        let mut context = Self {
            tables: run.mesh.tables(),
            columns: std::ptr::null(),
            progress: &raw mut run.machine.progress,
            window: std::ptr::null_mut(),
            stack: std::ptr::null_mut(),
            last: std::ptr::null_mut(),
            lists: std::ptr::null_mut(),
            first_list: std::ptr::null_mut(),
            last_list: std::ptr::null_mut(),
            function: function.map_or(0, |number| u64::from(number) + 1),
            op: 0,
            left: run.left,
            holding: &raw mut run.machine.holding,
            counts: run.machine.counts.as_mut_ptr(),
            lowered: &raw mut run.machine.known.lowered,
            level: run.level(),
            kept: &raw mut run.machine.kept,
            neighbors,
            listens: run.listens(),
            run: (&raw mut *run).cast(),
            result: NOTHING,
            appended: [0; 4],
            spare: [0; 4],
            appends: 0,
            given: 0,
            noted,
        };
        context.find_stack(run, base);
        context.find_columns(run, |_| true);
        context.find_lists(run, 0);
        context
    }

    /// The base of the window of the running code.
    pub(super) fn base(&self) -> usize {
        (self.window.addr() - self.stack.addr()) / size_of::<u64>()
    }

    /// The index of the first buffer of the running code among those of the run.
    pub(super) fn first_of_lists(&self) -> usize {
        (self.lists.addr() - self.first_list.addr()) / size_of::<List>()
    }

    /// The index of a buffer of the running code among those of the machine.
    #[inline]
    pub(super) fn list_at(&self, run: &Run<'_>, buffer: u16) -> usize {
        run.call.buffers + self.first_of_lists() + usize::from(buffer)
    }

    /// The call of the running code.
    #[inline]
    pub(super) fn call<'r>(&self, run: &Run<'r>) -> Call<'r> {
        let mut call = run.call;
        if let Some(op) = self.op.checked_sub(1)
            && let Some(Some(plan)) = call.plans.get(op as usize)
        {
            call = Call { buffers: call.buffers, ..call.calling(op as u16, plan) };
        }
        let number = self.function.wrapping_sub(1);
        if let Some(function) = call.functions.get(number as usize) {
            call.become_function(number as u16, function);
        }
        call.base = self.base();
        call.buffers += self.first_of_lists();
        call
    }

    /// Becomes the context of an operation that the running code, which has `buffers` buffers,
    /// calls.
    pub(super) fn begin_op(&mut self, run: &mut Run<'_>, call: &Call<'_>, op: u16, buffers: u16) {
        self.find_stack(run, call.base);
        self.find_lists(run, self.first_of_lists() + usize::from(buffers));
        (self.function, self.op) = (0, u64::from(op) + 1);
        (self.noted, self.result) = (0, NOTHING);
        self.level = NOT_DIRECTLY;
        self.left -= 1;
        // The operation counts its own functions.
        run.frames = 0_usize.wrapping_sub((run.left - self.left) as usize);
    }

    /// Becomes the context of the caller again, whose window has this base.
    pub(super) fn end_op(&mut self, run: &Run<'_>, base: usize, buffers: u16, function: u64) {
        self.window = self.stack.wrapping_add(base);
        self.lists = self.lists.wrapping_sub(usize::from(buffers));
        (self.function, self.op) = (function, 0);
        (self.noted, self.result) = (0, NOTHING);
        self.find_level(run);
        self.left += 1;
    }

    /// The outcome for an answer of native code; `None` if it was left by a trap.
    #[inline]
    pub(super) fn outcome(&self, answer: i64) -> Option<Outcome> {
        match answer {
            APPLIED => {
                let result = (self.result != NOTHING).then_some(self.result as u32);
                Some(Outcome::Applied { result })
            }
            REFUSED => {
                let reason = self.place(0).noted.map(|(_, reason)| reason);
                Some(Outcome::Refused { reason })
            }
            _ => None,
        }
    }

    /// Appends new elements to the tables and stores the first of each kind; false, with nothing
    /// done, if that has to be reported or an erased slot is to be reused.
    pub(super) fn append(&mut self, run: &mut Run<'_>, counts: [usize; 4]) -> bool {
        let is_told = run.machine.created.is_some() || !run.machine.drains.is_empty();
        if is_told || !run.mesh.can_append(counts) {
            return false;
        }
        let Tables { vertex_count, halfedge_count, edge_count, face_count, .. } = self.tables;
        self.appended =
            [vertex_count, halfedge_count, edge_count, face_count].map(|end| end as u32);
        if self.tables.has_room(counts) {
            self.append_spare(run, counts);
            return true;
        }
        self.settle(run);
        for (kind, count) in ElementKind::ALL.into_iter().zip(counts) {
            run.mesh.append(kind, count);
        }
        self.refresh_tables(run);
        true
    }

    /// Takes spare slots for new elements, for which there is room. If there are not enough, adds
    /// some first: the more, the more often this has been necessary.
    fn append_spare(&mut self, run: &mut Run<'_>, counts: [usize; 4]) {
        let times = 1 << self.appends.min(MOST_SPARE.ilog2());
        self.appends += 1;
        for (kind, count) in ElementKind::ALL.into_iter().zip(counts) {
            let spare = &mut self.spare[kind as usize];
            let had = *spare as usize;
            if count > had {
                let wanted = (count * times).min(count.max(MOST_SPARE));
                let added = wanted.min(self.tables.room[kind as usize]) - had;
                run.mesh.append(kind, added);
                *spare += added as u64;
            }
            *spare -= count as u64;
        }
        self.tables.appended(counts);
        self.find_columns(run, |kind| counts[kind as usize] > 0);
    }

    /// Gives spare slots back, so that the mesh has its elements only.
    #[inline]
    pub(super) fn settle(&mut self, run: &mut Run<'_>) {
        self.appends = 0;
        if self.spare != [0; 4] {
            self.give_back(run);
        }
    }

    #[cold]
    fn give_back(&mut self, run: &mut Run<'_>) {
        let spare = std::mem::take(&mut self.spare);
        for (kind, spare) in ElementKind::ALL.into_iter().zip(spare) {
            run.mesh.shorten(kind, spare as usize);
        }
        self.find_columns(run, |kind| spare[kind as usize] > 0);
    }

    /// Updates the addresses of the tables of the mesh.
    #[inline]
    pub(super) fn refresh_tables(&mut self, run: &mut Run<'_>) {
        self.tables = run.mesh.tables();
        self.find_columns(run, |_| true);
    }

    /// Updates everything that may have changed.
    #[inline]
    pub(super) fn refresh(&mut self, run: &mut Run<'_>) {
        self.refresh_tables(run);
        self.find_stack(run, self.base());
        self.find_lists(run, self.first_of_lists());
        self.listens = run.listens();
        self.find_level(run);
    }

    /// Updates the level state. The calls of an operation are left to the machine.
    #[inline]
    fn find_level(&mut self, run: &Run<'_>) {
        self.level = if self.op == 0 { run.level() } else { NOT_DIRECTLY };
    }

    fn find_stack(&mut self, run: &mut Run<'_>, base: usize) {
        let stack = &mut run.machine.stack;
        // A window always has all slots that a register can address.
        reserve(stack, base);
        self.stack = stack.as_mut_ptr();
        self.window = self.stack.wrapping_add(base);
        self.last = self.stack.wrapping_add(stack.len() - SLOTS);
    }

    /// Updates the addresses of the columns of some kinds of elements.
    #[inline]
    pub(super) fn find_columns(
        &mut self,
        run: &mut Run<'_>,
        of_kind: impl Fn(ElementKind) -> bool,
    ) {
        let Run { machine, mesh, scratch: Scratch { columns, .. }, attributes, .. } = run;
        for &attribute in *attributes {
            let at = usize::from(attribute);
            if columns.len() <= at {
                columns.resize(at + 1, Slice::default());
            }
            let column = machine.columns.get(at).copied().flatten();
            if column.is_some_and(|column| !of_kind(column.kind)) {
                continue;
            }
            columns[at] = column.map_or_else(Slice::default, |column| {
                // While other threads read too, no exclusive reference to the column may exist.
                let (start, count) = match machine.is_beside_others {
                    true => mesh.values_to_read(column),
                    false => mesh.values_in_memory(column),
                };
                Slice { start: start.expose_provenance(), count }
            });
        }
        self.columns = columns.as_ptr();
    }

    /// Updates the addresses of the buffers; those of the running code begin at `first` in those of
    /// the run.
    pub(super) fn find_lists(&mut self, run: &mut Run<'_>, first: usize) {
        let Run { machine, call, .. } = run;
        let all = machine.buffers.as_mut_ptr();
        self.first_list = all.wrapping_add(call.buffers);
        self.last_list = all.wrapping_add(machine.buffers.len());
        self.lists = self.first_list.wrapping_add(first);
    }

    /// The place where the machine continues.
    pub(super) fn place(&self, at: usize) -> Place {
        let noted = self.noted.checked_sub(1 << 16).map(|known| {
            let phase = match known >> 16 {
                0 => Phase::Match,
                1 => Phase::Require,
                2 => Phase::Guard,
                _ => Phase::Evaluate,
            };
            (phase, known as u16)
        });
        Place { at, noted, steps: 1 }
    }
}

impl Run<'_> {
    /// The state of the known level, if native code may call operations directly.
    #[inline]
    fn level(&self) -> u64 {
        match self.calls_directly && !self.mesh.is_recorded() {
            true => self.machine.known.state(),
            false => NOT_DIRECTLY,
        }
    }

    /// By kind, the fields whose writes are reported.
    #[inline]
    fn listens(&self) -> [u32; 4] {
        match (self.mesh.keeps_journal(), self.machine.drains.is_empty()) {
            (true, _) => [Fields::ALL.bits(); 4],
            (false, true) => [0; 4],
            (false, false) => self.machine.drains.listens().map(Fields::bits),
        }
    }

    /// Updates the machine's number of running functions.
    #[inline]
    pub(super) fn count_frames(&mut self, context: &Context) {
        let called = (self.left - context.left) as usize;
        self.machine.frames = self.frames.wrapping_add(called);
    }

    /// An instruction of the running code.
    pub(super) fn inst(&self, context: &Context, at: i64) -> Option<Inst> {
        context.call(self).code.insts.get(at as usize).copied()
    }
}

/// Encodes a refusal as a number: those of a later phase are greater than all of earlier ones, and
/// 0 is none.
pub(super) fn noted(noted: Option<(Phase, u16)>) -> u32 {
    noted.map_or(0, |(phase, reason)| (phase as u32 + 1) << 16 | u32::from(reason))
}
