//! Patches: triangulations of holes that bend little.
//!
//! P. Liepa, "Filling holes in meshes", 2003, section 3: dynamic programming builds a triangulation
//! of a polygon from those of runs of its corners, short ones first. Of each run it keeps the one
//! whose largest angle between neighboring triangles, those around the hole included, is the
//! least; of these, the one with the least area. Remaining ties, as in a flat hole, go to the one
//! whose worst triangle has the largest smallest angle. Since only one triangulation of each run is
//! kept, a triangle beyond its chord may bend more than with another one. The time is cubic in the
//! number of sides, so of a large hole a polygon of some of its corners is filled first, and then
//! each triangle of that anew, with all of its corners; if the rim is too uneven for that, the hole
//! gets the best-shaped [ears](super).

use std::collections::HashMap;

use glam::DVec3;

use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{FaceId, HalfedgeId};

/// The largest number of sides of a hole that is filled as a whole, in about 20 ms.
const MOST_SIDES: usize = 128;

/// The same of a triangle with the corners between its own.
const MOST_BESIDE: usize = 16;

impl Mesh {
    /// The corners of a face in an order in which they can be cut off until three are left, such
    /// that the triangles bend little, with each other and with the faces around. A corner is given
    /// as the halfedge that starts there. A face of more than 128 sides is filled in parts, or as by
    /// [`Mesh::ears`] if that bends less.
    pub fn patch(&self, f: FaceId) -> Vec<HalfedgeId> {
        let sides: Vec<_> = self.face_halfedges(f).collect();
        if sides.len() < 4 {
            return Vec::new();
        }
        let mut normals = HashMap::new();
        let beyond: Vec<_> = sides
            .iter()
            .map(|&side| {
                let face = self.face_across(side)?;
                Some(*normals.entry(face).or_insert_with(|| self.normal(face)))
            })
            .collect();
        let mut order = self.filling(&sides, &beyond, MOST_SIDES);
        // The last triangle is left over.
        order.pop();
        if sides.len() <= MOST_SIDES {
            return order;
        }
        let all = [order, self.ears(f)];
        all.into_iter()
            .min_by_key(|order| self.bends(&sides, beyond.clone(), order))
            .unwrap_or_default()
    }

    /// The corners of a polygon in an order in which all of its triangles can be cut off. `beyond`
    /// are the normals beyond its sides.
    ///
    /// Of more than `most` corners some are chosen at equal distances; then each triangle of these is
    /// filled anew, with the corners that lie between its own.
    fn filling(
        &self,
        corners: &[HalfedgeId],
        beyond: &[Option<DVec3>],
        most: usize,
    ) -> Vec<HalfedgeId> {
        let Some(end) = corners.len().checked_sub(1).filter(|&end| end > 1) else {
            return Vec::new();
        };
        let step = corners.len().div_ceil(most);
        let chosen: Vec<_> = (0..end).step_by(step).chain([end]).collect();
        let sides = chosen.windows(2).map(|ends| {
            let normals = beyond[ends[0]..ends[1]].iter().copied().flatten();
            normals.reduce(|sum, normal| sum + normal).and_then(DVec3::try_normalize)
        });
        let sides: Vec<_> = sides.chain([beyond[end]]).collect();
        let some: Vec<_> = chosen.iter().map(|&at| corners[at]).collect();
        let triangulations = Triangulations::new(self, &some, &sides);
        let mut order = Vec::with_capacity(corners.len() - 2);
        for ([first, third, last], above) in triangulations.triangles() {
            if step == 1 {
                order.push(corners[third]);
                continue;
            }
            let (mut inner, mut normals) = (Vec::new(), Vec::new());
            for [from, to] in [[first, third], [third, last]] {
                if to - from == 1 {
                    inner.extend(&corners[chosen[from]..chosen[to]]);
                    normals.extend(&beyond[chosen[from]..chosen[to]]);
                } else {
                    inner.push(some[from]);
                    normals.push(triangulations.normal(from, to));
                }
            }
            inner.push(some[last]);
            normals.push(above);
            order.extend(self.filling(&inner, &normals, MOST_BESIDE));
        }
        order
    }

