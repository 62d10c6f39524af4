//! Buffers: what native code does not do in place.

use std::slice;

use super::{LEAVE, failed, within_guarded};
use crate::mesh::ElementKind;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{Inst, Machine, Walk, access, families, lookahead, memory};

/// Empties the buffers of the code that starts to run.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn begin(context: *mut Context) -> i64 {
    let begin = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        run.machine.clear_buffers(&call);
        context.find_lists(run, context.first_of_lists());
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, begin) }
}

/// Empties and fills buffers: executes the instructions from the one in the lower half of `span` up
/// to, but without, that in its upper half.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn fill(context: *mut Context, span: i64) -> i64 {
    let fill = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        let (first, end) = (span as u32 as usize, (span >> 32) as usize);
        let insts = call.code.insts.get(first..end).unwrap_or_default();
        for (at, inst) in (first..).zip(insts) {
            let filled = run.machine.fill(run.mesh, call.buffers, inst);
            filled.map_err(|message| failed(context, run, at as i64, message))?;
        }
        if insts.iter().any(|inst| matches!(inst, Inst::BufferNew { .. })) {
            context.refresh(run);
        }
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, fill) }
}

/// Whether no two slots of a buffer are equal; reorders the slots.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn are_distinct(context: *mut Context, buffer: i64) -> i64 {
    let ask = |context: &mut Context, run: &mut Run<'_>| {
        let at = context.list_at(run, buffer as u16);
        let list = run.machine.buffers.get_mut(at);
        Ok(list.map_or(LEAVE, |list| families::are_distinct(list).into()))
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, ask) }
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
        machine.buffers[at].grow().push(bits as u64);
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
        let (before, mut list) = (list.len(), list.grow());
        let walked = access::collect(run.mesh, walk, [from as u32, until as u32], &mut list);
        if walked.is_err() {
            list.truncate(before);
        }
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
        let mut list = lists[at].grow();
        list.extend([header as u64, element as u64]);
        list.extend_from_slice(slots);
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, hold) }
}
