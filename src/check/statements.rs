//! The laws that read the statements of a drawing, in order.

use super::broken::{Broken, stop_at};
use super::problem::Problem;
use super::{
    ends_agree, names_are_accounted_for, new_is_placed, next_is_permutation, nothing_dangles,
    twin_is_involution,
};
use crate::diagram::Drawing;

/// The laws that read the statements: all but law 7.
pub(super) fn statements(drawing: &Drawing) -> Result<(), Broken> {
    // A name written for another is missing in one place and extra in the other: both are reported.
    let mut problems = names_are_accounted_for::test(drawing);
    problems = beside(problems, next_is_permutation::test(drawing), "next-twice");
    problems = beside(problems, twin_is_involution::test(drawing), "twin-twice");
    let unplaced = new_is_placed::test(drawing);
    if !problems.is_empty() {
        problems.extend(unplaced);
        return stop_at(problems);
    }
    let mut problems = nothing_dangles::test(drawing);
    problems.extend(ends_agree::test(drawing));
    problems.extend(unplaced);
    stop_at(problems)
}

/// Joins two lists. A name that occurs twice is in one place written for a missing one, so it is
/// reported with the first missing one.
fn beside(mut missing: Vec<Problem>, others: Vec<Problem>, twice: &str) -> Vec<Problem> {
    for other in others {
        let is_open = |problem: &&mut Problem| problem.diagnostic.code == "missing-reassignment";
        match missing.iter_mut().find(is_open).filter(|_| other.diagnostic.code == twice) {
            Some(first) => {
                first.diagnostic.notes.insert(0, other.diagnostic.message.clone());
                for (label, text) in other.diagnostic.labels.iter().zip(["here again", "here"]) {
                    first.diagnostic = first.diagnostic.clone().label(label.span, text);
                }
            }
            None => missing.push(other),
        }
    }
    missing
}
