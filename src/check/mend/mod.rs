//! Fixes that are certain: a repair is offered only after the laws have been tested on the rule
//! with the repair applied.

mod apply;
mod fix;
mod statements;

use super::forgotten::only_a_hole;
use super::joint::{TIERS, Tier, closed};
use super::new_is_placed::{self, placed};
use super::problem::{Problem, Repair};
use crate::diagnostic::{Diagnostic, Fix};
use crate::diagram::{Drawing, Kind, NameId, Rule};

/// Adds to each problem the fix that removes it and causes no new one, if exactly one does; or to
/// the first one the fix that mends everything.
pub(super) fn add_fixes(
    rule: &Rule,
    problems: Vec<Problem>,
    laws: impl Fn(&Rule) -> Vec<Problem>,
) -> Vec<Diagnostic> {
    // What value an attribute of a new element has, only the author knows.
    let (unplaced, mut problems): (Vec<_>, Vec<_>) =
        problems.into_iter().partition(lacks_attribute);
    if let (Some(Problem { diagnostic: first, .. }), Some(advice)) =
        (problems.first_mut(), only_a_hole(&Drawing::new(rule)))
        && !first.notes.contains(&advice)
    {
        first.notes.push(advice);
    }
    let told = mend(rule, problems, |mended| laws(&placed(mended)));
    told.into_iter().chain(unplaced.into_iter().map(|problem| problem.diagnostic)).collect()
}

fn mend(
    rule: &Rule,
    problems: Vec<Problem>,
    laws: impl Fn(&Rule) -> Vec<Problem>,
) -> Vec<Diagnostic> {
    let before: Vec<_> = problems.iter().map(|problem| problem.diagnostic.clone()).collect();
    let good = |repair: &Repair, at: usize| {
        let mended = repair.apply(rule).filter(changes_something)?;
        let left = laws(&mended);
        let known = |problem: &Problem| {
            before.iter().enumerate().any(|(index, old)| {
                index != at
                    && old.code == problem.diagnostic.code
                    && old.message == problem.diagnostic.message
            })
        };
        // Problems of a later law may appear once the names are in order; the fix is then not
        // wrong, but no longer certain. What seems to have been forgotten may be intended if
        // something else is wrong: it is erased, kept or created only if that leaves no problem.
        let good = match repair {
            Repair::Erase(_) | Repair::Keep(_) => left.is_empty(),
            // Vertices alone, without positions, may be meant to be other ones.
            Repair::Create(names) => {
                left.is_empty() && !(are_vertices(rule, names) && lacks_position(&mended))
            }
            _ => left.iter().all(known),
        };
        let fix = good.then(|| repair.fix(rule)).flatten()?;
        Some((fix, left.is_empty()))
    };
    let mut diagnostics = Vec::new();
    // The problems with a fix that mends all others, too.
    let mut causes = Vec::new();
    for (at, problem) in problems.into_iter().enumerate() {
        let mut diagnostic = problem.diagnostic;
        let found: Vec<_> = problem.repairs.iter().filter_map(|repair| good(repair, at)).collect();
        // A fix that mends everything is preferred to those that mend this problem alone.
        let all: Vec<_> = found.iter().filter(|(_, mends_all)| *mends_all).collect();
        let sure = match (found.as_slice(), all.as_slice()) {
            ([one], _) => Some(one),
            (_, &[one]) => Some(one),
            _ => None,
        };
        if let Some((fix, mends_all)) = sure {
            diagnostic.fixes.push(fix.clone());
            causes.extend(mends_all.then_some(at));
        }
        diagnostics.push(diagnostic);
    }
    if let &[cause] = causes.as_slice() {
        return vec![alone(diagnostics, cause)];
    }
    // A claim may be wrong as well as the drawing.
    let is_claim = |told: &Diagnostic| told.code == "property-not-kept";
    if diagnostics.is_empty() || diagnostics.iter().any(is_claim) {
        return diagnostics;
    }
    let mends = |tier: &Tier| mending(rule, tier(rule), &laws);
    match TIERS.iter().map(mends).find(|found| !found.is_empty()).as_deref() {
        Some([fix]) => vec![together(diagnostics, fix.clone())],
        _ => diagnostics,
    }
}

