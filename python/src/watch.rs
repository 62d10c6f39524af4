//! Looking on while something runs: signals, progress, and what is printed.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use hedgerow::Watch;
use pyo3::prelude::*;

/// The time for which nobody looks at signals and progress.
const BETWEEN: Duration = Duration::from_millis(50);

thread_local! {
    /// The exception of the signal that has stopped the last operation or question.
    static RAISED: Cell<Option<PyErr>> = const { Cell::new(None) };
}

/// The exception that has stopped an operation or a question.
pub fn stopped_by() -> Option<PyErr> {
    RAISED.take()
}

/// Looks at signals while operations and questions run, which may hold the interpreter's lock: other
/// threads get it now and then.
#[derive(Default)]
pub struct Signals {
    next: Option<Instant>,
}

impl Watch for Signals {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.tick()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        let now = Instant::now();
        if self.next.is_some_and(|next| now < next) {
            return ControlFlow::Continue(());
        }
        self.next = Some(now + BETWEEN);
        let looked = Python::attach(|py| {
            py.detach(|| ());
            py.check_signals()
        });
        match looked {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                RAISED.set(Some(error));
                ControlFlow::Break(())
            }
        }
    }
}

/// Looks on for Python. The interpreter's lock is taken only now and then.
pub struct Watcher {
    progress: Option<Py<PyAny>>,
    next: Instant,
    /// The exception that was raised while it looked on, which ends the run.
    raised: Option<PyErr>,
    loops: Vec<(u64, Option<u64>)>,
}

impl Watcher {
    /// Tells a callable, if there is one, how far the outermost loops are.
    pub fn new(progress: Option<Py<PyAny>>) -> Self {
        Self { progress, next: Instant::now() + BETWEEN, raised: None, loops: Vec::new() }
    }

    /// The exception that ended the run, if one did.
    pub fn raised(self) -> Option<PyErr> {
        self.raised
    }

    fn look(&mut self) -> ControlFlow<()> {
        if Instant::now() < self.next {
            return ControlFlow::Continue(());
        }
        let looked = Python::attach(|py| {
            py.check_signals()?;
            if let (Some(progress), Some(&(done, total))) = (&self.progress, self.loops.first()) {
                progress.call1(py, (done, total))?;
            }
            Ok(())
        });
        self.next = Instant::now() + BETWEEN;
        self.end(looked)
    }

    fn end(&mut self, result: PyResult<()>) -> ControlFlow<()> {
        match result {
            Ok(()) => ControlFlow::Continue(()),
            Err(error) => {
                self.raised.get_or_insert(error);
                ControlFlow::Break(())
            }
        }
    }
}

impl Watch for Watcher {
    fn iteration(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        if self.raised.is_some() {
            return ControlFlow::Break(());
        }
        self.loops.truncate(usize::from(depth));
        self.loops.push((done, total));
        self.look()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        match self.raised {
            Some(_) => ControlFlow::Break(()),
            None => self.look(),
        }
    }

    fn print(&mut self, line: &str) {
        let printed =
            Python::attach(|py| py.import("builtins")?.getattr("print")?.call1((line,)).map(drop));
        // It ends at the next iteration.
        let _ = self.end(printed);
    }
}
