//! The kernel around an edge: where one vertex could replace both ends.
//!
//! Contracting an edge turns the faces at its ends into the star of one vertex; their border, the
//! *link polygon*, stays. The *kernel* of a polygon is the set of points from which all of it is
//! visible, the intersection of the half-planes to the left of its sides; a polygon that has one is
//! *star-shaped*. A vertex in the kernel flips no triangle of its star.
//!
//! It is computed by clipping a rectangle with one half-plane after the other, as I. E. Sutherland
//! and G. W. Hodgman, *Reentrant polygon clipping*, 1974, clip a polygon. That takes n² steps for n
//! sides; D. T. Lee and F. P. Preparata, *An optimal algorithm for finding the kernel of a
//! polygon*, 1979, take n, which would not pay for the few sides of a link.

use glam::{DVec2, DVec3};

use super::connectivity::Mesh;
use super::id::{EdgeId, HalfedgeId, VertexId};

/// A kernel with less than this share of the area of the bounding rectangle counts as none: being
/// so thin, it is made of rounding errors.
const THINNEST: f64 = 1e-12;

impl Mesh {
    /// The area centroid of the kernel of the link polygon of an edge; `None` if the polygon has no
    /// kernel, or if an end lies on the boundary, so that the link is not a polygon.
    ///
    /// ```text
    ///      u---t                u---t
    ///     / \ / \              / \ / \
    ///    w---a---s     ->     w       s
    ///     \ / \ / \            \       \
    ///      x---b---r            x   .   r
    ///       \ / \ /              \     /
    ///        y---z                y---z
    /// ```
    ///
    /// A link that is not flat is projected along its normal (Newell's method), and the centroid
    /// lies in the plane through the mean of its corners.
    pub fn kernel_centroid(&self, e: EdgeId) -> Option<DVec3> {
        let corners = self.link_polygon(e)?;
        let plane = Plane::of(&corners)?;
        let flat: Vec<DVec2> = corners.iter().map(|&corner| plane.flat(corner)).collect();
        centroid_of_kernel(&flat).map(|centroid| plane.raised(centroid))
    }

    /// The border of the faces at the ends of an edge, counterclockwise.
    fn link_polygon(&self, e: EdgeId) -> Option<Vec<DVec3>> {
        let h = self.get_edge_halfedge(e)?;
        let twin = self.get_twin(h)?;
        let (a, b) = (self.get_vertex(h)?, self.get_vertex(twin)?);
        if self.is_boundary_vertex(a) || self.is_boundary_vertex(b) {
            return None;
        }
        let mut corners = Vec::new();
        for spoke in [h, twin] {
            for other in self.spokes_from(spoke).skip(1) {
                corners.extend(self.far_side(other, [a, b]));
            }
        }
        Some(corners)
    }

    /// The origins of the halfedges after a spoke in its loop, up to the first that ends in `ends`.
    fn far_side(&self, spoke: HalfedgeId, ends: [VertexId; 2]) -> impl Iterator<Item = DVec3> {
        let sides = self.loop_from(spoke).skip(1).take_while(move |&side| {
            let target = self.get_target(side);
            target.is_some_and(|target| !ends.contains(&target))
        });
        sides.filter_map(|side| self.get_position(self.get_vertex(side)?))
    }
}

/// A plane with its own coordinates.
struct Plane {
    origin: DVec3,
    right: DVec3,
    up: DVec3,
}

impl Plane {
    /// The plane of a polygon, which is counterclockwise in it; `None` if it has no normal.
    fn of(corners: &[DVec3]) -> Option<Self> {
        let first = *corners.first()?;
        let ahead = corners.iter().cycle().skip(1);
        let twice_area: DVec3 =
            corners.iter().zip(ahead).map(|(&p, &q)| (p - first).cross(q - first)).sum();
        let normal = twice_area.try_normalize()?;
        // For a polygon in the xy plane these are the x and y axes, without rounding.
        let right = match normal.x.abs() < 0.9 {
            true => DVec3::X.reject_from_normalized(normal).try_normalize()?,
            false => DVec3::Y.reject_from_normalized(normal).try_normalize()?,
        };
        let origin = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let up = normal.cross(right);
        Some(Self { origin, right, up })
    }

    fn flat(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.right), from.dot(self.up))
    }

    fn raised(&self, point: DVec2) -> DVec3 {
        self.origin + self.right * point.x + self.up * point.y
    }
}

/// The centroid of the kernel of a counterclockwise polygon.
fn centroid_of_kernel(polygon: &[DVec2]) -> Option<DVec2> {
    let low = polygon.iter().copied().reduce(DVec2::min)?;
    let high = polygon.iter().copied().reduce(DVec2::max)?;
    let size = high - low;
    let mut kernel = vec![low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    for (at, &from) in polygon.iter().enumerate() {
        let to = polygon[(at + 1) % polygon.len()];
        kernel = left_of(from, to, &kernel);
    }
    let first = *kernel.first()?;
    let (mut twice_area, mut moment) = (0.0, DVec2::ZERO);
    for pair in kernel.windows(2) {
        let (p, q) = (pair[0] - first, pair[1] - first);
        let weight = p.perp_dot(q);
        twice_area += weight;
        moment += (p + q) * weight;
    }
    let wide_enough = twice_area > 2.0 * THINNEST * size.x * size.y;
    let centroid = first + moment / (3.0 * twice_area);
    (wide_enough && centroid.is_finite()).then_some(centroid)
}

/// The part of a convex polygon to the left of a line.
fn left_of(from: DVec2, to: DVec2, convex: &[DVec2]) -> Vec<DVec2> {
    let side = |point: DVec2| (to - from).perp_dot(point - from);
    let mut left = Vec::with_capacity(convex.len() + 1);
    for (at, &p) in convex.iter().enumerate() {
        let q = convex[(at + 1) % convex.len()];
        let (of_p, of_q) = (side(p), side(q));
        if of_p >= 0.0 {
            left.push(p);
        }
        if of_p * of_q < 0.0 {
            left.push(p.lerp(q, of_p / (of_p - of_q)));
        }
    }
    left
}
