//! Refactorings: what `after` lacks, the inverse of an op, an alternative as an op of its own,
//! `keep` for what stays as it is.

use std::collections::HashSet;

use super::action::{Action, Purpose};
use super::cursor_context::{op_near, rule_near};
use super::edits::{append, indentation, slice};
use super::hover::op_named;
use super::invert::inverse;
use super::side::{left_open, subject};
use super::snapshot::Snapshot;
use super::soundness::stays_sound;
use crate::diagnostic::Edit;
use crate::source::Span;
use crate::syntax::tree::{Op, Rule, Side, Statement};

/// The refactorings at a byte.
pub(super) fn rewriting(snapshot: &Snapshot, offset: usize) -> Vec<Action> {
    let Some((_, op)) = op_near(snapshot, offset).filter(|(_, op)| op.span.touches(offset)) else {
        return Vec::new();
    };
    if snapshot.parsed().tree.is_misread(op.span) {
        return Vec::new();
    }
    let mut actions = Vec::new();
    let mut offer = |title: String, edits: Option<Vec<Edit>>| {
        let edits = edits.filter(|edits| stays_sound(snapshot, op, edits));
        actions.extend(edits.map(|edits| Action {
            title,
            purpose: Purpose::Rewrite,
            edits,
            mends: None,
        }));
    };
    if let Some((_, at, rule)) = rule_near(snapshot, offset) {
        let title = match is_empty(rule.after.as_ref()) {
            true => "write `after` as `before`",
            false => "restate what `after` lacks",
        };
        offer(title.into(), skeleton(snapshot, rule));
        let title = "write `keep` for what stays as it is";
        offer(title.into(), keep_what_stays(snapshot, rule));
        if let Some(name) = &rule.name {
            let own = format!("{}_{}", op.name.text, name.text);
            let title = format!("move `{}` to an op of its own, `{own}`", name.text);
            offer(title, split_out(snapshot, op, at, &own));
        }
    }
    let is_proved = |op: &Op| {
        let proved = snapshot.resolved(op).map(|at| snapshot.examined(at).proved.is_some());
        proved == Some(true)
    };
    let is_here = op.name.span.touches(offset) || op.span.start as usize + 2 >= offset;
    if is_here && is_proved(op) {
        let name = format!("un{}", op.name.text);
        let title = format!("write the inverse, `{name}`");
        offer(title, inverse(snapshot, op, &name));
    }
    actions
}

fn is_empty(side: Option<&Side>) -> bool {
    side.is_none_or(|side| side.statements.is_empty())
}

/// The edit that restates the statements of `before` that `after` does not mention.
fn skeleton(snapshot: &Snapshot, rule: &Rule) -> Option<Vec<Edit>> {
    let before = rule.before.as_ref()?;
    let missing: Vec<String> =
        left_open(rule).map(|statement| slice(snapshot, statement).to_owned()).collect();
    if missing.is_empty() {
        return None;
    }
    match &rule.after {
        Some(after) => Some(vec![append(snapshot, after, &missing)]),
        None => {
            let indentation = indentation(snapshot, before.span);
            let mut text = format!("\n{indentation}after {{");
            for statement in &missing {
                text.push_str(&format!("\n{indentation}  {statement}"));
            }
            text.push_str(&format!("\n{indentation}}}"));
            let span = before.span.after();
            Some(vec![Edit { span, text }])
        }
    }
}

/// The edits that replace statements of `after` that repeat `before` word for word by one `keep`.
fn keep_what_stays(snapshot: &Snapshot, rule: &Rule) -> Option<Vec<Edit>> {
    let (before, after) = (rule.before.as_ref()?, rule.after.as_ref()?);
    let words = |statement: &Statement| -> Vec<String> {
        slice(snapshot, statement).split_whitespace().map(str::to_owned).collect()
    };
    let same: Vec<&Statement> = after
        .statements
        .iter()
        .filter(|statement| {
            subject(statement).is_some()
                && before.statements.iter().any(|was| words(was) == words(statement))
        })
        .collect();
    let (first, rest) = same.split_first()?;
    let mut names: Vec<_> = same
        .iter()
        .filter_map(|statement| subject(statement))
        .map(|name| name.to_string())
        .collect();
    // What stands there twice is kept once.
    let mut seen = HashSet::new();
    names.retain(|name| seen.insert(name.clone()));
    let mut edits = vec![Edit { span: first.span(), text: format!("keep {}", names.join(" ")) }];
    for statement in rest {
        let span = statement.span();
        let before = &snapshot.text()[..span.start as usize];
        let start = before.trim_end_matches([' ', '\t']).trim_end_matches(['\n', '\r']).len();
        edits.push(Edit {
            span: Span::new(span.file, start, span.end as usize),
            text: String::new(),
        });
    }
    Some(edits)
}

/// The edits that move a rule to an op of its own, after the op.
fn split_out(snapshot: &Snapshot, op: &Op, at: usize, name: &str) -> Option<Vec<Edit>> {
    if op.rules.len() < 2 || op_named(snapshot, name).is_some() {
        return None;
    }
    let rule = &op.rules[at];
    let text = snapshot.sources().slice(rule.span);
    let open = text.find('{')?;
    let whole = snapshot.sources().slice(op.span);
    let head = &whole[..whole.find('{')?];
    let head = head.replacen(&op.name.text, name, 1);
    let body = text[open..].replace("\n  ", "\n");
    // The comment above the rule goes with it.
    let before = &snapshot.text()[op.span.start as usize..rule.span.start as usize];
    let mut start = before.trim_end_matches([' ', '\t']).trim_end_matches(['\n', '\r']).len();
    let mut comment = String::new();
    while let Some((rest, line)) = before[..start].rsplit_once('\n')
        && line.trim_start().starts_with("//")
    {
        comment.insert_str(0, &format!("{}\n", line.trim()));
        start = rest.trim_end_matches('\r').len();
    }
    let start = op.span.start as usize + start;
    Some(vec![
        Edit {
            span: Span::new(rule.span.file, start, rule.span.end as usize),
            text: String::new(),
        },
        Edit { span: op.span.after(), text: format!("\n\n{comment}{head}{body}") },
    ])
}
