//! Meshes compared: bit for bit, up to renumbering, and with what differs told.

use glam::DVec3;
use hedgerow::mesh::{
    ElementKind, FaceId, Mesh, Polygons, Value, VertexId, difference, equal_up_to_renumbering,
    identical, identical_but_for_scratch, same_connectivity, same_up_to_renumbering, shape,
    validate,
};

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
    assert!(!identical(&a, &b) && !identical_but_for_scratch(&a, &b));
    let mut c = a.clone();
    c.add_column(ElementKind::Edge, "private 0 sharp", Value::Bool(true)).unwrap();
    c.add_column(ElementKind::Edge, "sharp", Value::Bool(false)).unwrap();
    assert!(!identical(&b, &c) && identical_but_for_scratch(&b, &c));
}

#[test]
fn compaction_leaves_no_dead_slots() {
    let mut mesh = shape::torus(5, 7);
    let [gone, alone] = [mesh.add_vertex(), mesh.add_vertex()];
    mesh.erase_vertex(gone);
    mesh.set_position(alone, DVec3::ONE);
    mesh.set_hole(FaceId(4), true);
    let label = mesh.add_column(ElementKind::Face, "label", Value::Int(-1)).unwrap();
    assert!(mesh.set_value(label, 4, Value::Int(4)) && mesh.set_value(label, 5, Value::Int(5)));
    mesh.add_column(ElementKind::Face, "file:face", Value::Bool(true)).unwrap();
    let small = mesh.compacted();
    validate(&small).unwrap();
    assert!(equal_up_to_renumbering(&mesh, &small) && identical(&small, &small.compacted()));
    assert_eq!(small.capacity(ElementKind::Vertex), 36);
    assert_eq!(small.position(VertexId(35)), DVec3::ONE);
    // The hole comes last, and what is behind it moves up.
    assert!(small.is_hole(FaceId(34)) && small.hole_count() == 1);
    let values = small.values::<i64>(label).unwrap();
    assert_eq!((values[34], values[4], values[3]), (4, 5, -1));
    assert_eq!(small.column(label).unwrap().default_value(), Value::Int(-1));
    assert_eq!(small.columns(ElementKind::Face).count(), 1);
}

#[test]
fn each_comparison_sees_what_it_should() {
    let a = shape::torus(5, 7);
    let mut b = a.clone();
    assert!(equal_up_to_renumbering(&a, &b));
    b.set_position(VertexId(3), a.position(VertexId(3)) + DVec3::splat(1e-9));
    assert!(!equal_up_to_renumbering(&a, &b));
    assert!(same_up_to_renumbering(&a, &b, 1e-8) && !same_up_to_renumbering(&a, &b, 1e-10));
    assert!(same_connectivity(&a, &b));
    assert!(same_connectivity(&a, &shape::torus(7, 5)));
    assert!(!same_connectivity(&a, &shape::triangle_torus(5, 7)));
    b.set_hole(FaceId(4), true);
    assert!(!same_connectivity(&a, &b));
}

#[test]
fn mirror_images_differ_where_orientation_shows() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let polygons = |list: &[&[u32]]| list.iter().collect::<Polygons>();
    let a = Mesh::from_polygons(&square, &polygons(&[&[0, 1, 2, 3]])).unwrap();
    let b = Mesh::from_polygons(&square, &polygons(&[&[3, 2, 1, 0]])).unwrap();
    assert!(same_connectivity(&a, &b));
    assert!(!equal_up_to_renumbering(&a, &b));
}

#[test]
fn each_difference_is_found_in_its_order() {
    let told = |a: &Mesh, b: &Mesh| difference(a, b, 1e-9).to_string();
    let (cube, octahedron) = (shape::cube(), shape::octahedron());
    assert_eq!(
        told(&cube, &octahedron),
        "the mesh has 8 vertices, the other 6; the mesh has 6 faces, the other 8"
    );
    let mut moved = cube.clone();
    let v = moved.vertices().nth(3).expect("a cube has corners");
    moved.set_position(v, DVec3::new(0.5, 2.0, 0.0));
    assert_eq!(
        told(&moved, &cube),
        "a vertex lies where the other mesh has none; the first is vertex 3, at (0.5, 2, 0)"
    );
    let mut laid = cube.clone();
    laid.set_position(v, cube.position(cube.vertices().next().expect("a corner")));
    assert!(told(&laid, &cube).starts_with("no vertex lies where the other mesh has vertex 3"));
    // The same corners, but two of them have changed places.
    let mut swapped = cube.clone();
    let w = swapped.vertices().next().expect("a cube has corners");
    let (p, q) = (cube.position(v), cube.position(w));
    swapped.set_position(v, q);
    swapped.set_position(w, p);
    assert!(
        told(&swapped, &cube).starts_with("the other mesh has no edge where edge"),
        "{}",
        told(&swapped, &cube)
    );
}
