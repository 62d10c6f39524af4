//! Reasons why an op without errors of its own is not proved: something that it depends on is
//! broken.

use super::files::{Part, touches};
use crate::diagnostic::Diagnostic;
use crate::resolve::Program;
use crate::rewrite::Plan;
use crate::source::{Sources, Span};
use crate::syntax::tree::Item;

/// For each op without a plan and without an error in its own text, finds the broken thing that it
/// names: an op without a plan, a function or an attribute with an error, or a file that could not
/// be read. Reasons that are already set stay.
pub(super) fn tell_what_is_lacking(
    program: &Program,
    parts: &[Part],
    sources: &Sources,
    (plans, told): (&[Option<Plan>], &[Diagnostic]),
    lacks: &mut [Option<String>],
) {
    if plans.iter().all(Option::is_some) {
        return;
    }
    let is_wrong =
        |span: Span| told.iter().any(|told| told.is_error() && touches(span, told.span()));
    let items =
        parts.iter().flat_map(|part| part.parsed.tree.items.iter().map(move |item| (part, item)));
    let items: Vec<(&Part, &Item)> = items.collect();
    let mut broken: Vec<&str> = Vec::new();
    let mut broken_attribute = None;
    for (_, item) in &items {
        let name = match item {
            Item::Fn(function) => &function.name.text,
            Item::Attr(attr) => &attr.name.text,
            _ => continue,
        };
        if is_wrong(item.span()) {
            broken.push(name);
            if matches!(item, Item::Attr(_)) {
                broken_attribute.get_or_insert(name.as_str());
            }
        }
    }
    let functions = program.functions.iter().filter(|function| function.body.is_none());
    broken.extend(functions.map(|function| function.name.as_str()));
    let without_plan = program.ops.iter().zip(plans).filter(|(_, plan)| plan.is_none());
    broken.extend(without_plan.map(|(op, _)| op.name.as_str()));
    for ((op, plan), lacks) in program.ops.iter().zip(plans).zip(lacks) {
        if plan.is_some() || lacks.is_some() {
            continue;
        }
        let is_this = |item: &Item| matches!(item, Item::Op(tree) if tree.name.span == op.span);
        let Some((part, item)) = items.iter().find(|(_, item)| is_this(item)) else { continue };
        let span = item.span();
        if is_wrong(span) {
            continue;
        }
        let inside = part.parsed.tokens.iter().filter(|token| {
            span.start <= token.span.start && token.span.end <= span.end && token.span != op.span
        });
        let mut words = inside.map(|token| sources.slice(token.span));
        *lacks = match words.find(|word| broken.contains(word)) {
            Some(word) => Some(word.to_owned()),
            None if part.lacks => Some("a file that cannot be used".to_owned()),
            // The values of new elements are not known.
            None => broken_attribute.map(str::to_owned),
        };
    }
}
