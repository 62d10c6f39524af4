//! Texture coordinates and normals of corners, as they are written.
//!
//! A corner of the file keeps its row. A new one, where an operation has turned or added a
//! halfedge, gets that of its vertex, if at each vertex of its face, and at all neighbors of these,
//! all corners of the file have the same values: no seam and no crease is near. Otherwise it gets
//! the row at its vertex in the polygons of the nearest corners of the file before and after it in
//! its face. If these are two polygons, they must share vertices, with the same values there, so
//! that no seam lies between them.

use std::collections::HashMap;

use glam::DVec2;

use super::kept::{MISSING, Rows};
use super::mesh_file::MeshFile;
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId, VertexId};

/// Polygons with more corners are not searched: a search for each corner would take too long.
const LARGEST: usize = 1024;

/// The attributes of a corner other than its vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OfCorner {
    Texture,
    Normal,
}

impl OfCorner {
    pub(super) const ALL: [Self; 2] = [Self::Texture, Self::Normal];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Texture => "uv",
            Self::Normal => "normal",
        }
    }

    pub(super) fn can_be(self, ty: AttributeType) -> bool {
        match self {
            Self::Texture => matches!(ty, AttributeType::Vec2 | AttributeType::Vec3),
            Self::Normal => ty == AttributeType::Vec3,
        }
    }
}

/// The values of corners as they are written: the rows, and the row of each corner.
pub(super) enum Corners<'o> {
    /// The rows of the file, and those of new corners, by halfedge.
    Kept { obj: &'o MeshFile, what: OfCorner, new: HashMap<u32, u32> },
    /// The distinct values of a column, in the order of the faces.
    Values {
        rows: Rows,
        /// By halfedge.
        places: Vec<u32>,
    },
}

impl<'o> Corners<'o> {
    pub(super) fn of(obj: &'o MeshFile, what: OfCorner, faces: &[FaceId]) -> Self {
        let Some(column) = obj.written_column(what) else {
            return Self::kept(obj, what, faces);
        };
        let mesh = &obj.mesh;
        let is_flat = mesh.values::<DVec2>(column).is_some();
        let mut rows = Rows { rows: Vec::new(), width: if is_flat { 2 } else { 3 } };
        let mut places = vec![MISSING; mesh.capacity(ElementKind::Halfedge)];
        let mut known: HashMap<[u64; 3], u32> = HashMap::new();
        for h in faces.iter().flat_map(|&f| mesh.face_halfedges(f)) {
            let VertexId(vertex) = mesh.vertex(h);
            let of = if column.kind == ElementKind::Halfedge { h.0 } else { vertex };
            let row = match mesh.value(column, of) {
                Some(Value::Vec2(at)) => [at.x, at.y, 0.0],
                Some(Value::Vec3(at)) => at.to_array(),
                _ => continue, // such a column holds nothing else
            };
            let next = rows.rows.len() as u32;
            let place = *known.entry(row.map(f64::to_bits)).or_insert(next);
            if place == next {
                rows.rows.push(row);
            }
            places[h.index()] = place;
        }
        Self::Values { rows, places }
    }

    /// The rows of the file, whatever columns there are.
    pub(super) fn kept(obj: &'o MeshFile, what: OfCorner, faces: &[FaceId]) -> Self {
        Self::Kept { obj, what, new: obj.new_rows(what, faces) }
    }

    pub(super) fn rows(&self) -> &Rows {
        match self {
            Self::Kept { obj, what, .. } => obj.kept_rows(*what),
            Self::Values { rows, .. } => rows,
        }
    }

    /// True if all corners of a face have a row: only then is the face written with them.
    pub(super) fn cover(&self, mesh: &Mesh, f: FaceId) -> bool {
        let is_empty = self.rows().rows.is_empty();
        !is_empty && mesh.face_halfedges(f).all(|h| self.row(h).is_some())
    }

