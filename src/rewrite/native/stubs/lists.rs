//! Buffers: what changes one tells native code where its slots are from then on.

use super::{LEAVE, within_guarded};
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::window::Window;
use crate::rewrite::{Inst, Walk, access, attribute, memory};

/// Empties the buffers of code that begins.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn begin(context: *mut Context) -> i64 {
    let begin = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        run.machine.clear_buffers(&call);
        context.refresh_lists(run, call.code.buffers);
        Ok(0)
    };
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, begin) }
}

/// Empties a buffer.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn clear(context: *mut Context, buffer: i64) -> i64 {
    let clear = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        if let Some(list) = run.machine.buffers.get_mut(call.buffers + buffer as usize) {
            list.clear();
        }
        context.refresh_list(run, buffer as u16);
        Ok(0)
    };
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, clear) }
}

/// Appends to a buffer; [`LEAVE`] where the machine is to tell why it cannot.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn push(
    context: *mut Context,
    buffer: i64,
    bits: i64,
) -> i64 {
    let push = |context: &mut Context, run: &mut Run<'_>| {
        let at = context.call(run).buffers + buffer as usize;
        let machine = &mut *run.machine;
        let limit = (&*run.mesh, &machine.drains, machine.memory);
        if memory::for_list(&mut machine.buffers, at, 1, limit).is_err() {
            return Ok(LEAVE);
        }
        machine.buffers[at].push(bits as u64);
        context.refresh_list(run, buffer as u16);
        Ok(0)
    };
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, push) }
}

/// Appends the halfedges of a walk, as an instruction says; [`LEAVE`] where the machine is to tell
/// why it cannot.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn collect(
    context: *mut Context,
    which: i64,
    from: i64,
    until: i64,
) -> i64 {
    let collect = |context: &mut Context, run: &mut Run<'_>| {
        let buffer = which as u16;
        let walk = if which >> 16 == 0 { Walk::Loop } else { Walk::Star };
        let at = context.call(run).buffers + usize::from(buffer);
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
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, collect) }
}

/// Keeps a write back whose operands stand in the window; [`LEAVE`] where the machine is to tell
/// why it cannot.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn hold(context: *mut Context, inst: i64) -> i64 {
    let hold = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        let inst = call.code.insts.get(inst as usize);
        let Some(&(Inst::HoldPosition { buffer, .. } | Inst::HoldAttribute { buffer, .. })) = inst
        else {
            return Ok(LEAVE);
        };
        let at = call.buffers + usize::from(buffer);
        let (machine, mesh) = (&mut *run.machine, &mut *run.mesh);
        let limit = (&*mesh, &machine.drains, machine.memory);
        if memory::for_list(&mut machine.buffers, at, memory::HELD, limit).is_err() {
            return Ok(LEAVE);
        }
        let (list, columns) = (&mut machine.buffers[at], &machine.columns);
        let Some(w) = Window::at(&mut machine.stack, call.base) else {
            return Ok(LEAVE);
        };
        let held = match inst {
            Some(&Inst::HoldPosition { vertex, value, .. }) => {
                access::place(mesh, w.id(vertex), w.vector(value))
                    .map(|(vertex, position)| attribute::hold_position(vertex, position, list))
            }
            Some(&Inst::HoldAttribute { attribute, element, value, .. }) => {
                attribute::column(columns, attribute).and_then(|column| {
                    let target = (attribute, w.id(element));
                    attribute::hold(mesh, column, target, &w, value, list)
                })
            }
            _ => Ok(()),
        };
        context.refresh_list(run, buffer);
        Ok(held.map_or(LEAVE, |()| 0))
    };
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, hold) }
}
