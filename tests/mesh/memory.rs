//! Room for elements, up to a limit.

use hedgerow::mesh::{ElementKind, Value, shape};

#[test]
fn a_mesh_grows_up_to_its_limit() {
    let mut mesh = shape::cube();
    mesh.add_column(ElementKind::Halfedge, "x", Value::Real(0.0)).unwrap();
    let limit = 100_000;
    let mut added = 0;
    while mesh.make_room([0, 1, 0, 0], || limit) {
        mesh.add_halfedge();
        added += 1;
        assert!(mesh.bytes() <= limit);
    }
    assert!((2500..3200).contains(&added), "{added}");
    // What is free needs no room.
    let last = mesh.halfedges().last().unwrap();
    mesh.erase_halfedge(last);
    assert!(!mesh.make_room([0, 1, 0, 0], || limit));
    mesh.recycle();
    assert!(mesh.make_room([0, 1, 0, 0], || limit));
    assert!(!mesh.make_room([0, 2, 0, 0], || limit));
    assert!(mesh.make_room([0, 2, 0, 0], || usize::MAX));
}
