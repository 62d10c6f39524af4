//! Running a prepared script, and the report on the run.

use super::steps::with_steps;
use super::{Argument, Prepared};
use crate::diagnostic::{Diagnostic, all_of};
use crate::mesh::{ElementKind, Level, Mesh, level_of_polygons, validate_level};
use crate::rewrite::{Count, Inst, Machine, Message, Plan, Site, Trap, Watch};
use crate::source::Span;

/// The report on a script.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// One entry for each operation that it may call, in the order of the program.
    pub ops: Vec<OpReport>,
}

/// The report on the calls of an operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OpReport {
    /// The name of the operation.
    pub name: String,
    /// The number of calls that were applied.
    pub applied: u64,
    /// The number of calls that were refused, by reason: the reasons that occurred, in the order in
    /// which the operation tests them.
    pub refused: Vec<(String, u64)>,
}

/// A script that failed before its end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The reason and the place, with the calls that led there as labels.
    pub diagnostic: Diagnostic,
    /// The report up to that point.
    pub report: Report,
}

/// A failure before anything was done.
pub(super) fn failure(diagnostic: Diagnostic) -> Box<Failure> {
    Box::new(Failure { diagnostic, report: Report::default() })
}

/// Runs a script on a mesh. Printed lines go to the watcher.
///
/// # Errors
/// The arguments do not fit the parameters, and nothing has been done; or the script failed at some
/// point, and the mesh is as it was there.
pub fn run(
    prepared: &Prepared,
    mesh: &mut Mesh,
    arguments: &[(String, Argument)],
    watch: &mut dyn Watch,
) -> Result<Report, Box<Failure>> {
    run_with(prepared, mesh, arguments, Vec::new(), watch)
}

/// [`run`] with the meshes that a test refers to by number.
pub(super) fn run_with(
    prepared: &Prepared,
    mesh: &mut Mesh,
    arguments: &[(String, Argument)],
    meshes: Vec<Mesh>,
    watch: &mut dyn Watch,
) -> Result<Report, Box<Failure>> {
    let mut code = prepared.code.clone();
    let slots = prepared.slots(mesh, arguments, &mut code.texts).map_err(failure)?;
    let columns = prepared.columns.bind(mesh).map_err(failure)?;
    let mut machine = Machine::new(&prepared.plans);
    machine.limit_memory(prepared.memory);
    machine.use_engine(prepared.engine);
    machine.seed(prepared.seed);
    if prepared.of_polygons {
        machine.begin_at_level(level_of_polygons(mesh, prepared.wanted()));
    }
    machine.use_columns(columns);
    machine.use_meshes(meshes);
    let outcome = machine.run(mesh, &code, &slots, watch);
    watch.compiled(machine.compiling());
    prepared.columns.release(mesh);
    let report = report(prepared, machine.counts());
    match outcome {
        Ok(_) => Ok(report),
        Err(trap) => {
            let diagnostic = diagnostic(prepared, trap, Some(&machine));
            Err(Box::new(Failure { diagnostic, report }))
        }
    }
}

/// The highest level of the given operations and of all that their steps call, at least `level`.
pub(super) fn level_of_steps(plans: &[Option<Plan>], called: &[usize], level: Level) -> Level {
    let called = called.iter().filter_map(|&op| plans.get(op)?.as_ref());
    with_steps(plans, called).iter().fold(level, |wanted, plan| wanted.max(plan.level))
}

/// The highest level that a mesh has, from one that it is known to have up to one that is wanted.
pub(crate) fn highest_between(mesh: &Mesh, level: Level, wanted: Level) -> Level {
    let mut levels = Level::ALL.into_iter().rev();
    let has = |&of: &Level| level < of && of <= wanted && validate_level(mesh, of).is_ok();
    levels.find(has).unwrap_or(level)
}

/// Checks that the mesh has the level that an operation is for.
pub(super) fn expect_level(plan: &Plan, mesh: &Mesh, place: Span) -> Result<(), Diagnostic> {
    if plan.level == Level::Map {
        return Ok(());
    }
    validate_level(mesh, plan.level).map_err(|below| {
        let (name, level) = (&plan.name, plan.level);
        let message = format!("`{name}` is for meshes of level {level}, and this one is not");
        Diagnostic::error("below-level", message, place).note(below.to_string())
    })
}

/// The report on the calls of the operations that a script calls.
pub(crate) fn report(prepared: &Prepared, counts: &[Count]) -> Report {
    let ops = prepared.called.iter().zip(&prepared.names).filter_map(|(&op, name)| {
        let plan = prepared.plans.get(op)?.as_ref()?;
        Some(op_report(name, plan, counts.get(op)?))
    });
    Report { ops: ops.collect() }
}

fn op_report(name: &str, plan: &Plan, count: &Count) -> OpReport {
    let mut refused: Vec<(String, u64)> = Vec::new();
    for (refusal, &times) in plan.refusals.iter().zip(&count.refused) {
        match refused.iter_mut().find(|(known, _)| *known == refusal.reason) {
            Some((_, sum)) => *sum += times,
            None => refused.push((refusal.reason.clone(), times)),
        }
    }
    refused.retain(|&(_, times)| times > 0);
    OpReport { name: name.to_owned(), applied: count.applied, refused }
}

