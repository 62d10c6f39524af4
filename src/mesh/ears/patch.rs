//! Patches: the triangles over a hole that bend the least.
//!
//! P. Liepa, "Filling holes in meshes", 2003, section 3: of all ways to cut a polygon into
//! triangles, by dynamic programming the one whose largest angle between neighbouring triangles,
//! those around the hole among them, is the least; of these the one with the least area. What is
//! left to choose, as in a flat hole, goes to the one whose worst triangle has the largest
//! smallest angle. This takes time with the third power of the sides: large holes get the best
//! shaped [ears](super) instead.

use glam::DVec3;

use super::smallest_sine;
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{FaceId, HalfedgeId};

/// The most sides for which all ways are looked at.
const MOST_SIDES: usize = 50;

impl Mesh {
    /// The corners of a face in an order in which they can be cut off until three are left, such
    /// that the triangles bend as little as they can, with each other and with the faces around;
    /// the order of [`Mesh::ears`] for a face of more than 50 sides. A corner is told by the
    /// halfedge that starts there.
    pub fn patch(&self, f: FaceId) -> Vec<HalfedgeId> {
        let sides: Vec<_> = self.face_halfedges(f).take(MOST_SIDES + 1).collect();
        match sides.len() {
            0..=3 => Vec::new(),
            4..=MOST_SIDES => Ways::new(self, &sides).order(),
            _ => self.ears(f),
        }
    }
}

/// What is wrong with some triangles, the worst first. Angles and areas that differ by less than
/// rounding are equal.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Fault {
    /// How many of their sides join vertices that are joined already.
    joined: u32,
    /// Grows with the largest angle by which two of them bend.
    bend: i64,
    area: i64,
    /// Less than zero: the least sine of a smallest angle.
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

