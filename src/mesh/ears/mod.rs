//! Ear clipping: the order in which the corners of a face can be cut off until a triangle is left.
//!
//! G. Meisters, "Polygons have ears", 1975: every simple planar polygon except a triangle has at
//! least two. Faces need not be planar here; each is projected along its normal. The best-shaped
//! ear is cut first. Qualities are kept current: when a corner is cut off, those of its two
//! neighbors change, and those of the ears that it was in; a [`tree`] finds the points in an ear.
//! A face of n sides thus takes about n log n steps.
//!
//! [`patch`] orders the corners such that the triangles bend little instead.

mod patch;
mod tree;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use glam::{DVec2, DVec3};
use robust::{Coord, orient2d};

use super::connectivity::Mesh;
use super::id::{FaceId, HalfedgeId, VertexId};
use patch::smallest_sine;
use tree::Tree;

impl Mesh {
    /// The corners of a face in an order in which each can be cut off as an ear of what is left,
    /// until three are left: the ear with the largest smallest angle first. A corner is given as
    /// the halfedge that starts there. Only where there is no ear, one is cut that contains other
    /// corners; an ear whose cut would join two vertices that are already adjacent comes last.
    pub fn ears(&self, f: FaceId) -> Vec<HalfedgeId> {
        let sides: Vec<_> = self.face_halfedges(f).collect();
        let vertices: Vec<_> =
            sides.iter().map(|&h| self.get_vertex(h).unwrap_or(VertexId::NONE)).collect();
        let place = |&v: &VertexId| self.get_position(v).unwrap_or(DVec3::ZERO);
        let places = vertices.iter().map(place).collect();
        let is_joined = |a, b| self.adjacent(a, b);
        let mut polygon = Polygon::new(vertices, places, self.normal(f), is_joined);
        let ears = std::iter::from_fn(|| polygon.cut_off());
        ears.filter_map(|[_, corner, _]| sides.get(corner as usize).copied()).collect()
    }
}

/// The triangles of a polygon, which may go to holes and back along bridges, as numbers of its
/// corners. A corner has the number of its vertex.
pub(super) fn triangles(vertices: Vec<u32>, places: Vec<DVec3>, normal: DVec3) -> Vec<[u32; 3]> {
    let count = vertices.len() as u32;
    let mut polygon = Polygon::new(vertices, places, normal, |_, _| false);
    let mut triangles: Vec<_> = std::iter::from_fn(|| polygon.cut_off()).collect();
    let last = (0..count).find(|&corner| polygon.left.has(corner));
    triangles.extend(last.map(|corner| polygon.around(corner)));
    triangles
}

/// The part of a face that is left. Corners have the numbers of the sides that start there.
struct Polygon<V, J> {
    /// True if an edge joins two vertices.
    is_joined: J,
    vertices: Vec<V>,
    places: Vec<DVec3>,
    /// The places projected along the normal.
    flat: Vec<DVec2>,
    before: Vec<u32>,
    behind: Vec<u32>,
    left: Tree,
    /// For each corner, the ears that it is known to lie in.
    inside_of: Vec<Vec<u32>>,
    /// For each corner, how often its quality has changed: older entries of the queue are stale.
    changes: Vec<u32>,
    queue: BinaryHeap<Ear>,
    /// The number of corners that are left.
    count: u32,
}

/// An ear in the queue.
#[derive(Clone, Copy, Debug)]
struct Ear {
    quality: f64,
    corner: u32,
    change: u32,
}

impl Ord for Ear {
    fn cmp(&self, other: &Self) -> Ordering {
        // Of equally good ears, the first corner.
        self.quality.total_cmp(&other.quality).then(other.corner.cmp(&self.corner))
    }
}

impl PartialOrd for Ear {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Ear {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Ear {}

impl<V: Copy + PartialEq, J: Fn(V, V) -> bool> Polygon<V, J> {
    fn new(vertices: Vec<V>, places: Vec<DVec3>, normal: DVec3, is_joined: J) -> Self {
        let count = vertices.len() as u32;
        let (right, up) = match normal == DVec3::Z || normal == DVec3::ZERO || normal.is_nan() {
            true => (DVec3::X, DVec3::Y),
            false => normal.any_orthonormal_pair(),
        };
        let flat: Vec<_> = places.iter().map(|at| DVec2::new(at.dot(right), at.dot(up))).collect();
        let mut polygon = Self {
            is_joined,
            left: Tree::new(&flat),
            inside_of: vec![Vec::new(); places.len()],
            changes: vec![0; places.len()],
            vertices,
            places,
            flat,
            before: (0..count).map(|at| (at + count - 1) % count).collect(),
            behind: (0..count).map(|at| (at + 1) % count).collect(),
            queue: BinaryHeap::new(),
            count,
        };
        (0..count).for_each(|corner| polygon.enter(corner));
        polygon
    }

    /// Cuts off the best ear, unless no more than a triangle is left; returns its corners.
    fn cut_off(&mut self) -> Option<[u32; 3]> {
        while self.count > 3 {
            let ear = self.queue.pop()?;
            if self.changes[ear.corner as usize] == ear.change && self.left.has(ear.corner) {
                let corners = self.around(ear.corner);
                self.take(ear.corner);
                return Some(corners);
            }
        }
        None
    }

    /// A corner between its neighbors.
    fn around(&self, corner: u32) -> [u32; 3] {
        [self.before[corner as usize], corner, self.behind[corner as usize]]
    }

    fn take(&mut self, corner: u32) {
        let at = corner as usize;
        let (before, behind) = (self.before[at], self.behind[at]);
        self.left.take(corner);
        self.count -= 1;
        self.behind[before as usize] = behind;
        self.before[behind as usize] = before;
        self.enter(before);
        self.enter(behind);
        for ear in std::mem::take(&mut self.inside_of[at]) {
            if self.left.has(ear) && ear != before && ear != behind {
                self.enter(ear);
            }
        }
    }

    /// Puts the ear at a corner into the queue, with its current quality.
    fn enter(&mut self, corner: u32) {
        let quality = self.quality(corner);
        let change = &mut self.changes[corner as usize];
        *change += 1;
        let change = *change;
        let quality = if quality.is_finite() { quality } else { f64::NEG_INFINITY };
        self.queue.push(Ear { quality, corner, change });
    }

    /// The sine of the smallest angle of the triangle; less than zero where the corner is reflex,
    /// or another corner lies in the triangle.
    fn quality(&mut self, corner: u32) -> f64 {
        let around = self.around(corner);
        let [a, b, c] = around.map(|at| self.vertices[at as usize]);
        let [p, q, r] = around.map(|at| self.places[at as usize]);
        let sides = [p.distance(r), p.distance(q), q.distance(r)];
        let sine = smallest_sine((q - p).cross(r - q).length(), sides);
        let joined = if (self.is_joined)(a, c) { -4.0 } else { 0.0 };
        let triangle = around.map(|at| self.flat[at as usize]);
        if turn(triangle) < 0.0 {
            return joined - 2.0 - sine;
        }
        let vertices = &self.vertices;
        let is_other = |at: u32| ![a, b, c].contains(&vertices[at as usize]);
        match self.left.find(triangle, &self.flat, is_other) {
            Some(other) => {
                self.inside_of[other as usize].push(corner);
                joined - 2.0 + sine
            }
            None => joined + sine,
        }
    }
}

/// Positive where the three places turn counterclockwise, zero where they are collinear. The sign
/// is exact.
fn turn(places: [DVec2; 3]) -> f64 {
    let [a, b, c] = places.map(|at| Coord { x: at.x, y: at.y });
    orient2d(a, b, c)
}
