//! Facts that a proof establishes besides validity: the change of the counts, and the cost.

use super::change::Change;
use super::cost::grows_with;
use super::guard::Obligation;
use super::matching::Step;
use super::properties::{SizeChange, degree_changes, evenly, kept, kept_by_families, size_changes};
use super::sizes::Sizes;
use crate::diagram::{Drawing, LoopKind, Property, Rule};

/// The facts about a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The number of ways in which the mesh around the drawing can lie; all of them are checked.
    pub cases: usize,
    /// The change of the numbers of elements; with families, without the part that comes per index.
    pub change: Change,
    /// The change for each index, if there are families.
    pub per_index: Option<Change>,
    /// The quantities that the time grows with, in words; empty if it is constant.
    pub grows_with: Vec<String>,
    /// The properties that are kept besides validity, declared or not.
    pub keeps: Vec<Property>,
    /// The number of tests that `guard simple` would make, where that level is not kept.
    pub untested: usize,
    /// The reason why that guard would refuse every place, if it would.
    pub never_simple: Option<String>,
    /// The faces that become holes, and the holes that become faces.
    pub turned: Vec<Turned>,
    /// The changes of the degrees of the vertices that survive.
    pub degrees: Vec<SizeChange>,
    /// The changes of the numbers of sides of the faces that survive.
    pub sizes: Vec<SizeChange>,
}

/// A loop that changes its kind, such as a face that becomes a hole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Turned {
    /// Its name.
    pub face: String,
    /// The kind before.
    pub from: LoopKind,
    /// The kind after.
    pub to: LoopKind,
}

impl Facts {
    /// Reads the facts of a proved rule off its drawing and its matching.
    pub(super) fn of(
        drawing: &Drawing,
        matching: &[Step],
        guard: &[Obligation],
        cases: usize,
    ) -> Self {
        let change = Change::of(drawing.rule);
        let grows_with = grows_with(drawing, matching, guard);
        Self {
            cases,
            change,
            per_index: None,
            keeps: kept(drawing, change, &grows_with),
            grows_with,
            untested: 0,
            never_simple: None,
            turned: turned(drawing),
            degrees: degree_changes(drawing),
            sizes: size_changes(drawing),
        }
    }

    /// Notes what `guard simple` would test, where that level is not kept.
    pub(super) fn note_untested(&mut self, rule: &Rule, asked: &[Obligation]) {
        self.untested = asked.iter().filter(|one| one.is_test()).count();
        let never = asked.iter().find(|one| one.is_never);
        self.never_simple = never.map(|one| one.statement.refusal(rule));
    }

    /// The facts of a rule with families: those that hold on cycles of all sizes.
    pub(super) fn of_families(
        sizes: &Sizes,
        matching: &[Step],
        guard: &[Obligation],
        cases: usize,
    ) -> Self {
        let drawing = Drawing::new(&sizes.large.rule);
        let grows_with = grows_with(&drawing, matching, guard);
        // All counts grow linearly with the size.
        let counts: Vec<_> = sizes.small.iter().map(|one| Change::of(&one.rule)).collect();
        let per_index = counts[1].minus(counts[0]);
        Self {
            cases,
            change: counts[0].minus(per_index),
            per_index: Some(per_index),
            keeps: kept_by_families(sizes, &grows_with),
            grows_with,
            untested: 0,
            never_simple: None,
            turned: turned(&drawing),
            degrees: evenly(sizes, degree_changes),
            sizes: evenly(sizes, size_changes),
        }
    }
}

/// The faces that become holes, and the holes that become faces; one for each family.
fn turned(drawing: &Drawing) -> Vec<Turned> {
    let loops = drawing.rule.after.loops.iter();
    let turned = loops.filter(|orbit| drawing.rule.is_first(orbit.face.name)).filter_map(|orbit| {
        let before = drawing.before.loop_of_face(orbit.face.name)?;
        let face = drawing.rule.name(orbit.face.name).text.clone();
        (before.kind != orbit.kind).then_some(Turned { face, from: before.kind, to: orbit.kind })
    });
    turned.collect()
}
