//! The sides of polygons, grouped by the two vertices that they run between.
//!
//! Side `i` runs from corner `i` to the next corner of its polygon. The sides are sorted into
//! one bucket per vertex, the smaller of their ends, and each small bucket by the larger end;
//! there is no map of edges.

use std::ops::Range;

use super::parallel;

/// Sides that can be iterated more than once, in parts.
pub(super) trait EachSide: Sync {
    /// The number of groups of consecutive sides, such as polygons.
    fn groups(&self) -> usize;

    /// Calls `see` with each side of a range of groups and the two vertices that it runs between, in
    /// order.
    fn each_side(&self, groups: Range<usize>, see: impl FnMut(u32, u32, u32));
}

/// The fewest groups that are worth a thread.
const LEAST: usize = 4096;

/// The most threads that count sides: each has a number for every vertex.
const MOST_COUNTERS: usize = 4;

/// Sides, grouped by edge.
pub(super) struct Sides {
    /// Each side with the larger of its ends.
    sorted: Vec<(u32, u32)>,
    /// The ends of the buckets of the vertices.
    bounds: Vec<u32>,
}

impl Sides {
    /// Gathers all sides.
    pub(super) fn gather(all: &impl EachSide, vertices: usize) -> Self {
        // A counting sort: first `bounds[v]` is the number of sides in bucket v, then its start, and
        // in the end its end.
        let mut bounds = counts(all, vertices);
        let threads = if all.groups() < LEAST { 1 } else { parallel::threads() };
        let parts = balanced(&bounds, threads);
        let total = bounds.iter_mut().fold(0, |total, bound| {
            let count = std::mem::replace(bound, total);
            total + count
        });
        let mut sorted = vec![(0u32, 0u32); total as usize];
        let sides = parallel::split(&mut sorted, parts.iter().map(|(_, sides)| *sides));
        let buckets = parallel::split(&mut bounds, parts.iter().map(|(part, _)| part.len()));
        let work = parts.iter().map(|(part, _)| part.start).zip(sides.zip(buckets)).collect();
        parallel::map(work, |(first, (sorted, bounds))| fill(all, first, sorted, bounds));
        Self { sorted, bounds }
    }

    /// The sides of each edge, in order. Edges are ordered by their smaller end, then by the
    /// larger.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[(u32, u32)]> {
        self.edges_of(0..self.bounds.len())
    }

    /// As [`Self::edges`], of the edges whose smaller end is in a range.
    pub(super) fn edges_of(&self, vertices: Range<usize>) -> impl Iterator<Item = &[(u32, u32)]> {
        let mut start = vertices.start.checked_sub(1).map_or(0, |before| self.bounds[before]);
        self.bounds[vertices].iter().flat_map(move |&end| {
            let bucket = std::mem::replace(&mut start, end) as usize..end as usize;
            self.sorted[bucket].chunk_by(|a, b| a.0 == b.0)
        })
    }
}

/// Fills consecutive buckets from that of the vertex `first`, given where each starts, and sorts
/// them. Afterwards `bounds` tells where each ends.
fn fill(all: &impl EachSide, first: usize, sorted: &mut [(u32, u32)], bounds: &mut [u32]) {
    let base = bounds.first().copied().unwrap_or(0);
    all.each_side(0..all.groups(), |side, v, w| {
        if let Some(place) = bounds.get_mut((v.min(w) as usize).wrapping_sub(first)) {
            sorted[(*place - base) as usize] = (v.max(w), side);
            *place += 1;
        }
    });
    let mut start = base;
    for &end in &*bounds {
        sort(&mut sorted[(start - base) as usize..(end - base) as usize]);
        start = end;
    }
}

/// The number of sides whose smaller end is each vertex.
fn counts(all: &impl EachSide, vertices: usize) -> Vec<u32> {
    let parts = parallel::parts(all.groups(), LEAST).len().min(MOST_COUNTERS);
    let mut counts = parallel::map(parallel::cut(all.groups(), parts), |part| {
        let mut counts = vec![0; vertices];
        all.each_side(part, |_, v, w| {
            if let Some(count) = counts.get_mut(v.min(w) as usize) {
                *count += 1;
            }
        });
        counts
    });
    let mut total = counts.pop().unwrap_or_default();
    for part in counts {
        total.iter_mut().zip(part).for_each(|(total, count)| *total += count);
    }
    total
}

/// Ranges that cover all vertices, each with its number of sides: `parts`, with about as many
/// sides each.
fn balanced(counts: &[u32], parts: usize) -> Vec<(Range<usize>, usize)> {
    let each = counts.iter().map(|&count| count as usize).sum::<usize>().div_ceil(parts);
    let mut ranges = Vec::with_capacity(parts);
    let (mut start, mut sides) = (0, 0);
    for (vertex, &count) in counts.iter().enumerate() {
        sides += count as usize;
        if sides >= each && ranges.len() + 1 < parts {
            ranges.push((start..vertex + 1, sides));
            (start, sides) = (vertex + 1, 0);
        }
    }
    ranges.push((start..counts.len(), sides));
    ranges
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
