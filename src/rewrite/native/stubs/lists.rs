//! Buffers: a stub that changes one updates its address and length in the context.

use std::slice;

use super::{LEAVE, within_guarded};
use crate::mesh::ElementKind;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{Machine, Walk, access, lookahead, memory};

/// Empties the buffers of the code that starts to run.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn begin(context: *mut Context) -> i64 {
    let begin = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        run.machine.clear_buffers(&call);
        context.refresh_lists(run, call.code.buffers);
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, begin) }
}

/// Empties a buffer.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn clear(context: *mut Context, buffer: i64) -> i64 {
    let clear = |context: &mut Context, run: &mut Run<'_>| {
        let at = context.list_at(run, buffer as u16);
        if let Some(list) = run.machine.buffers.get_mut(at) {
            list.clear();
        }
        context.refresh_list(run, buffer as u16);
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, clear) }
}

/// Appends a slot to a buffer; [`LEAVE`] if that fails and the machine has to determine the trap.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn push(
    context: *mut Context,
    buffer: i64,
    bits: i64,
) -> i64 {
    let push = |context: &mut Context, run: &mut Run<'_>| {
        let at = context.list_at(run, buffer as u16);
        let machine = &mut *run.machine;
        let limit = (&*run.mesh, &machine.drains, machine.memory);
        if memory::for_list(&mut machine.buffers, at, 1, limit).is_err() {
            return Ok(LEAVE);
        }
        machine.buffers[at].push(bits as u64);
        context.refresh_list(run, buffer as u16);
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, push) }
}

/// Requests the memory around the elements that follow in a buffer: `which` has the number of the
/// buffer in its low 16 bits and then the kind of the elements.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn prefetch(
    context: *mut Context,
    which: i64,
    index: i64,
) -> i64 {
    let look = |context: &mut Context, run: &mut Run<'_>| {
        let at = context.list_at(run, which as u16);
        if let (Some(list), Some(&kind)) =
            (run.machine.buffers.get(at), ElementKind::ALL.get((which >> 16) as usize))
        {
            lookahead::prefetch(run.mesh, kind, list, index as u64);
        }
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, look) }
}

/// Appends the halfedges of a walk to a buffer: `which` has the number of the buffer in its low 16
/// bits and then the walk. [`LEAVE`] if that fails and the machine has to determine the trap.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn collect(
    context: *mut Context,
    which: i64,
    from: i64,
    until: i64,
) -> i64 {
    let collect = |context: &mut Context, run: &mut Run<'_>| {
        let buffer = which as u16;
        let walk = if which >> 16 == 0 { Walk::Loop } else { Walk::Star };
        let at = context.list_at(run, buffer);
        let Some(list) = run.machine.buffers.get_mut(at) else {
            return Ok(LEAVE);
        };
        let before = list.len();
        let walked = access::collect(run.mesh, walk, [from as u32, until as u32], list);
        if walked.is_err() {
            list.truncate(before);
        }
        context.refresh_list(run, buffer);
        Ok(walked.map_or(LEAVE, |()| 0))
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, collect) }
}

/// Keeps a valid write back: a header as the machine writes it, the number of the element, and
/// slots from the window. `which` has the buffer, the first slot and the number of slots, 16 bits
/// each. [`LEAVE`] if that fails and the machine has to determine the trap.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn hold(
    context: *mut Context,
    which: i64,
    header: i64,
    element: i64,
) -> i64 {
    let hold = |context: &mut Context, run: &mut Run<'_>| {
        let [buffer, first, width] = [0, 16, 32].map(|shift| (which >> shift) as u16);
        let (at, first) = (context.list_at(run, buffer), context.base() + usize::from(first));
        let is_kept = run.machine.is_beside_others;
        if is_kept {
            // SAFETY: native code passes on its context, and has written the slots that it has
            // counted.
            unsafe { context.count_kept(run.machine) };
        }
        let Machine { buffers, kept, drains, memory: limit, stack, .. } = &mut *run.machine;
        let (lists, at) = match is_kept {
            true => (slice::from_mut(kept), 0),
            false => (buffers.as_mut_slice(), at),
        };
        let has_room = memory::for_list(lists, at, memory::HELD, (&*run.mesh, drains, *limit));
        let slots = stack.get(first..first + usize::from(width));
        let (Some(slots), Ok(())) = (slots, has_room) else {
            return Ok(LEAVE);
        };
        let list = &mut lists[at];
        list.extend([header as u64, element as u64]);
        list.extend_from_slice(slots);
        match is_kept {
            true => context.find_kept(run.machine),
            false => context.refresh_list(run, buffer),
        }
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, hold) }
}
