//! Entry point of the checker: proves operations.

use super::broken::{Broken, Rejected, stop_at};
use super::problem::Problem;
use super::proof::{Proof, prove};
use super::sizes::Sizes;
use super::witness::{self, Outcome};
use super::{before, families, fans_have_room, mend};
use crate::diagnostic::{Diagnostic, Fix};
use crate::diagram::{Drawing, Op, Property, Rule};

/// An operation that keeps every valid mesh valid. Only [`check`] makes one.
#[derive(Clone, Debug)]
pub struct Proved {
    op: Op,
    proofs: Vec<Proof>,
}

impl Proved {
    /// The operation.
    pub fn op(&self) -> &Op {
        &self.op
    }

    /// Warnings about rules that are proved.
    pub fn warnings(&self) -> impl Iterator<Item = Diagnostic> {
        self.op
            .rules
            .iter()
            .zip(&self.proofs)
            .filter_map(|(rule, proof)| proof.refuses_everywhere(rule))
    }

    /// The properties that every rule keeps.
    pub fn keeps(&self) -> Vec<Property> {
        let kept = |property: &Property| {
            self.proofs.iter().all(|proof| proof.facts().keeps.contains(property))
        };
        Property::ALL.into_iter().filter(kept).collect()
    }

    /// The proofs, one for each rule.
    pub fn proofs(&self) -> &[Proof] {
        &self.proofs
    }
}

/// An operation that is not proved.
#[derive(Clone, Debug)]
pub struct Rejection {
    /// Every law it breaks.
    pub diagnostics: Vec<Diagnostic>,
    /// For each rejected rule, the outcome of carrying it out literally on a mesh.
    pub outcomes: Vec<Outcome>,
}

/// Proves an operation, or reports every law it breaks.
pub fn check(op: &Op) -> Result<Proved, Vec<Diagnostic>> {
    examine(op).map_err(|rejection| rejection.diagnostics)
}

/// Proves an operation, or reports every law it breaks, with meshes that show it.
pub fn examine(op: &Op) -> Result<Proved, Rejection> {
    let mut proofs = Vec::new();
    let mut rejection = Rejection { diagnostics: Vec::new(), outcomes: Vec::new() };
    for rule in &op.rules {
        let proof = match rule.has_families() {
            true => families::prove(op, rule),
            false => prove_with_room(op, rule).map_err(|broken| reject(op, rule, broken)),
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

/// The fix of an op with loops that do not end where they begin, if it is certain.
pub fn closing(op: &Op) -> Option<Fix> {
    match op.rules.as_slice() {
        [rule] if rule.has_families() => {
            let large = Sizes::new(rule).large.rule;
            mend::closing(&large, |large| families::problems(op, large))
        }
        [rule] => mend::closing(rule, |rule| problems(op, rule)),
        _ => None,
    }
}

fn reject(op: &Op, rule: &Rule, broken: Broken) -> Rejected {
    let mut broken = before::in_before(rule).unwrap_or(broken);
    let outcome = witness::find(op, rule, &mut broken);
    let laws = |rule: &Rule| problems(op, rule);
    Rejected { diagnostics: mend::add_fixes(rule, broken.problems, laws), outcome }
}

/// Proves a rule whose fans have room.
fn prove_with_room(op: &Op, rule: &Rule) -> Result<Proof, Broken> {
    let proof = prove(op, rule)?;
    stop_at(fans_have_room::test(&Drawing::new(rule)))?;
    Ok(proof)
}

fn problems(op: &Op, rule: &Rule) -> Vec<Problem> {
    match prove_with_room(op, rule) {
        Ok(proof) => proof.refuses_everywhere(rule).map(Problem::from).into_iter().collect(),
        Err(broken) => broken.problems,
    }
}
