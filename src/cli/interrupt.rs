//! Ctrl-C while a program runs.
//!
//! The first one asks the script to stop, which it does at its next turn, with nothing written;
//! the second ends the process at once. So does the first when the script is done and its result
//! goes into a pipe, which may wait for a reader for ever: there nothing is half-written.

use std::ops::ControlFlow;
use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};

/// The exit code of a command that was interrupted: 128 and the number of the signal, as shells
/// count.
pub(super) const CODE: u8 = 130;

static ASKED: AtomicBool = AtomicBool::new(false);
static ENDS_AT_ONCE: AtomicBool = AtomicBool::new(false);

/// Takes Ctrl-C from now on. Where that cannot be had, it ends the process as ever.
pub(super) fn listen() {
    let _ = ctrlc::set_handler(|| {
        let again = ASKED.swap(true, Ordering::SeqCst);
        if again || ENDS_AT_ONCE.load(Ordering::SeqCst) {
            exit(i32::from(CODE));
        }
    });
}

/// From now on a request to stop ends the process; so does an earlier one that was not heard.
pub(super) fn end_at_once() {
    ENDS_AT_ONCE.store(true, Ordering::SeqCst);
    if ASKED.load(Ordering::SeqCst) {
        exit(i32::from(CODE));
    }
}

/// True if somebody has asked to stop.
pub(super) fn is_asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Goes on unless somebody has asked to stop.
pub(super) fn unless_asked() -> ControlFlow<()> {
    match is_asked() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    }
}
