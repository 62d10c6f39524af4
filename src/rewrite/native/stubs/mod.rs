//! Stubs: the functions of the machine that native code calls.
//!
//! Each takes the context of the call. No panic unwinds into native code: a panic of a stub that
//! may panic is caught, and resumed when native code has been left; the others do not panic.

pub(super) mod calls;
pub(super) mod drains;
pub(super) mod guards;
pub(super) mod lists;
pub(super) mod writes;

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::mesh::ElementKind;
use crate::rewrite::arithmetic::{balance as balanced, direction, math};
use crate::rewrite::memory::Budget;
use crate::rewrite::native::context::{Context, Run, noted};
use crate::rewrite::question::ask;
use crate::rewrite::window::Window;
use crate::rewrite::{
    Call, Fault, Inst, Machine, Math, Message, Outcome, Question, Trap, access, vectors,
};

/// The answer of a stub if native code has to be left: the trap is in the run.
pub(super) const LEAVE: i64 = -1;

/// Calls a closure with a context and its run.
///
/// # Safety
/// The context is one that the machine has made for native code that runs.
#[inline]
pub(super) unsafe fn within(
    context: *mut Context,
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap>,
) -> i64 {
    let settled = |context: &mut Context, run: &mut Run<'_>| {
        context.settle(run);
        act(context, run)
    };
    // SAFETY: as for `within_unsettled`.
    unsafe { within_unsettled(context, settled) }
}

/// [`within`] for closures that access no more of the mesh than what elements that they are given
/// lead to, so that the tables may keep their spare slots.
///
/// # Safety
/// As for [`within`].
#[inline]
pub(super) unsafe fn within_unsettled(
    context: *mut Context,
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap>,
) -> i64 {
    // SAFETY: native code passes on the context that it was entered with. The machine made it and
    // its run from values that it borrows until native code returns, and accesses neither in the
    // meantime; native code itself holds no reference.
    let (context, run) = unsafe {
        let context = &mut *context;
        let run = &mut *context.run.cast::<Run<'_>>();
        (context, run)
    };
    match act(context, run) {
        Ok(answer) => answer,
        Err(trap) => {
            run.trap = Some(trap);
            LEAVE
        }
    }
}

/// [`within`] for closures that may panic.
///
/// # Safety
/// As for [`within`].
pub(super) unsafe fn within_guarded(
    context: *mut Context,
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap>,
) -> i64 {
    // SAFETY: as for `within`.
    unsafe { within(context, guarded(act)) }
}

/// A closure that catches a panic of another one.
pub(super) fn guarded(
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap>,
) -> impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap> {
    |context, run| {
        catch_unwind(AssertUnwindSafe(|| act(context, run))).unwrap_or_else(|panic| {
            run.panic = Some(panic);
            Ok(LEAVE)
        })
    }
}

/// [`within`] for closures that may do anything: afterwards the context is updated.
///
/// # Safety
/// As for [`within`].
pub(super) unsafe fn within_any(
    context: *mut Context,
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Result<i64, Trap>,
) -> i64 {
    let any = |context: &mut Context, run: &mut Run<'_>| {
        run.count_frames(context);
        let acted = catch_unwind(AssertUnwindSafe(|| act(context, run)));
        context.refresh(run);
        acted.unwrap_or_else(|panic| {
            run.panic = Some(panic);
            Ok(LEAVE)
        })
    };
    // SAFETY: as for `within`.
    unsafe { within(context, any) }
}

/// Executes instructions on the machine, from the one in the lower half of `span` on, as many as
/// its upper half says; returns the place where the code continues.
///
/// # Safety
/// As for all stubs: native code calls it with its context.
pub(super) unsafe extern "C" fn step(context: *mut Context, span: i64) -> i64 {
    let take = |context: &mut Context, run: &mut Run<'_>| {
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
    };
    // SAFETY: see above.
    unsafe { within_any(context, take) }
}

fn opens_drain(call: &Call<'_>, at: usize) -> bool {
    matches!(call.code.insts.get(at), Some(Inst::DrainOpen { .. }))
}

/// Calls the watcher, which may interrupt, at a turn of a loop at which this is due.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn tick(context: *mut Context, inst: i64) -> i64 {
    let tick = |context: &mut Context, run: &mut Run<'_>| {
        let Run { machine, watch, .. } = run;
        match machine.progress.tick(*watch).is_break() {
            true => Err(failed(context, run, inst, Message::Interrupted)),
            false => Ok(0),
        }
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, tick) }
}

