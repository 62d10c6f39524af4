//! A mesh with the other contents of its file, and the numbers that elements have there.
//!
//! Elements that were read have the first slots, in the order of the file. The columns
//! `file:vertex` and `file:face` mark the slots that still hold what was read, and `file:corner`
//! the halfedges that are corners. A slot given to a new element has `false`, so no new element is
//! taken for an old one. The language cannot use names with a colon. If the polygons of the file
//! were repaired or reordered, tables give the number in the file for each slot.

use std::collections::BTreeSet;
use std::path::PathBuf;

use super::corners::OfCorner;
use super::format::{Encoding, MshVersion};
use super::kept::{Kept, MISSING};
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId, VertexId};
use crate::mesh::repair::RepairReport;

/// A mesh, and the contents of its file that the mesh cannot represent.
#[derive(Clone, Debug)]
pub struct MeshFile {
    pub mesh: Mesh,
    pub(super) kept: Kept,
    vertex_numbers: Option<ColumnId>,
    face_numbers: Option<ColumnId>,
    corners: Option<ColumnId>,
    /// True if elements are numbered by their ids: they come from tables, not from a list of
    /// polygons.
    by_ids: bool,
    /// The places in the file of what was read, where these differ from the slots: vertices, faces.
    renumbered: Option<[Renumbered; 2]>,
    /// The folder of the file, to find files that it names.
    pub(super) folder: Option<PathBuf>,
    /// The report of the repair when the file was read, if one was requested.
    pub repaired: Option<RepairReport>,
    /// The first damaged place that the repair skipped: its line, and what is wrong with it.
    pub damage: Option<(Option<u32>, String)>,
    /// The encoding for writing: that of the file, if its format has one. A binary Gmsh file counts
    /// as text.
    pub encoding: Encoding,
    /// The version that a Gmsh file is written in: that of the file, if it was one.
    pub msh_version: MshVersion,
}

/// Slots, each with its place in the file.
#[derive(Clone, Debug)]
struct Renumbered {
    places: Vec<u32>,
    /// The slots in the order of their places, if they are not sorted.
    in_order: Option<Vec<u32>>,
}

impl Renumbered {
    fn new(places: Vec<u32>) -> Self {
        let in_order = (!places.is_sorted()).then(|| {
            let keys = (0_u64..).zip(&places).map(|(slot, &place)| u64::from(place) << 32 | slot);
            let mut keys: Vec<u64> = keys.collect();
            keys.sort_unstable();
            keys.into_iter().map(|key| key as u32).collect()
        });
        Self { places, in_order }
    }

    /// The first slot with this place or, if there is none, with the next place.
    fn slot(&self, place: u32) -> Option<u32> {
        let Some(slots) = &self.in_order else {
            return Some(self.places.partition_point(|&other| other < place) as u32);
        };
        let first = slots.partition_point(|&slot| self.places[slot as usize] < place);
        slots.get(first).copied()
    }
}

/// The number of every vertex and face in the file if it were written now.
#[derive(Clone, Debug)]
pub struct WrittenNumbers {
    vertices: Vec<u32>,
    faces: Vec<u32>,
    pub(super) vertex_order: Vec<VertexId>,
    pub(super) face_order: Vec<FaceId>,
}

impl MeshFile {
    /// A mesh that comes from no file: all its elements are new.
    pub fn from_mesh(mesh: Mesh) -> Self {
        let kept = Kept::default();
        Self {
            mesh,
            kept,
            vertex_numbers: None,
            face_numbers: None,
            corners: None,
            by_ids: false,
            renumbered: None,
            folder: None,
            repaired: None,
            damage: None,
            encoding: Encoding::default(),
            msh_version: MshVersion::default(),
        }
    }

    /// A mesh whose file numbers its elements by their ids.
    pub fn from_tables(mesh: Mesh) -> Self {
        Self { by_ids: true, ..Self::from_mesh(mesh) }
    }

