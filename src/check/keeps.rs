//! Levels that a rule claims to keep: nothing may be left to test.

use super::guard::{Obligation, obligations};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Level};

/// The tests of the result that would be needed for a mesh of the level to stay one. A guard tests
/// all that its level asks, and a rule with a guard is for meshes of that level.
pub(super) fn left_to_test(drawing: &Drawing, level: Level) -> Vec<Obligation> {
    if drawing.rule.guard.is_some_and(|(guard, _)| guard >= level) {
        return Vec::new();
    }
    let mut left = obligations(drawing, level);
    left.retain(|one| one.is_test() && drawing.rule.is_first(one.statement.subject()));
    left
}

/// Adds to the diagnostic what may come about, and offers the guard that refuses it.
pub(super) fn not_kept(drawing: &Drawing, mut diagnostic: Diagnostic, level: Level) -> Diagnostic {
    let rule = drawing.rule;
    for Obligation { statement, .. } in left_to_test(drawing, level) {
        let subject = statement.subject();
        let place = drawing.after.mention(subject).unwrap_or(rule.after.span);
        diagnostic = diagnostic.label(place, format!("perhaps {}", statement.refusal(rule)));
    }
    if let Some((_, guard)) = rule.guard {
        return diagnostic.label(guard, format!("`guard {level}` would refuse where it is so"));
    }
    diagnostic.note(format!("`guard {level}` refuses where it is so, and nowhere else")).fix(
        format!("insert `guard {level}`"),
        rule.after.span.before(),
        format!("guard {level}\n  "),
    )
}
