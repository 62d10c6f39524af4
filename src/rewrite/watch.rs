//! Watchers of a script while it runs.

use std::ops::ControlFlow;
use std::time::Duration;

/// The number of turns of loops between two looks.
pub(super) const TURNS_PER_LOOK: u32 = 256;

/// The fewest slots for which to list their elements takes as long as the turns between two looks.
pub(super) const LONG_LIST: usize = 10_000;

/// The number of nested loops that a look shows.
pub(super) const DEPTHS: usize = 8;

/// Looks on while code runs: sees how far its loops are, may interrupt it, gets what it
/// prints.
pub trait Watch {
    /// The loop at `depth`, 0 the outermost, has done so many turns; of so many, if that
    /// is known. Called for all running loops now and then, the outermost first.
    fn turn(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// An aggregate over the whole mesh is at work. Called now and then.
    fn tick(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// True if it wants to know of each operation that is applied; asked at the start of a run.
    fn follows_operations(&self) -> bool {
        false
    }

    /// A script has applied the operation of this number, and goes on; told to who follows them.
    fn applied(&mut self, _op: u16) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// The run is over, and native code has taken so long to compile meanwhile.
    fn compiled(&mut self, _time: Duration) {}

    /// A line, without its end.
    fn print(&mut self, _line: &str) {}
}

/// Nobody looks on.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}

/// The progress of the running loops.
#[derive(Debug, Default)]
#[repr(C)]
pub(super) struct Progress {
    pub(super) turns: u32,
    pub(super) loops: [Loop; DEPTHS],
}

/// How far a loop is: of so many turns, if that is no less than 0.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(super) struct Loop {
    pub(super) done: i64,
    pub(super) total: i64,
}

impl Progress {
    #[inline]
    pub(super) fn turn(
        &mut self,
        watch: &mut dyn Watch,
        depth: u16,
        done: i64,
        total: i64,
    ) -> ControlFlow<()> {
        if let Some(place) = self.loops.get_mut(usize::from(depth)) {
            *place = Loop { done, total };
        }
        self.look_at_turn(watch, depth)
    }

    /// One turn of a loop of which it is known how far it is.
    #[inline]
    pub(super) fn look_at_turn(&mut self, watch: &mut dyn Watch, depth: u16) -> ControlFlow<()> {
        self.turns = self.turns.wrapping_add(1);
        match self.turns.is_multiple_of(TURNS_PER_LOOK) {
            true => self.look(watch, depth),
            false => ControlFlow::Continue(()),
        }
    }

    /// True if the last turn was one to look at.
    #[inline]
    pub(super) fn has_looked(&self) -> bool {
        self.turns.is_multiple_of(TURNS_PER_LOOK)
    }

    #[inline]
    pub(super) fn tick(&mut self, watch: &mut dyn Watch) -> ControlFlow<()> {
        self.turns = self.turns.wrapping_add(1);
        match self.turns.is_multiple_of(TURNS_PER_LOOK) {
            true => watch.tick(),
            false => ControlFlow::Continue(()),
        }
    }

    /// Shows how far a loop is that several threads take: so many turns of so many.
    #[cfg_attr(not(feature = "native"), expect(dead_code))]
    pub(super) fn show(
        &mut self,
        watch: &mut dyn Watch,
        depth: u16,
        [done, total]: [usize; 2],
    ) -> ControlFlow<()> {
        if let Some(place) = self.loops.get_mut(usize::from(depth)) {
            *place = Loop { done: done.min(total) as i64, total: total as i64 };
        }
        self.look(watch, depth)
    }

    #[cold]
    fn look(&mut self, watch: &mut dyn Watch, depth: u16) -> ControlFlow<()> {
        for (depth, &Loop { done, total }) in (0..=depth).zip(&self.loops) {
            watch.turn(depth, done.max(0).unsigned_abs(), u64::try_from(total).ok())?;
        }
        ControlFlow::Continue(())
    }
}
