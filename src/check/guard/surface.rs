//! Obligations of `surface`: loops of three sides, vertices of two spokes with one hole at most,
//! loops that meet a vertex once.

use super::evidence;
use super::obligation::{Condition, Obligation, Statement};
use super::sketch::Sketch;
use crate::diagram::{Kind, Loop, LoopKind, NameId};
use crate::mesh::OrbitCondition as Orbit;

/// The obligations of `surface`.
pub(super) fn obligations(sketch: &Sketch) -> Vec<Obligation> {
    let mut obligations = Vec::new();
    obligations.extend(sketch.loops().iter().map(|orbit| three_sides(sketch, orbit)));
    for vertex in sketch.vertices() {
        obligations.extend(two_spokes(sketch, vertex));
    }
    for vertex in sketch.vertices() {
        obligations.extend(one_hole(sketch, vertex));
    }
    for orbit in sketch.loops() {
        let paths = sketch.paths(orbit);
        obligations.extend(paths.filter_map(|path| one_hole_along(sketch, orbit, path)));
    }
    for orbit in sketch.loops() {
        obligations.extend(meets_once(sketch, orbit));
    }
    for vertex in sketch.vertices() {
        obligations.extend(faces_differ(sketch, vertex));
    }
    obligations
}

/// A loop of `after` has its drawn halfedges and those of its paths.
fn three_sides(sketch: &Sketch, orbit: &Loop) -> Obligation {
    let statement = Statement::new(Orbit::ThreeSides, orbit.face.name);
    let proved = sketch.fewest(orbit) >= 3;
    let because = "its drawn sides, and the fewest that its paths can have, make three";
    let is_known = sketch.paths(orbit).next().is_none();
    Obligation::new(statement, proved.then_some(because)).or_never(is_known && !proved)
}

/// A vertex that loses a spoke must have two left.
fn two_spokes(sketch: &Sketch, vertex: NameId) -> Option<Obligation> {
    if !sketch.loses_a_spoke(vertex) {
        return None;
    }
    let proved = sketch.spokes_for_sure(vertex) >= 2;
    let because = "two of its spokes are drawn";
    let statement = Statement::new(Orbit::TwoSpokes, vertex);
    Some(Obligation::new(statement, proved.then_some(because)))
}

/// The corners of a vertex are drawn ones, and those that come from vertices of `before` without
/// being drawn. At most one corner of each of these vertices lies in a hole.
fn one_hole(sketch: &Sketch, vertex: NameId) -> Option<Obligation> {
    let from = sketch.outside(vertex);
    let after = sketch.holes_after(vertex);
    let stays = after.is_empty() && (from.is_empty() || from == [vertex]);
    if stays {
        return None;
    }
    // A vertex whose corner in a hole is drawn has no other.
    let has_one = |source: &&NameId| {
        let drawn = sketch.holes_before(**source);
        !drawn.iter().any(|(_, kind)| *kind == LoopKind::Hole)
    };
    let outside = from.iter().filter(has_one).count();
    let drawn = match after.as_slice() {
        [(left, _), (right, _)] if sketch.never_both_holes(*left, *right) => 1,
        after => after.len(),
    };
    // Or the corners are all from one vertex, and no more of them are in holes than were.
    let source = match from.as_slice() {
        [] if sketch.drawing.survives(vertex) => Some(vertex),
        [source] => Some(*source),
        _ => None,
    };
    let as_before = source.is_some_and(|source| {
        let mut before = sketch.holes_before(source);
        after.iter().all(|corner| {
            let at = before.iter().position(|known| known == corner);
            at.map(|at| before.swap_remove(at)).is_some()
        })
    });
    let because = if outside + drawn <= 1 {
        Some("one of its corners at most can lie in a hole")
    } else if as_before {
        Some("it has no corner in a hole that it did not have")
    } else {
        evidence::one_hole(sketch, vertex, &from)
    };
    let statement = Statement::new(Orbit::OneHole, vertex).telling(from);
    Some(Obligation::new(statement, because))
}

/// The vertices of a path get a corner in a hole where the path goes from a face to a hole.
fn one_hole_along(sketch: &Sketch, orbit: &Loop, path: NameId) -> Option<Obligation> {
    let before = sketch.drawing.before.loop_of_item(path)?;
    let was_hole = before.kind == LoopKind::Hole;
    let stays = before.kind == orbit.kind && before.face.name == orbit.face.name;
    if orbit.kind == LoopKind::Face || was_hole || stays {
        return None;
    }
    Some(Obligation::new(Statement::new(Condition::OneHoleAlong, path), None))
}

/// The obligation to meet once: where the pieces of a loop come from different loops, they may
/// meet.
fn meets_once(sketch: &Sketch, orbit: &Loop) -> Vec<Obligation> {
    let face = orbit.face.name;
    let corners: Vec<_> = orbit.corners().collect();
    let repeated = (1..corners.len()).any(|at| corners[..at].contains(&corners[at]));
    let paths: Vec<_> = sketch.paths(orbit).collect();
    let loop_before = |path: NameId| sketch.drawing.before.face(path);
    let paths_may_meet = paths.iter().any(|&path| loop_before(path) != loop_before(paths[0]));
    let once = Statement::new(Orbit::MeetsOnce, face);
    if repeated || paths_may_meet {
        return vec![Obligation::new(once, None).or_never(repeated)];
    }
    let mut tests = Vec::new();
    for &vertex in &corners {
        if paths.iter().any(|&path| sketch.may_lie_on(vertex, path)) {
            let statement = Statement::new(Orbit::CornerOnce, face).at(vertex);
            tests.push(Obligation::new(statement, None));
        }
    }
    if tests.is_empty() {
        let because = match paths.is_empty() {
            true => "all its corners are named, and different names are different vertices",
            false => "its paths come from one loop, which has no other corner at the named ones",
        };
        tests.push(Obligation::new(once, Some(because)));
    }
    tests
}

/// Stars that become one may have a loop in common.
fn faces_differ(sketch: &Sketch, vertex: NameId) -> Option<Obligation> {
    debug_assert!(sketch.drawing.rule.kind(vertex) == Kind::Vertex);
    let from = sketch.outside(vertex);
    let statement = Statement::new(Orbit::FacesDiffer, vertex).telling(from.clone());
    match from.as_slice() {
        [] => None,
        [source] if *source == vertex => None,
        [_] => {
            let because = "what it has from outside of the drawing lay around one vertex before";
            Some(Obligation::new(statement, Some(because)))
        }
        _ => Some(Obligation::new(statement, None)),
    }
}
