//! Routing of the strands of `after` that have changed.
//!
//! A path that gets other ends keeps its shape, turned and flattened, unless it would then cross
//! something, or enclose what is not part of its loop: then it becomes an arc that does not. A path
//! that closes becomes a petal on the side where it was.

use std::f64::consts::PI;

use glam::DVec2;

use super::curve::{Curve, angle, area, left, mean, turn};
use super::figure::{Figure, Node, Side, Strand};
use super::layout::NEAR;
use crate::mesh::is_inside;

/// The factor by which a path that keeps its shape is flattened.
const FLATTER: f64 = 0.7;
/// The heights of the arcs that are tried, relative to their widths.
const HEIGHTS: [f64; 6] = [0.45, -0.45, 0.25, -0.25, 0.8, -0.8];
/// The length and the width of the petal of a path that closes.
const PETAL: f64 = 1.35;
const SPREAD: f64 = 1.05;
/// The angle, in radians, between the middle of a petal and any other strand at its vertex.
const CLEAR: f64 = 1.5;

/// Bends the paths that get other ends, or whose ends move; `before` holds the earlier places.
pub(super) fn bend_paths(figure: &Figure, before: &[Option<DVec2>], places: &mut [Option<DVec2>]) {
    let known: Vec<_> = before.iter().flatten().copied().collect();
    let center = mean(&known);
    for (at, strand) in figure.after.strands.iter().enumerate() {
        let mut earlier = figure.before.strands.iter();
        let old = earlier.find(|other| strand.is_path && other.items == strand.items);
        let is_bent = strand.nodes.iter().all(|&node| places[node].is_some());
        let Some(old) = old.filter(|old| old.nodes != strand.nodes || !is_bent) else { continue };
        let points: Option<Vec<_>> = old.nodes.iter().map(|&node| before[node]).collect();
        let [from, to] = strand.ends();
        let (Some(points), Some(a), Some(b)) = (points, places[from], places[to]) else { continue };
        let scene = Scene { side: &figure.after, places, center };
        let best = match from == to {
            true => scene.petal(at, a, &points),
            false => scene.arc(at, [a, b], &points),
        };
        for (&node, place) in strand.nodes.iter().zip(best).skip(1) {
            places[node] = places[node].or(Some(place));
        }
    }
}

/// The strands placed so far.
struct Scene<'a> {
    side: &'a Side,
    places: &'a [Option<DVec2>],
    /// The centroid of the earlier places.
    center: DVec2,
}

