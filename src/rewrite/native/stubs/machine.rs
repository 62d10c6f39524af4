//! Steps of the machine, questions about the mesh, and elements that are added and erased.

use super::{Answer, LEAVE, failed};
use crate::mesh::ElementKind;
use crate::rewrite::memory::Budget;
use crate::rewrite::native::context::{Context, Run, noted};
use crate::rewrite::question::{Answered, ask};
use crate::rewrite::window::Window;
use crate::rewrite::{
    Call, Fault, Inst, Machine, Message, Outcome, Question, Trap, access, vectors,
};

/// Executes instructions on the machine, from the one in the lower half of `span` on, as many as
/// its upper half says; returns the place where the code continues.
pub(super) fn step(context: &mut Context, run: &mut Run<'_>, span: i64) -> Answer {
    let call = context.call(run);
    let mut place = context.place(span as u32 as usize);
    place.steps = (span >> 32) as usize;
    // An operation counts its own functions; the parts of a loop continue the current count.
    if !matches!(run.inst(context, span & 0xffff_ffff), Some(Inst::Spread { .. })) {
        run.machine.frames = 0;
    }
    let Run { machine, mesh, watch, .. } = run;
    let outcome = match machine.drains.is_empty() && !opens_drain(&call, place.at) {
        true => machine.execute_from::<false, true>(mesh, call, &mut place, *watch)?,
        false => machine.execute_from::<true, true>(mesh, call, &mut place, *watch)?,
    };
    if let Outcome::Refused { reason } = outcome {
        run.refused = Some(reason);
        return Ok(LEAVE);
    }
    context.noted = noted(place.noted);
    Ok(place.at as i64)
}

fn opens_drain(call: &Call<'_>, at: usize) -> bool {
    matches!(call.code.insts.get(at), Some(Inst::DrainOpen { .. }))
}

/// Calls the watcher, which may interrupt, at an iteration of a loop at which this is due.
pub(super) fn tick(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let Run { machine, watch, .. } = run;
    match machine.progress.tick(*watch).is_break() {
        true => Err(failed(context, run, inst, Message::Interrupted)),
        false => Ok(0),
    }
}

/// Calls the watcher at an iteration of a loop whose progress is stored, and checks the memory
/// limit.
pub(super) fn iteration(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let Some(Inst::Iteration { depth, .. }) = run.inst(context, inst) else { return Ok(LEAVE) };
    let Run { machine, mesh, watch, .. } = run;
    if machine.progress.poll_at_iteration(*watch, depth).is_break() {
        return Err(failed(context, run, inst, Message::Interrupted));
    }
    let Machine { buffers, drains, memory: limit, .. } = &**machine;
    if (Budget { buffers, drains, limit: *limit }).is_passed(mesh) {
        let message = Message::NoMemory(*limit);
        return Err(failed(context, run, inst, message));
    }
    Ok(0)
}

/// Answers a question from registers in the window, into the window; [`LEAVE`] if there is no
/// answer and the machine has to determine the trap.
pub(super) fn answer(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let call = context.call(run);
    let window = Window::at(&mut run.machine.stack, call.base);
    let (Some(Inst::Ask { question, to, elements: [first, second] }), Some(mut window)) =
        (call.code.insts.get(inst as usize), window)
    else {
        return Ok(LEAVE);
    };
    Ok(ask(run.mesh, *question, &mut window, [*to, *first, *second]).map_or(LEAVE, |()| 0))
}

/// Answers a question, by its number, with an int or a bool; [`LEAVE`] if there is no answer and
/// the machine has to determine the trap.
pub(super) fn ask_whole(
    _: &mut Context,
    run: &mut Run<'_>,
    question: i64,
    first: i64,
    second: i64,
) -> Answer {
    let Some(question) = Question::ALL.get(question as usize) else { return Ok(LEAVE) };
    Ok(match question.answer(run.mesh, [first, second].map(|id| id as u32)) {
        Ok(Answered::Whole(whole)) => whole,
        _ => LEAVE,
    })
}

/// Computes with vectors and matrices, from registers in the window into the window.
pub(super) fn compute(context: &mut Context, run: &mut Run<'_>, inst: i64) -> Answer {
    let call = context.call(run);
    let window = Window::at(&mut run.machine.stack, call.base);
    let (Some(inst), Some(mut w)) = (call.code.insts.get(inst as usize), window) else {
        return Ok(LEAVE);
    };
    match *inst {
        Inst::Wide { operation, width, to, left, right } => {
            vectors::lanes(&mut w, operation, width, [to, left, right]);
        }
        Inst::Matrix { operation, size, to, left, right } => {
            vectors::matrix(&mut w, operation, size, [to, left, right]);
        }
        _ => return Ok(LEAVE),
    }
    Ok(0)
}

/// The number of living elements of a kind.
pub(super) fn count(_: &mut Context, run: &mut Run<'_>, kind: i64) -> Answer {
    let kind = ElementKind::ALL.get(kind as usize);
    Ok(kind.map_or(0, |&kind| run.mesh.count(kind) as i64))
}

/// Appends new elements, their numbers in 16 bits for each kind, and stores the first of each;
/// [`LEAVE`], with nothing done, if [`add`] has to add them.
pub(super) fn append(context: &mut Context, run: &mut Run<'_>, counts: i64) -> Answer {
    let counts = [0, 16, 32, 48].map(|shift| (counts as u64 >> shift) as usize & 0xffff);
    if context.append(run, counts) { Ok(0) } else { Ok(LEAVE) }
}

/// Adds elements: executes the instructions from the one in the lower half of `span` up to, but
/// without, that in its upper half, which write to the window.
pub(super) fn add(context: &mut Context, run: &mut Run<'_>, span: i64) -> Answer {
    let (first, end) = (span as u32 as usize, (span >> 32) as usize);
    let call = context.call(run);
    let Run { machine, mesh, .. } = run;
    let is_told = !machine.drains.is_empty();
    for (at, inst) in call.code.insts.iter().enumerate().take(end).skip(first) {
        let failed = |fault: Fault| Trap::new(fault.into()).through(&call, at);
        let Inst::New { kind, to } = *inst else { continue };
        let drains = is_told.then_some(&mut machine.drains);
        let id = access::create(mesh, kind, &mut machine.created, drains).map_err(failed)?;
        let Some(mut window) = Window::at(&mut machine.stack, call.base) else {
            return Err(failed(Fault::Malformed));
        };
        window.set_id(to, id);
    }
    context.refresh(run);
    Ok(0)
}

/// Executes instructions that erase elements, from the one in the lower half of `span` up to, but
/// without, that in its upper half; [`LEAVE`] if one fails and the machine has to determine the
/// trap.
pub(super) fn erase(context: &mut Context, run: &mut Run<'_>, span: i64) -> Answer {
    let call = context.call(run);
    let (first, end) = (span as u32 as usize, (span >> 32) as usize);
    let Run { machine, mesh, .. } = run;
    let Some(window) = Window::at(&mut machine.stack, call.base) else { return Ok(LEAVE) };
    for inst in call.code.insts.get(first..end).unwrap_or_default() {
        let Inst::Erase { kind, element } = *inst else { return Ok(LEAVE) };
        let id = window.id(element);
        if !machine.drains.is_empty() {
            machine.drains.erased(mesh, kind, id);
        }
        if access::erase(mesh, kind, id).is_err() {
            return Ok(LEAVE);
        }
    }
    Ok(0)
}
