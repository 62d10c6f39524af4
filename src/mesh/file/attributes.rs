//! The attributes that a file can hold.
//!
//! | attribute | in the file |
//! | --- | --- |
//! | `color: vertex vec3` | three numbers after the coordinates of each `v` |
//! | `uv: halfedge vec2` or `vec3` | `vt`, at the corner of its face where the halfedge starts |
//! | `normal: halfedge vec3` | `vn`, likewise |
//! | `uv: vertex …`, `normal: vertex vec3` | the same value at all corners of the vertex |
//!
//! Texture coordinates and normals stay [kept](super::kept) beside the mesh, corner by corner,
//! until they are requested as values: [`MeshFile::bring`] makes a column of them, and a column of
//! such a name is what is written from then on, one row for each distinct value.

use glam::{DVec2, DVec3};

use super::corners::OfCorner;
use super::format::FileFormat;
use super::kept::{MISSING, State};
use super::mesh_file::MeshFile;
use super::{msh, obj, off, stl};
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId};

/// An attribute that a program uses: kind, name and default.
pub type WantedAttribute<'n> = (ElementKind, &'n str, Value);

impl MeshFile {
    /// Makes a column of the texture coordinates or normals that the file has, or of the colours of
    /// its materials (`color: face vec3`), if the attribute is one of these. A column that the mesh
    /// already has stays unchanged, except that whole numbers of a file become reals or truth
    /// values where these are wanted and all of them can; a corner without a value gets the default.
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
        let Some(what) = all.find(|what| what.name() == name && what.can_be(ty)) else { return };
        let known = self.mesh.find_column(kind, name).is_some();
        if !of_corners || known || self.kept_corners(what).is_empty() {
            return;
        }
        let Ok(column) = self.mesh.add_column(kind, name, default) else {
            return; // there is none of this name
        };
        let faces: Vec<FaceId> = self.mesh.faces().filter(|&f| !self.mesh.is_hole(f)).collect();
        let new = self.new_rows(what, &faces);
        let at = |h: HalfedgeId| {
            let row = self.kept_row(what, h).or_else(|| new.get(&h.0).copied())?;
            Some(value(ty, *self.kept_rows(what).rows.get(row as usize)?))
        };
        let values: Vec<(u32, Value)> = match kind {
            ElementKind::Halfedge => {
                self.mesh.halfedges().filter_map(|h| Some((h.0, at(h)?))).collect()
            }
            _ => {
                let all = self.mesh.vertices();
                all.filter_map(|v| Some((v.0, self.mesh.spokes(v).find_map(at)?))).collect()
            }
        };
        for (index, value) in values {
            let set = self.mesh.set_value(column, index, value);
            debug_assert!(set, "the element lives, and the value is of the column's type");
        }
    }

    /// Converts a column of whole numbers to reals or truth values, as the default is.
    fn convert(&mut self, kind: ElementKind, name: &str, default: Value) {
        let Some(old) = self.mesh.find_column(kind, name) else { return };
        let Some(numbers) = self.mesh.values::<i64>(old).map(<[i64]>::to_vec) else { return };
        let is_truth = numbers.iter().all(|&number| number == 0 || number == 1);
        let is_exact = numbers.iter().all(|&number| number as f64 as i128 == i128::from(number));
        let value = |number: i64| match default {
            Value::Real(_) if is_exact => Some(Value::Real(number as f64)),
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

    /// Makes columns of all texture coordinates and normals of the file, at its corners, and of the
    /// colours of its materials ([`MeshFile::bring_colors`]).
    pub fn bring_all(&mut self) {
        let uv = match self.kept.texture.width {
            0..3 => Value::Vec2(DVec2::ZERO),
            _ => Value::Vec3(DVec3::ZERO),
        };
        self.bring((ElementKind::Halfedge, "uv", uv));
        let normal = Value::Vec3(DVec3::ZERO);
        self.bring((ElementKind::Halfedge, "normal", normal));
        self.bring_colors();
    }

    /// Makes a column of the colours of the materials of the file.
    pub fn bring_colors(&mut self) {
        self.bring((ElementKind::Face, "color", Value::Vec3(DVec3::ONE)));
    }

    /// Makes attributes of vertices of the texture coordinates and normals of corners, where a file
    /// of the format holds these alone and all corners of each vertex agree. Returns their names.
    pub fn gather(&mut self, format: FileFormat) -> Vec<&'static str> {
        let mut all = vec![("uv", AttributeType::Vec2), ("normal", AttributeType::Vec3)];
        all.retain(|&(name, ty)| format == FileFormat::Off && self.gather_one(name, ty));
        all.into_iter().map(|(name, _)| name).collect()
    }

    fn gather_one(&mut self, name: &str, ty: AttributeType) -> bool {
        let corners = self.column_of_type(ElementKind::Halfedge, name, |has| has == ty);
        let Some((id, column)) = corners.and_then(|id| Some((id, self.mesh.column(id)?))) else {
            return false;
        };
        let (mesh, default) = (&self.mesh, column.default_value());
        let value = |v| {
            let corners = mesh.spokes(v).filter(|&h| !mesh.is_hole(mesh.face(h)));
            let mut values = corners.filter_map(|h| mesh.value(id, h.0));
            let first = values.next().unwrap_or(default);
            values.all(|other| other.is_identical(first)).then_some((v.0, first))
        };
        let values: Option<Vec<_>> = mesh.vertices().map(value).collect();
        let (Some(values), None) = (values, mesh.find_column(ElementKind::Vertex, name)) else {
            return false;
        };
        self.mesh.remove_column(id);
        self.find_columns(); // their places have moved
        if let Ok(column) = self.mesh.add_column(ElementKind::Vertex, name, default) {
            for (index, value) in values {
                self.mesh.put_value(column, index, value);
            }
        }
        true
    }

    /// The attributes of the mesh that a file of a format cannot hold: kinds, names and types. Of
    /// those that are zero or false everywhere nothing is lost.
    pub fn unheld(&self, format: FileFormat) -> Vec<(ElementKind, &str, AttributeType)> {
        let held: Vec<Option<ColumnId>> = match format {
            FileFormat::Obj => {
                let corners = OfCorner::ALL.map(|what| self.written_column(what));
                obj::vertex_columns(self).into_iter().chain(corners).collect()
            }
            FileFormat::Off => off::columns(self).to_vec(),
            _ => Vec::new(),
        };
        let unheld = self.mesh.public_columns().filter(|(id, column)| match format {
            FileFormat::Ply | FileFormat::Halfedges => false,
            FileFormat::Msh => !msh::is_held(id.kind, column.attribute_type()),
            _ => !held.contains(&Some(*id)),
        });
        let unheld = unheld.filter(|(id, column)| {
            let zero = column.attribute_type().zero();
            let mut values =
                (0..self.mesh.capacity(id.kind)).filter_map(|at| self.mesh.value(*id, at as u32));
            values.any(|value| !value.is_identical(zero))
        });
        unheld.map(|(id, column)| (id.kind, column.name(), column.attribute_type())).collect()
    }

    /// The parts of the file that are not in the mesh, in words: one line each.
    pub fn losses(&self) -> Vec<String> {
        let mut told = Vec::new();
        let mut words = self.kept.skipped_keywords().peekable();
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

    /// What a file of a format cannot hold of the objects, groups, materials, smoothing groups and
    /// texture files of the file that was read, in the plural.
    pub fn lost_groups(&self, format: FileFormat) -> Vec<&'static str> {
        let has = |place: usize| match place {
            2 if !self.kept.libraries.is_empty() => true,
            _ => self.kept.states.iter().any(|(_, state)| state.0[place] != MISSING),
        };
        let is_held = |place: usize| match format {
            FileFormat::Obj | FileFormat::Ply => true,
            FileFormat::Msh => place == 1,
            _ => false,
        };
        let lost = State::NAMED.into_iter().enumerate().filter(|(place, _)| !is_held(*place));
        let mut lost: Vec<_> =
            lost.filter(|(place, _)| has(*place)).map(|(_, word)| word).collect();
        let names_texture = |comment: &Vec<u8>| comment.starts_with(b"comment TextureFile");
        if format != FileFormat::Ply && self.kept.comments.iter().any(names_texture) {
            lost.push("texture files");
        }
        lost
    }

    /// The number of vertices that a file of a format cannot distinguish from another one, since
    /// they have the same position, and of those that it leaves out, since they have no face.
    pub fn lost_vertices(&self, format: FileFormat) -> [usize; 2] {
        if format == FileFormat::Stl { stl::lost_vertices(self) } else { [0; 2] }
    }

    /// The column of colours.
    pub(super) fn color(&self) -> Option<ColumnId> {
        self.column_of_type(ElementKind::Vertex, "color", |ty| ty == AttributeType::Vec3)
    }
}

fn value(ty: AttributeType, [x, y, z]: [f64; 3]) -> Value {
    match ty {
        AttributeType::Vec2 => Value::Vec2(DVec2::new(x, y)),
        _ => Value::Vec3(DVec3::new(x, y, z)),
    }
}