    /// A mesh just built from polygons, with the numbers of a file of these polygons.
    pub fn from_polygons(mesh: Mesh) -> Self {
        Self::from_file(mesh, Kept::default())
    }

    /// A mesh just built from a file, its elements in the order of their slots.
    pub(super) fn from_file(mesh: Mesh, kept: Kept) -> Self {
        let mut file = Self::from_mesh(mesh);
        let vertices = file.mesh.vertex_count();
        let faces = file.mesh.face_count();
        file.vertex_numbers = file.number(ElementKind::Vertex, "file:vertex", vertices);
        file.face_numbers = file.number(ElementKind::Face, "file:face", faces);
        let corners = kept.corners.corners().len();
        if corners > 0 {
            file.corners = file.number(ElementKind::Halfedge, "file:corner", corners);
        }
        file.kept = kept;
        file
    }

    /// Looks up the columns of numbers again, after another column was removed.
    pub(super) fn find_columns(&mut self) {
        let find = |kind, name| self.mesh.find_column(kind, name);
        let vertices = find(ElementKind::Vertex, "file:vertex");
        let faces = find(ElementKind::Face, "file:face");
        let corners = find(ElementKind::Halfedge, "file:corner");
        (self.vertex_numbers, self.face_numbers, self.corners) = (vertices, faces, corners);
    }

    /// Sets the places in the file of the first vertices, and those of all faces.
    pub(super) fn renumber(&mut self, vertices: Vec<u32>, faces: Vec<u32>) {
        self.renumbered = Some([vertices, faces].map(Renumbered::new));
    }

    /// A column that is true in the first `count` slots.
    fn number(&mut self, kind: ElementKind, name: &str, count: usize) -> Option<ColumnId> {
        let column = self.mesh.add_column(kind, name, Value::Bool(false)).ok()?;
        self.mesh.values_mut::<bool>(column)?[..count].fill(true);
        Some(column)
    }

    /// The slot itself, if its element was read.
    fn stored(&self, column: Option<ColumnId>, slot: usize) -> Option<usize> {
        self.mesh.values::<bool>(column?)?.get(slot)?.then_some(slot)
    }

    /// The column with the given name, if its type fits.
    pub(super) fn column_of_type(
        &self,
        kind: ElementKind,
        name: &str,
        fits: impl Fn(AttributeType) -> bool,
    ) -> Option<ColumnId> {
        let id = self.mesh.find_column(kind, name)?;
        fits(self.mesh.column(id)?.attribute_type()).then_some(id)
    }

    /// The place of a vertex among those that were read, from 0, if it was read.
    pub(super) fn vertex_place(&self, v: VertexId) -> Option<usize> {
        self.mesh.get_position(v)?;
        self.stored(self.vertex_numbers, v.index())
    }

    /// The place of a face among those that were read, from 0, if it was read.
    pub(super) fn face_place(&self, f: FaceId) -> Option<usize> {
        self.mesh.get_face_halfedge(f)?;
        self.stored(self.face_numbers, f.index())
    }

    /// The number of a vertex in its file, if it came from one.
    pub fn vertex_number(&self, v: VertexId) -> Option<u32> {
        let place = self.vertex_place(v)?;
        Some(match &self.renumbered {
            Some([vertices, _]) => vertices.places.get(place)? + 1,
            None => place as u32 + 1,
        })
    }

    /// The number of a face among the faces of its file.
    pub fn face_number(&self, f: FaceId) -> Option<u32> {
        let place = self.face_place(f)?;
        Some(self.file_place(place as u32) + 1)
    }

    /// The place of a face in the file, from 0, from its place among those that were read.
    pub(super) fn file_place(&self, place: u32) -> u32 {
        let faces = self.renumbered.as_ref().map(|[_, faces]| &faces.places);
        faces.and_then(|places| places.get(place as usize).copied()).unwrap_or(place)
    }

