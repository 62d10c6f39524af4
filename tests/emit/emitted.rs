// Written by the test `rust_is_as_committed` with UPDATE=1.

mod drawn {
use std::collections::HashMap;
use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use hedgerow::mesh::{Attribute, ColumnId, EdgeId, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// Merges the two ends of an edge between triangles at its midpoint; v1 goes.
///
/// The two triangles vanish, and of each the two other edges become one. All other spokes
/// of `v1`, the fan `S`, move to `v0`.
pub fn collapse_collapse(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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

/// Merges the two ends of an edge between any polygons at its midpoint; v1 goes.
///
/// A triangle at the edge would be left with two sides: it vanishes, as in `collapse`. A
/// larger polygon loses a side. An edge parameter is tried both ways around, so one drawing
/// serves a triangle on either side.
pub fn collapse_collapse_polygon(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    fn rule_triangles(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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

    #[allow(non_snake_case)]
    fn rule_triangle(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(c_);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(b_);
            let f1 = mesh.face(d);
            let v3 = mesh.vertex(h);
            let v4 = mesh.vertex(mesh.next(h));
            let eb = mesh.edge(b);
            let ec = mesh.edge(c);
            let Q_last = mesh.prev(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.next(c) != a {
                continue; // `f0` is not a triangle
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
            if v0 == v4 {
                continue; // `v0` and `v4` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            if v1 == v3 {
                continue; // `v1` and `v3` are one vertex
            }
            if v1 == v4 {
                continue; // `v1` and `v4` are one vertex
            }
            if v2 == v3 {
                continue; // `v2` and `v3` are one vertex
            }
            if v2 == v4 {
                continue; // `v2` and `v4` are one vertex
            }
            if v3 == v4 {
                continue; // `v3` and `v4` are one vertex
            }
            if (mesh.neighbors(v0).filter(|&w| mesh.adjacent(w, v1)).count() as i64) != 1 {
                continue; // the ends have a common neighbour
            }
            if !mesh.is_boundary_edge(e) && mesh.is_boundary_vertex(v0) && mesh.is_boundary_vertex(v1) {
                continue; // two boundaries would be pinched
            }
            let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h_2 = mesh.next(b_);
            while h_2 != d {
                mesh.set_vertex(h_2, v0);
                h_2 = mesh.next(mesh.twin(h_2));
            }
            mesh.set_prev(g, Q_last);
            mesh.set_next(Q_last, g);
            mesh.set_twin(b_, c_);
            mesh.set_twin(c_, b_);
            mesh.set_edge(c_, eb);
            mesh.set_vertex_halfedge(v0, g);
            mesh.set_vertex_halfedge(v2, b_);
            mesh.set_edge_halfedge(eb, b_);
            mesh.set_face_halfedge(f1, g);
            mesh.set_position(v0, v0_position);

            // 4. Erase what is gone.
            mesh.erase_vertex(v1);
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_halfedge(b);
            mesh.erase_halfedge(c);
            mesh.erase_face(f0);
            mesh.erase_edge(ec);
            return Some(v0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_polygons(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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
            let v4 = mesh.vertex(mesh.next(c));
            let f1 = mesh.face(d);
            let v3 = mesh.vertex(h);
            let v5 = mesh.vertex(mesh.next(h));
            let P_last = mesh.prev(a);
            let Q_last = mesh.prev(d);
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v0 == v4 {
                continue; // `v0` and `v4` are one vertex
            }
            if v0 == v3 {
                continue; // `v0` and `v3` are one vertex
            }
            if v0 == v5 {
                continue; // `v0` and `v5` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            if v1 == v4 {
                continue; // `v1` and `v4` are one vertex
            }
            if v1 == v3 {
                continue; // `v1` and `v3` are one vertex
            }
            if v1 == v5 {
                continue; // `v1` and `v5` are one vertex
            }
            if v2 == v4 {
                continue; // `v2` and `v4` are one vertex
            }
            if v2 == v3 {
                continue; // `v2` and `v3` are one vertex
            }
            if v2 == v5 {
                continue; // `v2` and `v5` are one vertex
            }
            if v4 == v3 {
                continue; // `v4` and `v3` are one vertex
            }
            if v4 == v5 {
                continue; // `v4` and `v5` are one vertex
            }
            if v3 == v5 {
                continue; // `v3` and `v5` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }
            if mesh.neighbors(v0).any(|w| mesh.adjacent(w, v1)) {
                continue; // the ends have a common neighbour
            }
            if !mesh.is_boundary_edge(e) && mesh.is_boundary_vertex(v0) && mesh.is_boundary_vertex(v1) {
                continue; // two boundaries would be pinched
            }
            let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h_2 = mesh.next(mesh.twin(b));
            while h_2 != d {
                mesh.set_vertex(h_2, v0);
                h_2 = mesh.next(mesh.twin(h_2));
            }
            mesh.set_prev(b, P_last);
            mesh.set_vertex(b, v0);
            mesh.set_next(P_last, b);
            mesh.set_prev(g, Q_last);
            mesh.set_next(Q_last, g);
            mesh.set_vertex_halfedge(v0, g);
            mesh.set_face_halfedge(f0, b);
            mesh.set_face_halfedge(f1, g);
            mesh.set_position(v0, v0_position);

            // 4. Erase what is gone.
            mesh.erase_vertex(v1);
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            return Some(v0);
        }
        None
    }

    rule_triangles(mesh, e).or_else(|| rule_triangle(mesh, e)).or_else(|| rule_polygons(mesh, e))
}

/// Cuts a face between the corners where `a` and `b` start; returns the new edge.
///
/// Corners that are neighbours are refused: the names of `v0 v1 v2 v3` are different, so
/// neither of the two paths is empty.
#[allow(non_snake_case)]
pub fn connect_connect(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    if mesh.adjacent(v0, v2) {
        return None; // an edge joins the two corners already
    }

    // 2. Allocate what is new.
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != a {
        mesh.set_face(h, g);
        h = mesh.next(h);
    }
    mesh.set_prev(a, x);
    mesh.set_next(P_last, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(Q_last, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, P_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, Q_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, y);
    Some(e)
}

/// Merges the two ends of an edge at its midpoint, whatever lies beside it.
#[allow(non_snake_case)]
pub fn contract_contract(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 3. Reassign every pointer that changes.
        let mut h = mesh.next(a);
        while h != d {
            mesh.set_vertex(h, v0);
            h = mesh.next(mesh.twin(h));
        }
        mesh.set_next(P_last, P_first);
        mesh.set_prev(P_first, P_last);
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v0, P_first);
        mesh.set_face_halfedge(f0, P_first);
        mesh.set_face_halfedge(f1, Q_first);
        mesh.set_position(v0, v0_position);

        // 4. Erase what is gone.
        mesh.erase_vertex(v1);
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        return Some(v0);
    }
    None
}

/// Merges the two faces at an edge; returns the one that is left.
#[allow(non_snake_case)]
pub fn dissolve_dissolve_edge(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        if (mesh.degree(v0) as i64) <= 2 {
            continue; // an end of the edge has no other face
        }
        if (mesh.degree(v1) as i64) <= 2 {
            continue; // an end of the edge has no other face
        }

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != d {
            mesh.set_face(h, f0);
            h = mesh.next(h);
        }
        mesh.set_next(P_last, Q_first);
        mesh.set_prev(P_first, Q_last);
        mesh.set_next(Q_last, P_first);
        mesh.set_prev(Q_first, P_last);
        mesh.set_vertex_halfedge(v0, Q_first);
        mesh.set_vertex_halfedge(v1, P_first);
        mesh.set_face_halfedge(f0, P_first);

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_face(f1);
        return Some(f0);
    }
    None
}

/// Shrinks a face inside its own boundary, and fills the gap with quads.
/// By default `t = 0.3`.
pub fn families_inset(mesh: &mut Mesh, f: FaceId, t: f64) -> bool {
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

/// Splits a face into triangles around a new vertex at its centre; returns the vertex.
pub fn families_poke(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let c_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let c = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(c, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], c);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(c, c_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(c)
}

/// Removes a vertex and merges the faces around it into one; returns the face.
#[allow(non_snake_case)]
pub fn families_dissolve_vertex(mesh: &mut Mesh, v: VertexId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(v).is_none() {
        return None; // `v` is isolated: no halfedge starts there
    }
    let h_0 = mesh.vertex_halfedge(v);
    let h = mesh.spokes_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let k: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(h[(i + n - 1) % n])).collect();
    let e: Vec<EdgeId> = (0..n).map(|i| mesh.edge(h[i])).collect();
    let g: Vec<FaceId> = (0..n).map(|i| mesh.face(h[i])).collect();
    let w: Vec<VertexId> = (0..n).map(|i| mesh.vertex(k[i])).collect();
    let P_first: Vec<HalfedgeId> = (0..n).map(|i| mesh.next(h[i])).collect();
    let P_last: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(k[(i + 1) % n])).collect();
    let P_is_empty: Vec<bool> = (0..n).map(|i| P_first[i] == k[(i + 1) % n]).collect();
    if (0..n).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..n).any(|i| mesh.twin(h[i]) != k[i]) {
        return None; // `h[i].twin` is not `k[i]`
    }
    if (0..n).any(|i| mesh.vertex(h[i]) != v) {
        return None; // `h[i]` does not start at `v`
    }
    let mut all: Vec<VertexId> = vec![v];
    for i in 0..n {
        all.push(w[i]);
    }
    if !all_differ(&all) {
        return None; // two of `v`, `w[i]` are one vertex
    }
    if !all_differ(&g) {
        return None; // two of `g[i]` are one face
    }
    if !(0..n).any(|i| !P_is_empty[i]) {
        return None; // `f` would be left without halfedges
    }
    // The guard looks at what there would be, on a sheet over the mesh.
    {
        let mut sheet = Sheet::new(mesh);
        let f = sheet.add_face();
        for i in 0..n {
            let mut h_2 = P_first[i];
            while h_2 != k[(i + 1) % n] {
                sheet.set_face(h_2, f);
                h_2 = mesh.next(h_2);
            }
        }
        let mut firsts: Vec<HalfedgeId> = Vec::new();
        let mut lasts: Vec<HalfedgeId> = Vec::new();
        for i in 0..n {
            if !P_is_empty[i] {
                firsts.push(P_first[i]);
                lasts.push(P_last[i]);
            }
        }
        let runs = firsts.len();
        for i in 0..runs {
            sheet.set_next(lasts[i], firsts[(i + 1) % runs]);
        }
        sheet.set_face_halfedge(f, firsts[0]);
        for i in 0..n {
            sheet.set_vertex_halfedge(w[i], P_first[i]);
        }
        if !sheet.three_sides(f) {
            return None; // `f` would have fewer than 3 sides
        }
        if (0..n).any(|i| !sheet.two_spokes(w[i])) {
            return None; // `w[i]` would keep a single edge
        }
        if !sheet.meets_once(f) {
            return None; // `f` would meet a vertex twice
        }
    }

    // 2. Allocate what is new.
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        let mut h_2 = P_first[i];
        while h_2 != k[(i + 1) % n] {
            mesh.set_face(h_2, f);
            h_2 = mesh.next(h_2);
        }
    }
    let mut firsts: Vec<HalfedgeId> = Vec::new();
    let mut lasts: Vec<HalfedgeId> = Vec::new();
    for i in 0..n {
        if !P_is_empty[i] {
            firsts.push(P_first[i]);
            lasts.push(P_last[i]);
        }
    }
    let runs = firsts.len();
    for i in 0..runs {
        mesh.set_next(lasts[i], firsts[(i + 1) % runs]);
        mesh.set_prev(firsts[(i + 1) % runs], lasts[i]);
    }
    mesh.set_face_halfedge(f, firsts[0]);
    for i in 0..n {
        mesh.set_vertex_halfedge(w[i], P_first[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(v);
    for i in 0..n {
        mesh.erase_halfedge(h[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(k[i]);
    }
    for i in 0..n {
        mesh.erase_edge(e[i]);
    }
    for i in 0..n {
        mesh.erase_face(g[i]);
    }
    Some(f)
}

/// Cuts off a vertex; returns the face that comes in its place.
/// By default `t = 0.3`.
pub fn families_bevel_vertex(mesh: &mut Mesh, v: VertexId, t: f64) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(v).is_none() {
        return None; // `v` is isolated: no halfedge starts there
    }
    let h_0 = mesh.vertex_halfedge(v);
    let h = mesh.spokes_from(h_0).collect::<Vec<_>>();
    let count = h.len();
    let k: Vec<HalfedgeId> = (0..count).map(|i| mesh.prev(h[(i + count - 1) % count])).collect();
    let g: Vec<FaceId> = (0..count).map(|i| mesh.face(h[i])).collect();
    let w: Vec<VertexId> = (0..count).map(|i| mesh.vertex(k[i])).collect();
    if (0..count).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..count).any(|i| mesh.twin(h[i]) != k[i]) {
        return None; // `h[i].twin` is not `k[i]`
    }
    if (0..count).any(|i| mesh.vertex(h[i]) != v) {
        return None; // `h[i]` does not start at `v`
    }
    let mut all: Vec<VertexId> = vec![v];
    for i in 0..count {
        all.push(w[i]);
    }
    if !all_differ(&all) {
        return None; // two of `v`, `w[i]` are one vertex
    }
    if !all_differ(&g) {
        return None; // two of `g[i]` are one face
    }
    let u_position: Vec<DVec3> = (0..count).map(|i| DVec3::lerp(mesh.position(v), mesh.position(w[i]), t)).collect();
    if (0..count).any(|i| !u_position[i].is_finite()) {
        return None; // the new position of `u[i]` is not finite
    }

    // 2. Allocate what is new.
    let u: Vec<_> = (0..count).map(|_| mesh.add_vertex()).collect();
    let s: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
    let m: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
    let n: Vec<_> = (0..count).map(|_| mesh.add_edge()).collect();
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    mesh.set_face_halfedge(f, m[0]);
    for i in 0..count {
        mesh.set_prev(h[i], s[i]);
        mesh.set_vertex(h[i], u[i]);
        mesh.set_next(k[(i + 1) % count], s[i]);
        mesh.set_next(s[i], h[i]);
        mesh.set_prev(s[i], k[(i + 1) % count]);
        mesh.set_twin(s[i], m[i]);
        mesh.set_vertex(s[i], u[(i + 1) % count]);
        mesh.set_edge(s[i], n[i]);
        mesh.set_face(s[i], g[i]);
        mesh.set_next(m[i], m[(i + 1) % count]);
        mesh.set_twin(m[i], s[i]);
        mesh.set_vertex(m[i], u[i]);
        mesh.set_edge(m[i], n[i]);
        mesh.set_face(m[i], f);
        mesh.set_prev(m[(i + 1) % count], m[i]);
        mesh.set_vertex_halfedge(u[i], h[i]);
        mesh.set_edge_halfedge(n[i], s[i]);
    }
    for i in 0..count {
        mesh.set_position(u[i], u_position[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(v);
    Some(f)
}

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
pub fn flip_flip(mesh: &mut Mesh, e: EdgeId) -> bool {
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

/// Rotates an edge between any two polygons by one corner. Nothing is walked: the rest of
/// the two loops, `P` and `Q`, stays where it is, so the time is constant.
#[allow(non_snake_case)]
pub fn flip_flip_any(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(mesh.next(b));
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(mesh.next(g));
        let P_first = mesh.next(b);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(g);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
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
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, Q_last);
        mesh.set_face(b, f1);
        mesh.set_next(P_last, g);
        mesh.set_prev(P_first, a);
        mesh.set_next(d, Q_first);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, P_last);
        mesh.set_face(g, f0);
        mesh.set_next(Q_last, b);
        mesh.set_prev(Q_first, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}

/// Splits an edge at its midpoint, and each triangle at it; returns the new vertex.
pub fn remesh_split(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    fn rule_interior(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let s = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let u = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let f3 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();
            let e3 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(c, p);
            mesh.set_next(d, s);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_next(g, u);
            mesh.set_prev(g, t);
            mesh.set_face(g, f3);
            mesh.set_prev(h, s);
            mesh.set_next(p, c);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(s, h);
            mesh.set_prev(s, d);
            mesh.set_twin(s, u);
            mesh.set_vertex(s, m);
            mesh.set_edge(s, e3);
            mesh.set_face(s, f1);
            mesh.set_next(t, g);
            mesh.set_prev(t, u);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f3);
            mesh.set_next(u, t);
            mesh.set_prev(u, g);
            mesh.set_twin(u, s);
            mesh.set_vertex(u, v3);
            mesh.set_edge(u, e3);
            mesh.set_face(u, f3);
            mesh.set_vertex_halfedge(m, p);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_edge_halfedge(e3, s);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_face_halfedge(f1, d);
            mesh.set_face_halfedge(f3, t);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_border(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let c = mesh.next(b);
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(c);
            let f1 = mesh.face(d);
            let P_first = mesh.next(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if !mesh.is_hole(f1) {
                continue; // `f1` is not a hole
            }
            if mesh.next(c) != a {
                continue; // `f0` is not a triangle
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(c, p);
            mesh.set_next(d, t);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_prev(P_first, t);
            mesh.set_next(p, c);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(t, P_first);
            mesh.set_prev(t, d);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f1);
            mesh.set_vertex_halfedge(m, p);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    rule_interior(mesh, e).or_else(|| rule_border(mesh, e))
}

/// Merges the two ends of an edge between triangles at its midpoint; v1 goes. Refuses where
/// the mesh would fold, or an edge longer than `longest` would come of it.
pub fn remesh_collapse(mesh: &mut Mesh, e: EdgeId, longest: f64) -> Option<VertexId> {
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
        if mesh.is_boundary_vertex(v0) {
            continue; // an end lies on the boundary
        }
        if mesh.is_boundary_vertex(v1) {
            continue; // an end lies on the boundary
        }
        let part = mesh.position(mesh.vertex(mesh.edge_halfedge(e))).lerp(mesh.position(mesh.target(mesh.edge_halfedge(e))), 0.5);
        let part_2 = mesh.position(mesh.vertex(mesh.edge_halfedge(e))).lerp(mesh.position(mesh.target(mesh.edge_halfedge(e))), 0.5);
        if !mesh.neighbors(v0).all(|w| DVec3::distance(mesh.position(w), part) < longest) {
            continue; // an edge would become too long
        }
        if !mesh.neighbors(v1).all(|w_2| DVec3::distance(mesh.position(w_2), part_2) < longest) {
            continue; // an edge would become too long
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

/// Rotates an edge between two triangles by one corner.
pub fn remesh_flip(mesh: &mut Mesh, e: EdgeId) -> bool {
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
            continue; // the edge is already there
        }
        if !(0.0 < DVec3::dot(DVec3::cross(mesh.position(v2) - mesh.position(v0), mesh.position(v3) - mesh.position(v0)), DVec3::cross(mesh.position(v3) - mesh.position(v1), mesh.position(v2) - mesh.position(v1)))) {
            continue; // the surface would fold
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

/// Splits an edge at its midpoint, and each triangle at it; returns the new vertex.
pub fn split_split(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    fn rule_interior(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let s = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let u = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let f3 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();
            let e3 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(c, p);
            mesh.set_next(d, s);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_next(g, u);
            mesh.set_prev(g, t);
            mesh.set_face(g, f3);
            mesh.set_prev(h, s);
            mesh.set_next(p, c);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(s, h);
            mesh.set_prev(s, d);
            mesh.set_twin(s, u);
            mesh.set_vertex(s, m);
            mesh.set_edge(s, e3);
            mesh.set_face(s, f1);
            mesh.set_next(t, g);
            mesh.set_prev(t, u);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f3);
            mesh.set_next(u, t);
            mesh.set_prev(u, g);
            mesh.set_twin(u, s);
            mesh.set_vertex(u, v3);
            mesh.set_edge(u, e3);
            mesh.set_face(u, f3);
            mesh.set_vertex_halfedge(m, p);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_edge_halfedge(e3, s);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_face_halfedge(f1, d);
            mesh.set_face_halfedge(f3, t);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_border(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let c = mesh.next(b);
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(c);
            let f1 = mesh.face(d);
            let P_first = mesh.next(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if !mesh.is_hole(f1) {
                continue; // `f1` is not a hole
            }
            if mesh.next(c) != a {
                continue; // `f0` is not a triangle
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(c, p);
            mesh.set_next(d, t);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_prev(P_first, t);
            mesh.set_next(p, c);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(t, P_first);
            mesh.set_prev(t, d);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f1);
            mesh.set_vertex_halfedge(m, p);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    rule_interior(mesh, e).or_else(|| rule_border(mesh, e))
}

/// Rotates the edge between two triangles: both of its ends step one corner counterclockwise.
///
/// ```text
///        v2                 v2
///       /  \               / | \ .
///     h2 f0 h1           h1  |  h5
///     /      \           /   |    \ .
///   v0---e0---v1   ->   v0 f0|e0 f1 v1
///     \      /           \   |    /
///     h4 f1 h5           h2  |  h4
///       \  /               \ | /
///        v3                 v3
/// ```
pub fn tutorial_flip(mesh: &mut Mesh, e0: EdgeId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e0 are tried.
    for h0 in [mesh.edge_halfedge(e0), mesh.twin(mesh.edge_halfedge(e0))] {
        let h1 = mesh.next(h0);
        let h2 = mesh.next(h1);
        let h3 = mesh.twin(h0);
        let h6 = mesh.twin(h1);
        let h7 = mesh.twin(h2);
        let h4 = mesh.next(h3);
        let h5 = mesh.next(h4);
        let h8 = mesh.twin(h4);
        let h9 = mesh.twin(h5);
        let f0 = mesh.face(h0);
        let v0 = mesh.vertex(h7);
        let v1 = mesh.vertex(h9);
        let v2 = mesh.vertex(h6);
        let f1 = mesh.face(h3);
        let v3 = mesh.vertex(h8);
        let e1 = mesh.edge(h1);
        let e2 = mesh.edge(h2);
        let e3 = mesh.edge(h4);
        let e4 = mesh.edge(h5);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
        }
        if mesh.next(h2) != h0 {
            continue; // `f0` is not a triangle
        }
        if mesh.next(h5) != h3 {
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

        // 3. Reassign every pointer that changes.
        mesh.set_vertex(h0, v3);
        mesh.set_twin(h1, h7);
        mesh.set_vertex(h1, v2);
        mesh.set_edge(h1, e2);
        mesh.set_twin(h2, h8);
        mesh.set_vertex(h2, v0);
        mesh.set_edge(h2, e3);
        mesh.set_vertex(h3, v2);
        mesh.set_twin(h4, h9);
        mesh.set_vertex(h4, v3);
        mesh.set_edge(h4, e4);
        mesh.set_twin(h5, h6);
        mesh.set_vertex(h5, v1);
        mesh.set_edge(h5, e1);
        mesh.set_twin(h6, h5);
        mesh.set_twin(h7, h1);
        mesh.set_twin(h8, h2);
        mesh.set_twin(h9, h4);
        mesh.set_vertex_halfedge(v0, h2);
        mesh.set_vertex_halfedge(v1, h5);
        mesh.set_vertex_halfedge(v2, h3);
        mesh.set_vertex_halfedge(v3, h0);
        mesh.set_edge_halfedge(e1, h5);
        mesh.set_edge_halfedge(e2, h1);
        mesh.set_edge_halfedge(e3, h2);
        mesh.set_edge_halfedge(e4, h4);
        return Some(e0);
    }
    None
}

/// Cuts an edge in two at its midpoint; returns the new vertex.
///
/// ```text
///      .---P---.               .---P---.
///      |  f0   |               |  f0   |
///      |       |               |       |
///      v0--e--v1     ->        v0--m--v1
///      |       |               |       |
///      |  f1   |               |  f1   |
///      '---Q---'               '---Q---'
/// ```
///
/// The loops at the edge, faces or holes, get a side more. Each of the two halfedges is
/// followed by a new one, and the twin of the old one is now the new one across. Never
/// refused.
#[allow(non_snake_case)]
pub fn polygon_bisect(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let Q_first = mesh.next(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 2. Allocate what is new.
        let m = mesh.add_vertex();
        let p = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let e1 = mesh.add_edge();

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, p);
        mesh.set_twin(a, q);
        mesh.set_prev(P_first, p);
        mesh.set_next(d, q);
        mesh.set_twin(d, p);
        mesh.set_edge(d, e1);
        mesh.set_prev(Q_first, q);
        mesh.set_next(p, P_first);
        mesh.set_prev(p, a);
        mesh.set_twin(p, d);
        mesh.set_vertex(p, m);
        mesh.set_edge(p, e1);
        mesh.set_face(p, f0);
        mesh.set_next(q, Q_first);
        mesh.set_prev(q, d);
        mesh.set_twin(q, a);
        mesh.set_vertex(q, m);
        mesh.set_edge(q, e);
        mesh.set_face(q, f1);
        mesh.set_vertex_halfedge(m, p);
        mesh.set_edge_halfedge(e, a);
        mesh.set_edge_halfedge(e1, p);
        mesh.set_position(m, m_position);
        return Some(m);
    }
    None
}

/// Cuts a face in two, from the corner where `a` starts to the corner where `b` starts;
/// returns the new edge.
///
/// ```text
///      v3--Q---v0              v3--Q---v0
///      |       |               |  g  / |
///      b       a               b   e   a
///      |   f   |     ->        | /  f  |
///      v2--P---v1              v2--P---v1
/// ```
///
/// Corners of different faces are refused, and corners that are neighbours: different names
/// are different vertices, so both `P` and `Q` have an edge at least, and both parts three
/// sides.
#[allow(non_snake_case)]
pub fn polygon_connect(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }

    // 2. Allocate what is new.
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != a {
        mesh.set_face(h, g);
        h = mesh.next(h);
    }
    mesh.set_prev(a, x);
    mesh.set_next(P_last, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(Q_last, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, P_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, Q_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, y);
    Some(e)
}

/// Removes an edge, the reverse of `connect`; the loops on its two sides become one, which is
/// returned.
///
/// ```text
///      .---P---v0              .---P---v0
///      |  f0 / |               |       |
///      |   e   |               |       |
///      | /  f1 |     ->        |   f0  |
///      v1--Q---.               v1--Q---.
/// ```
///
/// At the boundary the face joins the hole. Refused if an end would keep a single edge, if
/// the faces meet elsewhere too, or if two holes would meet at a vertex.
pub fn polygon_dissolve_edge(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
    #[allow(non_snake_case)]
    fn rule_inside(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }
            if (mesh.degree(v0) as i64) < 3 {
                continue; // `v0` would keep a single edge
            }
            if (mesh.degree(v1) as i64) < 3 {
                continue; // `v1` would keep a single edge
            }
            let mut corners: Vec<VertexId> = vec![v1, v0];
            let mut h = P_first;
            while h != a {
                if h != P_first {
                    corners.push(mesh.vertex(h));
                }
                h = mesh.next(h);
            }
            let mut h = Q_first;
            while h != d {
                if h != Q_first {
                    corners.push(mesh.vertex(h));
                }
                h = mesh.next(h);
            }
            if !all_differ(&corners) {
                continue; // `f0` would meet a vertex twice
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_border(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if !mesh.is_hole(f0) {
                continue; // `f0` is not a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if (mesh.degree(v0) as i64) < 3 {
                continue; // `v0` would keep a single edge
            }
            if (mesh.degree(v1) as i64) < 3 {
                continue; // `v1` would keep a single edge
            }
            let mut pinched = false;
            let mut h = Q_first;
            while h != d {
                if h != Q_first {
                    let mut holes = 0;
                    for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                        if mesh.face(s) == f1 || mesh.is_hole(mesh.face(s)) {
                            holes += 1;
                        }
                    }
                    if 1 < holes {
                        pinched = true;
                    }
                }
                h = mesh.next(h);
            }
            if pinched {
                continue; // the surface would be pinched at a vertex of `Q`
            }
            let mut corners: Vec<VertexId> = vec![v1, v0];
            let mut h = P_first;
            while h != a {
                if h != P_first {
                    corners.push(mesh.vertex(h));
                }
                h = mesh.next(h);
            }
            let mut h = Q_first;
            while h != d {
                if h != Q_first {
                    corners.push(mesh.vertex(h));
                }
                h = mesh.next(h);
            }
            if !all_differ(&corners) {
                continue; // `f0` would meet a vertex twice
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    rule_inside(mesh, e).or_else(|| rule_border(mesh, e))
}

/// Turns an edge between two faces: both of its ends step one corner counterclockwise.
///
/// ```text
///    . --P--- v2          . --P--- v2
///    |        |           |       /|
///    | f0     |           | f0   / |
///    |        |           |     /  |
///    v0 --e-- v1    ->    v0   e   v1
///    |        |           |   /    |
///    |     f1 |           |  /  f1 |
///    |        |           | /      |
///    v3 --Q-- .           v3 --Q-- .
/// ```
///
/// Nothing is walked and nothing moves but the edge: `P` and `Q`, the rest of the two faces,
/// stay where they are. Refused at the boundary; if an end would keep a single edge; if both
/// sides lead to one vertex; and if `v3` lies on `P`, or `v2` on `Q`: a face would meet it
/// twice.
#[allow(non_snake_case)]
pub fn polygon_flip(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(mesh.next(b));
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(mesh.next(g));
        let P_first = mesh.next(b);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(g);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
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
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        if (mesh.degree(v0) as i64) < 3 {
            continue; // `v0` would keep a single edge
        }
        if (mesh.degree(v1) as i64) < 3 {
            continue; // `v1` would keep a single edge
        }
        let mut meets = false;
        let mut h = P_first;
        while h != a {
            if h != P_first && mesh.vertex(h) == v3 {
                meets = true;
            }
            h = mesh.next(h);
        }
        if meets {
            continue; // `f0` would meet `v3` twice
        }
        let mut meets_2 = false;
        let mut h = Q_first;
        while h != d {
            if h != Q_first && mesh.vertex(h) == v2 {
                meets_2 = true;
            }
            h = mesh.next(h);
        }
        if meets_2 {
            continue; // `f1` would meet `v2` twice
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, Q_last);
        mesh.set_face(b, f1);
        mesh.set_next(P_last, g);
        mesh.set_prev(P_first, a);
        mesh.set_next(d, Q_first);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, P_last);
        mesh.set_face(g, f0);
        mesh.set_next(Q_last, b);
        mesh.set_prev(Q_first, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}

/// Cuts an edge at its midpoint, and from each face at it the next corner; returns the new
/// vertex, whose halfedge runs along the edge.
///
/// ```text
///    . --P--- v2          . --P--- v2
///    |        |           |      / |
///    | f0     |           | f0  /f2|
///    |        |           |    /   |
///    v0 --e-- v1    ->    v0 - m - v1
///    |        |           |   /    |
///    |     f1 |           |f3/  f1 |
///    |        |           | /      |
///    v3 --Q-- .           v3 --Q-- .
/// ```
///
/// What is new lies around the new vertex, so nothing can go wrong: no test is made, and it is
/// never refused.
pub fn polygon_split(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    #[allow(non_snake_case)]
    fn rule_inside(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let d = mesh.twin(a);
            let g = mesh.next(d);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(mesh.next(b));
            let f1 = mesh.face(d);
            let v3 = mesh.vertex(mesh.next(g));
            let P_first = mesh.next(b);
            let Q_first = mesh.next(g);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
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
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let s = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let u = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let f3 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();
            let e3 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(P_first, p);
            mesh.set_next(d, s);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_next(g, u);
            mesh.set_prev(g, t);
            mesh.set_face(g, f3);
            mesh.set_prev(Q_first, s);
            mesh.set_next(p, P_first);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(s, Q_first);
            mesh.set_prev(s, d);
            mesh.set_twin(s, u);
            mesh.set_vertex(s, m);
            mesh.set_edge(s, e3);
            mesh.set_face(s, f1);
            mesh.set_next(t, g);
            mesh.set_prev(t, u);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f3);
            mesh.set_next(u, t);
            mesh.set_prev(u, g);
            mesh.set_twin(u, s);
            mesh.set_vertex(u, v3);
            mesh.set_edge(u, e3);
            mesh.set_face(u, f3);
            mesh.set_vertex_halfedge(m, q);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_edge_halfedge(e3, s);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_face_halfedge(f1, d);
            mesh.set_face_halfedge(f3, t);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_inside_one_tip(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let d = mesh.twin(a);
            let g = mesh.next(d);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(mesh.next(b));
            let f1 = mesh.face(d);
            let P_first = mesh.next(b);
            let Q_first = mesh.next(g);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
            }
            if mesh.vertex(mesh.next(g)) != v2 {
                continue; // `g` does not end at `v2`
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let s = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let u = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let f3 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();
            let e3 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(P_first, p);
            mesh.set_next(d, s);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_next(g, u);
            mesh.set_prev(g, t);
            mesh.set_face(g, f3);
            mesh.set_prev(Q_first, s);
            mesh.set_next(p, P_first);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(s, Q_first);
            mesh.set_prev(s, d);
            mesh.set_twin(s, u);
            mesh.set_vertex(s, m);
            mesh.set_edge(s, e3);
            mesh.set_face(s, f1);
            mesh.set_next(t, g);
            mesh.set_prev(t, u);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f3);
            mesh.set_next(u, t);
            mesh.set_prev(u, g);
            mesh.set_twin(u, s);
            mesh.set_vertex(u, v2);
            mesh.set_edge(u, e3);
            mesh.set_face(u, f3);
            mesh.set_vertex_halfedge(m, q);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_edge_halfedge(e3, s);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_face_halfedge(f1, d);
            mesh.set_face_halfedge(f3, t);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_border(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(mesh.next(b));
            let f1 = mesh.face(d);
            let P_first = mesh.next(b);
            let Q_first = mesh.next(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if !mesh.is_hole(f1) {
                continue; // `f1` is not a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 2. Allocate what is new.
            let m = mesh.add_vertex();
            let p = mesh.add_halfedge();
            let q = mesh.add_halfedge();
            let r = mesh.add_halfedge();
            let t = mesh.add_halfedge();
            let f2 = mesh.add_face();
            let e1 = mesh.add_edge();
            let e2 = mesh.add_edge();

            // 3. Reassign every pointer that changes.
            mesh.set_next(a, p);
            mesh.set_twin(a, t);
            mesh.set_next(b, r);
            mesh.set_prev(b, q);
            mesh.set_face(b, f2);
            mesh.set_prev(P_first, p);
            mesh.set_next(d, t);
            mesh.set_twin(d, q);
            mesh.set_edge(d, e1);
            mesh.set_prev(Q_first, t);
            mesh.set_next(p, P_first);
            mesh.set_prev(p, a);
            mesh.set_twin(p, r);
            mesh.set_vertex(p, m);
            mesh.set_edge(p, e2);
            mesh.set_face(p, f0);
            mesh.set_next(q, b);
            mesh.set_prev(q, r);
            mesh.set_twin(q, d);
            mesh.set_vertex(q, m);
            mesh.set_edge(q, e1);
            mesh.set_face(q, f2);
            mesh.set_next(r, q);
            mesh.set_prev(r, b);
            mesh.set_twin(r, p);
            mesh.set_vertex(r, v2);
            mesh.set_edge(r, e2);
            mesh.set_face(r, f2);
            mesh.set_next(t, Q_first);
            mesh.set_prev(t, d);
            mesh.set_twin(t, a);
            mesh.set_vertex(t, m);
            mesh.set_edge(t, e);
            mesh.set_face(t, f1);
            mesh.set_vertex_halfedge(m, q);
            mesh.set_edge_halfedge(e, a);
            mesh.set_edge_halfedge(e1, q);
            mesh.set_edge_halfedge(e2, p);
            mesh.set_face_halfedge(f0, a);
            mesh.set_face_halfedge(f2, q);
            mesh.set_position(m, m_position);
            return Some(m);
        }
        None
    }

    rule_inside(mesh, e).or_else(|| rule_inside_one_tip(mesh, e)).or_else(|| rule_border(mesh, e))
}

/// Merges the two ends of an edge at its midpoint, and returns the vertex.
///
/// ```text
///      .--P---v2---.           .--P---v2---.
///      |  f0 /  \  |           |   f0 |    |
///      |    c f1 b |           |      |    |
///      '--v0--e--v1-'    ->    '------v0---'
/// ```
///
/// A face at the edge loses a side. A triangle would be left with two: it vanishes, and its
/// two other edges become one. So there is a rule for two triangles, one for a triangle and
/// anything else, and one for no triangle. Rules are tried in order, and a rule whose guard
/// says no leaves its place to the next; the last two need not say that a face is larger than
/// a triangle, since their guard does.
///
/// Refused if two boundaries would be pinched together, if a vertex would keep a single edge,
/// and for a triangle that is all there is of the surface, or half of it.
pub fn polygon_collapse(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    fn rule_two_triangles(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
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
            if (mesh.degree(v2) as i64) < 3 {
                continue; // `v2` would keep a single edge
            }
            if (mesh.degree(v3) as i64) < 3 {
                continue; // `v3` would keep a single edge
            }
            let mut holes = 0;
            if mesh.is_hole(mesh.face(c_)) {
                holes += 1;
            }
            if mesh.is_hole(mesh.face(h_)) {
                holes += 1;
            }
            for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h_2 != a && h_2 != g && h_2 != c_ && mesh.is_hole(mesh.face(h_2)) {
                    holes += 1;
                }
            }
            for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h_2 != b && h_2 != d && h_2 != h_ && mesh.is_hole(mesh.face(h_2)) {
                    holes += 1;
                }
            }
            if 1 < holes {
                continue; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
            }
            let mut faces: Vec<FaceId> = vec![mesh.face(c_), mesh.face(h_)];
            for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h_2 != a && h_2 != g && h_2 != c_ {
                    faces.push(mesh.face(h_2));
                }
            }
            for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h_2 != b && h_2 != d && h_2 != h_ {
                    faces.push(mesh.face(h_2));
                }
            }
            if !all_differ(&faces) {
                continue; // a face around both `v0` and `v1` would meet `v0` twice
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

    #[allow(non_snake_case)]
    fn rule_triangle(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let c = mesh.next(b);
            let d = mesh.twin(a);
            let b_ = mesh.twin(b);
            let c_ = mesh.twin(c);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(c_);
            let v1 = mesh.vertex(d);
            let v2 = mesh.vertex(b_);
            let f1 = mesh.face(d);
            let eb = mesh.edge(b);
            let ec = mesh.edge(c);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.next(c) != a {
                continue; // `f0` is not a triangle
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v2 {
                continue; // `v0` and `v2` are one vertex
            }
            if v1 == v2 {
                continue; // `v1` and `v2` are one vertex
            }
            if (mesh.face_size(f1) as i64) < 4 {
                continue; // `f1` would have fewer than 3 sides
            }
            if (mesh.degree(v2) as i64) < 3 {
                continue; // `v2` would keep a single edge
            }
            let mut holes = 0;
            if mesh.is_hole(mesh.face(c_)) {
                holes += 1;
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h != a && h != c_ && mesh.is_hole(mesh.face(h)) {
                    holes += 1;
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h != b && h != d && mesh.is_hole(mesh.face(h)) {
                    holes += 1;
                }
            }
            if 1 < holes {
                continue; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
            }
            let mut faces: Vec<FaceId> = vec![mesh.face(c_)];
            for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h != a && h != c_ {
                    faces.push(mesh.face(h));
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h != b && h != d {
                    faces.push(mesh.face(h));
                }
            }
            if !all_differ(&faces) {
                continue; // a face around both `v0` and `v1` would meet `v0` twice
            }
            let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h = mesh.next(b_);
            while h != d {
                mesh.set_vertex(h, v0);
                h = mesh.next(mesh.twin(h));
            }
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_twin(b_, c_);
            mesh.set_twin(c_, b_);
            mesh.set_edge(c_, eb);
            mesh.set_vertex_halfedge(v0, c_);
            mesh.set_vertex_halfedge(v2, b_);
            mesh.set_edge_halfedge(eb, b_);
            mesh.set_face_halfedge(f1, Q_first);
            mesh.set_position(v0, v0_position);

            // 4. Erase what is gone.
            mesh.erase_vertex(v1);
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_halfedge(b);
            mesh.erase_halfedge(c);
            mesh.erase_face(f0);
            mesh.erase_edge(ec);
            return Some(v0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_no_triangle(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }
            if (mesh.face_size(f0) as i64) < 4 {
                continue; // `f0` would have fewer than 3 sides
            }
            if (mesh.face_size(f1) as i64) < 4 {
                continue; // `f1` would have fewer than 3 sides
            }
            let mut holes = 0;
            for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h != a && mesh.is_hole(mesh.face(h)) {
                    holes += 1;
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h != d && mesh.is_hole(mesh.face(h)) {
                    holes += 1;
                }
            }
            if 1 < holes {
                continue; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
            }
            let mut faces: Vec<FaceId> = Vec::new();
            for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h != a {
                    faces.push(mesh.face(h));
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h != d {
                    faces.push(mesh.face(h));
                }
            }
            if !all_differ(&faces) {
                continue; // a face around both `v0` and `v1` would meet `v0` twice
            }
            let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h = mesh.next(a);
            while h != d {
                mesh.set_vertex(h, v0);
                h = mesh.next(mesh.twin(h));
            }
            mesh.set_next(P_last, P_first);
            mesh.set_prev(P_first, P_last);
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_vertex_halfedge(v0, P_first);
            mesh.set_face_halfedge(f0, P_first);
            mesh.set_face_halfedge(f1, Q_first);
            mesh.set_position(v0, v0_position);

            // 4. Erase what is gone.
            mesh.erase_vertex(v1);
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            return Some(v0);
        }
        None
    }

    rule_two_triangles(mesh, e).or_else(|| rule_triangle(mesh, e)).or_else(|| rule_no_triangle(mesh, e))
}

/// Raises a face: a ring of quads comes between its old sides and the face, which is returned.
///
/// ```text
///     v3----------v2          v3----------v2
///     |            |          | \        / |
///     |            |          |  w3----w2  |
///     |     f      |    ->    |  |  f  |   |
///     |            |          |  w0----w1  |
///     |            |          | /        \ |
///     v0----------v1          v0----------v1
/// ```
///
/// The new corners start where the old ones are. `shrink` moves them towards the centroid, all
/// the way for 1; `distance` along the normal of the face.
/// By default `distance = 0.0`, `shrink = 0.0`.
pub fn polygon_extrude(mesh: &mut Mesh, f: FaceId, distance: f64, shrink: f64) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let centroid = mesh.centroid(f);
    let part = mesh.normal(f) * distance;
    let w_position: Vec<DVec3> = (0..n).map(|i| DVec3::lerp(mesh.position(v[i]), centroid, shrink) + part).collect();
    if (0..n).any(|i| !w_position[i].is_finite()) {
        return None; // the new position of `w[i]` is not finite
    }

    // 2. Allocate what is new.
    let w: Vec<_> = (0..n).map(|_| mesh.add_vertex()).collect();
    let s: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let r: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
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
        mesh.set_next(r[i], b[i]);
        mesh.set_prev(r[i], a[i]);
        mesh.set_twin(r[i], s[i]);
        mesh.set_vertex(r[i], w[(i + 1) % n]);
        mesh.set_edge(r[i], c[i]);
        mesh.set_face(r[i], q[i]);
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
        mesh.set_vertex_halfedge(w[i], s[i]);
        mesh.set_edge_halfedge(c[i], s[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(q[i], h[i]);
    }
    for i in 0..n {
        mesh.set_position(w[i], w_position[i]);
    }
    Some(f)
}

/// Puts a vertex at the centroid of a face, and an edge from each corner to it; returns the
/// vertex.
///
/// ```text
///     v3--------v2            v3--------v2
///     |          |            | \      / |
///     |    f     |     ->     |    v     |
///     |          |            | /      \ |
///     v0--------v1            v0--------v1
/// ```
pub fn polygon_inset_vertex(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let w: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&w) {
        return None; // two of `w[i]` are one vertex
    }
    let v_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let v = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let e: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(v, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], w[(i + 1) % n]);
        mesh.set_edge(a[i], e[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], v);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], e[i]);
        mesh.set_edge_halfedge(e[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(v, v_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(v)
}

/// Makes two boundary edges one, and returns it; their ends meet at the midpoints.
///
/// ```text
///    //v1--P--v2//           //.--P--v1//
///    //|      |///           //|    /////
///    //e  f   e2//    ->     //'--e--////
///    //|      |///           //////    |
///    //v0--Q--v3//           //v0--Q--'//
/// ```
///
/// The hole between them is parted into two: what bounds it from one edge to the other, and
/// back. Edges that are neighbours close it like a zip. Edges of two holes make them one.
/// Refused inside; if a hole of fewer than three edges would be left; and if a face would be
/// folded onto itself.
pub fn polygon_weld(mesh: &mut Mesh, e: EdgeId, e2: EdgeId) -> Option<EdgeId> {
    #[allow(non_snake_case)]
    fn rule_two_holes(mesh: &mut Mesh, e: EdgeId, e2: EdgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let a_ = mesh.twin(a);
            // Both directions of e2 are tried.
            for b in [mesh.edge_halfedge(e2), mesh.twin(mesh.edge_halfedge(e2))] {
                let b_ = mesh.twin(b);
                let f = mesh.face(a);
                let v0 = mesh.vertex(a);
                let v1 = mesh.vertex(a_);
                let g = mesh.face(b);
                let v2 = mesh.vertex(b);
                let v3 = mesh.vertex(b_);
                let P_first = mesh.next(a);
                let P_last = mesh.prev(a);
                let Q_first = mesh.next(b);
                let Q_last = mesh.prev(b);
                if !mesh.is_hole(f) {
                    continue; // `f` is not a hole
                }
                if !mesh.is_hole(g) {
                    continue; // `g` is not a hole
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
                if f == g {
                    continue; // `f` and `g` are one face
                }
                let mut corners: Vec<VertexId> = vec![v1, v0];
                let mut h = P_first;
                while h != a {
                    if h != P_first {
                        corners.push(if mesh.vertex(h) == v3 { v0 } else { if mesh.vertex(h) == v2 { v1 } else { mesh.vertex(h) } });
                    }
                    h = mesh.next(h);
                }
                let mut h = Q_first;
                while h != b {
                    if h != Q_first {
                        corners.push(if mesh.vertex(h) == v3 { v0 } else { if mesh.vertex(h) == v2 { v1 } else { mesh.vertex(h) } });
                    }
                    h = mesh.next(h);
                }
                if !all_differ(&corners) {
                    continue; // `f` would meet a vertex twice
                }
                let mut faces: Vec<FaceId> = vec![if mesh.face(b_) == g { f } else { mesh.face(b_) }];
                for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                    if h != a {
                        faces.push(if mesh.face(h) == g { f } else { mesh.face(h) });
                    }
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v3)).collect::<Vec<_>>() {
                    if h != b_ {
                        faces.push(if mesh.face(h) == g { f } else { mesh.face(h) });
                    }
                }
                if !all_differ(&faces) {
                    continue; // a face around both `v0` and `v3` would meet `v0` twice
                }
                let mut faces_2: Vec<FaceId> = vec![if mesh.face(a_) == g { f } else { mesh.face(a_) }];
                for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                    if h != a_ {
                        faces_2.push(if mesh.face(h) == g { f } else { mesh.face(h) });
                    }
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
                    if h != b {
                        faces_2.push(if mesh.face(h) == g { f } else { mesh.face(h) });
                    }
                }
                if !all_differ(&faces_2) {
                    continue; // a face around both `v1` and `v2` would meet `v1` twice
                }
                let v0_position = (mesh.position(v0) + mesh.position(v3)) / 2.0;
                let v1_position = (mesh.position(v1) + mesh.position(v2)) / 2.0;

                // 3. Reassign every pointer that changes.
                let mut h = Q_first;
                while h != b {
                    mesh.set_face(h, f);
                    h = mesh.next(h);
                }
                let mut h = mesh.next(b_);
                while h != b {
                    mesh.set_vertex(h, v1);
                    h = mesh.next(mesh.twin(h));
                }
                let mut h = mesh.next(b);
                while h != b_ {
                    mesh.set_vertex(h, v0);
                    h = mesh.next(mesh.twin(h));
                }
                mesh.set_next(P_last, Q_first);
                mesh.set_prev(P_first, Q_last);
                mesh.set_next(Q_last, P_first);
                mesh.set_prev(Q_first, P_last);
                mesh.set_twin(a_, b_);
                mesh.set_twin(b_, a_);
                mesh.set_vertex(b_, v0);
                mesh.set_edge(b_, e);
                mesh.set_vertex_halfedge(v0, b_);
                mesh.set_edge_halfedge(e, a_);
                mesh.set_face_halfedge(f, P_first);
                mesh.set_position(v0, v0_position);
                mesh.set_position(v1, v1_position);

                // 4. Erase what is gone.
                mesh.erase_halfedge(a);
                mesh.erase_halfedge(b);
                mesh.erase_face(g);
                mesh.erase_edge(e2);
                mesh.erase_vertex(v2);
                mesh.erase_vertex(v3);
                return Some(e);
            }
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_one_hole(mesh: &mut Mesh, e: EdgeId, e2: EdgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let p = mesh.next(a);
            let q = mesh.next(p);
            let a_ = mesh.twin(a);
            // Both directions of e2 are tried.
            for b in [mesh.edge_halfedge(e2), mesh.twin(mesh.edge_halfedge(e2))] {
                let r = mesh.next(b);
                let s = mesh.next(r);
                let b_ = mesh.twin(b);
                let f = mesh.face(a);
                let v0 = mesh.vertex(a);
                let v1 = mesh.vertex(a_);
                let x1 = mesh.vertex(q);
                let x2 = mesh.vertex(mesh.next(q));
                let v2 = mesh.vertex(b);
                let v3 = mesh.vertex(b_);
                let y1 = mesh.vertex(s);
                let y2 = mesh.vertex(mesh.next(s));
                let P_last = mesh.prev(b);
                let Q_first = mesh.next(s);
                let Q_last = mesh.prev(a);
                if !mesh.is_hole(f) {
                    continue; // `f` is not a hole
                }
                if mesh.face(b) != f {
                    continue; // `b` does not lie in `f`
                }
                if v0 == v1 {
                    continue; // `v0` and `v1` are one vertex
                }
                if v0 == x1 {
                    continue; // `v0` and `x1` are one vertex
                }
                if v0 == x2 {
                    continue; // `v0` and `x2` are one vertex
                }
                if v0 == v2 {
                    continue; // `v0` and `v2` are one vertex
                }
                if v0 == v3 {
                    continue; // `v0` and `v3` are one vertex
                }
                if v0 == y1 {
                    continue; // `v0` and `y1` are one vertex
                }
                if v0 == y2 {
                    continue; // `v0` and `y2` are one vertex
                }
                if v1 == x1 {
                    continue; // `v1` and `x1` are one vertex
                }
                if v1 == x2 {
                    continue; // `v1` and `x2` are one vertex
                }
                if v1 == v2 {
                    continue; // `v1` and `v2` are one vertex
                }
                if v1 == v3 {
                    continue; // `v1` and `v3` are one vertex
                }
                if v1 == y1 {
                    continue; // `v1` and `y1` are one vertex
                }
                if v1 == y2 {
                    continue; // `v1` and `y2` are one vertex
                }
                if x1 == x2 {
                    continue; // `x1` and `x2` are one vertex
                }
                if x1 == v2 {
                    continue; // `x1` and `v2` are one vertex
                }
                if x1 == v3 {
                    continue; // `x1` and `v3` are one vertex
                }
                if x1 == y1 {
                    continue; // `x1` and `y1` are one vertex
                }
                if x1 == y2 {
                    continue; // `x1` and `y2` are one vertex
                }
                if x2 == v2 {
                    continue; // `x2` and `v2` are one vertex
                }
                if x2 == v3 {
                    continue; // `x2` and `v3` are one vertex
                }
                if x2 == y1 {
                    continue; // `x2` and `y1` are one vertex
                }
                if x2 == y2 {
                    continue; // `x2` and `y2` are one vertex
                }
                if v2 == v3 {
                    continue; // `v2` and `v3` are one vertex
                }
                if v2 == y1 {
                    continue; // `v2` and `y1` are one vertex
                }
                if v2 == y2 {
                    continue; // `v2` and `y2` are one vertex
                }
                if v3 == y1 {
                    continue; // `v3` and `y1` are one vertex
                }
                if v3 == y2 {
                    continue; // `v3` and `y2` are one vertex
                }
                if y1 == y2 {
                    continue; // `y1` and `y2` are one vertex
                }
                let mut along: Vec<HalfedgeId> = Vec::new();
                let mut h = Q_first;
                while h != a {
                    along.push(h);
                    h = mesh.next(h);
                }
                let mut faces: Vec<FaceId> = Vec::new();
                let mut count = 1;
                if !along.contains(&b_) {
                    faces.push(mesh.face(b_));
                }
                if along.contains(&b_) {
                    count += 1;
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                    if h != a {
                        if !along.contains(&h) {
                            faces.push(mesh.face(h));
                        }
                        if along.contains(&h) {
                            count += 1;
                        }
                    }
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v3)).collect::<Vec<_>>() {
                    if h != r && h != b_ {
                        if !along.contains(&h) {
                            faces.push(mesh.face(h));
                        }
                        if along.contains(&h) {
                            count += 1;
                        }
                    }
                }
                if !all_differ(&faces) || 1 < count {
                    continue; // a face around both `v0` and `v3` would meet `v0` twice
                }
                let mut faces_2: Vec<FaceId> = vec![f];
                let mut count_2 = 0;
                if !along.contains(&a_) {
                    faces_2.push(mesh.face(a_));
                }
                if along.contains(&a_) {
                    count_2 += 1;
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                    if h != p && h != a_ {
                        if !along.contains(&h) {
                            faces_2.push(mesh.face(h));
                        }
                        if along.contains(&h) {
                            count_2 += 1;
                        }
                    }
                }
                for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
                    if h != b {
                        if !along.contains(&h) {
                            faces_2.push(mesh.face(h));
                        }
                        if along.contains(&h) {
                            count_2 += 1;
                        }
                    }
                }
                if !all_differ(&faces_2) || 1 < count_2 {
                    continue; // a face around both `v1` and `v2` would meet `v1` twice
                }
                let v0_position = (mesh.position(v0) + mesh.position(v3)) / 2.0;
                let v1_position = (mesh.position(v1) + mesh.position(v2)) / 2.0;

                // 2. Allocate what is new.
                let g = mesh.add_face();

                // 3. Reassign every pointer that changes.
                let mut h = Q_first;
                while h != a {
                    mesh.set_face(h, g);
                    h = mesh.next(h);
                }
                let mut h = mesh.next(b_);
                while h != b {
                    mesh.set_vertex(h, v1);
                    h = mesh.next(mesh.twin(h));
                }
                let mut h = mesh.next(mesh.twin(r));
                while h != b_ {
                    mesh.set_vertex(h, v0);
                    h = mesh.next(mesh.twin(h));
                }
                mesh.set_prev(p, P_last);
                mesh.set_next(P_last, p);
                mesh.set_prev(r, Q_last);
                mesh.set_vertex(r, v0);
                mesh.set_face(r, g);
                mesh.set_face(s, g);
                mesh.set_next(Q_last, r);
                mesh.set_twin(a_, b_);
                mesh.set_twin(b_, a_);
                mesh.set_vertex(b_, v0);
                mesh.set_edge(b_, e);
                mesh.set_vertex_halfedge(v0, b_);
                mesh.set_edge_halfedge(e, a_);
                mesh.set_face_halfedge(f, p);
                mesh.set_face_halfedge(g, r);
                mesh.set_hole(g, true);
                mesh.set_position(v0, v0_position);
                mesh.set_position(v1, v1_position);

                // 4. Erase what is gone.
                mesh.erase_halfedge(a);
                mesh.erase_halfedge(b);
                mesh.erase_edge(e2);
                mesh.erase_vertex(v2);
                mesh.erase_vertex(v3);
                return Some(e);
            }
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_neighbours(mesh: &mut Mesh, e: EdgeId, e2: EdgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.next(a);
            let a_ = mesh.twin(a);
            let b_ = mesh.twin(b);
            let f = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(a_);
            let v3 = mesh.vertex(b_);
            let Q_first = mesh.next(b);
            let Q_last = mesh.prev(a);
            if mesh.edge(b) != e2 {
                continue; // `b.edge` is not `e2`
            }
            if !mesh.is_hole(f) {
                continue; // `f` is not a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if v0 == v3 {
                continue; // `v0` and `v3` are one vertex
            }
            if v1 == v3 {
                continue; // `v1` and `v3` are one vertex
            }
            if (mesh.face_size(f) as i64) < 5 {
                continue; // `f` would have fewer than 3 sides
            }
            if (mesh.degree(v1) as i64) < 3 {
                continue; // `v1` would keep a single edge
            }
            let mut faces: Vec<FaceId> = vec![mesh.face(b_)];
            for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
                if h != a {
                    faces.push(mesh.face(h));
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v3)).collect::<Vec<_>>() {
                if h != b_ {
                    faces.push(mesh.face(h));
                }
            }
            if !all_differ(&faces) {
                continue; // a face around both `v0` and `v3` would meet `v0` twice
            }
            let v0_position = (mesh.position(v0) + mesh.position(v3)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h = mesh.next(b);
            while h != b_ {
                mesh.set_vertex(h, v0);
                h = mesh.next(mesh.twin(h));
            }
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_twin(a_, b_);
            mesh.set_twin(b_, a_);
            mesh.set_vertex(b_, v0);
            mesh.set_edge(b_, e);
            mesh.set_vertex_halfedge(v0, b_);
            mesh.set_vertex_halfedge(v1, a_);
            mesh.set_edge_halfedge(e, a_);
            mesh.set_face_halfedge(f, Q_first);
            mesh.set_position(v0, v0_position);

            // 4. Erase what is gone.
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(b);
            mesh.erase_edge(e2);
            mesh.erase_vertex(v3);
            return Some(e);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_other_neighbours(mesh: &mut Mesh, e: EdgeId, e2: EdgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let b = mesh.prev(a);
            let a_ = mesh.twin(a);
            let b_ = mesh.twin(b);
            let f = mesh.face(b);
            let v2 = mesh.vertex(b);
            let v3 = mesh.vertex(b_);
            let v1 = mesh.vertex(a_);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(b);
            if mesh.edge(b) != e2 {
                continue; // `b.edge` is not `e2`
            }
            if !mesh.is_hole(f) {
                continue; // `f` is not a hole
            }
            if v2 == v3 {
                continue; // `v2` and `v3` are one vertex
            }
            if v2 == v1 {
                continue; // `v2` and `v1` are one vertex
            }
            if v3 == v1 {
                continue; // `v3` and `v1` are one vertex
            }
            if (mesh.face_size(f) as i64) < 5 {
                continue; // `f` would have fewer than 3 sides
            }
            if (mesh.degree(v3) as i64) < 3 {
                continue; // `v3` would keep a single edge
            }
            let mut faces: Vec<FaceId> = vec![mesh.face(a_)];
            for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
                if h != b {
                    faces.push(mesh.face(h));
                }
            }
            for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
                if h != a_ {
                    faces.push(mesh.face(h));
                }
            }
            if !all_differ(&faces) {
                continue; // a face around both `v1` and `v2` would meet `v1` twice
            }
            let v1_position = (mesh.position(v1) + mesh.position(v2)) / 2.0;

            // 3. Reassign every pointer that changes.
            let mut h = mesh.next(b_);
            while h != b {
                mesh.set_vertex(h, v1);
                h = mesh.next(mesh.twin(h));
            }
            mesh.set_next(P_last, P_first);
            mesh.set_prev(P_first, P_last);
            mesh.set_twin(a_, b_);
            mesh.set_twin(b_, a_);
            mesh.set_edge(b_, e);
            mesh.set_vertex_halfedge(v3, b_);
            mesh.set_edge_halfedge(e, a_);
            mesh.set_face_halfedge(f, P_first);
            mesh.set_position(v1, v1_position);

            // 4. Erase what is gone.
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(b);
            mesh.erase_edge(e2);
            mesh.erase_vertex(v2);
            return Some(e);
        }
        None
    }

    rule_two_holes(mesh, e, e2).or_else(|| rule_one_hole(mesh, e, e2)).or_else(|| rule_neighbours(mesh, e, e2)).or_else(|| rule_other_neighbours(mesh, e, e2))
}

/// Splits an edge between two triangles, and marks what is new, as remeshers do.
pub fn attributes_split_marked(mesh: &mut Mesh, e: EdgeId, t: f64) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    let tint_column = mesh.find_column(ElementKind::Vertex, "tint");
    let Some(tint_column) = tint_column.filter(|&c| mesh.values::<DVec3>(c).is_some()) else {
        return None; // the mesh has no attribute `tint` of this type
    };
    let mark_column = mesh.find_column(ElementKind::Halfedge, "mark");
    let Some(mark_column) = mark_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `mark` of this type
    };
    let fresh_column = mesh.find_column(ElementKind::Edge, "fresh");
    let Some(fresh_column) = fresh_column.filter(|&c| mesh.values::<bool>(c).is_some()) else {
        return None; // the mesh has no attribute `fresh` of this type
    };
    let class_column = mesh.find_column(ElementKind::Face, "class");
    let Some(class_column) = class_column.filter(|&c| mesh.values::<i64>(c).is_some()) else {
        return None; // the mesh has no attribute `class` of this type
    };
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
        if attribute::<bool>(mesh, fresh_column, e.0) {
            continue; // the edge is new
        }
        if attribute::<i64>(mesh, class_column, f0.0) != attribute::<i64>(mesh, class_column, f1.0) && !(attribute::<f64>(mesh, weight_column, v0.0) < attribute::<f64>(mesh, weight_column, v1.0) + attribute::<f64>(mesh, mark_column, a.0)) {
            continue; // it lies between classes
        }
        let m_position = DVec3::lerp(mesh.position(v0), mesh.position(v1), t);
        if !m_position.is_finite() {
            continue; // the new position of `m` is not finite
        }
        let m_weight = (attribute::<f64>(mesh, weight_column, v0.0) + attribute::<f64>(mesh, weight_column, v1.0)) / 2.0;
        let m_tint = DVec3::lerp(attribute::<DVec3>(mesh, tint_column, v0.0), attribute::<DVec3>(mesh, tint_column, v1.0), t) + DVec3::new(attribute::<f64>(mesh, mark_column, a.0), 0.0, 1.0);
        let p_mark = attribute::<f64>(mesh, mark_column, a.0) + 1.0;
        let q_mark = f64::max(attribute::<f64>(mesh, mark_column, b.0), attribute::<f64>(mesh, mark_column, c.0));
        let eq_fresh = true;
        let er_fresh = !attribute::<bool>(mesh, fresh_column, e.0);
        let g0_class_ = attribute::<i64>(mesh, class_column, f0.0);
        let f1_class_ = attribute::<i64>(mesh, class_column, f1.0) + 2;

        // 2. Allocate what is new.
        let m = mesh.add_vertex();
        let p = mesh.add_halfedge();
        let p_ = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let q_ = mesh.add_halfedge();
        let r = mesh.add_halfedge();
        let r_ = mesh.add_halfedge();
        let ep = mesh.add_edge();
        let eq = mesh.add_edge();
        let er = mesh.add_edge();
        let g0 = mesh.add_face();
        let g1 = mesh.add_face();

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, q);
        mesh.set_next(b, q_);
        mesh.set_prev(b, p);
        mesh.set_face(b, g0);
        mesh.set_prev(c, q);
        mesh.set_prev(d, r);
        mesh.set_vertex(d, m);
        mesh.set_next(g, r);
        mesh.set_next(h, p_);
        mesh.set_prev(h, r_);
        mesh.set_face(h, g1);
        mesh.set_next(p, b);
        mesh.set_prev(p, q_);
        mesh.set_twin(p, p_);
        mesh.set_vertex(p, m);
        mesh.set_edge(p, ep);
        mesh.set_face(p, g0);
        mesh.set_next(p_, r_);
        mesh.set_prev(p_, h);
        mesh.set_twin(p_, p);
        mesh.set_vertex(p_, v1);
        mesh.set_edge(p_, ep);
        mesh.set_face(p_, g1);
        mesh.set_next(q, c);
        mesh.set_prev(q, a);
        mesh.set_twin(q, q_);
        mesh.set_vertex(q, m);
        mesh.set_edge(q, eq);
        mesh.set_face(q, f0);
        mesh.set_next(q_, p);
        mesh.set_prev(q_, b);
        mesh.set_twin(q_, q);
        mesh.set_vertex(q_, v2);
        mesh.set_edge(q_, eq);
        mesh.set_face(q_, g0);
        mesh.set_next(r, d);
        mesh.set_prev(r, g);
        mesh.set_twin(r, r_);
        mesh.set_vertex(r, v3);
        mesh.set_edge(r, er);
        mesh.set_face(r, f1);
        mesh.set_next(r_, h);
        mesh.set_prev(r_, p_);
        mesh.set_twin(r_, r);
        mesh.set_vertex(r_, m);
        mesh.set_edge(r_, er);
        mesh.set_face(r_, g1);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_vertex_halfedge(m, d);
        mesh.set_edge_halfedge(ep, p);
        mesh.set_edge_halfedge(eq, q);
        mesh.set_edge_halfedge(er, r);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        mesh.set_face_halfedge(g0, p);
        mesh.set_face_halfedge(g1, p_);
        mesh.set_position(m, m_position);
        set_attribute(mesh, weight_column, m.0, m_weight);
        set_attribute(mesh, tint_column, m.0, m_tint);
        set_attribute(mesh, mark_column, p.0, p_mark);
        set_attribute(mesh, mark_column, q.0, q_mark);
        set_attribute(mesh, fresh_column, eq.0, eq_fresh);
        set_attribute(mesh, fresh_column, er.0, er_fresh);
        set_attribute(mesh, class_column, g0.0, g0_class_);
        set_attribute(mesh, class_column, f1.0, f1_class_);
        return Some(m);
    }
    None
}

/// Gives what the corners of a face carry to the next ones.
pub fn attributes_hand_on(mesh: &mut Mesh, f: FaceId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    let mark_column = mesh.find_column(ElementKind::Halfedge, "mark");
    let Some(mark_column) = mark_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `mark` of this type
    };
    let fresh_column = mesh.find_column(ElementKind::Edge, "fresh");
    let Some(fresh_column) = fresh_column.filter(|&c| mesh.values::<bool>(c).is_some()) else {
        return None; // the mesh has no attribute `fresh` of this type
    };
    let class_column = mesh.find_column(ElementKind::Face, "class");
    let Some(class_column) = class_column.filter(|&c| mesh.values::<i64>(c).is_some()) else {
        return None; // the mesh has no attribute `class` of this type
    };
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    if (0..n).any(|i| !(attribute::<f64>(mesh, weight_column, v[i].0) < 1.5)) {
        return None; // a corner is heavy
    }
    if 3 <= (mesh.face_halfedges(f).map(|h| mesh.edge(h)).filter(|&e| attribute::<bool>(mesh, fresh_column, e.0)).count() as i64) {
        return None; // the edges are new
    }
    let v_weight: Vec<f64> = (0..n).map(|i| attribute::<f64>(mesh, weight_column, v[(i + 1) % n].0) + attribute::<f64>(mesh, mark_column, h[i].0)).collect();
    let h_mark: Vec<f64> = (0..n).map(|i| mesh.spokes(v[i]).map(|h_2| attribute::<f64>(mesh, mark_column, h_2.0)).sum::<f64>() / 2.0).collect();
    let f_class_ = -attribute::<i64>(mesh, class_column, f.0);

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        set_attribute(mesh, weight_column, v[i].0, v_weight[i]);
    }
    for i in 0..n {
        set_attribute(mesh, mark_column, h[i].0, h_mark[i]);
    }
    set_attribute(mesh, class_column, f.0, f_class_);
    Some(f)
}

/// Reads and sets vectors and matrices.
pub fn attributes_note_plane(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let quadric_column = mesh.find_column(ElementKind::Vertex, "quadric");
    let Some(quadric_column) = quadric_column.filter(|&c| mesh.values::<DMat4>(c).is_some()) else {
        return false; // the mesh has no attribute `quadric` of this type
    };
    let uv_column = mesh.find_column(ElementKind::Halfedge, "uv");
    let Some(uv_column) = uv_column.filter(|&c| mesh.values::<DVec2>(c).is_some()) else {
        return false; // the mesh has no attribute `uv` of this type
    };
    let plane_column = mesh.find_column(ElementKind::Face, "plane");
    let Some(plane_column) = plane_column.filter(|&c| mesh.values::<DVec4>(c).is_some()) else {
        return false; // the mesh has no attribute `plane` of this type
    };
    let frame_column = mesh.find_column(ElementKind::Face, "frame");
    let Some(frame_column) = frame_column.filter(|&c| mesh.values::<DMat3>(c).is_some()) else {
        return false; // the mesh has no attribute `frame` of this type
    };
    let f = mesh.face(a);
    let v = mesh.vertex(a);
    let w = mesh.vertex(mesh.next(a));
    if mesh.is_hole(f) {
        return false; // `f` is a hole
    }
    if v == w {
        return false; // `v` and `w` are one vertex
    }
    let f_plane = (mesh.position(w) - mesh.position(v)).extend(attribute::<DVec4>(mesh, plane_column, f.0).w + 1.0);
    let f_frame = outer3(DVec3::new(1.0, 0.0, 2.0), attribute::<DVec4>(mesh, plane_column, f.0).truncate()) + attribute::<DMat3>(mesh, frame_column, f.0) / 2.0;
    let a_uv = DVec2::lerp(attribute::<DVec2>(mesh, uv_column, a.0), mesh.position(v).truncate(), 0.5);
    let v_quadric = attribute::<DMat4>(mesh, quadric_column, v.0) + attribute::<DMat4>(mesh, quadric_column, w.0);

    // 3. Reassign every pointer that changes.
    set_attribute(mesh, plane_column, f.0, f_plane);
    set_attribute(mesh, frame_column, f.0, f_frame);
    set_attribute(mesh, uv_column, a.0, a_uv);
    set_attribute(mesh, quadric_column, v.0, v_quadric);
    true
}

/// Removes a vertex and leaves a hole; returns the hole.
#[allow(non_snake_case)]
pub fn guards_open_star(mesh: &mut Mesh, v: VertexId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(v).is_none() {
        return None; // `v` is isolated: no halfedge starts there
    }
    let h_0 = mesh.vertex_halfedge(v);
    let h = mesh.spokes_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let k: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(h[(i + n - 1) % n])).collect();
    let e: Vec<EdgeId> = (0..n).map(|i| mesh.edge(h[i])).collect();
    let g: Vec<FaceId> = (0..n).map(|i| mesh.face(h[i])).collect();
    let w: Vec<VertexId> = (0..n).map(|i| mesh.vertex(k[i])).collect();
    let P_first: Vec<HalfedgeId> = (0..n).map(|i| mesh.next(h[i])).collect();
    let P_last: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(k[(i + 1) % n])).collect();
    let P_is_empty: Vec<bool> = (0..n).map(|i| P_first[i] == k[(i + 1) % n]).collect();
    if (0..n).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..n).any(|i| mesh.twin(h[i]) != k[i]) {
        return None; // `h[i].twin` is not `k[i]`
    }
    if (0..n).any(|i| mesh.vertex(h[i]) != v) {
        return None; // `h[i]` does not start at `v`
    }
    let mut all: Vec<VertexId> = vec![v];
    for i in 0..n {
        all.push(w[i]);
    }
    if !all_differ(&all) {
        return None; // two of `v`, `w[i]` are one vertex
    }
    if !all_differ(&g) {
        return None; // two of `g[i]` are one face
    }
    if !(0..n).any(|i| !P_is_empty[i]) {
        return None; // `f` would be left without halfedges
    }
    // The guard looks at what there would be, on a sheet over the mesh.
    {
        let mut sheet = Sheet::new(mesh);
        let f = sheet.add_face();
        for i in 0..n {
            let mut h_2 = P_first[i];
            while h_2 != k[(i + 1) % n] {
                sheet.set_face(h_2, f);
                h_2 = mesh.next(h_2);
            }
        }
        let mut firsts: Vec<HalfedgeId> = Vec::new();
        let mut lasts: Vec<HalfedgeId> = Vec::new();
        for i in 0..n {
            if !P_is_empty[i] {
                firsts.push(P_first[i]);
                lasts.push(P_last[i]);
            }
        }
        let runs = firsts.len();
        for i in 0..runs {
            sheet.set_next(lasts[i], firsts[(i + 1) % runs]);
        }
        sheet.set_face_halfedge(f, firsts[0]);
        sheet.set_hole(f, true);
        for i in 0..n {
            sheet.set_vertex_halfedge(w[i], P_first[i]);
        }
        if !sheet.three_sides(f) {
            return None; // `f` would have fewer than 3 sides
        }
        if (0..n).any(|i| !sheet.two_spokes(w[i])) {
            return None; // `w[i]` would keep a single edge
        }
        if (0..n).any(|i| !sheet.one_hole(w[i])) {
            return None; // the surface would be pinched at `w[i]`
        }
        let mut pinched = false;
        for i in 0..n {
            let mut h_2 = P_first[i];
            while h_2 != k[(i + 1) % n] {
                if !sheet.one_hole(sheet.vertex(h_2)) {
                    pinched = true;
                }
                h_2 = mesh.next(h_2);
            }
        }
        if pinched {
            return None; // the surface would be pinched at a vertex of `P[i]`
        }
        if !sheet.meets_once(f) {
            return None; // `f` would meet a vertex twice
        }
    }

    // 2. Allocate what is new.
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        let mut h_2 = P_first[i];
        while h_2 != k[(i + 1) % n] {
            mesh.set_face(h_2, f);
            h_2 = mesh.next(h_2);
        }
    }
    let mut firsts: Vec<HalfedgeId> = Vec::new();
    let mut lasts: Vec<HalfedgeId> = Vec::new();
    for i in 0..n {
        if !P_is_empty[i] {
            firsts.push(P_first[i]);
            lasts.push(P_last[i]);
        }
    }
    let runs = firsts.len();
    for i in 0..runs {
        mesh.set_next(lasts[i], firsts[(i + 1) % runs]);
        mesh.set_prev(firsts[(i + 1) % runs], lasts[i]);
    }
    mesh.set_face_halfedge(f, firsts[0]);
    mesh.set_hole(f, true);
    for i in 0..n {
        mesh.set_vertex_halfedge(w[i], P_first[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(v);
    for i in 0..n {
        mesh.erase_halfedge(h[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(k[i]);
    }
    for i in 0..n {
        mesh.erase_edge(e[i]);
    }
    for i in 0..n {
        mesh.erase_face(g[i]);
    }
    Some(f)
}

/// Removes a vertex and merges the faces around it, and two faces never share their corners.
#[allow(non_snake_case)]
pub fn guards_dissolve_simply(mesh: &mut Mesh, v: VertexId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(v).is_none() {
        return None; // `v` is isolated: no halfedge starts there
    }
    let h_0 = mesh.vertex_halfedge(v);
    let h = mesh.spokes_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let k: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(h[(i + n - 1) % n])).collect();
    let e: Vec<EdgeId> = (0..n).map(|i| mesh.edge(h[i])).collect();
    let g: Vec<FaceId> = (0..n).map(|i| mesh.face(h[i])).collect();
    let w: Vec<VertexId> = (0..n).map(|i| mesh.vertex(k[i])).collect();
    let P_first: Vec<HalfedgeId> = (0..n).map(|i| mesh.next(h[i])).collect();
    let P_last: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(k[(i + 1) % n])).collect();
    let P_is_empty: Vec<bool> = (0..n).map(|i| P_first[i] == k[(i + 1) % n]).collect();
    if (0..n).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..n).any(|i| mesh.twin(h[i]) != k[i]) {
        return None; // `h[i].twin` is not `k[i]`
    }
    if (0..n).any(|i| mesh.vertex(h[i]) != v) {
        return None; // `h[i]` does not start at `v`
    }
    let mut all: Vec<VertexId> = vec![v];
    for i in 0..n {
        all.push(w[i]);
    }
    if !all_differ(&all) {
        return None; // two of `v`, `w[i]` are one vertex
    }
    if !all_differ(&g) {
        return None; // two of `g[i]` are one face
    }
    if !(0..n).any(|i| !P_is_empty[i]) {
        return None; // `f` would be left without halfedges
    }
    // The guard looks at what there would be, on a sheet over the mesh.
    {
        let mut sheet = Sheet::new(mesh);
        let f = sheet.add_face();
        for i in 0..n {
            let mut h_2 = P_first[i];
            while h_2 != k[(i + 1) % n] {
                sheet.set_face(h_2, f);
                h_2 = mesh.next(h_2);
            }
        }
        let mut firsts: Vec<HalfedgeId> = Vec::new();
        let mut lasts: Vec<HalfedgeId> = Vec::new();
        for i in 0..n {
            if !P_is_empty[i] {
                firsts.push(P_first[i]);
                lasts.push(P_last[i]);
            }
        }
        let runs = firsts.len();
        for i in 0..runs {
            sheet.set_next(lasts[i], firsts[(i + 1) % runs]);
        }
        sheet.set_face_halfedge(f, firsts[0]);
        for i in 0..n {
            sheet.set_vertex_halfedge(w[i], P_first[i]);
        }
        if !sheet.three_sides(f) {
            return None; // `f` would have fewer than 3 sides
        }
        if (0..n).any(|i| !sheet.two_spokes(w[i])) {
            return None; // `w[i]` would keep a single edge
        }
        if !sheet.meets_once(f) {
            return None; // `f` would meet a vertex twice
        }
        if !sheet.corners_own(f, w[0]) {
            return None; // another face has the corners that `f` would have
        }
    }

    // 2. Allocate what is new.
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        let mut h_2 = P_first[i];
        while h_2 != k[(i + 1) % n] {
            mesh.set_face(h_2, f);
            h_2 = mesh.next(h_2);
        }
    }
    let mut firsts: Vec<HalfedgeId> = Vec::new();
    let mut lasts: Vec<HalfedgeId> = Vec::new();
    for i in 0..n {
        if !P_is_empty[i] {
            firsts.push(P_first[i]);
            lasts.push(P_last[i]);
        }
    }
    let runs = firsts.len();
    for i in 0..runs {
        mesh.set_next(lasts[i], firsts[(i + 1) % runs]);
        mesh.set_prev(firsts[(i + 1) % runs], lasts[i]);
    }
    mesh.set_face_halfedge(f, firsts[0]);
    for i in 0..n {
        mesh.set_vertex_halfedge(w[i], P_first[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(v);
    for i in 0..n {
        mesh.erase_halfedge(h[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(k[i]);
    }
    for i in 0..n {
        mesh.erase_edge(e[i]);
    }
    for i in 0..n {
        mesh.erase_face(g[i]);
    }
    Some(f)
}

/// Fills a hole with triangles around a new vertex, and edges stay told by their ends.
pub fn guards_fill_simply(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let c_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let c = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(c, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], c);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(c, c_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(c)
}

/// Turns an edge within its two faces, which may have a corner in common across it.
#[allow(non_snake_case)]
pub fn guards_flip_any(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(mesh.next(b));
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(mesh.next(g));
        let P_first = mesh.next(b);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(g);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
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
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        // The guard looks at what there would be, on a sheet over the mesh.
        {
            let mut sheet = Sheet::new(mesh);
            sheet.set_next(a, P_first);
            sheet.set_vertex(a, v3);
            sheet.set_next(b, d);
            sheet.set_face(b, f1);
            sheet.set_next(P_last, g);
            sheet.set_next(d, Q_first);
            sheet.set_vertex(d, v2);
            sheet.set_next(g, a);
            sheet.set_face(g, f0);
            sheet.set_next(Q_last, b);
            sheet.set_vertex_halfedge(v0, g);
            sheet.set_vertex_halfedge(v1, b);
            sheet.set_face_halfedge(f0, a);
            sheet.set_face_halfedge(f1, d);
            if !sheet.two_spokes(v0) {
                continue; // `v0` would keep a single edge
            }
            if !sheet.two_spokes(v1) {
                continue; // `v1` would keep a single edge
            }
            if !sheet.corner_once(f0, v3) {
                continue; // `f0` would meet `v3` twice
            }
            if !sheet.corner_once(f1, v2) {
                continue; // `f1` would meet `v2` twice
            }
            if !sheet.meets_once(f0) {
                continue; // `f0` would meet a vertex twice
            }
            if !sheet.meets_once(f1) {
                continue; // `f1` would meet a vertex twice
            }
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, Q_last);
        mesh.set_face(b, f1);
        mesh.set_next(P_last, g);
        mesh.set_prev(P_first, a);
        mesh.set_next(d, Q_first);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, P_last);
        mesh.set_face(g, f0);
        mesh.set_next(Q_last, b);
        mesh.set_prev(Q_first, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}

/// The same, and edges stay told by their ends.
#[allow(non_snake_case)]
pub fn guards_flip_simply(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(mesh.next(b));
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(mesh.next(g));
        let P_first = mesh.next(b);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(g);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
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
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        // The guard looks at what there would be, on a sheet over the mesh.
        {
            let mut sheet = Sheet::new(mesh);
            sheet.set_next(a, P_first);
            sheet.set_vertex(a, v3);
            sheet.set_next(b, d);
            sheet.set_face(b, f1);
            sheet.set_next(P_last, g);
            sheet.set_next(d, Q_first);
            sheet.set_vertex(d, v2);
            sheet.set_next(g, a);
            sheet.set_face(g, f0);
            sheet.set_next(Q_last, b);
            sheet.set_vertex_halfedge(v0, g);
            sheet.set_vertex_halfedge(v1, b);
            sheet.set_face_halfedge(f0, a);
            sheet.set_face_halfedge(f1, d);
            if !sheet.two_spokes(v0) {
                continue; // `v0` would keep a single edge
            }
            if !sheet.two_spokes(v1) {
                continue; // `v1` would keep a single edge
            }
            if !sheet.corner_once(f0, v3) {
                continue; // `f0` would meet `v3` twice
            }
            if !sheet.corner_once(f1, v2) {
                continue; // `f1` would meet `v2` twice
            }
            if !sheet.single_edge(a) {
                continue; // two edges would join `v2` and `v3`
            }
            if !sheet.corners_own(f0, v3) {
                continue; // another face has the corners that `f0` would have
            }
            if !sheet.corners_own(f1, v2) {
                continue; // another face has the corners that `f1` would have
            }
            if !sheet.meets_once(f0) {
                continue; // `f0` would meet a vertex twice
            }
            if !sheet.meets_once(f1) {
                continue; // `f1` would meet a vertex twice
            }
            if !sheet.corners_own(f0, v2) {
                continue; // another face has the corners that `f0` would have
            }
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, Q_last);
        mesh.set_face(b, f1);
        mesh.set_next(P_last, g);
        mesh.set_prev(P_first, a);
        mesh.set_next(d, Q_first);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, P_last);
        mesh.set_face(g, f0);
        mesh.set_next(Q_last, b);
        mesh.set_prev(Q_first, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}

/// Joins two corners of a face, which may lie next to each other.
#[allow(non_snake_case)]
pub fn guards_join_any(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_first = mesh.next(a);
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    let P_is_empty = P_first == b;
    let Q_is_empty = Q_first == a;
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    // The guard looks at what there would be, on a sheet over the mesh.
    {
        let mut sheet = Sheet::new(mesh);
        let x = sheet.add_halfedge();
        let y = sheet.add_halfedge();
        let g = sheet.add_face();
        let mut h = Q_first;
        while h != a {
            sheet.set_face(h, g);
            h = mesh.next(h);
        }
        sheet.set_next(if P_is_empty { a } else { P_last }, x);
        sheet.set_face(b, g);
        sheet.set_next(if Q_is_empty { b } else { Q_last }, y);
        sheet.set_next(x, a);
        sheet.set_twin(x, y);
        sheet.set_vertex(x, v2);
        sheet.set_face(x, f);
        sheet.set_next(y, b);
        sheet.set_twin(y, x);
        sheet.set_vertex(y, v0);
        sheet.set_face(y, g);
        sheet.set_face_halfedge(f, a);
        sheet.set_face_halfedge(g, b);
        if !sheet.three_sides(f) {
            return None; // `f` would have fewer than 3 sides
        }
        if !sheet.three_sides(g) {
            return None; // `g` would have fewer than 3 sides
        }
        if !sheet.meets_once(f) {
            return None; // `f` would meet a vertex twice
        }
        if !sheet.meets_once(g) {
            return None; // `g` would meet a vertex twice
        }
    }

    // 2. Allocate what is new.
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let e = mesh.add_edge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != a {
        mesh.set_face(h, g);
        h = mesh.next(h);
    }
    mesh.set_prev(a, x);
    mesh.set_next(if P_is_empty { a } else { P_last }, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(if Q_is_empty { b } else { Q_last }, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, if P_is_empty { a } else { P_last });
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, if Q_is_empty { b } else { Q_last });
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, b);
    Some(g)
}

/// Flips an edge where it is the longer one, as most remeshers would have it.
pub fn values_flip_if_longer(mesh: &mut Mesh, e: EdgeId, least: f64) -> Option<EdgeId> {
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
        if !(DVec3::distance(mesh.position(v2), mesh.position(v3)) - least < mesh.length(e)) {
            continue; // it is shorter
        }
        if mesh.adjacent(v2, v3) {
            continue; // it is shorter
        }
        if ((mesh.degree(v0) as i64) <= 3 || (mesh.degree(v1) as i64) <= 3) && !mesh.is_boundary_vertex(v0) {
            continue; // an end has few edges
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
        return Some(e);
    }
    None
}

/// Moves a vertex by everything that can be computed around it.
pub fn values_wander(mesh: &mut Mesh, v: VertexId, t: f64, n: i64) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge that starts at v is tried.
    for a in mesh.spokes(v).collect::<Vec<_>>() {
        let a_ = mesh.twin(a);
        let f = mesh.face(a);
        let w = mesh.vertex(a_);
        let e = mesh.edge(a);
        if mesh.vertex(a) != v {
            continue; // `a` does not start at `v`
        }
        if v == w {
            continue; // `v` and `w` are one vertex
        }
        if ((n % 3 + 3) % 3) == 1 {
            continue; // n is one of those
        }
        if n < (n / 2 - i64::from(n % 2 != 0 && (n < 0) != (2 < 0))) * 2 {
            continue; // n is one of those
        }
        if !mesh.neighbors(v).any(|w_2| mesh.is_boundary_vertex(w_2) || 2 < (mesh.degree(w_2) as i64)) {
            continue; // nothing around it
        }
        if (mesh.spokes(v).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).filter(|_| true).count() as i64) < 0 {
            continue; // no
        }
        if 9 <= (mesh.spokes(v).filter(|&h| !mesh.is_boundary_halfedge(h)).filter(|&h| h == a || mesh.twin(h) == a).count() as i64) {
            continue; // no
        }
        let v_position = DVec3::lerp(mesh.position(v), { let all = mesh.neighbors(v).map(|w_3| mesh.position(w_3)).collect::<Vec<DVec3>>(); assert!(!all.is_empty(), "a value of nothing"); all.iter().copied().sum::<DVec3>() / all.len() as f64 }, t) + mesh.vertex_normal(v) * f64::min(mesh.length(e), mesh.area(f)) + (if mesh.is_boundary_halfedge(a) { DVec3::new(0.25, 0.0, -1.0) } else { mesh.centroid(f) - mesh.position(mesh.vertex(mesh.edge_halfedge(e))).lerp(mesh.position(mesh.target(mesh.edge_halfedge(e))), 0.5) }) * f64::sin(t) / 2.0 + DVec3::cross(mesh.position(w), mesh.position(v)) * ((i64::max(n, 2) as f64) * 0.125) + direction(mesh.position(v) - mesh.position(w)) * f64::sqrt(f64::abs(DVec3::dot(mesh.position(v), mesh.position(w)))) + DVec3::new(f64::atan2(DVec3::cross(mesh.position(v), mesh.position(w)).length(), DVec3::dot(mesh.position(v), mesh.position(w))), mesh.face_halfedges(f).map(|h| mesh.edge(h)).filter(|&e_2| !mesh.is_boundary_edge(e_2)).map(|e_2| mesh.length(e_2)).sum::<f64>(), ((t * 7.0).round_ties_even() as i64) as f64);
        if !v_position.is_finite() {
            continue; // the new position of `v` is not finite
        }

        // 3. Reassign every pointer that changes.
        mesh.set_position(v, v_position);
        return Some(v);
    }
    None
}

/// Moves a face along its normal.
pub fn values_lift(mesh: &mut Mesh, f: FaceId, by: DVec3) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge of f is tried.
    for a in mesh.face_halfedges(f).collect::<Vec<_>>() {
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if mesh.face(a) != f {
            continue; // `a` does not lie in `f`
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if !mesh.face_vertices(f).all(|w| 1 < (mesh.degree(w) as i64)) {
            continue; // it is flat
        }
        if !(0.0 <= mesh.face_halfedges(f).map(|h| mesh.vector(h).length()).reduce(f64::min).expect("a value of nothing")) {
            continue; // it is flat
        }
        if (mesh.is_hole(f) || mesh.next(mesh.face_halfedge(f)) == mesh.next(a)) && mesh.target(mesh.prev(a)) != v0 {
            continue; // no
        }
        let v0_position = mesh.position(v0) + mesh.normal(f) * by.x + by * mesh.face_vertices(f).map(|w_2| mesh.position(w_2).z).reduce(f64::max).expect("a value of nothing") - -by * by.y;
        if !v0_position.is_finite() {
            continue; // the new position of `v0` is not finite
        }
        let v1_position = DVec3::new(f64::floor(mesh.position(v1).x * 3.0), f64::atan2(by.x, by.y), f64::powf(2.0, by.z)) * by;
        if !v1_position.is_finite() {
            continue; // the new position of `v1` is not finite
        }

        // 3. Reassign every pointer that changes.
        mesh.set_position(v0, v0_position);
        mesh.set_position(v1, v1_position);
        return Some(f);
    }
    None
}

/// Turns a spoke of a vertex into the first of its star: several starts are tried.
pub fn values_mark(mesh: &mut Mesh, v: VertexId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge that starts at v is tried.
    for a in mesh.spokes(v).collect::<Vec<_>>() {
        let b = mesh.next(a);
        let c = mesh.next(b);
        let a_ = mesh.twin(a);
        let f = mesh.face(a);
        let w = mesh.vertex(a_);
        let u = mesh.vertex(c);
        let e = mesh.edge(a);
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if mesh.next(c) != a {
            continue; // `f` is not a triangle
        }
        if mesh.vertex(a) != v {
            continue; // `a` does not start at `v`
        }
        if v == w {
            continue; // `v` and `w` are one vertex
        }
        if v == u {
            continue; // `v` and `u` are one vertex
        }
        if w == u {
            continue; // `w` and `u` are one vertex
        }
        if !(mesh.length(e) <= mesh.spokes(v).map(|h| mesh.edge(h)).map(|e_2| mesh.length(e_2)).reduce(f64::min).expect("a value of nothing")) {
            continue; // there is a shorter one
        }
        let v_position = mesh.position(v) + (mesh.position(w) - mesh.position(v)) / (1.0 + mesh.length(e));
        if !v_position.is_finite() {
            continue; // the new position of `v` is not finite
        }

        // 3. Reassign every pointer that changes.
        mesh.set_position(v, v_position);
        return Some(w);
    }
    None
}

/// Two places of one loop, in that order.
#[allow(non_snake_case)]
pub fn values_cut(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }

    // 2. Allocate what is new.
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let e = mesh.add_edge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != a {
        mesh.set_face(h, g);
        h = mesh.next(h);
    }
    mesh.set_prev(a, x);
    mesh.set_next(P_last, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(Q_last, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, P_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, Q_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, y);
    Some(g)
}

/// Opens a face: a new hole inside of it.
#[allow(non_snake_case)]
pub fn values_pierce(mesh: &mut Mesh, f: FaceId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge of f is tried.
    for a in mesh.face_halfedges(f).collect::<Vec<_>>() {
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        let P_last = mesh.prev(a);
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if mesh.face(a) != f {
            continue; // `a` does not lie in `f`
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        let u_position = DVec3::lerp(mesh.position(v0), mesh.position(v1), 0.25);
        let w_position = mesh.position(v1) * mesh.position(v0).x;

        // 2. Allocate what is new.
        let g = mesh.add_face();
        let u = mesh.add_vertex();
        let w = mesh.add_vertex();
        let e1 = mesh.add_edge();
        let e2 = mesh.add_edge();
        let e3 = mesh.add_edge();
        let d = mesh.add_halfedge();
        let d_ = mesh.add_halfedge();
        let p = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let y = mesh.add_halfedge();
        let z = mesh.add_halfedge();

        // 3. Reassign every pointer that changes.
        mesh.set_prev(a, d_);
        mesh.set_next(P_last, d);
        mesh.set_next(d, p);
        mesh.set_prev(d, P_last);
        mesh.set_twin(d, d_);
        mesh.set_vertex(d, v0);
        mesh.set_edge(d, e1);
        mesh.set_face(d, f);
        mesh.set_next(d_, a);
        mesh.set_prev(d_, q);
        mesh.set_twin(d_, d);
        mesh.set_vertex(d_, u);
        mesh.set_edge(d_, e1);
        mesh.set_face(d_, f);
        mesh.set_next(p, q);
        mesh.set_prev(p, d);
        mesh.set_twin(p, z);
        mesh.set_vertex(p, u);
        mesh.set_edge(p, e2);
        mesh.set_face(p, f);
        mesh.set_next(q, d_);
        mesh.set_prev(q, p);
        mesh.set_twin(q, y);
        mesh.set_vertex(q, w);
        mesh.set_edge(q, e3);
        mesh.set_face(q, f);
        mesh.set_next(y, z);
        mesh.set_prev(y, z);
        mesh.set_twin(y, q);
        mesh.set_vertex(y, u);
        mesh.set_edge(y, e3);
        mesh.set_face(y, g);
        mesh.set_next(z, y);
        mesh.set_prev(z, y);
        mesh.set_twin(z, p);
        mesh.set_vertex(z, w);
        mesh.set_edge(z, e2);
        mesh.set_face(z, g);
        mesh.set_vertex_halfedge(u, d_);
        mesh.set_vertex_halfedge(w, q);
        mesh.set_edge_halfedge(e1, d);
        mesh.set_edge_halfedge(e2, p);
        mesh.set_edge_halfedge(e3, q);
        mesh.set_face_halfedge(g, y);
        mesh.set_hole(g, true);
        mesh.set_position(u, u_position);
        mesh.set_position(w, w_position);
        return Some(g);
    }
    None
}

/// Moves a vertex along its edge, as functions tell.
pub fn values_stretch(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v = mesh.vertex(a);
    let w = mesh.vertex(mesh.next(a));
    if v == w {
        return false; // `v` and `w` are one vertex
    }
    if !holds_(mesh, a) {
        return false; // the corner is reflex
    }
    let v_position = between(mesh, v, w, reach(mesh, f));
    if !v_position.is_finite() {
        return false; // the new position of `v` is not finite
    }

    // 3. Reassign every pointer that changes.
    mesh.set_position(v, v_position);
    true
}

/// Moves a vertex to where it is nearest to the planes around it, and not far from where it was.
pub fn values_settle(mesh: &mut Mesh, v: VertexId, t: f64) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge that starts at v is tried.
    for a in mesh.spokes(v).collect::<Vec<_>>() {
        let f = mesh.face(a);
        let w = mesh.vertex(mesh.next(a));
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if mesh.vertex(a) != v {
            continue; // `a` does not start at `v`
        }
        if v == w {
            continue; // `v` and `w` are one vertex
        }
        if !quadric_of(mesh, f).is_finite() {
            continue; // it is flat
        }
        if mesh.position(v).is_nan() {
            continue; // it is flat
        }
        if mesh.spokes(v).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).map(|f_2| quadric_of(mesh, f_2)).sum::<DMat4>() == DMat4::from_diagonal(DVec4::splat(t)) {
            continue; // it does not change
        }
        let v_position = solve4(mesh.spokes(v).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).map(|f_3| quadric_of(mesh, f_3)).sum::<DMat4>() + DMat4::from_diagonal(DVec4::splat(0.5)), mesh.position(v).extend(1.0)).truncate() + inverse3(DMat3::from_mat4({ let all = mesh.spokes(v).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).map(|f_4| quadric_of(mesh, f_4)).collect::<Vec<DMat4>>(); assert!(!all.is_empty(), "a value of nothing"); all.iter().copied().sum::<DMat4>() / all.len() as f64 }) + DMat3::from_diagonal(DVec3::splat(1.0))) * mesh.position(w) + solve3(outer3(mesh.position(v), mesh.position(w)) / 4.0 + DMat3::from_diagonal(DVec3::splat(3.0)), DVec3::new(t, 1.0, (-DMat3::from_diagonal(DVec3::splat(t))).determinant()));
        if !v_position.is_finite() {
            continue; // the new position of `v` is not finite
        }

        // 3. Reassign every pointer that changes.
        mesh.set_position(v, v_position);
        return Some(v);
    }
    None
}

/// Everything else that can be done with vectors and matrices.
pub fn values_mangle(mesh: &mut Mesh, a: HalfedgeId, t: f64) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let f = mesh.face(a);
    let v = mesh.vertex(a);
    let w = mesh.vertex(b);
    let u = mesh.vertex(mesh.next(b));
    if mesh.is_hole(f) {
        return false; // `f` is a hole
    }
    if v == w {
        return false; // `v` and `w` are one vertex
    }
    if v == u {
        return false; // `v` and `u` are one vertex
    }
    if w == u {
        return false; // `w` and `u` are one vertex
    }
    if !(0.25 < DVec2::distance(mesh.position(v).truncate(), mesh.position(w).truncate())) {
        return false; // too near
    }
    let v_position = (DMat3::from_cols(mesh.position(v), mesh.position(w), mesh.position(u)) * DMat3::from_diagonal(DVec3::splat(2.0)).transpose()).y_axis + (DVec2::new(t, 1.0) * mesh.position(w).truncate() - DVec2::lerp(mesh.position(u).truncate(), (DVec4::new(1.0, 1.0, 1.0, 1.0) * t).truncate().truncate(), 0.25)).extend(1.0) + direction2(DVec2::new(t, 3.0)).extend(DVec2::new(1.0, t).length());
    if !v_position.is_finite() {
        return false; // the new position of `v` is not finite
    }
    let w_position = DVec3::new(DVec2::perp_dot(mesh.position(v).truncate(), mesh.position(w).truncate()), (DMat4::from_diagonal(DVec4::splat(t)) + outer4(mesh.position(w).extend(1.0), DVec4::new(1.0, 2.0, 3.0, 4.0))).determinant(), DVec4::dot(direction4(mesh.position(v).extend(t)), DVec4::new(1.0, mesh.position(u).x, mesh.position(u).y, mesh.position(u).z)));
    if !w_position.is_finite() {
        return false; // the new position of `w` is not finite
    }
    let u_position = DMat3::from_cols(DVec3::new(1.0, t, 0.0), mesh.position(u), DVec3::new(0.0, 0.0, 2.0)) * mesh.position(v).z * mesh.position(w) + DVec3::new(1.0, 1.0, 1.0) * DMat4::from_cols(DVec4::new(1.0, 1.0, 1.0, 1.0) * 1.0, DVec4::new(1.0, 1.0, 1.0, 1.0) * t, mesh.position(u).extend(2.0), DVec4::new(0.0, 1.0, 2.0, 3.0)).z_axis.w + (-DVec2::new(t, 2.0)).extend((DVec4::new(1.0, 1.0, 1.0, 1.0) * t / 3.0 - DVec4::new(1.0, 1.0, 1.0, 1.0) * 1.0).x) + (if DMat3::from_diagonal(DVec3::splat(1.0)) * DMat3::from_diagonal(DVec3::splat(t)) == DMat3::from_diagonal(DVec3::splat(t)) && !DMat3::from_diagonal(DVec3::splat(t)).is_nan() { DVec3::new(1.0, 1.0, 1.0) * 1.0 } else { DVec3::new(1.0, 1.0, 1.0) * 2.0 });
    if !u_position.is_finite() {
        return false; // the new position of `u` is not finite
    }

    // 3. Reassign every pointer that changes.
    mesh.set_position(v, v_position);
    mesh.set_position(w, w_position);
    mesh.set_position(u, u_position);
    true
}

/// Moves a vertex by the angles around it.
pub fn values_fold_up(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let a_ = mesh.twin(a);
        let v = mesh.vertex(a);
        let w = mesh.vertex(a_);
        if v == w {
            continue; // `v` and `w` are one vertex
        }
        if mesh.kernel_centroid(e).is_some() && !mesh.kernel_centroid(e).unwrap_or(DVec3::NAN).is_finite() {
            continue; // that is never so
        }
        let v_position = mesh.position(v) + DVec3::new(corner_angle(mesh, a), dihedral_angle(mesh, e), cotangent(mesh, a) / 64.0) + mesh.position(mesh.vertex(mesh.edge_halfedge(least_of(mesh.spokes(v).map(|h| mesh.edge(h)), |e_2| mesh.length(e_2))))).lerp(mesh.position(mesh.target(mesh.edge_halfedge(least_of(mesh.spokes(v).map(|h| mesh.edge(h)), |e_2| mesh.length(e_2))))), 0.5) + mesh.position(greatest_of(mesh.neighbors(v).filter(|&w_2| w_2 != v), |w_2| mesh.position(w_2).y));
        if !v_position.is_finite() {
            continue; // the new position of `v` is not finite
        }
        let w_position = if mesh.kernel_centroid(e).is_some() { mesh.kernel_centroid(e).unwrap_or(DVec3::NAN) } else { mesh.position(w) };
        if !w_position.is_finite() {
            continue; // the new position of `w` is not finite
        }

        // 3. Reassign every pointer that changes.
        mesh.set_position(v, v_position);
        mesh.set_position(w, w_position);
        return true;
    }
    false
}

/// Names that emitted code has its own functions for, and one that a function has.
pub fn values_rename_all(mesh: &mut Mesh, turned_: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let length = mesh.next(turned_);
    let holds = mesh.twin(turned_);
    let sheet = mesh.face(turned_);
    let degree_ = mesh.vertex(turned_);
    let spokes = mesh.vertex(holds);
    let reach_2 = mesh.vertex(mesh.next(length));
    if degree_ == spokes {
        return None; // `degree'` and `spokes` are one vertex
    }
    if degree_ == reach_2 {
        return None; // `degree'` and `reach` are one vertex
    }
    if spokes == reach_2 {
        return None; // `spokes` and `reach` are one vertex
    }
    let reach_2_position = direction_(mesh, spokes) + direction(mesh.position(degree_)) * reach(mesh, sheet);
    if !reach_2_position.is_finite() {
        return None; // the new position of `reach` is not finite
    }
    let spokes_position = DVec3::new((mesh.spokes(spokes).filter(|&h| mesh.next(turned_) == h).count() as i64) as f64, 0.0, 1.0);
    if !spokes_position.is_finite() {
        return None; // the new position of `spokes` is not finite
    }

    // 3. Reassign every pointer that changes.
    mesh.set_position(reach_2, reach_2_position);
    mesh.set_position(spokes, spokes_position);
    Some(spokes)
}

/// The operation `more_extrude`.
pub fn more_extrude(mesh: &mut Mesh, f: FaceId) -> bool {
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
    let w_position: Vec<DVec3> = (0..n).map(|i| mesh.position(v[i])).collect();

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

/// The operation `more_collapse_face`.
#[allow(non_snake_case)]
pub fn more_collapse_face(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let k: Vec<HalfedgeId> = (0..n).map(|i| mesh.twin(h[i])).collect();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(k[(i + n - 1) % n])).collect();
    let e: Vec<EdgeId> = (0..n).map(|i| mesh.edge(h[i])).collect();
    let g: Vec<FaceId> = (0..n).map(|i| mesh.face(k[i])).collect();
    let P_first: Vec<HalfedgeId> = (0..n).map(|i| mesh.next(k[i])).collect();
    let P_last: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(k[i])).collect();
    let P_is_empty: Vec<bool> = (0..n).map(|i| P_first[i] == k[i]).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if (0..n).any(|i| mesh.vertex(k[i]) != v[(i + 1) % n]) {
        return None; // `k[i]` does not start at `v[i+1]`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let mut all: Vec<FaceId> = vec![f];
    for i in 0..n {
        all.push(g[i]);
    }
    if !all_differ(&all) {
        return None; // two of `f`, `g[i]` are one face
    }
    if (0..n).any(|i| P_is_empty[i]) {
        return None; // `g[i]` would be left without halfedges
    }
    let m_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let m = mesh.add_vertex();

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        let mut h_2 = mesh.next(k[i]);
        while h_2 != k[(i + n - 1) % n] {
            mesh.set_vertex(h_2, m);
            h_2 = mesh.next(mesh.twin(h_2));
        }
    }
    for i in 0..n {
        mesh.set_next(P_last[i], P_first[i]);
        mesh.set_prev(P_first[i], P_last[i]);
        if !P_is_empty[i] {
            mesh.set_vertex_halfedge(m, P_first[i]);
        }
        mesh.set_face_halfedge(g[i], P_first[i]);
    }
    mesh.set_position(m, m_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    for i in 0..n {
        mesh.erase_vertex(v[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(h[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(k[i]);
    }
    for i in 0..n {
        mesh.erase_edge(e[i]);
    }
    Some(m)
}

/// The operation `more_cut_every_other_side`.
#[allow(non_snake_case)]
pub fn more_cut_every_other_side(mesh: &mut Mesh, f: FaceId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge of f is tried.
    for h_0 in mesh.face_halfedges(f).collect::<Vec<_>>() {
        let all_3 = mesh.loop_from(h_0).collect::<Vec<_>>();
        if all_3.len() % 2 != 0 {
            continue; // the number of sides of `f` is no multiple of 2
        }
        let h = all_3.iter().skip(0).step_by(2).copied().collect::<Vec<_>>();
        let count = h.len();
        let k = all_3.iter().skip(1).step_by(2).copied().collect::<Vec<_>>();
        let t: Vec<HalfedgeId> = (0..count).map(|i| mesh.twin(h[i])).collect();
        let v: Vec<VertexId> = (0..count).map(|i| mesh.vertex(h[i])).collect();
        let u: Vec<VertexId> = (0..count).map(|i| mesh.vertex(t[i])).collect();
        let e: Vec<EdgeId> = (0..count).map(|i| mesh.edge(h[i])).collect();
        let g: Vec<FaceId> = (0..count).map(|i| mesh.face(t[i])).collect();
        let P_first: Vec<HalfedgeId> = (0..count).map(|i| mesh.next(t[i])).collect();
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if (0..count).any(|i| mesh.face(h[i]) != f) {
            continue; // `h[i]` does not lie in `f`
        }
        let mut all: Vec<VertexId> = Vec::new();
        for i in 0..count {
            all.push(v[i]);
            all.push(u[i]);
        }
        if !all_differ(&all) {
            continue; // two of `v[i]`, `u[i]` are one vertex
        }
        let mut all_2: Vec<FaceId> = vec![f];
        for i in 0..count {
            all_2.push(g[i]);
        }
        if !all_differ(&all_2) {
            continue; // two of `f`, `g[i]` are one face
        }
        let m_position: Vec<DVec3> = (0..count).map(|i| (mesh.position(v[i]) + mesh.position(u[i])) / 2.0).collect();

        // 2. Allocate what is new.
        let m: Vec<_> = (0..count).map(|_| mesh.add_vertex()).collect();
        let x: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
        let y: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
        let n: Vec<_> = (0..count).map(|_| mesh.add_edge()).collect();

        // 3. Reassign every pointer that changes.
        for i in 0..count {
            mesh.set_next(h[i], x[i]);
            mesh.set_twin(h[i], y[i]);
            mesh.set_prev(k[i], x[i]);
            mesh.set_next(t[i], y[i]);
            mesh.set_twin(t[i], x[i]);
            mesh.set_edge(t[i], n[i]);
            mesh.set_prev(P_first[i], y[i]);
            mesh.set_next(x[i], k[i]);
            mesh.set_prev(x[i], h[i]);
            mesh.set_twin(x[i], t[i]);
            mesh.set_vertex(x[i], m[i]);
            mesh.set_edge(x[i], n[i]);
            mesh.set_face(x[i], f);
            mesh.set_next(y[i], P_first[i]);
            mesh.set_prev(y[i], t[i]);
            mesh.set_twin(y[i], h[i]);
            mesh.set_vertex(y[i], m[i]);
            mesh.set_edge(y[i], e[i]);
            mesh.set_face(y[i], g[i]);
            mesh.set_vertex_halfedge(m[i], x[i]);
            mesh.set_edge_halfedge(e[i], h[i]);
            mesh.set_edge_halfedge(n[i], x[i]);
        }
        for i in 0..count {
            mesh.set_position(m[i], m_position[i]);
        }
        return true;
    }
    false
}

/// The operation `more_cut_corner`.
#[allow(non_snake_case)]
pub fn more_cut_corner(mesh: &mut Mesh, v: VertexId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(v).is_none() {
        return None; // `v` is isolated: no halfedge starts there
    }
    let h_0 = mesh.vertex_halfedge(v);
    let h = mesh.spokes_from(h_0).collect::<Vec<_>>();
    let count = h.len();
    let k: Vec<HalfedgeId> = (0..count).map(|i| mesh.prev(h[(i + count - 1) % count])).collect();
    let e: Vec<EdgeId> = (0..count).map(|i| mesh.edge(h[i])).collect();
    let g: Vec<FaceId> = (0..count).map(|i| mesh.face(h[i])).collect();
    let w: Vec<VertexId> = (0..count).map(|i| mesh.vertex(k[i])).collect();
    let P_first: Vec<HalfedgeId> = (0..count).map(|i| mesh.next(h[i])).collect();
    let P_last: Vec<HalfedgeId> = (0..count).map(|i| mesh.prev(k[(i + 1) % count])).collect();
    let P_is_empty: Vec<bool> = (0..count).map(|i| P_first[i] == k[(i + 1) % count]).collect();
    if (0..count).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..count).any(|i| mesh.twin(h[i]) != k[i]) {
        return None; // `h[i].twin` is not `k[i]`
    }
    if (0..count).any(|i| mesh.vertex(h[i]) != v) {
        return None; // `h[i]` does not start at `v`
    }
    let mut all: Vec<VertexId> = vec![v];
    for i in 0..count {
        all.push(w[i]);
    }
    if !all_differ(&all) {
        return None; // two of `v`, `w[i]` are one vertex
    }
    if !all_differ(&g) {
        return None; // two of `g[i]` are one face
    }

    // 2. Allocate what is new.
    let s: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
    let m: Vec<_> = (0..count).map(|_| mesh.add_halfedge()).collect();
    let n: Vec<_> = (0..count).map(|_| mesh.add_edge()).collect();
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    mesh.set_face_halfedge(f, m[0]);
    for i in 0..count {
        mesh.set_next(if P_is_empty[i] { s[i] } else { P_last[i] }, s[i]);
        mesh.set_prev(if P_is_empty[i] { s[i] } else { P_first[i] }, s[i]);
        mesh.set_next(s[i], if P_is_empty[i] { s[i] } else { P_first[i] });
        mesh.set_prev(s[i], if P_is_empty[i] { s[i] } else { P_last[i] });
        mesh.set_twin(s[i], m[i]);
        mesh.set_vertex(s[i], w[(i + 1) % count]);
        mesh.set_edge(s[i], n[i]);
        mesh.set_face(s[i], g[i]);
        mesh.set_next(m[i], m[(i + 1) % count]);
        mesh.set_twin(m[i], s[i]);
        mesh.set_vertex(m[i], w[i]);
        mesh.set_edge(m[i], n[i]);
        mesh.set_face(m[i], f);
        mesh.set_prev(m[(i + 1) % count], m[i]);
        mesh.set_vertex_halfedge(w[i], s[(i + count - 1) % count]);
        mesh.set_edge_halfedge(n[i], s[i]);
        mesh.set_face_halfedge(g[i], if P_is_empty[i] { s[i] } else { P_first[i] });
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(v);
    for i in 0..count {
        mesh.erase_halfedge(h[i]);
    }
    for i in 0..count {
        mesh.erase_halfedge(k[i]);
    }
    for i in 0..count {
        mesh.erase_edge(e[i]);
    }
    Some(f)
}

/// The operation `more_poke_from`.
pub fn more_poke_from(mesh: &mut Mesh, h_0: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let f = mesh.face(h[0]);
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let c_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let c = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(c, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], c);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(c, c_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(c)
}

/// The operation `more_copy_places`.
pub fn more_copy_places(mesh: &mut Mesh, h_0: HalfedgeId, k_0: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let k = mesh.loop_from(k_0).collect::<Vec<_>>();
    if k.len() != n {
        return false; // `g` is longer, or shorter, than the families before
    }
    let f = mesh.face(h[0]);
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    let g = mesh.face(k[0]);
    let u: Vec<VertexId> = (0..n).map(|i| mesh.vertex(k[i])).collect();
    if mesh.is_hole(f) {
        return false; // `f` is a hole
    }
    if mesh.is_hole(g) {
        return false; // `g` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return false; // `h[i]` does not lie in `f`
    }
    if (0..n).any(|i| mesh.face(k[i]) != g) {
        return false; // `k[i]` does not lie in `g`
    }
    let mut all: Vec<VertexId> = Vec::new();
    for i in 0..n {
        all.push(v[i]);
        all.push(u[i]);
    }
    if !all_differ(&all) {
        return false; // two of `v[i]`, `u[i]` are one vertex
    }
    let u_position: Vec<DVec3> = (0..n).map(|i| mesh.position(v[i])).collect();

    // 3. Reassign every pointer that changes.
    for i in 0..n {
        mesh.set_position(u[i], u_position[i]);
    }
    true
}

/// The operation `more_fill`.
pub fn more_fill(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let c_position = mesh.centroid(f);

    // 2. Allocate what is new.
    let c = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(c, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], c);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(c, c_position);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(c)
}

/// The operation `more_unpoke`.
pub fn more_unpoke(mesh: &mut Mesh, c: VertexId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    if mesh.vertex_halfedge(c).is_none() {
        return None; // `c` is isolated: no halfedge starts there
    }
    let b_0 = mesh.vertex_halfedge(c);
    let b = mesh.spokes_from(b_0).collect::<Vec<_>>();
    let n = b.len();
    let a: Vec<HalfedgeId> = (0..n).map(|i| mesh.prev(b[i])).collect();
    let h: Vec<HalfedgeId> = (0..n).map(|i| mesh.next(b[i])).collect();
    let g: Vec<FaceId> = (0..n).map(|i| mesh.face(h[i])).collect();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(a[(i + n - 1) % n])).collect();
    let d: Vec<EdgeId> = (0..n).map(|i| mesh.edge(a[i])).collect();
    if (0..n).any(|i| mesh.is_hole(g[i])) {
        return None; // `g[i]` is a hole
    }
    if (0..n).any(|i| mesh.next(h[i]) != a[i]) {
        return None; // `g[i]` is not a triangle
    }
    if (0..n).any(|i| mesh.twin(a[i]) != b[(i + 1) % n]) {
        return None; // `a[i].twin` is not `b[i+1]`
    }
    if (0..n).any(|i| mesh.vertex(a[i]) != v[(i + 1) % n]) {
        return None; // `a[i]` does not start at `v[i+1]`
    }
    if (0..n).any(|i| mesh.vertex(b[i]) != c) {
        return None; // `b[i]` does not start at `c`
    }
    let mut all: Vec<VertexId> = vec![c];
    for i in 0..n {
        all.push(v[i]);
    }
    if !all_differ(&all) {
        return None; // two of `c`, `v[i]` are one vertex
    }

    // 2. Allocate what is new.
    let f = mesh.add_face();

    // 3. Reassign every pointer that changes.
    mesh.set_face_halfedge(f, h[0]);
    for i in 0..n {
        mesh.set_next(h[i], h[(i + 1) % n]);
        mesh.set_face(h[i], f);
        mesh.set_prev(h[(i + 1) % n], h[i]);
        mesh.set_vertex_halfedge(v[i], h[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_vertex(c);
    for i in 0..n {
        mesh.erase_halfedge(a[i]);
    }
    for i in 0..n {
        mesh.erase_halfedge(b[i]);
    }
    for i in 0..n {
        mesh.erase_edge(d[i]);
    }
    for i in 0..n {
        mesh.erase_face(g[i]);
    }
    Some(f)
}

/// The operation `surface_flip`.
pub fn surface_flip(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
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
        return false; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return false; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return false; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return false; // `f1` is not a triangle
    }
    if v0 == v1 {
        return false; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return false; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return false; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return false; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return false; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return false; // `v2` and `v3` are one vertex
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
    true
}

/// The operation `simple_flip`.
pub fn simple_flip(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
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
        return false; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return false; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return false; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return false; // `f1` is not a triangle
    }
    if v0 == v1 {
        return false; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return false; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return false; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return false; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return false; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return false; // `v2` and `v3` are one vertex
    }
    if mesh.adjacent(v3, v2) {
        return false; // two edges would join `v2` and `v3`
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
    true
}

/// The operation `surface_flip_any`.
#[allow(non_snake_case)]
pub fn surface_flip_any(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let d = mesh.twin(a);
    let g = mesh.next(d);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(mesh.next(b));
    let f1 = mesh.face(d);
    let v3 = mesh.vertex(mesh.next(g));
    let P_first = mesh.next(b);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(g);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return false; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return false; // `f1` is a hole
    }
    if v0 == v1 {
        return false; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return false; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return false; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return false; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return false; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return false; // `v2` and `v3` are one vertex
    }
    if f0 == f1 {
        return false; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return false; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return false; // `v1` would keep a single edge
    }
    let mut meets = false;
    let mut h = P_first;
    while h != a {
        if h != P_first && mesh.vertex(h) == v3 {
            meets = true;
        }
        h = mesh.next(h);
    }
    if meets {
        return false; // `f0` would meet `v3` twice
    }
    let mut meets_2 = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first && mesh.vertex(h) == v2 {
            meets_2 = true;
        }
        h = mesh.next(h);
    }
    if meets_2 {
        return false; // `f1` would meet `v2` twice
    }

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, P_first);
    mesh.set_prev(a, g);
    mesh.set_vertex(a, v3);
    mesh.set_next(b, d);
    mesh.set_prev(b, Q_last);
    mesh.set_face(b, f1);
    mesh.set_next(P_last, g);
    mesh.set_prev(P_first, a);
    mesh.set_next(d, Q_first);
    mesh.set_prev(d, b);
    mesh.set_vertex(d, v2);
    mesh.set_next(g, a);
    mesh.set_prev(g, P_last);
    mesh.set_face(g, f0);
    mesh.set_next(Q_last, b);
    mesh.set_prev(Q_first, d);
    mesh.set_vertex_halfedge(v0, g);
    mesh.set_vertex_halfedge(v1, b);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f1, d);
    true
}

/// The operation `simple_flip_any`.
#[allow(non_snake_case)]
pub fn simple_flip_any(mesh: &mut Mesh, a: HalfedgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let d = mesh.twin(a);
    let g = mesh.next(d);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(mesh.next(b));
    let f1 = mesh.face(d);
    let v3 = mesh.vertex(mesh.next(g));
    let P_first = mesh.next(b);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(g);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return false; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return false; // `f1` is a hole
    }
    if v0 == v1 {
        return false; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return false; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return false; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return false; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return false; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return false; // `v2` and `v3` are one vertex
    }
    if f0 == f1 {
        return false; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return false; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return false; // `v1` would keep a single edge
    }
    let mut meets = false;
    let mut h = P_first;
    while h != a {
        if h != P_first && mesh.vertex(h) == v3 {
            meets = true;
        }
        h = mesh.next(h);
    }
    if meets {
        return false; // `f0` would meet `v3` twice
    }
    let mut meets_2 = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first && mesh.vertex(h) == v2 {
            meets_2 = true;
        }
        h = mesh.next(h);
    }
    if meets_2 {
        return false; // `f1` would meet `v2` twice
    }
    if mesh.adjacent(v3, v2) {
        return false; // two edges would join `v2` and `v3`
    }
    let mut same = false;
    let mut corners: Vec<VertexId> = vec![v3, v2, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut corners_2: Vec<VertexId> = vec![v2, v3, v1];
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if same_elements(&corners, &corners_2) {
        same = true;
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v3)).collect::<Vec<_>>() {
        if !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces.push(mesh.face(h));
        }
    }
    for &f in &faces {
        let mut corners_3: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners_3.push(mesh.vertex(h));
        }
        if same_elements(&corners_3, &corners) {
            same = true;
        }
    }
    if same {
        return false; // another face has the corners that `f0` would have
    }
    let mut same_2 = false;
    let mut corners_4: Vec<VertexId> = vec![v2, v3, v1];
    let mut h_2 = Q_first;
    while h_2 != d {
        if h_2 != Q_first {
            corners_4.push(mesh.vertex(h_2));
        }
        h_2 = mesh.next(h_2);
    }
    let mut corners_5: Vec<VertexId> = vec![v3, v2, v0];
    let mut h_2 = P_first;
    while h_2 != a {
        if h_2 != P_first {
            corners_5.push(mesh.vertex(h_2));
        }
        h_2 = mesh.next(h_2);
    }
    if same_elements(&corners_4, &corners_5) {
        same_2 = true;
    }
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
        if !mesh.is_hole(mesh.face(h_2)) && mesh.face(h_2) != f0 && mesh.face(h_2) != f1 {
            faces_2.push(mesh.face(h_2));
        }
    }
    for &f_2 in &faces_2 {
        let mut corners_6: Vec<VertexId> = Vec::new();
        for h_2 in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
            corners_6.push(mesh.vertex(h_2));
        }
        if same_elements(&corners_6, &corners_4) {
            same_2 = true;
        }
    }
    if same_2 {
        return false; // another face has the corners that `f1` would have
    }

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, P_first);
    mesh.set_prev(a, g);
    mesh.set_vertex(a, v3);
    mesh.set_next(b, d);
    mesh.set_prev(b, Q_last);
    mesh.set_face(b, f1);
    mesh.set_next(P_last, g);
    mesh.set_prev(P_first, a);
    mesh.set_next(d, Q_first);
    mesh.set_prev(d, b);
    mesh.set_vertex(d, v2);
    mesh.set_next(g, a);
    mesh.set_prev(g, P_last);
    mesh.set_face(g, f0);
    mesh.set_next(Q_last, b);
    mesh.set_prev(Q_first, d);
    mesh.set_vertex_halfedge(v0, g);
    mesh.set_vertex_halfedge(v1, b);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f1, d);
    true
}

