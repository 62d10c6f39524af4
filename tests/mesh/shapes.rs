//! The named shapes are valid, of the level and the topology they should have.

use hedgerow::mesh::{Level, Mesh, Summary, same_connectivity, shape};

/// Vertices, edges, faces, holes.
fn counts(mesh: &Mesh) -> [usize; 4] {
    [mesh.vertex_count(), mesh.edge_count(), mesh.face_count(), mesh.hole_count()]
}

#[test]
fn every_shape_has_its_counts_level_and_genus() {
    let shapes = [
        ("tetrahedron", shape::tetrahedron(), [4, 6, 4, 0], Level::Simple, 0),
        ("cube", shape::cube(), [8, 12, 6, 0], Level::Simple, 0),
        ("octahedron", shape::octahedron(), [6, 12, 8, 0], Level::Simple, 0),
        ("icosahedron", shape::icosahedron(), [12, 30, 20, 0], Level::Simple, 0),
        ("icosphere 2", shape::icosphere(2), [162, 480, 320, 0], Level::Simple, 0),
        ("grid", shape::grid(3, 2), [12, 17, 6, 1], Level::Simple, 0),
        ("triangle grid", shape::triangle_grid(3, 2), [12, 23, 12, 1], Level::Simple, 0),
        ("torus", shape::torus(3, 4), [12, 24, 12, 0], Level::Simple, 1),
        ("triangle torus", shape::triangle_torus(3, 3), [9, 27, 18, 0], Level::Simple, 1),
        ("tube", shape::tube(4, 2), [12, 20, 8, 2], Level::Simple, 0),
        ("fan", shape::fan(5), [6, 10, 5, 1], Level::Simple, 0),
        ("polygon", shape::single_polygon(7), [7, 7, 1, 1], Level::Simple, 0),
        ("pillow", shape::pillow(3), [3, 3, 2, 0], Level::Surface, 0),
    ];
    for (name, mesh, expected, level, genus) in shapes {
        let summary = Summary::of(&mesh);
        assert_eq!(counts(&mesh), expected, "{name}");
        assert_eq!(summary.invalid, None, "{name}");
        assert_eq!(summary.level, Some(level), "{name}");
        let measures = summary.measures.unwrap();
        assert_eq!((measures.components, measures.genus), (1, genus), "{name}");
        assert!(measures.area > 0.0, "{name}");
    }
}

#[test]
fn closed_shapes_look_outward() {
    for mesh in [
        shape::tetrahedron(),
        shape::cube(),
        shape::octahedron(),
        shape::icosahedron(),
        shape::icosphere(1),
    ] {
        for f in mesh.faces() {
            assert!(mesh.normal(f).dot(mesh.centroid(f)) > 0.0);
        }
        for v in mesh.vertices() {
            assert!(mesh.vertex_normal(v).dot(mesh.position(v)) > 0.0);
        }
    }
    for mesh in [shape::grid(2, 2), shape::fan(4), shape::triangle_grid(2, 3)] {
        assert!(mesh.faces().filter(|&f| !mesh.is_hole(f)).all(|f| mesh.normal(f).z > 0.99));
    }
}

#[test]
fn counts_too_small_are_raised() {
    assert_eq!(counts(&shape::torus(0, 0)), counts(&shape::torus(3, 3)));
    assert_eq!(counts(&shape::grid(0, 0)), counts(&shape::grid(1, 1)));
    assert_eq!(counts(&shape::fan(0)), [4, 6, 3, 1]);
    assert!(same_connectivity(&shape::icosphere(0), &shape::icosahedron()));
}
