//! Contradictions in `before` alone, where the rest of an op could not be read.
//!
//! A `before` that no mesh matches has to be fixed first, so its contradictions are reported alone:
//! errors in `after` may follow from them, and the others are reported again after the fix.

use super::files::touches;
use crate::check::contradictions;
use crate::diagnostic::Diagnostic;
use crate::resolve::Program;

/// Replaces all errors inside an op by the contradictions in its `before`, if there are any.
pub(super) fn tell_of_before(program: &Program, told: &mut Vec<Diagnostic>) {
    for still in program.ops.iter().filter_map(|op| op.still.as_deref()) {
        let found = contradictions(still);
        if found.is_empty() {
            continue;
        }
        told.retain(|told| !told.is_error() || !touches(still.span, told.span()));
        told.extend(found);
    }
}
