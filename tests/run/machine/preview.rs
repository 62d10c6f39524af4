//! The mesh as an operation would leave it.

use hedgerow::mesh::{HalfedgeId, VertexId, shape};
use hedgerow::rewrite::preview::Preview;

use super::*;

#[test]
fn an_empty_sheet_shows_the_mesh() {
    let mesh = shape::pillow(3);
    let mut preview = Preview::default();
    preview.clear();
    let mut ask = |condition| preview.foresees(&mesh, condition, 0, 0).unwrap();
    assert!(ask(Foreseen::ThreeSides) && ask(Foreseen::MeetsOnce));
    assert!(ask(Foreseen::NeighborsDiffer) && ask(Foreseen::TwoSpokes));
    assert!(!ask(Foreseen::CornersDiffer) && !ask(Foreseen::CornersOwn));
}

#[test]
fn notes_count_until_the_sheet_is_cleared() {
    let mesh = shape::tetrahedron();
    let mut preview = Preview::default();
    preview.clear();
    let spoke = mesh.vertex_halfedge(VertexId(0));
    let twin = mesh.twin(spoke).0;
    let other = mesh.vertex(HalfedgeId(mesh.prev(spoke).0)).0;
    preview.store(&mesh, HalfedgeField::Vertex, twin, other).unwrap();
    let neighbors =
        |preview: &mut Preview| preview.foresees(&mesh, Foreseen::NeighborsDiffer, 0, 0).unwrap();
    assert!(!neighbors(&mut preview), "two spokes lead to {other}");
    preview.clear();
    assert!(neighbors(&mut preview));
}

#[test]
fn new_elements_have_numbers_that_the_mesh_does_not_use() {
    let mesh = shape::tetrahedron();
    let mut preview = Preview::default();
    preview.clear();
    let (a, b) = (preview.add(), preview.add());
    assert!(a != b && mesh.get_halfedge(HalfedgeId(b)).is_none());
    preview.store(&mesh, HalfedgeField::Face, b, 3).unwrap();
    assert_eq!(preview.record(&mesh, b).unwrap().face.0, 3);
}