impl Scene<'_> {
    /// The places along a path with two ends.
    fn arc(&self, strand: usize, [a, b]: [DVec2; 2], old: &[DVec2]) -> Vec<DVec2> {
        let last = old.len() - 1;
        let mut all = Vec::new();
        let was = old[last] - old[0];
        if was.length() > NEAR {
            let back = DVec2::new(was.x, -was.y) / was.length_squared();
            let moved = old.iter().map(|&at| {
                // Along and across the direction from end to end.
                let at = back.rotate(at - old[0]);
                a + (b - a).rotate(DVec2::new(at.x, at.y * FLATTER))
            });
            all.push(moved.collect::<Vec<_>>());
        }
        all.extend(HEIGHTS.map(|height| {
            let place = |at: usize| {
                let t = at as f64 / last as f64;
                a.lerp(b, t) + left(b - a) * (height * 4.0 * t * (1.0 - t))
            };
            (0..=last).map(place).collect()
        }));
        let faults = |points: &Vec<DVec2>| self.faults(strand, points);
        all.into_iter().min_by_key(faults).unwrap_or_default()
    }

    /// The places along a path that closes.
    fn petal(&self, strand: usize, root: DVec2, old: &[DVec2]) -> Vec<DVec2> {
        let last = old.len() - 1;
        let middle = mean(&old[1..last]);
        // Also away from the middle of the figure, to leave room between two petals.
        let outward = (middle - self.center).normalize_or_zero();
        let away = (middle - root).normalize_or(DVec2::X) + outward;
        let away = away.normalize_or(DVec2::X);
        let others = self.directions(strand);
        let worth = |step: &i32| {
            let way = angle(away) + 0.1 * f64::from(*step);
            let gap = |&other: &f64| turn(other, way).min(turn(way, other));
            let gap = others.iter().map(gap).fold(PI, f64::min);
            0.1 * f64::from(step.abs()) + 4.0 * (CLEAR - gap).max(0.0)
        };
        let steps = (0..=15).flat_map(|step| [step, -step]);
        let best = steps.min_by(|a, b| worth(a).total_cmp(&worth(b)));
        // Angles are counterclockwise, rotations of a picture clockwise.
        let away = away.rotate(DVec2::from_angle(-0.1 * f64::from(best.unwrap_or(0))));
        // No further than the path reached before.
        let far = old.iter().map(|at| (*at - root).length());
        let far = far.fold(0.0, f64::max).clamp(PETAL / 2.0, PETAL);
        let place = |at: usize| {
            let t = at as f64 / last as f64;
            let length = far * (PI * t).sin().abs().sqrt();
            root + away.rotate(DVec2::from_angle((0.5 - t) * SPREAD)) * length
        };
        (0..=last).map(place).collect()
    }

    /// The angles at which the other strands leave the vertex where a strand closes.
    fn directions(&self, strand: usize) -> Vec<f64> {
        let root = self.side.strands[strand].nodes[0];
        let mut angles = Vec::new();
        for (at, other) in self.side.strands.iter().enumerate() {
            let nodes = &other.nodes;
            let pairs = [[nodes[0], nodes[1]], [nodes[nodes.len() - 1], nodes[nodes.len() - 2]]];
            for [end, next] in pairs {
                if let (Some(from), Some(to)) = (self.places[end], self.places[next])
                    && end == root
                    && at != strand
                {
                    angles.push(angle(to - from));
                }
            }
        }
        angles
    }

    fn points(&self, strand: &Strand) -> Option<Vec<DVec2>> {
        strand.nodes.iter().map(|&node| self.places[node]).collect()
    }

    /// The number of faults of a path along some points: strands it crosses, loops it turns inside
    /// out, strands inside its loops that are not part of them, and other loops that it lies in.
    fn faults(&self, path: usize, points: &[DVec2]) -> usize {
        let curve = Curve::smooth(points);
        let known = |at: usize| match at == path {
            true => Some(points.to_vec()),
            false => self.points(&self.side.strands[at]),
        };
        let all: Vec<_> = (0..self.side.strands.len()).map(known).collect();
        let others = all.iter().enumerate().filter(|(at, _)| *at != path);
        let others = others.filter_map(|(_, points)| points.as_ref());
        let mut faults = others.filter(|points| curve.crosses(&Curve::smooth(points))).count();
        for orbit in &self.side.loops {
            let along = orbit.darts.iter().map(|dart| {
                let mut points = all[dart.strand].clone()?;
                if !dart.forward {
                    points.reverse();
                }
                points.pop();
                Some(points)
            });
            let Some(outline) = along.collect::<Option<Vec<_>>>() else { continue };
            let outline = outline.concat();
            if orbit.darts.iter().all(|dart| dart.strand != path) {
                faults += usize::from(area(&outline) > 0.0 && is_inside(mean(points), &outline));
                continue;
            }
            faults += usize::from(area(&outline) < 0.0);
            for (at, points) in all.iter().enumerate() {
                let is_part = orbit.darts.iter().any(|dart| dart.strand == at);
                if let Some(points) = points.as_ref().filter(|_| !is_part) {
                    faults += usize::from(is_inside(mean(points), &outline));
                }
            }
        }
        faults
    }
}

/// Bends what bends in `after` only: parallel strands apart.
pub(super) fn bend_beside(figure: &Figure, places: &mut [Option<DVec2>]) {
    let side = &figure.after;
    let is_new = |node: &usize| {
        figure.nodes[*node] == Node::Bend
            && !figure.before.strands.iter().any(|strand| strand.nodes.contains(node))
    };
    let loops = side.loop_of();
    let mut taken: Vec<([usize; 2], f64)> = Vec::new();
    for (at, strand) in side.strands.iter().enumerate() {
        let bends = &strand.nodes[1..strand.nodes.len() - 1];
        let [from, to] = strand.ends();
        let (Some(a), Some(b)) = (places[from], places[to]) else { continue };
        let is_placed = strand.is_path && bends.iter().all(|&bend| places[bend].is_some());
        if from == to || bends.is_empty() || is_placed || !bends.iter().all(is_new) {
            continue;
        }
        // A strand with a loop on one side leaves it room; that between two edges is on both.
        let beside = [2 * at, 2 * at + 1].map(|dart| loops[dart]);
        let leaves = |of: usize| if side.loops[of].darts.len() > 2 { 1.0 } else { -1.0 };
        let way = if from < to { 1.0 } else { -1.0 };
        let sign = match beside {
            [Some(of), None] => leaves(of),
            [None, Some(of)] => -leaves(of),
            _ => way,
        };
        // Of parallel strands each has its own place.
        let ends = [from.min(to), from.max(to)];
        let steps = (1..).flat_map(|step| [f64::from(step), -f64::from(step)]);
        let mut steps = steps.map(|step| step * sign * way);
        let Some(step) = steps.find(|&step| !taken.contains(&(ends, step))) else { continue };
        taken.push((ends, step));
        let away = left(b - a) * (step * way * 0.22);
        for (place, &bend) in bends.iter().enumerate() {
            let t = (place + 1) as f64 / (bends.len() + 1) as f64;
            places[bend] = Some(a.lerp(b, t) + away);
        }
    }
}