/// The greatest number of calls shown as labels of a failure.
const MOST_CALLERS: usize = 8;

/// The diagnostic of a trap, at the innermost place that is known. The machine is that of the run, if
/// it was one of a script or a function.
pub(crate) fn diagnostic(prepared: &Prepared, trap: Trap, machine: Option<&Machine>) -> Diagnostic {
    let known: Vec<(&Site, Span)> =
        trap.trace.iter().filter_map(|site| Some((site, span(prepared, site)?))).collect();
    let (first, calls) = match known.split_first() {
        Some(((_, span), calls)) => (*span, calls),
        None => (prepared.span, known.as_slice()),
    };
    let mut diagnostic = Diagnostic::error(code(&trap), trap.to_string(), first);
    match &trap.message {
        Message::Asserted { values, .. } if !values.is_empty() => {
            diagnostic = diagnostic.note(values.clone());
        }
        Message::BelowLevel { why, .. } => diagnostic = diagnostic.note(why.clone()),
        Message::Gone(kind) => {
            let counts = machine.map_or(&[][..], Machine::counts);
            diagnostic.notes.extend(erased_by(prepared, *kind, counts));
        }
        Message::Interrupted => {
            let last = machine.and_then(Machine::last_refusal);
            let told = last.map(|(op, reason)| format!("`{op}` was the last to refuse: {reason}"));
            diagnostic.notes.extend(told);
        }
        _ => {}
    }
    let mut told = vec![first];
    for (_, span) in calls {
        if told.len() <= MOST_CALLERS && !told.contains(span) {
            told.push(*span);
            diagnostic = diagnostic.label(*span, "called here");
        }
    }
    if calls.len() > MOST_CALLERS {
        diagnostic = diagnostic.note(format!("{} calls led here", calls.len()));
    }
    let unknown = |site: &&Site| site.op.is_some() && span(prepared, site).is_none();
    match trap.trace.iter().find(unknown).and_then(|site| name(prepared, site)) {
        Some(name) => diagnostic.note(format!("it happened inside of `{name}`")),
        None => diagnostic,
    }
}

/// The operations that were applied in the run and erase elements of a kind.
fn erased_by(prepared: &Prepared, kind: ElementKind, counts: &[Count]) -> Option<String> {
    let is_applied = |op: usize| counts.get(op).is_some_and(|count| count.applied > 0);
    let called = prepared.called.iter().zip(&prepared.names);
    let ops = called.filter(|&(&op, _)| is_applied(op) && erases(&prepared.plans, op, kind));
    let ops: Vec<_> = ops.map(|(_, name)| format!("`{name}`")).collect();
    let erase = if ops.len() == 1 { "erases" } else { "erase" };
    (!ops.is_empty()).then(|| format!("{} {erase} {}", all_of(ops), kind.plural()))
}

/// True if an operation, or one that its steps call, erases elements of a kind.
fn erases(plans: &[Option<Plan>], op: usize, kind: ElementKind) -> bool {
    let plans = with_steps(plans, plans.get(op).and_then(Option::as_ref));
    let mut insts = plans.iter().flat_map(|plan| &plan.code.insts);
    insts.any(|inst| matches!(inst, Inst::Erase { kind: of, .. } if *of == kind))
}

fn plan<'p>(prepared: &'p Prepared, site: &Site) -> Option<&'p Plan> {
    prepared.plans.get(usize::from(site.op?))?.as_ref()
}

fn name<'p>(prepared: &'p Prepared, site: &Site) -> Option<&'p str> {
    plan(prepared, site).map(|plan| plan.name.as_str())
}

fn span(prepared: &Prepared, site: &Site) -> Option<Span> {
    let places = match (site.function, site.op) {
        (Some(function), _) => {
            let functions = &prepared.functions.code;
            &functions.get(usize::from(function))?.places
        }
        (None, Some(_)) => &plan(prepared, site)?.places,
        (None, None) => &prepared.places,
    };
    places.get(site.place? as usize).copied()
}

/// The stable code of a failure.
pub(super) fn code(trap: &Trap) -> &'static str {
    match &trap.message {
        Message::Gone(_) => "element-gone",
        Message::Missing(_) => "no-element",
        Message::NothingToChoose => "nothing-to-choose",
        Message::DivisionByZero => "division-by-zero",
        Message::IntOverflow | Message::RoundsNaN | Message::KeyTooLarge => "int-overflow",
        Message::NotFinite => "not-finite",
        Message::KeyNotANumber => "key-not-a-number",
        Message::NoRoom(_) | Message::NoMemory(_) => "no-room",
        Message::Endless => "broken-mesh",
        Message::Failed(_) => "aggregate-of-nothing",
        Message::Asserted { .. } => "assertion-failed",
        Message::Refused { .. } => "op-refused",
        Message::BelowLevel { .. } => "below-level",
        Message::Unproved => "unproved-op",
        Message::Interrupted => "interrupted",
        Message::TooDeep => "calls-too-deep",
        Message::WildPointer(_) | Message::OutOfRange | Message::Malformed => "machine-error",
    }
}
