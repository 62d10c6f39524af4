//! When two meshes are the same, table by table.

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::ElementKind;

/// Whether the same ids live in both meshes and their tables agree bit for bit:
/// pointers, holes, positions and columns.
pub fn identical(a: &Mesh, b: &Mesh) -> bool {
    let bits = |p: DVec3| p.to_array().map(f64::to_bits);
    a.vertices().eq(b.vertices())
        && a.halfedges().eq(b.halfedges())
        && a.edges().eq(b.edges())
        && a.faces().eq(b.faces())
        && a.halfedges().all(|h| a.halfedge(h) == b.halfedge(h))
        && a.vertices().all(|v| a.vertex_halfedge(v) == b.vertex_halfedge(v))
        && a.vertices().all(|v| bits(a.position(v)) == bits(b.position(v)))
        && a.edges().all(|e| a.edge_halfedge(e) == b.edge_halfedge(e))
        && a.faces().all(|f| a.face_halfedge(f) == b.face_halfedge(f))
        && a.faces().all(|f| a.is_hole(f) == b.is_hole(f))
        && ElementKind::ALL.into_iter().all(|kind| same_columns(a, b, kind))
}

fn same_columns(a: &Mesh, b: &Mesh, kind: ElementKind) -> bool {
    let names = |mesh: &Mesh| {
        let columns = mesh.columns(kind);
        columns.map(|(id, column)| (id, column.name().to_owned())).collect::<Vec<_>>()
    };
    let columns = names(a);
    columns == names(b)
        && columns.iter().all(|&(id, _)| {
            (0..a.capacity(kind) as u32).filter(|&i| a.is_alive(kind, i)).all(|i| {
                match (a.value(id, i), b.value(id, i)) {
                    (Some(x), Some(y)) => x.is_identical(y),
                    _ => false,
                }
            })
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Value, VertexId, shape};

    #[test]
    fn every_bit_counts_and_dead_slots_do_not() {
        let a = shape::cube();
        let mut b = a.clone();
        let extra = b.add_vertex();
        assert!(!identical(&a, &b));
        b.erase_vertex(extra);
        assert!(identical(&a, &b));
        b.set_position(VertexId(0), a.position(VertexId(0)) + DVec3::splat(1e-15));
        assert!(!identical(&a, &b));
        let mut b = a.clone();
        b.add_column(ElementKind::Edge, "sharp", Value::Bool(false)).unwrap();
        assert!(!identical(&a, &b));
    }
}
