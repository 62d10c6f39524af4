//! Properties that an operation claims to keep and does not.

use super::change::Change;
use super::facts::Facts;
use super::guard::Obligation;
use super::keeps::left_to_test;
use super::problem::Problem;
use super::properties::wrong_size;
use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{Drawing, Level, Op, Property};

/// The properties that `keeps` declares and the rule does not keep.
pub(super) fn broken_claims(op: &Op, drawing: &Drawing, facts: &Facts) -> Vec<Problem> {
    let broken = op.keeps.iter().filter(|(property, _)| !facts.keeps.contains(property));
    broken
        .map(|&(property, span)| {
            let word = property.word();
            let rule = drawing.rule.label.as_ref();
            let who =
                rule.map_or_else(|| format!("`{}`", op.name), |rule| format!("the rule `{rule}`"));
            let message = format!("{who} does not keep `{word}`");
            let diagnostic = Diagnostic::error("property-not-kept", message, span);
            let why = match property {
                Property::Level(level) => {
                    return not_kept(drawing, diagnostic, level).into();
                }
                Property::Triangles => wrong_size(drawing, 3),
                Property::Quads => wrong_size(drawing, 4),
                Property::Euler => Some(euler_changes(facts)),
                Property::Boundary => {
                    Some("a hole may lose or gain vertices, or come or go".into())
                }
                Property::ConstantTime => {
                    Some(format!("its time grows with {}", all_of(&facts.grows_with)))
                }
            };
            diagnostic.with(why, Diagnostic::note).into()
        })
        .collect()
}

/// The change of V - E + F, with holes among the faces, in words.
fn euler_changes(facts: &Facts) -> String {
    let constant = facts.change.euler();
    let per_index = facts.per_index.map_or(0, Change::euler);
    match (constant, per_index) {
        (_, 0) => format!("V - E + F, with holes, changes by {constant:+}"),
        (0, _) => format!("V - E + F, with holes, changes by {per_index:+} for each index"),
        _ => format!(
            "V - E + F, with holes, changes by {constant:+}, and by {per_index:+} for each index"
        ),
    }
}

/// Adds the conditions that may be broken to the diagnostic, and offers the guard that tests them.
fn not_kept(drawing: &Drawing, mut diagnostic: Diagnostic, level: Level) -> Diagnostic {
    let rule = drawing.rule;
    for Obligation { statement, .. } in left_to_test(drawing, level) {
        let subject = statement.of;
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
