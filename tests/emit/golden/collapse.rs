use hedgerow::mesh::{EdgeId, Mesh, VertexId};

/// Merges the two ends of an edge between triangles at its midpoint; v1 goes.
///
/// The two triangles vanish, and of each the two other edges become one. All other spokes
/// of `v1`, the fan `S`, move to `v0`.
pub fn collapse(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let c = mesh.next(b);
        let d = mesh.twin(a);
        let b_ = mesh.twin(b);
        let c_ = mesh.twin(c);
        let g = mesh.next(d);
        let h = mesh.next(g);
        let g_ = mesh.twin(g);
        let h_ = mesh.twin(h);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(c_);
        let v1 = mesh.vertex(h_);
        let v2 = mesh.vertex(b_);
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(g_);
        let eb = mesh.edge(b);
        let ec = mesh.edge(c);
        let eg = mesh.edge(g);
        let eh = mesh.edge(h);
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
        if !mesh.link_condition(e) {
            continue; // the link condition does not hold
        }
        let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 3. Reassign every pointer that changes.
        let mut h_2 = mesh.next(b_);
        while h_2 != h_ {
            mesh.set_vertex(h_2, v0);
            h_2 = mesh.next(mesh.twin(h_2));
        }
        mesh.set_twin(b_, c_);
        mesh.set_twin(c_, b_);
        mesh.set_edge(c_, eb);
        mesh.set_twin(g_, h_);
        mesh.set_twin(h_, g_);
        mesh.set_vertex(h_, v0);
        mesh.set_edge(h_, eg);
        mesh.set_vertex_halfedge(v0, h_);
        mesh.set_vertex_halfedge(v2, b_);
        mesh.set_vertex_halfedge(v3, g_);
        mesh.set_edge_halfedge(eb, b_);
        mesh.set_edge_halfedge(eg, g_);
        mesh.set_position(v0, v0_position);

        // 4. Erase what is gone.
        mesh.erase_vertex(v1);
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_halfedge(b);
        mesh.erase_halfedge(c);
        mesh.erase_halfedge(g);
        mesh.erase_halfedge(h);
        mesh.erase_face(f0);
        mesh.erase_face(f1);
        mesh.erase_edge(ec);
        mesh.erase_edge(eh);
        return Some(v0);
    }
    None
}
