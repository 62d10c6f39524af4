//! Ops without a guard that hide guarded ones of the files that are used.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Level, Property};
use crate::resolve::{Program, ResolvedOp};
use crate::source::FileId;
use crate::syntax::tree::qualified;

/// A warning for each op of a file that hides a guarded op of the same name from a file that it
/// uses, and may lose the level that this one keeps. `seen` are the files that it uses.
pub(super) fn hidden_guards(
    program: &Program,
    own: FileId,
    seen: &[FileId],
    keeps: impl Fn(usize) -> Vec<Property>,
) -> Vec<Diagnostic> {
    let hiding = program.ops.iter().enumerate().filter(|(_, op)| op.span.file == own);
    // One with an error has neither; its guard is not known.
    let hiding = hiding.filter(|(_, op)| op.diagram.is_some() || op.steps.is_some());
    let hidden = hiding.filter_map(|(number, op)| {
        let used = |other: &&ResolvedOp| {
            let file = other.span.file;
            file != own && seen.contains(&file) && !program.private.contains(&other.span)
        };
        let same = program.ops.iter().filter(used).filter(|other| other.name == op.name);
        let guarded = same.filter_map(|other| Some((other, guard(other)?)));
        let (other, level) = guarded.max_by_key(|(_, level)| *level)?;
        let is_kept = guard(op) >= Some(level) || keeps(number).contains(&Property::Level(level));
        let file = program.qualifiers.get(&other.span.file).filter(|_| !is_kept)?;
        let whole = qualified(file, &op.name);
        let message = format!("`{}` hides `{whole}`, and lacks its `guard {level}`", op.name);
        Some(Diagnostic::warning("hidden-guard", message, op.span).note(format!(
            "`{whole}(…)` calls that one; the same guard here refuses the places where the level \
             would be lost"
        )))
    });
    hidden.collect()
}

/// The level that an op guards, in all of its alternatives.
fn guard(op: &ResolvedOp) -> Option<Level> {
    let steps = op.steps.as_ref().map(|steps| steps.level);
    let rules = op.diagram.iter().flat_map(|drawn| &drawn.rules);
    let drawn = rules.map(|rule| rule.guard.map_or(Level::Map, |(level, _)| level)).min();
    steps.or(drawn).filter(|level| *level > Level::Map)
}
