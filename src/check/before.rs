//! Whether `before` alone contradicts itself.
//!
//! Then no mesh matches, and whatever else may be wrong follows from it or does not matter yet.
//! It is found by the laws themselves: a rule that changes nothing breaks them only where its
//! drawing cannot be.

use super::problem::Problem;
use super::proved::Broken;
use super::{ends_agree, next_is_permutation, twin_is_involution, vertices_are_orbits};
use crate::diagram::{Drawing, Rule};

/// The codes of what no mesh matches.
const IMPOSSIBLE: [&str; 5] =
    ["impossible-drawing", "ends-disagree", "spoke-twice", "twin-twice", "twin-of-itself"];

/// What in `before` no mesh matches, if something is so.
pub(super) fn contradictions(rule: &Rule) -> Option<Broken> {
    let still = Rule {
        after: rule.before.clone(),
        created: Vec::new(),
        erased: Vec::new(),
        assignments: Vec::new(),
        ..rule.clone()
    };
    let drawing = Drawing::new(&still);
    let mut problems = next_is_permutation::test(&drawing);
    problems.extend(twin_is_involution::test(&drawing));
    problems.extend(ends_agree::test(&drawing));
    if problems.is_empty() && rule.size().is_none() {
        let rings = vertices_are_orbits::test(&drawing);
        problems.extend(rings.err().into_iter().flat_map(|broken| broken.problems));
    }
    if !problems.iter().any(|problem| IMPOSSIBLE.contains(&problem.diagnostic.code)) {
        return None;
    }
    let mut told: Vec<Problem> = Vec::new();
    for problem in problems {
        // What is said of `before` is said again of the copy that stands for `after`.
        let (code, span) = (problem.diagnostic.code, problem.diagnostic.span());
        let again = |one: &Problem| (one.diagnostic.code, one.diagnostic.span()) == (code, span);
        if !problem.diagnostic.message.contains("`after`") && !told.iter().any(again) {
            told.push(problem);
        }
    }
    let first = &mut told.first_mut()?.diagnostic;
    if !first.message.starts_with("no mesh matches") {
        first.notes.push("no mesh matches `before`: it contradicts itself".into());
    }
    Some(told.into())
}
