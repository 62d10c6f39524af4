//! Findings on cycles of several sizes, merged into findings about the members at index 0.

use super::distinct_names;
use super::guard::{Obligation, Statement};
use crate::diagram::{Drawing, NameId, Unrolled};
use crate::mesh::OrbitCondition as Orbit;

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
    let is_it = |known: &Statement| {
        (known.condition, known.of, known.at) == (statement.condition, statement.of, statement.at)
    };
    let known = found.iter_mut().find(|known| is_it(&known.statement));
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
    let Statement { condition, of, at, others } = statement;
    let pivot = at.filter(|_| !rule.is_member(of)).unwrap_or(of);
    let far = |name: NameId| {
        let reach = 2 * i64::from(large.span_of_subscripts()) + 1;
        large.offset(name).abs() > reach
    };
    let name = |of: NameId| fold.name(of, pivot);
    if condition == Orbit::SingleEdge.into() {
        let single = others.iter().find(|&&end| !rule.is_member(end));
        if let Some(&vertex) = single.filter(|_| rule.is_member(of)) {
            return Statement::new(Orbit::NeighborsDiffer, name(vertex));
        }
        return Statement::new(condition, name(of)).telling(others.into_iter().map(name).collect());
    }
    if let Some(corner) = at {
        let far_apart = [of, corner].into_iter().any(|one| far(name(one)));
        if condition == Orbit::CornerOnce.into() && far_apart {
            return Statement::new(Orbit::MeetsOnce, large.first_member(name(of)));
        }
        if condition == Orbit::CornersOwn.into() && rule.is_member(of) && !rule.is_member(corner) {
            return Statement::new(Orbit::CornersDiffer, name(corner));
        }
    }
    let mut origins: Vec<NameId> = Vec::new();
    for source in others {
        let source = large.first_member(name(source));
        if !origins.contains(&source) {
            origins.push(source);
        }
    }
    Statement { condition, of: name(of), at: at.map(name), others: origins }
}
