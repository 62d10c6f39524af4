//! Programs, ready to run.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use super::item::ApplicationOrError;
use super::{Error, Function, Op, Script};
#[cfg(feature = "play")]
use crate::analysis::Counterexample;
use crate::analysis::{Analysis, Disk, Nowhere, Reader, read_program};
use crate::diagnostic::Diagnostic;
use crate::library;
use crate::resolve::closest;
use crate::run::Prepared;
use crate::source::{FileId, Sources, Span};

/// A program that is proved and compiled. Clones are cheap and share everything.
#[derive(Clone)]
pub struct Program(pub(super) Arc<Parts>);

type PreparedOrErrors = Result<Prepared, Vec<Diagnostic>>;

/// The parts that clones of a program share.
pub(super) struct Parts {
    pub(super) sources: Arc<Sources>,
    pub(super) analysis: Analysis,
    /// The operations, each prepared on its first call.
    pub(super) applications: Vec<OnceLock<ApplicationOrError>>,
    /// The reasons why they may refuse, by number.
    pub(super) reasons: Vec<OnceLock<Arc<[Arc<str>]>>>,
    /// The scripts, likewise.
    pub(super) scripts: Vec<OnceLock<PreparedOrErrors>>,
    /// The functions, likewise.
    pub(super) functions: Vec<OnceLock<PreparedOrErrors>>,
}

