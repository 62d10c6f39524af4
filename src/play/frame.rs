//! The frame in which a mesh is shown.

use glam::DVec3;

use crate::mesh::Mesh;

/// The farthest that a mesh may reach in its frame, and the least size that it may have there:
/// within these, 32 bits are enough for each coordinate.
const FARTHEST: f64 = 16.0;
const LEAST: f64 = 1.0 / 16.0;

/// A point and a length, as origin and unit: graphics cards take numbers of 32 bits, which can be
/// neither very large nor exact far from zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub middle: DVec3,
    pub size: f64,
}

impl Default for Frame {
    fn default() -> Self {
        Self { middle: DVec3::ZERO, size: 1.0 }
    }
}

impl Frame {
    /// The same frame if a mesh can be shown in it, else one around the mesh. So a mesh that changes
    /// is seen to grow and to move.
    pub fn fitting(self, mesh: &Mesh) -> Self {
        let places = mesh.vertices().map(|vertex| mesh.position(vertex));
        let finite = places.filter(|at| at.is_finite());
        let ends =
            finite.map(|at| (at, at)).reduce(|(low, high), (at, _)| (low.min(at), high.max(at)));
        let Some((low, high)) = ends else { return self };
        // Halves: the whole may be too large for a number.
        let half = (high / 2.0 - low / 2.0).max_element();
        let farthest = [low, high].map(|at| self.place(at).abs().max_element());
        let is_small = half > 0.0 && half / self.size < LEAST;
        if farthest.iter().all(|&far| far <= FARTHEST) && !is_small {
            return self;
        }
        Self { middle: low / 2.0 + high / 2.0, size: if half > 0.0 { half } else { 1.0 } }
    }

    /// A point in this frame; the origin if it is at no finite place.
    pub fn place(&self, at: DVec3) -> DVec3 {
        if at.is_finite() { (at / 2.0 - self.middle / 2.0) / self.size * 2.0 } else { DVec3::ZERO }
    }
}
