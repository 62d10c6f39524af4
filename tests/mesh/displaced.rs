//! Values of corners that are no longer at the corner they were given for.

use glam::DVec2;
use hedgerow::mesh::{ColumnId, Displaced, ElementKind, Mesh, Places, Value, shape};

fn cube() -> (Mesh, ColumnId) {
    let mut mesh = shape::cube();
    let uv = Value::Vec2(DVec2::ZERO);
    let column = mesh.add_column(ElementKind::Halfedge, "uv", uv).unwrap();
    for h in mesh.halfedges().collect::<Vec<_>>() {
        let value = Value::Vec2(DVec2::new(f64::from(h.0), 1.0));
        assert!(mesh.set_value(column, h.0, value));
    }
    (mesh, column)
}

#[test]
fn what_has_not_moved_is_not_told() {
    let (mut mesh, column) = cube();
    let places = Places::of(&mesh);
    assert!(mesh.set_value(column, 3, Value::Vec2(DVec2::ONE)));
    assert!(places.displaced(&mesh).is_empty());
    let cube = shape::cube();
    assert!(Places::of(&cube).displaced(&cube).is_empty());
}

#[test]
fn what_has_moved_is_told_unless_it_was_set() {
    let (mut mesh, column) = cube();
    let places = Places::of(&mesh);
    // Turns a face by one corner.
    let face = mesh.faces().next().unwrap();
    let sides: Vec<_> = mesh.face_halfedges(face).collect();
    let corners: Vec<_> = sides.iter().map(|&h| mesh.vertex(h)).collect();
    for (at, &h) in sides.iter().enumerate() {
        mesh.set_vertex(h, corners[(at + 1) % corners.len()]);
    }
    assert!(mesh.set_value(column, sides[0].0, Value::Vec2(DVec2::ONE)));
    assert!(mesh.set_value(column, sides[1].0, Value::Vec2(DVec2::ZERO)));
    let told = Displaced { attribute: "uv".into(), kept: 2, defaulted: 1, faces: [1, 6] };
    assert_eq!(places.displaced(&mesh), [told]);
}
