//! Queries for points in a triangle, while points are removed.
//!
//! A k-d tree (J. Bentley, "Multidimensional binary search trees used for associative searching",
//! 1975) whose boxes count their remaining points.

use glam::DVec2;

use super::turn;

/// The largest number of points in a leaf box.
const LEAF: usize = 8;

/// Points in the plane, by number.
pub(super) struct Tree {
    boxes: Vec<Bounds>,
    /// The numbers of the points, box by box.
    points: Vec<u32>,
    /// The leaf box of each point.
    home: Vec<u32>,
    is_left: Vec<bool>,
}

/// A box around some of the points.
struct Bounds {
    low: DVec2,
    high: DVec2,
    /// The number of points that are left in it.
    left: u32,
    /// The range of its points.
    range: [u32; 2],
    /// The first of its two parts, which are stored next to each other.
    parts: Option<u32>,
    /// The box that it is a part of; itself, if it is the root.
    whole: u32,
}

impl Tree {
    pub fn new(places: &[DVec2]) -> Self {
        let count = places.len();
        let mut tree = Self {
            boxes: Vec::new(),
            points: (0..count as u32).collect(),
            home: vec![0; count],
            is_left: vec![true; count],
        };
        tree.add([0, count], 0, places);
        let mut open = vec![0_usize];
        while let Some(at) = open.pop() {
            let [start, end] = tree.boxes[at].range.map(|end| end as usize);
            if end - start <= LEAF {
                for &point in &tree.points[start..end] {
                    tree.home[point as usize] = at as u32;
                }
                continue;
            }
            let size = tree.boxes[at].high - tree.boxes[at].low;
            let middle = (end - start) / 2;
            let key = |&point: &u32| {
                let place = places[point as usize];
                if size.x > size.y { place.x } else { place.y }
            };
            tree.points[start..end]
                .select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)).then(a.cmp(b)));
            let parts = tree.boxes.len();
            tree.boxes[at].parts = Some(parts as u32);
            tree.add([start, start + middle], at, places);
            tree.add([start + middle, end], at, places);
            open.extend([parts, parts + 1]);
        }
        tree
    }

    fn add(&mut self, [start, end]: [usize; 2], whole: usize, places: &[DVec2]) {
        let inside = || self.points[start..end].iter().map(|&point| places[point as usize]);
        self.boxes.push(Bounds {
            low: inside().fold(DVec2::INFINITY, DVec2::min),
            high: inside().fold(DVec2::NEG_INFINITY, DVec2::max),
            left: (end - start) as u32,
            range: [start as u32, end as u32],
            parts: None,
            whole: whole as u32,
        });
    }

    pub fn has(&self, point: u32) -> bool {
        self.is_left[point as usize]
    }

    pub fn take(&mut self, point: u32) {
        self.is_left[point as usize] = false;
        let mut at = self.home[point as usize];
        loop {
            let bounds = &mut self.boxes[at as usize];
            bounds.left -= 1;
            if bounds.whole == at {
                return;
            }
            at = bounds.whole;
        }
    }

    /// A point that is left, lies in a triangle or on its boundary, and is wanted. The triangle is
    /// counterclockwise or degenerate.
    pub fn find(
        &self,
        triangle: [DVec2; 3],
        places: &[DVec2],
        is_wanted: impl Fn(u32) -> bool,
    ) -> Option<u32> {
        let mut open = vec![0_u32];
        while let Some(at) = open.pop() {
            let bounds = &self.boxes[at as usize];
            if bounds.left == 0 || !bounds.may_meet(triangle) {
                continue;
            }
            if let Some(parts) = bounds.parts {
                open.extend([parts, parts + 1]);
                continue;
            }
            let [start, end] = bounds.range.map(|end| end as usize);
            let found = self.points[start..end].iter().copied().find(|&point| {
                self.has(point) && is_wanted(point) && holds(triangle, places[point as usize])
            });
            if found.is_some() {
                return found;
            }
        }
        None
    }
}

impl Bounds {
    /// True if some point of the box may lie in a triangle.
    fn may_meet(&self, triangle: [DVec2; 3]) -> bool {
        let [a, b, c] = triangle;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        if !(self.low.cmple(high).all() && low.cmple(self.high).all()) {
            return false;
        }
        // The corner of the box that lies furthest to the left of a side.
        [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let along = to - from;
            let corner = DVec2::new(
                if along.y > 0.0 { self.low.x } else { self.high.x },
                if along.x > 0.0 { self.high.y } else { self.low.y },
            );
            turn([from, to, corner]) >= 0.0
        })
    }
}

/// True if a place lies in a triangle or on its boundary.
fn holds(triangle: [DVec2; 3], place: DVec2) -> bool {
    let [a, b, c] = triangle;
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    // Every point on the line of a degenerate triangle passes the tests of its sides: hence the
    // bounding box.
    place.cmpge(low).all()
        && place.cmple(high).all()
        && [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| turn([from, to, place]) >= 0.0)
}
