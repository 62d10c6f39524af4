//! Outcomes of names being one.

use super::closure::{Contradiction, united};
use super::quotient::Quotient;
use crate::check::arrangement::Arc;
use crate::check::broken::Broken;
use crate::check::distinct_names::pairs_of;
use crate::check::statements::statements;
use crate::check::vertices_are_orbits::{self, Rings};
use crate::check::witness::{self, Counterexample, Outcome};
use crate::diagram::{Drawing, Kind, NameId, Op, Rule};

/// Names of a rule that are one, and the outcome.
#[derive(Clone, Debug)]
pub struct Identification {
    /// The sets of names that are one; all others are distinct. Edges are left out: two are one
    /// where their halfedges are.
    pub names: Vec<Vec<NameId>>,
    /// The outcome.
    pub verdict: Verdict,
}

/// The outcome of names being one.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The rewrite is proved there as well.
    Fine,
    /// It breaks a mesh.
    Breaks {
        /// The broken law, in words.
        why: String,
        /// The mesh.
        example: Box<Counterexample>,
    },
    /// The names are one in no mesh, for this reason.
    Impossible(String),
    /// It is not proved there, for this reason, and no small mesh was found that breaks.
    Unproved(String),
}

/// Sets of names that are one, with the ways in which they are.
pub(super) type Sets = Vec<(Vec<Vec<NameId>>, Vec<Quotient>)>;

/// The greatest number of sets of names that are examined, beyond what follows from each pair.
const MOST_SETS: usize = 48;

/// The outcomes of names of a rule being one: for each pair of one kind with all that follows from
/// it, then for combinations of pairs. A rule with families has none: its names stand for different
/// elements on every cycle. False if there are further combinations, which were not examined.
pub fn identifications(op: &Op, rule: &Rule) -> (Vec<Identification>, bool) {
    if rule.has_families() {
        return (Vec::new(), true);
    }
    let count = rule.names.len();
    let drawing = Drawing::new(rule);
    let kinds = [Kind::Vertex, Kind::Halfedge, Kind::Face];
    let mut sets = Sets::new();
    let mut found = Vec::new();
    let mut possible = Vec::new();
    let whole = Quotient::of(rule);
    for pair in kinds.into_iter().flat_map(|kind| pairs_of(&drawing, kind)) {
        match united(&whole, pair) {
            Ok(quotients) => {
                possible.push(pair);
                add(&mut sets, quotients, count, |_| true);
            }
            Err(why) => {
                found.push(Identification { names: vec![pair.to_vec()], verdict: why.verdict() })
            }
        }
    }
    let most = sets.len() + MOST_SETS;
    let mut at = 0;
    while at < sets.len() && sets.len() < most {
        for &pair in &possible {
            let quotients: Vec<_> = sets[at].1.iter().map(|known| united(known, pair)).collect();
            add(&mut sets, quotients.into_iter().flatten().flatten().collect(), count, |_| true);
        }
        at += 1;
    }
    let is_complete = at == sets.len();
    let judged = sets
        .into_iter()
        .map(|(names, quotients)| Identification { names, verdict: verdict(op, rule, quotients) });
    let mut all: Vec<_> = judged.collect();
    all.sort_by_key(|one| one.names.iter().map(Vec::len).sum::<usize>() - one.names.len());
    all.append(&mut found);
    (all, is_complete)
}

impl Contradiction {
    fn verdict(self) -> Verdict {
        match self {
            Self::Certain(why) => Verdict::Impossible(why),
            Self::Unclear(why) => Verdict::Unproved(why),
        }
    }
}

/// Groups quotients by the names that are one in them, if these are allowed.
pub(super) fn add(
    sets: &mut Sets,
    quotients: Vec<Quotient>,
    count: usize,
    is_allowed: impl Fn(&[Vec<NameId>]) -> bool,
) {
    let known = sets.len();
    for quotient in quotients {
        let names = quotient.classes(count);
        match sets.iter().position(|(other, _)| *other == names) {
            // The same set found once more has the same quotients.
            Some(at) if at < known => {}
            Some(at) => sets[at].1.push(quotient),
            None if is_allowed(&names) => sets.push((names, vec![quotient])),
            None => {}
        }
    }
}

/// Judges all ways in which the same names are one.
fn verdict(op: &Op, rule: &Rule, quotients: Vec<Quotient>) -> Verdict {
    let mut unproved = None;
    let mut impossible = None;
    let mut fine = false;
    for quotient in quotients {
        let quotient = quotient.finished();
        match laws(&quotient) {
            Ok(_) => fine = true,
            Err(Failed::Impossible(why)) => impossible = Some(why),
            Err(Failed::Broken { why, arcs }) => {
                let code = "alias-breaks";
                match witness::find_where_one(op, rule, &quotient, arcs.as_deref(), code) {
                    Outcome::Breaks(example) => return Verdict::Breaks { why, example },
                    _ => unproved = Some(why),
                }
            }
        }
    }
    match (unproved, impossible) {
        (Some(why), _) => Verdict::Unproved(why),
        (None, Some(why)) if !fine => Verdict::Impossible(why),
        _ => Verdict::Fine,
    }
}

/// The reason why a quotient is not proved.
pub(super) enum Failed {
    /// No mesh matches it.
    Impossible(String),
    /// It breaks a law.
    Broken {
        /// The law, in words.
        why: String,
        /// For law 7, the arcs of the case that fails.
        arcs: Option<Vec<Arc>>,
    },
}

/// Tests the laws on a finished quotient.
pub(super) fn laws(quotient: &Quotient) -> Result<Rings, Failed> {
    if let Some(clash) = quotient.clashes.first() {
        return Err(Failed::Broken { why: clash.clone(), arcs: None });
    }
    let drawing = Drawing::new(&quotient.rule);
    let tested = statements(&drawing).and_then(|()| vertices_are_orbits::test(&drawing));
    tested.map_err(|Broken { problems, arcs, .. }| {
        let impossible =
            problems.iter().find(|problem| problem.diagnostic.code == "impossible-drawing");
        let told = impossible.or(problems.first());
        let why = told.map_or(String::new(), |problem| problem.diagnostic.message.clone());
        match impossible {
            Some(_) => Failed::Impossible(why),
            None => Failed::Broken { why, arcs },
        }
    })
}
