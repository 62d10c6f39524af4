//! Lowering of operations in steps to plans.
//!
//! Their code is like that of a function, but it refuses where a `must` or a `require` does not
//! hold, and the machine then undoes its steps.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::function::Functions;
use super::lower::{Lowering, Routine};
use crate::compile::width;
use crate::diagnostic::Diagnostic;
use crate::diagram::Property;
use crate::lower::Effects;
use crate::mesh::Level;
use crate::resolve::{Program, ResolvedOp};
use crate::rewrite::{self, BELOW, Code, Phase, Plan, Refusal, TooLarge};

/// The greatest number of reasons to refuse that an operation in steps can have, with those of all
/// that it calls: each has its own list of them.
const MOST_REFUSALS: usize = 1024;

/// Makes the plans of the operations in steps of a program, and adds them to the plans of the
/// others. An operation that calls one without a plan, or a function without code, gets none.
/// `drawn` gives the properties that a drawn operation keeps.
///
/// # Errors
/// One diagnostic for each operation that calls itself, directly or indirectly, for each that is
/// too large, and for each property that one claims to keep and does not.
pub fn plan_steps(
    program: &Program,
    functions: &Functions,
    drawn: impl Fn(usize) -> Vec<Property>,
    plans: &mut [Option<Plan>],
) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    let mut kept = BTreeMap::new();
    let mut left = calls_of_steps(program, functions);
    for number in called_first(&left) {
        let Some(calls) = left.remove(&number) else { continue };
        let op = &program.ops[number];
        match plan(op, &calls, functions, plans) {
            Ok(Some(plan)) => {
                let of_calls = calls.iter().map(|&called| {
                    let keeps = kept.get(&called).cloned().unwrap_or_else(|| drawn(called));
                    (program.ops[called].name.as_str(), keeps)
                });
                let claims = Claims { plan: &plan, calls: of_calls.collect() };
                let keeps = claims.kept();
                let broken = claims.broken(op, &keeps);
                kept.insert(number, keeps);
                plans[number] = broken.is_empty().then_some(plan);
                diagnostics.extend(broken);
            }
            Ok(None) => {}
            Err(TooLarge) => diagnostics.push(too_large(op)),
        }
    }
    let on_cycle = left.keys().filter(|&&number| leads_back(&left, number));
    diagnostics.extend(on_cycle.map(|&number| calls_itself(&program.ops[number])));
    diagnostics
}

/// The properties of an operation in steps: its plan, and what each operation that it calls keeps.
struct Claims<'c> {
    plan: &'c Plan,
    calls: Vec<(&'c str, Vec<Property>)>,
}

impl Claims<'_> {
    /// The first operation that it calls and that does not keep a property.
    fn breaks(&self, property: Property) -> Option<&str> {
        self.calls.iter().find(|(_, keeps)| !keeps.contains(&property)).map(|(name, _)| *name)
    }

    /// The properties that it keeps: those that all its steps keep, and the level of its guard.
    fn kept(&self) -> Vec<Property> {
        let keeps = |property: &Property| match property {
            Property::Level(level) => self.plan.keeps.contains(level),
            Property::ConstantTime => false,
            _ => self.breaks(*property).is_none(),
        };
        Property::ALL.into_iter().filter(keeps).collect()
    }

    /// The errors for the properties that it claims to keep and that are not among those kept.
    fn broken(&self, op: &ResolvedOp, kept: &[Property]) -> Vec<Diagnostic> {
        let claimed = op.steps.iter().flat_map(|steps| &steps.keeps);
        let broken = claimed.filter(|(property, _)| !kept.contains(property));
        let told = broken.map(|&(property, span)| {
            let word = property.word();
            let message = format!("`{}` does not keep `{word}`", op.name);
            let step = self.breaks(property).unwrap_or_default();
            let note = match property {
                Property::ConstantTime => "how many steps it takes is not known".to_owned(),
                Property::Level(_) => {
                    format!("`{step}` does not keep it; `guard {word}` tests it after the steps")
                }
                _ => format!("`{step}` does not keep it"),
            };
            Diagnostic::error("property-not-kept", message, span).note(note)
        });
        told.collect()
    }
}

/// Whether the calls of an operation lead back to it.
fn leads_back(all: &BTreeMap<usize, BTreeSet<usize>>, number: usize) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![number];
    while let Some(calls) = open.pop().and_then(|at| all.get(&at)) {
        if calls.contains(&number) {
            return true;
        }
        open.extend(
            calls.iter().filter(|&&called| all.contains_key(&called) && seen.insert(called)),
        );
    }
    false
}

/// The operations that are on no cycle of calls and call none that is, in topological order: each
/// after all that it calls.
fn called_first(all: &BTreeMap<usize, BTreeSet<usize>>) -> Vec<usize> {
    let mut waits: BTreeMap<usize, usize> = BTreeMap::new();
    let mut callers: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut order = Vec::new();
    for (&number, calls) in all {
        let calls = calls.iter().filter(|called| all.contains_key(called));
        let mut count = 0;
        for &called in calls {
            callers.entry(called).or_default().push(number);
            count += 1;
        }
        if count == 0 {
            order.push(number);
        }
        waits.insert(number, count);
    }
    let mut at = 0;
    while let Some(&done) = order.get(at) {
        at += 1;
        for caller in callers.remove(&done).into_iter().flatten() {
            if let Some(count) = waits.get_mut(&caller) {
                *count -= 1;
                if *count == 0 {
                    order.push(caller);
                }
            }
        }
    }
    order
}