/// The fix that closes loops which do not end where they begin, if exactly one leads to a rule that
/// keeps all laws.
pub(super) fn closing(rule: &Rule, laws: impl Fn(&Rule) -> Vec<Problem>) -> Option<Fix> {
    let fixes = mending(rule, closed(rule), &|mended: &Rule| laws(&placed(mended)));
    match fixes.as_slice() {
        [fix] => Some(fix.clone()),
        _ => None,
    }
}

/// The fixes, of these repairs, that mend everything.
fn mending(rule: &Rule, repairs: Vec<Repair>, laws: &impl Fn(&Rule) -> Vec<Problem>) -> Vec<Fix> {
    let mut fixes: Vec<Fix> = Vec::new();
    for repair in repairs {
        let mended = repair.apply(rule).filter(changes_something);
        // A new vertex without a position may be meant to be another one.
        let is_good = mended.is_some_and(|mended| {
            laws(&mended).is_empty() && (lacks_position(rule) || !lacks_position(&mended))
        });
        let fix = is_good.then(|| repair.fix(rule)).flatten();
        let is_new = |fix: &Fix| fixes.iter().all(|known| known.edits != fix.edits);
        fixes.extend(fix.filter(is_new));
    }
    fixes
}

/// True if a rule does not leave every mesh as it is.
fn changes_something(rule: &Rule) -> bool {
    let drawing = Drawing::new(rule);
    let Drawing { before, after, .. } = &drawing;
    let loops = rule.before.loops.iter().zip(&rule.after.loops);
    !rule.created.is_empty()
        || !rule.erased.is_empty()
        || !rule.assignments.is_empty()
        || loops.into_iter().any(|(one, other)| one.kind != other.kind)
        || rule.ids().any(|name| {
            before.item_after(name) != after.item_after(name)
                || before.loop_origin(name) != after.loop_origin(name)
                || before.twin(name) != after.twin(name)
        })
}

/// True if a new element is not given an attribute that it needs.
fn lacks_attribute(problem: &Problem) -> bool {
    problem.diagnostic.code == "missing-attribute"
}

/// True if a new vertex is given no position.
fn lacks_position(rule: &Rule) -> bool {
    let lacking = new_is_placed::test(&Drawing::new(rule));
    lacking.iter().any(|problem| problem.diagnostic.message.contains("no position"))
}

/// True if all names are those of vertices.
fn are_vertices(rule: &Rule, names: &[NameId]) -> bool {
    names.iter().all(|&name| rule.kind(name) == Kind::Vertex)
}

/// The first of several diagnostics, with the fix that mends them all; where the others are is told
/// as well.
fn together(diagnostics: Vec<Diagnostic>, fix: Fix) -> Diagnostic {
    let others = diagnostics[1..].iter().map(|other| (other.span(), other.message.clone()));
    let others: Vec<_> = others.collect();
    let mut told = alone(diagnostics, 0);
    for (span, message) in others {
        if told.labels.iter().all(|label| label.span != span) {
            told = told.label(span, message);
        }
    }
    told.fixes = vec![fix];
    told
}

/// The diagnostic that is the cause of all others, with their notes about the mesh.
fn alone(mut diagnostics: Vec<Diagnostic>, cause: usize) -> Diagnostic {
    let mut told = diagnostics.swap_remove(cause);
    let of_mesh = |note: &String| {
        ["carried out literally", "whether this mesh", "on a cycle of"]
            .iter()
            .any(|words| note.starts_with(words))
    };
    let notes = diagnostics.into_iter().flat_map(|other| other.notes);
    told.notes.extend(notes.filter(of_mesh));
    told
}
