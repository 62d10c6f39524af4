//! Levels that an op claims to keep: nothing may be left to test.

use super::guard::{Obligation, obligations};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Level, Op, Rule};
use crate::source::Span;

/// The levels, of those that are more than a map, that a mesh has after the rule if it had
/// them before.
pub(super) fn kept(drawing: &Drawing) -> Vec<Level> {
    let levels = [Level::Surface, Level::Simple];
    let kept = levels
        .into_iter()
        .filter(|&level| left_of(drawing, level).is_empty());
    kept.collect()
}

/// What would have to be tested. A guard tests all that its level asks, and an op with a
/// guard is only used on meshes of that level.
fn left_of(drawing: &Drawing, level: Level) -> Vec<Obligation> {
    if drawing.rule.guard.is_some_and(|(guard, _)| guard >= level) {
        return Vec::new();
    }
    let mut left = obligations(drawing, level);
    left.retain(Obligation::is_test);
    left
}

/// Tests each level that the op claims to keep on each of its rules.
pub(super) fn test(op: &Op) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    for &(level, span) in &op.keeps {
        for rule in &op.rules {
            let drawing = Drawing::new(rule);
            let left = left_of(&drawing, level);
            if !left.is_empty() {
                diagnostics.push(not_kept(op, rule, (level, span), &left));
            }
        }
    }
    diagnostics
}

fn not_kept(op: &Op, rule: &Rule, (level, span): (Level, Span), left: &[Obligation]) -> Diagnostic {
    let who = match &rule.label {
        Some(label) => format!("the rule `{label}` of `{}`", op.name),
        None => format!("`{}`", op.name),
    };
    let message = format!("it is not proved that {who} keeps a mesh {level}");
    let mut diagnostic = Diagnostic::error("level-not-kept", message, span)
        .saying("claimed here")
        .label(rule.after.span, "after this, it is to be shown that …");
    for obligation in left {
        diagnostic = diagnostic.note(format!(
            "… {}; else {}",
            obligation.statement.claim(rule),
            obligation.statement.refusal(rule)
        ));
    }
    match rule.guard {
        Some((_, guard)) => diagnostic.label(guard, format!("`guard {level}` would test that")),
        None => {
            let place = rule.after.span.before();
            diagnostic
                .note(format!(
                    "`guard {level}` tests just that, and refuses where it fails"
                ))
                .fix(
                    format!("insert `guard {level}`"),
                    place,
                    format!("guard {level}\n  "),
                )
        }
    }
}
