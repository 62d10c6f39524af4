//! Readable arguments for why each operation is proved.

use super::Analysis;
use crate::check::Argument;

/// The argument for one alternative of an operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleArgument {
    pub op: String,
    /// The alternative, where it has a name.
    pub rule: Option<String>,
    /// The argument for each law.
    pub laws: Vec<Argument>,
}

/// The arguments for every proved op of a file, in order.
pub fn why_proved(analysis: &Analysis) -> Vec<RuleArgument> {
    let mut arguments = Vec::new();
    for proved in analysis.proved.iter().flatten() {
        let op = proved.op();
        if op.span.file != analysis.file {
            continue;
        }
        for (rule, proof) in op.rules.iter().zip(proved.proofs()) {
            arguments.push(RuleArgument {
                op: op.name.clone(),
                rule: rule.label.clone(),
                laws: proof.argument(rule),
            });
        }
    }
    arguments
}
