//! Rules with families: proved for every size of the cycle at once.
//!
//! The rule is unrolled. Turning an unrolled rule by one index maps it to itself, so what is found
//! for the members at index 0 holds at every index. It is unrolled far enough that no statement
//! reaches around the cycle: then a subscript can be read off the names, and the laws about
//! statements (1 to 6, and 8) hold alike on every longer cycle, since each of them is about names
//! that one statement, or two with a name in common, bring together. On shorter cycles, different
//! members may be the same element; the shortest are tested one by one, and what can only be tested
//! when the op runs is gathered from all short cycles.
//!
//! Law 7 looks at rings of any length, and has its own argument:
//! [`family_rings`](super::family_rings).

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::broken::{Broken, Rejected, stop_at};
use super::facts::Facts;
use super::fold::fold_pairs;
use super::matching::Step;
use super::problem::Problem;
use super::proof::{Proof, prove as prove_plain};
use super::sizes::Sizes;
use super::statements::statements;
use super::witness::{self, Outcome};
use super::{before, family_rings, mend, reach, start};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Level, Naming, Op, Property, Rule, Unrolled};

/// Proves a rule with families for every size, or reports every law it breaks.
pub(super) fn prove(op: &Op, rule: &Rule) -> Result<Proof, Rejected> {
    let sizes = Sizes::new(rule);
    match laws(op, &sizes) {
        Ok(proof) => Ok(proof),
        Err(broken) => Err(reject(op, rule, &sizes, broken)),
    }
}

fn laws(op: &Op, sizes: &Sizes) -> Result<Proof, Broken> {
    let large = &sizes.large.rule;
    let drawing = Drawing::new(large);
    stop_at(start::test(op, &drawing))?;
    let rings = laws_at_large(large)?;
    for short in sizes.small.iter().take(3) {
        statements(&Drawing::new(&short.rule))?;
    }
    let same = fold_pairs(sizes.all(), &sizes.large);
    let matching = reach::matching(op, &drawing, &same)?;
    stop_at(sizes_are_known(&drawing, &matching))?;
    let guard = match large.guard {
        Some((level, _)) => sizes.obligations(level),
        None => Vec::new(),
    };
    let mut facts = Facts::of_families(sizes, &matching, &guard, rings.cases);
    if !facts.keeps.contains(&Property::Level(Level::Simple)) {
        let asked = sizes.obligations(Level::Simple);
        facts.note_untested(large, &asked);
    }
    let proof = Proof { matching, guard, facts, rings, unrolled: Some(Box::new(large.clone())) };
    proof.bears_out(op, &drawing)
}

/// The laws for a rule that is unrolled far enough.
fn laws_at_large(large: &Rule) -> Result<super::vertices_are_orbits::Rings, Broken> {
    let drawing = Drawing::new(large);
    statements(&drawing)?;
    family_rings::test(&drawing)
}

/// The problems of a rule that is unrolled far enough, without those of short cycles and of claims.
pub(super) fn problems(op: &Op, large: &Rule) -> Vec<Problem> {
    let test = || {
        let drawing = Drawing::new(large);
        stop_at(start::test(op, &drawing))?;
        laws_at_large(large)?;
        let matching = reach::matching(op, &drawing, &[])?;
        stop_at(sizes_are_known(&drawing, &matching))
    };
    test().err().map_or_else(Vec::new, |broken: Broken| broken.problems)
}

/// Tests that the size of the families is known: the length of an orbit of `before` drawn with
/// `each`.
fn sizes_are_known(drawing: &Drawing, matching: &[Step]) -> Vec<Problem> {
    let walks = |step: &Step| matches!(step, Step::Walk { .. });
    if matching.iter().any(walks) {
        return Vec::new();
    }
    let rule = drawing.rule;
    let Some(family) = rule.ids().find(|&name| rule.is_member(name)) else { return Vec::new() };
    let text = rule.quoted(family);
    let message = format!("nothing says how many there are of {text}");
    let problem = Diagnostic::error("unreachable-name", message, rule.name(family).span)
        .note("draw an orbit of `before` with `each`: `face f: each i { v[i] -h[i]-> }`");
    vec![problem.into()]
}

/// The number of sizes, beyond those that are tested one by one, that are searched for a mesh that
/// breaks.
const FURTHER: u32 = 3;

/// The shortest cycle that looks as people think of one: on a shorter one, neighbors coincide.
const PLAIN: u32 = 3;

/// Reports the problems of the members at index 0, and shows them on the shortest cycle that
/// breaks, of at least [`PLAIN`] indices if there is one.
fn reject(op: &Op, rule: &Rule, sizes: &Sizes, broken: Broken) -> Rejected {
    let mut problems = before::in_before(&sizes.large.rule).unwrap_or(broken).problems;
    let mut outcome = Outcome::NotTried;
    let tested = sizes.small.len() as u32;
    let further = (tested + 1..=tested + FURTHER)
        .map(|size| Cow::Owned(Unrolled::new(rule, size, Naming::Numbers)));
    let (shortest, short): (Vec<_>, Vec<_>) =
        sizes.small.iter().map(Cow::Borrowed).partition(|one| one.size() < PLAIN);
    for short in short.into_iter().chain(further).chain(shortest) {
        let Err(mut here) = prove_plain(op, &short.rule) else { continue };
        let found = witness::find(op, &short.rule, &mut here);
        if !matches!(found, Outcome::Breaks(_)) {
            continue;
        }
        let size = short.size();
        if let Some(first) = problems.first_mut() {
            let around = format!("on a cycle of {size}");
            let told = here.problems.into_iter().next();
            if let Some(told) = told {
                let notes = told.diagnostic.notes.into_iter();
                let literal = notes.filter(|note| note.starts_with("carried out literally"));
                first.diagnostic.notes.extend(literal.map(|note| format!("{around}, {note}")));
            }
        }
        outcome = found;
        break;
    }
    let laws = |large: &Rule| self::problems(op, large);
    let mut diagnostics = mend::add_fixes(&sizes.large.rule, problems, laws);
    let mut seen = BTreeSet::new();
    diagnostics.retain(|diagnostic| seen.insert((diagnostic.code, diagnostic.span())));
    Rejected { diagnostics, outcome }
}
