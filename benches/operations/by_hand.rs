//! Operations as a careful programmer would write them, on hedgerow's mesh.

use hedgerow::mesh::{EdgeId, HalfedgeId, Mesh};

/// Rotates an edge, even if the result is not simple.
pub fn flip_raw(mesh: &mut Mesh, edge: EdgeId) -> bool {
    flip_edge(mesh, edge, false)
}

/// Rotates an edge, unless another edge joins the same vertices.
pub fn flip(mesh: &mut Mesh, edge: EdgeId) -> bool {
    flip_edge(mesh, edge, true)
}

/// The halfedges of the triangle at `a`, or `None`.
fn triangle(mesh: &Mesh, a: HalfedgeId) -> Option<[HalfedgeId; 3]> {
    let b = mesh.next(a);
    let c = mesh.next(b);
    (!mesh.is_hole(mesh.face(a)) && mesh.next(c) == a).then_some([a, b, c])
}

fn link(mesh: &mut Mesh, from: HalfedgeId, to: HalfedgeId) {
    mesh.set_next(from, to);
    mesh.set_prev(to, from);
}

#[inline(always)]
fn flip_edge(mesh: &mut Mesh, edge: EdgeId, stays_simple: bool) -> bool {
    let a = mesh.edge_halfedge(edge);
    let (Some([a, b, c]), Some([d, g, h])) = (triangle(mesh, a), triangle(mesh, mesh.twin(a)))
    else {
        return false;
    };
    let [v0, v1, v2, v3] = [a, b, c, h].map(|half| mesh.vertex(half));
    let distinct = v0 != v1 && v0 != v2 && v0 != v3 && v1 != v2 && v1 != v3 && v2 != v3;
    if !distinct || stays_simple && mesh.adjacent(v2, v3) {
        return false;
    }
    let (f0, f1) = (mesh.face(a), mesh.face(d));
    for (from, to) in [(a, c), (c, g), (g, a), (d, h), (h, b), (b, d)] {
        link(mesh, from, to);
    }
    mesh.set_vertex(a, v3);
    mesh.set_vertex(d, v2);
    mesh.set_face(g, f0);
    mesh.set_face(b, f1);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f1, d);
    mesh.set_vertex_halfedge(v0, g);
    mesh.set_vertex_halfedge(v1, b);
    true
}

/// Splits an edge at its midpoint.
pub fn split(mesh: &mut Mesh, edge: EdgeId) -> bool {
    let a = mesh.edge_halfedge(edge);
    let (Some([a, b, c]), Some([d, g, h])) = (triangle(mesh, a), triangle(mesh, mesh.twin(a)))
    else {
        return false;
    };
    let [v0, v1, v2, v3] = [a, b, c, h].map(|half| mesh.vertex(half));
    if v0 == v1 || v0 == v2 || v0 == v3 || v1 == v2 || v1 == v3 || v2 == v3 {
        return false;
    }
    let (f0, f1) = (mesh.face(a), mesh.face(d));
    let middle = (mesh.position(v0) + mesh.position(v1)) / 2.0;
    let m = mesh.add_vertex();
    let [p, q, r, s, t, u] = [(); 6].map(|()| mesh.add_halfedge());
    let [f2, f3] = [(); 2].map(|()| mesh.add_face());
    let [e1, e2, e3] = [(); 3].map(|()| mesh.add_edge());
    for [x, y, z] in [[a, p, c], [q, b, r], [d, s, h], [t, g, u]] {
        link(mesh, x, y);
        link(mesh, y, z);
        link(mesh, z, x);
    }
    for (half, vertex, face) in
        [(p, m, f0), (q, m, f2), (r, v2, f2), (s, m, f1), (t, m, f3), (u, v3, f3)]
    {
        mesh.set_vertex(half, vertex);
        mesh.set_face(half, face);
    }
    mesh.set_face(b, f2);
    mesh.set_face(g, f3);
    for (e, x, y) in [(edge, a, t), (e1, q, d), (e2, p, r), (e3, s, u)] {
        mesh.set_twin(x, y);
        mesh.set_twin(y, x);
        mesh.set_edge(x, e);
        mesh.set_edge(y, e);
        mesh.set_edge_halfedge(e, x);
    }
    for (face, half) in [(f0, a), (f1, d), (f2, q), (f3, t)] {
        mesh.set_face_halfedge(face, half);
    }
    mesh.set_vertex_halfedge(m, p);
    mesh.set_position(m, middle);
    true
}

/// Collapses an edge to its midpoint, unless the mesh would not be simple; only away from the
/// boundary.
pub fn collapse(mesh: &mut Mesh, edge: EdgeId) -> bool {
    let a = mesh.edge_halfedge(edge);
    let (Some([a, b, c]), Some([d, g, h])) = (triangle(mesh, a), triangle(mesh, mesh.twin(a)))
    else {
        return false;
    };
    if !mesh.link_condition(edge) {
        return false;
    }
    let [v0, v1, v2, v3] = [a, b, c, h].map(|half| mesh.vertex(half));
    let [b2, c2, g2, h2] = [b, c, g, h].map(|half| mesh.twin(half));
    let [eb, ec, eg, eh] = [b, c, g, h].map(|half| mesh.edge(half));
    let (f0, f1) = (mesh.face(a), mesh.face(d));
    let middle = (mesh.position(v0) + mesh.position(v1)) / 2.0;
    let mut spoke = h2;
    while spoke != b {
        mesh.set_vertex(spoke, v0);
        spoke = mesh.twin(mesh.prev(spoke));
    }
    for (x, y, e) in [(b2, c2, eb), (g2, h2, eg)] {
        mesh.set_twin(x, y);
        mesh.set_twin(y, x);
        mesh.set_edge(x, e);
        mesh.set_edge(y, e);
        mesh.set_edge_halfedge(e, x);
    }
    mesh.set_vertex_halfedge(v0, h2);
    mesh.set_vertex_halfedge(v2, b2);
    mesh.set_vertex_halfedge(v3, g2);
    mesh.set_position(v0, middle);
    mesh.erase_vertex(v1);
    [edge, ec, eh].into_iter().for_each(|e| mesh.erase_edge(e));
    [a, b, c, d, g, h].into_iter().for_each(|half| mesh.erase_halfedge(half));
    mesh.erase_face(f0);
    mesh.erase_face(f1);
    true
}
