//! The attributes that a file has a place for.
//!
//! | attribute | in the file |
//! | --- | --- |
//! | `color: vertex vec3` | three numbers behind the coordinates of each `v` |
//! | `uv: halfedge vec2` or `vec3` | `vt`, at the corner of its face where the halfedge starts |
//! | `normal: halfedge vec3` | `vn`, likewise |
//! | `uv: vertex …`, `normal: vertex vec3` | the same value at all corners of the vertex |
//!
//! Texture coordinates and normals stay [kept](super::kept) beside the mesh, corner by corner,
//! until somebody wants them as values: [`MeshFile::bring`] makes a column of them, and a column of
//! such a name is what is written from then on, one row for each value that occurs.

use std::collections::HashMap;

use glam::{DVec2, DVec3};

use super::format::FileFormat;
use super::kept::{MISSING, Rows};
use super::mesh_file::MeshFile;
use super::{msh, obj, off};
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId, VertexId};

/// The attributes of a corner besides its vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OfCorner {
    Texture,
    Normal,
}

impl OfCorner {
    const ALL: [Self; 2] = [Self::Texture, Self::Normal];

    fn name(self) -> &'static str {
        match self {
            Self::Texture => "uv",
            Self::Normal => "normal",
        }
    }

    fn can_be(self, ty: AttributeType) -> bool {
        match self {
            Self::Texture => matches!(ty, AttributeType::Vec2 | AttributeType::Vec3),
            Self::Normal => ty == AttributeType::Vec3,
        }
    }
}

/// An attribute that a program uses: its kind, name and default.
pub type WantedAttribute<'n> = (ElementKind, &'n str, Value);

impl MeshFile {
    /// Makes a column of texture coordinates or normals that the file has, or of the colours of
    /// its materials (`color: face vec3`), if this is how they are called. What the mesh has
    /// already stays as it is, but that whole numbers of a file become reals or truth values where
    /// these are wanted; a corner without a value has the default.
    pub fn bring(&mut self, (kind, name, default): WantedAttribute) {
        let ty = default.attribute_type();
        self.convert(kind, name, default);
        if (kind, name) == (ElementKind::Face, "color")
            && self.mesh.find_column(kind, name).is_none()
        {
            return self.bring_face_colors(default);
        }
        let mut all = OfCorner::ALL.into_iter();
        let of_corners = matches!(kind, ElementKind::Vertex | ElementKind::Halfedge);
        let Some(what) = all.find(|what| what.name() == name && what.can_be(ty)) else {
            return;
        };
        let known = self.mesh.find_column(kind, name).is_some();
        if !of_corners || known || self.kept_corners(what).is_empty() {
            return;
        }
        let Ok(column) = self.mesh.add_column(kind, name, default) else {
            return; // there is none of this name
        };
        let values: Vec<(u32, Value)> = match kind {
            ElementKind::Halfedge => {
                let all = self.mesh.halfedges();
                all.filter_map(|h| Some((h.0, value(ty, self.kept_value(what, h)?)))).collect()
            }
            _ => {
                let all = self.mesh.vertices();
                all.filter_map(|v| {
                    let mut corners = self.mesh.spokes(v);
                    let found = corners.find_map(|h| self.kept_value(what, h))?;
                    Some((v.0, value(ty, found)))
                })
                .collect()
            }
        };
        for (index, value) in values {
            let set = self.mesh.set_value(column, index, value);
            debug_assert!(set, "the element lives, and the value is of the column's type");
        }
    }

    /// Makes reals or truth values of a column of whole numbers, if the file says nothing of its
    /// type.
    fn convert(&mut self, kind: ElementKind, name: &str, default: Value) {
        let Some(old) = self.mesh.find_column(kind, name) else { return };
        let Some(numbers) = self.mesh.values::<i64>(old).map(<[i64]>::to_vec) else { return };
        let is_truth = numbers.iter().all(|&number| number == 0 || number == 1);
        let value = |number: i64| match default {
            Value::Real(_) => Some(Value::Real(number as f64)),
            Value::Bool(_) if is_truth => Some(Value::Bool(number == 1)),
            _ => None,
        };
        if value(0).is_none() {
            return;
        }
        self.mesh.remove_column(old);
        self.find_columns(); // their places have moved
        if let Ok(column) = self.mesh.add_column(kind, name, default) {
            for (index, value) in (0..).zip(numbers.into_iter().filter_map(value)) {
                self.mesh.put_value(column, index, value);
            }
        }
    }

