//! The loops of a list of polygons: the next and the previous corner of each corner.

use std::ops::Range;

use super::polygon_sides::EachSide;

/// Polygons that give the neighbors of each of their corners.
pub(super) struct Loops<'p> {
    /// The vertices of the corners, and where the polygons end.
    corners: &'p [u32],
    ends: &'p [usize],
    shape: Shape,
}

enum Shape {
    Triangles,
    /// All polygons have this number of corners.
    Alike(u32),
    /// The polygon of each corner.
    Mixed(Vec<u32>),
}

impl<'p> Loops<'p> {
    pub(super) fn new(corners: &'p [u32], ends: &'p [usize]) -> Self {
        let sides = ends.first().map_or(3, |&end| end);
        let is_alike = sides > 0 && ends.iter().enumerate().all(|(i, &end)| end == (i + 1) * sides);
        let shape = match is_alike {
            true if sides == 3 => Shape::Triangles,
            true => Shape::Alike(sides as u32),
            false => {
                let starts = std::iter::once(&0).chain(ends);
                let of = |(polygon, (start, end)): (u32, (&usize, &usize))| (polygon, end - start);
                let all = (0..).zip(starts.zip(ends)).map(of);
                let all = all.flat_map(|(polygon, count)| std::iter::repeat_n(polygon, count));
                Shape::Mixed(all.collect())
            }
        };
        Self { corners, ends, shape }
    }

    /// The number of polygons.
    pub(super) fn len(&self) -> usize {
        self.ends.len()
    }

    /// The number of corners of each polygon, if it is the same for all.
    pub(super) fn alike(&self) -> Option<u32> {
        match self.shape {
            Shape::Triangles => Some(3),
            Shape::Alike(sides) => Some(sides),
            Shape::Mixed(_) => None,
        }
    }

    /// The vertices of all corners.
    #[inline]
    pub(super) fn corners(&self) -> &'p [u32] {
        self.corners
    }

    /// The polygon of a corner.
    #[inline]
    pub(super) fn polygon(&self, corner: u32) -> u32 {
        match &self.shape {
            Shape::Triangles => corner / 3,
            Shape::Alike(sides) => corner / sides,
            Shape::Mixed(polygons) => polygons[corner as usize],
        }
    }

    /// The first corner of a polygon.
    #[inline]
    pub(super) fn first(&self, polygon: usize) -> u32 {
        polygon.checked_sub(1).map_or(0, |before| self.ends[before] as u32)
    }

    /// The corner after another in its polygon.
    #[inline]
    pub(super) fn next(&self, corner: u32) -> u32 {
        let behind = corner + 1;
        match &self.shape {
            Shape::Triangles if behind.is_multiple_of(3) => behind - 3,
            Shape::Alike(sides) if behind.is_multiple_of(*sides) => behind - sides,
            Shape::Mixed(polygons) => {
                let polygon = polygons[corner as usize];
                match polygons.get(behind as usize) == Some(&polygon) {
                    true => behind,
                    false => self.first(polygon as usize),
                }
            }
            _ => behind,
        }
    }

    /// The corner before another in its polygon.
    #[inline]
    pub(super) fn prev(&self, corner: u32) -> u32 {
        let polygon = self.polygon(corner);
        let first = match &self.shape {
            Shape::Triangles => polygon * 3,
            Shape::Alike(sides) => polygon * sides,
            Shape::Mixed(_) => self.first(polygon as usize),
        };
        let is_first = corner == first;
        match &self.shape {
            _ if !is_first => corner - 1,
            Shape::Triangles => corner + 2,
            _ => self.ends[polygon as usize] as u32 - 1,
        }
    }

    /// The vertices between which the side from a corner runs.
    #[inline]
    pub(super) fn ends(&self, corner: u32) -> [u32; 2] {
        [corner, self.next(corner)].map(|corner| self.corners()[corner as usize])
    }
}

impl EachSide for Loops<'_> {
    fn groups(&self) -> usize {
        self.ends.len()
    }

    #[inline]
    fn each_side(&self, polygons: Range<usize>, mut see: impl FnMut(u32, u32, u32)) {
        if let Shape::Triangles = self.shape {
            let (triangles, _) = self.corners.as_chunks::<3>();
            let first = 3 * polygons.start as u32;
            for (h, &[a, b, c]) in (first..).step_by(3).zip(&triangles[polygons]) {
                see(h, a, b);
                see(h + 1, b, c);
                see(h + 2, c, a);
            }
            return;
        }
        let mut start = self.first(polygons.start) as usize;
        for &end in &self.ends[polygons] {
            let corners = &self.corners[start..end];
            for (h, pair) in (start as u32..).zip(corners.windows(2)) {
                see(h, pair[0], pair[1]);
            }
            if let (Some(&first), Some(&last)) = (corners.first(), corners.last()) {
                see(end as u32 - 1, last, first);
            }
            start = end;
        }
    }
}
