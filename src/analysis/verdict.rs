//! Verdicts: what was proved of each operation, for display.

use std::collections::BTreeMap;

use serde::Serialize;

use super::Analysis;
use crate::check::{Change, Proof, Proved, SizeChange, Turned};
use crate::diagram::{Level, LoopKind, Property, Rule};
use crate::resolve::Program;
use crate::rewrite::Plan;

/// The verdict on an operation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// Its name.
    pub op: String,
    /// True if it keeps every valid mesh valid.
    pub proved: bool,
    /// The verdicts on its alternatives; empty if it was not proved.
    pub rules: Vec<RuleVerdict>,
    /// A name it depends on that is broken, if that is why it is not proved.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lacks: Option<String>,
    /// For an op in steps, what it calls and which level it guards. All that it calls is proved.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps: Option<StepsVerdict>,
}

/// The verdict on an op in steps.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct StepsVerdict {
    /// The ops that it calls.
    pub calls: Vec<String>,
    /// The level that it guards.
    pub level: Level,
}

/// The verdict on one alternative.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct RuleVerdict {
    /// Its name, where it has one.
    pub rule: Option<String>,
    /// The number of configurations of the mesh around the drawing; all of them were examined.
    pub cases: usize,
    /// The change of the numbers of elements.
    #[serde(flatten)]
    pub change: Change,
    /// The change for each index, if there are families.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub per_index: Option<Change>,
    /// Each face that becomes a hole, and each hole that becomes a face, in words.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub turned: Vec<String>,
    /// True if it takes constant time.
    pub constant_time: bool,
    /// The quantities that the time grows with otherwise.
    pub grows_with: Vec<String>,
    /// The properties that are kept, in the words of `keeps`.
    pub keeps: Vec<&'static str>,
    /// The level that is kept, if it is not the highest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub keeps_only: Option<KeepsOnly>,
    /// The tests of its guard, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guard: Option<GuardVerdict>,
    /// The changes of degrees, by vertex: `-1 +S`; unchanged ones are left out.
    pub degrees: BTreeMap<String, String>,
    /// The changes of the numbers of sides, by face.
    pub sizes: BTreeMap<String, String>,
}

/// The level that is kept on a mesh of a higher level.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct KeepsOnly {
    pub level: Level,
    /// The number of tests that `guard simple` would add.
    pub untested: usize,
    /// The reason why that guard would refuse every place, if it would.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub never_simple: Option<String>,
}

impl KeepsOnly {
    /// The description in one line.
    pub fn words(&self) -> String {
        if let Some(refusal) = &self.never_simple {
            return format!("the mesh stays a {}, and is not simple: {refusal}", self.level);
        }
        let tests = if self.untested == 1 { "test" } else { "tests" };
        format!(
            "the mesh stays a {}, but perhaps not simple; `guard simple` would add {} {tests}",
            self.level, self.untested
        )
    }
}

/// The verdict on a guard.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GuardVerdict {
    pub level: Level,
    /// The tests that run before anything is written.
    pub tests: Vec<String>,
    /// The statements that need no test, with the reasons.
    pub proved: Vec<ProvedStatement>,
}

/// A statement that a level requires and that cannot fail.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ProvedStatement {
    /// The statement, which holds after the operation.
    pub statement: String,
    /// The reason why it does.
    pub because: &'static str,
}

impl GuardVerdict {
    fn new(rule: &Rule, proof: &Proof) -> Option<Self> {
        let (level, _) = rule.guard?;
        let (mut tests, mut proved) = (Vec::new(), Vec::new());
        for obligation in proof.guard() {
            let statement = obligation.statement.claim(rule);
            match obligation.because {
                Some(because) => proved.push(ProvedStatement { statement, because }),
                None => tests.push(statement),
            }
        }
        Some(Self { level, tests, proved })
    }
}

impl RuleVerdict {
    fn new(rule: &Rule, proof: &Proof) -> Self {
        let facts = proof.facts();
        Self {
            rule: rule.label.clone(),
            cases: facts.cases,
            change: facts.change,
            per_index: facts.per_index,
            turned: facts.turned.iter().map(turned).collect(),
            constant_time: facts.grows_with.is_empty(),
            grows_with: facts.grows_with.clone(),
            keeps: facts.keeps.iter().map(|property| property.word()).collect(),
            keeps_only: (facts.untested > 0).then(|| KeepsOnly {
                level: match facts.keeps.contains(&Property::Level(Level::Surface)) {
                    true => Level::Surface,
                    false => Level::Map,
                },
                untested: facts.untested,
                never_simple: facts.never_simple.clone(),
            }),
            guard: GuardVerdict::new(proof.drawn(rule), proof),
            degrees: changes(&facts.degrees),
            sizes: changes(&facts.sizes),
        }
    }
}

