//! From polygons to meshes: what is refused and in which words, what is kept.

use glam::DVec3;
use hedgerow::mesh::{
    BuildError, ElementKind, FaceId, Level, Mesh, Polygons, Value, VertexId,
    equal_up_to_renumbering, shape, validate,
};
use hedgerow::{Program, Session};
use support::meshes::{Dice, meshes};

fn build(vertices: u32, polygons: &[&[u32]]) -> Result<Mesh, BuildError> {
    let positions: Vec<_> = (0..vertices).map(|i| DVec3::splat(f64::from(i))).collect();
    Mesh::from_polygons(&positions, &polygons.iter().collect::<Polygons>())
}

#[test]
fn what_is_no_mesh_is_refused_in_words() {
    let cases: [(u32, &[&[u32]], &str); 9] = [
        (3, &[&[0, 1]], "polygon 0 has 2 corners; a face needs 3 or more"),
        (3, &[&[0, 1, 3]], "polygon 0 names vertex 3, but there are 3 vertices"),
        (4, &[&[0, 1, 2], &[0, 3, 0]], "polygon 1 has vertex 0 as a corner twice"),
        (
            5,
            &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]],
            "polygons 0, 1 and 2 share the edge between vertices 0 and 1; an edge has two sides",
        ),
        (
            4,
            &[&[0, 1, 2], &[0, 1, 3]],
            "polygons 0 and 1 both run from vertex 0 to vertex 1; one of them is turned over",
        ),
        (
            5,
            &[&[0, 1, 2], &[0, 3, 4]],
            "polygons 0 and 1 meet at vertex 0 without an edge to join their fans",
        ),
        // Two closed fans at one vertex.
        (
            7,
            &[
                &[0, 1, 2],
                &[0, 2, 3],
                &[0, 3, 1],
                &[1, 3, 2],
                &[0, 4, 5],
                &[0, 5, 6],
                &[0, 6, 4],
                &[4, 6, 5],
            ],
            "polygons 0 and 4 meet at vertex 0 without an edge to join their fans",
        ),
        // A closed fan and an open one.
        (
            6,
            &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2], &[0, 4, 5]],
            "polygons 4 and 0 meet at vertex 0 without an edge to join their fans",
        ),
        (9, &[&[0, 1, 2, 3, 4, 5, 6, 7, 8, 3]], "polygon 0 has vertex 3 as a corner twice"),
    ];
    for (vertices, polygons, words) in cases {
        assert_eq!(build(vertices, polygons).unwrap_err().to_string(), words);
    }
}

#[test]
fn places_must_be_finite() {
    let positions = [DVec3::ZERO, DVec3::new(1.0, f64::INFINITY, 0.0)];
    let error = Mesh::from_polygons(&positions, &Polygons::new()).unwrap_err();
    assert_eq!(error.to_string(), "vertex 1 lies at 1 inf 0, which is not finite");
}

#[test]
fn input_numbers_are_ids() {
    let mesh = build(9, &[&[2, 4, 6], &[6, 4, 8, 5]]).unwrap();
    validate(&mesh).unwrap();
    let corners = |f| mesh.face_vertices(f).map(|v| v.0).collect::<Vec<_>>();
    assert_eq!(corners(FaceId(0)), [2, 4, 6]);
    assert_eq!(corners(FaceId(1)), [6, 4, 8, 5]);
    assert!(mesh.is_hole(FaceId(2)) && mesh.face_size(FaceId(2)) == 5);
    assert!(mesh.vertex_halfedge(VertexId(7)).is_none());
    assert_eq!(mesh.position(VertexId(7)), DVec3::splat(7.0));
}

#[test]
fn nothing_makes_an_empty_mesh() {
    let mesh = build(0, &[]).unwrap();
    assert_eq!(ElementKind::ALL.map(|kind| mesh.count(kind)), [0; 4]);
    validate(&mesh).unwrap();
}

#[test]
fn order_of_polygons_and_corners_does_not_matter() {
    let mesh = shape::icosphere(2);
    let n = mesh.vertex_count() as u32;
    let mut positions = vec![DVec3::ZERO; n as usize];
    // 5 and 162 have no common divisor.
    let moved = |v: u32| v * 5 % n;
    mesh.vertices().for_each(|v| positions[moved(v.0) as usize] = mesh.position(v));
    let mut faces: Vec<Vec<u32>> =
        mesh.faces().map(|f| mesh.face_vertices(f).map(|v| moved(v.0)).collect()).collect();
    faces.reverse();
    for (i, face) in faces.iter_mut().enumerate() {
        face.rotate_left(i % 3);
    }
    let other = Mesh::from_polygons(&positions, &faces.iter().collect::<Polygons>()).unwrap();
    assert!(equal_up_to_renumbering(&mesh, &other));
    positions[7].x += 1e-12;
    let other = Mesh::from_polygons(&positions, &faces.iter().collect::<Polygons>()).unwrap();
    assert!(!equal_up_to_renumbering(&mesh, &other));
}

