//! Measures: of faces and vertices, of stars, and of whole meshes.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use hedgerow::mesh::{Bin, EdgeId, FaceId, HalfedgeId, Level, Mesh, Summary, VertexId, shape};

#[test]
fn a_square() {
    let mesh = shape::single_polygon(4);
    assert!((mesh.area(FaceId(0)) - 2.0).abs() < 1e-12);
    assert!((mesh.normal(FaceId(0)) - DVec3::Z).length() < 1e-12);
    assert!(mesh.centroid(FaceId(0)).length() < 1e-12);
    assert!((mesh.length(EdgeId(0)) - 2f64.sqrt()).abs() < 1e-12);
    assert!((mesh.vertex_normal(VertexId(0)) - DVec3::Z).length() < 1e-12);
}

#[test]
fn degenerate_faces_have_no_direction() {
    let mut mesh = shape::single_polygon(3);
    for v in 0..3 {
        mesh.set_position(VertexId(v), DVec3::ONE);
    }
    assert_eq!(mesh.normal(FaceId(0)), DVec3::ZERO);
    assert_eq!(mesh.vertex_normal(VertexId(0)), DVec3::ZERO);
    assert_eq!(mesh.area(FaceId(0)), 0.0);
    assert_eq!(mesh.normal(FaceId(77)), DVec3::ZERO);
    // One that is too large does not seem to have none.
    mesh.set_position(VertexId(0), DVec3::new(f64::MAX, -f64::MAX, 0.0));
    assert!(mesh.normal(FaceId(0)).is_nan() && mesh.vertex_normal(VertexId(0)).is_nan());
}

#[test]
fn small_faces_keep_their_direction() {
    let mut mesh = shape::single_polygon(3);
    for v in 0..3 {
        mesh.set_position(VertexId(v), mesh.position(VertexId(v)) * 1e-120);
    }
    assert!((mesh.normal(FaceId(0)) - DVec3::Z).length() < 1e-12);
}

#[test]
fn genus_and_components() {
    let torus = Summary::of(&shape::torus(4, 4)).measures.unwrap();
    assert_eq!((torus.euler_characteristic, torus.genus, torus.components), (0, 1, 1));
    let tube = Summary::of(&shape::tube(5, 2));
    assert_eq!(tube.holes, 2);
    let measures = tube.measures.unwrap();
    assert_eq!((measures.euler_characteristic, measures.genus), (0, 0));
    assert_eq!(measures.degrees, [Bin { size: 3, count: 10 }, Bin { size: 4, count: 5 }]);
    assert_eq!(measures.face_sizes, [Bin { size: 4, count: 10 }]);
}

#[test]
fn one_measure_alone_is_that_of_the_summary() {
    let mut open = shape::tube(5, 2);
    let alone = open.add_vertex();
    open.set_position(alone, DVec3::splat(9.0));
    for mesh in [Mesh::default(), shape::cube(), open] {
        let all = Summary::of(&mesh).measures.unwrap();
        assert_eq!((mesh.surface_area(), mesh.volume()), (all.area, all.volume));
        assert_eq!(mesh.bounds().map(|corners| corners.map(|at| at.to_array())), all.bounds);
        assert_eq!(mesh.euler_characteristic(), all.euler_characteristic);
    }
}

#[test]
fn volume_and_bounding_box() {
    let volume = |mesh: &Mesh| Summary::of(mesh).measures.unwrap().volume;
    let mut cube = shape::cube();
    let [low, high] = Summary::of(&cube).measures.unwrap().bounds.unwrap();
    let sides = [0, 1, 2].map(|axis| high[axis] - low[axis]);
    let product: f64 = sides.iter().product();
    assert!((volume(&cube).unwrap() - product).abs() < 1e-12 && product > 0.1);
    // Wherever it lies; and it is turned inside out by a mirror.
    for v in 0..8 {
        let v = VertexId(v);
        let place = cube.position(v);
        cube.set_position(v, DVec3::new(7.0 - place.x, place.y, place.z));
    }
    assert!((volume(&cube).unwrap() + product).abs() < 1e-12);
    let ball = volume(&shape::icosphere(5)).unwrap();
    assert!((ball - 4.0 / 3.0 * PI).abs() < 0.01, "{ball}");
    assert_eq!(volume(&shape::grid(2, 2)), None);
    assert_eq!(volume(&Mesh::default()), None);
}

