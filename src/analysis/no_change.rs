//! Ops that change nothing, since `after` repeats `before`.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Op, Rule, Write};

/// A warning for an op that changes nothing. One that is asked where it applies says `keep`, has
/// conditions, or returns what it found.
pub(super) fn changes_nothing(op: &Op) -> Option<Diagnostic> {
    let is_repeated = !op.rules.is_empty() && op.rules.iter().all(repeats_before);
    let rule = op.rules.first().filter(|_| is_repeated && op.result.is_none())?;
    let message = format!("`{}` changes nothing: `after` repeats `before`", op.name);
    let told = Diagnostic::warning("changes-nothing", message, rule.after.span);
    Some(told.note("`after` draws the loops, edges and vertices as they shall be"))
}

fn repeats_before(rule: &Rule) -> bool {
    let is_bare = rule.created.is_empty()
        && rule.erased.is_empty()
        && rule.assignments.is_empty()
        && rule.requires.is_empty()
        && rule.after.keeps.is_empty();
    let writes = Drawing::new(rule).reassignments();
    let mut writes = writes.iter().flat_map(|part| &part.writes).peekable();
    is_bare && writes.peek().is_some() && !writes.any(changes)
}

fn changes(write: &Write) -> bool {
    match write {
        Write::Halfedge { changes, .. }
        | Write::FaceAlong { changes, .. }
        | Write::VertexAround { changes, .. }
        | Write::Hole { changes, .. } => *changes,
        Write::Anchor { keeps, .. } => !keeps,
        Write::AsItWas { .. } => false,
        Write::LinkPaths { .. } => true,
    }
}
