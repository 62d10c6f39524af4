//! Loops that do not end where they begin: which of both is wrong, the laws tell.

use super::files::touches;
use crate::check::closing;
use crate::diagnostic::Diagnostic;
use crate::resolve::Program;

/// Replaces the fixes of loops that are not closed by the one that leads to a proved op, if there
/// is exactly one.
pub(super) fn tell_how_to_close(program: &Program, told: &mut [Diagnostic]) {
    for op in program.ops.iter().filter_map(|op| op.open.as_deref().filter(|_| !op.misread)) {
        let inside = told.iter_mut().filter(|error| touches(op.span, error.span()));
        let mut open: Vec<_> = inside.filter(|error| error.code == "open-loop").collect();
        if let (Some(first), Some(fix)) = (open.first_mut(), closing(op)) {
            first.fixes = vec![fix];
            open.iter_mut().skip(1).for_each(|error| error.fixes.clear());
        }
    }
}
