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

/// A file of a program.
#[derive(Clone, Debug)]
pub struct Unit<'t> {
    /// What it says.
    pub tree: &'t tree::File,
    /// The files it uses, by their places among the units.
    pub uses: Vec<usize>,
    /// Whether it uses others that could not be had.
    pub lacks: bool,
}

/// Finds what every name of a file means that uses no other, and what type every value has.
///
/// Items are resolved one by one: a mistake in one costs no other. Nothing is said
/// about what the parser has complained of already.
pub fn resolve(tree: &tree::File) -> Resolved {
    let uses = |item: &Item| matches!(item, Item::Use(_));
    resolve_all(&[Unit {
        tree,
        uses: Vec::new(),
        lacks: tree.items.iter().any(uses),
    }])
}

/// The same for the files of a program, the first of which is the program itself.
pub fn resolve_all(units: &[Unit]) -> Resolved {
    let mut diagnostics = Vec::new();
    let declared = Declared::of_all(units, &mut diagnostics);
    let mut program = Program {
        attributes: attributes(units, &declared, &mut diagnostics),
        ..Program::default()
    };
    let mut signatures = Vec::new();
    for (unit, declared) in units.iter().zip(&declared) {
        for item in &unit.tree.items {
            if let Item::Op(op) = item {
                let mut report = Report::default();
                let (signature, resolved) =
                    resolve_op(op, declared, &program.attributes, &mut report);
                signatures.push(signature);
                program.ops.push(resolved);
                diagnostics.extend(report.into_diagnostics());
            }
        }
    }
    for (unit, declared) in units.iter().zip(&declared) {
        for item in &unit.tree.items {
            if let Item::Script(script) = item {
                let mut report = Report::default();
                let resolved = resolve_script(script, &signatures, declared, &mut report);
                program.scripts.extend(resolved);
                diagnostics.extend(report.into_diagnostics());
            }
        }
    }
    diagnostics.sort_by_key(Diagnostic::span);
    Resolved {
        program,
        diagnostics,
    }
}