/// The best way for each run of corners, from a first to a last one that are joined by a chord.
struct Ways<'m> {
    mesh: &'m Mesh,
    sides: &'m [HalfedgeId],
    places: Vec<DVec3>,
    /// An area that is nothing, but for rounding.
    grain: f64,
    /// By first and last corner; of two neighbours nothing.
    faults: Vec<Fault>,
    /// The third corner of the triangle at the chord.
    thirds: Vec<usize>,
    /// The normal of that triangle; of two neighbours, that of the face across, if there is one.
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
            grain: around * around * 1e-12,
            faults: vec![Fault::NONE; count * count],
            thirds: vec![0; count * count],
            normals: vec![None; count * count],
        };
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

    /// The normal of the face on the other side of a side, if it is no hole.
    fn across(&self, side: usize) -> Option<DVec3> {
        let twin = self.mesh.get_twin(self.sides[side])?;
        let face = self.mesh.get_face(twin)?;
        (!self.mesh.get_is_hole(face)?).then(|| self.mesh.normal(face))
    }

    fn choose(&mut self, first: usize, last: usize) {
        let count = self.sides.len();
        let is_whole = last - first == count - 1;
        let ends = [first, last].map(|at| self.mesh.get_vertex(self.sides[at]));
        let joined = match ends {
            [Some(v), Some(w)] if !is_whole => u32::from(self.mesh.adjacent(v, w)),
            _ => 0,
        };
        let outside = is_whole.then(|| self.across(last)).flatten();
        let mut best: Option<(Fault, usize, DVec3)> = None;
        for third in first + 1..last {
            let [a, b, c] = [first, third, last].map(|at| self.places[at]);
            let twice = (b - a).cross(c - a);
            let normal = twice.normalize_or_zero();
            let beside = [first * count + third, third * count + last];
            let mut fault = Fault {
                joined,
                bend: i64::MIN,
                area: (twice.length() / 2.0 / self.grain).round() as i64,
                shape: -smallest_sine([a, b, c]),
            };
            for other in beside.map(|at| self.normals[at]).into_iter().chain([outside]).flatten() {
                fault.bend = fault.bend.max(bend(normal, other));
            }
            let fault = beside.iter().fold(fault, |fault, &at| fault.and(self.faults[at]));
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

    /// The third corner of each triangle, after those of the triangles beyond its sides. The
    /// triangle at the last side is left.
    fn order(&self) -> Vec<HalfedgeId> {
        let count = self.sides.len();
        let mut order = Vec::with_capacity(count - 2);
        let mut open = vec![[0, count - 1]];
        // The other way around each triangle comes before those beyond its sides.
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

/// Grows with the angle between two normals: 0 for a right one.
fn bend(one: DVec3, other: DVec3) -> i64 {
    match one == DVec3::ZERO || other == DVec3::ZERO {
        // What has no direction bends as much as can be.
        true => 1_000_000,
        false => (-1e6 * one.dot(other)).round() as i64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Polygons;

    /// Boxes whose corners are moved a little: the lid is cut along the diagonal that bends less.
    #[test]
    fn a_folded_lid_is_cut_where_it_bends_less() {
        let polygons: Polygons = [
            vec![0, 1, 2, 3],
            vec![7, 6, 5, 4],
            vec![4, 5, 1, 0],
            vec![5, 6, 2, 1],
            vec![6, 7, 3, 2],
            vec![7, 4, 0, 3],
        ]
        .into_iter()
        .collect();
        let mut chosen = [0, 0];
        for turn in 0..40_u32 {
            let moved = |at: u32| f64::from((turn * 31 + at * at * 17 + at * 5) % 23) / 40.0;
            let corner = |at: u32| {
                let (x, y) = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)][at as usize % 4];
                let z = if at < 4 { 2.0 } else { 0.0 };
                DVec3::new(x + moved(at), y - moved(at + 1), z + 2.0 * moved(at + 2))
            };
            let places: Vec<_> = (0..8).map(corner).collect();
            let mesh = Mesh::from_polygons(&places, &polygons).unwrap();
            let normal = |corners: [usize; 3]| {
                let [a, b, c] = corners.map(|at| places[at]);
                (b - a).cross(c - a).normalize()
            };
            // The normals of the two triangles, and which walls each has beside it: wall k
            // stands at the side from k to k + 1.
            let worst = |first: usize| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|at| (first + at) % 4);
                let (one, two) = (normal([a, b, c]), normal([a, c, d]));
                let wall = |side: usize| mesh.normal(FaceId(2 + side as u32));
                let walls = [(one, wall(a)), (one, wall(b)), (two, wall(c)), (two, wall(d))];
                let least = walls.into_iter().chain([(one, two)]);
                least.map(|(n, m)| n.dot(m)).fold(f64::INFINITY, f64::min)
            };
            let cut = usize::from(worst(1) > worst(0));
            // Cut along the diagonal from `cut`, one of the other two corners goes.
            let order = mesh.patch(FaceId(0));
            assert_eq!(order.len(), 1);
            assert_eq!(mesh.vertex(order[0]).index() % 2, 1 - cut, "lid {turn}");
            chosen[cut] += 1;
        }
        assert!(chosen[0] > 3 && chosen[1] > 3, "{chosen:?}");
    }

    #[test]
    fn a_flat_face_is_cut_into_good_shapes() {
        let place = |at: u32| {
            let angle = f64::from(at) * std::f64::consts::TAU / 6.0;
            DVec3::new(angle.cos(), angle.sin(), 0.0)
        };
        let places: Vec<_> = (0..6).map(place).collect();
        let polygons: Polygons = std::iter::once((0..6).collect::<Vec<u32>>()).collect();
        let mesh = Mesh::from_polygons(&places, &polygons).unwrap();
        let order = mesh.patch(FaceId(0));
        assert_eq!(order.len(), 3);
        let mut corners: Vec<_> = order.iter().map(|&h| mesh.vertex(h)).collect();
        corners.sort_unstable();
        corners.dedup();
        assert_eq!(corners.len(), 3, "each corner goes once");
    }
}
