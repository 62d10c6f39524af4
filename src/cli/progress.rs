//! A progress bar while a script runs, on a terminal.

use std::io::{IsTerminal, stderr};
use std::ops::ControlFlow;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt;
use super::output::{eprint_line, print_line};
use crate::rewrite::Watch;

/// The number of times the bar is drawn, per second.
const DRAWS_PER_SECOND: u8 = 10;

/// Shows how far a script is, and what it prints.
pub(super) struct Progress {
    bar: ProgressBar,
    /// True if the lines that the script prints go to standard error, since standard output is
    /// taken by data.
    lines_to_stderr: bool,
    /// The time that native code has taken to compile.
    pub compiling: Duration,
}

const PARTS: u64 = 1000;

impl Progress {
    /// A bar on standard error, if that is a terminal.
    pub fn new(script: &str, lines_to_stderr: bool) -> Self {
        let target = if stderr().is_terminal() {
            ProgressDrawTarget::stderr_with_hz(DRAWS_PER_SECOND)
        } else {
            ProgressDrawTarget::hidden()
        };
        let bar = ProgressBar::with_draw_target(Some(PARTS), target);
        if let Ok(style) = ProgressStyle::with_template("{msg} {bar:40} {percent:>3} %  {elapsed}")
        {
            bar.set_style(style);
        }
        bar.set_message(script.to_string());
        bar.enable_steady_tick(Duration::from_millis(250));
        Self { bar, lines_to_stderr, compiling: Duration::ZERO }
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Watch for Progress {
    fn iteration(&mut self, depth: u16, done: u64, total: Option<u64>) -> ControlFlow<()> {
        if depth == 0
            && let Some(total) = total.filter(|&total| total > 0)
        {
            let part = (done as f64 / total as f64).min(1.0);
            self.bar.set_position((part * PARTS as f64) as u64);
        }
        interrupt::unless_asked()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        interrupt::unless_asked()
    }

    fn compiled(&mut self, time: Duration) {
        self.compiling = time;
    }

    fn print(&mut self, line: &str) {
        let lines_to_stderr = self.lines_to_stderr;
        self.bar.suspend(|| if lines_to_stderr { eprint_line(line) } else { print_line(line) });
    }
}
