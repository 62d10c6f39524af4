//! Contradictions in `before` alone, where the rest of an op could not be read.
//!
//! A drawing that no mesh matches is the first thing to mend. It is told first and alone: what is
//! said of `after` may follow from it, or will be said again.

use crate::check::contradictions;
use crate::diagnostic::Diagnostic;
use crate::resolve::Program;

/// Puts what contradicts itself in a `before` in the place of all else that is said of the op.
pub(super) fn tell_of_before(program: &Program, told: &mut Vec<Diagnostic>) {
    for still in program.ops.iter().filter_map(|op| op.still.as_deref()) {
        let found = contradictions(still);
        if found.is_empty() {
            continue;
        }
        let inside = |error: &Diagnostic| {
            let place = error.span();
            place.file == still.span.file && still.span.touches(place.start as usize)
        };
        told.retain(|told| !told.is_error() || !inside(told));
        told.extend(found);
    }
}
