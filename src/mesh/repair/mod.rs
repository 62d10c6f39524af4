//! Making a mesh of polygons that are none.
//!
//! The steps, in their order; each is counted in the [`RepairReport`]:
//!
//! 1. vertices that lie nowhere (a coordinate that is not finite) go, with the polygons that
//!    use them or a vertex that does not exist;
//! 2. on demand, points within a tolerance become one vertex (`merge`);
//! 3. corners that repeat the one before go, a polygon that comes back to one of its vertices
//!    becomes several, of which none covers a hole (`keyhole`), and what has fewer than three
//!    corners goes (`clean`);
//! 4. of polygons with the same corners in the same order only the first stays; likewise of two
//!    that are each other's back, where an edge has more than two polygons (`double`);
//! 5. neighbours across edges of two polygons are turned to run alike, in each connected part
//!    as few as possible (`orient`);
//! 6. the surface is cut along edges of three polygons or more, but for two of these that hang
//!    together around both ends, and where turning does not help, as on a Möbius strip; a vertex
//!    becomes one for each fan of polygons around it (`fans`).
//!
//! Nothing is closed or filled, no point moves farther than the tolerance, and what is a mesh
//! already stays as it is: so a second repair changes nothing. Corners, polygons and vertices
//! know which ones of the list they were, so that whatever hung on these can follow.
//!
//! The rules to drop, turn and cut are those of CGAL with polygon soups (S. Loriot, M.
//! Rouxel-Labbé, J. Tournois, I. O. Yaz, *Polygon Mesh Processing*, `orient_polygon_soup` after A.
//! Guéziec, G. Taubin, F. Lazarus, B. Horn, "Cutting and Stitching: Converting Sets of Polygons to
//! Manifold Surfaces", 2001); it turns parts the way most of their polygons run, and isolates a
//! corner more where a cut edge would keep both its ends in common.

mod clean;
mod double;
mod fans;
mod keyhole;
mod merge;
mod orient;
mod polygon_list;

use glam::DVec3;
use serde::Serialize;

pub(super) use self::double::repeated;
pub(super) use self::merge::merge_equal;
pub(super) use self::polygon_list::{NONE, PolygonList};
use super::build_error::BuildError;
use super::connectivity::Mesh;
use super::order::Order;
use super::polygons::Polygons;

/// Which repairs are made where polygons become a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Repair {
    /// Points that are no farther from each other than this become one vertex; with 0, equal ones.
    pub merge: Option<f64>,
}

/// Polygons that are a mesh, and what they were.
#[derive(Clone, Debug)]
pub struct Repaired {
    pub mesh: Mesh,
    /// The vertices of the list that those of the mesh were. Those that stayed come first, in
    /// order; then those that have been split off.
    pub vertices: Vec<u32>,
    /// The number of vertices that stayed.
    pub kept_vertices: usize,
    /// The polygons of the list that the faces were, or were part of, in order.
    pub faces: Vec<u32>,
    /// The corners of the list that the halfedges of the faces were.
    pub corners: Vec<u32>,
    pub report: RepairReport,
}

/// The number of times each step of a repair did something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RepairReport {
    /// Places of a file that cannot be read, passed over: what should stand there is missing.
    pub damaged_places: usize,
    /// Vertices with a coordinate that is not finite, dropped.
    pub dropped_vertices: usize,
    /// Vertices merged into others that are close enough.
    pub merged_vertices: usize,
    /// Corners that repeat the one before, dropped.
    pub repeated_corners: usize,
    /// Polygons divided where they come back to a vertex.
    pub divided_faces: usize,
    /// Polygons without three corners of their own, dropped.
    pub degenerate_faces: usize,
    /// Polygons that are there already, dropped.
    pub doubled_faces: usize,
    /// Polygons turned over.
    pub turned_faces: usize,
    /// Edges of three polygons or more, cut.
    pub crowded_edges: usize,
    /// Edges that were cut because their polygons cannot all run alike.
    pub twisted_edges: usize,
    /// Vertices added, so that each fan of faces has its own.
    pub split_vertices: usize,
}

