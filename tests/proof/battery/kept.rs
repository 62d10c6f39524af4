//! Whether an application keeps what the prover says that it keeps.

use std::collections::BTreeMap;

use hedgerow::diagram::Property;
use hedgerow::mesh::{FaceId, Level, Mesh, VertexId, validate_level};

/// The first of the properties that a valid mesh has lost.
pub fn lost(keeps: &[Property], before: &Mesh, after: &Mesh) -> Option<Property> {
    let is_lost = |property: &&Property| match **property {
        Property::Triangles => are_of(before, 3) && !are_of(after, 3),
        Property::Quads => are_of(before, 4) && !are_of(after, 4),
        Property::Euler => euler(before) != euler(after),
        Property::Boundary => holes(before) != holes(after),
        Property::ConstantTime => false,
        Property::Level(level) => is_of(before, level) && !is_of(after, level),
    };
    keeps.iter().find(is_lost).copied()
}

fn are_of(mesh: &Mesh, sides: usize) -> bool {
    let mut faces = mesh.faces().filter(|&face| !mesh.is_hole(face));
    faces.all(|face| mesh.face_halfedges(face).count() == sides)
}

fn euler(mesh: &Mesh) -> i64 {
    mesh.vertex_count() as i64 - mesh.edge_count() as i64 + mesh.faces().count() as i64
}

/// The vertices of each hole, sorted.
fn holes(mesh: &Mesh) -> BTreeMap<FaceId, Vec<VertexId>> {
    let sorted = |hole| {
        let mut vertices: Vec<_> = mesh.face_vertices(hole).collect();
        vertices.sort_unstable();
        (hole, vertices)
    };
    mesh.holes().map(sorted).collect()
}

fn is_of(mesh: &Mesh, level: Level) -> bool {
    validate_level(mesh, level).is_ok()
}