#[test]
fn an_empty_mesh_and_a_broken_one() {
    let empty = Summary::of(&Mesh::default());
    assert_eq!(empty.level, Some(Level::Simple));
    assert_eq!(empty.measures.unwrap().genus, 0);
    let mut mesh = shape::cube();
    mesh.set_next(HalfedgeId(0), HalfedgeId(0));
    let broken = Summary::of(&mesh);
    assert!(broken.invalid.is_some() && broken.measures.is_none());
}

#[test]
fn the_reason_for_the_level() {
    let summary = Summary::of(&shape::pillow(3));
    assert_eq!(summary.level, Some(Level::Surface));
    let reason = summary.below_next_level.unwrap();
    assert_eq!(reason, "face 0 and face 1 have the same corners");
}

/// The centroid of the kernel of a polygon that is the link of an edge.
fn kernel(ring: &[[f64; 2]]) -> Option<DVec2> {
    let count = ring.len() as u32;
    let (a, b, half) = (count, count + 1, count / 2);
    let mut faces = vec![[a, half, b], [b, 0, a]];
    faces.extend((0..count).map(|at| [if at < half { a } else { b }, at, (at + 1) % count]));
    let ends = [[0.1, 0.2, 0.0], [0.2, 0.1, 0.0]];
    let ring = ring.iter().map(|&[x, y]| [x, y, 0.0]);
    let mesh = Mesh::from_triangles(&ring.chain(ends).collect::<Vec<_>>(), &faces).unwrap();
    let is_middle = |e: &EdgeId| {
        let h = mesh.edge_halfedge(*e);
        [mesh.vertex(h), mesh.target(h)].iter().all(|v| v.0 >= count)
    };
    let centroid = mesh.kernel_centroid(mesh.edges().find(is_middle).expect("there is one"))?;
    assert_eq!(centroid.z, 0.0);
    Some(centroid.truncate())
}

#[test]
fn kernels_of_polygons() {
    let near = |found: Option<DVec2>, wanted: DVec2| (found.unwrap() - wanted).length() < 1e-12;
    assert!(near(kernel(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]), DVec2::ONE));
    // The corner of an L is seen from the square at its bend.
    let bent = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
    assert!(near(kernel(&bent), DVec2::splat(0.5)));
    // From nowhere all of a U is seen.
    let cup = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 2.0],
        [2.0, 2.0],
        [2.0, 1.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [0.0, 2.0],
    ];
    assert_eq!(kernel(&cup), None);
    assert_eq!(kernel(&[[1.0, 1.0]; 4]), None);
}

#[test]
fn links_of_edges() {
    // Unit squares cut in two: the link of the diagonal in the middle of three by three.
    let mesh = shape::triangle_grid(3, 3);
    let inside = mesh.edges().filter(|&e| {
        let h = mesh.edge_halfedge(e);
        let ends = [mesh.vertex(h), mesh.target(h)];
        ends.iter().all(|&v| !mesh.is_boundary_vertex(v))
    });
    let mut seen = 0;
    for e in inside {
        let h = mesh.edge_halfedge(e);
        let middle = (mesh.position(mesh.vertex(h)) + mesh.position(mesh.target(h))) / 2.0;
        // The link is symmetric about the middle of the edge.
        let centroid = mesh.kernel_centroid(e).unwrap();
        assert!((centroid - middle).length() < 1e-12, "{centroid} {middle}");
        seen += 1;
    }
    assert_eq!(seen, 5);
    let closed = shape::octahedron();
    assert!(closed.edges().all(|e| closed.kernel_centroid(e).is_some()));
    let border = shape::single_polygon(3);
    assert!(border.edges().all(|e| border.kernel_centroid(e).is_none()));
}