    /// The row at the start of a halfedge in its face.
    pub(super) fn row(&self, h: HalfedgeId) -> Option<u32> {
        match self {
            Self::Kept { obj, what, new } => {
                obj.kept_row(*what, h).or_else(|| new.get(&h.0).copied())
            }
            Self::Values { places, .. } => {
                places.get(h.index()).copied().filter(|&row| row != MISSING)
            }
        }
    }
}

/// The numbers of faces that have no texture coordinates, or no normals, at some of their corners,
/// although others have them at all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BareFaces {
    /// Those of new corners.
    pub new: usize,
    /// Those that have them at other corners, as in the file.
    pub partial: usize,
    /// Those that have none, as in the file.
    pub without: usize,
}

impl MeshFile {
    /// The faces without texture coordinates at all corners, and those without normals.
    pub fn bare_faces(&self) -> [BareFaces; 2] {
        OfCorner::ALL.map(|what| {
            let mut bare = BareFaces::default();
            let kept = self.kept_corners(what);
            if kept.is_empty() || self.written_column(what).is_some() {
                return bare;
            }
            let all_had_one = kept.iter().all(|&row| row != MISSING);
            let is_face = |&f: &FaceId| !self.mesh.is_hole(f);
            let faces: Vec<_> = self.mesh.faces().filter(is_face).collect();
            let corners = Corners::of(self, what, &faces);
            for f in faces.into_iter().filter(|&f| !corners.cover(&self.mesh, f)) {
                let sides = || self.mesh.face_halfedges(f);
                let is_new = self.face_number(f).is_none();
                let has = all_had_one || sides().any(|h| corners.row(h).is_some());
                if is_new || has && sides().any(|h| self.corner(h).is_none()) {
                    bare.new += 1;
                } else if has {
                    bare.partial += 1;
                } else {
                    bare.without += 1;
                }
            }
            bare
        })
    }

    /// The column that is written for `what`: that of the corners if there is one, else that of the
    /// vertices.
    pub(super) fn written_column(&self, what: OfCorner) -> Option<ColumnId> {
        let mut kinds = [ElementKind::Halfedge, ElementKind::Vertex].into_iter();
        kinds.find_map(|kind| self.column_of_type(kind, what.name(), |ty| what.can_be(ty)))
    }

    pub(super) fn kept_corners(&self, what: OfCorner) -> &[u32] {
        match what {
            OfCorner::Texture => &self.kept.corner_texture,
            OfCorner::Normal => &self.kept.corner_normals,
        }
    }

    pub(super) fn kept_rows(&self, what: OfCorner) -> &Rows {
        match what {
            OfCorner::Texture => &self.kept.texture,
            OfCorner::Normal => &self.kept.normals,
        }
    }

    /// The row of the file at the start of a halfedge in its face.
    pub(super) fn kept_row(&self, what: OfCorner, h: HalfedgeId) -> Option<u32> {
        let row = *self.kept_corners(what).get(self.corner(h)?)?;
        (row != MISSING).then_some(row)
    }
}

/// New corners.
impl MeshFile {
    /// The rows of corners that are not from the file, by halfedge.
    pub(super) fn new_rows(&self, what: OfCorner, faces: &[FaceId]) -> HashMap<u32, u32> {
        let mut new = HashMap::new();
        if self.kept_corners(what).is_empty() {
            return new;
        }
        let mut of_vertices: Option<Vec<u32>> = None;
        let mut sides: Vec<(HalfedgeId, Option<usize>)> = Vec::new();
        for &f in faces {
            sides.clear();
            sides.extend(self.mesh.face_halfedges(f).map(|h| (h, self.corner(h))));
            if sides.iter().any(|(_, corner)| corner.is_none()) {
                let rows = of_vertices.get_or_insert_with(|| self.rows_of_vertices(what));
                let row = |&(h, _): &(HalfedgeId, _)| {
                    let row = *rows.get(self.vertex_place(self.mesh.vertex(h))?)?;
                    (row != MISSING).then_some((h.0, row))
                };
                if let Some(found) = sides.iter().map(row).collect::<Option<Vec<_>>>() {
                    new.extend(found);
                    continue;
                }
            }
            let Some(first) = sides.iter().position(|(_, corner)| corner.is_some()) else {
                continue;
            };
            sides.rotate_left(first);
            sides.push(sides[0]);
            // Between two successive corners of the file, all are new.
            let mut rest = &sides[..];
            while let [(_, Some(before)), others @ ..] = rest {
                let count = others.iter().take_while(|(_, corner)| corner.is_none()).count();
                let (between, behind) = others.split_at(count);
                if let (false, [(_, Some(behind)), ..]) = (between.is_empty(), behind)
                    && let Some(polygons) = self.polygons_without_seam(what, [*before, *behind])
                {
                    new.extend(between.iter().filter_map(|&(h, _)| {
                        let vertex = self.vertex_place(self.mesh.vertex(h))? as u32;
                        Some((h.0, polygons.iter().find_map(|polygon| polygon.row(vertex))?))
                    }));
                }
                rest = behind;
            }
        }
        new
    }

