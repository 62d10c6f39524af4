//! Applying a single operation, without a script.

use std::sync::{Arc, OnceLock};

use super::columns::Columns;
use super::report::{
    Failure, code, diagnostic, expect_level, failure, highest_between, level_of_steps,
};
use super::steps::with_steps;
use super::{Argument, Prepared, prepare};
use crate::compile::width;
use crate::diagnostic::Diagnostic;
use crate::diagram::Param;
use crate::mesh::{ElementKind, Level, Mesh, Value, validate_level};
use crate::resolve::{Body, Program, Script, Variable};
use crate::rewrite::{
    Bounded, Engine, Machine, Message, Outcome, Plan, Plans, Site, Trap, Unwatched, Watch,
};
use crate::source::Span;

/// The outcome of a call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Applied {
    /// The operation has been applied.
    Done {
        /// The element it returned.
        result: Option<(ElementKind, u32)>,
        /// The elements it created, in the order of creation.
        created: Vec<(ElementKind, u32)>,
    },
    /// The operation was refused, for this reason, and the mesh is as it was.
    Refused(String),
}

/// Parses the arguments of an operation, each a name and a text; see [`apply`].
///
/// # Errors
/// One diagnostic for each argument that does not fit, and for each that is missing.
pub fn arguments(
    program: &Program,
    op: usize,
    texts: &[(String, String)],
) -> Result<Vec<(String, Argument)>, Vec<Diagnostic>> {
    prepare(&parameters_alone(program, op), 0, &Plans::default())?.arguments(texts)
}

/// The attributes that an operation uses, without scratch attributes: those that it would read from
/// a file. Empty if the operation is not proved.
pub fn attributes(
    program: &Program,
    op: usize,
    plans: &Plans,
) -> Vec<(ElementKind, String, Value)> {
    let plan = plans.get(op).and_then(Option::as_ref);
    let columns = plan.map(|plan| columns(program, plan, plans));
    let columns = columns.and_then(Result::ok).unwrap_or_default();
    let public = columns.public();
    public.map(|(kind, name, default)| (kind, name.to_owned(), default)).collect()
}

/// The columns that an operation and its steps need.
fn columns(program: &Program, plan: &Plan, plans: &[Option<Plan>]) -> Result<Columns, Diagnostic> {
    let used = with_steps(plans, [plan]).into_iter().map(|plan| &plan.code);
    Columns::of(&program.attributes, used)
}

/// Applies an operation of a program, given the plans of all its operations. Parameters without an
/// argument take their defaults.
///
/// # Errors
/// The arguments do not fit the parameters, or an expression of the operation has no value
/// here; the mesh is as it was.
pub fn apply(
    program: &Program,
    op: usize,
    plans: &Plans,
    mesh: &mut Mesh,
    arguments: &[(String, Argument)],
) -> Result<Applied, Box<Failure>> {
    Application::new(program, op, plans).map_err(failure)?.apply(mesh, arguments, &mut Unwatched)
}

/// An operation of a program, to be applied to any number of meshes.
#[derive(Clone, Debug)]
pub struct Application {
    op: usize,
    plans: Plans,
    /// Its parameters, as those of a script that does nothing: see [`parameters_alone`].
    parameters: Prepared,
    columns: Columns,
    /// The level that a mesh should have for all that its steps call.
    wanted: Level,
    place: Span,
    /// By parameter, the question whether the operation would be applied, if its paths are bounded.
    questions: Vec<OnceLock<Option<Arc<Bounded>>>>,
}

impl Application {
    /// The operation with this number, with the plans of all operations.
    ///
    /// # Errors
    /// The operation is not proved, or the default of an attribute has no value.
    pub fn new(program: &Program, op: usize, plans: &Plans) -> Result<Self, Diagnostic> {
        let place = program.ops.get(op).map(|op| match &op.diagram {
            Some(diagram) => diagram.name_span,
            None => op.span,
        });
        let place = place.unwrap_or_default();
        let Some(plan) = plans.get(op).and_then(Option::as_ref) else {
            let message = "this operation is not proved, so it cannot run";
            return Err(Diagnostic::error("unproved-op", message, place));
        };
        let parameters = prepare(&parameters_alone(program, op), 0, &Plans::default());
        let parameters = parameters.map_err(|mut errors| errors.remove(0))?;
        Ok(Self {
            op,
            plans: Plans::clone(plans),
            questions: vec![OnceLock::new(); parameters.params().len()],
            parameters,
            columns: columns(program, plan, plans)?,
            wanted: level_of_steps(plans, &[op], plan.level),
            place,
        })
    }

    /// Sets the engine that runs it.
    pub fn use_engine(&mut self, engine: Engine) {
        self.parameters.use_engine(engine);
    }

    /// Its parameters, as those of a script that does nothing.
    pub(crate) fn parameters(&self) -> &Prepared {
        &self.parameters
    }

    /// The columns that it needs.
    pub(crate) fn columns(&self) -> &Columns {
        &self.columns
    }

    /// The level that a mesh should have for all that its steps call.
    pub(crate) fn wanted(&self) -> Level {
        self.wanted
    }

