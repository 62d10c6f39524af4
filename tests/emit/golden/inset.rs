use hedgerow::mesh::glam::DVec3;
use hedgerow::mesh::{FaceId, Mesh, VertexId};

/// Shrinks a face inside its own boundary, and fills the gap with quads.
/// By default `t = 0.3`.
pub fn inset(mesh: &mut Mesh, f: FaceId, t: f64) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return false; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return false; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return false; // two of `v[i]` are one vertex
    }
    let centroid = mesh.centroid(f);
    let w_position: Vec<DVec3> = (0..n).map(|i| DVec3::lerp(mesh.position(v[i]), centroid, t)).collect();
    if (0..n).any(|i| !w_position[i].is_finite()) {
        return false; // the new position of `w[i]` is not finite
    }

    // 2. Allocate what is new.
    let w: Vec<_> = (0..n).map(|_| mesh.add_vertex()).collect();
    let s: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let r: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let q: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();
    let c: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_face_halfedge(f, s[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], q[i]);
        mesh.set_next(s[i], s[(i + 1) % n]);
        mesh.set_twin(s[i], r[i]);
        mesh.set_vertex(s[i], w[i]);
        mesh.set_edge(s[i], c[i]);
        mesh.set_face(s[i], f);
        mesh.set_prev(s[(i + 1) % n], s[i]);
        mesh.set_next(a[i], r[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], q[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], r[i]);
        mesh.set_vertex(b[i], w[i]);
        mesh.set_face(b[i], q[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_next(r[i], b[i]);
        mesh.set_prev(r[i], a[i]);
        mesh.set_twin(r[i], s[i]);
        mesh.set_vertex(r[i], w[(i + 1) % n]);
        mesh.set_edge(r[i], c[i]);
        mesh.set_face(r[i], q[i]);
        mesh.set_vertex_halfedge(w[i], s[i]);
        mesh.set_edge_halfedge(c[i], s[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(q[i], h[i]);
    }
    for i in 0..n {
        mesh.set_position(w[i], w_position[i]);
    }
    true
}

/// Whether all are different.
fn all_differ<T: PartialEq>(all: &[T]) -> bool {
    (1..all.len()).all(|at| !all[..at].contains(&all[at]))
}
