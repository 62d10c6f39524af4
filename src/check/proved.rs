//! The door: from an operation to a proved one.

use super::argument::{self, Argument};
use super::arrangement::Arc;
use super::facts::Facts;
use super::guard::{Obligation, obligations};
use super::matching::Step;
use super::problem::Problem;
use super::vertices_are_orbits::Rings;
use super::witness::{self, Outcome};
use super::{
    alias, before, distinct_names, ends_agree, families, fans_have_room, mend,
    names_are_accounted_for, new_is_placed, next_is_permutation, nothing_dangles, properties,
    reach, start, twin_is_involution, vertices_are_orbits,
};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Level, Op, Property, Rule};

/// An operation that keeps every valid mesh valid. Only [`check`] makes one.
#[derive(Clone, Debug)]
pub struct Proved {
    op: Op,
    proofs: Vec<Proof>,
}

/// The proof of one rule.
#[derive(Clone, Debug)]
pub struct Proof {
    pub(super) matching: Vec<Step>,
    pub(super) guard: Vec<Obligation>,
    pub(super) facts: Facts,
    pub(super) rings: Rings,
    /// The rule that the steps speak of, if it is not the one that was proved.
    pub(super) unrolled: Option<Box<Rule>>,
}

impl Proved {
    /// The operation.
    pub fn op(&self) -> &Op {
        &self.op
    }

    /// For each rule what was proved of it.
    pub fn proofs(&self) -> &[Proof] {
        &self.proofs
    }
}

impl Proof {
    /// The rule that the matching and the guard speak of: the one that was proved, or if it
    /// has families, the same unrolled. What is said there of members at index 0 is meant for
    /// every index.
    pub fn drawn<'a>(&'a self, rule: &'a Rule) -> &'a Rule {
        self.unrolled.as_deref().unwrap_or(rule)
    }

    /// The steps by which the rule is matched.
    pub fn matching(&self) -> &[Step] {
        &self.matching
    }

    /// The obligations of the guard; some of it is left to test.
    pub fn guard(&self) -> &[Obligation] {
        &self.guard
    }

    /// The facts that the proof established.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// The proof, if it bears out all that the op claims to keep.
    pub(super) fn bears_out(self, op: &Op, drawing: &Drawing) -> Result<Self, Broken> {
        stop_at(properties::broken_claims(op, drawing, &self.facts))?;
        Ok(self)
    }

    /// The argument in words, law by law. The rule is the one that was proved.
    pub fn argument(&self, rule: &Rule) -> Vec<Argument> {
        argument::argument(self.drawn(rule), &self.rings)
    }
}

/// An operation that is not proved.
#[derive(Clone, Debug)]
pub struct Rejection {
    /// Every law it breaks.
    pub diagnostics: Vec<Diagnostic>,
    /// The outcome of each rejected rule does to a mesh when it is carried out literally.
    pub outcomes: Vec<Outcome>,
}

/// Proves an operation, or tells every law it breaks.
pub fn check(op: &Op) -> Result<Proved, Vec<Diagnostic>> {
    examine(op).map_err(|rejection| rejection.diagnostics)
}

/// Proves an operation, or tells every law it breaks, with meshes that show it.
pub fn examine(op: &Op) -> Result<Proved, Rejection> {
    let mut proofs = Vec::new();
    let mut rejection = Rejection { diagnostics: Vec::new(), outcomes: Vec::new() };
    for rule in &op.rules {
        let proof = match rule.has_families() {
            true => families::prove(op, rule),
            false => {
                let proof = prove(op, rule).and_then(|proof| {
                    stop_at(fans_have_room::test(&Drawing::new(rule)))?;
                    Ok(proof)
                });
                proof.map_err(|broken| reject(op, rule, broken))
            }
        };
        match proof {
            Ok(proof) => proofs.push(proof),
            Err(rejected) => {
                rejection.diagnostics.extend(rejected.diagnostics);
                rejection.outcomes.push(rejected.outcome);
            }
        }
    }
    if rejection.diagnostics.is_empty() {
        Ok(Proved { op: op.clone(), proofs })
    } else {
        Err(rejection)
    }
}

