//! The sides of polygons, gathered by the two vertices that they run between.
//!
//! Side `i` runs from corner `i` to the next corner of its polygon. The sides are sorted into
//! one bucket per vertex, the smaller of their ends, and each small bucket by the larger end;
//! there is no map of edges.

/// Sides by edges.
pub(super) struct Sides {
    /// Each side with the larger of its ends.
    sorted: Vec<(u32, u32)>,
    /// The ends of the buckets of the vertices.
    bounds: Vec<u32>,
}

impl Sides {
    /// Gathers `sides` sides between `vertices` vertices; `ends` tells where a side runs.
    pub(super) fn gather(sides: u32, vertices: usize, ends: impl Fn(u32) -> [u32; 2]) -> Self {
        // A counting sort: after the second pass `bounds[v]` is the end of bucket v.
        let mut bounds = vec![0u32; vertices + 1];
        for side in 0..sides {
            let [v, w] = ends(side);
            bounds[v.min(w) as usize + 1] += 1;
        }
        for v in 1..bounds.len() {
            bounds[v] += bounds[v - 1];
        }
        let mut sorted = vec![(0u32, 0u32); sides as usize];
        for side in 0..sides {
            let [v, w] = ends(side);
            let place = &mut bounds[v.min(w) as usize];
            sorted[*place as usize] = (v.max(w), side);
            *place += 1;
        }
        bounds.pop();
        let mut start = 0;
        for &end in &bounds {
            sorted[start..end as usize].sort_unstable();
            start = end as usize;
        }
        Self { sorted, bounds }
    }

    /// The edges by the smaller of their ends and then the larger: the sides of each, in order.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[(u32, u32)]> {
        let mut start = 0;
        self.bounds.iter().flat_map(move |&end| {
            let bucket = &self.sorted[std::mem::replace(&mut start, end as usize)..end as usize];
            bucket.chunk_by(|a, b| a.0 == b.0)
        })
    }
}