/// Calls the watcher at a turn of a loop whose progress is stored, and checks the memory limit.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn turn(context: *mut Context, inst: i64) -> i64 {
    let turn = |context: &mut Context, run: &mut Run<'_>| {
        let Some(Inst::Turn { depth, .. }) = run.inst(context, inst) else { return Ok(LEAVE) };
        let Run { machine, mesh, watch, .. } = run;
        if machine.progress.look_at_turn(*watch, depth).is_break() {
            return Err(failed(context, run, inst, Message::Interrupted));
        }
        let Machine { buffers, drains, memory: limit, .. } = &**machine;
        if (Budget { buffers, drains, limit: *limit }).is_passed(mesh) {
            let message = Message::NoMemory(*limit);
            return Err(failed(context, run, inst, message));
        }
        Ok(0)
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, turn) }
}

/// The trap of an instruction of the running code.
#[cold]
pub(super) fn failed(context: &Context, run: &Run<'_>, inst: i64, message: Message) -> Trap {
    let call = context.call(run);
    let about = run.machine.about(&call, inst as usize);
    Trap { about, ..Trap::new(message) }.through(&call, inst as usize)
}

/// Answers a question from registers in the window, into the window; [`LEAVE`] if there is no
/// answer and the machine has to determine the trap.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn answer(context: *mut Context, inst: i64) -> i64 {
    let answer = |context: &mut Context, run: &mut Run<'_>| {
        let call = context.call(run);
        let window = Window::at(&mut run.machine.stack, call.base);
        let (Some(Inst::Ask { question, to, elements: [first, second] }), Some(mut window)) =
            (call.code.insts.get(inst as usize), window)
        else {
            return Ok(LEAVE);
        };
        Ok(ask(run.mesh, *question, &mut window, [*to, *first, *second]).map_or(LEAVE, |()| 0))
    };
    // SAFETY: as for all stubs.
    unsafe { within_unsettled(context, guarded(answer)) }
}

/// Answers a question, by its number, with an int or a bool; [`LEAVE`] if there is no answer and
/// the machine has to determine the trap.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn ask_whole(
    context: *mut Context,
    question: i64,
    first: i64,
    second: i64,
) -> i64 {
    let answer = |_: &mut Context, run: &mut Run<'_>| {
        let mesh = &*run.mesh;
        let vertex = |id: i64| access::vertex(mesh, id as u32);
        let edge = || access::edge(mesh, first as u32);
        const DEGREE: i64 = Question::Degree as i64;
        const BOUNDARY_VERTEX: i64 = Question::BoundaryVertex as i64;
        const ADJACENT: i64 = Question::Adjacent as i64;
        const BOUNDARY_EDGE: i64 = Question::BoundaryEdge as i64;
        const LINK_CONDITION: i64 = Question::LinkCondition as i64;
        const STAR_SHAPED: i64 = Question::StarShaped as i64;
        const FACE_SIZE: i64 = Question::FaceSize as i64;
        let answer = match question {
            DEGREE => vertex(first).map(|v| mesh.degree(v) as i64),
            BOUNDARY_VERTEX => vertex(first).map(|v| mesh.is_boundary_vertex(v).into()),
            ADJACENT => vertex(second).and_then(|w| Ok(mesh.adjacent(vertex(first)?, w).into())),
            BOUNDARY_EDGE => edge().map(|e| mesh.is_boundary_edge(e).into()),
            LINK_CONDITION => edge().map(|e| mesh.link_condition(e).into()),
            STAR_SHAPED => edge().map(|e| mesh.kernel_centroid(e).is_some().into()),
            FACE_SIZE => access::face(mesh, first as u32).map(|f| mesh.face_size(f) as i64),
            _ => Ok(LEAVE),
        };
        Ok(answer.unwrap_or(LEAVE))
    };
    // SAFETY: as for all stubs.
    unsafe { within_unsettled(context, guarded(answer)) }
}

/// Computes with vectors and matrices, from registers in the window into the window.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn compute(context: *mut Context, inst: i64) -> i64 {
    let compute = |context: &mut Context, run: &mut Run<'_>| {
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
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, compute) }
}

