//! Ops without a guard that hide guarded ones of the files that are used.

use super::files::Part;
use crate::check::Proved;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Level, Property};
use crate::resolve::{Program, ResolvedOp};
use crate::syntax::tree::qualified;

/// A warning for each op of a file that hides a guarded op of the same name from a file that it
/// uses, and may lose the level that this one keeps.
pub(super) fn hidden_guards<'p>(
    program: &'p Program,
    parts: &[Part],
    proved: &'p [Option<Proved>],
) -> Vec<Diagnostic> {
    let Some(own) = parts.first() else { return Vec::new() };
    let hidden = program.ops.iter().zip(proved).filter(|(op, _)| op.span.file == own.file);
    let hidden = hidden.filter_map(|(op, proof)| {
        let used = |other: &&ResolvedOp| {
            let mut used = own.uses.iter().map(|&used| parts[used].file);
            used.any(|file| other.span.file == file) && !program.private.contains(&other.span)
        };
        let same = program.ops.iter().filter(used).filter(|other| other.name == op.name);
        let guarded = same.filter_map(|other| Some((other, guard(other)?)));
        let (other, level) = guarded.max_by_key(|(_, level)| *level)?;
        let keeps = proof.as_ref().map(Proved::keeps).unwrap_or_default();
        let is_kept = keeps.contains(&Property::Level(level)) || guard(op) >= Some(level);
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
