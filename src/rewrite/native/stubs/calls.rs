//! Calls of functions and operations.

use super::{LEAVE, failed, within, within_any, within_guarded};
use crate::rewrite::native::compile::Entry;
use crate::rewrite::native::context::{Context, Run, Slice};
use crate::rewrite::{Inst, Message, Outcome, Trap};

/// Calls a function where native code does not do so itself.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn call(context: *mut Context, inst: i64) -> i64 {
    let call = |context: &mut Context, run: &mut Run<'_>| {
        let caller = context.call(run);
        let Run { machine, mesh, watch, .. } = run;
        match machine.call_function(mesh, &caller, inst as usize, *watch)? {
            Outcome::Applied { .. } => Ok(0),
            Outcome::Refused { reason } => {
                run.refused = Some(reason);
                Ok(LEAVE)
            }
        }
    };
    // SAFETY: as of all stubs.
    unsafe { within_any(context, call) }
}

/// A function or operation that native code called itself has been left by a trap: it is seen from the caller,
/// too.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn left(context: *mut Context, inst: i64) -> i64 {
    let left = |context: &mut Context, run: &mut Run<'_>| match run.trap.take() {
        Some(trap) => Err(trap.through(&context.call(run), inst as usize)),
        None => Ok(LEAVE),
    };
    // SAFETY: as of all stubs.
    unsafe { within(context, left) }
}

/// The answer where an operation is to be called by the machine.
const BY_MACHINE: i64 = 0;

/// Calls an operation: whether it was applied, and one bit further whether it gives an element,
/// which stands in the upper half.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn apply(context: *mut Context, inst: i64) -> i64 {
    let mut caller = None;
    let begin = |context: &mut Context, run: &mut Run<'_>| match begin_op(context, run, inst) {
        Some((entry, before)) => {
            caller = Some((entry, before));
            Ok(1)
        }
        None => Ok(BY_MACHINE),
    };
    // SAFETY: as of all stubs.
    if unsafe { within_guarded(context, begin) } == LEAVE {
        return LEAVE;
    }
    let Some((entry, before)) = caller else {
        // SAFETY: as of all stubs.
        return unsafe { apply_by_machine(context, inst) };
    };
    // SAFETY: the entry is that of native code of an operation of the program that runs, which
    // lives as long; the context is set for it, and nobody refers to it or its run.
    let answer = unsafe { entry(context, 0) };
    let end =
        |context: &mut Context, run: &mut Run<'_>| end_op(context, run, (inst, answer), before);
    // SAFETY: as of all stubs.
    unsafe { within_guarded(context, end) }
}

/// What the context held for the caller of an operation.
struct Before {
    base: usize,
    lists: *const Slice,
    first_list: *const Slice,
    function: u64,
    frames: usize,
}

/// Makes the context that of an operation that is called, if it is there as native code, nobody
/// has to know what it writes when it is done, and a script calls it. Gives where to enter it.
#[inline]
fn begin_op(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Option<(Entry, Before)> {
    let caller = context.call(run);
    let Some(&Inst::Apply { op, args, .. }) = caller.code.insts.get(inst as usize) else {
        return None;
    };
    let plan = caller.plans.get(usize::from(op))?.as_ref()?;
    let is_of_script = caller.op.is_none() && caller.steps.is_none() && caller.depth == 0;
    if plan.steps.is_some() || !is_of_script || context.left == 0 || run.machine.watches_level(plan)
    {
        return None;
    }
    run.count_frames(context);
    let Run { machine, mesh, attributes, .. } = run;
    let compiled = machine.compiled(mesh, &caller.calling(op, plan))?;
    if !compiled.attributes.iter().all(|attribute| attributes.contains(attribute)) {
        return None;
    }
    let (_, call) = machine.begin_call(mesh, &caller, [op, args.0]).ok()?;
    let before = Before {
        base: caller.base,
        lists: context.lists,
        first_list: context.first_list,
        function: context.function,
        frames: run.frames,
    };
    context.begin_op(run, &call, op, caller.code.buffers);
    Some((compiled.entry, before))
}

/// Makes the context that of the caller again, and counts what has become of the operation.
#[inline]
fn end_op(
    context: &mut Context,
    run: &mut Run<'_>,
    (inst, answer): (i64, i64),
    before: Before,
) -> Result<i64, Trap> {
    let outcome = context.outcome(answer);
    let Before { base, lists, first_list, function, frames } = before;
    context.end_op(run, base, lists.addr() - first_list.addr(), function);
    run.frames = frames;
    let caller = context.call(run);
    let (Some(outcome), Some(&Inst::Apply { op, .. })) =
        (outcome, caller.code.insts.get(inst as usize))
    else {
        // By a trap or a panic.
        return run.trap.take().map_or(Ok(LEAVE), |trap| Err(trap.through(&caller, inst as usize)));
    };
    let Run { machine, mesh, watch, .. } = run;
    let counted = machine.conclude(mesh, &caller, op, None, outcome, *watch);
    counted.map_err(|trap| trap.through(&caller, inst as usize))?;
    Ok(answer_of(outcome))
}

/// Counts an operation that native code has called itself and that refuses.
///
/// # Safety
/// As of all stubs.
pub(in super::super) unsafe extern "C" fn refused(context: *mut Context, op: i64) -> i64 {
    let refused = |context: &mut Context, run: &mut Run<'_>| {
        let reason = context.place(0).noted.map(|(_, reason)| reason);
        context.noted = 0;
        run.machine.last_reason = reason;
        run.machine.count(op as u16, Outcome::Refused { reason });
        Ok(0)
    };
    // SAFETY: as of all stubs.
    unsafe { within(context, refused) }
}

fn answer_of(outcome: Outcome) -> i64 {
    match outcome {
        Outcome::Applied { result: Some(made) } => 3 | i64::from(made) << 32,
        Outcome::Applied { result: None } => 1,
        Outcome::Refused { .. } => 0,
    }
}

/// The same by the machine.
///
/// # Safety
/// As of all stubs.
unsafe fn apply_by_machine(context: *mut Context, inst: i64) -> i64 {
    let apply = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        let Some(&Inst::Apply { op, args, .. }) = call.code.insts.get(inst as usize) else {
            return Err(failed(context, run, inst, Message::Malformed));
        };
        // It counts its own functions.
        run.machine.frames = 0;
        let Run { machine, mesh, watch, .. } = run;
        let outcome = match machine.drains.is_empty() {
            true => machine.call::<false>(mesh, &call, [op, args.0], *watch),
            false => machine.call::<true>(mesh, &call, [op, args.0], *watch),
        };
        outcome.map(answer_of).map_err(|trap| trap.through(&call, inst as usize))
    };
    // SAFETY: as of all stubs.
    unsafe { within_any(context, apply) }
}
