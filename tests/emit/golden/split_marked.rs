use hedgerow::mesh::glam::DVec3;
use hedgerow::mesh::{Attribute, ColumnId, EdgeId, ElementKind, Mesh, VertexId};

/// Splits an edge between two triangles, and marks what is new, as remeshers do.
pub fn split_marked(mesh: &mut Mesh, e: EdgeId, t: f64) -> Option<VertexId> {
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

/// The value of an attribute.
fn attribute<T: Attribute>(mesh: &Mesh, column: ColumnId, element: u32) -> T {
    mesh.values(column).expect("a column of this type")[element as usize]
}

/// Sets the value of an attribute.
fn set_attribute<T: Attribute>(mesh: &mut Mesh, column: ColumnId, element: u32, value: T) {
    mesh.note_value(column, element);
    mesh.values_mut(column).expect("a column of this type")[element as usize] = value;
}
