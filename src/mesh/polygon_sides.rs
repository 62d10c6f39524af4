//! The sides of polygons, grouped by the two vertices that they run between.
//!
//! Side `i` runs from corner `i` to the next corner of its polygon. The sides are sorted into
//! one bucket per vertex, the smaller of their ends, and each small bucket by the larger end;
//! there is no map of edges.

use std::ops::Range;

use super::parallel;

/// Sides that can be iterated more than once.
pub(super) trait EachSide {
    /// Calls `see` with each side and the two vertices that it runs between, in order.
    fn each_side(&self, see: impl FnMut(u32, u32, u32));
}

/// The fewest sides that are worth a thread.
const LEAST: usize = 1 << 14;

/// Sides, grouped by edge.
pub(super) struct Sides {
    /// Each side with the larger of its ends.
    sorted: Vec<(u32, u32)>,
    /// The ends of the buckets of the vertices.
    bounds: Vec<u32>,
}

impl Sides {
    /// The ranges of vertices, one for each thread; each thread scans all sides.
    pub(super) fn parts(vertices: usize, sides: usize) -> Vec<Range<usize>> {
        parallel::cut(vertices, if sides < LEAST { 1 } else { parallel::threads() })
    }

    /// Gathers the sides whose smaller end is among `vertices`.
    pub(super) fn gather(all: &impl EachSide, vertices: Range<usize>) -> Self {
        let bucket = |v: u32, w: u32| (v.min(w) as usize).wrapping_sub(vertices.start);
        // A counting sort: after the second pass `bounds[v]` is the end of bucket v.
        let mut bounds = vec![0u32; vertices.len() + 1];
        all.each_side(|_, v, w| {
            if let Some(bound) = bounds[1..].get_mut(bucket(v, w)) {
                *bound += 1;
            }
        });
        for v in 1..bounds.len() {
            bounds[v] += bounds[v - 1];
        }
        let mut sorted = vec![(0u32, 0u32); bounds.pop().map_or(0, |all| all as usize)];
        all.each_side(|side, v, w| {
            if let Some(place) = bounds.get_mut(bucket(v, w)) {
                sorted[*place as usize] = (v.max(w), side);
                *place += 1;
            }
        });
        let mut start = 0;
        for &end in &bounds {
            sort(&mut sorted[start..end as usize]);
            start = end as usize;
        }
        Self { sorted, bounds }
    }

    /// The sides of each edge, in order. Edges are ordered by their smaller end, then by the
    /// larger.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[(u32, u32)]> {
        let mut start = 0;
        self.bounds.iter().flat_map(move |&end| {
            let bucket = &self.sorted[std::mem::replace(&mut start, end as usize)..end as usize];
            bucket.chunk_by(|a, b| a.0 == b.0)
        })
    }
}

/// Sorts the sides of a bucket; most buckets have about six.
fn sort(sides: &mut [(u32, u32)]) {
    if sides.len() > 16 {
        return sides.sort_unstable();
    }
    let key = |(far, side): (u32, u32)| u64::from(far) << 32 | u64::from(side);
    for i in 1..sides.len() {
        let side = sides[i];
        let mut at = i;
        while at > 0 && key(sides[at - 1]) > key(side) {
            sides[at] = sides[at - 1];
            at -= 1;
        }
        sides[at] = side;
    }
}
