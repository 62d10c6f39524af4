//! What the checker says of an op, and what meshes say.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use hedgerow::check::{Outcome, Proved, examine};
use hedgerow::compile::compile;
use hedgerow::diagram::Op;
use hedgerow::source::Sources;

use crate::battery::bases::read_back;
use crate::battery::experience::experience;
use crate::battery::trial::{Pool, Trial};
use support::reference::random::Random;
use support::reference::unrolling::unrolled;

/// Codes of rejections that do not say that a mesh breaks: the op says too little, or says a
/// thing that nobody can follow, or leaves a vertex alone.
pub const BY_RULE: &[&str] = &[
    "adjacent-runs",
    "alias-always",
    "alias-impossible",
    "alias-incomplete",
    "empty-fan",
    "erased-and-drawn",
    "erased-run",
    "missing-attribute",
    "missing-reassignment",
    "new-loop-kind",
    "spoke-twice",
    "too-many-cases",
    "unaccounted-name",
    "unknown-name",
    "unplaced-halfedge",
    "unreachable-name",
    "vertex-without-spokes",
];

/// What the checker said of a mutant, and what the meshes said.
pub struct Judged {
    pub text: String,
    pub verdict: Verdict,
    pub matches: usize,
    pub applied: usize,
    /// Whether a rejection comes with a mesh that breaks.
    pub shown: bool,
    /// How long the checker took.
    pub time: Duration,
    pub complaints: Vec<String>,
}

impl Judged {
    /// Whether it was rejected for breaking meshes, and breaks none.
    pub fn is_unfounded(&self) -> bool {
        let Verdict::Rejected(code, meshes) = self.verdict else {
            return false;
        };
        meshes == Meshes::Survived && !BY_RULE.contains(&code) && !self.shown
    }

    /// Whether it was rejected for breaking meshes, and breaks one.
    pub fn breaks_by_a_law(&self) -> bool {
        let Verdict::Rejected(code, meshes) = self.verdict else {
            return false;
        };
        meshes == Meshes::Broke && !BY_RULE.contains(&code)
    }

    /// The same, and none is shown.
    pub fn lacks_a_witness(&self) -> bool {
        self.breaks_by_a_law() && !self.shown
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    Accepted,
    /// By its code, and whether a mesh broke.
    Rejected(&'static str, Meshes),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Meshes {
    Broke,
    /// No mesh broke, but it was not what `after` draws.
    Lied,
    /// The rewrite cannot even be carried out.
    Unwritable,
    NeverMatched,
    Survived,
}

/// Judges an op on the meshes of the pool, and where it comes from.
pub fn judge(
    text: String,
    pool: &Pool,
    home: Option<&Trial>,
    random: &mut Random,
) -> Option<Judged> {
    let (sources, op) = read_back(&text)?;
    let start = Instant::now();
    let checked = catch_unwind(AssertUnwindSafe(|| examine(&op)));
    let time = start.elapsed();
    let mut judged = Judged {
        text,
        verdict: Verdict::Accepted,
        matches: 0,
        applied: 0,
        shown: false,
        time,
        complaints: Vec::new(),
    };
    let Ok(checked) = checked else {
        judged.complaints.push("the checker panics".into());
        return Some(judged);
    };
    match checked {
        Ok(proved) => {
            let sizes = sizes(proved.op(), &judged.text, LONGEST);
            accepted(&proved, &sources, &sizes, pool, home, random, &mut judged);
        }
        Err(rejection) => {
            let code = rejection.diagnostics.first().map_or("none", |told| told.code);
            judged.shown = rejection.outcomes.iter().any(|it| matches!(it, Outcome::Breaks(_)));
            let sizes = sizes(&op, &judged.text, TRIED);
            let rules: Vec<_> = sizes.iter().map(|op| &op.rules[0]).collect();
            let trials = home.cloned().into_iter().chain(pool.trials(&sizes, random));
            let experience = experience(&rules, None, trials);
            judged.matches = experience.matches;
            let meshes = if experience.broken > 0 {
                Meshes::Broke
            } else if experience.lies > 0 {
                Meshes::Lied
            } else if experience.unwritable > 0 {
                Meshes::Unwritable
            } else if experience.matches == 0 || contradicts(&sizes, pool, random) {
                Meshes::NeverMatched
            } else {
                Meshes::Survived
            };
            judged.verdict = Verdict::Rejected(code, meshes);
        }
    }
    Some(judged)
}

/// Cycles up to this long are drawn, and others met in maps.
pub const TRIED: usize = 4;

/// No orbit of a mesh that is tried is longer.
const LONGEST: usize = 14;

/// The op without families: itself, or written out for cycles of size 1, 2 and so on.
pub fn sizes(op: &Op, text: &str, most: usize) -> Vec<Op> {
    if !op.rules[0].has_families() {
        return vec![op.clone()];
    }
    let written = (1..=most).map(|size| unrolled(text, size as i64));
    written.filter_map(|text| Some(read_back(&text)?.1)).collect()
}

/// Whether a rule with families matches on cycles of 1 and 2 alone: there `h[i+1]` and `h[i-1]`
/// may be one, on all longer cycles the drawing contradicts itself.
fn contradicts(sizes: &[Op], pool: &Pool, random: &mut Random) -> bool {
    let longer = sizes.get(2..).unwrap_or_default();
    let rules: Vec<_> = longer.iter().map(|op| &op.rules[0]).collect();
    !longer.is_empty() && experience(&rules, None, pool.trials(longer, random)).matches == 0
}

fn accepted(
    proved: &Proved,
    sources: &Sources,
    sizes: &[Op],
    pool: &Pool,
    home: Option<&Trial>,
    random: &mut Random,
    judged: &mut Judged,
) {
    let rules: Vec<_> = sizes.iter().map(|op| &op.rules[0]).collect();
    let tried = &sizes[..sizes.len().min(TRIED)];
    let run = catch_unwind(AssertUnwindSafe(|| {
        let plan = compile(proved, sources, &Arc::default()).expect("a small op");
        let trials = home.cloned().into_iter().chain(pool.trials(tried, random));
        experience(&rules, Some((&plan, &proved.keeps())), trials)
    }));
    let Ok(experience) = run else {
        judged.complaints.push("compiling or running it panics".into());
        return;
    };
    judged.matches = experience.matches;
    judged.applied = experience.applied;
    if let Some((_, smallest)) = experience.smallest {
        let times = experience.broken;
        judged.complaints.push(format!("accepted, but breaks {times} meshes: {smallest}"));
    }
    let smallest = experience.differences.into_iter().min_by_key(String::len);
    judged.complaints.extend(smallest);
}
