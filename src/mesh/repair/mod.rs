//! Repair of polygon soups: building a mesh from polygons that are not one.
//!
//! The steps, in order; each is counted in the [`RepairReport`]:
//!
//! 1. vertices with a coordinate that is not finite are dropped, with the polygons that use them or
//!    a vertex that does not exist;
//! 2. on request, points within a tolerance become one vertex (`merge`);
//! 3. corners that repeat the previous one are dropped, a polygon that returns to one of its
//!    vertices becomes several, of which none covers a hole (`keyhole`), and what has fewer than
//!    three corners is dropped (`clean`);
//! 4. of polygons with the same corners in the same order only the first stays; likewise of two
//!    that are each other's back, where an edge has more than two polygons (`double`);
//! 5. neighbors across edges of two polygons are oriented consistently, by turning as few as
//!    possible in each connected part (`orient`);
//! 6. the surface is cut along edges of three polygons or more, except between two of them that are
//!    one sheet around one end, from where this continues along the line, and where turning does not
//!    help, as on a Möbius strip; a vertex becomes one for each fan of polygons around it (`fans`).
//!
//! Nothing is closed or filled, no point moves farther than the tolerance, and what is already a
//! mesh stays unchanged: so a second repair changes nothing. Corners, polygons and vertices record
//! their origins in the input, so that attributes attached to these can follow.
//!
//! The rules for dropping, turning and cutting are those of CGAL for polygon soups (S. Loriot, M.
//! Rouxel-Labbé, J. Tournois, I. O. Yaz, *Polygon Mesh Processing*, `orient_polygon_soup` after A.
//! Guéziec, G. Taubin, F. Lazarus, B. Horn, "Cutting and Stitching: Converting Sets of Polygons to
//! Manifold Surfaces", 2001). Each part is turned the way most of its polygons run, and another
//! corner is isolated where a cut edge would keep both ends in common.

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

/// The options of a repair.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Repair {
    /// Points that are no farther from each other than this become one vertex; with 0, only equal
    /// ones.
    pub merge: Option<f64>,
}

/// A mesh built from polygons, with the origins of its elements in the input.
#[derive(Clone, Debug)]
pub struct Repaired {
    pub mesh: Mesh,
    /// For each vertex of the mesh, that of the input. Kept vertices come first, then those that
    /// were split off.
    pub vertices: Vec<u32>,
    /// The number of vertices that were kept.
    pub kept_vertices: usize,
    /// For each face, the polygon of the input that it was, or was part of.
    pub faces: Vec<u32>,
    /// For each halfedge of the faces, the corner of the input that it was.
    pub corners: Vec<u32>,
    pub report: RepairReport,
}

/// How often each step of a repair did something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct RepairReport {
    /// Places of a file that cannot be read, skipped: their contents are missing.
    pub damaged_places: usize,
    /// Vertices with a coordinate that is not finite, dropped.
    pub dropped_vertices: usize,
    /// Vertices merged into others that are close enough.
    pub merged_vertices: usize,
    /// Corners that repeat the previous one, dropped.
    pub repeated_corners: usize,
    /// Edges along which polygons only go and come back, dropped.
    pub spurs: usize,
    /// Polygons divided where they return to a vertex.
    pub divided_faces: usize,
    /// Polygons with an unusable vertex or without three distinct corners, dropped.
    pub degenerate_faces: usize,
    /// Duplicate polygons, dropped.
    pub doubled_faces: usize,
    /// Polygons turned over.
    pub turned_faces: usize,
    /// Edges of three polygons or more, cut.
    pub crowded_edges: usize,
    /// Edges cut because their polygons cannot be oriented consistently.
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
            (self.spurs, "dropped", "spur edge", "spur edges", " of faces"),
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
    /// Builds a mesh from polygons, in an order that keeps neighbors near each other in memory,
    /// except for the vertices after the first `kept_vertices`; `None` if the polygons are not a
    /// mesh.
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

    /// Reorders the mesh in the same way.
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

    /// Builds a mesh from polygons, repairing whatever prevents it.
    ///
    /// # Errors
    /// Only [`BuildError::TooLarge`]: everything else is repaired.
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
