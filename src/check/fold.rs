//! Findings on cycles of several sizes, merged into findings about the members at index 0.

use super::distinct_names;
use super::guard::{Obligation, Statement};
use crate::diagram::{Drawing, NameId, Unrolled};

/// The map from the names of one size to those of the large one.
pub(super) struct Fold<'a> {
    pub large: &'a Unrolled,
    pub other: &'a Unrolled,
}

impl Fold<'_> {
    /// The name on the large cycle, where the member `pivot` is at index 0.
    fn name(&self, name: NameId, pivot: NameId) -> NameId {
        let rule = &self.other.rule;
        let by = -i64::from(rule.index(pivot));
        let offset = if rule.is_member(name) { rule.offset(rule.turned(name, by)) } else { 0 };
        self.large.member(self.other.source(name), offset)
    }
}

/// The pairs of names that only a test keeps apart on a cycle of some size.
pub(super) fn fold_pairs<'a>(
    sizes: impl Iterator<Item = &'a Unrolled>,
    large: &Unrolled,
) -> Vec<[NameId; 2]> {
    let mut folded = Vec::new();
    for other in sizes {
        let fold = Fold { large, other };
        for pair in distinct_names::pairs(&Drawing::new(&other.rule)) {
            let mut pair = pair.map(|name| fold.name(name, name));
            pair.sort_unstable();
            folded.push(pair);
        }
    }
    folded.sort_unstable();
    folded.dedup();
    folded
}

/// Adds the obligations of a level on one size. A statement is tested on every size if it has to be
/// tested on one: each is a condition of the level, so the further tests refuse nothing else.
pub(super) fn fold_obligations(
    fold: &Fold,
    obligations: Vec<Obligation>,
    found: &mut Vec<Obligation>,
) {
    for Obligation { statement, because, .. } in obligations {
        add_obligation(near(fold, statement), because, found);
    }
}

/// Adds a statement to those found in other cases; it is tested if it has to be tested in one of
/// them.
pub(super) fn add_obligation(
    statement: Statement,
    because: Option<&'static str>,
    found: &mut Vec<Obligation>,
) {
    let wanted = statement.without_origin();
    let known = found.iter_mut().find(|known| known.statement.without_origin() == wanted);
    match known {
        Some(known) if because.is_none() => known.because = None,
        Some(_) => {}
        None => found.push(Obligation { statement, because, is_never: false }),
    }
}

/// The statement for index 0. One about two names far apart, or about a single orbit and
/// every member of a family, becomes one about the whole orbit, which says more and costs
/// less: it too is a condition of the level.
fn near(fold: &Fold, statement: Statement) -> Statement {
    let rule = &fold.other.rule;
    let large = &fold.large.rule;
    let pivot = statement.subject();
    let pivot = match &statement {
        Statement::CornerOnce { vertex, .. } if !rule.is_member(pivot) => *vertex,
        Statement::CornersOwn { vertex, .. } if !rule.is_member(pivot) => *vertex,
        _ => pivot,
    };
    let far = |name: NameId| {
        let reach = 2 * i64::from(large.span_of_subscripts()) + 1;
        large.offset(name).abs() > reach
    };
    let name = |of: NameId| fold.name(of, pivot);
    let origins = |from: Vec<NameId>| {
        let mut folded: Vec<NameId> = Vec::new();
        for source in from {
            let source = large.first_member(name(source));
            if !folded.contains(&source) {
                folded.push(source);
            }
        }
        folded
    };
    match statement {
        Statement::ThreeSides(face) => Statement::ThreeSides(name(face)),
        Statement::MeetsOnce(face) => Statement::MeetsOnce(name(face)),
        Statement::CornerOnce { face, vertex } => {
            let (face, vertex) = (name(face), name(vertex));
            match far(vertex) || far(face) {
                true => Statement::MeetsOnce(large.first_member(face)),
                false => Statement::CornerOnce { face, vertex },
            }
        }
        Statement::FacesDiffer { vertex, from } => {
            Statement::FacesDiffer { vertex: name(vertex), from: origins(from) }
        }
        Statement::TwoSpokes(vertex) => Statement::TwoSpokes(name(vertex)),
        Statement::OneHole { vertex, from } => {
            Statement::OneHole { vertex: name(vertex), from: origins(from) }
        }
        Statement::OneHoleAlong(path) => Statement::OneHoleAlong(name(path)),
        Statement::NeighborsDiffer { vertex, from } => {
            Statement::NeighborsDiffer { vertex: name(vertex), from: origins(from) }
        }
        Statement::SingleEdge { halfedge, ends } => {
            let single = ends.into_iter().find(|&end| !rule.is_member(end));
            match single.filter(|_| rule.is_member(halfedge)) {
                Some(vertex) => {
                    Statement::NeighborsDiffer { vertex: name(vertex), from: Vec::new() }
                }
                None => Statement::SingleEdge { halfedge: name(halfedge), ends: ends.map(name) },
            }
        }
        Statement::CornersDiffer(vertex) => Statement::CornersDiffer(name(vertex)),
        Statement::CornersOwn { face, vertex } => {
            match rule.is_member(face) && !rule.is_member(vertex) {
                true => Statement::CornersDiffer(name(vertex)),
                false => Statement::CornersOwn { face: name(face), vertex: name(vertex) },
            }
        }
    }
}
