//! An op: parameters, result, and its rules one by one.

use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{self, Attribute, Kind, Type};
use crate::syntax::foreign_syntax::type_word;
use crate::syntax::tree::{self, Arrow, Ident, Statement};

use super::declared::{Declared, duplicate};
use super::family::{is_family, read_index};
use super::names::Names;
use super::parameter::{Owner, parameters};
use super::program;
use super::property::properties;
use super::report::Report;
use super::rule::{Context, resolve_rule};
use super::signature::{Parameter, Signature, Value};
use super::steps::steps_signature;
use super::suggestion::suggest;

/// The maximum number of halfedges and statements in `before`: every pair of halfedges may have to
/// be proved distinct.
const MOST_BEFORE: usize = 256;
/// The maximum number of halfedges and statements in `after`.
const MOST_AFTER: usize = 1024;
/// The maximum number of spokes and listed names of a side.
const MOST_LISTED: usize = 4096;
/// The maximum number of rules of an op.
const MOST_RULES: usize = 1024;

/// Resolves an op.
pub(super) fn resolve_op(
    op: &tree::Op,
    declared: &Declared,
    attributes: &Arc<[Attribute]>,
    report: &mut Report,
) -> (Signature, program::Op) {
    if !declared.has_its_name(&op.name) {
        report.fail();
    }
    let params = parameters(&op.params, Owner::Op, declared, report);
    if op.steps.is_some() {
        return steps_signature(op, params, report);
    }
    let keeps = properties(&op.keeps, report);
    rule_names(&op.rules, report);
    if op.rules.is_empty() {
        let message = format!("the op `{}` has neither `before` nor `after`", op.name.text);
        report.add(Diagnostic::error("missing-side", message, op.name.span));
    }
    if has_too_many_rules(op, report) || op.rules.iter().any(|rule| draws_too_much(rule, report)) {
        let result = Value::Unknown;
        let signature = Signature { name: op.name.text.clone(), params, result };
        let resolved = signature.op(op.name.span, None);
        return (signature, resolved);
    }
    let names = op.rules.iter().map(|rule| {
        let letter = read_index(rule, &op.params, report);
        Names::of(rule, &params, letter, report)
    });
    let names: Vec<Names> = names.collect();
    let result = match &op.result {
        None => Value::Nothing,
        Some(name) => result_type(name, &names, report).map_or(Value::Unknown, Value::Of),
    };
    if let Some(name) = &op.result {
        one_result(name, op, report);
    }
    let mut rules = Vec::new();
    let context = Context { op, params: &params, result, declared, attributes };
    for (rule, names) in op.rules.iter().zip(names) {
        rules.extend(resolve_rule(rule, names, &context, report));
    }
    let is_complete = !report.failed() || report.has_only("open-loop");
    let drawn = (is_complete && rules.len() == op.rules.len()).then(|| diagram::Op {
        name: op.name.text.clone(),
        name_span: op.name.span,
        docs: op.docs.clone(),
        params: params.iter().map(Parameter::param).collect(),
        result: result.ty(),
        keeps,
        rules,
        span: op.span,
    });
    let signature = Signature { name: op.name.text.clone(), params, result };
    let (diagram, open) = if report.failed() { (None, drawn) } else { (drawn, None) };
    let mut resolved = signature.op(op.name.span, diagram);
    resolved.open = open.map(Box::new);
    let is_still = op.rules.iter().all(|rule| rule.after == rule.before);
    if resolved.diagram.is_none() && !is_still {
        let (_, still) = resolve_op(&still(op), declared, attributes, &mut Report::default());
        resolved.still = still.diagram.map(Box::new);
    }
    (signature, resolved)
}

/// A copy of the op whose `after` repeats its `before`, without result, properties, and conditions
/// other than `alias`.
fn still(op: &tree::Op) -> tree::Op {
    let mut still = tree::Op { result: None, keeps: Vec::new(), ..op.clone() };
    for rule in &mut still.rules {
        rule.conditions.retain(|condition| matches!(condition, tree::Condition::Alias { .. }));
        rule.after = rule.before.clone();
    }
    still
}

/// Reports an op with more than the maximum number of rules.
fn has_too_many_rules(op: &tree::Op, report: &mut Report) -> bool {
    let is_too_much = op.rules.len() > MOST_RULES;
    if is_too_much {
        let count = op.rules.len();
        let message = format!("this op has {count} rules, and there can be {MOST_RULES}");
        let error = Diagnostic::error("too-large", message, op.name.span);
        report.add(error.note("an op in steps, `steps { … }`, tries several ops in turn"));
    }
    is_too_much
}

