//! The door: from an operation to a proved one.

use super::facts::Facts;
use super::guard::{Obligation, obligations};
use super::matching::Step;
use super::problem::Problem;
use super::{
    ends_agree, mend, names_are_accounted_for, new_is_placed, next_is_permutation, nothing_dangles,
    properties, reach, twin_is_involution, vertices_are_orbits,
};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Op, Rule};

/// An operation that keeps every valid mesh valid. Only [`check`] makes one.
#[derive(Clone, Debug)]
pub struct Proved {
    op: Op,
    proofs: Vec<Proof>,
}

/// What was proved of one rule.
#[derive(Clone, Debug)]
pub struct Proof {
    matching: Vec<Step>,
    guard: Vec<Obligation>,
    facts: Facts,
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
    /// How the rule is matched.
    pub fn matching(&self) -> &[Step] {
        &self.matching
    }

    /// What the guard of the rule asks of the result; some of it is left to test.
    pub fn guard(&self) -> &[Obligation] {
        &self.guard
    }

    /// What the proof established.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }
}

/// Proves an operation, or tells every law it breaks.
pub fn check(op: &Op) -> Result<Proved, Vec<Diagnostic>> {
    let mut proofs = Vec::new();
    let mut diagnostics = Vec::new();
    for rule in &op.rules {
        match prove(op, rule) {
            Ok(proof) => proofs.push(proof),
            Err(problems) => {
                let laws = |rule: &Rule| prove(op, rule).err().unwrap_or_default();
                diagnostics.extend(mend::add_fixes(rule, problems, laws));
            }
        }
    }
    if diagnostics.is_empty() {
        Ok(Proved {
            op: op.clone(),
            proofs,
        })
    } else {
        Err(diagnostics)
    }
}

/// The laws in order. Each group reads what the one before has established, so the first
/// group that fails is told, in full.
fn prove(op: &Op, rule: &Rule) -> Result<Proof, Vec<Problem>> {
    let drawing = Drawing::new(rule);
    // A name written for another is missing in one place and too many in the other: both
    // are told.
    let mut problems = names_are_accounted_for::test(&drawing);
    problems.extend(next_is_permutation::test(&drawing));
    problems.extend(twin_is_involution::test(&drawing));
    stop_at(problems)?;
    let mut problems = nothing_dangles::test(&drawing);
    problems.extend(ends_agree::test(&drawing));
    problems.extend(new_is_placed::test(&drawing));
    stop_at(problems)?;
    let cases = vertices_are_orbits::test(&drawing)?;
    let matching = reach::matching(op, &drawing)?;
    let guard = match rule.guard {
        Some((level, _)) => obligations(&drawing, level),
        None => Vec::new(),
    };
    let facts = Facts::of(&drawing, &matching, &guard, cases);
    let Facts {
        keeps,
        change,
        grows_with,
        ..
    } = &facts;
    stop_at(properties::broken_claims(
        op, &drawing, keeps, *change, grows_with,
    ))?;
    Ok(Proof {
        matching,
        guard,
        facts,
    })
}

fn stop_at(problems: Vec<Problem>) -> Result<(), Vec<Problem>> {
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems)
    }
}