    /// The vertex with this number in the file, if it is still alive. Elements from a file stay in
    /// their slots.
    pub fn vertex_by_number(&self, number: u32) -> Option<VertexId> {
        if self.by_ids {
            return Some(VertexId(number)).filter(|&v| self.mesh.vertex_alive(v));
        }
        let place = number.checked_sub(1)?;
        let v = VertexId(match &self.renumbered {
            Some([vertices, _]) => vertices.slot(place)?,
            None => place,
        });
        (self.vertex_number(v)? == number).then_some(v)
    }

    /// True if elements are numbered by their ids, as in tables.
    pub fn goes_by_ids(&self) -> bool {
        self.by_ids
    }

    /// The face with this number in the file, if it is still alive; the first if it was divided.
    pub fn face_by_number(&self, number: u32) -> Option<FaceId> {
        if self.by_ids {
            return Some(FaceId(number)).filter(|&f| self.mesh.face_alive(f));
        }
        let place = number.checked_sub(1)?;
        let f = FaceId(match &self.renumbered {
            Some([_, faces]) => faces.slot(place)?,
            None => place,
        });
        (self.face_number(f)? == number).then_some(f)
    }

    /// The corner of the file that a halfedge was.
    pub(super) fn original_corner(&self, h: HalfedgeId) -> Option<usize> {
        self.stored(self.corners, h.index())
    }

    /// The corner of the file that a halfedge still is: it starts at the same vertex.
    pub(super) fn corner(&self, h: HalfedgeId) -> Option<usize> {
        let corner = self.original_corner(h)?;
        let vertex = *self.kept.corners.corners().get(corner)?;
        (self.vertex_place(self.mesh.get_vertex(h)?)? == vertex as usize).then_some(corner)
    }

    /// The names of the objects, groups, materials and smoothing groups that the file has.
    pub fn named_parts(&self) -> [Vec<&[u8]>; 4] {
        std::array::from_fn(|keyword| {
            let places = self.kept.states.iter().map(|(_, state)| state.0[keyword]);
            let places: BTreeSet<u32> = places.collect();
            let names = places.iter().filter_map(|&place| self.kept.names.get(place as usize));
            let names: BTreeSet<&[u8]> = names.map(Vec::as_slice).collect();
            names.into_iter().collect()
        })
    }

    /// The row of the file's texture coordinates at the start of `h` in its face, from 0.
    pub fn texture_index(&self, h: HalfedgeId) -> Option<u32> {
        self.kept_row(OfCorner::Texture, h)
    }

    /// The row of the file's normals at the start of `h` in its face, from 0.
    pub fn normal_index(&self, h: HalfedgeId) -> Option<u32> {
        self.kept_row(OfCorner::Normal, h)
    }

    /// The rows of `vt`; missing numbers are 0.
    pub fn texture_coordinates(&self) -> &[[f64; 3]] {
        &self.kept.texture.rows
    }

    /// The rows of `vn`.
    pub fn normals(&self) -> &[[f64; 3]] {
        &self.kept.normals.rows
    }

    /// The numbers in the file if it were written now: what came from a file first, in its old
    /// order, then what is new. Holes have none.
    pub fn written_numbers(&self) -> WrittenNumbers {
        let (mut old, new): (Vec<_>, Vec<_>) =
            self.mesh.vertices().partition(|&v| self.vertex_place(v).is_some());
        if self.renumbered.is_some() {
            old.sort_by_cached_key(|&v| self.vertex_number(v).unwrap_or(MISSING));
        }
        let vertex_order: Vec<VertexId> = old.into_iter().chain(new).collect();
        let faces = self.mesh.faces().filter(|&f| !self.mesh.is_hole(f));
        let (mut old, new): (Vec<_>, Vec<_>) = faces.partition(|&f| self.face_place(f).is_some());
        if self.renumbered.is_some() {
            old.sort_by_cached_key(|&f| self.face_number(f).unwrap_or(MISSING));
        }
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
    /// The numbers in tables, which are ids.
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

    /// The number of a face among the faces; `None` for a hole.
    pub fn face(&self, f: FaceId) -> Option<u32> {
        self.faces.get(f.index()).copied().filter(|&number| number != MISSING)
    }
}
