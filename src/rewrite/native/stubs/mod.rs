//! Stubs: the functions of the machine that native code calls.
//!
//! Each takes the context of the call. No panic unwinds into native code: a panic of a stub that
//! may panic is caught, and resumed when native code has been left; the others do not panic.

pub(super) mod calls;
mod drains;
mod guards;
mod lists;
mod machine;
mod writes;

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::rewrite::arithmetic::{balance as balanced, direction, math};
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{Math, Message, Trap};

pub(super) use drains::NONE;
pub(super) use guards::{BITS, MOST_ASKED};

/// The answer of a stub if native code has to be left: the trap is in the run.
pub(super) const LEAVE: i64 = -1;

/// The answer of a stub, or the trap by which native code is left.
type Answer = Result<i64, Trap>;

/// Defines a stub for each function of a context and its run: by what it does, one of [`settled`],
/// [`unsettled`], [`guarded`] and [`anything`].
macro_rules! stubs {
    ($($module:ident::$name:ident($($argument:ident: $type:ty),*), $way:ident;)*) => {$(
        /// # Safety
        /// Native code calls it with its context.
        pub(super) unsafe extern "C" fn $name(
            context: *mut Context
            $(, $argument: $type)*
        ) -> i64 {
            let act = $way(|context, run| $module::$name(context, run $(, $argument)*));
            // SAFETY: native code passes on the context that it was entered with.
            unsafe { enter(context, act) }
        }
    )*};
}

stubs! {
    machine::step(span: i64), anything;
    machine::tick(inst: i64), guarded;
    machine::iteration(inst: i64), guarded;
    machine::answer(inst: i64), unsettled;
    machine::ask_whole(question: i64, first: i64, second: i64), unsettled;
    machine::compute(inst: i64), guarded;
    machine::count(kind: i64), settled;
    machine::append(counts: i64), unsettled;
    machine::add(span: i64), guarded;
    machine::erase(span: i64), unsettled;
    calls::call(inst: i64), anything;
    calls::left(inst: i64), settled;
    calls::refused(op: i64), settled;
    drains::next_stale(), guarded;
    drains::set_key(inst: i64, key: f64), guarded;
    drains::least(), guarded;
    drains::take_least(), guarded;
    guards::set_preview(span: i64), guarded;
    guards::clear_preview(), settled;
    guards::foresee(condition: i64, element: i64, at: i64), guarded;
    guards::foresee_star(conditions: i64, vertex: i64, inst: i64), guarded;
    lists::begin_lists(), guarded;
    lists::fill(inst: i64), unsettled;
    lists::are_distinct(buffer: i64), guarded;
    lists::push(buffer: i64, bits: i64), guarded;
    lists::prefetch(which: i64, index: i64), guarded;
    lists::collect(which: i64, from: i64, until: i64), guarded;
    lists::hold(which: i64, header: i64, element: i64), guarded;
    writes::pointer_set(field: i64, halfedge: i64, value: i64), guarded;
    writes::first_set(of: i64, element: i64, value: i64), guarded;
    writes::position_set(vertex: i64), guarded;
    writes::value_set(number: i64, element: i64), guarded;
}

/// Calls a closure with a context and its run.
///
/// # Safety
/// The context is one that the machine has made for native code that runs.
#[inline]
unsafe fn enter(
    context: *mut Context,
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Answer,
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

/// A stub that does not panic.
#[inline]
fn settled(
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Answer,
) -> impl FnOnce(&mut Context, &mut Run<'_>) -> Answer {
    |context, run| {
        context.settle(run);
        act(context, run)
    }
}

/// A stub that may panic and accesses no more of the mesh than what elements that it is given lead
/// to, so that the tables may keep their spare slots.
#[inline]
fn unsettled(
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Answer,
) -> impl FnOnce(&mut Context, &mut Run<'_>) -> Answer {
    |context, run| {
        catch_unwind(AssertUnwindSafe(|| act(context, run))).unwrap_or_else(|panic| {
            run.panic = Some(panic);
            Ok(LEAVE)
        })
    }
}

/// A stub that may panic.
#[inline]
fn guarded(
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Answer,
) -> impl FnOnce(&mut Context, &mut Run<'_>) -> Answer {
    settled(unsettled(act))
}

/// A stub that may do anything: afterwards the context is updated.
#[inline]
fn anything(
    act: impl FnOnce(&mut Context, &mut Run<'_>) -> Answer,
) -> impl FnOnce(&mut Context, &mut Run<'_>) -> Answer {
    settled(|context, run| {
        run.count_frames(context);
        let answer = unsettled(act)(context, run);
        context.refresh(run);
        answer
    })
}

/// The trap of an instruction of the running code.
#[cold]
pub(super) fn failed(context: &Context, run: &Run<'_>, inst: i64, message: Message) -> Trap {
    let call = context.call(run);
    let about = run.machine.about(&call, inst as usize);
    Trap { about, ..Trap::new(message) }.through(&call, inst as usize)
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
        unsafe { enter(context, settled(say)) };
    }
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
