//! Running scripts, and stepping through their runs.

use std::ops::ControlFlow;

use serde_json::{Value, json};

use crate::mesh::{History, Mesh};
use crate::rewrite::Watch;
use crate::run::{Argument, Report};
use crate::session::{Error, Script, Session};

use super::ask::Given;
use super::workbench::{Answer, Host, Workbench};

/// The most bytes that a history takes.
pub(super) const MOST_HISTORY: usize = 384 << 20;

/// The outcome of a run.
#[derive(Debug)]
pub(super) struct RunResult {
    pub report: Option<Report>,
    pub printed: Vec<String>,
    /// The number of operations that were applied.
    pub applied: u64,
    /// The error, unless it is that the run stopped where it should.
    pub error: Option<Error>,
    /// The states of the mesh, one application apart.
    pub history: History,
}

/// The limits of a run: the application at which it stops, and the size of its history.
#[derive(Clone, Copy, Debug)]
pub(super) struct RunLimits {
    pub to: u64,
    /// The most bytes of the history.
    pub most: usize,
}

/// Runs a script up to the limits.
pub(super) fn run(
    session: &mut Session,
    script: &Script,
    arguments: Vec<(String, Argument)>,
    limits: RunLimits,
    host: &mut dyn Host,
) -> RunResult {
    let mut recording = RecordingHost { host, printed: Vec::new(), applied: 0, most: limits.to };
    let (outcome, history) = session.run_recorded(script, arguments, limits.most, &mut recording);
    let RecordingHost { printed, applied, .. } = recording;
    match outcome {
        Ok(report) => RunResult { report: Some(report), printed, applied, error: None, history },
        Err(error) => {
            let is_stop = applied == limits.to && error.code() == "interrupted";
            let report = error.report().cloned();
            RunResult { report, printed, applied, error: (!is_stop).then_some(error), history }
        }
    }
}

/// The script that was run last, and the states that the mesh went through.
#[derive(Debug)]
pub(super) struct LastRun {
    script: Script,
    arguments: Vec<(String, Argument)>,
    total: u64,
    history: History,
}

impl Workbench {
    /// Runs a script.
    pub(super) fn run(&mut self, name: &str, given: &Given, host: &mut dyn Host) -> Answer {
        let script = self.program.script(name).map_err(|error| error.message().to_owned())?;
        let arguments = Self::arguments(&script.parameters(), given, None)?;
        let before = self.session.mesh().clone();
        // A new session, so that random numbers are the same in each run.
        self.set(before.clone());
        self.past.keep(before);
        let limits = RunLimits { to: u64::MAX, most: self.most_history };
        let ran = run(&mut self.session, &script, arguments.clone(), limits, host);
        let answer = told(&ran);
        let RunResult { applied: total, history, .. } = ran;
        self.last_run = Some(LastRun { script, arguments, total, history });
        Ok(self.state(answer))
    }

    /// Sets the mesh to its state after `to` applications of the script that was run last.
    pub(super) fn seek(&mut self, to: u64, host: &mut dyn Host) -> Answer {
        let Some(mut last) = self.last_run.take() else {
            return Err("no script has been run".to_owned());
        };
        let to = to.min(last.total);
        let found = self.state_of(&mut last, to, host);
        let json = json!({ "at": to, "total": last.total });
        self.last_run = Some(last);
        self.set(found?);
        Ok(self.state(json))
    }

    /// The mesh after `to` applications of a run. If it is not in the history, the script is run
    /// again, with a history of the states around it.
    fn state_of(&self, last: &mut LastRun, to: u64, host: &mut dyn Host) -> Result<Mesh, String> {
        let [start, end] = last.history.span();
        let half = ((end - start) / 2).max(1);
        let until = |to| if to < last.total { to } else { u64::MAX };
        let around = RunLimits { to: until(to.saturating_add(half)), most: self.most_history };
        // A state that does not fit together with others is computed alone.
        let alone = RunLimits { to: until(to), most: 0 };
        for limits in [None, Some(around), Some(alone)] {
            if let Some(limits) = limits {
                let before = self.past.last().ok_or("the mesh before the run is not kept")?;
                if to == 0 {
                    return Ok(before.clone());
                }
                let mut session = self.session_of(before.clone());
                let arguments = last.arguments.clone();
                let ran = run(&mut session, &last.script, arguments, limits, host);
                if let Some(error) = ran.error.filter(|_| ran.applied < to) {
                    return Err(error.to_string());
                }
                last.history = ran.history;
            }
            if let Some(mesh) = last.history.go(to) {
                let mut mesh = mesh.clone();
                last.script.clear_scratch(&mut mesh);
                return Ok(mesh);
            }
        }
        Err("the script does not come to that application any more".to_owned())
    }
}

/// The outcome of a run, as data.
fn told(ran: &RunResult) -> Value {
    let ops = |report: &Report| {
        let ops = report
            .ops
            .iter()
            .map(|op| json!({ "op": op.name, "applied": op.applied, "refused": op.refused }));
        ops.collect::<Vec<_>>()
    };
    json!({
        "at": ran.applied,
        "total": ran.applied,
        "printed": ran.printed,
        "ops": ran.report.as_ref().map(ops),
        "failed": ran.error.as_ref().map(|error| error.to_string()),
    })
}

/// The most printed lines that are kept.
const MOST_LINES: usize = 2000;

struct RecordingHost<'h> {
    host: &'h mut dyn Host,
    printed: Vec<String>,
    applied: u64,
    most: u64,
}

impl Watch for RecordingHost<'_> {
    fn iteration(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        if depth == 0 { self.host.progress(done, total) } else { ControlFlow::Continue(()) }
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.host.progress(0, None)
    }

    fn follows_operations(&self) -> bool {
        true
    }

    fn applied(&mut self, _op: u16) -> ControlFlow<()> {
        self.applied += 1;
        if self.applied < self.most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    fn print(&mut self, line: &str) {
        if self.printed.len() < MOST_LINES {
            self.printed.push(line.to_owned());
        }
    }
}
