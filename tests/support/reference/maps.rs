//! Random maps: any pairing `twin`, any permutation `next`, and their orbits.

use glam::DVec3;
use hedgerow::mesh::{HalfedgeId, Mesh, validate};

use super::random::Random;

/// The mesh of two permutations; `holes` decides which faces are holes.
pub fn mesh_of(next: &[usize], twin: &[usize], holes: &mut dyn FnMut(usize) -> bool) -> Mesh {
    let count = next.len();
    let mut mesh = Mesh::default();
    let mut prev = vec![0; count];
    for half in 0..count {
        prev[next[half]] = half;
        mesh.add_halfedge();
    }
    let id = |half: usize| HalfedgeId(half as u32);
    for half in 0..count {
        mesh.set_next(id(half), id(next[half]));
        mesh.set_prev(id(half), id(prev[half]));
        mesh.set_twin(id(half), id(twin[half]));
    }
    let orbit = |start: usize, step: &dyn Fn(usize) -> usize| {
        let mut orbit = vec![start];
        while step(orbit[orbit.len() - 1]) != start {
            orbit.push(step(orbit[orbit.len() - 1]));
        }
        orbit
    };
    for half in 0..count {
        if mesh.face(id(half)).is_none() {
            let face = mesh.add_face();
            mesh.set_face_halfedge(face, id(half));
            mesh.set_hole(face, holes(half));
            orbit(half, &|h| next[h]).into_iter().for_each(|h| mesh.set_face(id(h), face));
        }
        if mesh.edge(id(half)).is_none() {
            let edge = mesh.add_edge();
            mesh.set_edge_halfedge(edge, id(half));
            orbit(half, &|h| twin[h]).into_iter().for_each(|h| mesh.set_edge(id(h), edge));
        }
        if mesh.vertex(id(half)).is_none() {
            let vertex = mesh.add_vertex();
            let at = f64::from(vertex.0);
            mesh.set_position(vertex, DVec3::new(at, (3.0 * at).sin(), (5.0 * at).cos()));
            mesh.set_vertex_halfedge(vertex, id(half));
            orbit(half, &|h| twin[prev[h]])
                .into_iter()
                .for_each(|h| mesh.set_vertex(id(h), vertex));
        }
    }
    mesh
}

/// A random map of `count` halfedges, an even number, in which the degrees of the faces, or those
/// of the vertices, have a random bound.
pub fn random_map(count: usize, random: &mut Random) -> Mesh {
    let twin: Vec<_> = (0..count).map(|half| half ^ 1).collect();
    let mut order: Vec<_> = (0..count).collect();
    random.shuffle(&mut order);
    let mut orbits = vec![0; count];
    let most = 1 + random.below(count);
    let mut start = 0;
    while start < count {
        let size = (1 + random.below(most)).min(count - start);
        for place in 0..size {
            orbits[order[start + place]] = order[start + (place + 1) % size];
        }
        start += size;
    }
    let next: Vec<_> = match random.once_in(2) {
        true => orbits,
        // The orbits become those of the vertices, clockwise: h.twin.next.
        false => (0..count).map(|half| orbits[twin[half]]).collect(),
    };
    let mut mesh = mesh_of(&next, &twin, &mut |_| random.once_in(3));
    if random.once_in(8) {
        mesh.add_vertex(); // an isolated one
    }
    shuffle_pointers(&mut mesh, random);
    assert_eq!(validate(&mesh), Ok(()), "a random map is a mesh");
    mesh
}

/// Lets every vertex, edge and face point to a random one of its halfedges.
pub fn shuffle_pointers(mesh: &mut Mesh, random: &mut Random) {
    let halfedges: Vec<_> = mesh.halfedges().collect();
    let mut order = halfedges.clone();
    random.shuffle(&mut order);
    for half in order {
        let record = mesh.halfedge(half).clone();
        mesh.set_vertex_halfedge(record.vertex, half);
        mesh.set_edge_halfedge(record.edge, half);
        mesh.set_face_halfedge(record.face, half);
    }
}
