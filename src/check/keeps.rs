//! Levels that a rule claims to keep: nothing may be left to test.

use super::guard::{Obligation, obligations};
use crate::diagram::{Drawing, Level};

/// The tests of the result that would be needed for a mesh of the level to stay one. A guard makes
/// all tests of its level, and a rule with a guard is for meshes of that level.
pub(super) fn left_to_test(drawing: &Drawing, level: Level) -> Vec<Obligation> {
    if drawing.rule.guard.is_some_and(|(guard, _)| guard >= level) {
        return Vec::new();
    }
    let mut left = obligations(drawing, level);
    left.retain(|one| one.is_test() && drawing.rule.is_first(one.statement.of));
    left
}
