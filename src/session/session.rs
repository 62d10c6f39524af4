//! A mesh with everything that calls of operations and scripts need.

use std::borrow::Cow;

use super::binding::Bound;
use super::engine::Engine;
use super::level::Known;
use super::marks::Marks;
use super::masks::Masks;
use super::{Arguments, Error, Given, Op, Outcome, Program, Script};
use crate::diagnostic::Diagnostic;
use crate::mesh::{Element, ElementKind, Mesh};
use crate::rewrite::{self, Code, Machine, Trap, Unwatched, Watch};
use crate::run::{self, Application, Argument, Failure, Prepared, Report};

/// A mesh on which operations and scripts of one program are called.
///
/// # Ids
///
/// An id denotes one element as long as that is alive; after that [`is_alive`](Self::is_alive) is
/// false, and passing the id is an error. Ids of erased elements are given to new ones only after
/// [`recycle`](Self::recycle), with which the caller declares that it holds none of them, and by
/// scripts, which recycle by themselves: after a script has run, ids from before may denote other
/// elements.
///
/// # Attributes
///
/// The attributes of the program are added to the mesh when something that uses them and may change
/// the mesh is called, and stay there: [`Mesh::find_column`] and [`Mesh::values`] read them. The
/// defaults of all attributes that are on the mesh are then those of the program. Questions, kept
/// masks, and functions and scripts that do not change the mesh add no attribute and leave the
/// defaults as they are; what they need meanwhile is on [`mesh`](Self::mesh) as scratch columns, and
/// on no copy. Scratch attributes have their defaults at the start of each call.
///
/// # What fails
///
/// An operation that refuses or fails leaves the mesh unchanged. A script that fails keeps what it
/// did so far, each step of it complete; [`attempt`](Self::attempt) makes it all or nothing.
pub struct Session {
    pub(super) engine: Engine,
    /// The engines of other programs that have been used.
    others: Vec<Engine>,
    pub(super) mesh: Mesh,
    pub(super) known: Known,
    pub(super) marks: Marks,
    pub(super) masks: Masks,
    pub(super) values: Vec<Option<Argument>>,
    pub(super) slots: Vec<u64>,
    /// The watcher of operations and questions.
    pub(super) watch: Box<dyn Watch + Send>,
    runs_by: rewrite::Engine,
    memory: Option<usize>,
    seed: u64,
    created: Vec<Element>,
    erased: Vec<Element>,
}

impl Session {
    /// A session for a program and a mesh.
    pub fn new(program: &Program, mesh: Mesh) -> Self {
        Self {
            engine: Engine::new(program),
            others: Vec::new(),
            mesh,
            known: Known::NOTHING,
            marks: Marks::default(),
            masks: Masks::default(),
            values: Vec::new(),
            slots: Vec::new(),
            watch: Box::new(Unwatched),
            runs_by: rewrite::Engine::default(),
            memory: None,
            seed: 0,
            created: Vec::new(),
            erased: Vec::new(),
        }
    }

    /// The program.
    pub fn program(&self) -> &Program {
        &self.engine.program
    }

    /// Switches to another program: from then on its operations, scripts and functions are called.
    /// The mesh stays, with its attributes except scratch ones, and so do marks. What calls of the
    /// previous program need is kept, so that switching back is cheap.
    pub fn use_program(&mut self, program: &Program) {
        if self.engine.program.is(program) {
            return;
        }
        self.engine.release(&mut self.mesh);
        self.engine.unbind();
        let next = match self.others.iter().position(|other| other.program.is(program)) {
            Some(at) => self.others.swap_remove(at),
            None => self.new_engine(program),
        };
        self.others.push(std::mem::replace(&mut self.engine, next));
    }

    /// Removes the scratch attributes of the other programs, which may have come back.
    pub(super) fn release_others(&mut self) {
        self.others.iter().for_each(|other| other.release(&mut self.mesh));
    }

    /// An engine with the settings of the session.
    fn new_engine(&self, program: &Program) -> Engine {
        let mut engine = Engine::new(program);
        engine.machine.use_engine(self.runs_by);
        engine.machine.seed(self.seed);
        if let Some(bytes) = self.memory {
            engine.machine.limit_memory(bytes);
        }
        engine
    }