    /// Checks that a mesh has the level that the operation is for.
    pub(crate) fn expect_level(&self, mesh: &Mesh) -> Result<(), Diagnostic> {
        expect_level(self.plan(), mesh, self.place)
    }

    /// The question whether the operation would be applied, for the element that is passed for a
    /// parameter; `None` if its paths are not bounded.
    pub(crate) fn question(&self, parameter: usize) -> Option<Arc<Bounded>> {
        let made = self.questions.get(parameter)?.get_or_init(|| {
            let params = self.parameters.params();
            let kind = params[parameter].ty.element_kind()?;
            let slot = params[..parameter].iter().map(|param| usize::from(width(param.ty))).sum();
            Bounded::new(self.plan(), kind, slot).ok().map(Arc::new)
        });
        made.clone()
    }

    pub fn plan(&self) -> &Plan {
        self.plans[self.op].as_ref().expect("only a proved operation is applied")
    }

    /// Applies it, and reports to a watcher. Parameters without an argument take their defaults.
    ///
    /// # Errors
    /// As for [`apply`]; or it was interrupted, and the mesh is as it was.
    pub fn apply(
        &self,
        mesh: &mut Mesh,
        arguments: &[(String, Argument)],
        watch: &mut dyn Watch,
    ) -> Result<Applied, Box<Failure>> {
        let plan = self.plan();
        expect_level(plan, mesh, self.place).map_err(failure)?;
        let mut code = self.parameters.code().clone();
        let slots = self.parameters.slots(mesh, arguments, &mut code.texts).map_err(failure)?;
        let mut machine = Machine::new(&self.plans);
        machine.trust_level(highest_between(mesh, plan.level, self.wanted));
        machine.use_columns(self.columns.bind(mesh).map_err(failure)?);
        machine.use_engine(self.parameters.engine);
        machine.remember_created();
        let trapped = |trap| failure(self.told_of_parameters(trap));
        machine.run(mesh, &code, &slots, watch).map_err(trapped)?;
        let slots = machine.window().to_vec();
        let outcome = machine.apply_watched(mesh, plan, &slots, watch);
        self.columns.release(mesh);
        Ok(match outcome.map_err(|trap| failure(self.told(trap, mesh)))? {
            Outcome::Applied { result } => {
                let created = machine.created().to_vec();
                Applied::Done { result: plan.result.zip(result), created }
            }
            Outcome::Refused { reason } => {
                let known = reason.and_then(|reason| plan.refusals.get(usize::from(reason)));
                Applied::Refused(known.map_or(UNKNOWN_REASON, |known| &known.reason).to_owned())
            }
        })
    }

    /// The diagnostic of a trap in the code of its parameters.
    pub(crate) fn told_of_parameters(&self, trap: Trap) -> Diagnostic {
        diagnostic(&self.parameters, trap, None)
    }

    /// The diagnostic of a trap in its own code or in what that calls, at its place there; the mesh
    /// is as it was.
    pub(crate) fn told(&self, trap: Trap, mesh: &Mesh) -> Diagnostic {
        let Some(span) = trap.trace.iter().find_map(|site| self.span(site)) else {
            return diagnostic(&self.parameters, trap, None);
        };
        let message = trap.to_string();
        match &trap.message {
            Message::Interrupted | Message::NoRoom(_) | Message::NoMemory(_) => {
                diagnostic(&self.parameters, trap, None)
            }
            Message::BelowLevel { op, level, why, .. } => match validate_level(mesh, *level) {
                Err(below) => {
                    let name = &self.plan().name;
                    let message = format!(
                        "`{op}`, a step of `{name}`, is for meshes of level {level}, and this one is not"
                    );
                    Diagnostic::error("below-level", message, span).note(below.to_string())
                }
                Ok(()) => Diagnostic::error("below-level", message, span).note(why.clone()),
            },
            _ => Diagnostic::error(code(&trap), message, span),
        }
    }

    fn span(&self, site: &Site) -> Option<Span> {
        let plan = match site.op {
            Some(op) => self.plans.get(usize::from(op))?.as_ref()?,
            None => self.plan(),
        };
        let places = match site.function {
            Some(function) => &plan.code.functions.get(usize::from(function))?.places,
            None => &plan.places,
        };
        places.get(site.place? as usize).copied()
    }
}

/// The reason of a refusal for which none is noted.
pub(crate) const UNKNOWN_REASON: &str = "the diagram does not match here";

/// A program whose only script has the parameters of an operation, and does nothing: running it
/// leaves their values in the window.
fn parameters_alone(program: &Program, op: usize) -> Program {
    let variable =
        |param: &Param| Variable { name: param.name.clone(), ty: param.ty, span: param.span };
    let scripts = program.ops.get(op).map(|op| Script {
        name: op.name.clone(),
        span: op.span,
        docs: Vec::new(),
        params: op.params.clone(),
        body: Body { variables: op.params.iter().map(variable).collect(), block: Vec::new() },
    });
    Program {
        attributes: Arc::clone(&program.attributes),
        functions: program.functions.clone(),
        scripts: scripts.into_iter().collect(),
        ..Program::default()
    }
}
