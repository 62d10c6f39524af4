//! A mesh with what its file said, and the numbers elements have there.
//!
//! The columns `obj:vertex` and `obj:face` hold the number of an element in the file it
//! came from, 0 for one that came later; `obj:corner` holds the place of a halfedge
//! among the corners of the file, counted from 1. A slot given to a new element has 0
//! again, so no new element is taken for an old one. Names with a colon are out of
//! reach of the language.

use glam::DVec3;

use super::kept::{Kept, MISSING};
use crate::mesh::attribute::{ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId, VertexId};

/// A mesh and what the file it came from said beyond it.
#[derive(Clone, Debug)]
pub struct MeshFile {
    pub mesh: Mesh,
    pub(super) kept: Kept,
    vertex_numbers: Option<ColumnId>,
    face_numbers: Option<ColumnId>,
    corners: Option<ColumnId>,
    /// Whether elements go by their ids: they come from tables, not from an OBJ file.
    by_ids: bool,
}

/// The number of every vertex and face in the file as it would be written now.
#[derive(Clone, Debug)]
pub struct WrittenNumbers {
    vertices: Vec<u32>,
    faces: Vec<u32>,
    pub(super) vertex_order: Vec<VertexId>,
    pub(super) face_order: Vec<FaceId>,
}

impl MeshFile {
    /// A mesh that comes from no file: everything in it is new.
    pub fn from_mesh(mesh: Mesh) -> Self {
        let kept = Kept::default();
        Self { mesh, kept, vertex_numbers: None, face_numbers: None, corners: None, by_ids: false }
    }

    /// A mesh whose file numbers its elements by their ids.
    pub fn from_tables(mesh: Mesh) -> Self {
        Self { by_ids: true, ..Self::from_mesh(mesh) }
    }

    /// A mesh just built from a file, its elements in the order of the file. `colors` is
    /// empty or has one for each vertex.
    pub(super) fn from_file(mesh: Mesh, kept: Kept, colors: &[[f64; 3]]) -> Self {
        let mut obj = Self::from_mesh(mesh);
        let vertices = obj.mesh.vertex_count();
        let faces = obj.mesh.face_count();
        obj.vertex_numbers = obj.number(ElementKind::Vertex, "obj:vertex", vertices);
        obj.face_numbers = obj.number(ElementKind::Face, "obj:face", faces);
        if !kept.corner_vertices.is_empty() {
            let corners = kept.corner_vertices.len();
            obj.corners = obj.number(ElementKind::Halfedge, "obj:corner", corners);
        }
        obj.kept = kept;
        if !colors.is_empty() {
            let white = Value::Vec3(DVec3::ONE);
            let column = obj.mesh.add_column(ElementKind::Vertex, "color", white);
            let values = column.ok().and_then(|column| obj.mesh.values_mut::<DVec3>(column));
            for (value, &color) in values.into_iter().flatten().zip(colors) {
                *value = DVec3::from_array(color);
            }
        }
        obj
    }

    /// A column that counts the first `count` slots from 1.
    fn number(&mut self, kind: ElementKind, name: &str, count: usize) -> Option<ColumnId> {
        let column = self.mesh.add_column(kind, name, Value::Int(0)).ok()?;
        let values = self.mesh.values_mut::<i64>(column)?;
        for (number, value) in (1..).zip(&mut values[..count]) {
            *value = number;
        }
        Some(column)
    }

    fn stored(&self, column: Option<ColumnId>, slot: usize) -> Option<u32> {
        let number = *self.mesh.values::<i64>(column?)?.get(slot)?;
        u32::try_from(number).ok().filter(|&number| number > 0)
    }

    /// The number of a vertex in the file it came from, if it did.
    pub fn vertex_number(&self, v: VertexId) -> Option<u32> {
        self.mesh.get_position(v)?;
        self.stored(self.vertex_numbers, v.index())
    }

    /// The number of a face among the faces of its file.
    pub fn face_number(&self, f: FaceId) -> Option<u32> {
        self.mesh.get_face_halfedge(f)?;
        self.stored(self.face_numbers, f.index())
    }