    /// Makes columns of all texture coordinates and normals that the file has, at its corners, and
    /// of the colours of its materials.
    pub fn bring_all(&mut self) {
        let uv = match self.kept.texture.width {
            0..3 => Value::Vec2(DVec2::ZERO),
            _ => Value::Vec3(DVec3::ZERO),
        };
        self.bring((ElementKind::Halfedge, "uv", uv));
        let normal = Value::Vec3(DVec3::ZERO);
        self.bring((ElementKind::Halfedge, "normal", normal));
        self.bring((ElementKind::Face, "color", Value::Vec3(DVec3::ONE)));
    }

    /// The attributes of the mesh that a file of a format has no place for: kinds, names and
    /// types.
    pub fn unheld(&self, format: FileFormat) -> Vec<(ElementKind, &str, AttributeType)> {
        let held: Vec<Option<ColumnId>> = match format {
            FileFormat::Obj => {
                let corners = OfCorner::ALL.map(|what| self.written_column(what));
                obj::vertex_columns(self).into_iter().chain(corners).collect()
            }
            FileFormat::Off => off::columns(self).to_vec(),
            _ => Vec::new(),
        };
        let columns = self.mesh.sayable_columns();
        let unheld = columns.filter(|(id, column)| match format {
            FileFormat::Ply | FileFormat::Halfedges => false,
            FileFormat::Msh => !msh::is_held(id.kind, column.attribute_type()),
            _ => !held.contains(&Some(*id)),
        });
        unheld.map(|(id, column)| (id.kind, column.name(), column.attribute_type())).collect()
    }

    /// The parts of the file that was read which are not in the mesh, in words: a line each.
    pub fn losses(&self) -> Vec<String> {
        let mut told = Vec::new();
        let mut words = self.kept.told_passed_over().peekable();
        if let Some((_, line)) = words.peek().copied() {
            let shown: Vec<_> = words
                .map(|(word, _)| match word {
                    "l" => "lines (`l`)".to_owned(),
                    "p" => "points (`p`)".to_owned(),
                    _ => format!("`{word}`"),
                })
                .collect();
            told.push(format!("{}, first in line {line}, cannot be kept", shown.join(", ")));
        }
        told.extend(self.kept.notes.iter().map(ToString::to_string));
        told
    }

    /// The number of faces that are written without texture coordinates (`vt`), and how many
    /// without normals (`vn`), although the file had some: corners of theirs are not those of the
    /// file.
    pub fn bare_faces(&self) -> [usize; 2] {
        OfCorner::ALL.map(|what| {
            let kept = self.kept_corners(what);
            if kept.is_empty() || self.written_column(what).is_some() {
                return 0;
            }
            let all_had_one = kept.iter().all(|&row| row != MISSING);
            let corners = Corners::Kept { obj: self, what };
            let is_bare = |&f: &FaceId| {
                let mut sides = self.mesh.face_halfedges(f);
                let mut had =
                    || self.face_number(f).is_none() || sides.any(|h| corners.row(h).is_some());
                !corners.cover(&self.mesh, f) && (all_had_one || had())
            };
            let faces = self.mesh.faces().filter(|&f| !self.mesh.is_hole(f));
            faces.filter(is_bare).count()
        })
    }

    /// True if the file that was read has groups, objects, materials or smoothing groups that a
    /// file of a format has no place for.
    pub fn loses_groups(&self, format: FileFormat) -> bool {
        let has_more = |place: usize| self.kept.states.iter().any(|(_, s)| s.0[place] != MISSING);
        match format {
            FileFormat::Obj | FileFormat::Ply => false,
            FileFormat::Msh => {
                [0, 2, 3].into_iter().any(has_more) || !self.kept.libraries.is_empty()
            }
            _ => !self.kept.states.is_empty() || !self.kept.libraries.is_empty(),
        }
    }

