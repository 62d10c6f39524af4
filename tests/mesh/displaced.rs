//! Values of corners that are no longer at the corner they were given for.

use glam::DVec2;
use hedgerow::mesh::{ColumnId, Displaced, ElementKind, Mesh, Places, Unset, Value, shape};

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
    let places = Places::of(&mesh, |_, _| false);
    assert!(mesh.set_value(column, 3, Value::Vec2(DVec2::ONE)));
    assert!(places.displaced(&mesh).is_empty());
    let cube = shape::cube();
    assert!(Places::of(&cube, |_, _| false).displaced(&cube).is_empty());
}

#[test]
fn what_has_moved_is_told_unless_it_was_set() {
    let (mut mesh, column) = cube();
    let places = Places::of(&mesh, |_, _| false);
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

#[test]
fn new_elements_without_a_value_are_told_unless_the_program_knows_it() {
    for kind in [ElementKind::Edge, ElementKind::Face] {
        let mut mesh = shape::cube();
        let label = mesh.add_column(kind, "label", Value::Int(0)).unwrap();
        for index in 0..mesh.capacity(kind) as u32 {
            assert!(mesh.set_value(label, index, Value::Int(7)));
        }
        let places = Places::of(&mesh, |_, _| false);
        let known = Places::of(&mesh, |of, name| (of, name) == (kind, "label"));
        assert_eq!(places.unset(&mesh), []);
        let last = mesh.capacity(kind) as u32 - 1;
        match kind {
            ElementKind::Edge => mesh.erase_edge(hedgerow::mesh::EdgeId(last)),
            _ => mesh.erase_face(hedgerow::mesh::FaceId(last)),
        }
        mesh.recycle();
        // One takes the slot of the other, one a slot of its own.
        for _ in 0..2 {
            match kind {
                ElementKind::Edge => drop(mesh.add_edge()),
                _ => drop(mesh.add_face()),
            }
        }
        let told = Unset { kind, attribute: "label".into(), count: 2 };
        assert_eq!(places.unset(&mesh), [told]);
        assert_eq!(known.unset(&mesh), []);
    }
}
