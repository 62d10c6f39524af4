//! Prepared scripts: a script with everything that it needs to run.

use super::Argument;
use super::argument::{sample, wanted};
use super::columns::Columns;
use super::function::{Functions, calling, routine, with_functions};
use super::lower::Lowering;
use super::report::level_of_steps;
use super::steps::with_steps;
use crate::compile::width;
use crate::diagnostic::{Diagnostic, quoted};
use crate::diagram::{Param, Type};
use crate::mesh::{Level, Mesh, WantedAttribute};
use crate::resolve::{Program, Script};
use crate::rewrite::{self, Code, Engine, Plans, TooLarge, Unbounded};
use crate::source::Span;

/// The messages for a wrong number of values of a parameter: the code and the words.
const MISSING: (&str, &str) = ("missing-argument", "has no value");
const TWICE: (&str, &str) = ("repeated-argument", "is given more than once");

/// A script, ready to run.
#[derive(Clone, Debug)]
pub struct Prepared {
    pub(super) name: String,
    pub(super) span: Span,
    pub(super) params: Vec<Param>,
    pub(super) plans: Plans,
    pub(super) code: Code,
    pub(super) functions: Functions,
    pub(super) columns: Columns,
    /// The seed of its random numbers.
    pub(super) seed: u64,
    /// The places in the source where the code can trap, by number.
    pub(super) places: Vec<Span>,
    /// The operations that it may call, in the order of the program.
    pub(super) called: Vec<usize>,
    /// Their names; those of several with one name have the words for their files before them.
    pub(super) names: Vec<String>,
    /// The greatest number of bytes that the mesh and the lists may take.
    pub(super) memory: usize,
    pub(super) engine: Engine,
    /// Whether the meshes on which it runs are as [`Mesh::from_polygons`] makes them.
    pub(super) of_polygons: bool,
}

/// Prepares a script of a program, by its number. The plans are those of the program's
/// operations, in order; `None` stands for an operation that is not proved.
///
/// # Errors
/// The script calls an operation that is not proved, or it is too large.
pub fn prepare(
    program: &Program,
    script: usize,
    plans: &Plans,
) -> Result<Prepared, Vec<Diagnostic>> {
    let Some(script) = program.scripts.get(script) else {
        let message = "there is no such script";
        return Err(vec![Diagnostic::error("unknown-script", message, Span::default())]);
    };
    let (functions, too_large) = Functions::of(program);
    if !too_large.is_empty() {
        return Err(too_large);
    }
    prepare_script(program, script, plans, functions)
}

/// Prepares a function of a program, by its number, to be called like a script. Its value is in
/// the slots after its parameters: see [`Prepared::value`].
///
/// # Errors
/// As for [`prepare`].
pub(crate) fn prepare_function(
    program: &Program,
    function: usize,
    plans: &Plans,
) -> Result<Prepared, Vec<Diagnostic>> {
    let (functions, too_large) = Functions::of(program);
    if !too_large.is_empty() {
        return Err(too_large);
    }
    prepare_script(program, &calling(&program.functions[function], function), plans, functions)
}

