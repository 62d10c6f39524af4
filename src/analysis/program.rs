//! From a text to proved and compiled operations.

use super::Examined;
use crate::check::{Counterexample, Proved};
use crate::diagnostic::Diagnostic;
use crate::resolve::{Program, resolve};
use crate::rewrite::Plan;
use crate::source::{FileId, Sources};
use crate::syntax::parse;

/// What is known of one file.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// The file.
    pub file: FileId,
    /// What it declares.
    pub program: Program,
    /// For each op of the program, its proof, if there is one.
    pub proved: Vec<Option<Proved>>,
    /// For each op of the program, its plan, if it is proved.
    pub plans: Vec<Option<Plan>>,
    /// A smallest mesh for each rejected rule that breaks one.
    pub counterexamples: Vec<Counterexample>,
    /// Everything that is wrong, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl Analysis {
    /// Reads, resolves, proves and compiles a file of `sources`.
    pub fn of(sources: &Sources, file: FileId) -> Self {
        let parsed = parse(file, sources.get(file).text());
        let resolved = resolve(&parsed.tree);
        let mut diagnostics = parsed.diagnostics;
        diagnostics.extend(resolved.diagnostics);
        let program = resolved.program;
        let mut proved = Vec::new();
        let mut plans = Vec::new();
        let mut counterexamples = Vec::new();
        for op in &program.ops {
            let examined = Examined::of(op, &diagnostics, sources);
            diagnostics.extend(examined.diagnostics);
            counterexamples.extend(examined.counterexamples);
            proved.push(examined.proved);
            plans.push(examined.plan);
        }
        diagnostics.sort_by_key(|diagnostic| diagnostic.span().start);
        Self {
            file,
            program,
            proved,
            plans,
            counterexamples,
            diagnostics,
        }
    }

    /// Whether nothing in the file is an error.
    pub fn is_sound(&self) -> bool {
        !self.diagnostics.iter().any(Diagnostic::is_error)
    }

    /// The index of an op.
    pub fn op(&self, name: &str) -> Option<usize> {
        self.program.ops.iter().position(|op| op.name == name)
    }

    /// The index of a script.
    pub fn script(&self, name: &str) -> Option<usize> {
        self.program
            .scripts
            .iter()
            .position(|script| script.name == name)
    }
}