#[test]
fn erased_slots_wait_for_recycling() {
    let mut mesh = shape::tetrahedron();
    let weight = mesh.add_column(ElementKind::Vertex, "weight", Value::Real(0.5)).unwrap();
    assert!(mesh.set_value(weight, 2, Value::Real(3.0)));
    assert!(
        !mesh.set_value(weight, 2, Value::Int(3)) && !mesh.set_value(weight, 9, Value::Real(3.0))
    );
    mesh.erase_vertex(VertexId(2));
    mesh.erase_vertex(VertexId(2));
    assert_eq!((mesh.vertex_count(), mesh.capacity(ElementKind::Vertex)), (3, 4));
    assert_eq!((mesh.value(weight, 2), mesh.get_position(VertexId(2))), (None, None));
    assert_eq!(mesh.add_vertex(), VertexId(4));
    mesh.recycle();
    assert_eq!(mesh.add_vertex(), VertexId(2));
    assert_eq!(mesh.value(weight, 2), Some(Value::Real(0.5)));
    assert_eq!(mesh.values::<f64>(weight), Some(&[0.5; 5][..]));
    assert_eq!(mesh.values::<bool>(weight), None);
    assert_eq!(mesh.add_vertex(), VertexId(5));
    assert!(mesh.can_add(10, 10, 10, 10) && !mesh.can_add(0, usize::MAX / 2, 0, 0));
}

#[test]
fn holes_are_counted_as_they_come_and_go() {
    let mut mesh = shape::tube(4, 1);
    assert_eq!((mesh.face_count(), mesh.hole_count()), (4, 2));
    let hole = mesh.holes().next().unwrap();
    mesh.set_hole(hole, false);
    mesh.set_hole(hole, false);
    assert_eq!((mesh.face_count(), mesh.hole_count()), (5, 1));
    let hole = mesh.holes().next().unwrap();
    mesh.erase_face(hole);
    assert_eq!((mesh.face_count(), mesh.hole_count()), (5, 0));
    mesh.recycle();
    assert_eq!(mesh.add_face(), hole);
    assert!(!mesh.is_hole(hole));
}

#[test]
fn a_column_of_another_type_is_a_conflict() {
    let mut mesh = shape::cube();
    let a = mesh.add_column(ElementKind::Edge, "sharp", Value::Bool(false)).unwrap();
    assert_eq!(mesh.add_column(ElementKind::Edge, "sharp", Value::Bool(true)), Ok(a));
    assert_eq!(mesh.find_column(ElementKind::Edge, "sharp"), Some(a));
    assert_eq!(mesh.find_column(ElementKind::Face, "sharp"), None);
    let conflict = mesh.add_column(ElementKind::Edge, "sharp", Value::Int(1)).unwrap_err();
    assert_eq!(conflict.to_string(), "the edge attribute `sharp` is of type bool, not int");
}

/// Meshes of any level, by flips that nothing guards: polygons hold just those that they give back.
#[test]
fn polygons_hold_what_they_give_back() {
    let text = "op flip(e: edge) {
        before {
          loop f0: v0 -a-> v1 -b-> v2 =P=> v0
          loop f1: v1 -d-> v0 -g-> v3 =Q=> v1
          edge e: a | d
        }
        after {
          loop f0: v3 -a-> v2 =P=> v0 -g-> v3
          loop f1: v2 -d-> v3 =Q=> v1 -b-> v2
          edge e: a | d
        }
      }";
    let program = Program::parse("flip.hedge", text).expect("it is proved");
    let flip = program.op("flip").expect("it is there");
    let mut dice = Dice(7);
    let (mut held, mut others) = (0, 0);
    for mesh in meshes(Level::Simple, &mut dice) {
        let mut session = Session::new(&program, mesh);
        for _ in 0..6 {
            let edges: Vec<_> = session.mesh().edges().collect();
            let edge = edges[dice.below(edges.len())];
            session.apply(&flip, edge).expect("it can be asked");
            let mesh = session.mesh();
            let (positions, polygons) = mesh.to_polygons();
            let again = Mesh::from_polygons(&positions, &polygons);
            let same = again.is_ok_and(|again| equal_up_to_renumbering(mesh, &again));
            assert_eq!(mesh.is_polygons(), same, "{positions:?} {polygons:?}");
            held += usize::from(same);
            others += usize::from(!same);
        }
    }
    assert!(held > 50 && others > 50, "{held} and {others}");
}
