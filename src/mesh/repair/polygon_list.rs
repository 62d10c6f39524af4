//! Polygons under repair.

use glam::DVec3;

use super::RepairReport;
use crate::mesh::loops::Loops;
use crate::mesh::polygon_sides::Sides;
use crate::mesh::polygons::Polygons;

/// Marks a missing index.
pub(in crate::mesh) const NONE: u32 = u32::MAX;

/// Polygons, with their origins: the vertices, polygons and corners of the input that they come
/// from.
#[derive(Clone)]
pub(in crate::mesh) struct PolygonList {
    pub(in crate::mesh) positions: Vec<DVec3>,
    /// The vertices of the corners.
    pub(in crate::mesh) corners: Vec<u32>,
    /// The end of each polygon in `corners`.
    pub(in crate::mesh) ends: Vec<usize>,
    /// The origins of the vertices.
    pub(in crate::mesh) vertices: Vec<u32>,
    /// The origins of the polygons.
    pub(in crate::mesh) faces: Vec<u32>,
    /// The origins of the corners.
    pub(in crate::mesh) corner_origins: Vec<u32>,
}

impl PolygonList {
    pub(in crate::mesh) fn new(positions: Vec<DVec3>, polygons: Polygons) -> Self {
        let (corners, ends) = polygons.into_parts();
        Self {
            vertices: (0..positions.len() as u32).collect(),
            faces: (0..ends.len() as u32).collect(),
            corner_origins: (0..corners.len() as u32).collect(),
            positions,
            corners,
            ends,
        }
    }

    /// The range of the corners of a polygon.
    pub(in crate::mesh) fn range(&self, polygon: usize) -> std::ops::Range<usize> {
        polygon.checked_sub(1).map_or(0, |before| self.ends[before])..self.ends[polygon]
    }

    /// Keeps the polygons for which `keep` is true.
    pub(in crate::mesh) fn retain(&mut self, mut keep: impl FnMut(usize, &[u32]) -> bool) {
        let (mut polygons, mut corners, mut start) = (0, 0, 0);
        for polygon in 0..self.ends.len() {
            let end = self.ends[polygon];
            if keep(polygon, &self.corners[start..end]) {
                self.corners.copy_within(start..end, corners);
                self.corner_origins.copy_within(start..end, corners);
                corners += end - start;
                self.ends[polygons] = corners;
                self.faces[polygons] = self.faces[polygon];
                polygons += 1;
            }
            start = end;
        }
        self.ends.truncate(polygons);
        self.faces.truncate(polygons);
        self.corners.truncate(corners);
        self.corner_origins.truncate(corners);
    }

    /// Drops vertices with a coordinate that is not finite, and the polygons that use them or a
    /// vertex that does not exist.
    pub(in crate::mesh) fn drop_unusable(&mut self, report: &mut RepairReport) {
        let usable: Vec<bool> = self.positions.iter().map(|at| at.is_finite()).collect();
        let is_usable = |&v: &u32| usable.get(v as usize).is_some_and(|&usable| usable);
        let before = self.ends.len();
        if !self.corners.iter().all(is_usable) {
            self.retain(|_, corners| corners.iter().all(is_usable));
        }
        report.degenerate_faces += before - self.ends.len();
        if !usable.iter().all(|&usable| usable) {
            let itself = |(v, &usable): (u32, &bool)| if usable { v } else { NONE };
            let kept: Vec<u32> = (0..).zip(&usable).map(itself).collect();
            report.dropped_vertices += self.merge(&kept);
        }
    }

    /// Replaces each vertex by that of `into`, itself if it stays. Returns the number of vertices
    /// removed.
    pub(in crate::mesh) fn merge(&mut self, into: &[u32]) -> usize {
        let mut numbers = vec![NONE; into.len()];
        let mut kept = 0;
        for v in 0..into.len() {
            if into[v] as usize == v {
                numbers[v] = kept as u32;
                self.positions[kept] = self.positions[v];
                self.vertices[kept] = self.vertices[v];
                kept += 1;
            }
        }
        self.positions.truncate(kept);
        self.vertices.truncate(kept);
        if kept < into.len() {
            for corner in &mut self.corners {
                *corner = numbers[into[*corner as usize] as usize];
            }
        }
        into.len() - kept
    }

    /// The loops of the polygons.
    pub(in crate::mesh) fn loops(&self) -> Loops<'_> {
        Loops::new(&self.corners, &self.ends)
    }

    /// The sides of the polygons, grouped by edge; side `i` begins at corner `i`.
    pub(in crate::mesh) fn sides(&self) -> Sides {
        Sides::gather(&self.loops(), self.positions.len())
    }
}
