//! Ctrl-C while a program runs.
//!
//! The first one asks the script to stop, which it does at its next turn, or the writing of its
//! result; nothing is written then. The second ends the process at once. So does the first one when
//! the script is done and its result goes into a pipe, which may block indefinitely: no file is left
//! half-written.

use std::ops::ControlFlow;
use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};

use super::failure::Failure;
use super::output::eprint_line;

/// The exit code of a command that was interrupted: 128 plus the number of the signal, as is usual
/// in shells.
pub(super) const CODE: u8 = 130;

static ASKED: AtomicBool = AtomicBool::new(false);
static ENDS_AT_ONCE: AtomicBool = AtomicBool::new(false);

/// Handles Ctrl-C from now on. If the handler cannot be set, Ctrl-C ends the process as usual.
pub(super) fn listen() {
    let _ = ctrlc::set_handler(|| {
        let again = ASKED.swap(true, Ordering::SeqCst);
        if again || ENDS_AT_ONCE.load(Ordering::SeqCst) {
            exit(i32::from(CODE));
        }
    });
}

/// From now on Ctrl-C ends the process at once; an earlier one that is still pending ends it now.
pub(super) fn end_at_once() {
    ENDS_AT_ONCE.store(true, Ordering::SeqCst);
    if ASKED.load(Ordering::SeqCst) {
        exit(i32::from(CODE));
    }
}

/// True if Ctrl-C was pressed.
pub(super) fn is_asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Fails if Ctrl-C was pressed.
pub(super) fn expect_none() -> Result<(), Failure> {
    if !is_asked() {
        return Ok(());
    }
    eprint_line("interrupted: nothing is written");
    Err(Failure::Silent(CODE.into()))
}

/// Continues unless Ctrl-C was pressed.
pub(super) fn unless_asked() -> ControlFlow<()> {
    if is_asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}
