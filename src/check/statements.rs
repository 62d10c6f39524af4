//! The laws that read the statements of a drawing, in order.

use super::broken::{Broken, stop_at};
use super::{
    ends_agree, names_are_accounted_for, new_is_placed, next_is_permutation, nothing_dangles,
    twin_is_involution,
};
use crate::diagram::Drawing;

/// The laws that read the statements: all but law 7.
pub(super) fn statements(drawing: &Drawing) -> Result<(), Broken> {
    // A name written for another is missing in one place and too many in the other: both
    // are told.
    let mut problems = names_are_accounted_for::test(drawing);
    problems.extend(next_is_permutation::test(drawing));
    problems.extend(twin_is_involution::test(drawing));
    stop_at(problems)?;
    let mut problems = nothing_dangles::test(drawing);
    problems.extend(ends_agree::test(drawing));
    problems.extend(new_is_placed::test(drawing));
    stop_at(problems)
}
