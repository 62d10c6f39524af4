//! Commas between the names of a list, `erase b, e, h`: they are allowed, and formatting replaces
//! them with blanks, so that all positions stay the same.

use crate::syntax::tree::{Condition, Item, Side, Statement};
use crate::syntax::{Parsed, TokenKind};
use std::borrow::Cow;
use std::ops::Range;

/// The text without such commas, and its parse; items with errors keep theirs.
pub(super) fn without_commas<'t>(
    source: &'t str,
    parsed: &'t Parsed,
) -> (Cow<'t, str>, Cow<'t, Parsed>) {
    let lists = lists(parsed);
    let commas = parsed.tokens.iter().filter(|token| {
        let place = token.span.start as usize;
        let at = lists.partition_point(|list| list.end <= place);
        token.kind == TokenKind::Comma && lists.get(at).is_some_and(|list| list.contains(&place))
    });
    let commas: Vec<Range<usize>> = commas.map(|token| token.span.range()).collect();
    if commas.is_empty() {
        return (Cow::Borrowed(source), Cow::Borrowed(parsed));
    }
    let mut text = source.to_owned();
    let mut plain = parsed.clone();
    for comma in &commas {
        text.replace_range(comma.clone(), " ");
    }
    plain.tokens.retain(|token| !commas.contains(&token.span.range()));
    (Cow::Owned(text), Cow::Owned(plain))
}

/// The ranges of lists of names, in order.
fn lists(parsed: &Parsed) -> Vec<Range<usize>> {
    let mut lists = Vec::new();
    for item in &parsed.tree.items {
        let Item::Op(op) = item else { continue };
        let wrong =
            |told: &crate::diagnostic::Diagnostic| op.span.touches(told.span().start as usize);
        if parsed.diagnostics.iter().any(wrong) {
            continue;
        }
        for rule in &op.rules {
            lists.extend(rule.before.iter().flat_map(of_side));
            lists.extend(rule.conditions.iter().filter_map(|condition| match condition {
                Condition::Alias { span, .. } => Some(span.range()),
                _ => None,
            }));
            lists.extend(rule.after.iter().flat_map(of_side));
        }
    }
    lists.sort_by_key(|list| list.start);
    lists
}

fn of_side(side: &Side) -> impl Iterator<Item = Range<usize>> {
    side.statements.iter().filter_map(|statement| match statement {
        Statement::New(_, span) | Statement::Keep(_, span) | Statement::Erase(_, span) => {
            Some(span.range())
        }
        Statement::Vertex(star) => Some(star.span.range()),
        _ => None,
    })
}
