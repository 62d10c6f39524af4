//! Watchers of a script while it runs.

use std::ops::ControlFlow;
use std::time::Duration;

/// The number of iterations of loops between two calls of the watcher.
pub(super) const ITERATIONS_PER_POLL: u32 = 256;

/// The number of slots from which listing their elements takes about as long as the iterations
/// between two calls of the watcher.
pub(super) const LONG_LIST: usize = 10_000;

/// The number of diagonals from which the watcher is called whenever those of a face are listed.
pub(super) const LONG_FACE: usize = 1_000;

/// The number of nested loops whose progress is reported.
pub(super) const DEPTHS: usize = 8;

/// An observer of running code: it is told the progress of loops, may interrupt the run, and gets
/// the printed lines.
pub trait Watch {
    /// Reports that the loop at `depth`, 0 for the outermost, has done `done` iterations; of
    /// `total`, if that is known. Called for all running loops now and then, the outermost first.
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Reports that code of unknown progress, such as an aggregate over the whole mesh, is running.
    /// Called now and then.
    fn tick(&mut self) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Whether [`applied`](Self::applied) is to be called for each operation; asked at the start of
    /// a run.
    fn follows_operations(&self) -> bool {
        false
    }

    /// Reports that a script has applied the operation with this number, if the watcher [follows
    /// operations](Self::follows_operations).
    fn applied(&mut self, _op: u16) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// Reports, at the end of a run, the time spent on compiling native code.
    fn compiled(&mut self, _time: Duration) {}

    /// Gets a printed line, without its end.
    fn print(&mut self, _line: &str) {}
}

/// A watcher that ignores everything.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}

/// A watcher that interrupts the run once it has been called so many times.
#[derive(Clone, Copy, Debug)]
pub struct StopAfter(pub u32);

impl Watch for StopAfter {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.tick()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The progress of the running loops.
#[derive(Debug, Default)]
#[repr(C)]
pub(super) struct Progress {
    pub(super) iterations: u32,
    pub(super) loops: [Loop; DEPTHS],
}

/// The progress of a loop; `total` is negative if it is not known.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(super) struct Loop {
    pub(super) done: i64,
    pub(super) total: i64,
}

impl Progress {
    #[inline]
    pub(super) fn iteration(
        &mut self,
        watch: &mut dyn Watch,
        depth: u16,
        done: i64,
        total: i64,
    ) -> ControlFlow<()> {
        if let Some(place) = self.loops.get_mut(usize::from(depth)) {
            *place = Loop { done, total };
        }
        self.poll_at_iteration(watch, depth)
    }

    /// Counts an iteration of a loop whose progress is already stored.
    #[inline]
    pub(super) fn poll_at_iteration(
        &mut self,
        watch: &mut dyn Watch,
        depth: u16,
    ) -> ControlFlow<()> {
        self.iterations = self.iterations.wrapping_add(1);
        match self.iterations.is_multiple_of(ITERATIONS_PER_POLL) {
            true => self.poll(watch, depth),
            false => ControlFlow::Continue(()),
        }
    }

    /// Whether the watcher was called at the last iteration.
    #[inline]
    pub(super) fn has_polled(&self) -> bool {
        self.iterations.is_multiple_of(ITERATIONS_PER_POLL)
    }

    #[inline]
    pub(super) fn tick(&mut self, watch: &mut dyn Watch) -> ControlFlow<()> {
        self.iterations = self.iterations.wrapping_add(1);
        match self.iterations.is_multiple_of(ITERATIONS_PER_POLL) {
            true => watch.tick(),
            false => ControlFlow::Continue(()),
        }
    }

    /// Reports the progress of a loop that several threads run.
    pub(super) fn show(
        &mut self,
        watch: &mut dyn Watch,
        depth: u16,
        [done, total]: [usize; 2],
    ) -> ControlFlow<()> {
        if let Some(place) = self.loops.get_mut(usize::from(depth)) {
            *place = Loop { done: done.min(total) as i64, total: total as i64 };
        }
        self.poll(watch, depth)
    }

    #[cold]
    fn poll(&mut self, watch: &mut dyn Watch, depth: u16) -> ControlFlow<()> {
        for (depth, &Loop { done, total }) in (0..=depth).zip(&self.loops) {
            watch.iteration(depth, done.max(0).unsigned_abs(), u64::try_from(total).ok())?;
        }
        ControlFlow::Continue(())
    }
}