/// [`prepare`] for a script that need not be in the program's list.
pub(super) fn prepare_script(
    program: &Program,
    script: &Script,
    plans: &Plans,
    functions: Functions,
) -> Result<Prepared, Vec<Diagnostic>> {
    let mut lowering = Lowering::of_script(routine(script), functions.known());
    lowering.body(routine(script));
    let reached = functions.reached(&lowering.functions);
    if let Some(missing) = functions.first_missing(&reached) {
        return Err(vec![not_understood(program, missing, script.span)]);
    }
    let mut called = lowering.called;
    for &function in &reached {
        called.extend(&functions.applies[function]);
    }
    called.sort_by_key(|&(op, _)| op);
    called.dedup_by_key(|&mut (op, _)| op);
    let unproved = called.iter().filter(|&&(op, _)| plans.get(op).is_none_or(Option::is_none));
    let unproved: Vec<_> = unproved.map(|&(op, call)| not_proved(program, op, call)).collect();
    if !unproved.is_empty() {
        return Err(unproved);
    }
    let last = called.last().map_or(0, |&(op, _)| op);
    let code = lowering.asm.finish();
    let code = code.and_then(|code| u16::try_from(last).map_or(Err(TooLarge), |_| Ok(code)));
    let code = code.map_err(|too_large| {
        let message = format!("`{}` is {too_large}", script.name);
        vec![Diagnostic::error("script-too-large", message, script.span)]
    })?;
    let code = with_functions(code, &functions);
    let called_plans = called.iter().filter_map(|&(op, _)| plans.get(op)?.as_ref());
    let called_plans = with_steps(plans, called_plans);
    let all_code = called_plans.iter().map(|plan| &plan.code).chain([&code]);
    let columns = Columns::of(&program.attributes, all_code).map_err(|error| vec![error])?;
    let called: Vec<usize> = called.into_iter().map(|(op, _)| op).collect();
    Ok(Prepared {
        name: script.name.clone(),
        span: script.span,
        params: script.params.clone(),
        plans: Plans::clone(plans),
        columns,
        code,
        functions,
        seed: 0,
        places: lowering.names.places,
        memory: usize::MAX,
        engine: Engine::default(),
        names: program.names_of_ops(called.iter().copied()),
        called,
        of_polygons: false,
    })
}

fn not_proved(program: &Program, op: usize, call: Span) -> Diagnostic {
    let code = "unproved-op";
    let Some(op) = program.ops.get(op) else {
        return Diagnostic::error(code, "there is no such operation", call);
    };
    let message = format!("`{}` is not proved, so it cannot run", op.name);
    Diagnostic::error(code, message, call).saying("called here").label(op.span, "this operation")
}

fn not_understood(program: &Program, function: usize, by: Span) -> Diagnostic {
    let functions = program.functions.iter().map(|known| (&known.name, known.span, "function"));
    let scripts = program.called_scripts.iter().map(|(name, span, _)| (name, *span, "script"));
    let Some((name, span, kind)) = functions.chain(scripts).nth(function) else {
        return Diagnostic::error("unproved-op", "what this calls has an error", by);
    };
    let message = format!("`{name}` has an error, and this depends on it: it cannot run");
    Diagnostic::error("unproved-op", message, by).label(span, format!("this {kind} has an error"))
}

impl Prepared {
    /// The numbers of the operations that it may call itself, in the order of the program.
    pub fn called(&self) -> &[usize] {
        &self.called
    }

    /// The code of the script.
    pub fn code(&self) -> &Code {
        &self.code
    }

    /// The loops `drain` of the script and of the functions that it calls, each with its place in
    /// the source and, if its key is not a bounded walk from its element, the reason; the reads of
    /// such a key are noted.
    pub fn drains(&self) -> Vec<(Span, Option<Unbounded>)> {
        let functions = &self.functions.code;
        let called = self.code.with_called();
        let places = |code: &Code| {
            let function = functions.iter().find(|one| std::ptr::eq(&one.code, code));
            function.map_or(self.places.as_slice(), |function| &function.places)
        };
        let mut drains = Vec::new();
        for code in called {
            for (at, why) in rewrite::drains(code, functions, &self.plans) {
                let place = code.place(at).and_then(|place| places(code).get(place as usize));
                drains.push((place.copied().unwrap_or(self.span), why));
            }
        }
        drains
    }

    /// Limits the memory for the mesh and for lists, in bytes: a run that needs more fails with
    /// `no-room`.
    pub fn limit_memory(&mut self, bytes: usize) {
        self.memory = bytes;
    }