/// The operation `surface_split`.
pub fn surface_split(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
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
    let e = mesh.edge(a);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return None; // `f1` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let r = mesh.add_halfedge();
    let s = mesh.add_halfedge();
    let t = mesh.add_halfedge();
    let u = mesh.add_halfedge();
    let f2 = mesh.add_face();
    let f3 = mesh.add_face();
    let e1 = mesh.add_edge();
    let e2 = mesh.add_edge();
    let e3 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, t);
    mesh.set_next(b, r);
    mesh.set_prev(b, q);
    mesh.set_face(b, f2);
    mesh.set_prev(c, p);
    mesh.set_next(d, s);
    mesh.set_twin(d, q);
    mesh.set_edge(d, e1);
    mesh.set_next(g, u);
    mesh.set_prev(g, t);
    mesh.set_face(g, f3);
    mesh.set_prev(h, s);
    mesh.set_next(p, c);
    mesh.set_prev(p, a);
    mesh.set_twin(p, r);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e2);
    mesh.set_face(p, f0);
    mesh.set_next(q, b);
    mesh.set_prev(q, r);
    mesh.set_twin(q, d);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e1);
    mesh.set_face(q, f2);
    mesh.set_next(r, q);
    mesh.set_prev(r, b);
    mesh.set_twin(r, p);
    mesh.set_vertex(r, v2);
    mesh.set_edge(r, e2);
    mesh.set_face(r, f2);
    mesh.set_next(s, h);
    mesh.set_prev(s, d);
    mesh.set_twin(s, u);
    mesh.set_vertex(s, m);
    mesh.set_edge(s, e3);
    mesh.set_face(s, f1);
    mesh.set_next(t, g);
    mesh.set_prev(t, u);
    mesh.set_twin(t, a);
    mesh.set_vertex(t, m);
    mesh.set_edge(t, e);
    mesh.set_face(t, f3);
    mesh.set_next(u, t);
    mesh.set_prev(u, g);
    mesh.set_twin(u, s);
    mesh.set_vertex(u, v3);
    mesh.set_edge(u, e3);
    mesh.set_face(u, f3);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, q);
    mesh.set_edge_halfedge(e2, p);
    mesh.set_edge_halfedge(e3, s);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f2, q);
    mesh.set_face_halfedge(f1, d);
    mesh.set_face_halfedge(f3, t);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `simple_split`.
