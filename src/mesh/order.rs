//! An order of vertices and polygons that keeps neighbors close together in memory, so that walks
//! hit the processor's caches.
//!
//! Vertices follow a Hilbert curve through the cube around them, computed as by J. Skilling,
//! "Programming the Hilbert curve", 2004; polygons follow the first of their vertices.

use glam::DVec3;

use super::parallel;
use super::polygons::Polygons;

/// The bits of a coordinate on the curve.
const BITS: u32 = 12;

/// The fewest elements that are worth a thread.
const LEAST: usize = 4096;

/// The old numbers of vertices, polygons and corners, in the new order.
pub(super) struct Order {
    pub(super) vertices: Vec<u32>,
    pub(super) faces: Vec<u32>,
    pub(super) corners: Vec<u32>,
    /// The new numbers of vertices, by the old ones.
    numbers: Vec<u32>,
}

impl Order {
    /// An order of a list of polygons; the vertices after the first `kept` keep their places.
    pub(super) fn of(positions: &[DVec3], polygons: &Polygons, kept: usize) -> Self {
        let finite = || positions.iter().copied().filter(|p| p.is_finite());
        let least = finite().fold(DVec3::INFINITY, DVec3::min);
        let most = finite().fold(DVec3::NEG_INFINITY, DVec3::max);
        let side = (most - least).max_element();
        let scale = f64::from((1_u32 << BITS) - 1) / side;
        let mut keys = parallel::collect(positions.len(), LEAST, |at| {
            // A NaN, as when all is in one place, becomes 0; an infinity saturates.
            let place = ((positions[at] - least) * scale).to_array().map(|x| x as u32);
            let key = if at < kept { along_curve(place) } else { u64::MAX };
            (key, at as u32)
        });
        keys.sort_unstable();
        let vertices: Vec<u32> = keys.into_iter().map(|(_, vertex)| vertex).collect();
        let mut numbers = vec![0; vertices.len()];
        for (number, &vertex) in (0..).zip(&vertices) {
            numbers[vertex as usize] = number;
        }
        let first = |corners: &[u32]| {
            let numbers = corners.iter().filter_map(|&v| numbers.get(v as usize).copied());
            numbers.min().unwrap_or(u32::MAX)
        };
        let keys = (0_u64..).zip(polygons.iter());
        let mut keys: Vec<u64> =
            keys.map(|(face, corners)| u64::from(first(corners)) << 32 | face).collect();
        keys.sort_unstable();
        let faces: Vec<u32> = keys.into_iter().map(|key| key as u32).collect();
        let mut corners = Vec::with_capacity(polygons.corners().len());
        for &face in &faces {
            let end = polygons.ends()[face as usize];
            let start = face.checked_sub(1).map_or(0, |before| polygons.ends()[before as usize]);
            corners.extend(start as u32..end as u32);
        }
        Self { vertices, faces, corners, numbers }
    }

    /// The list in this order.
    pub(super) fn applied(
        &self,
        positions: &[DVec3],
        polygons: &Polygons,
    ) -> (Vec<DVec3>, Polygons) {
        let positions = self.vertices.iter().map(|&v| positions[v as usize]).collect();
        let corner = |&corner: &u32| {
            let vertex = polygons.corners()[corner as usize];
            self.numbers.get(vertex as usize).copied().unwrap_or(vertex)
        };
        let corners = self.corners.iter().map(corner).collect();
        let mut end = 0;
        let sizes =
            self.faces.iter().map(|&face| polygons.get(face as usize).map_or(0, <[_]>::len));
        let ends = sizes.map(|size| {
            end += size;
            end
        });
        let ends = ends.collect();
        (positions, Polygons::of_parts(corners, ends))
    }
}

/// The position of a cell on the curve through all cells.
fn along_curve(mut cell: [u32; 3]) -> u64 {
    let mut bit = 1 << (BITS - 1);
    while bit > 1 {
        let below = bit - 1;
        for axis in 0..3 {
            if cell[axis] & bit != 0 {
                cell[0] ^= below;
            } else {
                let change = (cell[0] ^ cell[axis]) & below;
                cell[0] ^= change;
                cell[axis] ^= change;
            }
        }
        bit >>= 1;
    }
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    let mut turned = 0;
    let mut bit = 1 << (BITS - 1);
    while bit > 1 {
        if cell[2] & bit != 0 {
            turned ^= bit - 1;
        }
        bit >>= 1;
    }
    let cell = cell.map(|coordinate| coordinate ^ turned);
    let bits = (0..BITS).rev().flat_map(|bit| cell.map(|coordinate| coordinate >> bit & 1));
    bits.fold(0, |place, bit| place << 1 | u64::from(bit))
}