/// Reports a side of a rule that draws too much. Nothing else is then checked in the op, whose
/// proof would take too long.
fn draws_too_much(rule: &tree::Rule, report: &mut Report) -> bool {
    let sides = [("before", &rule.before, MOST_BEFORE), ("after", &rule.after, MOST_AFTER)];
    let mut is_too_much = false;
    for (word, side, most) in sides {
        let Some(side) = side else { continue };
        let mut expect = |count: usize, most: usize, told: &str, note: &str| {
            if count > most {
                let message = format!("`{word}` {told}, and there can be {most}");
                report.add(Diagnostic::error("too-large", message, side.span).note(note));
                is_too_much = true;
            }
        };
        let drawn = side.statements.iter().map(|statement| match statement {
            Statement::Loop(orbit) => {
                let arrows = orbit.items.iter().map(|item| &item.arrow);
                arrows.filter(|arrow| matches!(arrow, Arrow::Halfedge(_))).count()
            }
            _ => 1,
        });
        let count = drawn.sum();
        expect(
            count,
            most,
            &format!("draws {count} halfedges and statements"),
            "draw a run that stays as it is as a path, `v0 =P=> v1`, and what repeats around a face \
             or a vertex as a family, `each i { … }`",
        );
        let listed = side.statements.iter().map(|statement| match statement {
            Statement::Vertex(star) => star.spokes.len(),
            Statement::New(names, _) | Statement::Erase(names, _) | Statement::Keep(names, _) => {
                names.len()
            }
            _ => 0,
        });
        let count = listed.sum();
        expect(
            count,
            MOST_LISTED,
            &format!("lists {count} spokes and names"),
            "write spokes that stay as they are as a fan, `*S`, and what repeats as a family, \
             `each i { … }`",
        );
    }
    is_too_much
}

/// Reports a family as a result: it is many elements, and an op returns one.
fn one_result(name: &Ident, op: &tree::Op, report: &mut Report) {
    let mut sides = op.rules.iter().flat_map(|rule| [&rule.before, &rule.after]);
    if sides.any(|side| side.as_ref().is_some_and(|side| is_family(side, &name.text))) {
        let message = format!("`{}` is a family, and an op returns one element", name.text);
        report.add(Diagnostic::error("two-forms", message, name.span));
    }
}

/// Reports rules of an op that have the same name.
fn rule_names(rules: &[tree::Rule], report: &mut Report) {
    let named: Vec<&Ident> = rules.iter().filter_map(|rule| rule.name.as_ref()).collect();
    for (place, name) in named.iter().enumerate() {
        let first = named[..place].iter().find(|first| first.text == name.text);
        if let Some(first) = first {
            report.add(duplicate("a rule", name, first.span));
        }
    }
}

/// The error for a kind as a result: a drawn op returns one of its names.
fn kind_returned(kind: Kind, word: &Ident, rules: &[Names]) -> Diagnostic {
    let message =
        format!("`{}` is a kind, and an op that is drawn returns one of its names", word.text);
    let error = Diagnostic::error("unknown-result", message, word.span);
    let is_one = |names: &Names, name: &str| {
        let id = names.find(name);
        id.is_some_and(|id| names.get(id).kind == kind)
    };
    let mut drawn =
        rules.iter().flat_map(|names| names.words().filter(move |name| is_one(names, name)));
    match drawn.next() {
        Some(name) => error.note(format!("write the name, for example `-> {name}`")),
        None => error.note(format!("draw {} and write its name here", kind.a_word())),
    }
}

/// The result type of an op: the type of the returned name in its rules.
fn result_type(name: &Ident, rules: &[Names], report: &mut Report) -> Option<Type> {
    let word = &name.text;
    let mut kinds: Vec<Kind> = Vec::new();
    for names in rules {
        kinds.extend(names.find(word).map(|id| names.get(id).kind));
    }
    let Some(first) = kinds.first().copied() else {
        if let Some(kind) = Type::named(word).and_then(Type::element_kind) {
            return report.reject(kind_returned(kind.into(), name, rules));
        }
        let message = format!("`{word}` is returned, but it is drawn nowhere");
        let error = Diagnostic::error("unknown-result", message, name.span);
        let drawn = rules.iter().flat_map(Names::words);
        let error = match Type::named(word).is_some() || type_word(word).is_some() {
            true => error.note(
                "an op names the element that it returns, `-> m`; whether it applied is asked by \
                 `if flip(e) { … }`",
            ),
            false => suggest(error, word, name.span, drawn),
        };
        return report.reject(error);
    };
    if let Some(other) = kinds.iter().find(|kind| **kind != first) {
        let message = format!(
            "`{word}` is returned as {} by one rule and as {} by another",
            first.a_word(),
            other.a_word()
        );
        return report.reject(Diagnostic::error("result-kind", message, name.span));
    }
    let ty = first.element_type();
    if ty.is_none() {
        let message = format!(
            "`{word}` is {}; an op returns a vertex, a halfedge, an edge or a face",
            first.a_word()
        );
        report.add(Diagnostic::error("not-an-element", message, name.span));
    }
    ty
}