/// A loop that becomes another, in words.
fn turned(turned: &Turned) -> String {
    let word = |kind: LoopKind| match kind {
        LoopKind::Face => "face",
        LoopKind::Hole => "hole",
        LoopKind::Any => "loop",
    };
    format!("the {} `{}` becomes a {}", word(turned.from), turned.face, word(turned.to))
}

impl RuleVerdict {
    /// The changes of the numbers of elements, each with the change per index: vertices, edges and
    /// faces; holes and loops only if they change.
    pub fn counts(&self) -> Vec<(&'static str, i64, i64)> {
        let per_index = self.per_index.unwrap_or_default();
        let counts = |of: fn(&Change) -> i64| (of(&self.change), of(&per_index));
        let all = [
            ("V", counts(|change| change.vertices)),
            ("E", counts(|change| change.edges)),
            ("F", counts(|change| change.faces)),
            ("holes", counts(|change| change.holes)),
            ("loops", counts(|change| change.loops)),
        ];
        let told = all.into_iter().enumerate().filter(|(at, (_, by))| *at < 3 || *by != (0, 0));
        told.map(|(_, (name, (constant, per_index)))| (name, constant, per_index)).collect()
    }
}

fn changes(changes: &[SizeChange]) -> BTreeMap<String, String> {
    let told = changes.iter().filter(|change| !change.is_nothing()).map(|change| {
        let constant = (change.constant != 0).then(|| format!("{:+}", change.constant));
        let per_index = (change.per_index != 0).then(|| format!("{:+}n", change.per_index));
        let gains = change.gains.iter().map(|run| format!("+{run}"));
        let loses = change.loses.iter().map(|run| format!("-{run}"));
        let but = change.varies.then(|| "where no names are one".to_owned());
        let parts: Vec<_> =
            constant.into_iter().chain(per_index).chain(gains).chain(loses).chain(but).collect();
        (change.element.clone(), parts.join(" "))
    });
    told.collect()
}

/// The verdict on an op, by its index.
pub fn verdict(analysis: &Analysis, op: usize) -> Verdict {
    let name = &analysis.program.ops[op].name;
    let steps = StepsVerdict::of(&analysis.program, &analysis.plans, op);
    Verdict::of(name, analysis.proved[op].as_ref(), steps, analysis.lacks[op].clone())
}

/// The verdict on every op of a file, in order; those of the files it uses are left out.
pub fn verdicts(analysis: &Analysis) -> Vec<Verdict> {
    let ops = analysis.program.ops.iter().enumerate();
    let ops = ops.filter(|(_, op)| op.span.file == analysis.file);
    ops.map(|(at, _)| verdict(analysis, at)).collect()
}

impl StepsVerdict {
    /// The verdict on an op in steps, if it has a plan.
    pub(super) fn of(program: &Program, plans: &[Option<Plan>], op: usize) -> Option<Self> {
        let plan = plans.get(op)?.as_ref()?;
        let calls = plan.steps.as_ref()?.calls.iter();
        let calls = program.names_of_ops(calls.map(|&(called, _)| usize::from(called)));
        Some(Self { calls, level: plan.level })
    }
}

impl Verdict {
    /// The verdict on an op, from its proof or, for an op in steps, from the verdict on its steps.
    pub(super) fn of(
        op: &str,
        proved: Option<&Proved>,
        steps: Option<StepsVerdict>,
        lacks: Option<String>,
    ) -> Self {
        let is_proved = proved.is_some() || steps.is_some();
        Self {
            op: op.to_owned(),
            lacks: lacks.filter(|_| !is_proved),
            proved: is_proved,
            rules: proved.into_iter().flat_map(rules).collect(),
            steps,
        }
    }
}

fn rules(proved: &Proved) -> Vec<RuleVerdict> {
    let rules = proved.op().rules.iter().zip(proved.proofs());
    rules.map(|(rule, proof)| RuleVerdict::new(rule, proof)).collect()
}
