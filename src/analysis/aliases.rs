//! Aliasing: which names of an operation may stand for one element, and with what outcome.

use serde::Serialize;

use super::Analysis;
use crate::check::{Counterexample, Identification, Verdict, identifications};
use crate::diagram::{NameId, Rule};

/// The outcomes of aliasing names of one rule.
#[derive(Clone, Debug, Serialize)]
pub struct RuleAliases {
    pub op: String,
    /// The rule, where it has a name.
    pub rule: Option<String>,
    /// True if it has families; then `sets` is empty.
    pub has_families: bool,
    /// Each set of names that was examined.
    pub sets: Vec<NamesAsOne>,
    /// True if all combinations were examined.
    pub complete: bool,
}

/// Names that stand for one element, all others distinct, and the outcome.
#[derive(Clone, Debug, Serialize)]
pub struct NamesAsOne {
    /// The classes of names that stand for one element each.
    pub names: Vec<Vec<String>>,
    /// The verdict: `fine`, `breaks`, `impossible` or `unproved`.
    pub verdict: &'static str,
    /// The reason why it is not fine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<String>,
    /// The result on a small mesh that the rule breaks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub comes_to: Option<String>,
    /// That mesh.
    #[serde(skip)]
    pub example: Option<Counterexample>,
}

/// For each rule of the file, the outcomes of aliasing its names.
pub fn aliases(analysis: &Analysis) -> Vec<RuleAliases> {
    let own = |op: &&crate::resolve::ResolvedOp| op.span.file == analysis.file;
    let diagrams = analysis.program.ops.iter().filter(own).filter_map(|op| op.diagram.as_ref());
    let rules = diagrams.flat_map(|op| op.rules.iter().map(move |rule| (op, rule)));
    let of_rule = rules.map(|(op, rule)| {
        let (sets, complete) = identifications(op, rule);
        RuleAliases {
            op: op.name.clone(),
            rule: rule.label.clone(),
            has_families: rule.has_families(),
            sets: sets.into_iter().map(|one| NamesAsOne::new(rule, one)).collect(),
            complete,
        }
    });
    of_rule.collect()
}

impl NamesAsOne {
    fn new(rule: &Rule, one: Identification) -> Self {
        let word = |name: &NameId| rule.name(*name).text.clone();
        let names = one.names.iter().map(|class| class.iter().map(word).collect());
        let (verdict, why, example) = match one.verdict {
            Verdict::Fine => ("fine", None, None),
            Verdict::Breaks { why, example } => ("breaks", Some(why), Some(*example)),
            Verdict::Impossible(why) => ("impossible", Some(why), None),
            Verdict::Unproved(why) => ("unproved", Some(why), None),
        };
        Self {
            names: names.collect(),
            verdict,
            why,
            comes_to: example.as_ref().map(|example| example.verdict.clone()),
            example,
        }
    }
}
