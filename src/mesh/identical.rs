//! Bitwise equality of two meshes, table by table.

use glam::DVec3;

use super::attribute::ColumnId;
use super::connectivity::Mesh;
use super::id::ElementKind;

/// True if the same ids are alive in both meshes and their tables agree bit for bit: pointers,
/// holes, positions and columns.
pub fn identical(a: &Mesh, b: &Mesh) -> bool {
    same_tables(a, b) && ElementKind::ALL.into_iter().all(|kind| same_columns(a, b, kind))
}

/// As [`identical`], except for columns that are scratch or bookkeeping and the order of the
/// others.
pub fn identical_but_for_scratch(a: &Mesh, b: &Mesh) -> bool {
    let public = |mesh: &Mesh| mesh.public_columns().count();
    same_tables(a, b)
        && public(a) == public(b)
        && a.public_columns().all(|(ours, column)| {
            let theirs = b.find_column(ours.kind, column.name());
            theirs.is_some_and(|theirs| same_values((a, ours), (b, theirs)))
        })
}

fn same_tables(a: &Mesh, b: &Mesh) -> bool {
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
}

fn same_columns(a: &Mesh, b: &Mesh, kind: ElementKind) -> bool {
    let names = |mesh: &Mesh| {
        mesh.columns(kind).map(|(id, column)| (id, column.name().to_owned())).collect::<Vec<_>>()
    };
    let columns = names(a);
    columns == names(b) && columns.iter().all(|&(id, _)| same_values((a, id), (b, id)))
}

fn same_values((a, ours): (&Mesh, ColumnId), (b, theirs): (&Mesh, ColumnId)) -> bool {
    a.elements(ours.kind).all(|i| match (a.value(ours, i), b.value(theirs, i)) {
        (Some(x), Some(y)) => x.is_identical(y),
        _ => false,
    })
}
