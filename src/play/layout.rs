//! Positions for the vertices of a mesh without any: counterexamples consist of pointers alone.

use glam::DVec3;

use crate::mesh::{Mesh, VertexId};

/// The number of rounds in which neighbors pull, and the strength of the pull.
const ROUNDS: usize = 200;
const PULL: f64 = 0.2;

/// The mesh with its vertices on a sphere, if all of them coincide: spread evenly along a spiral
/// (R. Swinbank and R. J. Purser, "Fibonacci grids: A novel approach to global modelling", 2006),
/// then pulled towards the middle of their neighbors and back to the sphere.
pub(super) fn laid_out(mesh: &Mesh) -> Mesh {
    let mut mesh = mesh.clone();
    let vertices: Vec<VertexId> = mesh.vertices().collect();
    let places = vertices.iter().map(|&vertex| mesh.position(vertex));
    let (low, high) =
        places.fold((DVec3::MAX, DVec3::MIN), |(low, high), at| (low.min(at), high.max(at)));
    if vertices.len() < 2 || (high - low).length() > 0.0 {
        return mesh;
    }
    let turn = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let count = vertices.len() as f64;
    for (at, &vertex) in vertices.iter().enumerate() {
        let height = 1.0 - (2.0 * at as f64 + 1.0) / count;
        let wide = (1.0 - height * height).sqrt();
        let (sine, cosine) = (turn * at as f64).sin_cos();
        mesh.set_position(vertex, DVec3::new(wide * cosine, height, wide * sine));
    }
    let edges: Vec<_> = mesh.edges().collect();
    for _ in 0..ROUNDS {
        let mut pulls = vec![DVec3::ZERO; mesh.positions().len()];
        for &edge in &edges {
            let halfedge = mesh.edge_halfedge(edge);
            let [a, b] = [halfedge, mesh.twin(halfedge)].map(|of| mesh.vertex(of));
            let way = mesh.position(b) - mesh.position(a);
            pulls[a.index()] += way;
            pulls[b.index()] -= way;
        }
        for &vertex in &vertices {
            let pull = pulls[vertex.index()] * (PULL / (edges.len() as f64 / count + 1.0)) * 0.1;
            let place = (mesh.position(vertex) + pull).normalize_or(DVec3::Y);
            mesh.set_position(vertex, place);
        }
    }
    mesh
}
