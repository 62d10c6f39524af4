//! Changes that are offered at a place: fixes of diagnostics, and refactorings.

use std::collections::HashSet;
use std::ops::Range;

use super::action::Action;
use super::fixes::mending;
use super::refactor::rewriting;
use super::snapshot::Snapshot;

/// The changes that are offered for a part of the text.
pub fn actions(snapshot: &Snapshot, part: Range<usize>) -> Vec<Action> {
    let mut actions = mending(snapshot, &part);
    actions.extend(rewriting(snapshot, part.start));
    let mut seen = HashSet::new();
    actions.retain(|action| seen.insert(action.edits.clone()));
    actions
}
