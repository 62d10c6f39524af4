//! A whole file: first the names of its items, then the ops, then the scripts.

use crate::diagnostic::Diagnostic;
use crate::syntax::tree::{self, Item};

use super::attribute::attributes;
use super::declared::Declared;
use super::op::resolve_op;
use super::program::Program;
use super::report::Report;
use super::script::resolve_script;

/// A program, and what is wrong with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resolved {
    /// What could be understood.
    pub program: Program,
    /// What is wrong, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

/// Finds what every name of a file means and what type every value has.
///
/// Items are resolved one by one: a mistake in one costs no other. Nothing is said
/// about what the parser has complained of already.
pub fn resolve(tree: &tree::File) -> Resolved {
    let mut diagnostics = Vec::new();
    let declared = Declared::of(tree, &mut diagnostics);
    let attributes = attributes(tree, &declared, &mut diagnostics);
    let mut program = Program {
        attributes,
        ..Program::default()
    };
    let mut signatures = Vec::new();
    for item in &tree.items {
        if let Item::Op(op) = item {
            let mut report = Report::default();
            let (signature, resolved) = resolve_op(op, &declared, &program.attributes, &mut report);
            signatures.push(signature);
            program.ops.push(resolved);
            diagnostics.extend(report.into_diagnostics());
        }
    }
    for item in &tree.items {
        if let Item::Script(script) = item {
            let mut report = Report::default();
            let resolved = resolve_script(script, &signatures, &declared, &mut report);
            program.scripts.extend(resolved);
            diagnostics.extend(report.into_diagnostics());
        }
    }
    diagnostics.sort_by_key(Diagnostic::span);
    Resolved {
        program,
        diagnostics,
    }
}