/// The report on a rule that is not proved.
pub(super) struct Rejected {
    /// Every law it breaks.
    pub diagnostics: Vec<Diagnostic>,
    /// The outcome when it is carried out literally.
    pub outcome: Outcome,
}

fn reject(op: &Op, rule: &Rule, broken: Broken) -> Rejected {
    let mut broken = before::in_before(rule).unwrap_or(broken);
    let outcome = witness::find(op, rule, &mut broken);
    let laws = |rule: &Rule| match prove(op, rule) {
        Ok(_) => Vec::new(),
        Err(broken) => broken.problems,
    };
    Rejected { diagnostics: mend::add_fixes(rule, broken.problems, laws), outcome }
}

/// The laws that a rule breaks.
pub(super) struct Broken {
    /// The messages.
    pub problems: Vec<Problem>,
    /// For law 7 the arcs of the case that fails.
    pub arcs: Option<Vec<Arc>>,
    /// The outcome of carrying it out, if that has been tried.
    pub outcome: Option<Outcome>,
}

impl From<Vec<Problem>> for Broken {
    fn from(problems: Vec<Problem>) -> Self {
        Self { problems, arcs: None, outcome: None }
    }
}

/// The laws in order. Each group reads what the one before has established, so the first
/// group that fails is told, in full.
pub(super) fn prove(op: &Op, rule: &Rule) -> Result<Proof, Broken> {
    let drawing = Drawing::new(rule);
    stop_at(start::test(op, &drawing))?;
    statements(&drawing)?;
    let rings = vertices_are_orbits::test(&drawing)?;
    let aliased = alias::allowed(op, rule)?;
    let matching = reach::matching(op, &drawing, &distinct_names::pairs(&drawing))?;
    let guard = match rule.guard {
        Some((level, _)) => aliased.obligations(obligations(&drawing, level), level),
        None => Vec::new(),
    };
    let cases = rings.cases + aliased.cases();
    let mut facts = Facts::of(&drawing, &matching, &guard, cases);
    aliased.keeps_no_more(&mut facts);
    if !facts.keeps.contains(&Property::Level(Level::Simple)) {
        let asked = aliased.obligations(obligations(&drawing, Level::Simple), Level::Simple);
        facts.untested = asked.iter().filter(|one| one.is_test()).count();
    }
    let proof = Proof { matching, guard, facts, rings, unrolled: None };
    proof.bears_out(op, &drawing)
}

/// The laws that read the statements: all but law 7.
pub(super) fn statements(drawing: &Drawing) -> Result<(), Broken> {
    // A name written for another is missing in one place and too many in the other: both
    // are told.
    let mut problems = names_are_accounted_for::test(drawing);
    problems = beside(problems, next_is_permutation::test(drawing), "next-twice");
    problems = beside(problems, twin_is_involution::test(drawing), "twin-twice");
    stop_at(problems)?;
    let mut problems = nothing_dangles::test(drawing);
    problems.extend(ends_agree::test(drawing));
    problems.extend(new_is_placed::test(drawing));
    stop_at(problems)
}

/// Two lists as one. What stands twice stands in one place for what is missing elsewhere, so that
/// is told with the first that is missing.
fn beside(mut missing: Vec<Problem>, others: Vec<Problem>, twice: &str) -> Vec<Problem> {
    for other in others {
        let is_open = |problem: &&mut Problem| problem.diagnostic.code == "missing-reassignment";
        match missing.iter_mut().find(is_open).filter(|_| other.diagnostic.code == twice) {
            Some(first) => {
                first.diagnostic.notes.insert(0, other.diagnostic.message.clone());
                for (label, text) in other.diagnostic.labels.iter().zip(["here again", "here"]) {
                    first.diagnostic = first.diagnostic.clone().label(label.span, text);
                }
            }
            None => missing.push(other),
        }
    }
    missing
}

pub(super) fn stop_at(problems: Vec<Problem>) -> Result<(), Broken> {
    if problems.is_empty() { Ok(()) } else { Err(problems.into()) }
}