pub fn simple_split(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
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
    let e = mesh.edge(a);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return None; // `f1` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let r = mesh.add_halfedge();
    let s = mesh.add_halfedge();
    let t = mesh.add_halfedge();
    let u = mesh.add_halfedge();
    let f2 = mesh.add_face();
    let f3 = mesh.add_face();
    let e1 = mesh.add_edge();
    let e2 = mesh.add_edge();
    let e3 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, t);
    mesh.set_next(b, r);
    mesh.set_prev(b, q);
    mesh.set_face(b, f2);
    mesh.set_prev(c, p);
    mesh.set_next(d, s);
    mesh.set_twin(d, q);
    mesh.set_edge(d, e1);
    mesh.set_next(g, u);
    mesh.set_prev(g, t);
    mesh.set_face(g, f3);
    mesh.set_prev(h, s);
    mesh.set_next(p, c);
    mesh.set_prev(p, a);
    mesh.set_twin(p, r);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e2);
    mesh.set_face(p, f0);
    mesh.set_next(q, b);
    mesh.set_prev(q, r);
    mesh.set_twin(q, d);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e1);
    mesh.set_face(q, f2);
    mesh.set_next(r, q);
    mesh.set_prev(r, b);
    mesh.set_twin(r, p);
    mesh.set_vertex(r, v2);
    mesh.set_edge(r, e2);
    mesh.set_face(r, f2);
    mesh.set_next(s, h);
    mesh.set_prev(s, d);
    mesh.set_twin(s, u);
    mesh.set_vertex(s, m);
    mesh.set_edge(s, e3);
    mesh.set_face(s, f1);
    mesh.set_next(t, g);
    mesh.set_prev(t, u);
    mesh.set_twin(t, a);
    mesh.set_vertex(t, m);
    mesh.set_edge(t, e);
    mesh.set_face(t, f3);
    mesh.set_next(u, t);
    mesh.set_prev(u, g);
    mesh.set_twin(u, s);
    mesh.set_vertex(u, v3);
    mesh.set_edge(u, e3);
    mesh.set_face(u, f3);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, q);
    mesh.set_edge_halfedge(e2, p);
    mesh.set_edge_halfedge(e3, s);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f2, q);
    mesh.set_face_halfedge(f1, d);
    mesh.set_face_halfedge(f3, t);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `surface_split_border`.
