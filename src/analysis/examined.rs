//! One operation, proved and compiled, or the reasons why not.

use super::always_refused::always_refused;
use super::files::touches;
use super::no_change::changes_nothing;
use crate::check::{Counterexample, Outcome, Proved, examine};
use crate::compile::compile;
use crate::diagnostic::{Diagnostic, Fix};
use crate::diagram;
use crate::resolve::ResolvedOp;
use crate::rewrite::Plan;
use crate::run::Functions;
use crate::source::{Sources, Span};

/// The result of checking one operation.
#[derive(Clone, Debug, Default)]
pub struct Examined {
    /// Its proof, if there is one.
    pub proved: Option<Proved>,
    /// Its plan, if it is proved.
    pub plan: Option<Plan>,
    /// A small mesh for each rejected rule that breaks one.
    pub counterexamples: Vec<Counterexample>,
    /// The laws that it breaks, or that it is too large to compile.
    pub diagnostics: Vec<Diagnostic>,
    /// A name with an error that it depends on; then it is not examined.
    pub lacks: Option<String>,
}

impl Examined {
    /// Proves and compiles an op; `told` are the diagnostics so far, and `functions` those of its
    /// program.
    ///
    /// An op with an error inside is not examined: without the part that could not be read, it is a
    /// different operation.
    pub fn of(
        op: &ResolvedOp,
        told: &[Diagnostic],
        sources: &Sources,
        functions: &Functions,
    ) -> Self {
        let whole = op.diagram.as_ref().filter(|_| !op.misread).filter(|diagram| {
            !told.iter().any(|told| told.is_error() && touches(diagram.span, told.span()))
        });
        let mut found = Self::default();
        if let Some(lacks) = whole.and_then(|diagram| functions.lacking(values(diagram))) {
            found.lacks = Some(lacks.to_owned());
            return found;
        }
        match whole.map(examine) {
            Some(Ok(proof)) => {
                match compile(&proof, sources, &functions.code) {
                    Ok(plan) => found.plan = Some(plan),
                    Err(_) => found.diagnostics.push(too_large(op.span, &op.name)),
                }
                found.diagnostics.extend(proof.warnings());
                found.diagnostics.extend(whole.map(always_refused).unwrap_or_default());
                found.diagnostics.extend(whole.and_then(changes_nothing));
                found.proved = Some(proof);
            }
            Some(Err(rejection)) => {
                found.diagnostics = rejection.diagnostics;
                let broken = rejection.outcomes.into_iter();
                let broken = broken.filter_map(|outcome| match outcome {
                    Outcome::Breaks(example) => Some(*example),
                    Outcome::Valid(_) | Outcome::NoMesh | Outcome::NotTried => None,
                });
                found.counterexamples = broken.collect();
            }
            None => {}
        }
        // A fix that replaces a comment would lose it.
        let keeps_comments =
            |fix: &Fix| fix.edits.iter().all(|edit| !sources.slice(edit.span).contains("//"));
        found.diagnostics.iter_mut().for_each(|told| told.fixes.retain(keeps_comments));
        found
    }
}

/// The expressions of an op: the conditions it requires and the values it sets.
fn values(op: &diagram::Op) -> impl Iterator<Item = &diagram::Expr> {
    op.rules.iter().flat_map(|rule| {
        let asked = rule.requires.iter().map(|require| &require.condition);
        asked.chain(rule.assignments.iter().map(|set| &set.value))
    })
}

fn too_large(span: Span, name: &str) -> Diagnostic {
    Diagnostic::error("too-large", format!("`{name}` is too large to compile"), span).note(
        "its diagrams need more than the 65,536 registers or tests that there can be: draw runs that \
         stay as they are as paths, `=P=>`, or make smaller ops of it",
    )
}
