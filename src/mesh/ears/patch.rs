//! Patches: triangulations of holes that bend little.
//!
//! P. Liepa, "Filling holes in meshes", 2003, section 3: dynamic programming builds a triangulation
//! of a polygon from those of runs of its corners, short ones first. Of each run it keeps the one
//! whose largest angle between neighbouring triangles, those around the hole included, is the
//! least; of these, the one with the least area. Remaining ties, as in a flat hole, go to the one
//! whose worst triangle has the largest smallest angle. Since only one triangulation of each run is
//! kept, a triangle beyond its chord may bend more than with another one. The time is cubic in the
//! number of sides: large holes get the best-shaped [ears](super) instead.

use glam::DVec3;

use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{FaceId, HalfedgeId};

/// The largest number of sides of a patch.
const MOST_SIDES: usize = 50;

impl Mesh {
    /// The corners of a face in an order in which they can be cut off until three are left, such
    /// that the triangles bend little, with each other and with the faces around; the order of
    /// [`Mesh::ears`] for a face of more than 50 sides. A corner is given as the halfedge that
    /// starts there.
    pub fn patch(&self, f: FaceId) -> Vec<HalfedgeId> {
        let sides: Vec<_> = self.face_halfedges(f).take(MOST_SIDES + 1).collect();
        match sides.len() {
            0..=3 => Vec::new(),
            4..=MOST_SIDES => Ways::new(self, &sides).order(),
            _ => self.ears(f),
        }
    }
}

/// The faults of a set of triangles, the most important first. Angles and areas that differ by less
/// than rounding are equal.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Fault {
    /// The number of their sides that join vertices that are already adjacent.
    joined: u32,
    /// Grows with the largest angle between the normals of two neighbours.
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
struct Ways<'m> {
    mesh: &'m Mesh,
    sides: &'m [HalfedgeId],
    places: Vec<DVec3>,
    /// The pairwise distances of the corners.
    distances: Vec<f64>,
    /// An area that is zero up to rounding.
    grain: f64,
    /// The faults by first and last corner; none for two adjacent corners.
    faults: Vec<Fault>,
    /// The third corner of the triangle at the chord.
    thirds: Vec<usize>,
    /// The normal of that triangle; for two adjacent corners, that of the face across, if there is
    /// one.
    normals: Vec<Option<DVec3>>,
}

impl<'m> Ways<'m> {
    fn new(mesh: &'m Mesh, sides: &'m [HalfedgeId]) -> Self {
        let count = sides.len();
        let place = |&h: &HalfedgeId| mesh.get_vertex(h).and_then(|v| mesh.get_position(v));
        let places: Vec<_> = sides.iter().map(|h| place(h).unwrap_or(DVec3::ZERO)).collect();
        let around: f64 = (0..count).map(|at| places[at].distance(places[(at + 1) % count])).sum();
        let mut ways = Self {
            mesh,
            sides,
            places,
            distances: vec![0.0; count * count],
            grain: around * around * 1e-12,
            faults: vec![Fault::NONE; count * count],
            thirds: vec![0; count * count],
            normals: vec![None; count * count],
        };
        for first in 0..count {
            for last in 0..count {
                ways.distances[first * count + last] =
                    ways.places[first].distance(ways.places[last]);
            }
        }
        for first in 0..count - 1 {
            ways.normals[first * count + first + 1] = ways.across(first);
        }
        for length in 2..count {
            for first in 0..count - length {
                ways.choose(first, first + length);
            }
        }
        ways
    }

    /// The normal of the face across a side, unless that is a hole.
    fn across(&self, side: usize) -> Option<DVec3> {
        let twin = self.mesh.get_twin(self.sides[side])?;
        let face = self.mesh.get_face(twin)?;
        (!self.mesh.get_is_hole(face)?).then(|| self.mesh.normal(face))
    }

    fn choose(&mut self, first: usize, last: usize) {
        let count = self.sides.len();
        let is_whole = last - first == count - 1;
        let joined = match [first, last].map(|at| self.mesh.get_vertex(self.sides[at])) {
            [Some(v), Some(w)] if !is_whole => u32::from(self.mesh.adjacent(v, w)),
            _ => 0,
        };
        let outside = is_whole.then(|| self.across(last)).flatten();
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
                area: rounded(length / 2.0 / self.grain),
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

    /// The third corner of each triangle, after those of the triangles across its sides. The
    /// triangle at the last side is left over.
    fn order(&self) -> Vec<HalfedgeId> {
        let count = self.sides.len();
        let mut order = Vec::with_capacity(count - 2);
        let mut open = vec![[0, count - 1]];
        // In the reverse order: each triangle before those across its sides.
        while let Some([first, last]) = open.pop() {
            if last - first > 1 {
                let third = self.thirds[first * count + last];
                order.push(self.sides[third]);
                open.extend([[first, third], [third, last]]);
            }
        }
        order.reverse();
        order.pop();
        order
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
