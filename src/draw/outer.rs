//! The outside of a figure.
//!
//! The drawn loops are polygons glued along their edges; the sides that are in no loop form walks
//! around the result. The longest walk is the outside. Where all sides are in loops, as on a closed
//! surface, the outside is a hole, or else the longest loop, one that stays as it is if there are
//! several. A hole that is the only loop and runs around several pieces is the outside as well.

use super::figure::{Dart, Figure, Orbit, Side};
use crate::diagram::LoopKind;

/// The darts around the outside, clockwise; empty if there is no loop. Only loops and walks whose
/// first node is in `among` count.
pub(super) fn outside(figure: &Figure, side: &Side, among: &dyn Fn(usize) -> bool) -> Vec<Dart> {
    let counts = |darts: &[Dart]| darts.first().is_some_and(|&dart| among(side.nodes(dart)[0]));
    let walks: Vec<_> = walks(side).into_iter().filter(|walk| counts(walk)).collect();
    // A hole around several pieces is itself the outside.
    let is_around = |orbit: &Orbit| orbit.kind == LoopKind::Hole && walks.len() > 1;
    if let [orbit] = &side.loops[..]
        && is_around(orbit)
    {
        return orbit.darts.clone();
    }
    if let Some(walk) = longest(walks.into_iter()) {
        return walk;
    }
    let loops = |holes: bool| {
        let wanted = side.loops.iter();
        let wanted = wanted
            .filter(move |orbit| (orbit.kind == LoopKind::Hole) == holes && counts(&orbit.darts));
        let (stay, change): (Vec<_>, Vec<_>) = wanted.partition(|orbit| figure.stays(orbit));
        longest(stay.into_iter().chain(change).map(|orbit| orbit.darts.clone()))
    };
    loops(true).or_else(|| loops(false)).unwrap_or_default()
}

fn longest(walks: impl Iterator<Item = Vec<Dart>>) -> Option<Vec<Dart>> {
    let mut best: Option<Vec<Dart>> = None;
    for walk in walks {
        if best.as_ref().is_none_or(|best| walk.len() > best.len()) {
            best = Some(walk);
        }
    }
    best
}

/// The walks along the sides that are in no loop.
fn walks(side: &Side) -> Vec<Vec<Dart>> {
    let count = 2 * side.strands.len();
    let mut before = vec![None; count];
    for orbit in &side.loops {
        for (at, dart) in orbit.darts.iter().enumerate() {
            let previous = orbit.darts[(at + orbit.darts.len() - 1) % orbit.darts.len()];
            before[dart.index()].get_or_insert(previous.index());
        }
    }
    let is_outside = |dart: usize| before[dart].is_none() && before[dart ^ 1].is_some();
    let mut seen = vec![false; count];
    let mut walks = Vec::new();
    for first in (0..count).filter(|&dart| is_outside(dart)) {
        let mut walk = Vec::new();
        let mut dart = first;
        while !seen[dart] {
            seen[dart] = true;
            walk.push(Dart::of(dart));
            // Turns around the vertex at its end, through the corners that are drawn.
            let mut spoke = dart ^ 1;
            for _ in 0..count {
                match before[spoke] {
                    Some(previous) => spoke = previous ^ 1,
                    None => break,
                }
            }
            dart = spoke;
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    walks
}