#[allow(non_snake_case)]
pub fn surface_split_border(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let c = mesh.next(b);
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(c);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if !mesh.is_hole(f1) {
        return None; // `f1` is not a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let r = mesh.add_halfedge();
    let t = mesh.add_halfedge();
    let f2 = mesh.add_face();
    let e1 = mesh.add_edge();
    let e2 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, t);
    mesh.set_next(b, r);
    mesh.set_prev(b, q);
    mesh.set_face(b, f2);
    mesh.set_prev(c, p);
    mesh.set_next(d, t);
    mesh.set_twin(d, q);
    mesh.set_edge(d, e1);
    mesh.set_prev(P_first, t);
    mesh.set_next(p, c);
    mesh.set_prev(p, a);
    mesh.set_twin(p, r);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e2);
    mesh.set_face(p, f0);
    mesh.set_next(q, b);
    mesh.set_prev(q, r);
    mesh.set_twin(q, d);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e1);
    mesh.set_face(q, f2);
    mesh.set_next(r, q);
    mesh.set_prev(r, b);
    mesh.set_twin(r, p);
    mesh.set_vertex(r, v2);
    mesh.set_edge(r, e2);
    mesh.set_face(r, f2);
    mesh.set_next(t, P_first);
    mesh.set_prev(t, d);
    mesh.set_twin(t, a);
    mesh.set_vertex(t, m);
    mesh.set_edge(t, e);
    mesh.set_face(t, f1);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, q);
    mesh.set_edge_halfedge(e2, p);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f2, q);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `simple_split_border`.
