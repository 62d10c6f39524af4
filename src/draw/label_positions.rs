//! Positions of labels: beside an arrow, inside a face, in the widest gap at a vertex.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::curve::{Curve, bounds, distance, left, mean, sides, turn};
use super::label_boxes::{Spot, reach};
use super::letters::Label;
use crate::mesh::is_inside;

/// The radius of a vertex.
pub(super) const DOT: f64 = 4.5;
/// The resolution of the grid on which a face is searched for room.
const GRID: u32 = 24;

/// The spots on the left of an arrow; those near it and near its middle cost least.
pub(super) fn beside(arrow: &Curve, label: &Label) -> Vec<Spot> {
    let length = arrow.length();
    let mut spots = Vec::new();
    for (place, part) in
        [0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82].into_iter().enumerate()
    {
        let (at, way) = arrow.at(length * part);
        let aside = left(way);
        for (far, gap) in [7.5, 10.0, 14.0, 20.0].into_iter().enumerate() {
            // The support of the box, so that a slanted line does not touch its corner.
            let clear = label.half.dot(aside.abs());
            // Nearer, a corner of a long name may lie on the line or beyond its end.
            let near = clear.min(reach(label.half, aside) + 4.0);
            let spot = |clear: f64| Spot {
                at: at + aside * (clear + gap - 2.0),
                cost: 2.0 * place as f64 + 4.0 * far as f64 + 0.2 * (clear - near),
            };
            spots.push(spot(near));
            if clear > near {
                spots.push(spot(clear));
            }
        }
    }
    spots
}

/// Points inside a polygon but outside its islands, each with its distance from the sides.
fn inner_points(outline: &[DVec2], islands: &[Vec<DVec2>]) -> Vec<(DVec2, f64)> {
    let (low, high) = bounds(outline.iter().copied());
    let outlines = islands.iter().map(Vec::as_slice).chain([outline]);
    let sides: Vec<_> = outlines.flat_map(sides).collect();
    let in_sea = |at: DVec2| !islands.iter().any(|island| is_inside(at, island));
    let room = |at: DVec2| sides.iter().map(|side| distance(at, *side)).fold(f64::MAX, f64::min);
    let steps = 1..GRID;
    let points = steps.clone().flat_map(|row| steps.clone().map(move |column| (column, row)));
    points
        .map(|(column, row)| {
            low + (high - low) * DVec2::new(column.into(), row.into()) / f64::from(GRID)
        })
        .filter(|&at| is_inside(at, outline) && in_sea(at))
        .map(|at| (at, room(at)))
        .collect()
}

/// The approximate radius of the largest circle inside a polygon.
pub(super) fn widest_circle(outline: &[DVec2]) -> f64 {
    inner_points(outline, &[]).into_iter().map(|(_, room)| room).fold(0.0, f64::max)
}

/// Spots inside a polygon but outside its islands; the more room a spot has, the less it costs.
pub(super) fn inner_spots(outline: &[DVec2], islands: &[Vec<DVec2>]) -> Vec<Spot> {
    let points = inner_points(outline, islands);
    let most = points.iter().map(|(_, room)| *room).fold(0.0, f64::max);
    let good = points.iter().filter(|(_, room)| *room > most - 1.0);
    let good: Vec<_> = good.map(|(at, _)| *at).collect();
    let center = mean(&good);
    let mut all = Vec::new();
    // The middle of a ring is not part of it.
    if islands.is_empty() {
        all.push(Spot { at: center, cost: 0.0 });
    }
    all.extend(points.into_iter().map(|(at, room)| Spot {
        at,
        cost: 1.0 + (most - room) * 0.5 + (at - center).length() * 0.2,
    }));
    all
}

/// The middle of the widest gap between directions.
pub(super) fn widest_gap(angles: &[f64]) -> f64 {
    let mut best = (0.0, PI / 2.0);
    for &from in angles {
        let gap = angles.iter().map(|&to| turn(from, to)).fold(TAU, f64::min);
        if gap > best.0 + 1e-6 {
            best = (gap, from + gap / 2.0);
        }
    }
    best.1
}

/// The distance from a vertex at which a text clears its dot.
pub(super) fn beyond_dot(label: &Label, way: DVec2) -> f64 {
    DOT + 5.0 + reach(label.half, way)
}
