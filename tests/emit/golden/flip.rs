use hedgerow::mesh::{EdgeId, Mesh};

/// Rotates an edge between two triangles by one corner.
///
/// ```text
///        v2                 v2
///       /  \               /|\ .
///     c/ f0 \b           c/ | \b
///     /  a-> \           /  |  \ .
///   v0 ------ v1   =>  v0   |   v1
///     \ <-d  /           \ a|d /
///     g\ f1 /h           g\ | /h
///       \  /               \|/
///        v3                 v3
/// ```
pub fn flip(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let c = mesh.next(b);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let h = mesh.next(g);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(c);
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(h);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
        }
        if mesh.next(c) != a {
            continue; // `f0` is not a triangle
        }
        if mesh.next(h) != d {
            continue; // `f1` is not a triangle
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            continue; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            continue; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            continue; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            continue; // `v1` and `v3` are one vertex
        }
        if v2 == v3 {
            continue; // `v2` and `v3` are one vertex
        }
        if mesh.adjacent(v2, v3) {
            continue; // the edge v2 v3 is already there
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, c);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, h);
        mesh.set_face(b, f1);
        mesh.set_next(c, g);
        mesh.set_prev(c, a);
        mesh.set_next(d, h);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, c);
        mesh.set_face(g, f0);
        mesh.set_next(h, b);
        mesh.set_prev(h, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}
