//! Calls of one operation, from outside of any script.

use std::sync::Arc;

use super::columns::Columns;
use super::report::{Failure, diagnostic, expect_level, level_for_steps};
use super::steps::with_steps;
use super::{Argument, Report, prepare};
use crate::diagnostic::Diagnostic;
use crate::mesh::{ElementKind, Mesh, Value, validate_level};
use crate::resolve::{Program, Script, Variable};
use crate::rewrite::{Machine, Message, Outcome, Plan, Trap, Unwatched, Watch};
use crate::source::Span;

/// What became of a call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Applied {
    /// The operation has been applied.
    Done {
        /// What it returned.
        result: Option<(ElementKind, u32)>,
        /// What it created, in that order.
        created: Vec<(ElementKind, u32)>,
    },
    /// It does not apply here, and the mesh is as it was; the reason.
    Refused(String),
}

/// Reads the arguments of an operation, each a name and a text; see [`apply`].
///
/// # Errors
/// One diagnostic for each argument that does not fit, and for each that is missing.
pub fn arguments(
    program: &Program,
    op: usize,
    texts: &[(String, String)],
) -> Result<Vec<(String, Argument)>, Vec<Diagnostic>> {
    prepare(&parameters_alone(program, op), 0, &[])?.arguments(texts)
}

/// The attributes that an operation uses and that are not scratch: what it would take from a
/// file. None if the operation is not proved.
pub fn attributes(
    program: &Program,
    op: usize,
    plans: &[Option<Plan>],
) -> Vec<(ElementKind, String, Value)> {
    let plan = plans.get(op).and_then(Option::as_ref);
    let columns = plan.map(|plan| columns(program, plan, plans));
    let columns = columns.and_then(Result::ok).unwrap_or_default();
    let public = columns.public();
    public.map(|(kind, name, default)| (kind, name.to_owned(), default)).collect()
}

/// The columns that an operation and its steps need.
fn columns(program: &Program, plan: &Plan, plans: &[Option<Plan>]) -> Result<Columns, Diagnostic> {
    let used = with_steps(plans, [plan]);
    let used = used.into_iter().map(|plan| &plan.code);
    Columns::of(&program.attributes, used)
}

/// Applies an operation of a program, all of whose plans are given. Parameters that are not
/// given take their defaults.
///
/// # Errors
/// The arguments do not fit the parameters, or an expression of the operation has no value
/// here; the mesh is as it was.
pub fn apply(
    program: &Program,
    op: usize,
    plans: &[Option<Plan>],
    mesh: &mut Mesh,
    arguments: &[(String, Argument)],
) -> Result<Applied, Box<Failure>> {
    let application = Application::new(program, op, plans).map_err(failure)?;
    application.apply(mesh, arguments, &mut Unwatched)
}

/// An operation of a program, to be applied to any number of meshes.
#[derive(Clone, Debug)]
pub struct Application<'p> {
    op: usize,
    plans: &'p [Option<Plan>],
    plan: &'p Plan,
    parameters: Program,
    columns: Columns,
    place: Span,
}

impl<'p> Application<'p> {
    /// The operation of this number, with the plans of all.
    ///
    /// # Errors
    /// It is not proved, or the default of an attribute has no value.
    pub fn new(
        program: &Program,
        op: usize,
        plans: &'p [Option<Plan>],
    ) -> Result<Self, Diagnostic> {
        let place = program.ops.get(op).map(|op| match &op.diagram {
            Some(diagram) => diagram.name_span,
            None => op.span,
        });
        let place = place.unwrap_or_default();
        let Some(plan) = plans.get(op).and_then(Option::as_ref) else {
            let message = "this operation is not proved, so it cannot run";
            return Err(Diagnostic::error("unproved-op", message, place));
        };
        Ok(Self {
            op,
            plans,
            plan,
            parameters: parameters_alone(program, op),
            columns: columns(program, plan, plans)?,
            place,
        })
    }

    /// Applies it, while somebody looks on. Parameters that are not given take their defaults.
    ///
    /// # Errors
    /// As of [`apply`]; or it was interrupted, and the mesh is as it was.
    pub fn apply(
        &self,
        mesh: &mut Mesh,
        arguments: &[(String, Argument)],
        watch: &mut dyn Watch,
    ) -> Result<Applied, Box<Failure>> {
        let Self { plans, plan, .. } = *self;
        expect_level(plan, mesh, self.place).map_err(failure)?;
        let prepared = prepare(&self.parameters, 0, &[]);
        let prepared = prepared.map_err(|mut errors| failure(errors.remove(0)))?;
        let mut code = prepared.code().clone();
        let slots = prepared.slots(mesh, arguments, &mut code.texts).map_err(failure)?;
        let mut machine = Machine::new(plans);
        machine.trust_level(level_for_steps(plans, &[self.op], plan.level, mesh));
        machine.use_columns(self.columns.bind(mesh).map_err(failure)?);
        machine.remember_created();
        let trapped = |trap: Trap| failure(diagnostic(&prepared, trap));
        machine.run(mesh, &code, &slots, watch).map_err(trapped)?;
        let slots = machine.window().to_vec();
        let outcome = machine
            .apply_watched(mesh, plan, &slots, watch)
            .map_err(|trap| failure(in_plan(plan, trap, &prepared, mesh)));
        self.columns.release(mesh);
        Ok(match outcome? {
            Outcome::Applied { result } => {
                let created = machine.created().to_vec();
                Applied::Done { result: plan.result.zip(result), created }
            }
            Outcome::Refused { reason } => {
                let known = reason.and_then(|reason| plan.refusals.get(usize::from(reason)));
                let reason = known.map_or("the diagram does not match here", |known| &known.reason);
                Applied::Refused(reason.to_owned())
            }
        })
    }
}

fn failure(diagnostic: Diagnostic) -> Box<Failure> {
    Box::new(Failure { diagnostic, report: Report::default() })
}

/// A script that has the parameters of an operation, and does nothing: running it leaves
/// their values in the window.
fn parameters_alone(program: &Program, op: usize) -> Program {
    let scripts = program.ops.get(op).map(|op| Script {
        name: op.name.clone(),
        span: op.span,
        docs: Vec::new(),
        params: op.params.clone(),
        variables: op
            .params
            .iter()
            .map(|param| Variable { name: param.name.clone(), ty: param.ty, span: param.span })
            .collect(),
        body: Vec::new(),
    });
    Program {
        attributes: Arc::clone(&program.attributes),
        functions: program.functions.clone(),
        scripts: scripts.into_iter().collect(),
        ..Program::default()
    }
}

/// A trap in the code of the operation itself, at its place there. The mesh is as it was.
fn in_plan(plan: &Plan, trap: Trap, prepared: &super::Prepared, mesh: &Mesh) -> Diagnostic {
    let place = trap.trace.first().and_then(|site| plan.places.get(site.place? as usize)).copied();
    if let (Message::BelowLevel { op, level, why, .. }, Some(place)) = (&trap.message, place) {
        let name = &plan.name;
        return match validate_level(mesh, *level) {
            Err(below) => {
                let message = format!(
                    "`{op}`, a step of `{name}`, is for meshes of level {level}, and this one is not"
                );
                Diagnostic::error("below-level", message, place).note(below.to_string())
            }
            Ok(()) => {
                Diagnostic::error("below-level", trap.message.to_string(), place).note(why.clone())
            }
        };
    }
    let message = trap.message.to_string();
    match place {
        Some(span) => Diagnostic::error("run-time-error", message, span),
        None => diagnostic(prepared, trap),
    }
}