/// The number of living elements of a kind.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn count(context: *mut Context, kind: i64) -> i64 {
    let count = |_: &mut Context, run: &mut Run<'_>| {
        let kind = ElementKind::ALL.get(kind as usize);
        Ok(kind.map_or(0, |&kind| run.mesh.count(kind) as i64))
    };
    // SAFETY: as for all stubs.
    unsafe { within(context, count) }
}

/// Executes an instruction on the machine that native code has found to trap.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn fault(context: *mut Context, inst: i64) {
    // SAFETY: as for all stubs.
    let answer = unsafe { step(context, inst | 1 << 32) };
    if answer != LEAVE {
        let say = |_: &mut Context, _: &mut Run<'_>| Err(Trap::new(Message::Malformed));
        // SAFETY: as for all stubs.
        unsafe { within(context, say) };
    }
}

/// Appends new elements, their numbers in 16 bits for each kind, and stores the first of each;
/// [`LEAVE`], with nothing done, if [`add`] has to add them.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn append(context: *mut Context, counts: i64) -> i64 {
    let counts = [0, 16, 32, 48].map(|shift| (counts as u64 >> shift) as usize & 0xffff);
    let append = |context: &mut Context, run: &mut Run<'_>| match context.append(run, counts) {
        true => Ok(0),
        false => Ok(LEAVE),
    };
    // SAFETY: as for all stubs.
    unsafe { within_unsettled(context, guarded(append)) }
}

/// Adds elements: executes the instructions from the one in the lower half of `span` up to, but
/// without, that in its upper half, which write to the window.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn add(context: *mut Context, span: i64) -> i64 {
    let take = |context: &mut Context, run: &mut Run<'_>| {
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
    };
    // SAFETY: as for all stubs.
    unsafe { within_guarded(context, take) }
}

/// Executes instructions that erase elements, from the one in the lower half of `span` up to, but
/// without, that in its upper half; [`LEAVE`] if one fails and the machine has to determine the
/// trap.
///
/// # Safety
/// As for all stubs.
pub(super) unsafe extern "C" fn erase(context: *mut Context, span: i64) -> i64 {
    let erase = |context: &mut Context, run: &mut Run<'_>| {
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
    };
    // SAFETY: as for all stubs.
    unsafe { within_unsettled(context, guarded(erase)) }
}

pub(super) extern "C" fn min(left: f64, right: f64) -> f64 {
    left.min(right)
}

pub(super) extern "C" fn max(left: f64, right: f64) -> f64 {
    left.max(right)
}

pub(super) extern "C" fn pow(left: f64, right: f64) -> f64 {
    left.powf(right)
}

pub(super) extern "C" fn atan2(left: f64, right: f64) -> f64 {
    left.atan2(right)
}

/// The stub of a function of one real that is not an instruction of the processor.
pub(super) fn function(function: Math) -> extern "C" fn(f64) -> f64 {
    macro_rules! stub {
        ($name:ident) => {{
            extern "C" fn stub(x: f64) -> f64 {
                math(Math::$name, x)
            }
            stub
        }};
    }
    match function {
        Math::Sqrt => stub!(Sqrt),
        Math::Sin => stub!(Sin),
        Math::Cos => stub!(Cos),
        Math::Tan => stub!(Tan),
        Math::Asin => stub!(Asin),
        Math::Acos => stub!(Acos),
        Math::Exp => stub!(Exp),
        Math::Log => stub!(Log),
        Math::Floor => stub!(Floor),
        Math::Ceil => stub!(Ceil),
        Math::Abs => stub!(Abs),
        Math::Negate => stub!(Negate),
    }
}

/// Replaces the vector at `place` by its direction.
///
/// # Safety
/// `place` points to three reals, to which there is no other reference.
pub(super) unsafe extern "C" fn normalize(place: *mut [f64; 3]) {
    // SAFETY: native code passes the address of a place of that size in its own frame.
    let vector = unsafe { &mut *place };
    *vector = direction((*vector).into()).to_array();
}

/// Balances the vector at `place`.
///
/// # Safety
/// As for [`normalize`].
pub(super) unsafe extern "C" fn balance(place: *mut [f64; 3]) {
    // SAFETY: native code passes the address of a place of that size in its own frame.
    let vector = unsafe { &mut *place };
    *vector = balanced((*vector).into()).to_array();
}
