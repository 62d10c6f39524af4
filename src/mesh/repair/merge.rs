//! Merging of points into earlier ones.
//!
//! Points are processed in order. One that lies no farther than the tolerance from a point that
//! stays is merged into the nearest such point; otherwise it stays. So no point moves farther than
//! the tolerance, those that stay are farther than it from each other, and a second run merges
//! nothing. A grid of cells, four tolerances wide, finds the neighbors.

use glam::DVec3;

/// Marks an empty place of the table.
const EMPTY: u32 = u32::MAX;

/// For each point, the point that it is merged into: itself if it stays.
pub(super) fn merge(positions: &[DVec3], tolerance: f64) -> Vec<u32> {
    let exact = merge_equal(positions);
    let farthest = positions.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    // Cell coordinates must be finite; at such a scale only equal points are within the tolerance.
    let has_cells = tolerance > 0.0 && (farthest / tolerance).is_finite();
    if has_cells { merge_close(positions, &exact, tolerance) } else { exact }
}

pub(in crate::mesh) fn merge_equal(positions: &[DVec3]) -> Vec<u32> {
    let mut table = Table::new();
    let mut merged = Vec::with_capacity(positions.len());
    for (point, &position) in (0..).zip(positions) {
        // 0 and -0 are equal.
        let key = (position + DVec3::ZERO).to_array().map(f64::to_bits);
        let known = table.find(hash(key), |other| positions[other as usize] == position);
        if known.is_none() {
            table.insert(hash(key), point);
        }
        merged.push(known.unwrap_or(point));
    }
    merged
}

fn merge_close(positions: &[DVec3], exact: &[u32], tolerance: f64) -> Vec<u32> {
    let width = 4.0 * tolerance;
    let cell = |at: DVec3| (at / width).floor() + DVec3::ZERO;
    let mut table = Table::new();
    let mut merged: Vec<u32> = Vec::with_capacity(positions.len());
    for (point, &at) in (0..).zip(positions) {
        if exact[point as usize] != point {
            merged.push(merged[exact[point as usize] as usize]);
            continue;
        }
        let (low, high) = (cell(at - tolerance), cell(at + tolerance));
        let mut nearest = (f64::INFINITY, point);
        for choice in 0..8 {
            let mut place = low;
            let mut is_new = true;
            for axis in 0..3 {
                if choice >> axis & 1 == 1 {
                    place[axis] = high[axis];
                    is_new &= high[axis] != low[axis];
                }
            }
            if is_new {
                table.each(hash(place.to_array().map(f64::to_bits)), |other| {
                    let distance = at.distance(positions[other as usize]);
                    if distance <= tolerance && distance < nearest.0 {
                        nearest = (distance, other);
                    }
                });
            }
        }
        if nearest.1 == point {
            table.insert(hash(cell(at).to_array().map(f64::to_bits)), point);
        }
        merged.push(nearest.1);
    }
    merged
}

fn hash(key: [u64; 3]) -> u64 {
    let mut state = 0u64;
    for part in key {
        state = (state.rotate_left(26) ^ part).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        state ^= state >> 32;
    }
    state
}

/// Points by the hash of their place: open addressing with linear probing.
struct Table {
    /// The upper half of the hash, and the point.
    places: Vec<(u32, u32)>,
    used: usize,
}

impl Table {
    fn new() -> Self {
        Self { places: vec![(0, EMPTY); 1 << 10], used: 0 }
    }

    /// Visits the points with a hash, and possibly others.
    fn each(&self, hash: u64, mut visit: impl FnMut(u32)) {
        self.find(hash, |point| {
            visit(point);
            false
        });
    }

    /// The first point with a hash that passes `is_it`.
    fn find(&self, hash: u64, mut is_it: impl FnMut(u32) -> bool) -> Option<u32> {
        let (tag, mut at) = self.start(hash);
        loop {
            match self.places[at] {
                (_, EMPTY) => return None,
                (other, point) if other == tag && is_it(point) => return Some(point),
                _ => at = (at + 1) & (self.places.len() - 1),
            }
        }
    }

    fn insert(&mut self, hash: u64, point: u32) {
        if self.used * 2 >= self.places.len() {
            self.grow();
        }
        self.put(hash, point);
        self.used += 1;
    }

    fn start(&self, hash: u64) -> (u32, usize) {
        // The place depends on the tag alone, so that the table can grow without the points.
        let tag = (hash >> 32) as u32;
        (tag, tag.wrapping_mul(0x9E37_79B1) as usize & (self.places.len() - 1))
    }

    fn put(&mut self, hash: u64, point: u32) {
        let (tag, mut at) = self.start(hash);
        while self.places[at].1 != EMPTY {
            at = (at + 1) & (self.places.len() - 1);
        }
        self.places[at] = (tag, point);
    }

    fn grow(&mut self) {
        let larger = vec![(0, EMPTY); self.places.len() * 4];
        for (tag, point) in std::mem::replace(&mut self.places, larger) {
            if point != EMPTY {
                self.put(u64::from(tag) << 32, point);
            }
        }
    }
}