    /// Declares that the meshes on which it runs are as [`Mesh::from_polygons`] makes them, as is
    /// true of meshes just read from files: they are not checked again for being surfaces.
    #[cfg(feature = "cli")]
    pub(crate) fn expect_polygons(&mut self) {
        self.of_polygons = true;
    }

    /// Sets the engine that runs it.
    pub fn use_engine(&mut self, engine: Engine) {
        self.engine = engine;
    }

    /// Its parameters, in order.
    pub(crate) fn params(&self) -> &[Param] {
        &self.params
    }

    /// The slot of the value in the window, for a prepared function.
    pub(crate) fn value(&self) -> usize {
        // Before it are the parameters, and for each of them whether it was given.
        self.params.iter().map(|param| usize::from(width(param.ty)) + 1).sum()
    }

    /// Whether it may change the mesh.
    pub(crate) fn changes(&self) -> bool {
        self.code.with_called().iter().any(|code| code.changes())
    }

    /// The level that a mesh should have for all operations that it calls.
    pub(crate) fn wanted(&self) -> Level {
        level_of_steps(&self.plans, &self.called, Level::Map)
    }

    /// The columns that it needs.
    pub(crate) fn columns(&self) -> &Columns {
        &self.columns
    }

    /// Returns it with a seed for its random numbers, 0 by default. The same seed gives the same
    /// numbers on every machine.
    pub fn with_seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The attributes that it uses, without scratch attributes: those that it would read from a
    /// file.
    pub fn attributes(&self) -> impl Iterator<Item = WantedAttribute<'_>> {
        self.columns.public()
    }

    /// Parses the arguments, each a name and a text, by the types of the parameters.
    ///
    /// # Errors
    /// One diagnostic for each argument that names no parameter or is not of its type, and for each
    /// parameter without a value.
    pub fn arguments(
        &self,
        texts: &[(String, String)],
    ) -> Result<Vec<(String, Argument)>, Vec<Diagnostic>> {
        let mut arguments = Vec::new();
        let mut errors = Vec::new();
        for (name, text) in texts {
            match self.param(name) {
                None => errors.push(self.no_such_parameter(name)),
                Some(param) => match Argument::parse(text, param.ty) {
                    Some(value) => arguments.push((name.clone(), value)),
                    None => errors.push(wrong_text(param, text)),
                },
            }
        }
        let given = texts.iter().map(|(name, _)| name.as_str());
        errors.extend(self.badly_given(given));
        if errors.is_empty() { Ok(arguments) } else { Err(errors) }
    }

    /// The slots at the start of the window: the values of the parameters, then for each of them
    /// whether it is given. Texts are added to those of the code.
    pub(super) fn slots(
        &self,
        mesh: &Mesh,
        arguments: &[(String, Argument)],
        texts: &mut Vec<String>,
    ) -> Result<Vec<u64>, Diagnostic> {
        let mut values = vec![None; self.params.len()];
        for (name, value) in arguments {
            self.give(name, value.clone(), &mut values)?;
        }
        let mut slots = Vec::new();
        self.fill(mesh, &values, texts, &mut slots)?;
        Ok(slots)
    }

    /// Sets the value of a parameter, which must have none yet.
    pub(crate) fn give(
        &self,
        name: &str,
        value: Argument,
        values: &mut [Option<Argument>],
    ) -> Result<(), Diagnostic> {
        let at = self.params.iter().position(|param| param.name == name);
        let Some(at) = at else { return Err(self.no_such_parameter(name)) };
        match values.get_mut(at) {
            Some(free @ None) => *free = Some(value),
            _ => return Err(self.wrongly_given(&self.params[at], TWICE)),
        }
        Ok(())
    }

    /// Fills the slots with the values of the parameters, after checking them, then for each of
    /// them whether it is given. Returns whether all are given.
    pub(crate) fn fill(
        &self,
        mesh: &Mesh,
        values: &[Option<Argument>],
        texts: &mut Vec<String>,
        slots: &mut Vec<u64>,
    ) -> Result<bool, Diagnostic> {
        slots.clear();
        for (param, value) in self.params.iter().zip(values) {
            match value {
                Some(Argument::Int(value)) if param.ty == Type::Real => {
                    slots.push((*value as f64).to_bits());
                }
                Some(value) => {
                    if param.ty != value.ty() {
                        return Err(wrong_type(param, value.ty()));
                    }
                    if let Some(given) = value.wrong_count() {
                        let message =
                            format!("the number of reals given for `{}` is {given}", param.name);
                        return Err(Diagnostic::error("wrong-argument", message, param.span)
                            .note(format!("it wants {}", wanted(param.ty))));
                    }
                    if !value.is_finite() {
                        let message = format!("`{}` is not finite", param.name);
                        return Err(Diagnostic::error("wrong-argument", message, param.span));
                    }
                    if let Some(id) = value.missing_in(mesh) {
                        let kind = param.ty.word();
                        let message = format!("`{}` is no {kind} of the mesh: {id}", param.name);
                        return Err(Diagnostic::error("wrong-argument", message, param.span));
                    }
                    value.fill(texts, slots);
                }
                None if param.default.is_none() => return Err(self.wrongly_given(param, MISSING)),
                None => slots.extend(std::iter::repeat_n(0, usize::from(width(param.ty)))),
            }
        }
        slots.extend(values.iter().map(|value| u64::from(value.is_some())));
        Ok(values.iter().all(Option::is_some))
    }

    /// The error for more values than parameters.
    pub(crate) fn too_many(&self) -> Diagnostic {
        let message = match self.params.len() {
            0 => format!("`{}` has no parameters", self.name),
            1 => format!("`{}` has only one parameter", self.name),
            count => format!("`{}` has only {count} parameters", self.name),
        };
        Diagnostic::error("wrong-argument", message, self.span)
    }

    fn param(&self, name: &str) -> Option<&Param> {
        self.params.iter().find(|param| param.name == name)
    }

    /// The errors for parameters that are given twice, or not at all though they have no default.
    fn badly_given<'n>(&self, names: impl Iterator<Item = &'n str> + Clone) -> Vec<Diagnostic> {
        let mut errors = Vec::new();
        for param in &self.params {
            let times = names.clone().filter(|name| *name == param.name).count();
            match times {
                0 if param.default.is_none() => {
                    let sample = sample(param.ty).unwrap_or("VALUE");
                    let way_out = format!("give it by `--set {}={sample}`", param.name);
                    errors.push(self.wrongly_given(param, MISSING).note(way_out));
                }
                0 | 1 => {}
                _ => errors.push(self.wrongly_given(param, TWICE)),
            }
        }
        errors
    }

    fn wrongly_given(&self, param: &Param, (code, how): (&'static str, &str)) -> Diagnostic {
        let message = format!("`{}` of `{}` {how}", param.name, self.name);
        Diagnostic::error(code, message, param.span).note(format!("it wants {}", wanted(param.ty)))
    }

    fn no_such_parameter(&self, name: &str) -> Diagnostic {
        let message = format!("`{}` has no parameter `{name}`", self.name);
        let note = match quoted(self.params.iter().map(|param| &param.name)).as_str() {
            "" => "it has no parameters".to_owned(),
            known => format!("it has {known}"),
        };
        Diagnostic::error("unknown-argument", message, self.span).note(note)
    }
}

fn wrong_text(param: &Param, text: &str) -> Diagnostic {
    let message = format!("`{}` cannot be `{text}`", param.name);
    Diagnostic::error("wrong-argument", message, param.span)
        .note(format!("it wants {}", wanted(param.ty)))
}

fn wrong_type(param: &Param, got: Type) -> Diagnostic {
    let message = format!(
        "`{}` is of type `{}`, but the value given is of type `{}`",
        param.name,
        param.ty.word(),
        got.word()
    );
    Diagnostic::error("wrong-argument", message, param.span)
}