    /// For each vertex of the file, the row of its corners, if these, and those of each of its
    /// neighbors, all have the same values.
    fn rows_of_vertices(&self, what: OfCorner) -> Vec<u32> {
        let mut rows = vec![MISSING; self.mesh.capacity(ElementKind::Vertex)];
        let mut several = vec![false; rows.len()];
        let value = |row: u32| self.kept_rows(what).rows.get(row as usize);
        let corners = self.kept.corners.corners().iter().zip(self.kept_corners(what));
        for (&vertex, &row) in corners.filter(|&(_, &row)| row != MISSING) {
            let Some(known) = rows.get_mut(vertex as usize) else { continue };
            match *known {
                MISSING => *known = row,
                known => several[vertex as usize] |= value(known) != value(row),
            }
        }
        let at_seam =
            |polygon: &[u32]| polygon.iter().any(|&v| several.get(v as usize) == Some(&true));
        for &vertex in self.kept.corners.iter().filter(|polygon| at_seam(polygon)).flatten() {
            if let Some(row) = rows.get_mut(vertex as usize) {
                *row = MISSING;
            }
        }
        rows
    }

    /// The polygons of two corners of the file, if no seam lies between them: they are the same, or
    /// share vertices and have the same values there.
    fn polygons_without_seam(
        &self,
        what: OfCorner,
        [one, other]: [usize; 2],
    ) -> Option<[KeptPolygon<'_>; 2]> {
        let (one, other) = (self.polygon(what, one)?, self.polygon(what, other)?);
        let value = |row: u32| self.kept_rows(what).rows.get(row as usize);
        let corners = one.vertices.iter().zip(one.rows);
        let mut shared = corners.filter_map(|(&v, &row)| Some((row, other.row(v)?))).peekable();
        let has_no_seam = one.first == other.first
            || shared.peek().is_some() && shared.all(|(a, b)| value(a) == value(b));
        has_no_seam.then_some([one, other])
    }

    /// The polygon of the file that has a corner.
    fn polygon(&self, what: OfCorner, corner: usize) -> Option<KeptPolygon<'_>> {
        let ends = self.kept.corners.ends();
        let place = ends.partition_point(|&end| end <= corner);
        let vertices = self.kept.corners.get(place)?;
        let first = ends[place] - vertices.len();
        let rows = self.kept_corners(what).get(first..ends[place])?;
        (vertices.len() <= LARGEST).then_some(KeptPolygon { first, vertices, rows })
    }
}

/// A polygon of the file: the index of its first corner, its vertices and its rows.
struct KeptPolygon<'f> {
    first: usize,
    vertices: &'f [u32],
    rows: &'f [u32],
}

impl KeptPolygon<'_> {
    /// The row at a vertex.
    fn row(&self, vertex: u32) -> Option<u32> {
        let corner = self.vertices.iter().position(|&v| v == vertex)?;
        self.rows.get(corner).copied().filter(|&row| row != MISSING)
    }
}
