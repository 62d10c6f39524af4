//! Stubs for the loop `drain`.

use super::{Answer, LEAVE, failed};
use crate::rewrite::memory::Budget;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::window::Window;
use crate::rewrite::{Machine, Message};

/// The answer if there is no element.
pub(in super::super) const NONE: i64 = -2;

/// The next element whose key is to be computed; the registers that paths may read are in the
/// window.
pub(super) fn next_stale(context: &mut Context, run: &mut Run<'_>) -> Answer {
    let base = context.call(run).base;
    let Machine { stack, drains, .. } = &mut *run.machine;
    let Some(w) = Window::at(stack, base) else { return Ok(LEAVE) };
    Ok(drains.next_stale(run.mesh, |variable| w.id(variable)).map_or(NONE, i64::from))
}

/// Sets the key of the element whose key is being computed.
pub(super) fn set_key(context: &mut Context, run: &mut Run<'_>, inst: i64, key: f64) -> Answer {
    if let Err(message) = run.machine.drains.set_key(key) {
        return Err(failed(context, run, inst, message));
    }
    let Machine { buffers, drains, memory: limit, .. } = &*run.machine;
    if drains.has_looked() && (Budget { buffers, drains, limit: *limit }).is_passed(run.mesh) {
        return Err(failed(context, run, inst, Message::NoMemory(*limit)));
    }
    Ok(0)
}

/// The element with the least key.
pub(super) fn least(_: &mut Context, run: &mut Run<'_>) -> Answer {
    Ok(run.machine.drains.least(run.mesh).map_or(NONE, i64::from))
}

/// Removes the element with the least key from the queue.
pub(super) fn take_least(_: &mut Context, run: &mut Run<'_>) -> Answer {
    run.machine.drains.take();
    Ok(0)
}
