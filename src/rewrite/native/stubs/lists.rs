//! Buffers: what native code does not do in place.

use std::slice;

use super::{Answer, LEAVE, failed};
use crate::mesh::ElementKind;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{Inst, Machine, Message, Walk, access, families, lookahead, memory};

/// Empties the buffers of the code that starts to run.
pub(super) fn begin_lists(context: &mut Context, run: &mut Run<'_>) -> Answer {
    run.machine.clear_buffers(&context.call(run));
    context.find_lists(run, context.first_of_lists());
    Ok(0)
}

/// Executes an instruction that fills a buffer with members of a family.
pub(super) fn fill(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let call = context.call(run);
    let Some(instruction) = call.code.insts.get(inst as usize) else { return Ok(LEAVE) };
    let filled = match *instruction {
        Inst::BufferNew { kind, cycle, buffer } => {
            let [cycle, to] = [cycle, buffer].map(|buffer| context.list_at(run, buffer));
            new_members(context, run, kind, [cycle, to])
        }
        _ => Ok(false),
    };
    let filled = filled.and_then(|is_done| {
        if !is_done {
            context.settle(run);
            run.machine.fill(run.mesh, call.buffers, instruction)?;
            context.refresh(run);
        }
        Ok(0)
    });
    filled.map_err(|message| failed(context, run, inst, message))
}

/// Appends as many elements of a kind as a list has slots, and fills another one with them; false,
/// with nothing done, if the machine has to.
fn new_members(
    context: &mut Context,
    run: &mut Run<'_>,
    kind: ElementKind,
    [cycle, to]: [usize; 2],
) -> Result<bool, Message> {
    let count = run.machine.buffers.get(cycle).map_or(0, |list| list.len());
    let Machine { buffers, drains, memory: limit, .. } = &mut *run.machine;
    let Some(list) = buffers.get_mut(to) else { return Err(Message::Malformed) };
    list.clear();
    memory::for_list(buffers, to, count, (&*run.mesh, drains, *limit))?;
    let is_done = context.append(run, access::counts_of(kind, count));
    if is_done {
        let first = u64::from(context.appended[kind as usize]);
        run.machine.buffers[to].grow().extend(first..first + count as u64);
    }
    Ok(is_done)
}

/// Whether no two slots of a buffer are equal; reorders the slots.
pub(super) fn are_distinct(context: &mut Context, run: &mut Run<'_>, buffer: i64) -> Answer {
    let at = context.list_at(run, buffer as u16);
    let list = run.machine.buffers.get_mut(at);
    Ok(list.map_or(LEAVE, |list| families::are_distinct(list).into()))
}

/// Appends a slot to a buffer; [`LEAVE`] if that fails and the machine has to determine the trap.
pub(super) fn push(context: &mut Context, run: &mut Run<'_>, buffer: i64, bits: i64) -> Answer {
    let at = context.list_at(run, buffer as u16);
    let machine = &mut *run.machine;
    let limit = (&*run.mesh, &machine.drains, machine.memory);
    if memory::for_list(&mut machine.buffers, at, 1, limit).is_err() {
        return Ok(LEAVE);
    }
    machine.buffers[at].grow().push(bits as u64);
    Ok(0)
}

/// Requests the memory around the elements that follow in a buffer: `which` has the number of the
/// buffer in its low 16 bits and then the kind of the elements.
pub(super) fn prefetch(context: &mut Context, run: &mut Run<'_>, which: i64, index: i64) -> Answer {
    let at = context.list_at(run, which as u16);
    if let (Some(list), Some(&kind)) =
        (run.machine.buffers.get(at), ElementKind::ALL.get((which >> 16) as usize))
    {
        lookahead::prefetch(run.mesh, kind, list, index as u64);
    }
    Ok(0)
}

/// Appends the halfedges of a walk to a buffer: `which` has the number of the buffer in its low 16
/// bits and then the walk. [`LEAVE`] if that fails and the machine has to determine the trap.
pub(super) fn collect(
    context: &mut Context,
    run: &mut Run<'_>,
    which: i64,
    from: i64,
    until: i64,
) -> Answer {
    let buffer = which as u16;
    let walk = if which >> 16 == 0 { Walk::Loop } else { Walk::Star };
    let at = context.list_at(run, buffer);
    let Some(list) = run.machine.buffers.get_mut(at) else { return Ok(LEAVE) };
    let (before, mut list) = (list.len(), list.grow());
    let walked = access::collect(run.mesh, walk, [from as u32, until as u32], &mut list);
    if walked.is_err() {
        list.truncate(before);
    }
    Ok(walked.map_or(LEAVE, |()| 0))
}

/// Keeps a valid write back: a header as the machine writes it, the number of the element, and
/// slots from the window. `which` has the buffer, the first slot and the number of slots, 16 bits
/// each. [`LEAVE`] if that fails and the machine has to determine the trap.
pub(super) fn hold(
    context: &mut Context,
    run: &mut Run<'_>,
    which: i64,
    header: i64,
    element: i64,
) -> Answer {
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
    let (Some(slots), Ok(())) = (slots, has_room) else { return Ok(LEAVE) };
    let mut list = lists[at].grow();
    list.extend([header as u64, element as u64]);
    list.extend_from_slice(slots);
    Ok(0)
}
