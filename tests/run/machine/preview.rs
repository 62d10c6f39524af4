//! The mesh as an operation would leave it.

use hedgerow::mesh::{
    ElementKind, HalfedgeId, OrbitCondition, VertexId, identical, shape, validate,
};
use hedgerow::rewrite::preview::Preview;
use support::dice::Dice;

use super::*;

#[test]
fn where_nothing_is_set_the_mesh_is_asked() {
    let mesh = shape::pillow(3);
    let mut preview = Preview::default();
    preview.clear();
    let mut ask = |condition| preview.foresees(&mesh, condition, 0, 0).unwrap();
    assert!(ask(OrbitCondition::ThreeSides) && ask(OrbitCondition::MeetsOnce));
    assert!(ask(OrbitCondition::NeighborsDiffer) && ask(OrbitCondition::TwoSpokes));
    assert!(!ask(OrbitCondition::CornersDiffer) && !ask(OrbitCondition::CornersOwn));
}

#[test]
fn what_is_set_counts_until_it_is_put_back() {
    let mut mesh = shape::tetrahedron();
    let before = mesh.clone();
    let mut preview = Preview::default();
    preview.clear();
    let spoke = mesh.vertex_halfedge(VertexId(0));
    let twin = mesh.twin(spoke).0;
    let other = mesh.vertex(HalfedgeId(mesh.prev(spoke).0)).0;
    preview.store(&mut mesh, HalfedgeField::Vertex, twin, other).unwrap();
    let neighbors = |preview: &mut Preview, mesh: &Mesh| {
        preview.foresees(mesh, OrbitCondition::NeighborsDiffer, 0, 0).unwrap()
    };
    assert!(!neighbors(&mut preview, &mesh), "two spokes lead to {other}");
    preview.undo(&mut mesh);
    assert!(neighbors(&mut preview, &mesh));
    assert!(identical(&mesh, &before));
}

#[test]
fn all_that_is_set_is_put_back_the_last_first() {
    let mut dice = Dice(5);
    let mut mesh = shape::torus(5, 4);
    let before = mesh.clone();
    let mut preview = Preview::default();
    for _ in 0..50 {
        preview.clear();
        let some = preview.add();
        for _ in 0..200 {
            let mut below = |kind| dice.below(mesh.capacity(kind) + 1) as u32;
            let [v, h, e, f] = ElementKind::ALL.map(&mut below);
            let value = if dice.below(9) == 0 { some } else { h };
            let field = [HalfedgeField::Next, HalfedgeField::Prev, HalfedgeField::Twin];
            // Those past the end are told, and nothing is set.
            let _ = preview.store(&mut mesh, field[dice.below(3)], h, value);
            let _ = preview.store(&mut mesh, HalfedgeField::Vertex, h, v);
            let _ = preview.store(&mut mesh, HalfedgeField::Edge, h, e);
            let _ = preview.store(&mut mesh, HalfedgeField::Face, h, f);
            let _ = preview.store_halfedge(&mut mesh, ElementField::Vertex, v, u32::MAX);
            let _ = preview.store_halfedge(&mut mesh, ElementField::Edge, e, value);
            let _ = preview.store_halfedge(&mut mesh, ElementField::Face, f, value);
            let _ = preview.store_hole(&mut mesh, f, dice.below(2) == 0);
            let erased = u32::MAX - 1;
            assert!(preview.store(&mut mesh, HalfedgeField::Next, 0, erased).is_err());
        }
        assert!(!identical(&mesh, &before));
        preview.undo(&mut mesh);
        assert!(identical(&mesh, &before));
    }
    validate(&mesh).unwrap();
}

#[test]
fn new_elements_have_numbers_that_the_mesh_does_not_use() {
    let mut mesh = shape::tetrahedron();
    let mut preview = Preview::default();
    preview.clear();
    let (a, b) = (preview.add(), preview.add());
    assert!(a != b && mesh.get_halfedge(HalfedgeId(b)).is_none());
    preview.store(&mut mesh, HalfedgeField::Face, b, 3).unwrap();
    assert_eq!(preview.record(&mesh, b).unwrap().face.0, 3);
}
