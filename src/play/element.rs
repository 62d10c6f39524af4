//! The geometry of elements that a page needs to point at them.

use glam::DVec3;
use serde_json::{Value, json};

use super::frame::Frame;
use crate::mesh::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// The fraction by which a halfedge is drawn away from its edge, towards the middle of its face.
const INSIDE: f64 = 0.14;

/// The fraction of the way from there to the middle of the face at which its name is.
const FURTHER: f64 = 0.13;

/// An element with a place for its name and a line to draw, in a frame: the corners of a face, the
/// ends of an edge, a halfedge a little inside its face, with its name further inside.
pub(super) fn shown(mesh: &Mesh, frame: &Frame, Element { kind, index }: Element) -> Value {
    let place = |vertex| frame.place(mesh.position(vertex));
    let corners = |face| mesh.face_vertices(face).map(place).collect::<Vec<_>>();
    let ends = |halfedge| [halfedge, mesh.twin(halfedge)].map(|of| place(mesh.vertex(of)));
    let mut inside = None;
    let line: Vec<DVec3> = match kind {
        _ if !mesh.is_alive(kind, index) => Vec::new(),
        ElementKind::Vertex => vec![place(VertexId(index))],
        ElementKind::Edge => ends(mesh.edge_halfedge(EdgeId(index))).to_vec(),
        ElementKind::Face => corners(FaceId(index)),
        ElementKind::Halfedge => {
            let halfedge = HalfedgeId(index);
            let [from, to] = ends(halfedge);
            let face = mesh.face(halfedge);
            let middle = match mesh.is_hole(face) {
                // The mirror image of the face on the other side: a hole has no inside.
                true => {
                    let other = mean(&corners(mesh.face(mesh.twin(halfedge))));
                    from + to - other
                }
                false => mean(&corners(face)),
            };
            inside = Some(middle);
            [(from, to), (to, from)]
                .map(|(near, far)| near.lerp(far, INSIDE).lerp(middle, INSIDE))
                .to_vec()
        }
    };
    let is_hole =
        kind == ElementKind::Face && mesh.is_alive(kind, index) && mesh.is_hole(FaceId(index));
    let at = mean(&line);
    let at = inside.map_or(at, |inside| at.lerp(inside, FURTHER));
    json!({
        "kind": kind.name(),
        "index": index,
        "hole": is_hole,
        "at": at.to_array(),
        "line": line.iter().map(DVec3::to_array).collect::<Vec<_>>(),
    })
}

fn mean(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len().max(1) as f64
}
