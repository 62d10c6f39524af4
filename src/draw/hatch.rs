//! Hatching, which distinguishes holes from faces.

use glam::DVec2;

use super::curve::{Curve, distance, left, sides};

/// The distance between two lines.
const APART: f64 = 8.0;
/// The distance from the outline at which the hatching around a figure begins.
const ASIDE: f64 = 20.0;

/// Slanted lines inside a polygon, except in its islands.
pub(super) fn hatch(outline: &[DVec2], islands: &[Vec<DVec2>]) -> Vec<Curve> {
    let slant = DVec2::new(1.0, -1.0).normalize();
    let across = DVec2::new(1.0, 1.0).normalize();
    let heights = outline.iter().map(|at| at.dot(across));
    let (low, high) =
        heights.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
    let mut lines = Vec::new();
    if !(high - low).is_finite() {
        return lines;
    }
    let outlines = islands.iter().map(Vec::as_slice).chain([outline]);
    let sides: Vec<_> = outlines.flat_map(sides).collect();
    // Offset by half a distance, so that no line passes through a corner of a tidy picture.
    let first = (low / APART).floor() as i64;
    let last = (high / APART).ceil() as i64;
    for step in first..=last {
        let height = (step as f64 + 0.5) * APART;
        let mut cuts: Vec<f64> = sides
            .iter()
            .filter_map(|&[a, b]| {
                let (from, to) = (a.dot(across) - height, b.dot(across) - height);
                let crosses = (from < 0.0) != (to < 0.0);
                crosses.then(|| a.lerp(b, from / (from - to)).dot(slant))
            })
            .collect();
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.chunks_exact(2) {
            if pair[1] - pair[0] > 3.0 {
                let ends = [pair[0] + 1.0, pair[1] - 1.0];
                lines.push(Curve::through(ends.map(|at| slant * at + across * height)));
            }
        }
    }
    lines
}

/// Short lines on the left of a curve, such as the outside of a polygon that a hole surrounds.
pub(super) fn ticks(around: &Curve) -> Vec<Curve> {
    let count = (around.length() / APART).floor().min(4000.0) as usize;
    let tick = |step: usize| {
        let (at, way) = around.at((step as f64 + 0.5) * APART);
        let slant = (left(way) - way * 0.7).normalize_or_zero();
        let from = at + left(way) * ASIDE;
        [from, from + slant * 9.0]
    };
    // In a corner of the hole there is room for the ticks of one side only.
    let is_free = |ends: &[DVec2; 2]| {
        let far = |end: DVec2| around.segments().all(|side| distance(end, side) > 0.85 * ASIDE);
        ends.iter().all(|&end| far(end))
    };
    let ticks = (0..count).map(tick).filter(is_free);
    ticks.map(Curve::through).collect()
}