#[allow(non_snake_case)]
pub fn simple_split_border(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let c = mesh.next(b);
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(c);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if !mesh.is_hole(f1) {
        return None; // `f1` is not a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let r = mesh.add_halfedge();
    let t = mesh.add_halfedge();
    let f2 = mesh.add_face();
    let e1 = mesh.add_edge();
    let e2 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, t);
    mesh.set_next(b, r);
    mesh.set_prev(b, q);
    mesh.set_face(b, f2);
    mesh.set_prev(c, p);
    mesh.set_next(d, t);
    mesh.set_twin(d, q);
    mesh.set_edge(d, e1);
    mesh.set_prev(P_first, t);
    mesh.set_next(p, c);
    mesh.set_prev(p, a);
    mesh.set_twin(p, r);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e2);
    mesh.set_face(p, f0);
    mesh.set_next(q, b);
    mesh.set_prev(q, r);
    mesh.set_twin(q, d);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e1);
    mesh.set_face(q, f2);
    mesh.set_next(r, q);
    mesh.set_prev(r, b);
    mesh.set_twin(r, p);
    mesh.set_vertex(r, v2);
    mesh.set_edge(r, e2);
    mesh.set_face(r, f2);
    mesh.set_next(t, P_first);
    mesh.set_prev(t, d);
    mesh.set_twin(t, a);
    mesh.set_vertex(t, m);
    mesh.set_edge(t, e);
    mesh.set_face(t, f1);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, q);
    mesh.set_edge_halfedge(e2, p);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f2, q);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `surface_bisect`.
#[allow(non_snake_case)]
pub fn surface_bisect(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let Q_first = mesh.next(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let e1 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, q);
    mesh.set_prev(P_first, p);
    mesh.set_next(d, q);
    mesh.set_twin(d, p);
    mesh.set_edge(d, e1);
    mesh.set_prev(Q_first, q);
    mesh.set_next(p, P_first);
    mesh.set_prev(p, a);
    mesh.set_twin(p, d);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e1);
    mesh.set_face(p, f0);
    mesh.set_next(q, Q_first);
    mesh.set_prev(q, d);
    mesh.set_twin(q, a);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e);
    mesh.set_face(q, f1);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, p);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `simple_bisect`.
#[allow(non_snake_case)]
pub fn simple_bisect(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let Q_first = mesh.next(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    let mut same = false;
    let mut corners: Vec<VertexId> = vec![v0, v1];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut corners_2: Vec<VertexId> = vec![v1, v0];
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !mesh.is_hole(f1) && !mesh.is_hole(f0) && same_elements(&corners, &corners_2) {
        same = true;
    }
    if !mesh.is_hole(f0) && same {
        return None; // another face has the corners that `f0` would have
    }
    let mut same_2 = false;
    let mut corners_3: Vec<VertexId> = vec![v1, v0];
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_3.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut corners_4: Vec<VertexId> = vec![v0, v1];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners_4.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !mesh.is_hole(f0) && !mesh.is_hole(f1) && same_elements(&corners_3, &corners_4) {
        same_2 = true;
    }
    if !mesh.is_hole(f1) && same_2 {
        return None; // another face has the corners that `f1` would have
    }
    let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 2. Allocate what is new.
    let m = mesh.add_vertex();
    let p = mesh.add_halfedge();
    let q = mesh.add_halfedge();
    let e1 = mesh.add_edge();

    // 3. Reassign every pointer that changes.
    mesh.set_next(a, p);
    mesh.set_twin(a, q);
    mesh.set_prev(P_first, p);
    mesh.set_next(d, q);
    mesh.set_twin(d, p);
    mesh.set_edge(d, e1);
    mesh.set_prev(Q_first, q);
    mesh.set_next(p, P_first);
    mesh.set_prev(p, a);
    mesh.set_twin(p, d);
    mesh.set_vertex(p, m);
    mesh.set_edge(p, e1);
    mesh.set_face(p, f0);
    mesh.set_next(q, Q_first);
    mesh.set_prev(q, d);
    mesh.set_twin(q, a);
    mesh.set_vertex(q, m);
    mesh.set_edge(q, e);
    mesh.set_face(q, f1);
    mesh.set_vertex_halfedge(m, p);
    mesh.set_edge_halfedge(e, a);
    mesh.set_edge_halfedge(e1, p);
    mesh.set_position(m, m_position);
    Some(m)
}

/// The operation `surface_collapse`.
pub fn surface_collapse(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
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
    let e = mesh.edge(a);
    let eb = mesh.edge(b);
    let ec = mesh.edge(c);
    let eg = mesh.edge(g);
    let eh = mesh.edge(h);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return None; // `f1` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    if (mesh.degree(v2) as i64) < 3 {
        return None; // `v2` would keep a single edge
    }
    if (mesh.degree(v3) as i64) < 3 {
        return None; // `v3` would keep a single edge
    }
    let mut holes = 0;
    if mesh.is_hole(mesh.face(c_)) {
        holes += 1;
    }
    if mesh.is_hole(mesh.face(h_)) {
        holes += 1;
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ && mesh.is_hole(mesh.face(h_2)) {
            holes += 1;
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ && mesh.is_hole(mesh.face(h_2)) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(c_), mesh.face(h_)];
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ {
            faces.push(mesh.face(h_2));
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ {
            faces.push(mesh.face(h_2));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
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
    Some(v0)
}

/// The operation `simple_collapse`.
pub fn simple_collapse(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
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
    let e = mesh.edge(a);
    let eb = mesh.edge(b);
    let ec = mesh.edge(c);
    let eg = mesh.edge(g);
    let eh = mesh.edge(h);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if mesh.next(h) != d {
        return None; // `f1` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    if (mesh.degree(v2) as i64) < 3 {
        return None; // `v2` would keep a single edge
    }
    if (mesh.degree(v3) as i64) < 3 {
        return None; // `v3` would keep a single edge
    }
    let mut holes = 0;
    if mesh.is_hole(mesh.face(c_)) {
        holes += 1;
    }
    if mesh.is_hole(mesh.face(h_)) {
        holes += 1;
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ && mesh.is_hole(mesh.face(h_2)) {
            holes += 1;
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ && mesh.is_hole(mesh.face(h_2)) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(c_), mesh.face(h_)];
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ {
            faces.push(mesh.face(h_2));
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ {
            faces.push(mesh.face(h_2));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
    }
    let mut neighbors: Vec<VertexId> = vec![v2, v3];
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ {
            neighbors.push(if mesh.vertex(mesh.twin(h_2)) == v1 { v0 } else { mesh.vertex(mesh.twin(h_2)) });
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ {
            neighbors.push(if mesh.vertex(mesh.twin(h_2)) == v1 { v0 } else { mesh.vertex(mesh.twin(h_2)) });
        }
    }
    if !all_differ(&neighbors) {
        return None; // `v0` and `v1` have a neighbor in common: two edges would join it to `v0`
    }
    let mut same = false;
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && h_2 != g && h_2 != c_ && !mesh.is_hole(mesh.face(h_2)) && mesh.face(h_2) != f0 && mesh.face(h_2) != f1 {
            faces_2.push(mesh.face(h_2));
        }
    }
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h_2 != b && h_2 != d && h_2 != h_ && !mesh.is_hole(mesh.face(h_2)) && mesh.face(h_2) != f0 && mesh.face(h_2) != f1 {
            faces_2.push(mesh.face(h_2));
        }
    }
    if !mesh.is_hole(mesh.face(c_)) && mesh.face(c_) != f0 && mesh.face(c_) != f1 {
        faces_2.push(mesh.face(c_));
    }
    if !mesh.is_hole(mesh.face(h_)) && mesh.face(h_) != f0 && mesh.face(h_) != f1 {
        faces_2.push(mesh.face(h_));
    }
    for &f in &faces_2 {
        let mut corners: Vec<VertexId> = Vec::new();
        for h_2 in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners.push(if mesh.vertex(h_2) == v1 { v0 } else { mesh.vertex(h_2) });
        }
        for &f_2 in &faces_2 {
            if f_2 != f {
                let mut corners_2: Vec<VertexId> = Vec::new();
                for h_3 in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
                    corners_2.push(if mesh.vertex(h_3) == v1 { v0 } else { mesh.vertex(h_3) });
                }
                if same_elements(&corners, &corners_2) {
                    same = true;
                }
            }
        }
    }
    if same {
        return None; // two faces around `v0` would have the same corners
    }
    let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 3. Reassign every pointer that changes.
    let mut h_4 = mesh.next(b_);
    while h_4 != h_ {
        mesh.set_vertex(h_4, v0);
        h_4 = mesh.next(mesh.twin(h_4));
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
    Some(v0)
}

/// The operation `surface_collapse_border`.
#[allow(non_snake_case)]
pub fn surface_collapse_border(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let c = mesh.next(b);
    let d = mesh.twin(a);
    let b_ = mesh.twin(b);
    let c_ = mesh.twin(c);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(c_);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(b_);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let eb = mesh.edge(b);
    let ec = mesh.edge(c);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if !mesh.is_hole(f1) {
        return None; // `f1` is not a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if (mesh.face_size(f1) as i64) < 4 {
        return None; // `f1` would have fewer than 3 sides
    }
    if (mesh.degree(v2) as i64) < 3 {
        return None; // `v2` would keep a single edge
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(c_)];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && h != c_ {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != b && h != d {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
    }
    let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 3. Reassign every pointer that changes.
    let mut h = mesh.next(b_);
    while h != d {
        mesh.set_vertex(h, v0);
        h = mesh.next(mesh.twin(h));
    }
    mesh.set_next(Q_last, Q_first);
    mesh.set_prev(Q_first, Q_last);
    mesh.set_twin(b_, c_);
    mesh.set_twin(c_, b_);
    mesh.set_edge(c_, eb);
    mesh.set_vertex_halfedge(v0, c_);
    mesh.set_vertex_halfedge(v2, b_);
    mesh.set_edge_halfedge(eb, b_);
    mesh.set_face_halfedge(f1, Q_first);
    mesh.set_position(v0, v0_position);

    // 4. Erase what is gone.
    mesh.erase_vertex(v1);
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_halfedge(b);
    mesh.erase_halfedge(c);
    mesh.erase_face(f0);
    mesh.erase_edge(ec);
    Some(v0)
}

/// The operation `simple_collapse_border`.
#[allow(non_snake_case)]
pub fn simple_collapse_border(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let c = mesh.next(b);
    let d = mesh.twin(a);
    let b_ = mesh.twin(b);
    let c_ = mesh.twin(c);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(c_);
    let v1 = mesh.vertex(d);
    let v2 = mesh.vertex(b_);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let eb = mesh.edge(b);
    let ec = mesh.edge(c);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if !mesh.is_hole(f1) {
        return None; // `f1` is not a hole
    }
    if mesh.next(c) != a {
        return None; // `f0` is not a triangle
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if (mesh.face_size(f1) as i64) < 4 {
        return None; // `f1` would have fewer than 3 sides
    }
    if (mesh.degree(v2) as i64) < 3 {
        return None; // `v2` would keep a single edge
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(c_)];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && h != c_ {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != b && h != d {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
    }
    let mut neighbors: Vec<VertexId> = vec![v2];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && h != c_ {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v1 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != b && h != d {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v1 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    if !all_differ(&neighbors) {
        return None; // `v0` and `v1` have a neighbor in common: two edges would join it to `v0`
    }
    let mut same = false;
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && h != c_ && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces_2.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != b && h != d && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces_2.push(mesh.face(h));
        }
    }
    if !mesh.is_hole(mesh.face(c_)) && mesh.face(c_) != f0 && mesh.face(c_) != f1 {
        faces_2.push(mesh.face(c_));
    }
    for &f in &faces_2 {
        let mut corners: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners.push(if mesh.vertex(h) == v1 { v0 } else { mesh.vertex(h) });
        }
        for &f_2 in &faces_2 {
            if f_2 != f {
                let mut corners_2: Vec<VertexId> = Vec::new();
                for h_2 in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
                    corners_2.push(if mesh.vertex(h_2) == v1 { v0 } else { mesh.vertex(h_2) });
                }
                if same_elements(&corners, &corners_2) {
                    same = true;
                }
            }
        }
    }
    if same {
        return None; // two faces around `v0` would have the same corners
    }
    let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 3. Reassign every pointer that changes.
    let mut h_3 = mesh.next(b_);
    while h_3 != d {
        mesh.set_vertex(h_3, v0);
        h_3 = mesh.next(mesh.twin(h_3));
    }
    mesh.set_next(Q_last, Q_first);
    mesh.set_prev(Q_first, Q_last);
    mesh.set_twin(b_, c_);
    mesh.set_twin(c_, b_);
    mesh.set_edge(c_, eb);
    mesh.set_vertex_halfedge(v0, c_);
    mesh.set_vertex_halfedge(v2, b_);
    mesh.set_edge_halfedge(eb, b_);
    mesh.set_face_halfedge(f1, Q_first);
    mesh.set_position(v0, v0_position);

    // 4. Erase what is gone.
    mesh.erase_vertex(v1);
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_halfedge(b);
    mesh.erase_halfedge(c);
    mesh.erase_face(f0);
    mesh.erase_edge(ec);
    Some(v0)
}

/// The operation `surface_contract`.
#[allow(non_snake_case)]
pub fn surface_contract(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.face_size(f0) as i64) < 4 {
        return None; // `f0` would have fewer than 3 sides
    }
    if (mesh.face_size(f1) as i64) < 4 {
        return None; // `f1` would have fewer than 3 sides
    }
    let mut holes = 0;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && mesh.is_hole(mesh.face(h)) {
            holes += 1;
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d && mesh.is_hole(mesh.face(h)) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
    }
    let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 3. Reassign every pointer that changes.
    let mut h = mesh.next(a);
    while h != d {
        mesh.set_vertex(h, v0);
        h = mesh.next(mesh.twin(h));
    }
    mesh.set_next(P_last, P_first);
    mesh.set_prev(P_first, P_last);
    mesh.set_next(Q_last, Q_first);
    mesh.set_prev(Q_first, Q_last);
    mesh.set_vertex_halfedge(v0, P_first);
    mesh.set_face_halfedge(f0, P_first);
    mesh.set_face_halfedge(f1, Q_first);
    mesh.set_position(v0, v0_position);

    // 4. Erase what is gone.
    mesh.erase_vertex(v1);
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    Some(v0)
}

/// The operation `simple_contract`.
#[allow(non_snake_case)]
pub fn simple_contract(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.face_size(f0) as i64) < 4 {
        return None; // `f0` would have fewer than 3 sides
    }
    if (mesh.face_size(f1) as i64) < 4 {
        return None; // `f1` would have fewer than 3 sides
    }
    let mut holes = 0;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && mesh.is_hole(mesh.face(h)) {
            holes += 1;
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d && mesh.is_hole(mesh.face(h)) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // both `v0` and `v1` lie on the boundary: the surface would be pinched at `v0`
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v1` would meet `v0` twice
    }
    let mut neighbors: Vec<VertexId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v1 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v1 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    if !all_differ(&neighbors) {
        return None; // `v0` and `v1` have a neighbor in common: two edges would join it to `v0`
    }
    let mut same = false;
    let mut corners: Vec<VertexId> = vec![v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(if mesh.vertex(h) == v1 { v0 } else { mesh.vertex(h) });
        }
        h = mesh.next(h);
    }
    let mut corners_2: Vec<VertexId> = vec![v0];
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_2.push(if mesh.vertex(h) == v1 { v0 } else { mesh.vertex(h) });
        }
        h = mesh.next(h);
    }
    if !mesh.is_hole(f1) && !mesh.is_hole(f0) && corners.contains(&v0) && same_elements(&corners, &corners_2) {
        same = true;
    }
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces_2.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces_2.push(mesh.face(h));
        }
    }
    for &f in &faces_2 {
        let mut corners_3: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners_3.push(if mesh.vertex(h) == v1 { v0 } else { mesh.vertex(h) });
        }
        if !mesh.is_hole(f0) && same_elements(&corners_3, &corners) {
            same = true;
        }
        if !mesh.is_hole(f1) && same_elements(&corners_3, &corners_2) {
            same = true;
        }
        for &f_2 in &faces_2 {
            if f_2 != f {
                let mut corners_4: Vec<VertexId> = Vec::new();
                for h_2 in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
                    corners_4.push(if mesh.vertex(h_2) == v1 { v0 } else { mesh.vertex(h_2) });
                }
                if same_elements(&corners_3, &corners_4) {
                    same = true;
                }
            }
        }
    }
    if same {
        return None; // two faces around `v0` would have the same corners
    }
    let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

    // 3. Reassign every pointer that changes.
    let mut h_3 = mesh.next(a);
    while h_3 != d {
        mesh.set_vertex(h_3, v0);
        h_3 = mesh.next(mesh.twin(h_3));
    }
    mesh.set_next(P_last, P_first);
    mesh.set_prev(P_first, P_last);
    mesh.set_next(Q_last, Q_first);
    mesh.set_prev(Q_first, Q_last);
    mesh.set_vertex_halfedge(v0, P_first);
    mesh.set_face_halfedge(f0, P_first);
    mesh.set_face_halfedge(f1, Q_first);
    mesh.set_position(v0, v0_position);

    // 4. Erase what is gone.
    mesh.erase_vertex(v1);
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    Some(v0)
}

/// The operation `surface_dissolve_edge`.
#[allow(non_snake_case)]
pub fn surface_dissolve_edge(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != d {
        mesh.set_face(h, f0);
        h = mesh.next(h);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `simple_dissolve_edge`.
#[allow(non_snake_case)]
pub fn simple_dissolve_edge(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if mesh.is_hole(f0) {
        return None; // `f0` is a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }
    let mut same = false;
    let mut corners_2: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces.push(mesh.face(h));
        }
    }
    for &f in &faces {
        let mut corners_3: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners_3.push(mesh.vertex(h));
        }
        if same_elements(&corners_3, &corners_2) {
            same = true;
        }
    }
    if same {
        return None; // another face has the corners that `f0` would have
    }

    // 3. Reassign every pointer that changes.
    let mut h_2 = Q_first;
    while h_2 != d {
        mesh.set_face(h_2, f0);
        h_2 = mesh.next(h_2);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `surface_dissolve_into_hole`.
#[allow(non_snake_case)]
pub fn surface_dissolve_into_hole(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if !mesh.is_hole(f0) {
        return None; // `f0` is not a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut pinched = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            let mut holes = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if mesh.face(s) == f1 || mesh.is_hole(mesh.face(s)) {
                    holes += 1;
                }
            }
            if 1 < holes {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `Q`
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != d {
        mesh.set_face(h, f0);
        h = mesh.next(h);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `simple_dissolve_into_hole`.
#[allow(non_snake_case)]
pub fn simple_dissolve_into_hole(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if !mesh.is_hole(f0) {
        return None; // `f0` is not a hole
    }
    if mesh.is_hole(f1) {
        return None; // `f1` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut pinched = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            let mut holes = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if mesh.face(s) == f1 || mesh.is_hole(mesh.face(s)) {
                    holes += 1;
                }
            }
            if 1 < holes {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `Q`
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != d {
        mesh.set_face(h, f0);
        h = mesh.next(h);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `surface_dissolve_any`.
#[allow(non_snake_case)]
pub fn surface_dissolve_any(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut pinched = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            let mut holes = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if if mesh.face(s) == f1 { mesh.is_hole(f0) } else { mesh.is_hole(mesh.face(s)) } {
                    holes += 1;
                }
            }
            if 1 < holes {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `Q`
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != d {
        mesh.set_face(h, f0);
        h = mesh.next(h);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `simple_dissolve_any`.
#[allow(non_snake_case)]
pub fn simple_dissolve_any(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let d = mesh.twin(a);
    let f0 = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(d);
    let f1 = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(a);
    let P_last = mesh.prev(a);
    let Q_first = mesh.next(d);
    let Q_last = mesh.prev(d);
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    if (mesh.degree(v0) as i64) < 3 {
        return None; // `v0` would keep a single edge
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut pinched = false;
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            let mut holes = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if if mesh.face(s) == f1 { mesh.is_hole(f0) } else { mesh.is_hole(mesh.face(s)) } {
                    holes += 1;
                }
            }
            if 1 < holes {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `Q`
    }
    let mut corners: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if !all_differ(&corners) {
        return None; // `f0` would meet a vertex twice
    }
    let mut same = false;
    let mut corners_2: Vec<VertexId> = vec![v1, v0];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut h = Q_first;
    while h != d {
        if h != Q_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if h != d && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f0 && mesh.face(h) != f1 {
            faces.push(mesh.face(h));
        }
    }
    for &f in &faces {
        let mut corners_3: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f)).collect::<Vec<_>>() {
            corners_3.push(mesh.vertex(h));
        }
        if !mesh.is_hole(f0) && same_elements(&corners_3, &corners_2) {
            same = true;
        }
    }
    if !mesh.is_hole(f0) && same {
        return None; // another face has the corners that `f0` would have
    }

    // 3. Reassign every pointer that changes.
    let mut h_2 = Q_first;
    while h_2 != d {
        mesh.set_face(h_2, f0);
        h_2 = mesh.next(h_2);
    }
    mesh.set_next(P_last, Q_first);
    mesh.set_prev(P_first, Q_last);
    mesh.set_next(Q_last, P_first);
    mesh.set_prev(Q_first, P_last);
    mesh.set_vertex_halfedge(v0, Q_first);
    mesh.set_vertex_halfedge(v1, P_first);
    mesh.set_face_halfedge(f0, P_first);

    // 4. Erase what is gone.
    mesh.erase_edge(e);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_face(f1);
    Some(f0)
}

/// The operation `surface_open_face`.
#[allow(non_snake_case)]
pub fn surface_open_face(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let P_first = mesh.next(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    let mut holes = 1;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && (mesh.face(h) == f || mesh.is_hole(mesh.face(h))) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // the surface would be pinched at `v0`
    }
    let mut holes_2 = 0;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if mesh.face(h) == f || mesh.is_hole(mesh.face(h)) {
            holes_2 += 1;
        }
    }
    if 1 < holes_2 {
        return None; // the surface would be pinched at `v1`
    }
    let mut pinched = false;
    let mut h = P_first;
    while h != a {
        if h != P_first {
            let mut holes_3 = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if mesh.face(s) == f || mesh.is_hole(mesh.face(s)) {
                    holes_3 += 1;
                }
            }
            if 1 < holes_3 {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `P`
    }

    // 3. Reassign every pointer that changes.
    mesh.set_hole(f, true);
    Some(f)
}

/// The operation `simple_open_face`.
#[allow(non_snake_case)]
pub fn simple_open_face(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let P_first = mesh.next(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    let mut holes = 1;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && (mesh.face(h) == f || mesh.is_hole(mesh.face(h))) {
            holes += 1;
        }
    }
    if 1 < holes {
        return None; // the surface would be pinched at `v0`
    }
    let mut holes_2 = 0;
    for h in mesh.spokes_from(mesh.vertex_halfedge(v1)).collect::<Vec<_>>() {
        if mesh.face(h) == f || mesh.is_hole(mesh.face(h)) {
            holes_2 += 1;
        }
    }
    if 1 < holes_2 {
        return None; // the surface would be pinched at `v1`
    }
    let mut pinched = false;
    let mut h = P_first;
    while h != a {
        if h != P_first {
            let mut holes_3 = 0;
            for s in mesh.spokes_from(h).collect::<Vec<_>>() {
                if mesh.face(s) == f || mesh.is_hole(mesh.face(s)) {
                    holes_3 += 1;
                }
            }
            if 1 < holes_3 {
                pinched = true;
            }
        }
        h = mesh.next(h);
    }
    if pinched {
        return None; // the surface would be pinched at a vertex of `P`
    }

    // 3. Reassign every pointer that changes.
    mesh.set_hole(f, true);
    Some(f)
}

/// The operation `surface_fill_hole`.
pub fn surface_fill_hole(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }

    // 3. Reassign every pointer that changes.
    mesh.set_hole(f, false);
    Some(f)
}

/// The operation `simple_fill_hole`.
#[allow(non_snake_case)]
pub fn simple_fill_hole(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let P_first = mesh.next(a);
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    let mut same = false;
    let mut corners: Vec<VertexId> = vec![v0, v1];
    let mut h = P_first;
    while h != a {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f {
            faces.push(mesh.face(h));
        }
    }
    for &f_2 in &faces {
        let mut corners_2: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
            corners_2.push(mesh.vertex(h));
        }
        if same_elements(&corners_2, &corners) {
            same = true;
        }
    }
    if same {
        return None; // another face has the corners that `f` would have
    }

    // 3. Reassign every pointer that changes.
    mesh.set_hole(f, false);
    Some(f)
}

/// The operation `surface_zip`.
#[allow(non_snake_case)]
pub fn surface_zip(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let a_ = mesh.twin(a);
    let b_ = mesh.twin(b);
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(a_);
    let v2 = mesh.vertex(b_);
    let ea = mesh.edge(a);
    let eb = mesh.edge(b);
    let P_first = mesh.next(b);
    let P_last = mesh.prev(a);
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if (mesh.face_size(f) as i64) < 5 {
        return None; // `f` would have fewer than 3 sides
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(b_)];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
        if h != b_ {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v2` would meet `v0` twice
    }

    // 3. Reassign every pointer that changes.
    let mut h = mesh.next(b);
    while h != b_ {
        mesh.set_vertex(h, v0);
        h = mesh.next(mesh.twin(h));
    }
    mesh.set_next(P_last, P_first);
    mesh.set_prev(P_first, P_last);
    mesh.set_twin(a_, b_);
    mesh.set_twin(b_, a_);
    mesh.set_vertex(b_, v0);
    mesh.set_edge(b_, ea);
    mesh.set_vertex_halfedge(v0, b_);
    mesh.set_vertex_halfedge(v1, a_);
    mesh.set_edge_halfedge(ea, a_);
    mesh.set_face_halfedge(f, P_first);

    // 4. Erase what is gone.
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(b);
    mesh.erase_edge(eb);
    mesh.erase_vertex(v2);
    Some(v0)
}

/// The operation `simple_zip`.
#[allow(non_snake_case)]
pub fn simple_zip(mesh: &mut Mesh, a: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let b = mesh.next(a);
    let a_ = mesh.twin(a);
    let b_ = mesh.twin(b);
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(a_);
    let v2 = mesh.vertex(b_);
    let ea = mesh.edge(a);
    let eb = mesh.edge(b);
    let P_first = mesh.next(b);
    let P_last = mesh.prev(a);
    if !mesh.is_hole(f) {
        return None; // `f` is not a hole
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if (mesh.face_size(f) as i64) < 5 {
        return None; // `f` would have fewer than 3 sides
    }
    if (mesh.degree(v1) as i64) < 3 {
        return None; // `v1` would keep a single edge
    }
    let mut faces: Vec<FaceId> = vec![mesh.face(b_)];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            faces.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
        if h != b_ {
            faces.push(mesh.face(h));
        }
    }
    if !all_differ(&faces) {
        return None; // a face around both `v0` and `v2` would meet `v0` twice
    }
    let mut neighbors: Vec<VertexId> = vec![v1];
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v2 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
        if h != b_ {
            neighbors.push(if mesh.vertex(mesh.twin(h)) == v2 { v0 } else { mesh.vertex(mesh.twin(h)) });
        }
    }
    if !all_differ(&neighbors) {
        return None; // `v0` and `v2` have a neighbor in common: two edges would join it to `v0`
    }
    let mut same = false;
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f {
            faces_2.push(mesh.face(h));
        }
    }
    for h in mesh.spokes_from(mesh.vertex_halfedge(v2)).collect::<Vec<_>>() {
        if h != b_ && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f {
            faces_2.push(mesh.face(h));
        }
    }
    if !mesh.is_hole(mesh.face(b_)) && mesh.face(b_) != f {
        faces_2.push(mesh.face(b_));
    }
    for &f_2 in &faces_2 {
        let mut corners: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
            corners.push(if mesh.vertex(h) == v2 { v0 } else { mesh.vertex(h) });
        }
        for &f_3 in &faces_2 {
            if f_3 != f_2 {
                let mut corners_2: Vec<VertexId> = Vec::new();
                for h_2 in mesh.loop_from(mesh.face_halfedge(f_3)).collect::<Vec<_>>() {
                    corners_2.push(if mesh.vertex(h_2) == v2 { v0 } else { mesh.vertex(h_2) });
                }
                if same_elements(&corners, &corners_2) {
                    same = true;
                }
            }
        }
    }
    if same {
        return None; // two faces around `v0` would have the same corners
    }

    // 3. Reassign every pointer that changes.
    let mut h_3 = mesh.next(b);
    while h_3 != b_ {
        mesh.set_vertex(h_3, v0);
        h_3 = mesh.next(mesh.twin(h_3));
    }
    mesh.set_next(P_last, P_first);
    mesh.set_prev(P_first, P_last);
    mesh.set_twin(a_, b_);
    mesh.set_twin(b_, a_);
    mesh.set_vertex(b_, v0);
    mesh.set_edge(b_, ea);
    mesh.set_vertex_halfedge(v0, b_);
    mesh.set_vertex_halfedge(v1, a_);
    mesh.set_edge_halfedge(ea, a_);
    mesh.set_face_halfedge(f, P_first);

    // 4. Erase what is gone.
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(b);
    mesh.erase_edge(eb);
    mesh.erase_vertex(v2);
    Some(v0)
}