    /// The column of colours.
    pub(super) fn color(&self) -> Option<ColumnId> {
        self.column_of_type(ElementKind::Vertex, "color", |ty| ty == AttributeType::Vec3)
    }

    /// The column that is written for `what`: that of the corners before that of the vertices.
    fn written_column(&self, what: OfCorner) -> Option<ColumnId> {
        let mut kinds = [ElementKind::Halfedge, ElementKind::Vertex].into_iter();
        kinds.find_map(|kind| self.column_of_type(kind, what.name(), |ty| what.can_be(ty)))
    }

    pub(super) fn column_of_type(
        &self,
        kind: ElementKind,
        name: &str,
        fits: impl Fn(AttributeType) -> bool,
    ) -> Option<ColumnId> {
        let id = self.mesh.find_column(kind, name)?;
        let column = self.mesh.column(id)?;
        fits(column.attribute_type()).then_some(id)
    }

    fn kept_corners(&self, what: OfCorner) -> &[u32] {
        match what {
            OfCorner::Texture => &self.kept.corner_texture,
            OfCorner::Normal => &self.kept.corner_normals,
        }
    }

    fn kept_rows(&self, what: OfCorner) -> &Rows {
        match what {
            OfCorner::Texture => &self.kept.texture,
            OfCorner::Normal => &self.kept.normals,
        }
    }

    /// The row of the file at the start of a halfedge in its face.
    fn kept_row(&self, what: OfCorner, h: HalfedgeId) -> Option<u32> {
        match what {
            OfCorner::Texture => self.texture_index(h),
            OfCorner::Normal => self.normal_index(h),
        }
    }

    fn kept_value(&self, what: OfCorner, h: HalfedgeId) -> Option<[f64; 3]> {
        let row = self.kept_row(what, h)?;
        self.kept_rows(what).rows.get(row as usize).copied()
    }
}

fn value(ty: AttributeType, [x, y, z]: [f64; 3]) -> Value {
    match ty {
        AttributeType::Vec2 => Value::Vec2(DVec2::new(x, y)),
        _ => Value::Vec3(DVec3::new(x, y, z)),
    }
}

/// The values of corners, as they are written: rows, and where they are used.
pub(super) enum Corners<'o> {
    /// As the file had it.
    Kept { obj: &'o MeshFile, what: OfCorner },
    /// The values of a column, each once, in the order of the faces.
    Values {
        rows: Rows,
        /// By halfedge.
        places: Vec<u32>,
    },
}

impl<'o> Corners<'o> {
    pub(super) fn of(obj: &'o MeshFile, what: OfCorner, faces: &[FaceId]) -> Self {
        let Some(column) = obj.written_column(what) else {
            return Self::Kept { obj, what };
        };
        let mesh = &obj.mesh;
        let is_flat = mesh.values::<DVec2>(column).is_some();
        let mut rows = Rows { rows: Vec::new(), width: if is_flat { 2 } else { 3 } };
        let mut places = vec![MISSING; mesh.capacity(ElementKind::Halfedge)];
        let mut known: HashMap<[u64; 3], u32> = HashMap::new();
        for h in faces.iter().flat_map(|&f| mesh.face_halfedges(f)) {
            let VertexId(vertex) = mesh.vertex(h);
            let of = match column.kind {
                ElementKind::Halfedge => h.0,
                _ => vertex,
            };
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

    pub(super) fn rows(&self) -> &Rows {
        match self {
            Self::Kept { obj, what } => obj.kept_rows(*what),
            Self::Values { rows, .. } => rows,
        }
    }

    /// True if all corners of a face have a row: only then the face is written with them.
    pub(super) fn cover(&self, mesh: &Mesh, f: FaceId) -> bool {
        let is_empty = self.rows().rows.is_empty();
        !is_empty && mesh.face_halfedges(f).all(|h| self.row(h).is_some())
    }

    /// The row at the start of a halfedge in its face.
    pub(super) fn row(&self, h: HalfedgeId) -> Option<u32> {
        match self {
            Self::Kept { obj, what } => obj.kept_row(*what, h),
            Self::Values { places, .. } => {
                let row = places.get(h.index()).copied();
                row.filter(|&row| row != MISSING)
            }
        }
    }
}
