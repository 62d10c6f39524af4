//! The files of a program: the names of all items are resolved first, then the items.

use std::collections::HashMap;

use crate::diagnostic::Diagnostic;
use crate::diagram::Type;
use crate::source::Span;
use crate::syntax::tree::{self, Ident, Item};

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

/// For each word after a dot, by its span, the declaration of the attribute that it names, or
/// `None` for a built-in field. Words of unknown meaning are missing.
pub type Fields = HashMap<Span, Option<Span>>;

/// The types of the variables of functions, ops in steps, scripts and tests, by the spans of their
/// names, also where the item has an error.
pub type Types = HashMap<Span, Type>;

/// A program and its diagnostics.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resolved {
    /// The program, as far as it could be resolved.
    pub program: Program,
    /// The diagnostics, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The meanings of the words after dots.
    pub fields: Fields,
    /// The types of variables.
    pub types: Types,
}

/// Resolves a single file that uses no others: the meaning of every name and the type of every
/// value.
///
/// Items are resolved independently: an error in one does not affect the others. What the parser
/// has already reported is not reported again, and code that it could not read as it is written is
/// left out of the program, as code with an error is.
pub fn resolve(tree: &tree::File) -> Resolved {
    let uses = |item: &Item| matches!(item, Item::Use(_));
    resolve_all(&[Unit {
        qualifier: "",
        tree,
        uses: Vec::new(),
        lacks: tree.items.iter().any(uses),
    }])
}

/// Resolves the files of a program; the first one is the program itself.
///
/// Callees come before callers: first the functions that call no op, then the ops, which may call
/// them, then the functions that call ops, then the steps of ops, then scripts and tests.
pub fn resolve_all(units: &[Unit]) -> Resolved {
    let mut diagnostics = Vec::new();
    let mut declared = Declared::of_all(units, &mut diagnostics);
    let attributes = attributes(units, &mut declared, &mut diagnostics);
    let mut functions = Functions::of(units, declared);
    let qualifiers = units
        .iter()
        .filter_map(|unit| Some((unit.tree.items.first()?.span().file, unit.qualifier.to_owned())));
    let qualifiers = qualifiers.collect();
    let items = units.iter().flat_map(|unit| &unit.tree.items);
    let private = items.filter_map(|item| Some(item.private_name()?.span)).collect();
    let mut program = Program { qualifiers, private, attributes, ..Program::default() };
    let (mut signatures, mut reports) = (Vec::new(), Vec::new());
    functions.resolve(&signatures, |found| !found.calls_ops);
    for (unit, declared) in units.iter().zip(&functions.declared) {
        for item in &unit.tree.items {
            if let Item::Op(op) = item {
                let mut report = Report::default();
                let (signature, mut resolved) =
                    resolve_op(op, declared, &program.attributes, &mut report);
                resolved.misread = unit.tree.is_misread(op.span);
                signatures.push(signature);
                reports.push(report);
                program.ops.push(resolved);
            }
        }
    }
    functions.resolve(&signatures, |found| found.calls_ops);
    let mut number = 0;
    for (unit, declared) in units.iter().zip(&functions.declared) {
        for item in &unit.tree.items {
            let Item::Op(op) = item else { continue };
            if let Some(steps) = &op.steps {
                let (signature, report) = (&signatures[number], &mut reports[number]);
                let resolved = resolve_steps(op, steps, signature, &signatures, declared, report);
                program.ops[number].steps = resolved.filter(|_| !program.ops[number].misread);
            }
            number += 1;
        }
    }
    diagnostics.extend(reports.into_iter().flat_map(Report::into_diagnostics));
    let mut tests = HashMap::new();
    for (unit, declared) in units.iter().zip(&functions.declared) {
        for item in &unit.tree.items {
            if let Item::Script(script) = item {
                let mut report = Report::default();
                let resolved = resolve_script(script, &signatures, declared, &mut report);
                let resolved = resolved.filter(|_| !unit.tree.is_misread(script.span));
                let place = resolved.is_some().then_some(program.scripts.len());
                let Ident { text, span } = &script.name;
                program.called_scripts.push((text.clone(), *span, place));
                program.scripts.extend(resolved);
                diagnostics.extend(report.into_diagnostics());
            }
            if let Item::Test(test) = item {
                let name = test.name_span;
                let first = *tests.entry((name.file, &test.name)).or_insert(name);
                if first != name {
                    let message = format!("another test is called `{}`", test.name);
                    let told = Diagnostic::warning("duplicate-name", message, name);
                    diagnostics.push(told.label(first, "the first one"));
                }
                let mut report = Report::default();
                let resolved = resolve_test(test, &signatures, declared, &mut report);
                match resolved.filter(|_| !unit.tree.is_misread(test.span)) {
                    Some(resolved) => program.tests.push(resolved),
                    None => program.unread_tests.push((test.name.clone(), test.span)),
                }
                diagnostics.extend(report.into_diagnostics());
            }
        }
    }
    diagnostics.extend(functions.take_diagnostics());
    let (mut fields, mut types) = (Fields::new(), Types::new());
    for declared in &mut functions.declared {
        fields.extend(declared.take_met());
        types.extend(declared.take_types());
    }
    program.functions = functions.into_resolved();
    diagnostics.sort_by_key(Diagnostic::span);
    Resolved { program, diagnostics, fields, types }
}