    fn each_machine(&mut self, set: impl Fn(&mut Machine)) {
        let engines = self.others.iter_mut().chain([&mut self.engine]);
        engines.for_each(|engine| set(&mut engine.machine));
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The mesh, to be changed by hand. Its level must be determined anew afterwards. To put another
    /// mesh in its place ends all marks.
    pub fn mesh_mut(&mut self) -> &mut Mesh {
        self.engine.unbind();
        self.known = Known::NOTHING;
        self.masks.forget();
        &mut self.mesh
    }

    /// The mesh, without scratch attributes. What was written since open marks is kept.
    pub fn into_mesh(mut self) -> Mesh {
        let mut mesh = std::mem::take(&mut self.mesh);
        self.clean(&mut mesh);
        mesh
    }

    /// A copy of the mesh, without scratch attributes and without marks.
    pub fn copy_mesh(&self) -> Mesh {
        let mut mesh = self.mesh.clone();
        self.clean(&mut mesh);
        mesh
    }

    /// Makes a mesh that nothing runs on: without marks and scratch columns.
    fn clean(&self, mesh: &mut Mesh) {
        mesh.keep_all();
        self.engine.release(mesh);
        run::remove_stand_ins(mesh);
    }

    /// Another session with the same mesh, whose random numbers go on as here. It has no marks.
    pub fn copy(&self) -> Self {
        let mesh = self.copy_mesh();
        let mut copy = Self::new(&self.engine.program, mesh);
        copy.known = self.known;
        copy.use_engine(self.runs_by);
        copy.seed = self.seed;
        if let Some(bytes) = self.memory {
            copy.limit_memory(bytes);
        }
        copy.engine.machine.go_on_from(&self.engine.machine);
        for other in self.others.iter().filter(|other| !other.machine.is_at_seed(self.seed)) {
            let mut engine = copy.new_engine(&other.program);
            engine.machine.go_on_from(&other.machine);
            copy.others.push(engine);
        }
        copy
    }

    /// Limits the memory, in bytes, for the mesh and for lists: what needs more fails with
    /// `no-room`. There is no limit at first.
    pub fn limit_memory(&mut self, bytes: usize) {
        self.memory = Some(bytes);
        self.each_machine(|machine| machine.limit_memory(bytes));
    }

    /// Sets the engine that runs operations and scripts from now on. The results are the same.
    pub fn use_engine(&mut self, engine: rewrite::Engine) {
        self.runs_by = engine;
        self.each_machine(|machine| machine.use_engine(engine));
    }

    /// Sets the seed of the random numbers of scripts and functions. By default the seed is 0; the
    /// sequence continues from call to call, for each program its own.
    pub fn seed(&mut self, seed: u64) {
        self.seed = seed;
        self.each_machine(|machine| machine.seed(seed));
    }

    /// Sets the watcher of operations, questions and kept masks from now on, which may stop them
    /// (`interrupted`). Scripts and functions are given theirs:
    /// [`run_watched`](Self::run_watched). A copy of the session has no watcher.
    pub fn watch(&mut self, watch: impl Watch + Send + 'static) {
        self.watch = Box::new(watch);
    }

    /// True if an element is alive.
    pub fn is_alive(&self, element: impl Into<Element>) -> bool {
        let Element { kind, index } = element.into();
        self.mesh.is_alive(kind, index)
    }

    /// Declares that the caller holds no ids of erased elements: new elements may get them. Has no
    /// effect while a mark is open.
    pub fn recycle(&mut self) {
        self.mesh.recycle();
    }

    /// Applies an operation.
    ///
    /// # Errors
    /// The arguments do not fit the parameters, an element is not alive, the mesh lacks the level
    /// that the operation requires (`below-level`), an expression of it has no value here, or it was
    /// stopped (`interrupted`). The mesh is unchanged.
    pub fn apply(&mut self, op: &Op, arguments: impl Arguments) -> Result<Outcome, Error> {
        self.created.clear();
        self.erased.clear();
        let application = self.enter(op, arguments, Bound::ToAsk)?;
        if self.engine.bound_ops[op.index] < Bound::ToChange {
            // A refusal brings no attribute and no default.
            if application.columns().are_new_to(&self.mesh) {
                let asked = self.with_own_defaults(|session| session.ask_at(application));
                let asked = asked.map_err(|trap| self.trapped(application, trap))?;
                if let rewrite::Outcome::Refused { reason } = asked {
                    return Ok(Outcome::Refused(op.reason(reason)));
                }
            }
            self.make_ready(op, application, Bound::ToChange)?;
        }
        self.engine.machine.remember_created();
        let plan = application.plan();
        let gone = ElementKind::ALL.map(|kind| self.mesh.erased(kind).len());
        let mark = self.masks.are_kept().then(|| self.mesh.open_journal());
        let Self { engine, mesh, slots, watch, .. } = self;
        let outcome = engine.machine.apply_watched(mesh, plan, slots, &mut **watch);
        if let Some(mark) = mark {
            self.masks.note(&self.mesh, &mark);
            self.mesh.keep(mark);
        }
        Ok(match outcome.map_err(|trap| self.trapped(application, trap))? {
            rewrite::Outcome::Applied { result } => {
                self.known.leave(plan.level_after(self.engine.machine.level()));
                application.columns().clear(&mut self.mesh);
                let element = |&(kind, index): &(ElementKind, u32)| Element { kind, index };
                self.created.extend(self.engine.machine.created().iter().map(element));
                for (kind, before) in ElementKind::ALL.into_iter().zip(gone) {
                    let gone = self.mesh.erased(kind)[before..].iter();
                    self.erased.extend(gone.map(|&index| Element { kind, index }));
                }
                self.forget_passing();
                Outcome::Applied(plan.result.zip(result).map(|made| element(&made)))
            }
            rewrite::Outcome::Refused { reason } => Outcome::Refused(op.reason(reason)),
        })
    }

    /// The elements that the last call of [`apply`](Self::apply) has created, in order of creation.
    pub fn created(&self) -> &[Element] {
        &self.created
    }

    /// The elements that the last call of [`apply`](Self::apply) has erased.
    pub fn erased(&self) -> &[Element] {
        &self.erased
    }

    /// Removes elements that the same call created and erased: callers never saw them.
    fn forget_passing(&mut self) {
        let Self { created, erased, mesh, .. } = self;
        if !erased.is_empty() && !created.is_empty() {
            erased.retain(|element| !created.contains(element));
            created.retain(|&Element { kind, index }| mesh.is_alive(kind, index));
        }
    }

    /// Runs a script. What it prints is discarded.
    ///
    /// # Errors
    /// The arguments do not fit the parameters, the mesh lacks the level that the operations it
    /// calls require, or the script fails. What it did so far is kept: see [`Error::report`] and
    /// [`attempt`](Self::attempt).
    pub fn run(&mut self, script: &Script, arguments: impl Arguments) -> Result<Report, Error> {
        self.run_watched(script, arguments, &mut Unwatched)
    }

    /// Runs a script with a watcher, which sees its progress, receives what it prints, and may stop
    /// it.
    ///
    /// # Errors
    /// As for [`run`](Self::run); or it was stopped (`interrupted`).
    pub fn run_watched(
        &mut self,
        script: &Script,
        arguments: impl Arguments,
        watch: &mut dyn Watch,
    ) -> Result<Report, Error> {
        self.expect_own(&script.program)?;
        let prepared = script.prepared()?;
        self.give(prepared, arguments)?;
        let code = self.filled(prepared)?;
        let wanted = Bound::to_run(prepared.changes());
        self.bind(prepared.columns(), wanted, |engine| &mut engine.bound_scripts[script.index])?;
        self.go((prepared, &code), watch)
    }

    /// As [`run_watched`](Self::run_watched), with a history of the last operations that it
    /// applies, as many as fit into `most` bytes.
    #[cfg(feature = "play")]
    pub(crate) fn run_recorded(
        &mut self,
        script: &Script,
        arguments: impl Arguments,
        most: usize,
        watch: &mut dyn Watch,
    ) -> (Result<Report, Error>, crate::mesh::History) {
        self.mesh.record_history(most);
        (self.run_watched(script, arguments, watch), self.mesh.take_history().unwrap_or_default())
    }

    /// Fills the slots with the given values. Returns the code to run, whose texts include theirs.
    pub(super) fn filled<'p>(&mut self, prepared: &'p Prepared) -> Result<Cow<'p, Code>, Error> {
        let code = prepared.code();
        let mut texts = code.texts.clone();
        let filled = prepared.fill(&self.mesh, &self.values, &mut texts, &mut self.slots);
        filled.map_err(|error| self.error(error))?;
        Ok(match texts.len() == code.texts.len() {
            true => Cow::Borrowed(code),
            false => Cow::Owned(Code { texts, ..code.clone() }),
        })
    }

    /// Runs prepared code, as it has been [filled](Self::filled); its columns are on the mesh.
    pub(super) fn go(
        &mut self,
        (prepared, code): (&Prepared, &Code),
        watch: &mut dyn Watch,
    ) -> Result<Report, Error> {
        if self.masks.are_kept() && prepared.changes() {
            self.masks.forget();
        }
        self.engine.machine.forget_created();
        self.engine.machine.clear_counts();
        self.engine.machine.trust_level(self.known.level());
        let mut run = |session: &mut Self| {
            session.engine.machine.run(&mut session.mesh, code, &session.slots, watch)
        };
        let outcome = if prepared.changes() { run(self) } else { self.with_own_defaults(run) };
        self.known.leave(self.engine.machine.level());
        prepared.columns().clear(&mut self.mesh);
        let report = run::report(prepared, self.engine.machine.counts());
        match outcome {
            Ok(_) => Ok(report),
            Err(trap) => {
                let diagnostic = run::diagnostic(prepared, trap, Some(&self.engine.machine));
                Err(Error::failure(Failure { diagnostic, report }, &self.engine.program.0.sources))
            }
        }
    }

    /// Checks the arguments of an operation and prepares the call: its slots are filled.
    pub(super) fn enter<'o>(
        &mut self,
        op: &'o Op,
        arguments: impl Arguments,
        wanted: Bound,
    ) -> Result<&'o Application, Error> {
        self.expect_own(&op.program)?;
        let application = op.application()?;
        self.give(application.parameters(), arguments)?;
        self.make_ready(op, application, wanted)?;
        Ok(application)
    }

    /// Fails if the program is not that of this session.
    pub(super) fn expect_own(&self, program: &Program) -> Result<(), Error> {
        if self.engine.program.is(program) {
            return Ok(());
        }
        Err(self.wrong("foreign-program", "this belongs to another program than the session"))
    }

    /// Takes the arguments.
    pub(super) fn give(
        &mut self,
        takes: &Prepared,
        arguments: impl Arguments,
    ) -> Result<(), Error> {
        let mut given = Given::new(takes, &mut self.values);
        arguments.give(&mut given);
        given.end().map_err(|error| self.error(error))
    }

    /// Fills the slots of an operation from its values, and checks the level and binds the columns.
    pub(super) fn make_ready(
        &mut self,
        op: &Op,
        application: &Application,
        wanted: Bound,
    ) -> Result<(), Error> {
        let parameters = application.parameters();
        // No operation takes a text.
        let mut texts = Vec::new();
        let filled = parameters.fill(&self.mesh, &self.values, &mut texts, &mut self.slots);
        let all_given = filled.map_err(|error| self.error(error))?;
        let plan = application.plan();
        let has = self.known.seek(application.wanted().max(plan.level), &self.mesh);
        if has < plan.level {
            application.expect_level(&self.mesh).map_err(|error| self.error(error))?;
        }
        self.bind(application.columns(), wanted, |engine| &mut engine.bound_ops[op.index])?;
        self.engine.machine.trust_level(has);
        if !all_given {
            self.engine.machine.forget_created();
            let code = parameters.code();
            let Self { engine, mesh, slots, watch, .. } = self;
            let run = engine.machine.run(mesh, code, slots, &mut **watch);
            run.map_err(|trap| self.error(application.told_of_parameters(trap)))?;
            for (slot, value) in self.slots.iter_mut().zip(self.engine.machine.window()) {
                *slot = *value;
            }
        }
        Ok(())
    }

    pub(super) fn trapped(&self, application: &Application, trap: Trap) -> Error {
        self.error(application.told(trap, &self.mesh))
    }

    /// An error without a place.
    pub(super) fn wrong(&self, code: &'static str, message: impl Into<String>) -> Error {
        Error::nowhere(code, message.into(), &self.engine.program.0.sources)
    }

    pub(super) fn error(&self, diagnostic: Diagnostic) -> Error {
        Error::one(diagnostic, &self.engine.program.0.sources)
    }
}

impl Clone for Session {
    fn clone(&self) -> Self {
        self.copy()
    }
}

impl std::fmt::Debug for Session {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let counts = ElementKind::ALL.map(|kind| (kind.plural(), self.mesh.count(kind)));
        let mut shown = f.debug_struct("Session");
        shown.field("program", &self.engine.program);
        for (name, count) in &counts {
            shown.field(name, count);
        }
        shown.finish()
    }
}