    /// How much a filling bends: the number of pairs of neighbors with more than a right angle
    /// between their normals, and the sum over all pairs.
    fn bends(
        &self,
        sides: &[HalfedgeId],
        mut beyond: Vec<Option<DVec3>>,
        order: &[HalfedgeId],
    ) -> (usize, i64) {
        let count = sides.len();
        let places: Vec<_> = sides.iter().map(|&h| self.place(h)).collect();
        let numbers: HashMap<_, _> = sides.iter().copied().zip(0..).collect();
        let mut next: Vec<_> = (1..count).chain([0]).collect();
        let mut prev: Vec<_> = [count - 1].into_iter().chain(0..count - 1).collect();
        let (mut folds, mut total, mut left) = (0, 0, 0);
        let corners = order.iter().filter_map(|corner| numbers.get(corner).copied());
        for corner in corners.map(Some).chain([None]) {
            // At the end a triangle is left.
            let at = corner.unwrap_or(left);
            let (before, after) = (prev[at], next[at]);
            let [a, b, c] = [before, at, after].map(|at| places[at]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            let third = if corner.is_none() { beyond[after] } else { None };
            for other in [beyond[before], beyond[at], third].into_iter().flatten() {
                let bend = bend(normal, other);
                folds += usize::from(bend > 1_000_000);
                total += bend;
            }
            beyond[before] = Some(normal);
            (next[before], prev[after], left) = (after, before, before);
        }
        (folds, total)
    }

    /// The position of the origin of a halfedge.
    fn place(&self, h: HalfedgeId) -> DVec3 {
        self.get_vertex(h).and_then(|v| self.get_position(v)).unwrap_or(DVec3::ZERO)
    }

    /// The face across a side, unless that is a hole.
    fn face_across(&self, side: HalfedgeId) -> Option<FaceId> {
        let face = self.get_face(self.get_twin(side)?)?;
        (!self.get_is_hole(face)?).then_some(face)
    }
}

/// The faults of a set of triangles, the most important first. Angles and areas that differ by less
/// than rounding are equal.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Fault {
    /// The number of their sides that join vertices that are already adjacent.
    joined: u32,
    /// Grows with the largest angle between the normals of two neighbors.
    bend: i64,
    area: i64,
    /// The least of the sines of their smallest angles, negated.
    shape: f64,
}

impl Fault {
    const NONE: Self = Self { joined: 0, bend: i64::MIN, area: 0, shape: -1.0 };

    fn and(self, other: Self) -> Self {
        Self {
            joined: self.joined + other.joined,
            bend: self.bend.max(other.bend),
            area: self.area.saturating_add(other.area),
            shape: self.shape.max(other.shape),
        }
    }
}

/// The best triangulation of each run of corners, from a first to a last one that a chord joins.
struct Triangulations<'m> {
    mesh: &'m Mesh,
    corners: &'m [HalfedgeId],
    places: Vec<DVec3>,
    /// The pairwise distances of the corners.
    distances: Vec<f64>,
    /// An area that is zero up to rounding.
    area_tolerance: f64,
    /// The faults by first and last corner; none for two adjacent corners.
    faults: Vec<Fault>,
    /// The third corner of the triangle at the chord.
    thirds: Vec<usize>,
    /// The normal of that triangle; for two adjacent corners, that beyond the side, if there is one.
    normals: Vec<Option<DVec3>>,
    /// The normal beyond the last side.
    closing: Option<DVec3>,
}

impl<'m> Triangulations<'m> {
    /// `beyond` are the normals beyond the sides.
    fn new(mesh: &'m Mesh, corners: &'m [HalfedgeId], beyond: &[Option<DVec3>]) -> Self {
        let count = corners.len();
        let places: Vec<_> = corners.iter().map(|&h| mesh.place(h)).collect();
        let around: f64 = (0..count).map(|at| places[at].distance(places[(at + 1) % count])).sum();
        let mut triangulations = Self {
            mesh,
            corners,
            places,
            distances: vec![0.0; count * count],
            area_tolerance: around * around * 1e-12,
            faults: vec![Fault::NONE; count * count],
            thirds: vec![0; count * count],
            normals: vec![None; count * count],
            closing: beyond[count - 1],
        };
        for first in 0..count {
            for last in 0..count {
                triangulations.distances[first * count + last] =
                    triangulations.places[first].distance(triangulations.places[last]);
            }
        }
        for (first, &normal) in beyond.iter().enumerate().take(count - 1) {
            triangulations.normals[first * count + first + 1] = normal;
        }
        for length in 2..count {
            for first in 0..count - length {
                triangulations.choose(first, first + length);
            }
        }
        triangulations
    }

