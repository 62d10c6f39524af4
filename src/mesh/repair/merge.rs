//! Merging of points into earlier ones.
//!
//! Points are processed in order. One that lies no farther than the tolerance from a point that
//! stays is merged into the nearest such point; otherwise it stays. So no point moves farther than
//! the tolerance, those that stay are farther than it from each other, and a second run merges
//! nothing. A grid of cells, four tolerances wide, finds the neighbors.

use glam::DVec3;
use hashbrown::HashTable;

/// For each point, the point that it is merged into: itself if it stays.
pub(super) fn merge(positions: &[DVec3], tolerance: f64) -> Vec<u32> {
    let exact = merge_equal(positions);
    let farthest = positions.iter().map(|at| at.abs().max_element()).fold(0.0, f64::max);
    // Cell coordinates must be finite; at such a scale only equal points are within the tolerance.
    let has_cells = tolerance > 0.0 && (farthest / tolerance).is_finite();
    if has_cells { merge_close(positions, &exact, tolerance) } else { exact }
}

pub(in crate::mesh) fn merge_equal(positions: &[DVec3]) -> Vec<u32> {
    let mut table = HashTable::new();
    let mut merged = Vec::with_capacity(positions.len());
    let hash_of = |&point: &u32| hash(positions[point as usize]);
    for (point, &position) in (0..).zip(positions) {
        // What equals nothing would be compared with all that hashes alike.
        if position.is_nan() {
            merged.push(point);
            continue;
        }
        let is_equal = |&other: &u32| positions[other as usize] == position;
        let entry = table.entry(hash(position), is_equal, hash_of).or_insert(point);
        merged.push(*entry.get());
    }
    merged
}

fn merge_close(positions: &[DVec3], exact: &[u32], tolerance: f64) -> Vec<u32> {
    let width = 4.0 * tolerance;
    let cell = |at: DVec3| (at / width).floor();
    let hash_of = |&point: &u32| hash(cell(positions[point as usize]));
    let mut table = HashTable::new();
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
                for &other in table.iter_hash(hash(place)) {
                    let distance = at.distance(positions[other as usize]);
                    if distance <= tolerance && (distance, other) < nearest {
                        nearest = (distance, other);
                    }
                }
            }
        }
        if nearest.1 == point {
            table.insert_unique(hash_of(&point), point, hash_of);
        }
        merged.push(nearest.1);
    }
    merged
}

fn hash(place: DVec3) -> u64 {
    let mut state = 0u64;
    // 0 and -0 are equal.
    for part in (place + DVec3::ZERO).to_array() {
        state = (state.rotate_left(26) ^ part.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        state ^= state >> 32;
    }
    state
}
