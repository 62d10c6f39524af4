//! The picture of a mesh as arrays for a graphics card.

use std::collections::HashMap;

use glam::DVec3;
use serde_json::{Value, json};

use super::Message;
use super::frame::Frame;
use crate::draw::{Colours, Key};
use crate::mesh::{ColumnId, EdgeId, ElementKind, FaceId, HalfedgeId, Mesh};

/// The mesh as arrays, which the answer lists by name, type and length, in their order:
///
/// - `positions`: three reals for each slot of a vertex, in the `frame`, of which the answer gives
///   the middle and the size;
/// - `triangles`: three vertices each; `faces`: the face that each is part of;
/// - `edges`: the ends of each living edge; `edgeIds`: its number; `halfedges`: its two halfedges,
///   of which the first starts at the first end; `edgeFaces`: their faces; `edgeIsBoundary`: 1 or
///   0;
/// - `loose`: the vertices without an edge;
/// - `colours`: red, green and blue (sRGB, from 0 to 255) of the value of the attribute, for each
///   slot of its kind, which is `coloured`. `legend` tells their meaning, unless the values are
///   colours themselves: the least and the greatest number, or the values and their colours.
pub(super) fn view(mesh: &Mesh, frame: &Frame, attribute: Option<&str>) -> Message {
    let mut arrays = Arrays::default();
    let places = mesh.positions().iter().zip(0..).map(|(&at, vertex)| {
        let is_alive = mesh.is_alive(ElementKind::Vertex, vertex);
        if is_alive { frame.place(at) } else { DVec3::ZERO }
    });
    let parts = places.flat_map(|at| at.to_array());
    arrays.reals("positions", parts.map(|part| part as f32));
    let (mut triangles, mut faces) = (Vec::new(), Vec::new());
    for face in mesh.faces().filter(|&face| !mesh.is_hole(face)) {
        triangulate(mesh, face, &mut triangles);
        faces.resize(triangles.len() / 3, face.0);
    }
    arrays.ints("triangles", &triangles);
    arrays.ints("faces", &faces);
    let edges: Vec<EdgeId> = mesh.edges().collect();
    let ends = |&edge: &EdgeId| {
        let halfedge = mesh.edge_halfedge(edge);
        [mesh.vertex(halfedge).0, mesh.vertex(mesh.twin(halfedge)).0]
    };
    arrays.ints("edges", &edges.iter().flat_map(ends).collect::<Vec<_>>());
    let sides = |&edge: &EdgeId| {
        let halfedge = mesh.edge_halfedge(edge);
        [halfedge, mesh.twin(halfedge)]
    };
    let halfedges: Vec<HalfedgeId> = edges.iter().flat_map(sides).collect();
    arrays.ints("halfedges", &halfedges.iter().map(|side| side.0).collect::<Vec<_>>());
    let faces_of = halfedges.iter().map(|&side| mesh.face(side).0);
    arrays.ints("edgeFaces", &faces_of.collect::<Vec<_>>());
    arrays.ints("edgeIds", &edges.iter().map(|edge| edge.0).collect::<Vec<_>>());
    let on_boundary = |&edge: &EdgeId| u32::from(mesh.is_boundary_edge(edge));
    arrays.ints("edgeIsBoundary", &edges.iter().map(on_boundary).collect::<Vec<_>>());
    let loose = mesh.vertices().filter(|&vertex| mesh.vertex_halfedge(vertex).is_none());
    arrays.ints("loose", &loose.map(|vertex| vertex.0).collect::<Vec<_>>());
    let column = attribute.and_then(|name| find(mesh, name));
    let colours = column.and_then(|column| Some((column.kind, Colours::new(mesh, column)?)));
    if let Some((kind, colours)) = &colours {
        let slots = 0..mesh.capacity(*kind) as u32;
        arrays.octets("colours", slots.flat_map(|slot| colours.of_element(mesh, slot)));
    }
    let attributes = mesh.public_columns();
    let attributes = attributes.map(|(id, column)| format!("{}.{}", id.kind.name(), column.name()));
    let json = json!({
        "counts": counts(mesh),
        "frame": [frame.middle.x, frame.middle.y, frame.middle.z, frame.size],
        "slots": ElementKind::ALL.map(|kind| mesh.capacity(kind)),
        "attributes": attributes.collect::<Vec<_>>(),
        "coloured": colours.as_ref().map(|(kind, _)| kind.name()),
        "legend": colours.as_ref().and_then(|(_, colours)| colours.key()).map(legend),
        "arrays": arrays.list,
    });
    Message { json, bytes: arrays.bytes }
}

/// The meaning of colours.
fn legend(key: Key) -> Value {
    match key {
        Key::Range(range) => json!({ "range": range.ends() }),
        Key::Swatches(values) => json!({ "swatches": values }),
    }
}

/// The numbers of elements.
pub(super) fn counts(mesh: &Mesh) -> Value {
    json!({
        "vertices": mesh.vertex_count(),
        "edges": mesh.edge_count(),
        "faces": mesh.face_count(),
        "holes": mesh.hole_count(),
    })
}

/// The attribute of a name with its kind: `vertex.height`.
fn find(mesh: &Mesh, name: &str) -> Option<ColumnId> {
    let (kind, name) = name.split_once('.')?;
    let mut columns = mesh.public_columns();
    columns.find(|(id, column)| id.kind.name() == kind && column.name() == name).map(|(id, _)| id)
}

/// Appends the triangles of a face.
fn triangulate(mesh: &Mesh, face: FaceId, to: &mut Vec<u32>) {
    let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
    let corner = |side: HalfedgeId| mesh.vertex(side).0;
    match sides[..] {
        [a, b, c] => to.extend([a, b, c].map(corner)),
        [_, _] | [_] | [] => {}
        _ => {
            let count = sides.len();
            let places: HashMap<_, _> = sides.iter().zip(0..).collect();
            let mut before: Vec<_> = (0..count).map(|at| (at + count - 1) % count).collect();
            let mut behind: Vec<_> = (0..count).map(|at| (at + 1) % count).collect();
            let mut is_cut = vec![false; count];
            let ears = mesh.ears(face);
            let mut ears = ears.iter().filter_map(|side| places.get(side).copied());
            for _ in 2..count {
                // In the end a triangle is left, of which any corner will do.
                let left = || is_cut.iter().position(|is_cut| !is_cut);
                let Some(at) = ears.next().or_else(left) else { break };
                let (left, right): (usize, usize) = (before[at], behind[at]);
                to.extend([left, at, right].map(|at| corner(sides[at])));
                (behind[left], before[right]) = (right, left);
                is_cut[at] = true;
            }
        }
    }
}

/// Arrays, one after the other.
#[derive(Default)]
struct Arrays {
    list: Vec<Value>,
    bytes: Vec<u8>,
}

impl Arrays {
    fn add(&mut self, name: &str, ty: &str, length: usize) {
        self.list.push(json!({ "name": name, "type": ty, "length": length }));
    }

    fn reals(&mut self, name: &str, numbers: impl Iterator<Item = f32>) {
        let start = self.bytes.len();
        self.bytes.extend(numbers.flat_map(f32::to_le_bytes));
        self.add(name, "f32", (self.bytes.len() - start) / 4);
    }

    fn octets(&mut self, name: &str, numbers: impl Iterator<Item = u8>) {
        let start = self.bytes.len();
        self.bytes.extend(numbers);
        self.add(name, "u8", self.bytes.len() - start);
    }

    fn ints(&mut self, name: &str, numbers: &[u32]) {
        self.bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        self.add(name, "u32", numbers.len());
    }
}