impl Program {
    /// Reads a program and the files that it uses. A name such as `std/remesh.hedge` that is not
    /// the path of a file refers to the library.
    ///
    /// # Errors
    /// The file cannot be read (`missing-file`), or the program has errors, all of which are
    /// reported.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let shown = path.display().to_string();
        if let Some(file) = library::file(&shown).filter(|_| !path.exists()) {
            return Self::parse_with(file.name, file.text, &mut Disk);
        }
        let text = read_program(path).map_err(|why| {
            let message = format!("cannot read `{shown}`: {why}");
            Error::nowhere("missing-file", message, &Arc::default())
        })?;
        Self::parse_with(&library::outside(shown), &text, &mut Disk)
    }

    /// Reads a program from a text. The name is used in messages, and the files that the program
    /// uses are looked up in its folder.
    ///
    /// # Errors
    /// The program has errors.
    pub fn parse(name: &str, text: &str) -> Result<Self, Error> {
        Self::parse_with(name, text, &mut Disk)
    }

    /// As [`parse`](Self::parse), with the files that the program uses read by `reader`.
    ///
    /// # Errors
    /// The program has errors.
    pub fn parse_with(name: &str, text: &str, reader: &mut dyn Reader) -> Result<Self, Error> {
        let mut sources = Sources::new();
        let file = sources.add(name, text);
        Self::analysed(sources, file, reader)
    }

    /// Reads a program from texts alone, each with its name, the program itself first; anything
    /// else that it uses must be in the library. [`texts`](Self::texts) returns such texts.
    ///
    /// # Errors
    /// There are no texts, or the program has errors.
    pub fn from_texts(texts: &[(String, String)]) -> Result<Self, Error> {
        let mut sources = Sources::new();
        let files: Vec<_> = texts.iter().map(|(name, text)| sources.add(name, text)).collect();
        match files.first() {
            Some(&file) => Self::analysed(sources, file, &mut Nowhere),
            None => {
                let message = "a program of no texts".to_owned();
                Err(Error::nowhere("missing-file", message, &Arc::default()))
            }
        }
    }

    /// The names and texts of the program and of all that it uses except the library, its own
    /// first.
    pub fn texts(&self) -> Vec<(String, String)> {
        let (sources, own) = (&self.0.sources, self.0.analysis.file);
        let others = sources.ids().filter(|&file| file != own);
        let others = others.filter(|&file| library::file(sources.get(file).name()).is_none());
        let texts = std::iter::once(own).chain(others).map(|file| {
            let source = sources.get(file);
            (source.name().to_owned(), source.text().to_owned())
        });
        texts.collect()
    }

    /// As [`parse_with`](Self::parse_with), with counterexamples: meshes that its operations break.
    #[cfg(feature = "play")]
    pub(crate) fn examined(
        name: &str,
        text: &str,
        reader: &mut dyn Reader,
    ) -> (Result<Self, Error>, Vec<Counterexample>) {
        let mut sources = Sources::new();
        let file = sources.add(name, text);
        let mut analysis = Analysis::with(&mut sources, file, reader);
        let counterexamples = std::mem::take(&mut analysis.counterexamples);
        (Self::of(analysis, sources), counterexamples)
    }

    fn analysed(
        mut sources: Sources,
        file: FileId,
        reader: &mut dyn Reader,
    ) -> Result<Self, Error> {
        Self::of(Analysis::with(&mut sources, file, reader), sources)
    }

    fn of(analysis: Analysis, sources: Sources) -> Result<Self, Error> {
        let sources = Arc::new(sources);
        if !analysis.is_sound() {
            return Err(Error::new(analysis.diagnostics, &sources));
        }
        let ops = analysis.program.ops.len();
        let scripts = analysis.program.scripts.len();
        let functions = analysis.program.functions.len();
        Ok(Self(Arc::new(Parts {
            sources,
            applications: (0..ops).map(|_| OnceLock::new()).collect(),
            reasons: (0..ops).map(|_| OnceLock::new()).collect(),
            scripts: (0..scripts).map(|_| OnceLock::new()).collect(),
            functions: (0..functions).map(|_| OnceLock::new()).collect(),
            analysis,
        })))
    }

    /// The operation with the given name: of the file itself, or else of the files that it uses.
    ///
    /// # Errors
    /// There is none (`unknown-op`).
    pub fn op(&self, name: &str) -> Result<Op, Error> {
        match self.0.analysis.op(name) {
            Some(op) => Ok(Op::new(self, op)),
            None => {
                let other = self.0.analysis.script(name).map(|_| "it is a script");
                let names = self.ops().map(|op| op.name().to_owned()).collect();
                Err(self.unknown(("unknown-op", "operation"), name, other, names))
            }
        }
    }

    /// The script with the given name: of the file itself, or else of the files that it uses.
    ///
    /// # Errors
    /// There is none (`unknown-script`).
    pub fn script(&self, name: &str) -> Result<Script, Error> {
        match self.0.analysis.script(name) {
            Some(script) => Ok(Script::new(self, script)),
            None => {
                let other = self.0.analysis.op(name).map(|_| "it is an operation");
                let names = self.scripts().map(|script| script.name().to_owned()).collect();
                Err(self.unknown(("unknown-script", "script"), name, other, names))
            }
        }
    }

    /// The function with the given name: of the file itself, or else of the files that it uses.
    ///
    /// # Errors
    /// There is none (`unknown-function`).
    pub fn function(&self, name: &str) -> Result<Function, Error> {
        match self.0.analysis.function(name) {
            Some(function) => Ok(Function::new(self, function)),
            None => {
                let names = self.functions().map(|function| function.name().to_owned()).collect();
                Err(self.unknown(("unknown-function", "function"), name, None, names))
            }
        }
    }

    /// All operations that can be named, those of the file first.
    pub fn ops(&self) -> impl Iterator<Item = Op> + '_ {
        let ops = self.0.analysis.program.ops.iter().map(|op| op.span);
        self.visible(ops).map(|at| Op::new(self, at))
    }

    /// All scripts that can be named, those of the file first.
    pub fn scripts(&self) -> impl Iterator<Item = Script> + '_ {
        let scripts = self.0.analysis.program.scripts.iter().map(|script| script.span);
        self.visible(scripts).map(|at| Script::new(self, at))
    }

    /// All functions that can be named, those of the file first.
    pub fn functions(&self) -> impl Iterator<Item = Function> + '_ {
        let functions = self.0.analysis.program.functions.iter().map(|function| function.span);
        self.visible(functions).map(|at| Function::new(self, at))
    }

    fn visible(&self, spans: impl Iterator<Item = Span>) -> impl Iterator<Item = usize> {
        spans.enumerate().filter(|(_, span)| self.0.analysis.sees(*span)).map(|(at, _)| at)
    }

    /// The warnings about the program.
    pub fn warnings(&self) -> &[Diagnostic] {
        &self.0.analysis.diagnostics
    }

    /// The analysis of its texts.
    #[cfg(feature = "play")]
    pub(crate) fn analysis(&self) -> &Analysis {
        &self.0.analysis
    }

    /// True for an operation or a script that its own file declares, not a file that it uses.
    pub(crate) fn is_own(&self, name: &str) -> bool {
        let analysis = &self.0.analysis;
        let op = analysis.op(name).map(|at| analysis.program.ops[at].span.file);
        let script = || analysis.script(name).map(|at| analysis.program.scripts[at].span.file);
        op.or_else(script) == Some(analysis.file)
    }

    /// Its texts, for rendering diagnostics.
    pub fn sources(&self) -> &Sources {
        &self.0.sources
    }

    /// True if both are the same program, not merely equal ones.
    pub(super) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    fn unknown(
        &self,
        (code, what): (&'static str, &str),
        name: &str,
        other: Option<&str>,
        known: Vec<String>,
    ) -> Error {
        let near = closest(name, known.iter().map(String::as_str));
        let advice = match (other, near) {
            (Some(other), _) => format!("; {other}"),
            (None, Some(near)) => format!("; did you mean `{near}`?"),
            (None, None) => String::new(),
        };
        let message = format!("the program has no {what} `{name}`{advice}");
        Error::nowhere(code, message, &self.0.sources)
    }
}

impl std::fmt::Debug for Program {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let name = self.0.sources.get(self.0.analysis.file).name();
        f.debug_tuple("Program").field(&name).finish()
    }
}
