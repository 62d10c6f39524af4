//! Polygons that use a vertex more than once.

use super::RepairReport;
use super::keyhole::{self, Corner};
use super::polygon_list::PolygonList;
use crate::mesh::build_error::repeated;

/// Drops corners that repeat the previous one, divides polygons that return to a vertex, and drops
/// those that are left with fewer than three corners.
pub(super) fn clean(list: &mut PolygonList, report: &mut RepairReport) {
    let mut sorted = Vec::new();
    let mut is_sound =
        |corners: &[u32]| corners.len() >= 3 && repeated(corners, &mut sorted).is_none();
    if (0..list.ends.len()).all(|polygon| is_sound(&list.corners[list.range(polygon)])) {
        return;
    }
    let (mut cleaner, mut cleaned) = (Cleaner::default(), Cleaned::default());
    for polygon in 0..list.ends.len() {
        let range = list.range(polygon);
        let corners = &list.corners[range.clone()];
        let before = cleaned.ends.len();
        cleaned.origin = list.faces[polygon];
        let origins = &list.corner_origins[range];
        if is_sound(corners) {
            cleaned.push(corners.iter().copied().zip(origins.iter().copied()));
        } else {
            let corners = corners.iter().copied().zip(origins.iter().copied()).collect();
            let mut open: Vec<Vec<Corner>> = vec![corners];
            while let Some(corners) = open.pop() {
                match keyhole::cut(&corners, &list.positions) {
                    Some([first, second]) => open.extend([second, first]),
                    None => report.repeated_corners += cleaner.divide(&corners, &mut cleaned),
                }
            }
        }
        match cleaned.ends.len() - before {
            0 => report.degenerate_faces += 1,
            1 => {}
            _ => report.divided_faces += 1,
        }
    }
    let Cleaned { corners, origins, ends, faces, .. } = cleaned;
    (list.corners, list.corner_origins, list.ends, list.faces) = (corners, origins, ends, faces);
}

#[derive(Default)]
struct Cleaned {
    corners: Vec<u32>,
    origins: Vec<u32>,
    ends: Vec<usize>,
    faces: Vec<u32>,
    /// The number of the current polygon in the input.
    origin: u32,
}

impl Cleaned {
    /// Adds a polygon, unless it has fewer than three corners.
    fn push(&mut self, corners: impl ExactSizeIterator<Item = Corner>) {
        if corners.len() < 3 {
            return;
        }
        for (vertex, origin) in corners {
            self.corners.push(vertex);
            self.origins.push(origin);
        }
        self.ends.push(self.corners.len());
        self.faces.push(self.origin);
    }
}

/// Scratch space.
#[derive(Default)]
struct Cleaner {
    /// The corners of the loop that is still open.
    open: Vec<Corner>,
    /// The places of vertices in `open`.
    places: std::collections::HashMap<u32, usize>,
}

impl Cleaner {
    /// Cuts off loops at repeated vertices. Returns the number of corners that repeat the previous
    /// one.
    fn divide(&mut self, corners: &[Corner], cleaned: &mut Cleaned) -> usize {
        self.open.clear();
        self.places.clear();
        let mut repeated = 0;
        for &(vertex, origin) in corners {
            match self.places.get(&vertex).copied() {
                Some(place) if place + 1 == self.open.len() => repeated += 1,
                Some(place) => {
                    for &(closed, _) in &self.open[place + 1..] {
                        self.places.remove(&closed);
                    }
                    cleaned.push(self.open.drain(place..));
                    self.open.push((vertex, origin));
                }
                None => {
                    self.places.insert(vertex, self.open.len());
                    self.open.push((vertex, origin));
                }
            }
        }
        cleaned.push(self.open.drain(..));
        repeated
    }
}