/// The operation `surface_connect`.
#[allow(non_snake_case)]
pub fn surface_connect(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }

    // 2. Allocate what is new.
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h = Q_first;
    while h != a {
        mesh.set_face(h, g);
        h = mesh.next(h);
    }
    mesh.set_prev(a, x);
    mesh.set_next(P_last, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(Q_last, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, P_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, Q_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, y);
    Some(e)
}

/// The operation `simple_connect`.
#[allow(non_snake_case)]
pub fn simple_connect(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f = mesh.face(a);
    let v0 = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let v2 = mesh.vertex(b);
    let v3 = mesh.vertex(mesh.next(b));
    let P_first = mesh.next(a);
    let P_last = mesh.prev(b);
    let Q_first = mesh.next(b);
    let Q_last = mesh.prev(a);
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if mesh.face(b) != f {
        return None; // `b` does not lie in `f`
    }
    if v0 == v1 {
        return None; // `v0` and `v1` are one vertex
    }
    if v0 == v2 {
        return None; // `v0` and `v2` are one vertex
    }
    if v0 == v3 {
        return None; // `v0` and `v3` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if v1 == v3 {
        return None; // `v1` and `v3` are one vertex
    }
    if v2 == v3 {
        return None; // `v2` and `v3` are one vertex
    }
    if mesh.adjacent(v2, v0) {
        return None; // two edges would join `v0` and `v2`
    }
    let mut same = false;
    let mut corners: Vec<VertexId> = vec![v0, v1, v2];
    let mut h = P_first;
    while h != b {
        if h != P_first {
            corners.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    let mut corners_2: Vec<VertexId> = vec![v0, v2, v3];
    let mut h = Q_first;
    while h != a {
        if h != Q_first {
            corners_2.push(mesh.vertex(h));
        }
        h = mesh.next(h);
    }
    if same_elements(&corners, &corners_2) {
        same = true;
    }
    let mut faces: Vec<FaceId> = Vec::new();
    for h in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h != a && !mesh.is_hole(mesh.face(h)) && mesh.face(h) != f {
            faces.push(mesh.face(h));
        }
    }
    for &f_2 in &faces {
        let mut corners_3: Vec<VertexId> = Vec::new();
        for h in mesh.loop_from(mesh.face_halfedge(f_2)).collect::<Vec<_>>() {
            corners_3.push(mesh.vertex(h));
        }
        if same_elements(&corners_3, &corners) {
            same = true;
        }
    }
    if same {
        return None; // another face has the corners that `f` would have
    }
    let mut same_2 = false;
    let mut corners_4: Vec<VertexId> = vec![v0, v2, v3];
    let mut h_2 = Q_first;
    while h_2 != a {
        if h_2 != Q_first {
            corners_4.push(mesh.vertex(h_2));
        }
        h_2 = mesh.next(h_2);
    }
    let mut corners_5: Vec<VertexId> = vec![v0, v1, v2];
    let mut h_2 = P_first;
    while h_2 != b {
        if h_2 != P_first {
            corners_5.push(mesh.vertex(h_2));
        }
        h_2 = mesh.next(h_2);
    }
    if same_elements(&corners_4, &corners_5) {
        same_2 = true;
    }
    let mut faces_2: Vec<FaceId> = Vec::new();
    for h_2 in mesh.spokes_from(mesh.vertex_halfedge(v0)).collect::<Vec<_>>() {
        if h_2 != a && !mesh.is_hole(mesh.face(h_2)) && mesh.face(h_2) != f {
            faces_2.push(mesh.face(h_2));
        }
    }
    for &f_3 in &faces_2 {
        let mut corners_6: Vec<VertexId> = Vec::new();
        for h_2 in mesh.loop_from(mesh.face_halfedge(f_3)).collect::<Vec<_>>() {
            corners_6.push(mesh.vertex(h_2));
        }
        if same_elements(&corners_6, &corners_4) {
            same_2 = true;
        }
    }
    if same_2 {
        return None; // another face has the corners that `g` would have
    }

    // 2. Allocate what is new.
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();
    let g = mesh.add_face();

    // 3. Reassign every pointer that changes.
    let mut h_3 = Q_first;
    while h_3 != a {
        mesh.set_face(h_3, g);
        h_3 = mesh.next(h_3);
    }
    mesh.set_prev(a, x);
    mesh.set_next(P_last, x);
    mesh.set_prev(b, y);
    mesh.set_face(b, g);
    mesh.set_next(Q_last, y);
    mesh.set_next(x, a);
    mesh.set_prev(x, P_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v2);
    mesh.set_edge(x, e);
    mesh.set_face(x, f);
    mesh.set_next(y, b);
    mesh.set_prev(y, Q_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, v0);
    mesh.set_edge(y, e);
    mesh.set_face(y, g);
    mesh.set_edge_halfedge(e, x);
    mesh.set_face_halfedge(f, a);
    mesh.set_face_halfedge(g, y);
    Some(e)
}

/// The operation `surface_part_vertex`.
#[allow(non_snake_case)]
pub fn surface_part_vertex(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f0 = mesh.face(a);
    let v = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let f1 = mesh.face(b);
    let v2 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(a);
    let Q_last = mesh.prev(b);
    if mesh.vertex(b) != v {
        return None; // `b` does not start at `v`
    }
    if v == v1 {
        return None; // `v` and `v1` are one vertex
    }
    if v == v2 {
        return None; // `v` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    let w_position = mesh.position(v);

    // 2. Allocate what is new.
    let w = mesh.add_vertex();
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();

    // 3. Reassign every pointer that changes.
    let mut h = mesh.next(mesh.twin(b));
    while h != a {
        mesh.set_vertex(h, w);
        h = mesh.next(mesh.twin(h));
    }
    mesh.set_prev(a, y);
    mesh.set_next(P_last, y);
    mesh.set_prev(b, x);
    mesh.set_vertex(b, w);
    mesh.set_next(Q_last, x);
    mesh.set_next(x, b);
    mesh.set_prev(x, Q_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v);
    mesh.set_edge(x, e);
    mesh.set_face(x, f1);
    mesh.set_next(y, a);
    mesh.set_prev(y, P_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, w);
    mesh.set_edge(y, e);
    mesh.set_face(y, f0);
    mesh.set_vertex_halfedge(v, a);
    mesh.set_vertex_halfedge(w, b);
    mesh.set_edge_halfedge(e, x);
    mesh.set_position(w, w_position);
    Some(w)
}

/// The operation `simple_part_vertex`.
#[allow(non_snake_case)]
pub fn simple_part_vertex(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let f0 = mesh.face(a);
    let v = mesh.vertex(a);
    let v1 = mesh.vertex(mesh.next(a));
    let f1 = mesh.face(b);
    let v2 = mesh.vertex(mesh.next(b));
    let P_last = mesh.prev(a);
    let Q_last = mesh.prev(b);
    if mesh.vertex(b) != v {
        return None; // `b` does not start at `v`
    }
    if v == v1 {
        return None; // `v` and `v1` are one vertex
    }
    if v == v2 {
        return None; // `v` and `v2` are one vertex
    }
    if v1 == v2 {
        return None; // `v1` and `v2` are one vertex
    }
    if f0 == f1 {
        return None; // `f0` and `f1` are one face
    }
    // The guard looks at what there would be, on a sheet over the mesh.
    {
        let mut sheet = Sheet::new(mesh);
        let w = sheet.add_vertex();
        let x = sheet.add_halfedge();
        let y = sheet.add_halfedge();
        let mut h = mesh.next(mesh.twin(b));
        while h != a {
            sheet.set_vertex(h, w);
            h = mesh.next(mesh.twin(h));
        }
        sheet.set_next(P_last, y);
        sheet.set_vertex(b, w);
        sheet.set_next(Q_last, x);
        sheet.set_next(x, b);
        sheet.set_twin(x, y);
        sheet.set_vertex(x, v);
        sheet.set_face(x, f1);
        sheet.set_next(y, a);
        sheet.set_twin(y, x);
        sheet.set_vertex(y, w);
        sheet.set_face(y, f0);
        sheet.set_vertex_halfedge(v, a);
        sheet.set_vertex_halfedge(w, b);
        if !sheet.single_edge(b) {
            return None; // two edges would join `v2` and `w`
        }
        if !sheet.single_edge(x) {
            return None; // two edges would join `v` and `w`
        }
        if !sheet.corners_own(f0, v) {
            return None; // another face has the corners that `f0` would have
        }
        if !sheet.corners_own(f1, w) {
            return None; // another face has the corners that `f1` would have
        }
    }
    let w_position = mesh.position(v);

    // 2. Allocate what is new.
    let w = mesh.add_vertex();
    let e = mesh.add_edge();
    let x = mesh.add_halfedge();
    let y = mesh.add_halfedge();

    // 3. Reassign every pointer that changes.
    let mut h = mesh.next(mesh.twin(b));
    while h != a {
        mesh.set_vertex(h, w);
        h = mesh.next(mesh.twin(h));
    }
    mesh.set_prev(a, y);
    mesh.set_next(P_last, y);
    mesh.set_prev(b, x);
    mesh.set_vertex(b, w);
    mesh.set_next(Q_last, x);
    mesh.set_next(x, b);
    mesh.set_prev(x, Q_last);
    mesh.set_twin(x, y);
    mesh.set_vertex(x, v);
    mesh.set_edge(x, e);
    mesh.set_face(x, f1);
    mesh.set_next(y, a);
    mesh.set_prev(y, P_last);
    mesh.set_twin(y, x);
    mesh.set_vertex(y, w);
    mesh.set_edge(y, e);
    mesh.set_face(y, f0);
    mesh.set_vertex_halfedge(v, a);
    mesh.set_vertex_halfedge(w, b);
    mesh.set_edge_halfedge(e, x);
    mesh.set_position(w, w_position);
    Some(w)
}

/// How far a vertex goes: farther in a large face.
fn reach(mesh: &Mesh, f: FaceId) -> f64 {
    if 3 < (mesh.face_size(f) as i64) {
        let sides = mesh.face_size(f) as i64;
        let half = (sides as f64) / 2.0;
        return 0.25 + half / 100.0;
    }
    0.125
}

/// A place on the way from one vertex to another.
fn between(mesh: &Mesh, v: VertexId, w: VertexId, t: f64) -> DVec3 {
    DVec3::lerp(mesh.position(v), mesh.position(w), t)
}

/// Whether the corner at the origin of a halfedge turns left, as seen from above.
fn holds_(mesh: &Mesh, h: HalfedgeId) -> bool {
    let ahead = mesh.position(mesh.target(h)) - mesh.position(mesh.vertex(h));
    let back = mesh.position(mesh.vertex(mesh.prev(h))) - mesh.position(mesh.vertex(h));
    if mesh.is_boundary_halfedge(h) { true } else { -reach(mesh, mesh.face(h)) <= DVec3::cross(ahead, back).z }
}

/// The plane of a face: its unit normal, and how far it is from the origin.
fn plane_of(mesh: &Mesh, f: FaceId) -> DVec4 {
    let n = mesh.normal(f);
    n.extend(-DVec3::dot(n, mesh.centroid(f)))
}

/// How the distance to a face grows.
fn quadric_of(mesh: &Mesh, f: FaceId) -> DMat4 {
    outer4(plane_of(mesh, f), plane_of(mesh, f)) * (mesh.area(f) + 0.5)
}

/// How far to go; emitted code has a function of that name itself.
fn direction_(mesh: &Mesh, v: VertexId) -> DVec3 {
    direction(mesh.position(v))
}

/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect("a column of this type")[element as usize]
}

/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.note_value(column, element);
    mesh.values_mut(column).expect("a column of this type")[element as usize] = value;
}

/// Whether nothing stands twice in `all`.
fn all_differ<T: PartialEq>(all: &[T]) -> bool {
    (1..all.len()).all(|at| !all[..at].contains(&all[at]))
}

/// Whether `a` and `b`, neither with repetitions, hold the same.
fn same_elements<T: PartialEq>(a: &[T], b: &[T]) -> bool {
    a.len() == b.len() && a.iter().all(|x| b.contains(x))
}

/// The direction of a vector, or zero.
fn direction(v: DVec3) -> DVec3 {
    // The square of a small length is zero, that of a large one infinite.
    let largest = v.abs().max_element();
    match largest > 0.0 && largest.is_finite() {
        true => (v / largest).normalize_or_zero(),
        false => DVec3::ZERO,
    }
}

/// The direction of a vector, or zero.
fn direction2(v: DVec2) -> DVec2 {
    let largest = v.abs().max_element();
    let length = (v / largest).length();
    match largest > 0.0 && length.is_finite() {
        true => v / largest / length,
        false => DVec2::ZERO,
    }
}

/// The direction of a vector, or zero.
fn direction4(v: DVec4) -> DVec4 {
    let largest = v.abs().max_element();
    let length = (v / largest).length();
    match largest > 0.0 && length.is_finite() {
        true => v / largest / length,
        false => DVec4::ZERO,
    }
}

/// A column times a row.
fn outer3(column: DVec3, row: DVec3) -> DMat3 {
    DMat3::from_cols(column * row.x, column * row.y, column * row.z)
}

/// A column times a row.
fn outer4(column: DVec4, row: DVec4) -> DMat4 {
    DMat4::from_cols(column * row.x, column * row.y, column * row.z, column * row.w)
}

/// Solves for several right sides at once by elimination with partial pivoting (Golub and Van
/// Loan, Matrix Computations, 1996, section 3.4); not a number everywhere if the matrix is
/// singular.
fn eliminate<const N: usize, const M: usize>(mut a: [[f64; N]; N], mut b: [[f64; N]; M]) -> [[f64; N]; M] {
    let largest = a.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let least = N as f64 * f64::EPSILON * largest;
    for k in 0..N {
        let smaller = |&i: &usize, &j: &usize| a[k][i].abs().total_cmp(&a[k][j].abs());
        let pivot = (k..N).max_by(smaller).unwrap_or(k);
        if !(a[k][pivot].abs() > least && a[k][pivot].is_finite()) {
            return [[f64::NAN; N]; M];
        }
        a.iter_mut().for_each(|column| column.swap(k, pivot));
        b.iter_mut().for_each(|side| side.swap(k, pivot));
        for row in k + 1..N {
            let factor = a[k][row] / a[k][k];
            a.iter_mut().for_each(|column| column[row] -= factor * column[k]);
            b.iter_mut().for_each(|side| side[row] -= factor * side[k]);
        }
    }
    for side in &mut b {
        for row in (0..N).rev() {
            let known: f64 = (row + 1..N).map(|k| a[k][row] * side[k]).sum();
            side[row] = (side[row] - known) / a[row][row];
        }
    }
    b
}

fn inverse3(m: DMat3) -> DMat3 {
    DMat3::from_cols_array_2d(&eliminate(m.to_cols_array_2d(), DMat3::IDENTITY.to_cols_array_2d()))
}

/// What the matrix takes to a vector.
fn solve3(m: DMat3, to: DVec3) -> DVec3 {
    DVec3::from_array(eliminate(m.to_cols_array_2d(), [to.to_array()])[0])
}

/// What the matrix takes to a vector.
fn solve4(m: DMat4, to: DVec4) -> DVec4 {
    DVec4::from_array(eliminate(m.to_cols_array_2d(), [to.to_array()])[0])
}

/// The angle at the corner where a halfedge starts, in its face.
fn corner_angle(mesh: &Mesh, h: HalfedgeId) -> f64 {
    let place = |h| mesh.position(mesh.vertex(h));
    let ahead = place(mesh.next(h)) - place(h);
    let behind = place(mesh.prev(h)) - place(h);
    f64::atan2(ahead.cross(behind).length(), ahead.dot(behind))
}

/// The cotangent of the angle opposite to a halfedge in its triangle.
fn cotangent(mesh: &Mesh, h: HalfedgeId) -> f64 {
    let place = |h| mesh.position(mesh.vertex(h));
    let a = place(h) - place(mesh.prev(h));
    let b = place(mesh.next(h)) - place(mesh.prev(h));
    a.dot(b) / a.cross(b).length()
}

/// The angle between the normals on both sides of an edge, positive where it stands out; zero on
/// the boundary.
fn dihedral_angle(mesh: &Mesh, e: EdgeId) -> f64 {
    if mesh.is_boundary_edge(e) {
        return 0.0;
    }
    let h = mesh.edge_halfedge(e);
    let first = mesh.normal(mesh.face(h));
    let second = mesh.normal(mesh.face(mesh.twin(h)));
    let place = |h| mesh.position(mesh.vertex(h));
    let along = direction(place(mesh.next(h)) - place(h));
    f64::atan2(along.dot(first.cross(second)), first.dot(second))
}

/// The one with the least value, of several the first; what is not a number gives way.
fn least_of<T: Copy>(all: impl IntoIterator<Item = T>, value: impl Fn(T) -> f64) -> T {
    let valued = all.into_iter().map(|x| (x, value(x)));
    let better = |a: &(T, f64), b: &(T, f64)| b.1 < a.1 || (a.1.is_nan() && !b.1.is_nan());
    let best = valued.reduce(|a, b| if better(&a, &b) { b } else { a });
    best.expect("the least of nothing").0
}

/// The one with the greatest value, of several the first; what is not a number gives way.
fn greatest_of<T: Copy>(all: impl IntoIterator<Item = T>, value: impl Fn(T) -> f64) -> T {
    let valued = all.into_iter().map(|x| (x, value(x)));
    let better = |a: &(T, f64), b: &(T, f64)| b.1 > a.1 || (a.1.is_nan() && !b.1.is_nan());
    let best = valued.reduce(|a, b| if better(&a, &b) { b } else { a });
    best.expect("the greatest of nothing").0
}

/// The mesh as it will be: what is noted here counts, and of all else what the mesh says. An
/// operation looks at its result on it before anything is written.
struct Sheet<'m> {
    mesh: &'m Mesh,
    new: u32,
    next: HashMap<HalfedgeId, HalfedgeId>,
    twin: HashMap<HalfedgeId, HalfedgeId>,
    vertex: HashMap<HalfedgeId, VertexId>,
    face: HashMap<HalfedgeId, FaceId>,
    vertex_halfedge: HashMap<VertexId, HalfedgeId>,
    face_halfedge: HashMap<FaceId, HalfedgeId>,
    holes: HashMap<FaceId, bool>,
}

#[allow(dead_code)]
impl<'m> Sheet<'m> {
    fn new(mesh: &'m Mesh) -> Self {
        Self {
            mesh,
            new: u32::MAX,
            next: HashMap::new(),
            twin: HashMap::new(),
            vertex: HashMap::new(),
            face: HashMap::new(),
            vertex_halfedge: HashMap::new(),
            face_halfedge: HashMap::new(),
            holes: HashMap::new(),
        }
    }

    /// A number from the top of the range, where the mesh has none.
    fn number(&mut self) -> u32 {
        self.new -= 1;
        self.new
    }

    fn add_vertex(&mut self) -> VertexId {
        VertexId(self.number())
    }

    fn add_halfedge(&mut self) -> HalfedgeId {
        HalfedgeId(self.number())
    }

    /// A new face is no hole.
    fn add_face(&mut self) -> FaceId {
        let face = FaceId(self.number());
        self.set_hole(face, false);
        face
    }

    fn set_next(&mut self, h: HalfedgeId, to: HalfedgeId) {
        self.next.insert(h, to);
    }

    fn set_twin(&mut self, h: HalfedgeId, to: HalfedgeId) {
        self.twin.insert(h, to);
    }

    fn set_vertex(&mut self, h: HalfedgeId, to: VertexId) {
        self.vertex.insert(h, to);
    }

    fn set_face(&mut self, h: HalfedgeId, to: FaceId) {
        self.face.insert(h, to);
    }

    fn set_vertex_halfedge(&mut self, v: VertexId, to: HalfedgeId) {
        self.vertex_halfedge.insert(v, to);
    }

    fn set_face_halfedge(&mut self, f: FaceId, to: HalfedgeId) {
        self.face_halfedge.insert(f, to);
    }

    fn set_hole(&mut self, f: FaceId, hole: bool) {
        self.holes.insert(f, hole);
    }

    fn next(&self, h: HalfedgeId) -> HalfedgeId {
        self.next.get(&h).copied().unwrap_or_else(|| self.mesh.next(h))
    }

    fn twin(&self, h: HalfedgeId) -> HalfedgeId {
        self.twin.get(&h).copied().unwrap_or_else(|| self.mesh.twin(h))
    }

    fn vertex(&self, h: HalfedgeId) -> VertexId {
        self.vertex.get(&h).copied().unwrap_or_else(|| self.mesh.vertex(h))
    }

    fn face(&self, h: HalfedgeId) -> FaceId {
        self.face.get(&h).copied().unwrap_or_else(|| self.mesh.face(h))
    }

    fn is_hole(&self, f: FaceId) -> bool {
        self.holes.get(&f).copied().unwrap_or_else(|| self.mesh.is_hole(f))
    }

    /// The halfedges that start at a vertex.
    fn star(&self, v: VertexId) -> Vec<HalfedgeId> {
        let first = self.vertex_halfedge.get(&v).copied();
        let first = first.unwrap_or_else(|| self.mesh.vertex_halfedge(v));
        let mut around = Vec::new();
        let mut h = first;
        while !h.is_none() {
            around.push(h);
            h = self.next(self.twin(h));
            if h == first {
                break;
            }
        }
        around
    }

    /// The corners of a face.
    fn corners(&self, f: FaceId) -> Vec<VertexId> {
        let first = self.face_halfedge.get(&f).copied();
        let first = first.unwrap_or_else(|| self.mesh.face_halfedge(f));
        let mut around = vec![self.vertex(first)];
        let mut h = self.next(first);
        while h != first {
            around.push(self.vertex(h));
            h = self.next(h);
        }
        around
    }

    /// The corners of a face, in an order that tells whether two have the same.
    fn sorted_corners(&self, f: FaceId) -> Vec<VertexId> {
        let mut corners = self.corners(f);
        corners.sort_unstable();
        corners
    }

    fn differ<T: PartialEq>(all: &[T]) -> bool {
        (1..all.len()).all(|at| !all[..at].contains(&all[at]))
    }

    /// Whether a face or hole has three sides or more.
    fn three_sides(&self, f: FaceId) -> bool {
        self.corners(f).len() > 2
    }

    /// Whether no vertex is two corners of a face.
    fn meets_once(&self, f: FaceId) -> bool {
        Self::differ(&self.corners(f))
    }

    /// Whether a face has no more than one corner at a vertex.
    fn corner_once(&self, f: FaceId, v: VertexId) -> bool {
        self.star(v).into_iter().filter(|&h| self.face(h) == f).count() <= 1
    }

    /// Whether a vertex has two edges or more, or none.
    fn two_spokes(&self, v: VertexId) -> bool {
        self.star(v).len() != 1
    }

    /// Whether no more than one corner of a vertex lies in a hole.
    fn one_hole(&self, v: VertexId) -> bool {
        self.star(v).into_iter().filter(|&h| self.is_hole(self.face(h))).count() <= 1
    }

    /// Whether no face has two corners at a vertex.
    fn faces_differ(&self, v: VertexId) -> bool {
        let faces: Vec<_> = self.star(v).into_iter().map(|h| self.face(h)).collect();
        Self::differ(&faces)
    }

    fn target(&self, h: HalfedgeId) -> VertexId {
        self.vertex(self.twin(h))
    }

    /// Whether no two edges lead from a vertex to one neighbor.
    fn neighbors_differ(&self, v: VertexId) -> bool {
        let neighbors: Vec<_> = self.star(v).into_iter().map(|h| self.target(h)).collect();
        Self::differ(&neighbors)
    }

    /// Whether no other edge joins the ends of a halfedge.
    fn single_edge(&self, h: HalfedgeId) -> bool {
        let (star, end) = (self.star(self.vertex(h)), self.target(h));
        star.into_iter().filter(|&h| self.target(h) == end).count() <= 1
    }

    /// Whether no two faces around a vertex have the same corners.
    fn corners_differ(&self, v: VertexId) -> bool {
        let faces = self.star(v).into_iter().map(|h| self.face(h));
        let faces = faces.filter(|&f| !self.is_hole(f));
        Self::differ(&faces.map(|f| self.sorted_corners(f)).collect::<Vec<_>>())
    }

    /// Whether no other face around a vertex has the corners of a face.
    fn corners_own(&self, f: FaceId, v: VertexId) -> bool {
        let others = self.star(v).into_iter().map(|h| self.face(h));
        let mut others = others.filter(|&other| other != f && !self.is_hole(other));
        self.is_hole(f) || others.all(|other| self.sorted_corners(other) != self.sorted_corners(f))
    }
}
}

mod polygon_in_steps {
use glam::DVec3;
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Level, Mesh, VertexId, validate_level_near};

/// Shrinks a face to one vertex at its centroid, which is returned.
///
/// ```text
///      \          /            \        /
///       v3------v2               \    /
///       |   f    |       ->         v
///       v0------v1               /    \ .
///      /          \            /        \ .
/// ```
///
/// A triangle at a side of the face would be left with two sides: it vanishes, as in
/// `collapse`, and so does a hole. Refused if no face would be left, as of a tetrahedron.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn polygon_collapse_face(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    if mesh.is_hole(f) {
        return None; // the face is a hole
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let center = mesh.centroid(f);
        let mut v = mesh.vertex(mesh.face_halfedge(f));
        let mut left = (mesh.face_size(f) as i64) - 1;
        // The last side begins and ends at the vertex then.
        for e in mesh.face_halfedges(f).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(e) {
                continue;
            }
            if 0 < left {
                v = contract(mesh, e)?;
                left = left - 1;
            }
        }
        if !drop_monogon(mesh, f) {
            return None;
        }
        for h in mesh.spokes(v).collect::<Vec<_>>() {
            if !mesh.halfedge_alive(h) {
                continue;
            }
            if (mesh.face_size(mesh.face(h)) as i64) == 2 {
                let f_2 = mesh.face(h);
                if !zip(mesh, f_2) {
                    return None; // no face would be left
                }
            }
        }
        mesh.set_position(v, finite(center)?);
        Some(v)
    })
}

/// Removes a vertex, and merges the faces around it into one, which is returned.
///
/// ```text
///     .-----.-----.           .-----.-----.
///     |     |     |           |           |
///     |     |     |           |           |
///     .-----v-----.     ->    .     f     .
///     |     |     |           |           |
///     |     |     |           |           |
///     '-----'-----'           '-----'-----'
/// ```
///
/// On the boundary the two edges along the hole become one. Refused if a neighbor would keep a
/// single edge, or the face or the hole fewer than three sides.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn polygon_dissolve_vertex(mesh: &mut Mesh, v: VertexId) -> Option<FaceId> {
    if (mesh.degree(v) as i64) <= 1 {
        return None; // the vertex has no faces to merge
    }
    if mesh.is_boundary_vertex(v) && (mesh.degree(v) as i64) <= 2 {
        return None; // the vertex has a single face
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let border = mesh.is_boundary_vertex(v);
        let mut f = mesh.face(mesh.vertex_halfedge(v));
        // Inside, the last of them is a spur, and the vertex goes with it.
        for e in mesh.spokes(v).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(e) || mesh.is_boundary_edge(e) {
                continue;
            }
            f = remove(mesh, e)?;
        }
        if border {
            straighten(mesh, v)?;
        }
        Some(f)
    })
}

