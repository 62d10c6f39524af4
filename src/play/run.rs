//! Running scripts, whole or up to some application.

use std::ops::ControlFlow;

use crate::rewrite::Watch;
use crate::run::{Argument, Report};
use crate::session::{Error, Script, Session};

use super::workbench::Host;

/// The outcome of a run.
#[derive(Debug)]
pub(super) struct Ran {
    pub report: Option<Report>,
    pub printed: Vec<String>,
    /// The number of operations that were applied.
    pub applied: u64,
    /// The error, if it is not that the run was to stop there.
    pub error: Option<Error>,
}

/// Runs a script, up to so many applications.
pub(super) fn run(
    session: &mut Session,
    script: &Script,
    arguments: Vec<(String, Argument)>,
    most: u64,
    host: &mut dyn Host,
) -> Ran {
    let mut looker = Looker { host, printed: Vec::new(), applied: 0, most };
    if most == 0 {
        return Ran { report: None, printed: Vec::new(), applied: 0, error: None };
    }
    let outcome = session.run_watched(script, arguments, &mut looker);
    let Looker { printed, applied, .. } = looker;
    match outcome {
        Ok(report) => Ran { report: Some(report), printed, applied, error: None },
        Err(error) => {
            let is_stop = applied == most && error.code() == "interrupted";
            let report = error.report().cloned();
            Ran { report, printed, applied, error: (!is_stop).then_some(error) }
        }
    }
}

/// The most lines of what is printed that are kept.
const MOST_LINES: usize = 2000;

struct Looker<'h> {
    host: &'h mut dyn Host,
    printed: Vec<String>,
    applied: u64,
    most: u64,
}

impl Watch for Looker<'_> {
    fn turn(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        match depth {
            0 => self.host.progress(done, total),
            _ => ControlFlow::Continue(()),
        }
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.host.progress(0, None)
    }

    fn applied(&mut self, _op: u16) -> ControlFlow<()> {
        self.applied += 1;
        match self.applied < self.most {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        }
    }

    fn print(&mut self, line: &str) {
        if self.printed.len() < MOST_LINES {
            self.printed.push(line.to_owned());
        }
    }
}
