//! The files of a program: first the names of all items, then the items.

use std::collections::HashMap;

use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::tree::{self, Item};

use super::attribute::attributes;
use super::declared::Declared;
use super::functions::Functions;
use super::op::resolve_op;
use super::program::Program;
use super::report::Report;
use super::script::resolve_script;
use super::steps::resolve_steps;
use super::testing::resolve_test;
use super::unit::Unit;

/// For each word behind a dot, by its place, where the attribute that it names is declared; `None`
/// if it is a field of the language. A word is not there if its meaning is not known.
pub type Fields = HashMap<Span, Option<Span>>;

/// A program, and what is wrong with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resolved {
    /// The program, as far as it could be understood.
    pub program: Program,
    /// The mistakes, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The meanings of the words behind dots.
    pub fields: Fields,
}

/// Finds what every name of a file means that uses no other, and what type every value has.
///
/// Items are resolved one by one: a mistake in one costs no other. Nothing is said
/// about what the parser has complained of already.
pub fn resolve(tree: &tree::File) -> Resolved {
    let uses = |item: &Item| matches!(item, Item::Use(_));
    resolve_all(&[Unit { tree, uses: Vec::new(), lacks: tree.items.iter().any(uses) }])
}

/// The same for the files of a program, the first of which is the program itself.
///
/// Functions come before what calls them: first those that call no op, then the ops, which
/// may ask them, then the functions that call ops, then the steps of ops, then the scripts.
pub fn resolve_all(units: &[Unit]) -> Resolved {
    let mut diagnostics = Vec::new();
    let declared = Declared::of_all(units, &mut diagnostics);
    let attributes = attributes(units, &declared, &mut diagnostics);
    let mut functions = Functions::of(units, declared);
    let mut program = Program { attributes, ..Program::default() };
    let mut signatures = Vec::new();
    functions.resolve(&signatures, |found| !found.calls_ops);
    for (unit, declared) in units.iter().zip(&functions.declared) {
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
    functions.resolve(&signatures, |found| found.calls_ops);
    let mut number = 0;
    for (unit, declared) in units.iter().zip(&functions.declared) {
        for item in &unit.tree.items {
            let Item::Op(op) = item else {
                continue;
            };
            if let Some(steps) = &op.steps {
                let mut report = Report::default();
                let signature = &signatures[number];
                program.ops[number].steps =
                    resolve_steps(op, steps, signature, &signatures, declared, &mut report);
                diagnostics.extend(report.into_diagnostics());
            }
            number += 1;
        }
    }
    for (unit, declared) in units.iter().zip(&functions.declared) {
        for item in &unit.tree.items {
            if let Item::Script(script) = item {
                let mut report = Report::default();
                let resolved = resolve_script(script, &signatures, declared, &mut report);
                let place = resolved.is_some().then_some(program.scripts.len());
                program.called_scripts.push(place);
                program.scripts.extend(resolved);
                diagnostics.extend(report.into_diagnostics());
            }
            if let Item::Test(test) = item {
                let mut report = Report::default();
                match resolve_test(test, &signatures, declared, &mut report) {
                    Some(resolved) => program.tests.push(resolved),
                    None => program.unread_tests.push((test.name.clone(), test.span)),
                }
                diagnostics.extend(report.into_diagnostics());
            }
        }
    }
    diagnostics.extend(functions.take_diagnostics());
    let fields = functions.declared.iter_mut().flat_map(Declared::take_met).collect();
    program.functions = functions.into_resolved();
    diagnostics.sort_by_key(Diagnostic::span);
    Resolved { program, diagnostics, fields }
}