    /// The vertex that the file numbers so, if it still lives. What comes from a file
    /// stays in its slot.
    pub fn vertex_by_number(&self, number: u32) -> Option<VertexId> {
        if self.by_ids {
            return Some(VertexId(number)).filter(|&v| self.mesh.vertex_alive(v));
        }
        let v = VertexId(number.checked_sub(1)?);
        (self.vertex_number(v)? == number).then_some(v)
    }

    /// Whether elements go by their ids, as in tables.
    pub fn goes_by_ids(&self) -> bool {
        self.by_ids
    }

    /// The face that the file numbers so, if it still lives.
    pub fn face_by_number(&self, number: u32) -> Option<FaceId> {
        if self.by_ids {
            return Some(FaceId(number)).filter(|&f| self.mesh.face_alive(f));
        }
        let f = FaceId(number.checked_sub(1)?);
        (self.face_number(f)? == number).then_some(f)
    }

    /// The corner of the file that a halfedge still is: it starts at the same vertex.
    pub(super) fn corner(&self, h: HalfedgeId) -> Option<usize> {
        let corner = self.stored(self.corners, h.index())? as usize - 1;
        let vertex = *self.kept.corner_vertices.get(corner)?;
        let number = self.vertex_number(self.mesh.get_vertex(h)?)?;
        (number - 1 == vertex).then_some(corner)
    }

    /// The row of the file's texture coordinates at the start of `h` in its face, from 0.
    pub fn texture_index(&self, h: HalfedgeId) -> Option<u32> {
        let row = *self.kept.corner_texture.get(self.corner(h)?)?;
        (row != MISSING).then_some(row)
    }

    /// The row of the file's normals at the start of `h` in its face, from 0.
    pub fn normal_index(&self, h: HalfedgeId) -> Option<u32> {
        let row = *self.kept.corner_normals.get(self.corner(h)?)?;
        (row != MISSING).then_some(row)
    }

    /// The rows of `vt`; what a row leaves out is 0.
    pub fn texture_coordinates(&self) -> &[[f64; 3]] {
        &self.kept.texture.rows
    }

    /// The rows of `vn`.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.kept.normals.rows
    }

    /// The numbers in the file as it would be written now: what came from a file first,
    /// in its old order, then what is new. Holes have none.
    pub fn written_numbers(&self) -> WrittenNumbers {
        let (old, new): (Vec<_>, Vec<_>) =
            self.mesh.vertices().partition(|&v| self.vertex_number(v).is_some());
        let vertex_order: Vec<VertexId> = old.into_iter().chain(new).collect();
        let faces = self.mesh.faces().filter(|&f| !self.mesh.is_hole(f));
        let (old, new): (Vec<_>, Vec<_>) = faces.partition(|&f| self.face_number(f).is_some());
        let face_order: Vec<FaceId> = old.into_iter().chain(new).collect();
        let mut vertices = vec![MISSING; self.mesh.capacity(ElementKind::Vertex)];
        for (number, v) in (1..).zip(&vertex_order) {
            vertices[v.index()] = number;
        }
        let mut faces = vec![MISSING; self.mesh.capacity(ElementKind::Face)];
        for (number, f) in (1..).zip(&face_order) {
            faces[f.index()] = number;
        }
        WrittenNumbers { vertices, faces, vertex_order, face_order }
    }
}

impl WrittenNumbers {
    /// The numbers in tables: ids.
    pub fn of_tables(mesh: &Mesh) -> Self {
        let mut vertices = vec![MISSING; mesh.capacity(ElementKind::Vertex)];
        let mut faces = vec![MISSING; mesh.capacity(ElementKind::Face)];
        mesh.vertices().for_each(|v| vertices[v.index()] = v.0);
        mesh.faces().for_each(|f| faces[f.index()] = f.0);
        Self {
            vertices,
            faces,
            vertex_order: mesh.vertices().collect(),
            face_order: mesh.faces().collect(),
        }
    }

    pub fn vertex(&self, v: VertexId) -> Option<u32> {
        self.vertices.get(v.index()).copied().filter(|&number| number != MISSING)
    }

    /// The number of a face among the faces; a hole has none.
    pub fn face(&self, f: FaceId) -> Option<u32> {
        self.faces.get(f.index()).copied().filter(|&number| number != MISSING)
    }
}
