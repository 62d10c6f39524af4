//! What was proved of each operation, to show.

use serde::Serialize;

use super::Analysis;
use crate::check::Facts;

/// What was proved of an operation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// Its name.
    pub op: String,
    /// Whether it keeps every valid mesh valid.
    pub proved: bool,
    /// For each alternative what was established; empty if it was not proved.
    pub rules: Vec<RuleVerdict>,
}

/// What was established of one alternative.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RuleVerdict {
    /// Its name, where it has one.
    pub rule: Option<String>,
    /// How many ways the mesh around the drawing can lie, all of them looked at.
    pub cases: usize,
    /// The change of the number of vertices.
    pub vertices: i64,
    /// The change of the number of edges.
    pub edges: i64,
    /// The change of the number of faces and holes.
    pub faces: i64,
    /// Whether it takes constant time.
    pub constant_time: bool,
    /// What the time grows with otherwise.
    pub grows_with: Vec<String>,
}

impl RuleVerdict {
    fn new(rule: Option<String>, facts: &Facts) -> Self {
        Self {
            rule,
            cases: facts.cases,
            vertices: facts.change.vertices,
            edges: facts.change.edges,
            faces: facts.change.faces,
            constant_time: facts.grows_with.is_empty(),
            grows_with: facts.grows_with.clone(),
        }
    }
}

/// The verdict on every op of a file, in order.
pub fn verdicts(analysis: &Analysis) -> Vec<Verdict> {
    let ops = analysis.program.ops.iter().zip(&analysis.proved);
    ops.map(|(op, proved)| Verdict {
        op: op.name.clone(),
        proved: proved.is_some(),
        rules: proved.iter().flat_map(rules).collect(),
    })
    .collect()
}

fn rules(proved: &crate::check::Proved) -> Vec<RuleVerdict> {
    let rules = proved.op().rules.iter().zip(proved.proofs());
    rules
        .map(|(rule, proof)| RuleVerdict::new(rule.label.clone(), proof.facts()))
        .collect()
}
