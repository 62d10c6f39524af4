//! Stubs for the loop `drain`.

use super::{LEAVE, failed, within_guarded};
use crate::rewrite::memory::Budget;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::window::Window;
use crate::rewrite::{Machine, Message};

/// The answer if there is no element.
pub(in super::super) const NONE: i64 = -2;

/// The next element whose key is to be computed; the registers that paths may read are in the
/// window.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn stale(context: *mut Context) -> i64 {
    let stale = |context: &mut Context, run: &mut Run<'_>| {
        let base = context.call(run).base;
        let Machine { stack, drains, .. } = &mut *run.machine;
        let Some(w) = Window::at(stack, base) else { return Ok(LEAVE) };
        Ok(drains.next_stale(run.mesh, |variable| w.id(variable)).map_or(NONE, i64::from))
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, stale) }
}

/// Sets the key of the element whose key is being computed.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn key(context: *mut Context, inst: i64, key: f64) -> i64 {
    let set = |context: &mut Context, run: &mut Run<'_>| {
        if let Err(message) = run.machine.drains.set_key(key) {
            return Err(failed(context, run, inst, message));
        }
        let Machine { buffers, drains, memory: limit, .. } = &*run.machine;
        if drains.has_looked() && (Budget { buffers, drains, limit: *limit }).is_passed(run.mesh) {
            return Err(failed(context, run, inst, Message::NoMemory(*limit)));
        }
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, set) }
}

/// The element with the least key.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn least(context: *mut Context) -> i64 {
    let least = |_: &mut Context, run: &mut Run<'_>| {
        Ok(run.machine.drains.least(run.mesh).map_or(NONE, i64::from))
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, least) }
}

/// Removes the element with the least key from the queue.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn take(context: *mut Context) -> i64 {
    let take = |_: &mut Context, run: &mut Run<'_>| {
        run.machine.drains.take();
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, take) }
}
