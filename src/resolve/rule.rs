//! A rule: its two drawings, its conditions and its assignments.

use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Attribute, Ref, Rule};
use crate::syntax::tree::{self, Ident};

use super::condition::{aliases, assignments, guard, requires};
use super::declared::Declared;
use super::drawing::{draw_after, draw_before};
use super::lists::read_lists;
use super::names::Names;
use super::report::Report;
use super::signature::{Parameter, Value};
use super::typing::{Place, Typing};

/// The context of a rule, from its op.
pub(super) struct Context<'a> {
    pub(super) op: &'a tree::Op,
    pub(super) params: &'a [Parameter],
    pub(super) result: Value,
    pub(super) declared: &'a Declared,
    pub(super) attributes: &'a Arc<[Attribute]>,
}

/// Resolves a rule, whose names are read. It is complete only if the report has no error.
pub(super) fn resolve_rule(
    rule: &tree::Rule,
    names: Names,
    context: &Context,
    report: &mut Report,
) -> Option<Rule> {
    let (before, after) = sides(rule, &context.op.name, report)?;
    let drawn_before = draw_before(before, &names, report);
    let drawn_after = draw_after(after, &drawn_before, &names, report);
    let lists = read_lists(after, [&drawn_before, &drawn_after], &names, report);

    let guard = guard(&rule.conditions, context.params, report);
    let aliases = aliases(&rule.conditions, &names, report);

    let place = Place::Rule(&names);
    let mut typing = Typing::new(place, context.declared, context.params, report);
    let op = &context.op.name.text;
    let requires = requires(&rule.conditions, op, &mut typing);
    let assignments = assignments(after, &names, &lists.erased, &mut typing);

    let result = match (&context.op.result, context.result) {
        (Some(name), Value::Of(_)) => returned(name, rule, &names, &lists.erased, report),
        // The op has reported a result that is not an element.
        _ => None,
    };
    let params = context.params.iter();
    let params = params.map(|param| {
        // A value with the name of a drawn element has been reported as an error.
        names.find(&param.name).filter(|_| param.ty.is_some_and(|ty| ty.is_element()))
    });
    let mut rule = Rule {
        label: rule.name.as_ref().map(|name| name.text.clone()),
        example: None,
        broken: None,
        params: params.collect(),
        result,
        before: drawn_before,
        requires,
        guard,
        aliases,
        after: drawn_after,
        created: lists.created,
        erased: lists.erased,
        assignments,
        attributes: Arc::clone(context.attributes),
        span: rule.span,
        cycle: names.cycle(),
        names: names.into_list(),
    };
    rule.assignments.extend(rule.inherited());
    Some(rule)
}

/// Both sides of a rule.
fn sides<'a>(
    rule: &'a tree::Rule,
    op: &Ident,
    report: &mut Report,
) -> Option<(&'a tree::Side, &'a tree::Side)> {
    let missing = match (&rule.before, &rule.after) {
        (Some(before), Some(after)) => return Some((before, after)),
        (Some(_), None) => "no `after`",
        (None, Some(_)) => "no `before`",
        (None, None) => "neither `before` nor `after`",
    };
    let (what, place) = match &rule.name {
        Some(rule) => ("rule", rule),
        None => ("op", op),
    };
    let message = format!("the {what} `{}` has {missing}", place.text);
    report.reject(Diagnostic::error("missing-side", message, place.span))
}

/// The element that the rule returns.
fn returned(
    name: &Ident,
    rule: &tree::Rule,
    names: &Names,
    erased: &[Ref],
    report: &mut Report,
) -> Option<Ref> {
    let word = &name.text;
    let Some(id) = names.find(word) else {
        if let Some(label) = &rule.name {
            report.add(not_returned(name, label));
        }
        return None;
    };
    if let Some(erased) = erased.iter().find(|erased| erased.name == id) {
        let message = format!("`{word}` is returned, but it is erased");
        let error = Diagnostic::error("returns-erased", message, name.span)
            .label(erased.span, "it is erased here");
        report.add(error);
    }
    Some(Ref::plain(id, name.span))
}

fn not_returned(name: &Ident, rule: &Ident) -> Diagnostic {
    let message =
        format!("`{}` is returned, but the rule `{}` does not draw it", name.text, rule.text);
    Diagnostic::error("unknown-result", message, name.span).label(rule.span, "in this rule")
}
