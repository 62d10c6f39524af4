//! Polygons with holes that are connected to their outlines by bridges.
//!
//! A face with a hole is often written as one polygon that goes to the hole along an edge, around
//! it, and back along the same edge. A second cut beside that bridge turns it into two polygons
//! that repeat no corner and cover the same area; where there is none, or the polygon is long, it
//! becomes triangles.

use std::collections::{HashMap, HashSet};

use glam::{DVec2, DVec3};

use crate::mesh::ears;
use crate::mesh::is_inside;

/// The vertex of a corner, and the number of the corner in the input.
pub(super) type Corner = (u32, u32);

/// Longer polygons are not searched for a cut, which may consider all pairs of corners.
const LONGEST: usize = 256;

/// The polygons into which a polygon with a hole is cut; `None` if it has no hole.
pub(super) fn cut(corners: &[Corner], positions: &[DVec3]) -> Option<Vec<Vec<Corner>>> {
    let halves = cut_in_two(corners, positions).map(Vec::from);
    halves.or_else(|| has_hole(corners, positions).then(|| triangles(corners, positions)))
}

/// True if a polygon returns to a vertex, and of the two parts there one lies in the other and has
/// the opposite direction.
fn has_hole(corners: &[Corner], positions: &[DVec3]) -> bool {
    let count = corners.len();
    let Some(&(first, _)) = corners.first() else { return false };
    let place = |at: usize| positions[corners[at % count].0 as usize];
    let origin = positions[first as usize];
    let (mut sums, mut sizes) = (vec![DVec3::ZERO], 0.0);
    sums.extend((0..count).scan(DVec3::ZERO, |sum, at| {
        let area = (place(at) - origin).cross(place(at + 1) - origin);
        sizes += area.length();
        *sum += area;
        Some(*sum)
    }));
    // What is smaller comes from rounding: a part that goes along edges and back.
    let least = 1e-12 * sizes;
    let mut budget = LONGEST * LONGEST + 4 * count;
    let mut is_hole = |from: usize, to: usize| {
        let part = sums[to] - sums[from];
        let rest = sums[count] - part;
        let (inner, outer, axis) = match part.dot(sums[count]) < 0.0 {
            true => (from..to, to..from + count, rest),
            false => (to..from + count, from..to, part),
        };
        let is_opposite = part.dot(rest) < 0.0 && part.length().min(rest.length()) > least;
        if !is_opposite || budget < outer.len() {
            return false;
        }
        budget -= outer.len();
        let on_outline: HashSet<_> = outer.clone().map(|at| corners[at % count].0).collect();
        let mut inside = inner.filter(|&at| !on_outline.contains(&corners[at % count].0));
        let outline: Vec<_> = outer.map(place).collect();
        inside.next().is_some_and(|at| surrounds(&outline, place(at), axis))
    };
    let mut visits: HashMap<u32, [usize; 2]> = HashMap::new();
    for (at, &(vertex, _)) in corners.iter().enumerate() {
        let [_, last] = visits.entry(vertex).or_insert([at; 2]);
        if *last < at && is_hole(*last, at) {
            return true;
        }
        *last = at;
    }
    // From the last visit on to the first: what is left where there are more than two.
    visits.into_values().any(|[first, last]| first < last && is_hole(first, last))
}

/// True if a polygon runs around a point, seen along an axis.
fn surrounds(outline: &[DVec3], point: DVec3, axis: DVec3) -> bool {
    let (right, up) = axis.normalize_or(DVec3::Z).any_orthonormal_pair();
    let flat = |at: &DVec3| DVec2::new((at - point).dot(right), (at - point).dot(up));
    is_inside(DVec2::ZERO, &outline.iter().map(flat).collect::<Vec<_>>())
}

/// The triangles of a polygon.
fn triangles(corners: &[Corner], positions: &[DVec3]) -> Vec<Vec<Corner>> {
    let (vertices, places) =
        corners.iter().map(|&(vertex, _)| (vertex, positions[vertex as usize])).unzip();
    let closed = [corners, &corners[..1]].concat();
    let normal = normal(&closed, positions).normalize_or_zero();
    let triangles = ears::triangles(vertices, places, normal).into_iter();
    triangles.map(|triangle| triangle.map(|at| corners[at as usize]).to_vec()).collect()
}

