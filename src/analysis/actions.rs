//! Changes that are offered at a place: fixes of diagnostics, and refactorings.

use std::ops::Range;

use super::action::Action;
use super::fixes::mending;
use super::refactor::rewriting;
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;

/// The changes that are offered for a part of the text.
pub fn actions(snapshot: &Snapshot, part: Range<usize>) -> Vec<Action> {
    let mut actions = mending(snapshot, &part);
    actions.extend(rewriting(snapshot, part.start));
    let mut seen: Vec<Vec<Edit>> = Vec::new();
    actions.retain(|action| {
        let is_first = !seen.contains(&action.edits);
        seen.push(action.edits.clone());
        is_first
    });
    actions
}