impl RepairReport {
    /// True if something was changed.
    pub fn is_changed(&self) -> bool {
        *self != Self::default()
    }

    /// The steps that did something, in words.
    pub fn steps(&self) -> Vec<String> {
        let steps = [
            (self.damaged_places, "passed over", "damaged place", "damaged places", " of the file"),
            (self.dropped_vertices, "dropped", "vertex", "vertices", " without coordinates"),
            (self.merged_vertices, "merged", "vertex", "vertices", " into others"),
            (self.repeated_corners, "dropped", "repeated corner", "repeated corners", ""),
            (self.divided_faces, "divided", "face", "faces", " with a vertex twice"),
            (self.degenerate_faces, "dropped", "degenerate face", "degenerate faces", ""),
            (self.doubled_faces, "dropped", "doubled face", "doubled faces", ""),
            (self.turned_faces, "turned", "face", "faces", " over"),
            (self.crowded_edges, "cut", "edge", "edges", " of three faces or more"),
            (self.twisted_edges, "cut", "edge", "edges", " whose faces cannot run alike"),
            (self.split_vertices, "split off", "vertex", "vertices", ""),
        ];
        let done = steps.into_iter().filter(|&(count, ..)| count > 0);
        let words = done.map(|(count, verb, one, many, rest)| {
            format!("{verb} {count} {}{rest}", if count == 1 { one } else { many })
        });
        words.collect()
    }
}

impl Repaired {
    /// Polygons that are a mesh, in an order in which neighbors stand near each other, but for the
    /// vertices behind the first `kept_vertices`; `None` if they are none.
    pub(super) fn in_order(
        positions: &[DVec3],
        polygons: &Polygons,
        kept_vertices: usize,
    ) -> Option<Self> {
        let order = Order::of(positions, polygons, kept_vertices);
        let (positions, polygons) = order.applied(positions, polygons);
        let mesh = Mesh::from_owned_polygons(positions, &polygons).ok()?;
        let Order { vertices, faces, corners, .. } = order;
        let report = RepairReport::default();
        Some(Self { mesh, vertices, kept_vertices, faces, corners, report })
    }

    /// The same in such an order.
    pub(super) fn reordered(self) -> Self {
        let (positions, polygons) = self.mesh.to_polygons();
        let Some(order) = Self::in_order(&positions, &polygons, self.kept_vertices) else {
            return self; // Never: it was a mesh.
        };
        let at = |of: &[u32], order: &[u32]| order.iter().map(|&at| of[at as usize]).collect();
        Self {
            vertices: at(&self.vertices, &order.vertices),
            faces: at(&self.faces, &order.faces),
            corners: at(&self.corners, &order.corners),
            report: self.report,
            ..order
        }
    }

    /// Makes a mesh of polygons, repairing what keeps them from being one.
    ///
    /// # Errors
    /// [`BuildError::TooLarge`] alone: all else is mended.
    pub fn new(
        positions: Vec<DVec3>,
        polygons: Polygons,
        repair: Repair,
    ) -> Result<Self, BuildError> {
        let mut list = PolygonList::new(positions, polygons);
        let mut report = RepairReport::default();
        list.drop_unusable(&mut report);
        if let Some(tolerance) = repair.merge {
            let merged = merge::merge(&list.positions, tolerance);
            report.merged_vertices = list.merge(&merged);
        }
        let kept_vertices = list.positions.len();
        clean::clean(&mut list, &mut report);
        double::drop_doubled(&mut list, &mut report);
        orient::orient(&mut list, &mut report);
        fans::split(&mut list, &mut report);
        let PolygonList { positions, corners, ends, vertices, faces, corner_origins } = list;
        let polygons = Polygons::of_parts(corners, ends);
        let mesh = Mesh::from_owned_polygons(positions, &polygons)?;
        Ok(Self { mesh, vertices, kept_vertices, faces, corners: corner_origins, report })
    }
}
