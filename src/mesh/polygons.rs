//! A list of polygons, flat: all corners in one array, and where each polygon ends.

use std::ops::Range;

/// Polygons by the indices of their corners, each counterclockwise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polygons {
    corners: Vec<u32>,
    ends: Vec<usize>,
}

impl Polygons {
    pub fn new() -> Self {
        Self::default()
    }

    pub fn with_capacity(polygons: usize, corners: usize) -> Self {
        Self { corners: Vec::with_capacity(corners), ends: Vec::with_capacity(polygons) }
    }

    /// Polygons from the corners of all of them, one after the other, and the end of each; the ends
    /// ascend, and the last is the number of corners.
    pub(super) fn of_parts(corners: Vec<u32>, ends: Vec<usize>) -> Self {
        debug_assert!(ends.is_sorted() && ends.last().is_none_or(|&end| end == corners.len()));
        Self { corners, ends }
    }

    pub(super) fn into_parts(self) -> (Vec<u32>, Vec<usize>) {
        (self.corners, self.ends)
    }

    /// Polygons from all their corners, one polygon after the other, and the end of each; `None` if
    /// the ends are not in order, or the last is not the number of corners.
    pub fn from_parts(corners: Vec<u32>, ends: Vec<usize>) -> Option<Self> {
        let in_order = ends.is_sorted() && ends.last().copied().unwrap_or(0) == corners.len();
        in_order.then_some(Self { corners, ends })
    }

    /// A list of triangles.
    pub fn from_triangles(triangles: &[[u32; 3]]) -> Self {
        let corners = triangles.as_flattened().to_vec();
        Self { corners, ends: (1..=triangles.len()).map(|count| 3 * count).collect() }
    }

    pub fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len());
    }

    /// The number of polygons.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of all polygons, one after the other.
    pub fn corners(&self) -> &[u32] {
        &self.corners
    }

    /// The ends of the polygons in [`Polygons::corners`].
    pub fn ends(&self) -> &[usize] {
        &self.ends
    }

    pub fn into_corners(self) -> Vec<u32> {
        self.corners
    }

    /// The corners of one polygon.
    pub fn get(&self, polygon: usize) -> Option<&[u32]> {
        let end = *self.ends.get(polygon)?;
        let start = polygon.checked_sub(1).map_or(0, |before| self.ends[before]);
        Some(&self.corners[start..end])
    }

    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> + '_ {
        let mut start = 0;
        self.ends.iter().map(move |&end| &self.corners[std::mem::replace(&mut start, end)..end])
    }

    /// The polygons of a range, in order.
    pub(super) fn range(&self, range: Range<usize>) -> impl Iterator<Item = &[u32]> + '_ {
        let mut start = range.start.checked_sub(1).map_or(0, |before| self.ends[before]);
        let ends = self.ends[range].iter();
        ends.map(move |&end| &self.corners[std::mem::replace(&mut start, end)..end])
    }
}

impl<P: AsRef<[u32]>> FromIterator<P> for Polygons {
    fn from_iter<I: IntoIterator<Item = P>>(polygons: I) -> Self {
        let mut list = Self::new();
        for polygon in polygons {
            list.push(polygon.as_ref());
        }
        list
    }
}