/// Cuts a corner off: each edge of the vertex ends at a vertex of its own, and these make a
/// new face, which is returned.
///
/// ```text
///          |                     |
///          |                     u
///      ----v----       ->     --u u--
///          |                     u
///          |                     |
/// ```
///
/// The new vertices start where the old one is, and lie at the share `t` of the way along the
/// edges. A vertex of two edges is refused.
///
/// All or nothing: if a step refuses, what was done is undone.
/// By default `t = 0.0`.
pub fn polygon_bevel_vertex(mesh: &mut Mesh, v: VertexId, t: f64) -> Option<FaceId> {
    if (mesh.degree(v) as i64) <= 2 {
        return None; // the vertex has fewer than three edges
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        for s in mesh.spokes(v).collect::<Vec<_>>() {
            let far_ = mesh.position(mesh.target(s));
            let e = mesh.edge(s);
            let u = polygon_bisect(mesh, e)?;
            mesh.set_position(u, finite(DVec3::lerp(mesh.position(v), far_, t))?);
        }
        for s in mesh.spokes(v).collect::<Vec<_>>() {
            let a = mesh.next(s);
            let b = mesh.prev(s);
            cut(mesh, a, b)?;
        }
        let mut f = mesh.face(mesh.vertex_halfedge(v));
        for e in mesh.spokes(v).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(e) {
                continue;
            }
            f = remove(mesh, e)?;
        }
        Some(f)
    })
}

/// Cuts an edge off: each other edge at its ends ends at a vertex of its own, and these make a
/// new face in the place of the edge, which is returned.
///
/// ```text
///     \        /             \          /
///      \      /               u--------u
///       a--e-b        ->      |    f   |
///      /      \               u--------u
///     /        \             /          \ .
/// ```
///
/// The new vertices start where the ends of the edge are, and lie at the share `t` of the way
/// along their edges. Refused at the boundary, and if the face would have two sides.
///
/// All or nothing: if a step refuses, what was done is undone.
/// By default `t = 0.0`.
pub fn polygon_bevel_edge(mesh: &mut Mesh, e: EdgeId, t: f64) -> Option<FaceId> {
    if mesh.is_boundary_edge(e) {
        return None; // the edge lies on the boundary
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let h = mesh.edge_halfedge(e);
        let a = mesh.vertex(h);
        let b = mesh.target(h);
        for s in mesh.spokes(a).collect::<Vec<_>>() {
            if mesh.edge(s) == e {
                continue;
            }
            let far_ = mesh.position(mesh.target(s));
            let e_2 = mesh.edge(s);
            let u = polygon_bisect(mesh, e_2)?;
            mesh.set_position(u, finite(DVec3::lerp(mesh.position(a), far_, t))?);
        }
        for s in mesh.spokes(b).collect::<Vec<_>>() {
            if mesh.edge(s) == e {
                continue;
            }
            let far_ = mesh.position(mesh.target(s));
            let e_2 = mesh.edge(s);
            let u = polygon_bisect(mesh, e_2)?;
            mesh.set_position(u, finite(DVec3::lerp(mesh.position(b), far_, t))?);
        }
        // Cut the corners around both ends, and along the two sides of the edge.
        for s in mesh.spokes(a).collect::<Vec<_>>() {
            if mesh.edge(s) == e || mesh.edge(mesh.prev(s)) == e {
                continue;
            }
            let a_2 = mesh.next(s);
            let b_2 = mesh.prev(s);
            cut(mesh, a_2, b_2)?;
        }
        for s in mesh.spokes(b).collect::<Vec<_>>() {
            if mesh.edge(s) == e || mesh.edge(mesh.prev(s)) == e {
                continue;
            }
            let a_2 = mesh.next(s);
            let b_2 = mesh.prev(s);
            cut(mesh, a_2, b_2)?;
        }
        let a_2 = mesh.next(mesh.next(h));
        let b_2 = mesh.prev(h);
        cut(mesh, a_2, b_2)?;
        let a_2 = mesh.next(mesh.next(mesh.twin(h)));
        let b_2 = mesh.prev(mesh.twin(h));
        cut(mesh, a_2, b_2)?;
        let mut f = mesh.face(h);
        for s in mesh.spokes(a).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(s) {
                continue;
            }
            f = remove(mesh, s)?;
        }
        for s in mesh.spokes(b).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(s) {
                continue;
            }
            f = remove(mesh, s)?;
        }
        Some(f)
    })
}

/// Makes a face a hole, and returns it.
///
/// Where the face lies at the boundary, the hole there joins it: the edges between the two go,
/// and the vertices that have no other. Refused if two holes would meet at a vertex, and if the
/// face has no other beside it: nothing would be left.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn polygon_open_face(mesh: &mut Mesh, f: FaceId) -> Option<FaceId> {
    if mesh.is_hole(f) {
        return None; // the face is a hole already
    }
    if mesh.face_halfedges(f).map(|h| mesh.edge(h)).all(|e| mesh.is_boundary_edge(e)) {
        return None; // no face would be left beside the hole
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        open(mesh, f)?;
        for h in mesh.face_halfedges(f).collect::<Vec<_>>() {
            if !mesh.halfedge_alive(h) || !mesh.is_boundary_halfedge(mesh.twin(h)) {
                continue;
            }
            let a = if mesh.face(h) != f && mesh.face(mesh.twin(h)) == f { mesh.twin(h) } else { h };
            if clear(mesh, a).is_none() {
                let e_2 = mesh.edge(h);
                if !vanish(mesh, e_2) {
                    return None;
                }
            }
        }
        Some(f)
    })
}

/// Shrinks an edge until its ends are one vertex at its midpoint, which is returned.
///
/// ```text
///      .--P--.                 .--P--.
///      |     |                  \   /
///      v0-e-v1        ->          v0
///      |     |                  /   \ .
///      '--Q--'                 '--Q--'
/// ```
#[allow(non_snake_case)]
fn contract(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 3. Reassign every pointer that changes.
        let mut h = mesh.next(a);
        while h != d {
            mesh.set_vertex(h, v0);
            h = mesh.next(mesh.twin(h));
        }
        mesh.set_next(P_last, P_first);
        mesh.set_prev(P_first, P_last);
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v0, P_first);
        mesh.set_face_halfedge(f0, P_first);
        mesh.set_face_halfedge(f1, Q_first);
        mesh.set_position(v0, v0_position);

        // 4. Erase what is gone.
        mesh.erase_vertex(v1);
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        return Some(v0);
    }
    None
}

/// Makes the two sides of a face, or of a hole, one edge, so that the loop is gone.
///
/// ```text
///        .-b-.
///      v0  f  v1      ->     v0--a--v1
///        '-a-'
/// ```
fn zip(mesh: &mut Mesh, f: FaceId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge of f is tried.
    for a in mesh.face_halfedges(f).collect::<Vec<_>>() {
        let b = mesh.next(a);
        let a_ = mesh.twin(a);
        let b_ = mesh.twin(b);
        let v0 = mesh.vertex(b_);
        let v1 = mesh.vertex(a_);
        let ea = mesh.edge(a);
        let eb = mesh.edge(b);
        if mesh.next(b) != a {
            continue; // `f` does not have 2 corners
        }
        if mesh.face(a) != f {
            continue; // `a` does not lie in `f`
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if a == b_ {
            continue; // `a` and `b'` are one halfedge
        }

        // 3. Reassign every pointer that changes.
        mesh.set_twin(a_, b_);
        mesh.set_twin(b_, a_);
        mesh.set_edge(b_, ea);
        mesh.set_vertex_halfedge(v0, b_);
        mesh.set_vertex_halfedge(v1, a_);
        mesh.set_edge_halfedge(ea, a_);

        // 4. Erase what is gone.
        mesh.erase_face(f);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(b);
        mesh.erase_edge(eb);
        return true;
    }
    false
}

/// Removes a face with a single side, an edge that ends where it begins.
#[allow(non_snake_case)]
fn drop_monogon(mesh: &mut Mesh, f: FaceId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    let a = mesh.face_halfedge(f);
    let d = mesh.twin(a);
    let v = mesh.vertex(d);
    let g = mesh.face(d);
    let e = mesh.edge(a);
    let P_first = mesh.next(d);
    let P_last = mesh.prev(d);
    let P_is_empty = P_first == d;
    if mesh.is_hole(f) {
        return false; // `f` is a hole
    }
    if mesh.next(a) != a {
        return false; // `f` does not have 1 corners
    }
    if mesh.face(a) != f {
        return false; // `a` does not lie in `f`
    }
    if P_is_empty {
        return false; // `g` would be left without halfedges
    }

    // 3. Reassign every pointer that changes.
    mesh.set_next(P_last, P_first);
    mesh.set_prev(P_first, P_last);
    mesh.set_vertex_halfedge(v, P_first);
    mesh.set_face_halfedge(g, P_first);

    // 4. Erase what is gone.
    mesh.erase_face(f);
    mesh.erase_halfedge(a);
    mesh.erase_halfedge(d);
    mesh.erase_edge(e);
    true
}

/// Removes an edge and nothing else, whatever lies on its two sides; returns the loop that is
/// left there.
fn remove(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
    #[allow(non_snake_case)]
    fn rule_between_faces(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_beside_a_hole(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if !mesh.is_hole(f0) {
                continue; // `f0` is not a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_spur(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.next(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(a);
            let Q_is_empty = Q_first == a;
            if mesh.twin(a) != d {
                continue; // `a.twin` is not `d`
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if Q_is_empty {
                continue; // `f0` would be left without halfedges
            }

            // 3. Reassign every pointer that changes.
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_face_halfedge(f0, Q_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_vertex(v1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_bridge(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(d);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(a);
            let P_is_empty = P_first == d;
            let Q_is_empty = Q_first == a;
            if !mesh.is_hole(f0) {
                continue; // `f0` is not a hole
            }
            if mesh.face(d) != f0 {
                continue; // `d` does not lie in `f0`
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if P_is_empty {
                continue; // `f0` would be left without halfedges
            }
            if Q_is_empty {
                continue; // `g` would be left without halfedges
            }

            // 2. Allocate what is new.
            let g = mesh.add_face();

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != a {
                mesh.set_face(h, g);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, P_first);
            mesh.set_prev(P_first, P_last);
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);
            mesh.set_face_halfedge(g, Q_first);
            mesh.set_hole(g, true);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            return Some(f0);
        }
        None
    }

    rule_between_faces(mesh, e).or_else(|| rule_beside_a_hole(mesh, e)).or_else(|| rule_spur(mesh, e)).or_else(|| rule_bridge(mesh, e))
}

/// Removes a vertex with two edges, which become one; returns it.
///
/// ```text
///     u--a--v--b--w     ->     u----a----w
/// ```
#[allow(non_snake_case)]
fn straighten(mesh: &mut Mesh, v: VertexId) -> Option<EdgeId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge that starts at v is tried.
    for b in mesh.spokes(v).collect::<Vec<_>>() {
        let a = mesh.prev(b);
        let d = mesh.twin(a);
        let c = mesh.twin(b);
        let f = mesh.face(a);
        let u = mesh.vertex(a);
        let w = mesh.vertex(c);
        let g = mesh.face(c);
        let e = mesh.edge(a);
        let e2 = mesh.edge(b);
        let P_first = mesh.next(b);
        let Q_last = mesh.prev(c);
        if mesh.next(c) != d {
            continue; // `c.next` is not `d`
        }
        if mesh.vertex(b) != v {
            continue; // `b` does not start at `v`
        }
        if u == v {
            continue; // `u` and `v` are one vertex
        }
        if u == w {
            continue; // `u` and `w` are one vertex
        }
        if v == w {
            continue; // `v` and `w` are one vertex
        }
        if f == g {
            continue; // `f` and `g` are one face
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(P_first, a);
        mesh.set_prev(d, Q_last);
        mesh.set_vertex(d, w);
        mesh.set_next(Q_last, d);
        mesh.set_vertex_halfedge(w, d);
        mesh.set_face_halfedge(f, a);
        mesh.set_face_halfedge(g, d);

        // 4. Erase what is gone.
        mesh.erase_vertex(v);
        mesh.erase_halfedge(b);
        mesh.erase_halfedge(c);
        mesh.erase_edge(e2);
        return Some(e);
    }
    None
}

/// Cuts an edge in two at its midpoint; returns the new vertex.
///
/// ```text
///      .---P---.               .---P---.
///      |  f0   |               |  f0   |
///      |       |               |       |
///      v0--e--v1     ->        v0--m--v1
///      |       |               |       |
///      |  f1   |               |  f1   |
///      '---Q---'               '---Q---'
/// ```
///
/// The loops at the edge, faces or holes, get a side more. Each of the two halfedges is
/// followed by a new one, and the twin of the old one is now the new one across. Never
/// refused.
#[allow(non_snake_case)]
fn polygon_bisect(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let Q_first = mesh.next(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 2. Allocate what is new.
        let m = mesh.add_vertex();
        let p = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let e1 = mesh.add_edge();

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, p);
        mesh.set_twin(a, q);
        mesh.set_prev(P_first, p);
        mesh.set_next(d, q);
        mesh.set_twin(d, p);
        mesh.set_edge(d, e1);
        mesh.set_prev(Q_first, q);
        mesh.set_next(p, P_first);
        mesh.set_prev(p, a);
        mesh.set_twin(p, d);
        mesh.set_vertex(p, m);
        mesh.set_edge(p, e1);
        mesh.set_face(p, f0);
        mesh.set_next(q, Q_first);
        mesh.set_prev(q, d);
        mesh.set_twin(q, a);
        mesh.set_vertex(q, m);
        mesh.set_edge(q, e);
        mesh.set_face(q, f1);
        mesh.set_vertex_halfedge(m, p);
        mesh.set_edge_halfedge(e, a);
        mesh.set_edge_halfedge(e1, p);
        mesh.set_position(m, m_position);
        return Some(m);
    }
    None
}

/// Cuts a loop in two, from the corner where `a` starts to the corner where `b` starts; returns
/// the new edge. Of a hole, the part from `b` on becomes a face.
fn cut(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    #[allow(non_snake_case)]
    fn rule_face_in_two(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        let f = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        let v2 = mesh.vertex(b);
        let v3 = mesh.vertex(mesh.next(b));
        let P_last = mesh.prev(b);
        let Q_first = mesh.next(b);
        let Q_last = mesh.prev(a);
        if mesh.is_hole(f) {
            return None; // `f` is a hole
        }
        if mesh.face(b) != f {
            return None; // `b` does not lie in `f`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            return None; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            return None; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            return None; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            return None; // `v1` and `v3` are one vertex
        }
        if v2 == v3 {
            return None; // `v2` and `v3` are one vertex
        }

        // 2. Allocate what is new.
        let e = mesh.add_edge();
        let x = mesh.add_halfedge();
        let y = mesh.add_halfedge();
        let g = mesh.add_face();

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != a {
            mesh.set_face(h, g);
            h = mesh.next(h);
        }
        mesh.set_prev(a, x);
        mesh.set_next(P_last, x);
        mesh.set_prev(b, y);
        mesh.set_face(b, g);
        mesh.set_next(Q_last, y);
        mesh.set_next(x, a);
        mesh.set_prev(x, P_last);
        mesh.set_twin(x, y);
        mesh.set_vertex(x, v2);
        mesh.set_edge(x, e);
        mesh.set_face(x, f);
        mesh.set_next(y, b);
        mesh.set_prev(y, Q_last);
        mesh.set_twin(y, x);
        mesh.set_vertex(y, v0);
        mesh.set_edge(y, e);
        mesh.set_face(y, g);
        mesh.set_edge_halfedge(e, x);
        mesh.set_face_halfedge(f, a);
        mesh.set_face_halfedge(g, y);
        Some(e)
    }

    #[allow(non_snake_case)]
    fn rule_face_off_a_hole(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        let f = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        let v2 = mesh.vertex(b);
        let v3 = mesh.vertex(mesh.next(b));
        let P_last = mesh.prev(b);
        let Q_first = mesh.next(b);
        let Q_last = mesh.prev(a);
        if !mesh.is_hole(f) {
            return None; // `f` is not a hole
        }
        if mesh.face(b) != f {
            return None; // `b` does not lie in `f`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            return None; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            return None; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            return None; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            return None; // `v1` and `v3` are one vertex
        }
        if v2 == v3 {
            return None; // `v2` and `v3` are one vertex
        }

        // 2. Allocate what is new.
        let e = mesh.add_edge();
        let x = mesh.add_halfedge();
        let y = mesh.add_halfedge();
        let g = mesh.add_face();

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != a {
            mesh.set_face(h, g);
            h = mesh.next(h);
        }
        mesh.set_prev(a, x);
        mesh.set_next(P_last, x);
        mesh.set_prev(b, y);
        mesh.set_face(b, g);
        mesh.set_next(Q_last, y);
        mesh.set_next(x, a);
        mesh.set_prev(x, P_last);
        mesh.set_twin(x, y);
        mesh.set_vertex(x, v2);
        mesh.set_edge(x, e);
        mesh.set_face(x, f);
        mesh.set_next(y, b);
        mesh.set_prev(y, Q_last);
        mesh.set_twin(y, x);
        mesh.set_vertex(y, v0);
        mesh.set_edge(y, e);
        mesh.set_face(y, g);
        mesh.set_edge_halfedge(e, x);
        mesh.set_face_halfedge(f, a);
        mesh.set_face_halfedge(g, y);
        Some(e)
    }

    rule_face_in_two(mesh, a, b).or_else(|| rule_face_off_a_hole(mesh, a, b))
}

/// Removes the edge of a halfedge that lies in a hole, and nothing else; that hole is left there.
fn clear(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
    #[allow(non_snake_case)]
    fn rule_beside_another(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let e = mesh.edge(a);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(d);
        if !mesh.is_hole(f0) {
            return None; // `f0` is not a hole
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            return None; // `f0` and `f1` are one face
        }

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != d {
            mesh.set_face(h, f0);
            h = mesh.next(h);
        }
        mesh.set_next(P_last, Q_first);
        mesh.set_prev(P_first, Q_last);
        mesh.set_next(Q_last, P_first);
        mesh.set_prev(Q_first, P_last);
        mesh.set_vertex_halfedge(v0, Q_first);
        mesh.set_vertex_halfedge(v1, P_first);
        mesh.set_face_halfedge(f0, P_first);

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_face(f1);
        Some(f0)
    }

    #[allow(non_snake_case)]
    fn rule_spur_ahead(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        let d = mesh.next(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let e = mesh.edge(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(a);
        let Q_is_empty = Q_first == a;
        if !mesh.is_hole(f0) {
            return None; // `f0` is not a hole
        }
        if mesh.twin(a) != d {
            return None; // `a.twin` is not `d`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if Q_is_empty {
            return None; // `f0` would be left without halfedges
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v0, Q_first);
        mesh.set_face_halfedge(f0, Q_first);

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_vertex(v1);
        Some(f0)
    }

    #[allow(non_snake_case)]
    fn rule_spur_behind(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        let d = mesh.prev(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let e = mesh.edge(a);
        let Q_first = mesh.next(a);
        let Q_last = mesh.prev(d);
        let Q_is_empty = Q_first == d;
        if !mesh.is_hole(f0) {
            return None; // `f0` is not a hole
        }
        if mesh.twin(a) != d {
            return None; // `a.twin` is not `d`
        }
        if mesh.face(d) != f0 {
            return None; // `d` does not lie in `f0`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if Q_is_empty {
            return None; // `f0` would be left without halfedges
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v1, Q_first);
        mesh.set_face_halfedge(f0, Q_first);

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_vertex(v0);
        Some(f0)
    }

    #[allow(non_snake_case)]
    fn rule_bridge(mesh: &mut Mesh, a: HalfedgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let e = mesh.edge(a);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(d);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(a);
        let P_is_empty = P_first == d;
        let Q_is_empty = Q_first == a;
        if !mesh.is_hole(f0) {
            return None; // `f0` is not a hole
        }
        if mesh.face(d) != f0 {
            return None; // `d` does not lie in `f0`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if Q_is_empty {
            return None; // `f0` would be left without halfedges
        }
        if P_is_empty {
            return None; // `g` would be left without halfedges
        }

        // 2. Allocate what is new.
        let g = mesh.add_face();

        // 3. Reassign every pointer that changes.
        let mut h = P_first;
        while h != d {
            mesh.set_face(h, g);
            h = mesh.next(h);
        }
        mesh.set_next(P_last, P_first);
        mesh.set_prev(P_first, P_last);
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v0, Q_first);
        mesh.set_vertex_halfedge(v1, P_first);
        mesh.set_face_halfedge(f0, Q_first);
        mesh.set_face_halfedge(g, P_first);
        mesh.set_hole(g, true);

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        Some(f0)
    }

    rule_beside_another(mesh, a).or_else(|| rule_spur_ahead(mesh, a)).or_else(|| rule_spur_behind(mesh, a)).or_else(|| rule_bridge(mesh, a))
}

/// Removes an edge that is all there is of a piece of the mesh.
fn vanish(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.next(a);
        let f = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        if mesh.next(d) != a {
            continue; // `f` does not have 2 corners
        }
        if mesh.twin(a) != d {
            continue; // `a.twin` is not `d`
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }

        // 4. Erase what is gone.
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        mesh.erase_vertex(v0);
        mesh.erase_vertex(v1);
        mesh.erase_face(f);
        return true;
    }
    false
}

/// Makes a face a hole.
fn open(mesh: &mut Mesh, f: FaceId) -> Option<FaceId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Each halfedge of f is tried.
    for a in mesh.face_halfedges(f).collect::<Vec<_>>() {
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        if mesh.is_hole(f) {
            continue; // `f` is a hole
        }
        if mesh.face(a) != f {
            continue; // `a` does not lie in `f`
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }

        // 3. Reassign every pointer that changes.
        mesh.set_hole(f, true);
        return Some(f);
    }
    None
}

/// Does the steps; if one refuses, or the mesh is not of the level in the end, undoes them.
fn all_or_nothing<T>(
    mesh: &mut Mesh,
    level: Level,
    steps: impl FnOnce(&mut Mesh) -> Option<T>,
) -> Option<T> {
    let mark = mesh.open_journal();
    let done = steps(mesh)
        .filter(|_| validate_level_near(mesh, level, &mesh.written_since(&mark)).is_ok());
    match done {
        Some(_) => mesh.keep(mark),
        None => mesh.roll_back(mark),
    }
    done
}

/// A position, if it is finite.
fn finite(position: DVec3) -> Option<DVec3> {
    position.is_finite().then_some(position)
}
}

mod steps_in_steps {
use glam::DVec3;
use hedgerow::mesh::{Attribute, ColumnId, EdgeId, ElementKind, FaceId, HalfedgeId, Level, Mesh, VertexId, validate_level_near};

/// Bisects an edge several times, always beside the last new vertex.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_divide(mesh: &mut Mesh, e: EdgeId, n: i64) -> Option<VertexId> {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    if 12 <= n {
        return None; // that is too often
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let mut m = bisect(mesh, e)?;
        for _ in 0..twos(mesh, n) + 1 {
            let weight = attribute::<f64>(mesh, weight_column, m.0) + 1.0;
            set_attribute(mesh, weight_column, m.0, weight);
            let e_2 = mesh.edge(mesh.vertex_halfedge(m));
            m = bisect(mesh, e_2)?;
        }
        Some(m)
    })
}

/// Bisects two sides of a face, and joins the new vertices.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_halve(mesh: &mut Mesh, h: HalfedgeId, t: f64) -> Option<EdgeId> {
    let tint_column = mesh.find_column(ElementKind::Vertex, "tint");
    let Some(tint_column) = tint_column.filter(|&c| mesh.values::<DVec3>(c).is_some()) else {
        return None; // the mesh has no attribute `tint` of this type
    };
    let fresh_column = mesh.find_column(ElementKind::Edge, "fresh");
    let Some(fresh_column) = fresh_column.filter(|&c| mesh.values::<bool>(c).is_some()) else {
        return None; // the mesh has no attribute `fresh` of this type
    };
    if mesh.find_column(ElementKind::Vertex, "weight").and_then(|c| mesh.values::<f64>(c)).is_none() {
        return None; // the mesh has no attribute `weight` of this type
    }
    if mesh.find_column(ElementKind::Halfedge, "mark").and_then(|c| mesh.values::<f64>(c)).is_none() {
        return None; // the mesh has no attribute `mark` of this type
    }
    if mesh.is_boundary_halfedge(h) {
        return None; // there is no face
    }
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let e = mesh.edge(h);
        let m = bisect(mesh, e)?;
        // nothing is finite for 0
        mesh.set_position(m, finite(mesh.position(m) / t)?);
        load(mesh, m, t);
        let k = mesh.next(mesh.next(mesh.next(h)));
        let e = mesh.edge(k);
        let n = steps_bisect_heavy(mesh, e)?;
        let tint = DVec3::lerp(attribute::<DVec3>(mesh, tint_column, m.0), DVec3::new(1.0, 2.0, t), 0.5);
        set_attribute(mesh, tint_column, n.0, tint);
        if mesh.face(k) != mesh.face(h) || !(t < 6.0) {
            return None; // the sides lie apart
        }
        let a = mesh.next(h);
        let b = mesh.next(k);
        let e = cut(mesh, a, b)?;
        set_attribute(mesh, fresh_column, e.0, true);
        Some(e)
    })
}

/// Halves faces at a vertex, those that can be.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_halve_around(mesh: &mut Mesh, v: VertexId, t: f64) -> Option<VertexId> {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    let mark_column = mesh.find_column(ElementKind::Halfedge, "mark");
    let Some(mark_column) = mark_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `mark` of this type
    };
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let mut done: i64 = 0;
        for h in mesh.spokes(v).collect::<Vec<_>>() {
            if 2 < done {
                continue;
            }
            // Some of these are refused after several steps.
            if let Some(e) = steps_halve(mesh, h, t) {
                done = done + 1;
                let halfedge = mesh.edge_halfedge(e);
                set_attribute(mesh, mark_column, halfedge.0, 3.0);
            } else {
                let e = mesh.edge(h);
                if steps_divide(mesh, e, done + 7).is_some() {
                    set_attribute(mesh, weight_column, v.0, 0.0);
                } else {
                    break;
                }
            }
        }
        if done <= 0 {
            return None; // nothing was halved
        }
        Some(v)
    })
}

/// Triangulates a face.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_triangulate(mesh: &mut Mesh, f: FaceId, by: f64) -> bool {
    let class_column = mesh.find_column(ElementKind::Face, "class");
    let Some(class_column) = class_column.filter(|&c| mesh.values::<i64>(c).is_some()) else {
        return false; // the mesh has no attribute `class` of this type
    };
    if mesh.find_column(ElementKind::Vertex, "weight").and_then(|c| mesh.values::<f64>(c)).is_none() {
        return false; // the mesh has no attribute `weight` of this type
    }
    if mesh.find_column(ElementKind::Halfedge, "mark").and_then(|c| mesh.values::<f64>(c)).is_none() {
        return false; // the mesh has no attribute `mark` of this type
    }
    if mesh.find_column(ElementKind::Edge, "fresh").and_then(|c| mesh.values::<bool>(c)).is_none() {
        return false; // the mesh has no attribute `fresh` of this type
    }
    if mesh.is_hole(f) {
        return false; // it is a hole
    }
    all_or_nothing(mesh, Level::Simple, |mesh| {
        let first = mesh.vertex(mesh.face_halfedge(f));
        load(mesh, first, by);
        if 3.0 < by {
            let h = mesh.face_halfedge(f);
            slice(mesh, h)?;
        }
        let n = cut_ears(mesh, f);
        if n <= 0 {
            return None; // it is a triangle
        }
        let class_ = n + attribute::<i64>(mesh, class_column, f.0);
        set_attribute(mesh, class_column, f.0, class_);
        let mut g = f;
        if by < 1.0 {
            let h = mesh.face_halfedge(f);
            g = slice(mesh, h)?;
        } else if by < 2.0 {
            let e = mesh.edge(mesh.face_halfedge(g));
            contract(mesh, e)?;
            return Some(());
        }
        let class_ = attribute::<i64>(mesh, class_column, g.0) + 1;
        set_attribute(mesh, class_column, g.0, class_);
        Some(())
    }).is_some()
}

/// Contracts all edges of a vertex that can be contracted, as long as the mesh stays simple.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_draw_in(mesh: &mut Mesh, v: VertexId) -> bool {
    let fresh_column = mesh.find_column(ElementKind::Edge, "fresh");
    let Some(fresh_column) = fresh_column.filter(|&c| mesh.values::<bool>(c).is_some()) else {
        return false; // the mesh has no attribute `fresh` of this type
    };
    all_or_nothing(mesh, Level::Simple, |mesh| {
        let mut left: i64 = 2;
        for e in mesh.spokes(v).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
            if !mesh.edge_alive(e) || attribute::<bool>(mesh, fresh_column, e.0) {
                continue;
            }
            contract(mesh, e);
            left = left - 1;
            if left == 0 {
                break;
            }
        }
        Some(())
    }).is_some()
}

/// Removes what lies between the faces around an edge, from its ends; nothing is asked.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_clear(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
    all_or_nothing(mesh, Level::Map, |mesh| {
        let f = mesh.face(mesh.edge_halfedge(e));
        for v in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))].into_iter().map(|h| mesh.vertex(h)).collect::<Vec<_>>() {
            if !mesh.vertex_alive(v) {
                continue;
            }
            for s in mesh.spokes(v).map(|h| mesh.edge(h)).collect::<Vec<_>>() {
                if !mesh.edge_alive(s) || s == e || mesh.is_boundary_edge(s) {
                    continue;
                }
                for g in [mesh.edge_halfedge(s), mesh.twin(mesh.edge_halfedge(s))].into_iter().map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).collect::<Vec<_>>() {
                    if !mesh.face_alive(g) || g == f {
                        continue;
                    }
                    if 3 < (mesh.face_size(g) as i64) {
                        remove(mesh, s);
                        break;
                    }
                }
            }
        }
        Some(mesh.face(mesh.edge_halfedge(e)))
    })
}

/// Draws the corners of a face towards their neighbours, all at once.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_relax(mesh: &mut Mesh, f: FaceId, t: f64) -> bool {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return false; // the mesh has no attribute `weight` of this type
    };
    let tint_column = mesh.find_column(ElementKind::Vertex, "tint");
    let Some(tint_column) = tint_column.filter(|&c| mesh.values::<DVec3>(c).is_some()) else {
        return false; // the mesh has no attribute `tint` of this type
    };
    all_or_nothing(mesh, Level::Surface, |mesh| {
        let e = mesh.edge(mesh.face_halfedge(f));
        let m = bisect(mesh, e)?;
        let mut positions = Vec::new();
        let mut weights = Vec::new();
        let mut tints = Vec::new();
        for v in mesh.face_vertices(f).collect::<Vec<_>>() {
            if mesh.is_boundary_vertex(v) {
                continue;
            }
            let middle = { let all = mesh.neighbors(v).map(|w| mesh.position(w)).collect::<Vec<DVec3>>(); assert!(!all.is_empty(), "a value of nothing"); all.iter().copied().sum::<DVec3>() / all.len() as f64 };
            positions.push((v, DVec3::lerp(mesh.position(v), middle, t)));
            if 1.0 < attribute::<f64>(mesh, weight_column, v.0) {
                weights.push((v, attribute::<f64>(mesh, weight_column, v.0) / 2.0));
                tints.push((v, DVec3::new(1.0, 1.0, 1.0) * t));
            } else {
                weights.push((v, heaviest(mesh, v) + attribute::<f64>(mesh, weight_column, m.0)));
            }
        }
        for (element, value) in positions {
            mesh.set_position(element, finite(value)?);
        }
        for (element, value) in weights {
            set_attribute(mesh, weight_column, element.0, value);
        }
        for (element, value) in tints {
            set_attribute(mesh, tint_column, element.0, value);
        }
        if !(attribute::<f64>(mesh, weight_column, m.0) < 2.0) {
            return None; // it has become heavy
        }
        Some(())
    }).is_some()
}