/// The two polygons into which a polygon with a hole is cut; `None` if there is no such cut.
fn cut_in_two(corners: &[Corner], positions: &[DVec3]) -> Option<[Vec<Corner>; 2]> {
    let count = corners.len();
    if count > LONGEST {
        return None;
    }
    let vertex = |at: usize| corners[at % count].0;
    for start in 0..count {
        for end in start + 2..start + count {
            let is_bridge = vertex(start) == vertex(end + 1) && vertex(start + 1) == vertex(end);
            if !is_bridge {
                continue;
            }
            // Outline and hole, each from its end of the bridge back to it.
            let walk = |from: usize, to: usize| (from..=to).map(|at| corners[at % count]).collect();
            let hole: Vec<Corner> = walk(start + 1, end);
            let outline: Vec<Corner> = walk(end + 1, start + count);
            if let Some(cut) = cut_beside(&outline, &hole, positions) {
                return Some(cut);
            }
        }
    }
    None
}

/// The two polygons, if the hole lies in the outline and has the opposite direction.
fn cut_beside(
    outline: &[Corner],
    hole: &[Corner],
    positions: &[DVec3],
) -> Option<[Vec<Corner>; 2]> {
    let at = |corner: Corner| positions[corner.0 as usize];
    let [outer, inner] = [outline, hole].map(|walk| normal(walk, positions));
    let axis = (outer + inner).try_normalize()?;
    if inner.dot(axis) >= 0.0 || outer.dot(axis) <= 0.0 {
        return None;
    }
    let sides = || outline.windows(2).chain(hole.windows(2));
    let is_free = |x: Corner, y: Corner| {
        sides().all(|side| {
            let shares = side.iter().any(|corner| corner.0 == x.0 || corner.0 == y.0);
            shares || !meet([at(x), at(y)], [at(side[0]), at(side[1])], axis)
        })
    };
    // The first and the last corner of each are the ends of the bridge.
    let (last_outer, last_inner) = (outline.len() - 1, hole.len() - 1);
    let pairs = (1..last_outer).flat_map(|a| (1..last_inner).map(move |b| (a, b)));
    let mut pairs: Vec<(f64, usize, usize)> =
        pairs.map(|(a, b)| (at(outline[a]).distance_squared(at(hole[b])), a, b)).collect();
    pairs.sort_unstable_by(|one, other| one.0.total_cmp(&other.0));
    let (_, a, b) = pairs.into_iter().find(|&(_, a, b)| {
        let (x, y) = (outline[a], hole[b]);
        // At a vertex that is passed twice, as the ends of the bridge, a cut may leave the polygon.
        let times = |vertex| sides().filter(|side| side[0].0 == vertex).count();
        times(x.0) == 1 && times(y.0) == 1 && is_free(x, y)
    })?;
    let first = [&outline[last_outer..], &hole[..=b], &outline[a..last_outer]].concat();
    let second = [&hole[last_inner..], &outline[..=a], &hole[b..last_inner]].concat();
    Some([first, second])
}

/// The normal of a closed walk whose last corner is its first, of twice the area in length (M. E.
/// Newell's method; F. Tampieri, *Newell's Method for Computing the Plane Equation of a Polygon*,
/// Graphics Gems III, 1992).
fn normal(walk: &[Corner], positions: &[DVec3]) -> DVec3 {
    let origin = positions[walk[0].0 as usize];
    let from_origin = |corner: Corner| positions[corner.0 as usize] - origin;
    walk.windows(2).map(|side| from_origin(side[0]).cross(from_origin(side[1]))).sum()
}

/// True if two segments meet or touch, seen along an axis.
fn meet([a, b]: [DVec3; 2], [c, d]: [DVec3; 2], axis: DVec3) -> bool {
    let side = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a).dot(axis);
    let apart = |one: f64, other: f64| one * other > 0.0;
    if apart(side(a, b, c), side(a, b, d)) || apart(side(c, d, a), side(c, d, b)) {
        return false;
    }
    // Collinear segments may be disjoint.
    let along = |point: DVec3| (point - a).dot(b - a);
    let [low, high] = [along(c).min(along(d)), along(c).max(along(d))];
    high >= 0.0 && low <= along(b)
}
