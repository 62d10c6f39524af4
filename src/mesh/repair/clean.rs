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
                    Some(parts) => open.extend(parts.into_iter().rev()),
                    None => cleaner.divide(&corners, &mut cleaned),
                }
            }
        }
        report.repeated_corners += std::mem::take(&mut cleaner.repeated);
        let [returns, spurs] = std::mem::take(&mut cleaner.short);
        match cleaned.ends.len() - before {
            0 => report.degenerate_faces += 1,
            count => {
                report.repeated_corners += returns;
                report.spurs += spurs;
                report.divided_faces += usize::from(count > 1);
            }
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
    /// Adds a polygon.
    fn push(&mut self, corners: impl Iterator<Item = Corner>) {
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
    /// The number of corners that repeated the previous one.
    repeated: usize,
    /// The numbers of loops of one and of two corners: the last corner that is the first, and spurs.
    short: [usize; 2],
}

impl Cleaner {
    /// Cuts off loops at repeated vertices.
    fn divide(&mut self, corners: &[Corner], cleaned: &mut Cleaned) {
        self.open.clear();
        self.places.clear();
        for &(vertex, origin) in corners {
            if let Some(place) = self.places.get(&vertex).copied() {
                if place + 1 == self.open.len() {
                    self.repeated += 1;
                    continue;
                }
                for &(closed, _) in &self.open[place..] {
                    self.places.remove(&closed);
                }
                self.close(place, cleaned);
            }
            self.places.insert(vertex, self.open.len());
            self.open.push((vertex, origin));
        }
        self.close(0, cleaned);
    }

    /// Adds the corners from a place on as a polygon, or drops them if they are fewer than three.
    fn close(&mut self, place: usize, cleaned: &mut Cleaned) {
        let corners = self.open.drain(place..);
        match corners.len() {
            0 => {}
            few @ (1 | 2) => self.short[few - 1] += 1,
            _ => cleaned.push(corners),
        }
    }
}