/// Pokes a face, and the triangles that come of it.
///
/// All or nothing: if a step refuses, what was done is undone.
pub fn steps_stud(mesh: &mut Mesh, f: FaceId, t: f64) -> Option<VertexId> {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    all_or_nothing(mesh, Level::Simple, |mesh| {
        let c = steps_poke(mesh, f)?;
        set_attribute(mesh, weight_column, c.0, t);
        for g in mesh.spokes(c).map(|h| mesh.face(h)).filter(|&f| !mesh.is_hole(f)).collect::<Vec<_>>() {
            if !mesh.face_alive(g) {
                continue;
            }
            steps_poke(mesh, g)?;
        }
        if !(t < heaviest(mesh, c)) {
            return None; // all around is light
        }
        Some(c)
    })
}

/// How often 2 divides a number.
fn twos(_mesh: &Mesh, n: i64) -> i64 {
    let mut rest = n;
    let mut count: i64 = 0;
    while ((rest % 2 + 2) % 2) == 0 {
        if rest == 0 {
            break;
        }
        rest = rest / 2 - i64::from(rest % 2 != 0 && (rest < 0) != (2 < 0));
        count = count + 1;
    }
    count
}

/// Cuts an edge in two at its midpoint; returns the new vertex.
///
/// ```text
///      .---P---.               .---P---.
///      |  f0   |               |  f0   |
///      |       |               |       |
///      v0--e--v1     ->        v0--m--v1
///      |       |               |       |
///      |  f1   |               |  f1   |
///      '---Q---'               '---Q---'
/// ```
///
/// The loops at the edge, faces or holes, get a side more. Each of the two halfedges is
/// followed by a new one, and the twin of the old one is now the new one across. Never
/// refused.
#[allow(non_snake_case)]
fn bisect(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let Q_first = mesh.next(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 2. Allocate what is new.
        let m = mesh.add_vertex();
        let p = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let e1 = mesh.add_edge();

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, p);
        mesh.set_twin(a, q);
        mesh.set_prev(P_first, p);
        mesh.set_next(d, q);
        mesh.set_twin(d, p);
        mesh.set_edge(d, e1);
        mesh.set_prev(Q_first, q);
        mesh.set_next(p, P_first);
        mesh.set_prev(p, a);
        mesh.set_twin(p, d);
        mesh.set_vertex(p, m);
        mesh.set_edge(p, e1);
        mesh.set_face(p, f0);
        mesh.set_next(q, Q_first);
        mesh.set_prev(q, d);
        mesh.set_twin(q, a);
        mesh.set_vertex(q, m);
        mesh.set_edge(q, e);
        mesh.set_face(q, f1);
        mesh.set_vertex_halfedge(m, p);
        mesh.set_edge_halfedge(e, a);
        mesh.set_edge_halfedge(e1, p);
        mesh.set_position(m, m_position);
        return Some(m);
    }
    None
}

fn load(mesh: &mut Mesh, v: VertexId, by: f64) {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight").expect("whoever calls asks for it");
    let mark_column = mesh.find_column(ElementKind::Halfedge, "mark").expect("whoever calls asks for it");
    if mesh.is_boundary_vertex(v) && by < 0.0 {
        return;
    }
    let weight = attribute::<f64>(mesh, weight_column, v.0) + by;
    set_attribute(mesh, weight_column, v.0, weight);
    // All around it, too.
    for h in mesh.spokes(v).collect::<Vec<_>>() {
        if mesh.is_boundary_halfedge(h) {
            continue;
        }
        let mark = attribute::<f64>(mesh, mark_column, h.0) + by;
        set_attribute(mesh, mark_column, h.0, mark);
    }
}

/// The greatest weight around a vertex.
fn heaviest(mesh: &Mesh, v: VertexId) -> f64 {
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight").expect("whoever calls asks for it");
    let mut most: f64 = 0.0;
    for w in mesh.neighbors(v).collect::<Vec<_>>() {
        if attribute::<f64>(mesh, weight_column, w.0) <= most {
            continue;
        }
        most = attribute::<f64>(mesh, weight_column, w.0);
    }
    most
}

/// Bisects an edge at a vertex that is heavy enough.
#[allow(non_snake_case)]
fn steps_bisect_heavy(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let Q_first = mesh.next(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        if !(1.0 < heaviest(mesh, v0)) {
            continue; // nothing heavy is near
        }
        let m_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;
        let m_weight = heaviest(mesh, v1);

        // 2. Allocate what is new.
        let m = mesh.add_vertex();
        let p = mesh.add_halfedge();
        let q = mesh.add_halfedge();
        let e1 = mesh.add_edge();

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, p);
        mesh.set_twin(a, q);
        mesh.set_prev(P_first, p);
        mesh.set_next(d, q);
        mesh.set_twin(d, p);
        mesh.set_edge(d, e1);
        mesh.set_prev(Q_first, q);
        mesh.set_next(p, P_first);
        mesh.set_prev(p, a);
        mesh.set_twin(p, d);
        mesh.set_vertex(p, m);
        mesh.set_edge(p, e1);
        mesh.set_face(p, f0);
        mesh.set_next(q, Q_first);
        mesh.set_prev(q, d);
        mesh.set_twin(q, a);
        mesh.set_vertex(q, m);
        mesh.set_edge(q, e);
        mesh.set_face(q, f1);
        mesh.set_vertex_halfedge(m, p);
        mesh.set_edge_halfedge(e, a);
        mesh.set_edge_halfedge(e1, p);
        mesh.set_position(m, m_position);
        set_attribute(mesh, weight_column, m.0, m_weight);
        return Some(m);
    }
    None
}

/// Cuts a loop in two, from the corner where `a` starts to the corner where `b` starts; returns
/// the new edge. Of a hole, the part from `b` on becomes a face.
fn cut(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
    #[allow(non_snake_case)]
    fn rule_face_in_two(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        let f = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        let v2 = mesh.vertex(b);
        let v3 = mesh.vertex(mesh.next(b));
        let P_last = mesh.prev(b);
        let Q_first = mesh.next(b);
        let Q_last = mesh.prev(a);
        if mesh.is_hole(f) {
            return None; // `f` is a hole
        }
        if mesh.face(b) != f {
            return None; // `b` does not lie in `f`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            return None; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            return None; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            return None; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            return None; // `v1` and `v3` are one vertex
        }
        if v2 == v3 {
            return None; // `v2` and `v3` are one vertex
        }

        // 2. Allocate what is new.
        let e = mesh.add_edge();
        let x = mesh.add_halfedge();
        let y = mesh.add_halfedge();
        let g = mesh.add_face();

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != a {
            mesh.set_face(h, g);
            h = mesh.next(h);
        }
        mesh.set_prev(a, x);
        mesh.set_next(P_last, x);
        mesh.set_prev(b, y);
        mesh.set_face(b, g);
        mesh.set_next(Q_last, y);
        mesh.set_next(x, a);
        mesh.set_prev(x, P_last);
        mesh.set_twin(x, y);
        mesh.set_vertex(x, v2);
        mesh.set_edge(x, e);
        mesh.set_face(x, f);
        mesh.set_next(y, b);
        mesh.set_prev(y, Q_last);
        mesh.set_twin(y, x);
        mesh.set_vertex(y, v0);
        mesh.set_edge(y, e);
        mesh.set_face(y, g);
        mesh.set_edge_halfedge(e, x);
        mesh.set_face_halfedge(f, a);
        mesh.set_face_halfedge(g, y);
        Some(e)
    }

    #[allow(non_snake_case)]
    fn rule_face_off_a_hole(mesh: &mut Mesh, a: HalfedgeId, b: HalfedgeId) -> Option<EdgeId> {
        // 1. Collect: nothing is written before all of this has passed.
        let f = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(mesh.next(a));
        let v2 = mesh.vertex(b);
        let v3 = mesh.vertex(mesh.next(b));
        let P_last = mesh.prev(b);
        let Q_first = mesh.next(b);
        let Q_last = mesh.prev(a);
        if !mesh.is_hole(f) {
            return None; // `f` is not a hole
        }
        if mesh.face(b) != f {
            return None; // `b` does not lie in `f`
        }
        if v0 == v1 {
            return None; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            return None; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            return None; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            return None; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            return None; // `v1` and `v3` are one vertex
        }
        if v2 == v3 {
            return None; // `v2` and `v3` are one vertex
        }

        // 2. Allocate what is new.
        let e = mesh.add_edge();
        let x = mesh.add_halfedge();
        let y = mesh.add_halfedge();
        let g = mesh.add_face();

        // 3. Reassign every pointer that changes.
        let mut h = Q_first;
        while h != a {
            mesh.set_face(h, g);
            h = mesh.next(h);
        }
        mesh.set_prev(a, x);
        mesh.set_next(P_last, x);
        mesh.set_prev(b, y);
        mesh.set_face(b, g);
        mesh.set_next(Q_last, y);
        mesh.set_next(x, a);
        mesh.set_prev(x, P_last);
        mesh.set_twin(x, y);
        mesh.set_vertex(x, v2);
        mesh.set_edge(x, e);
        mesh.set_face(x, f);
        mesh.set_next(y, b);
        mesh.set_prev(y, Q_last);
        mesh.set_twin(y, x);
        mesh.set_vertex(y, v0);
        mesh.set_edge(y, e);
        mesh.set_face(y, g);
        mesh.set_edge_halfedge(e, x);
        mesh.set_face_halfedge(f, a);
        mesh.set_face_halfedge(g, y);
        Some(e)
    }

    rule_face_in_two(mesh, a, b).or_else(|| rule_face_off_a_hole(mesh, a, b))
}

/// Cuts triangles off a face until a triangle is left; how many.
fn cut_ears(mesh: &mut Mesh, f: FaceId) -> i64 {
    let fresh_column = mesh.find_column(ElementKind::Edge, "fresh").expect("whoever calls asks for it");
    let mut cuts: i64 = 0;
    let mut h = mesh.face_halfedge(f);
    while 3 < (mesh.face_size(mesh.face(h)) as i64) {
        let b = mesh.next(mesh.next(h));
        if let Some(e) = cut(mesh, h, b) {
            set_attribute(mesh, fresh_column, e.0, true);
            cuts = cuts + 1;
            h = mesh.twin(mesh.edge_halfedge(e));
        } else {
            break;
        }
    }
    cuts
}

/// Cuts a face, which must be done, and gives the part cut off.
fn slice(mesh: &mut Mesh, h: HalfedgeId) -> Option<FaceId> {
    let class_column = mesh.find_column(ElementKind::Face, "class").expect("whoever calls asks for it");
    let b = mesh.next(mesh.next(h));
    let e = cut(mesh, h, b)?;
    let face = mesh.face(mesh.edge_halfedge(e));
    set_attribute(mesh, class_column, face.0, 7);
    Some(mesh.face(mesh.edge_halfedge(e)))
}

/// Shrinks an edge until its ends are one vertex at its midpoint, which is returned.
///
/// ```text
///      .--P--.                 .--P--.
///      |     |                  \   /
///      v0-e-v1        ->          v0
///      |     |                  /   \ .
///      '--Q--'                 '--Q--'
/// ```
#[allow(non_snake_case)]
fn contract(mesh: &mut Mesh, e: EdgeId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let d = mesh.twin(a);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let f1 = mesh.face(d);
        let P_first = mesh.next(a);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(d);
        let Q_last = mesh.prev(d);
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        let v0_position = (mesh.position(v0) + mesh.position(v1)) / 2.0;

        // 3. Reassign every pointer that changes.
        let mut h = mesh.next(a);
        while h != d {
            mesh.set_vertex(h, v0);
            h = mesh.next(mesh.twin(h));
        }
        mesh.set_next(P_last, P_first);
        mesh.set_prev(P_first, P_last);
        mesh.set_next(Q_last, Q_first);
        mesh.set_prev(Q_first, Q_last);
        mesh.set_vertex_halfedge(v0, P_first);
        mesh.set_face_halfedge(f0, P_first);
        mesh.set_face_halfedge(f1, Q_first);
        mesh.set_position(v0, v0_position);

        // 4. Erase what is gone.
        mesh.erase_vertex(v1);
        mesh.erase_edge(e);
        mesh.erase_halfedge(a);
        mesh.erase_halfedge(d);
        return Some(v0);
    }
    None
}

/// Removes an edge and nothing else, whatever lies on its two sides; returns the loop that is
/// left there.
fn remove(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
    #[allow(non_snake_case)]
    fn rule_between_faces(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if mesh.is_hole(f0) {
                continue; // `f0` is a hole
            }
            if mesh.is_hole(f1) {
                continue; // `f1` is a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_beside_a_hole(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let f1 = mesh.face(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(a);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(d);
            if !mesh.is_hole(f0) {
                continue; // `f0` is not a hole
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if f0 == f1 {
                continue; // `f0` and `f1` are one face
            }

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != d {
                mesh.set_face(h, f0);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, Q_first);
            mesh.set_prev(P_first, Q_last);
            mesh.set_next(Q_last, P_first);
            mesh.set_prev(Q_first, P_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_face(f1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_spur(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.next(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(a);
            let Q_is_empty = Q_first == a;
            if mesh.twin(a) != d {
                continue; // `a.twin` is not `d`
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if Q_is_empty {
                continue; // `f0` would be left without halfedges
            }

            // 3. Reassign every pointer that changes.
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_face_halfedge(f0, Q_first);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            mesh.erase_vertex(v1);
            return Some(f0);
        }
        None
    }

    #[allow(non_snake_case)]
    fn rule_bridge(mesh: &mut Mesh, e: EdgeId) -> Option<FaceId> {
        // 1. Collect: nothing is written before all of this has passed.
        // Both directions of e are tried.
        for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
            let d = mesh.twin(a);
            let f0 = mesh.face(a);
            let v0 = mesh.vertex(a);
            let v1 = mesh.vertex(d);
            let P_first = mesh.next(a);
            let P_last = mesh.prev(d);
            let Q_first = mesh.next(d);
            let Q_last = mesh.prev(a);
            let P_is_empty = P_first == d;
            let Q_is_empty = Q_first == a;
            if !mesh.is_hole(f0) {
                continue; // `f0` is not a hole
            }
            if mesh.face(d) != f0 {
                continue; // `d` does not lie in `f0`
            }
            if v0 == v1 {
                continue; // `v0` and `v1` are one vertex
            }
            if P_is_empty {
                continue; // `f0` would be left without halfedges
            }
            if Q_is_empty {
                continue; // `g` would be left without halfedges
            }

            // 2. Allocate what is new.
            let g = mesh.add_face();

            // 3. Reassign every pointer that changes.
            let mut h = Q_first;
            while h != a {
                mesh.set_face(h, g);
                h = mesh.next(h);
            }
            mesh.set_next(P_last, P_first);
            mesh.set_prev(P_first, P_last);
            mesh.set_next(Q_last, Q_first);
            mesh.set_prev(Q_first, Q_last);
            mesh.set_vertex_halfedge(v0, Q_first);
            mesh.set_vertex_halfedge(v1, P_first);
            mesh.set_face_halfedge(f0, P_first);
            mesh.set_face_halfedge(g, Q_first);
            mesh.set_hole(g, true);

            // 4. Erase what is gone.
            mesh.erase_edge(e);
            mesh.erase_halfedge(a);
            mesh.erase_halfedge(d);
            return Some(f0);
        }
        None
    }

    rule_between_faces(mesh, e).or_else(|| rule_beside_a_hole(mesh, e)).or_else(|| rule_spur(mesh, e)).or_else(|| rule_bridge(mesh, e))
}

/// Splits a face into triangles around a new vertex.
fn steps_poke(mesh: &mut Mesh, f: FaceId) -> Option<VertexId> {
    // 1. Collect: nothing is written before all of this has passed.
    let weight_column = mesh.find_column(ElementKind::Vertex, "weight");
    let Some(weight_column) = weight_column.filter(|&c| mesh.values::<f64>(c).is_some()) else {
        return None; // the mesh has no attribute `weight` of this type
    };
    let h_0 = mesh.face_halfedge(f);
    let h = mesh.loop_from(h_0).collect::<Vec<_>>();
    let n = h.len();
    let v: Vec<VertexId> = (0..n).map(|i| mesh.vertex(h[i])).collect();
    if mesh.is_hole(f) {
        return None; // `f` is a hole
    }
    if (0..n).any(|i| mesh.face(h[i]) != f) {
        return None; // `h[i]` does not lie in `f`
    }
    if !all_differ(&v) {
        return None; // two of `v[i]` are one vertex
    }
    let c_position = mesh.centroid(f);
    let v_weight: Vec<f64> = (0..n).map(|i| attribute::<f64>(mesh, weight_column, v[i].0) / 2.0).collect();

    // 2. Allocate what is new.
    let c = mesh.add_vertex();
    let a: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let b: Vec<_> = (0..n).map(|_| mesh.add_halfedge()).collect();
    let d: Vec<_> = (0..n).map(|_| mesh.add_edge()).collect();
    let g: Vec<_> = (0..n).map(|_| mesh.add_face()).collect();

    // 3. Reassign every pointer that changes.
    mesh.set_vertex_halfedge(c, b[0]);
    for i in 0..n {
        mesh.set_next(h[i], a[i]);
        mesh.set_prev(h[i], b[i]);
        mesh.set_face(h[i], g[i]);
        mesh.set_next(a[i], b[i]);
        mesh.set_prev(a[i], h[i]);
        mesh.set_twin(a[i], b[(i + 1) % n]);
        mesh.set_vertex(a[i], v[(i + 1) % n]);
        mesh.set_edge(a[i], d[i]);
        mesh.set_face(a[i], g[i]);
        mesh.set_next(b[i], h[i]);
        mesh.set_prev(b[i], a[i]);
        mesh.set_vertex(b[i], c);
        mesh.set_face(b[i], g[i]);
        mesh.set_twin(b[(i + 1) % n], a[i]);
        mesh.set_edge(b[(i + 1) % n], d[i]);
        mesh.set_edge_halfedge(d[i], a[i]);
        mesh.set_face_halfedge(g[i], h[i]);
    }
    mesh.set_position(c, c_position);
    for i in 0..n {
        set_attribute(mesh, weight_column, v[i].0, v_weight[i]);
    }

    // 4. Erase what is gone.
    mesh.erase_face(f);
    Some(c)
}

/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect("a column of this type")[element as usize]
}

/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.note_value(column, element);
    mesh.values_mut(column).expect("a column of this type")[element as usize] = value;
}

/// Whether nothing stands twice in `all`.
fn all_differ<T: PartialEq>(all: &[T]) -> bool {
    (1..all.len()).all(|at| !all[..at].contains(&all[at]))
}

/// Does the steps; if one refuses, or the mesh is not of the level in the end, undoes them.
fn all_or_nothing<T>(
    mesh: &mut Mesh,
    level: Level,
    steps: impl FnOnce(&mut Mesh) -> Option<T>,
) -> Option<T> {
    let mark = mesh.open_journal();
    let done = steps(mesh)
        .filter(|_| validate_level_near(mesh, level, &mesh.written_since(&mark)).is_ok());
    match done {
        Some(_) => mesh.keep(mark),
        None => mesh.roll_back(mark),
    }
    done
}

/// A position, if it is finite.
fn finite(position: DVec3) -> Option<DVec3> {
    position.is_finite().then_some(position)
}
}

use crate::places::Argument::{self, *};
use glam::DVec3;
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};

/// Calls an operation: whether it applied, and its result.
pub fn call(name: &str, mesh: &mut Mesh, a: &[Argument]) -> (bool, Option<u32>) {
    match (name, a) {
        ("collapse_collapse", &[Element(x0)]) => { let r = drawn::collapse_collapse(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("collapse_collapse_polygon", &[Element(x0)]) => { let r = drawn::collapse_collapse_polygon(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("connect_connect", &[Element(x0), Element(x1)]) => { let r = drawn::connect_connect(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("contract_contract", &[Element(x0)]) => { let r = drawn::contract_contract(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("dissolve_dissolve_edge", &[Element(x0)]) => { let r = drawn::dissolve_dissolve_edge(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("families_inset", &[Element(x0), Real(x1)]) => (drawn::families_inset(mesh, FaceId(x0), x1), None),
        ("families_poke", &[Element(x0)]) => { let r = drawn::families_poke(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("families_dissolve_vertex", &[Element(x0)]) => { let r = drawn::families_dissolve_vertex(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("families_bevel_vertex", &[Element(x0), Real(x1)]) => { let r = drawn::families_bevel_vertex(mesh, VertexId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("flip_flip", &[Element(x0)]) => (drawn::flip_flip(mesh, EdgeId(x0)), None),
        ("flip_flip_any", &[Element(x0)]) => (drawn::flip_flip_any(mesh, EdgeId(x0)), None),
        ("remesh_split", &[Element(x0)]) => { let r = drawn::remesh_split(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("remesh_collapse", &[Element(x0), Real(x1)]) => { let r = drawn::remesh_collapse(mesh, EdgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("remesh_flip", &[Element(x0)]) => (drawn::remesh_flip(mesh, EdgeId(x0)), None),
        ("split_split", &[Element(x0)]) => { let r = drawn::split_split(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("tutorial_flip", &[Element(x0)]) => { let r = drawn::tutorial_flip(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_bisect", &[Element(x0)]) => { let r = drawn::polygon_bisect(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_connect", &[Element(x0), Element(x1)]) => { let r = drawn::polygon_connect(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_dissolve_edge", &[Element(x0)]) => { let r = drawn::polygon_dissolve_edge(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_flip", &[Element(x0)]) => (drawn::polygon_flip(mesh, EdgeId(x0)), None),
        ("polygon_split", &[Element(x0)]) => { let r = drawn::polygon_split(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_collapse", &[Element(x0)]) => { let r = drawn::polygon_collapse(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_extrude", &[Element(x0), Real(x1), Real(x2)]) => { let r = drawn::polygon_extrude(mesh, FaceId(x0), x1, x2); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_inset_vertex", &[Element(x0)]) => { let r = drawn::polygon_inset_vertex(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_weld", &[Element(x0), Element(x1)]) => { let r = drawn::polygon_weld(mesh, EdgeId(x0), EdgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("attributes_split_marked", &[Element(x0), Real(x1)]) => { let r = drawn::attributes_split_marked(mesh, EdgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("attributes_hand_on", &[Element(x0)]) => { let r = drawn::attributes_hand_on(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("attributes_note_plane", &[Element(x0)]) => (drawn::attributes_note_plane(mesh, HalfedgeId(x0)), None),
        ("guards_open_star", &[Element(x0)]) => { let r = drawn::guards_open_star(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("guards_dissolve_simply", &[Element(x0)]) => { let r = drawn::guards_dissolve_simply(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("guards_fill_simply", &[Element(x0)]) => { let r = drawn::guards_fill_simply(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("guards_flip_any", &[Element(x0)]) => (drawn::guards_flip_any(mesh, EdgeId(x0)), None),
        ("guards_flip_simply", &[Element(x0)]) => (drawn::guards_flip_simply(mesh, EdgeId(x0)), None),
        ("guards_join_any", &[Element(x0), Element(x1)]) => { let r = drawn::guards_join_any(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("values_flip_if_longer", &[Element(x0), Real(x1)]) => { let r = drawn::values_flip_if_longer(mesh, EdgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("values_wander", &[Element(x0), Real(x1), Int(x2)]) => { let r = drawn::values_wander(mesh, VertexId(x0), x1, x2); (r.is_some(), r.map(|r| r.0)) },
        ("values_lift", &[Element(x0), Vec3(x1)]) => { let r = drawn::values_lift(mesh, FaceId(x0), DVec3::from_array(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("values_mark", &[Element(x0)]) => { let r = drawn::values_mark(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("values_cut", &[Element(x0), Element(x1)]) => { let r = drawn::values_cut(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("values_pierce", &[Element(x0)]) => { let r = drawn::values_pierce(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("values_stretch", &[Element(x0)]) => (drawn::values_stretch(mesh, HalfedgeId(x0)), None),
        ("values_settle", &[Element(x0), Real(x1)]) => { let r = drawn::values_settle(mesh, VertexId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("values_mangle", &[Element(x0), Real(x1)]) => (drawn::values_mangle(mesh, HalfedgeId(x0), x1), None),
        ("values_fold_up", &[Element(x0)]) => (drawn::values_fold_up(mesh, EdgeId(x0)), None),
        ("values_rename_all", &[Element(x0)]) => { let r = drawn::values_rename_all(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("more_extrude", &[Element(x0)]) => (drawn::more_extrude(mesh, FaceId(x0)), None),
        ("more_collapse_face", &[Element(x0)]) => { let r = drawn::more_collapse_face(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("more_cut_every_other_side", &[Element(x0)]) => (drawn::more_cut_every_other_side(mesh, FaceId(x0)), None),
        ("more_cut_corner", &[Element(x0)]) => { let r = drawn::more_cut_corner(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("more_poke_from", &[Element(x0)]) => { let r = drawn::more_poke_from(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("more_copy_places", &[Element(x0), Element(x1)]) => (drawn::more_copy_places(mesh, HalfedgeId(x0), HalfedgeId(x1)), None),
        ("more_fill", &[Element(x0)]) => { let r = drawn::more_fill(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("more_unpoke", &[Element(x0)]) => { let r = drawn::more_unpoke(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_flip", &[Element(x0)]) => (drawn::surface_flip(mesh, HalfedgeId(x0)), None),
        ("simple_flip", &[Element(x0)]) => (drawn::simple_flip(mesh, HalfedgeId(x0)), None),
        ("surface_flip_any", &[Element(x0)]) => (drawn::surface_flip_any(mesh, HalfedgeId(x0)), None),
        ("simple_flip_any", &[Element(x0)]) => (drawn::simple_flip_any(mesh, HalfedgeId(x0)), None),
        ("surface_split", &[Element(x0)]) => { let r = drawn::surface_split(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_split", &[Element(x0)]) => { let r = drawn::simple_split(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_split_border", &[Element(x0)]) => { let r = drawn::surface_split_border(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_split_border", &[Element(x0)]) => { let r = drawn::simple_split_border(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_bisect", &[Element(x0)]) => { let r = drawn::surface_bisect(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_bisect", &[Element(x0)]) => { let r = drawn::simple_bisect(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_collapse", &[Element(x0)]) => { let r = drawn::surface_collapse(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_collapse", &[Element(x0)]) => { let r = drawn::simple_collapse(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_collapse_border", &[Element(x0)]) => { let r = drawn::surface_collapse_border(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_collapse_border", &[Element(x0)]) => { let r = drawn::simple_collapse_border(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_contract", &[Element(x0)]) => { let r = drawn::surface_contract(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_contract", &[Element(x0)]) => { let r = drawn::simple_contract(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_dissolve_edge", &[Element(x0)]) => { let r = drawn::surface_dissolve_edge(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_dissolve_edge", &[Element(x0)]) => { let r = drawn::simple_dissolve_edge(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_dissolve_into_hole", &[Element(x0)]) => { let r = drawn::surface_dissolve_into_hole(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_dissolve_into_hole", &[Element(x0)]) => { let r = drawn::simple_dissolve_into_hole(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_dissolve_any", &[Element(x0)]) => { let r = drawn::surface_dissolve_any(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_dissolve_any", &[Element(x0)]) => { let r = drawn::simple_dissolve_any(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_open_face", &[Element(x0)]) => { let r = drawn::surface_open_face(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_open_face", &[Element(x0)]) => { let r = drawn::simple_open_face(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_fill_hole", &[Element(x0)]) => { let r = drawn::surface_fill_hole(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_fill_hole", &[Element(x0)]) => { let r = drawn::simple_fill_hole(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_zip", &[Element(x0)]) => { let r = drawn::surface_zip(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_zip", &[Element(x0)]) => { let r = drawn::simple_zip(mesh, HalfedgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_connect", &[Element(x0), Element(x1)]) => { let r = drawn::surface_connect(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_connect", &[Element(x0), Element(x1)]) => { let r = drawn::simple_connect(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("surface_part_vertex", &[Element(x0), Element(x1)]) => { let r = drawn::surface_part_vertex(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("simple_part_vertex", &[Element(x0), Element(x1)]) => { let r = drawn::simple_part_vertex(mesh, HalfedgeId(x0), HalfedgeId(x1)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_collapse_face", &[Element(x0)]) => { let r = polygon_in_steps::polygon_collapse_face(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_dissolve_vertex", &[Element(x0)]) => { let r = polygon_in_steps::polygon_dissolve_vertex(mesh, VertexId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_bevel_vertex", &[Element(x0), Real(x1)]) => { let r = polygon_in_steps::polygon_bevel_vertex(mesh, VertexId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_bevel_edge", &[Element(x0), Real(x1)]) => { let r = polygon_in_steps::polygon_bevel_edge(mesh, EdgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("polygon_open_face", &[Element(x0)]) => { let r = polygon_in_steps::polygon_open_face(mesh, FaceId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("steps_divide", &[Element(x0), Int(x1)]) => { let r = steps_in_steps::steps_divide(mesh, EdgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("steps_halve", &[Element(x0), Real(x1)]) => { let r = steps_in_steps::steps_halve(mesh, HalfedgeId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("steps_halve_around", &[Element(x0), Real(x1)]) => { let r = steps_in_steps::steps_halve_around(mesh, VertexId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        ("steps_triangulate", &[Element(x0), Real(x1)]) => (steps_in_steps::steps_triangulate(mesh, FaceId(x0), x1), None),
        ("steps_draw_in", &[Element(x0)]) => (steps_in_steps::steps_draw_in(mesh, VertexId(x0)), None),
        ("steps_clear", &[Element(x0)]) => { let r = steps_in_steps::steps_clear(mesh, EdgeId(x0)); (r.is_some(), r.map(|r| r.0)) },
        ("steps_relax", &[Element(x0), Real(x1)]) => (steps_in_steps::steps_relax(mesh, FaceId(x0), x1), None),
        ("steps_stud", &[Element(x0), Real(x1)]) => { let r = steps_in_steps::steps_stud(mesh, FaceId(x0), x1); (r.is_some(), r.map(|r| r.0)) },
        _ => panic!("{name} is not there"),
    }
}