/// The operations that each operation in steps of a program calls, itself or through functions, by
/// number.
pub fn calls_of_steps(
    program: &Program,
    functions: &Functions,
) -> BTreeMap<usize, BTreeSet<usize>> {
    let steps = program.ops.iter().enumerate().filter_map(|(number, op)| {
        let effects = Effects::of_steps(op.steps.as_ref()?);
        let mut calls: BTreeSet<usize> = effects.ops.keys().copied().collect();
        let called: Vec<_> = effects.functions.iter().map(|&number| number as usize).collect();
        for function in functions.reached(&called) {
            calls.extend(functions.applies[function].iter().map(|&(op, _)| op));
        }
        Some((number, calls))
    });
    steps.collect()
}

/// The given plans, and those of all operations that their steps call, directly or indirectly.
pub(super) fn with_steps<'p>(
    plans: &'p [Option<Plan>],
    first: impl IntoIterator<Item = &'p Plan>,
) -> Vec<&'p Plan> {
    let mut all: Vec<&Plan> = first.into_iter().collect();
    let mut seen = BTreeSet::new();
    let mut at = 0;
    while let Some(plan) = all.get(at) {
        let calls = plan.steps.iter().flat_map(|steps| &steps.calls);
        let new: Vec<_> = calls.filter(|&&(op, _)| seen.insert(op)).collect();
        all.extend(new.iter().filter_map(|(op, _)| plans.get(usize::from(*op))?.as_ref()));
        at += 1;
    }
    all
}

/// The plan of an operation in steps; `None` if an operation that it calls has none, or a function
/// that it calls no code.
fn plan(
    op: &ResolvedOp,
    calls: &BTreeSet<usize>,
    functions: &Functions,
    plans: &[Option<Plan>],
) -> Result<Option<Plan>, TooLarge> {
    let Some(steps) = &op.steps else { return Ok(None) };
    let effects = Effects::of_steps(steps);
    let called: Vec<_> = effects.functions.iter().map(|&number| number as usize).collect();
    if functions.first_missing(&functions.reached(&called)).is_some() {
        return Ok(None);
    }
    let routine = Routine { params: &op.params, body: &steps.body };
    let mut lowering = Lowering::of_steps(routine, effects, functions.known());
    for require in &steps.requires {
        let mark = lowering.asm.mark();
        let condition = lowering.value(&require.condition);
        lowering.require(condition, &require.reason);
        lowering.asm.release(mark);
    }
    lowering.body(routine);
    lowering.end_of_steps();
    let mut refusals = lowering.refusals;
    let number = |place: usize| u16::try_from(place).map_err(|_| TooLarge);
    let mut first = Vec::new();
    let mut keeps = vec![Level::Surface, Level::Simple];
    for &called in calls {
        let Some(plan) = plans.get(called).and_then(Option::as_ref) else { return Ok(None) };
        // The mesh has the level of the guard at the end, and keeps what every step keeps.
        keeps.retain(|kept| *kept <= steps.level || plan.keeps.contains(kept));
        first.push((number(called)?, number(refusals.len())?));
        refusals.extend(plan.refusals.iter().map(|refusal| within(plan, refusal)));
        if refusals.len() > MOST_REFUSALS {
            return Err(TooLarge);
        }
    }
    let below = number(refusals.len())?;
    let guard = |reason: &str| Refusal { reason: reason.to_owned(), phase: Phase::Guard };
    refusals.extend(BELOW.map(guard));
    number(refusals.len())?;
    Ok(Some(Plan {
        matched: Vec::new(),
        name: op.name.clone(),
        params: op.params.iter().map(|param| width(param.ty)).collect(),
        of: op.params.first().and_then(|param| param.ty.element_kind()),
        result: op.result.and_then(|ty| ty.element_kind()),
        level: steps.level,
        keeps,
        code: Code { functions: Arc::clone(&functions.code), ..lowering.asm.finish()? },
        places: lowering.names.places,
        refusals,
        stages: Vec::new(),
        steps: Some(rewrite::Steps { calls: first, below }),
    }))
}

/// The refusal of a step as a refusal of the whole operation. A reason that refers to the drawing
/// of the step gets the step's name, since it is clear only beside that drawing.
fn within(step: &Plan, refusal: &Refusal) -> Refusal {
    let Refusal { reason, phase } = refusal;
    let is_drawn = matches!(phase, Phase::Match | Phase::Guard) && step.steps.is_none();
    Refusal {
        reason: if is_drawn { format!("in `{}`, {reason}", step.name) } else { reason.clone() },
        phase: *phase,
    }
}

fn too_large(op: &ResolvedOp) -> Diagnostic {
    let message = format!("`{}` is too large to compile", op.name);
    Diagnostic::error("too-large", message, op.span).note(format!(
        "its steps, and those of what they call, can refuse for more than {MOST_REFUSALS} reasons: \
         call fewer operations, or take the steps in a script"
    ))
}

fn calls_itself(op: &ResolvedOp) -> Diagnostic {
    let message = format!("the steps of `{}` lead back to it", op.name);
    Diagnostic::error("cyclic-steps", message, op.span)
        .note("what is done over and over stands in a loop")
}
