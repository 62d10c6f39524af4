//! Stale values: attributes of corners whose halfedges have moved since they were read.
//!
//! A texture coordinate belongs to a corner: a vertex in a face. Its halfedge keeps it when an
//! operation moves the halfedge to another corner, and a new halfedge has the default. Neither is
//! the value that the corner should have, unless the operation has set it, or the vertex had that
//! value in another face as well. So the places and values of a mesh are noted when it is read, and
//! compared when it is written. Meshes without such attributes have nothing to note.

use super::attribute::{ColumnId, Value};
use super::connectivity::Mesh;
use super::id::{ElementKind, FaceId, HalfedgeId, VertexId};

/// The attributes of vertices that describe the surface, as those of corners do.
const OF_SURFACE: [&str; 3] = ["uv", "normal", "color"];

/// The places and attributes of corners when a mesh was read, and the attributes of edges and faces
/// that the program does not know.
#[derive(Clone, Debug, Default)]
pub struct Places {
    columns: Vec<(ColumnId, String, Vec<Option<Value>>)>,
    unknown: Vec<(ColumnId, String, Vec<Option<Value>>)>,
    /// The vertex and the face of each halfedge, `None` in a hole; empty if no halfedge has
    /// attributes.
    corners: Vec<Option<(VertexId, FaceId)>>,
}

/// The number of corners that have a value of an attribute that is not their own.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Displaced {
    /// The name of the attribute.
    pub attribute: String,
    /// The number of corners that have kept the value of a place that they have left.
    pub kept: usize,
    /// The number of corners that are new and have the default.
    pub defaulted: usize,
    /// The number of faces with such corners, and that of all faces.
    pub faces: [usize; 2],
}

/// New edges or faces that have the default of an attribute that the file has and the program does
/// not know.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unset {
    pub kind: ElementKind,
    /// The name of the attribute.
    pub attribute: String,
    /// The number of these elements.
    pub count: usize,
}

impl Places {
    /// Notes the attributes of corners, those of vertices that describe the surface, and those of
    /// edges and faces that a program does not know by kind and name.
    pub fn of(mesh: &Mesh, is_known: impl Fn(ElementKind, &str) -> bool) -> Self {
        let values = |id: ColumnId| {
            let all = 0..mesh.capacity(id.kind) as u32;
            all.map(|index| mesh.value(id, index)).collect()
        };
        let (mut columns, mut unknown) = (Vec::new(), Vec::new());
        for (id, column) in mesh.public_columns() {
            let name = column.name();
            let noted = match id.kind {
                ElementKind::Halfedge => &mut columns,
                ElementKind::Vertex if OF_SURFACE.contains(&name) => &mut columns,
                ElementKind::Edge | ElementKind::Face if !is_known(id.kind, name) => &mut unknown,
                _ => continue,
            };
            noted.push((id, name.to_owned(), values(id)));
        }
        let of_corners = columns.iter().any(|(id, ..)| id.kind == ElementKind::Halfedge);
        let count = if of_corners { mesh.capacity(ElementKind::Halfedge) as u32 } else { 0 };
        let corners = (0..count).map(|h| corner(mesh, HalfedgeId(h))).collect();
        Self { columns, unknown, corners }
    }

    /// The attributes of which some corners have a value that is not their own, now that the mesh
    /// has changed. A value that has been set since counts as their own.
    pub fn displaced(&self, mesh: &Mesh) -> Vec<Displaced> {
        let columns = self.columns.iter();
        let told = columns.map(|(id, name, values)| self.of_column(mesh, *id, name, values));
        told.filter(|told| told.kept + told.defaulted > 0).collect()
    }

    /// The attributes of which new edges or faces have the default because nothing has set them.
    pub fn unset(&self, mesh: &Mesh) -> Vec<Unset> {
        let count = |(id, name, values): &(ColumnId, String, Vec<Option<Value>>)| {
            let default = mesh.column(*id).filter(|column| column.name() == name)?.default_value();
            let is_new = |index: &u32| {
                let was = values.get(*index as usize).copied().flatten();
                mesh.value(*id, *index) == Some(default) && was != Some(default)
            };
            let is_shown = |index: &u32| {
                id.kind == ElementKind::Edge || mesh.get_is_hole(FaceId(*index)) == Some(false)
            };
            let slots = 0..mesh.capacity(id.kind) as u32;
            let count = slots.filter(is_new).filter(is_shown).count();
            (count > 0).then(|| Unset { kind: id.kind, attribute: name.clone(), count })
        };
        self.unknown.iter().filter_map(count).collect()
    }

    /// The noted corners, sorted by vertex, each with the index of its halfedge.
    fn by_vertex(&self) -> Vec<(VertexId, usize)> {
        let corners = self.corners.iter().enumerate();
        let corners = corners.filter_map(|(index, corner)| Some(((*corner)?.0, index)));
        let mut corners: Vec<_> = corners.collect();
        corners.sort_unstable();
        corners
    }

    fn of_column(
        &self,
        mesh: &Mesh,
        id: ColumnId,
        name: &str,
        values: &[Option<Value>],
    ) -> Displaced {
        let mut told = Displaced {
            attribute: name.to_owned(),
            kept: 0,
            defaulted: 0,
            faces: [0, mesh.face_count()],
        };
        let Some(column) = mesh.column(id).filter(|column| column.name() == name) else {
            return told;
        };
        let default = Some(column.default_value());
        let known = if id.kind == ElementKind::Halfedge { self.by_vertex() } else { Vec::new() };
        let had = |vertex: VertexId, value: Option<Value>| {
            let first = known.partition_point(|&(of, _)| of < vertex);
            let mut here = known[first..].iter().take_while(|&&(of, _)| of == vertex);
            here.any(|&(_, index)| values.get(index).copied().flatten() == value)
        };
        for face in mesh.faces().filter(|&f| !mesh.is_hole(f)) {
            let before = told.kept + told.defaulted;
            for h in mesh.face_halfedges(face) {
                let vertex = mesh.vertex(h);
                let (index, place) = match id.kind {
                    ElementKind::Halfedge => (h.0, self.corners.get(h.index()).copied().flatten()),
                    _ => (vertex.0, None),
                };
                let was = values.get(index as usize).copied().flatten();
                let is = mesh.value(id, index);
                // A vertex, unlike a halfedge, cannot move to another place.
                let is_its_own = match id.kind {
                    ElementKind::Halfedge => place == corner(mesh, h) || had(vertex, is),
                    _ => was == is,
                };
                if is_its_own {
                    continue;
                } else if was == is {
                    told.kept += 1;
                } else if is == default {
                    told.defaulted += 1;
                }
            }
            told.faces[0] += usize::from(told.kept + told.defaulted > before);
        }
        told
    }
}

/// The place of a halfedge; `None` if it lies in a hole.
fn corner(mesh: &Mesh, h: HalfedgeId) -> Option<(VertexId, FaceId)> {
    let face = mesh.get_face(h)?;
    (!mesh.get_is_hole(face)?).then_some((mesh.get_vertex(h)?, face))
}
