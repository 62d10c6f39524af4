//! The tables of a mesh as arrays, by the numbers of elements; -1 where there is nothing.

use hedgerow::mesh::{ElementKind, FaceId, HalfedgeRecord, Mesh, VertexId};
use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;

use super::element::one;

/// The number that stands for no element.
const NOTHING: i64 = -1;

/// The pointer of a name, for each slot of a kind.
pub fn pointers(mesh: &Mesh, kind: ElementKind, name: &str) -> PyResult<Vec<i64>> {
    let id = |id: u32| if id == u32::MAX { NOTHING } else { i64::from(id) };
    let none = || {
        let message = format!("{} has no pointer `{name}`", one(kind));
        PyAttributeError::new_err(message)
    };
    if kind == ElementKind::Halfedge {
        let of: fn(&HalfedgeRecord) -> u32 = match name {
            "next" => |record| record.next.0,
            "prev" => |record| record.prev.0,
            "twin" => |record| record.twin.0,
            "vertex" => |record| record.vertex.0,
            "edge" => |record| record.edge.0,
            "face" => |record| record.face.0,
            _ => return Err(none()),
        };
        let mut all = vec![NOTHING; mesh.capacity(kind)];
        let records = mesh.halfedge_records();
        for halfedge in mesh.halfedges() {
            all[halfedge.index()] = id(of(&records[halfedge.index()]));
        }
        return Ok(all);
    }
    if name != "halfedge" {
        return Err(none());
    }
    let mut all = vec![NOTHING; mesh.capacity(kind)];
    match kind {
        ElementKind::Vertex => {
            mesh.vertices().for_each(|v| all[v.index()] = id(mesh.vertex_halfedge(v).0));
        }
        ElementKind::Edge => {
            mesh.edges().for_each(|e| all[e.index()] = id(mesh.edge_halfedge(e).0));
        }
        _ => mesh.faces().for_each(|f| all[f.index()] = id(mesh.face_halfedge(f).0)),
    }
    Ok(all)
}

/// For each slot of a kind whether there is an element; holes count as faces.
pub fn living(mesh: &Mesh, kind: ElementKind) -> Vec<bool> {
    let mut all = vec![false; mesh.capacity(kind)];
    match kind {
        ElementKind::Vertex => mesh.vertices().for_each(|v| all[v.index()] = true),
        ElementKind::Halfedge => mesh.halfedges().for_each(|h| all[h.index()] = true),
        ElementKind::Edge => mesh.edges().for_each(|e| all[e.index()] = true),
        ElementKind::Face => mesh.faces().for_each(|f| all[f.index()] = true),
    }
    all
}

/// For each slot of a face whether it is a hole.
pub fn holes(mesh: &Mesh) -> Vec<bool> {
    let mut all = vec![false; mesh.capacity(ElementKind::Face)];
    mesh.holes().for_each(|hole| all[hole.index()] = true);
    all
}

/// The two vertices of each slot of an edge, those of its halfedge first; -1 where there is none.
pub fn ends(mesh: &Mesh) -> Vec<i64> {
    let mut all = vec![NOTHING; 2 * mesh.capacity(ElementKind::Edge)];
    for edge in mesh.edges() {
        let halfedge = mesh.edge_halfedge(edge);
        let ends = [mesh.vertex(halfedge), mesh.vertex(mesh.twin(halfedge))];
        let place = &mut all[2 * edge.index()..][..2];
        place.copy_from_slice(&ends.map(|VertexId(end)| i64::from(end)));
    }
    all
}

/// The corners of the faces in the rows of the living vertices, and where each face ends; holes are
/// left out. `numbered` keeps the numbers of the vertices.
pub fn polygons(mesh: &Mesh, numbered: bool) -> (Vec<i64>, Vec<i64>) {
    let mut rows = Vec::new();
    if !numbered && mesh.vertex_count() < mesh.capacity(ElementKind::Vertex) {
        rows = vec![NOTHING; mesh.capacity(ElementKind::Vertex)];
        for (row, vertex) in (0..).zip(mesh.vertices()) {
            rows[vertex.index()] = row;
        }
    }
    let mut corners = Vec::with_capacity(mesh.halfedge_count());
    let mut ends = Vec::with_capacity(mesh.face_count());
    let records = mesh.halfedge_records();
    for face in mesh.faces().filter(|&face| !mesh.is_hole(face)) {
        corner_walk(mesh, records, face, |vertex| {
            corners.push(rows.get(vertex.index()).copied().unwrap_or(i64::from(vertex.0)));
        });
        ends.push(corners.len() as i64);
    }
    (corners, ends)
}

fn corner_walk(
    mesh: &Mesh,
    records: &[HalfedgeRecord],
    face: FaceId,
    mut see: impl FnMut(VertexId),
) {
    let first = mesh.face_halfedge(face);
    let mut at = first;
    for _ in 0..records.len() {
        let Some(record) = records.get(at.index()) else { return };
        see(record.vertex);
        at = record.next;
        if at == first {
            return;
        }
    }
}