    fn choose(&mut self, first: usize, last: usize) {
        let count = self.corners.len();
        let is_whole = last - first == count - 1;
        let joined = match [first, last].map(|at| self.mesh.get_vertex(self.corners[at])) {
            [Some(v), Some(w)] if !is_whole => u32::from(self.mesh.adjacent(v, w)),
            _ => 0,
        };
        let outside = self.closing.filter(|_| is_whole);
        let mut best: Option<(Fault, usize, DVec3)> = None;
        let [a, c] = [first, last].map(|at| self.places[at]);
        let chord = self.distances[first * count + last];
        for third in first + 1..last {
            let beside = [first * count + third, third * count + last];
            let beyond = self.faults[beside[0]].and(self.faults[beside[1]]);
            // Another triangle makes nothing better.
            let is_worse = |(least, ..): &(Fault, usize, DVec3)| {
                (beyond.joined + joined, beyond.bend) > (least.joined, least.bend)
            };
            if best.as_ref().is_some_and(is_worse) {
                continue;
            }
            let twice = (self.places[third] - a).cross(c - a);
            let length = twice.length();
            let normal = if length > 0.0 { twice / length } else { DVec3::ZERO };
            let [left, right] = beside.map(|at| self.distances[at]);
            let mut fault = Fault {
                joined,
                bend: i64::MIN,
                area: rounded(length / 2.0 / self.area_tolerance),
                shape: -smallest_sine(length, [chord, left, right]),
            };
            for other in beside.map(|at| self.normals[at]).into_iter().chain([outside]).flatten() {
                fault.bend = fault.bend.max(bend(normal, other));
            }
            let fault = fault.and(beyond);
            if best.as_ref().is_none_or(|(least, ..)| fault < *least) {
                best = Some((fault, third, normal));
            }
        }
        if let Some((fault, third, normal)) = best {
            let at = first * count + last;
            self.faults[at] = fault;
            self.thirds[at] = third;
            self.normals[at] = Some(normal);
        }
    }

    /// The normal beyond a chord or side.
    fn normal(&self, first: usize, last: usize) -> Option<DVec3> {
        self.normals[first * self.corners.len() + last]
    }

    /// The first, third and last corner of each triangle, after those across its two other sides,
    /// with the normal beyond the side from the first to the last.
    fn triangles(&self) -> Vec<([usize; 3], Option<DVec3>)> {
        let count = self.corners.len();
        let mut triangles = Vec::with_capacity(count - 2);
        let mut open = vec![([0, count - 1], self.closing)];
        // In the reverse order: each triangle before those across its sides.
        while let Some(([first, last], above)) = open.pop() {
            if last - first > 1 {
                let third = self.thirds[first * count + last];
                triangles.push(([first, third, last], above));
                let normal = self.normal(first, last);
                open.extend([([first, third], normal), ([third, last], normal)]);
            }
        }
        triangles.reverse();
        triangles
    }
}

/// Grows with the angle between two normals, from 0 to two million.
fn bend(one: DVec3, other: DVec3) -> i64 {
    match one == DVec3::ZERO || other == DVec3::ZERO || other.is_nan() {
        // A degenerate triangle bends as much as possible.
        true => 2_000_000,
        false => rounded(1e6 - 1e6 * one.dot(other)),
    }
}

/// The sine of the smallest angle of a triangle with the given double area and sides: it lies
/// across the shortest side, between the other two.
pub(super) fn smallest_sine(double_area: f64, [a, b, c]: [f64; 3]) -> f64 {
    let sides = (a * b).max((b * c).max(c * a));
    if sides > 0.0 { double_area / sides } else { 0.0 }
}

/// Rounds a nonnegative number.
#[inline]
fn rounded(number: f64) -> i64 {
    (number + 0.5) as i64
}
