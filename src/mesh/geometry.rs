//! Lengths, areas, normals and centers.
//!
//! All are defined for any mesh: what has no length, area or direction gives zero, never a NaN from
//! a division by zero. Only what is not finite gives NaN, or products that are not: coordinates
//! should be between 1e-150 and 1e150. Faces need be neither flat nor convex; area and normal come
//! from the vector area (Newell's method), which is half the sum of the cross products along the
//! loop.

use glam::{DVec2, DVec3};

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};

/// True if a point of the plane lies inside a polygon.
pub(crate) fn is_inside(point: DVec2, polygon: &[DVec2]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(a, b)| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossed.count() % 2 == 1
}

impl Mesh {
    /// The vector from the origin of `h` to its target.
    pub fn vector(&self, h: HalfedgeId) -> DVec3 {
        let ends = || Some((self.get_vertex(h)?, self.get_target(h)?));
        let positions =
            ends().and_then(|(v, w)| Some((self.get_position(v)?, self.get_position(w)?)));
        positions.map_or(DVec3::ZERO, |(from, to)| to - from)
    }

    /// The length of an edge, in the unit of the positions; 0 for an erased one.
    pub fn length(&self, e: EdgeId) -> f64 {
        self.get_edge_halfedge(e).map_or(0.0, |h| self.vector(h).length())
    }

    /// The vector normal to the face whose length is its area: half the sum of the cross products of
    /// consecutive corners (M. Newell, R. Newell and T. Sancha, "A solution to the hidden surface
    /// problem", 1972).
    #[inline]
    pub fn vector_area(&self, f: FaceId) -> DVec3 {
        let triangle = self.get_face_halfedge(f).and_then(|first| self.triangle_area(first));
        triangle.unwrap_or_else(|| self.vector_area_of_any(f))
    }

    /// The [`vector_area`](Self::vector_area) of the face of a halfedge, if it has three sides,
    /// computed from the origin of the halfedge.
    #[inline]
    fn triangle_area(&self, first: HalfedgeId) -> Option<DVec3> {
        let a = self.get_halfedge(first)?;
        let b = self.get_halfedge(a.next)?;
        let c = self.get_halfedge(b.next)?;
        if c.next != first || a.next == first || b.next == first {
            return None;
        }
        let position = |v: VertexId| self.positions.get(v.index()).copied();
        let (a, b, c) = (position(a.vertex)?, position(b.vertex)?, position(c.vertex)?);
        // The sum for other polygons begins with zero too, so both give the same bits.
        Some((DVec3::ZERO + (b - a).cross(c - a)) / 2.0)
    }

    fn vector_area_of_any(&self, f: FaceId) -> DVec3 {
        let mut corners = self.face_vertices(f).filter_map(|v| self.get_position(v));
        // Relative to the first corner, so that a small face far away keeps its digits.
        let Some(first) = corners.next() else { return DVec3::ZERO };
        let mut sum = DVec3::ZERO;
        let mut last = DVec3::ZERO;
        for corner in corners {
            let at = corner - first;
            sum += last.cross(at);
            last = at;
        }
        sum / 2.0
    }

    /// The area of a face, in squared units of the positions; 0 for an erased one. That of a face
    /// that is not flat is the area of its projection along its normal.
    pub fn area(&self, f: FaceId) -> f64 {
        self.vector_area(f).length()
    }

    /// The unit normal, on the side from which the loop runs counterclockwise.
    pub fn normal(&self, f: FaceId) -> DVec3 {
        direction(self.vector_area(f))
    }

    /// The unit normal at a vertex: the faces around it, each weighted by its area.
    /// Holes do not count.
    pub fn vertex_normal(&self, v: VertexId) -> DVec3 {
        let is_closed = self.hole_count() == 0;
        let real = |h: &HalfedgeId| {
            is_closed || self.get_face(*h).and_then(|f| self.get_is_hole(f)) == Some(false)
        };
        let any = |h| self.get_face(h).map_or(DVec3::ZERO, |f| self.vector_area_of_any(f));
        let area = |h| self.triangle_area(h).unwrap_or_else(|| any(h));
        direction(self.spokes(v).filter(real).map(area).sum())
    }

    /// The mean of the corners.
    pub fn centroid(&self, f: FaceId) -> DVec3 {
        let mut sum = DVec3::ZERO;
        let mut corners = 0.0;
        for at in self.face_vertices(f).filter_map(|v| self.get_position(v)) {
            sum += at;
            corners += 1.0;
        }
        if corners > 0.0 { sum / corners } else { DVec3::ZERO }
    }
}

/// The unit vector in the direction of `v`: zero if that is zero, NaN if it is not finite. The
/// vector is scaled first: the square of a small length is zero, that of a large one infinite.
#[inline]
pub fn direction(v: DVec3) -> DVec3 {
    let largest = v.abs().max_element();
    match v.is_finite() {
        true if largest > 0.0 => (v / largest).normalize_or_zero(),
        true => DVec3::ZERO,
        false => DVec3::NAN,
    }
}
