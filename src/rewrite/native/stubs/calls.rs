//! Calls of functions and operations.

use super::{Answer, LEAVE, anything, enter, failed, guarded};
use crate::rewrite::native::compile::Entry;
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{Inst, Message, Outcome, Trap};

/// Calls a function that native code does not call directly.
pub(super) fn call(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let caller = context.call(run);
    let Run { machine, mesh, watch, .. } = run;
    match machine.call_function(mesh, &caller, inst as usize, *watch)? {
        Outcome::Applied { .. } => Ok(0),
        Outcome::Refused { reason } => {
            run.refused = Some(reason);
            Ok(LEAVE)
        }
    }
}

/// Adds the caller to the trace of a trap by which a function or operation that native code called
/// directly has been left.
pub(super) fn left(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    match run.trap.take() {
        Some(trap) => Err(trap.through(&context.call(run), inst as usize)),
        None => Ok(LEAVE),
    }
}

/// The answer if an operation has to be called by the machine.
const BY_MACHINE: i64 = 0;

/// Calls an operation. Bit 0 of the answer says whether it was applied, bit 1 whether it has a
/// result, which is in the upper half.
///
/// # Safety
/// As for all stubs.
pub(in super::super) unsafe extern "C" fn apply(context: *mut Context, inst: i64) -> i64 {
    let mut caller = None;
    let begin = |context: &mut Context, run: &mut Run<'_>| match begin_op(context, run, inst) {
        Some((entry, before)) => {
            caller = Some((entry, before));
            Ok(1)
        }
        None => Ok(BY_MACHINE),
    };
    // SAFETY: as for all stubs.
    if unsafe { enter(context, guarded(begin)) } == LEAVE {
        return LEAVE;
    }
    let Some((entry, before)) = caller else {
        // SAFETY: as for all stubs.
        return unsafe { apply_by_machine(context, inst) };
    };
    // SAFETY: the entry is that of native code of an operation of the running program, which lives
    // long enough; the context is set up for it, and there is no reference to it or its run.
    let answer = unsafe { entry(context, 0) };
    let end =
        |context: &mut Context, run: &mut Run<'_>| end_op(context, run, (inst, answer), before);
    // SAFETY: as for all stubs.
    unsafe { enter(context, guarded(end)) }
}

/// The state of the context for the caller of an operation.
struct Before {
    base: usize,
    buffers: u16,
    function: u64,
    frames: usize,
}

/// Makes the context that of a called operation, if it has native code, its writes need not be
/// tracked, and a script calls it; returns its entry.
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
        buffers: caller.code.buffers,
        function: context.function,
        frames: run.frames,
    };
    context.begin_op(run, &call, op, caller.code.buffers);
    Some((compiled.entry, before))
}

/// Makes the context that of the caller again, and counts the outcome of the operation.
#[inline]
fn end_op(
    context: &mut Context,
    run: &mut Run<'_>,
    (inst, answer): (i64, i64),
    before: Before,
) -> Result<i64, Trap> {
    let outcome = context.outcome(answer);
    let Before { base, buffers, function, frames } = before;
    context.end_op(run, base, buffers, function);
    run.frames = frames;
    let caller = context.call(run);
    let (Some(outcome), Some(&Inst::Apply { op, .. })) =
        (outcome, caller.code.insts.get(inst as usize))
    else {
        // The operation was left by a trap or a panic.
        return run.trap.take().map_or(Ok(LEAVE), |trap| Err(trap.through(&caller, inst as usize)));
    };
    let Run { machine, mesh, watch, .. } = run;
    let counted = machine.conclude(mesh, &caller, op, None, outcome, *watch);
    counted.map_err(|trap| trap.through(&caller, inst as usize))?;
    Ok(answer_of(outcome))
}

/// Counts a refusal of an operation that native code has called directly.
pub(super) fn refused(context: &mut Context, run: &mut Run<'_>, op: i64) -> Answer {
    let reason = context.place(0).noted.map(|(_, reason)| reason);
    context.noted = 0;
    run.machine.last_refusal = Some((op as u16, reason));
    run.machine.count(op as u16, Outcome::Refused { reason });
    Ok(0)
}

fn answer_of(outcome: Outcome) -> i64 {
    match outcome {
        Outcome::Applied { result: Some(made) } => 3 | i64::from(made) << 32,
        Outcome::Applied { result: None } => 1,
        Outcome::Refused { .. } => 0,
    }
}

/// Calls an operation by the machine; answers as [`apply`] does.
///
/// # Safety
/// As for all stubs.
unsafe fn apply_by_machine(context: *mut Context, inst: i64) -> i64 {
    let apply = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        let Some(&Inst::Apply { op, args, .. }) = call.code.insts.get(inst as usize) else {
            return Err(failed(context, run, inst, Message::Malformed));
        };
        // The operation counts its own functions.
        run.machine.frames = 0;
        let Run { machine, mesh, watch, .. } = run;
        let outcome = match machine.drains.is_empty() {
            true => machine.call::<false>(mesh, &call, [op, args.0], *watch),
            false => machine.call::<true>(mesh, &call, [op, args.0], *watch),
        };
        outcome.map(answer_of).map_err(|trap| trap.through(&call, inst as usize))
    };
    // SAFETY: as for all stubs.
    unsafe { enter(context, anything(apply)) }
}
