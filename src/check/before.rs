//! Contradictions in `before` alone.
//!
//! No mesh matches such a `before`, and whatever else is wrong follows from that or does not matter
//! yet. The laws themselves find the contradictions: a rule that changes nothing breaks them only
//! where its drawing is impossible.

use std::collections::BTreeSet;

use super::broken::Broken;
use super::problem::{Problem, enumerate};
use super::sizes::Sizes;
use super::{
    alias, ends_agree, family_rings, next_is_permutation, twin_is_involution, vertices_are_orbits,
};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Op, Rule};

/// The codes of problems with which no mesh matches.
const IMPOSSIBLE: [&str; 5] =
    ["impossible-drawing", "ends-disagree", "spoke-twice", "twin-twice", "twin-of-itself"];

/// The contradictions in the `before` of an op, which no mesh matches.
pub fn contradictions(op: &Op) -> Vec<Diagnostic> {
    let found = op.rules.iter().filter_map(|rule| match rule.has_families() {
        true => in_before(&Sizes::new(rule).large.rule),
        false => in_before(rule),
    });
    let problems = found.flat_map(|broken| broken.problems);
    let mut told: Vec<_> = problems.map(|problem| problem.diagnostic).collect();
    // The members of a family have the same problems.
    let mut seen = BTreeSet::new();
    told.retain(|one| seen.insert((one.code, one.span())));
    told
}

/// The contradictions in `before`, if there are any.
pub(super) fn in_before(rule: &Rule) -> Option<Broken> {
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
    if problems.is_empty() {
        problems.extend(ends_agree::test(&drawing));
    }
    if problems.is_empty() {
        let rings = match rule.size() {
            None => vertices_are_orbits::test(&drawing),
            Some(_) => family_rings::test(&drawing),
        };
        problems.extend(rings.err().into_iter().flat_map(|broken| broken.problems));
    }
    if problems.is_empty() {
        problems.extend(ends_agree::neighbors_are_twins(&drawing));
    }
    if let Some(told) = always_one(&still, &problems) {
        return Some(vec![Problem::from(told)].into());
    }
    if !problems.iter().any(|problem| IMPOSSIBLE.contains(&problem.diagnostic.code)) {
        return None;
    }
    // Problems of `before` are repeated for the copy of it that takes the place of `after`.
    let mut seen = BTreeSet::new();
    problems.retain(|Problem { diagnostic: one, .. }| {
        !one.message.contains("`after`") && seen.insert((one.code, one.span()))
    });
    let first = &mut problems.first_mut()?.diagnostic;
    if !first.message.starts_with("no mesh matches") {
        first.notes.push("no mesh matches `before`: it contradicts itself".into());
    }
    Some(problems.into())
}

/// Reports names that an `alias` allows to be one element, but that the statements make one in
/// every mesh.
fn always_one(still: &Rule, problems: &[Problem]) -> Option<Diagnostic> {
    let alias = still.aliases.first()?;
    problems.first()?;
    let mut classes = alias::drawable_where_one(still)?;
    classes.retain(|class| class.len() > 1);
    let named = |class: &Vec<_>| enumerate(still, class);
    let sets: Vec<_> = classes.iter().map(named).collect();
    let message = format!("{} are one in every mesh that `before` matches", sets.join(", and "));
    Some(
        Diagnostic::error("alias-always", message, alias.span)
            .saying("these may be one, and always are")
            .note("give them one name, and leave them out of the `alias`"),
    )
}
