//! Meshes of polygons that are none: each fault is told, mended, and mended once.

use glam::DVec3;
use hedgerow::mesh::{
    ElementKind, FileFormat, Level, Mesh, MeshFile, Polygons, Repair, RepairReport, Repaired,
    equal_up_to_renumbering, read_mesh_from, validate, validate_level, write_mesh_to,
};
use proptest::prelude::*;

fn repair(positions: &[DVec3], polygons: &[Vec<u32>], merge: Option<f64>) -> Repaired {
    let list = polygons.iter().collect::<Polygons>();
    Repaired::new(positions.to_vec(), list, Repair { merge }).unwrap()
}

/// Points in general position.
fn points(count: u32) -> Vec<DVec3> {
    let at = |i: f64| DVec3::new((i * 0.7).sin(), (i * 1.3).cos(), i * 0.01);
    (0..count).map(|i| at(f64::from(i))).collect()
}

/// Repairs, and checks that the result is a mesh which a second repair leaves as it is.
fn repaired(count: u32, polygons: &[&[u32]]) -> (Mesh, RepairReport) {
    let polygons: Vec<Vec<u32>> = polygons.iter().map(|p| p.to_vec()).collect();
    let Repaired { mesh, report, .. } = repair(&points(count), &polygons, None);
    validate(&mesh).unwrap();
    let again = again(&mesh);
    assert!(!again.report.is_changed(), "{:?}", again.report);
    assert!(equal_up_to_renumbering(&mesh, &again.mesh));
    (mesh, report)
}

fn again(mesh: &Mesh) -> Repaired {
    let positions: Vec<_> = mesh.vertices().map(|v| mesh.position(v)).collect();
    let faces = mesh.faces().filter(|&f| !mesh.is_hole(f));
    let faces: Vec<Vec<u32>> =
        faces.map(|f| mesh.face_vertices(f).map(|v| v.0).collect()).collect();
    repair(&positions, &faces, None)
}

/// Vertices, polygons, the vertices and faces of the result, and what was done.
type Case = (u32, &'static [&'static [u32]], [usize; 2], RepairReport);

#[test]
fn each_fault_is_mended_and_counted() {
    let none = RepairReport::default();
    let cases: &[Case] = &[
        // A mesh stays, also two triangles back to back.
        (4, &[&[0, 1, 2], &[2, 1, 3]], [4, 2], none),
        (3, &[&[0, 1, 2], &[2, 1, 0]], [3, 2], none),
        // Corners that repeat the one before, and what is left of two-cornered faces.
        (
            4,
            &[&[0, 1, 1, 2], &[0, 3]],
            [4, 1],
            RepairReport { repeated_corners: 1, degenerate_faces: 1, ..none },
        ),
        // A polygon that comes back to a vertex becomes two.
        (
            5,
            &[&[0, 1, 2, 0, 3, 4]],
            [6, 2],
            RepairReport { divided_faces: 1, split_vertices: 1, ..none },
        ),
        // The same triangle again; and its back, where three meet at an edge.
        (3, &[&[0, 1, 2], &[1, 2, 0]], [3, 1], RepairReport { doubled_faces: 1, ..none }),
        (
            4,
            &[&[0, 1, 2], &[2, 1, 3], &[2, 1, 0], &[1, 2, 3]],
            [4, 2],
            RepairReport { doubled_faces: 2, ..none },
        ),
        // One of three is turned over.
        (
            5,
            &[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4]],
            [5, 3],
            RepairReport { turned_faces: 1, ..none },
        ),
        // Three at an edge: each has its own.
        (
            5,
            &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]],
            [9, 3],
            RepairReport { crowded_edges: 1, split_vertices: 4, ..none },
        ),
        // Two fans at a vertex.
        (5, &[&[0, 1, 2], &[0, 3, 4]], [6, 2], RepairReport { split_vertices: 1, ..none }),
        // A Möbius strip of five triangles.
        (
            5,
            &[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4], &[3, 4, 0], &[4, 0, 1]],
            [7, 5],
            RepairReport { turned_faces: 2, twisted_edges: 1, split_vertices: 2, ..none },
        ),
        // A spur, and a last corner that is the first.
        (4, &[&[0, 1, 2, 0, 3]], [4, 1], RepairReport { spurs: 1, ..none }),
        (4, &[&[3, 0, 1, 2, 0]], [4, 1], RepairReport { spurs: 1, ..none }),
        (3, &[&[0, 1, 2, 0]], [3, 1], RepairReport { repeated_corners: 1, ..none }),
        // A face of a vertex that does not exist.
        (3, &[&[0, 1, 2], &[0, 1, 7]], [3, 1], RepairReport { degenerate_faces: 1, ..none }),
    ];
    for (count, polygons, [vertices, faces], expected) in cases {
        let (mesh, report) = repaired(*count, polygons);
        assert_eq!(report, *expected, "{polygons:?}");
        assert_eq!([mesh.vertex_count(), mesh.face_count()], [*vertices, *faces], "{polygons:?}");
    }
}

/// Faces with holes, each a polygon that goes to its holes and back along bridges.
#[test]
fn holes_of_faces_are_not_filled() {
    let square = |x: f64, y: f64, size: f64| {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(u, v)| DVec3::new(x + size * u, y + size * v, 0.5 * (x + size * u)))
    };
    // The walk around a hole begins and ends at one corner, clockwise.
    let around = |first: u32| [first, first + 3, first + 2, first + 1, first];
    let one = [&[0, 1, 2, 3, 0][..], &around(4)].concat();
    let two = [&[0, 1, 2, 10, 9, 8, 11, 10, 2, 3, 0][..], &around(4)].concat();
    let chain = [&[0, 1, 2, 3, 0][..], &[4, 7, 6], &around(8), &[6, 5, 4]].concat();
    // Both holes hang on one corner.
    let shared = [&[0, 1][..], &[5, 4, 7, 6, 5, 1], &around(8), &[1, 2, 3]].concat();
    for (polygon, area) in [(one, 12.0), (two, 11.0), (chain, 11.0), (shared, 11.0)] {
        for turned in 0..polygon.len() {
            let mut polygon = polygon.clone();
            polygon.rotate_left(turned);
            let positions =
                [square(0.0, 0.0, 4.0), square(0.5, 0.5, 2.0), square(2.75, 2.75, 1.0)].concat();
            let Repaired { mesh, report, .. } = repair(&positions, &[polygon.clone()], None);
            validate_level(&mesh, Level::Simple).unwrap();
            let faces = mesh.faces().filter(|&f| !mesh.is_hole(f));
            let areas: f64 = faces.clone().map(|f| mesh.area(f)).sum();
            // The plane is inclined.
            let wanted = area * 1.25_f64.sqrt();
            assert!((areas - wanted).abs() < 1e-9, "{polygon:?}: {areas} for {wanted}");
            for f in faces {
                assert!(mesh.normal(f).z > 0.0, "{polygon:?}: a face is turned over");
            }
            assert_eq!((report.divided_faces, report.split_vertices), (1, 0), "{polygon:?}");
        }
    }
    // A round hole with very many corners.
    let corner = |at: u32| {
        let (y, x) = (f64::from(at) * std::f64::consts::TAU / 400.0).sin_cos();
        DVec3::new(x, y, 0.0)
    };
    let outline = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)];
    let outline = outline.map(|(x, y)| DVec3::new(x, y, 0.0));
    let positions: Vec<_> = outline.into_iter().chain((0..400).map(corner)).collect();
    let polygon = [1, 2, 3, 0, 1, 4].into_iter().chain((4..404).rev()).collect();
    let Repaired { mesh, .. } = repair(&positions, &[polygon], None);
    let area: f64 = mesh.faces().filter(|&f| !mesh.is_hole(f)).map(|f| mesh.area(f)).sum();
    let circle = 200.0 * (std::f64::consts::TAU / 400.0).sin();
    assert!((area - (16.0 - circle)).abs() < 1e-9, "{area}");
    // A spur whose area is not zero in doubles.
    let corners = [(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.1, 0.9), (0.3, 0.8)];
    let positions = corners.map(|(x, y)| DVec3::new(x, y, 0.0));
    for turned in 0..6 {
        let mut polygon = vec![0, 1, 2, 4, 2, 3];
        polygon.rotate_left(turned);
        let Repaired { mesh, report, .. } = repair(&positions, &[polygon], None);
        assert_eq!((mesh.face_count(), report.spurs), (1, 1));
    }
    // Two triangles side by side with a vertex in common, in opposite directions, have none.
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 0.0), (-1.0, 1.0)];
    let positions = corners.map(|(x, y)| DVec3::new(x, y, 0.0));
    assert_eq!(repair(&positions, &[vec![0, 1, 2, 0, 3, 4]], None).mesh.face_count(), 2);
    // Two polygons that hang at an edge have no hole.
    let positions = [square(0.0, 0.0, 1.0), square(2.0, 0.0, 1.0)].concat();
    let polygon = vec![0, 1, 2, 3, 0, 4, 5, 6, 7, 4];
    assert_eq!(repair(&positions, &[polygon], None).mesh.face_count(), 2);
}

#[test]
fn two_that_hang_together_around_a_cut_edge_keep_it() {
    // Four triangles around each end of the edge 0-1, and a flap at the edge, which comes off.
    let polygons: &[&[u32]] =
        &[&[0, 1, 2], &[1, 0, 3], &[0, 2, 4], &[0, 4, 3], &[1, 5, 2], &[1, 3, 5], &[0, 1, 6]];
    let (mesh, report) = repaired(7, polygons);
    assert_eq!(report.crowded_edges, 1);
    assert_eq!(mesh.face_count(), 7);
    let boundary = mesh.halfedges().filter(|&h| mesh.is_hole(mesh.face(h))).count();
    assert_eq!(boundary, 4 + 3);
    assert_eq!(validate_level(&mesh, Level::Simple), Ok(()));
}

/// A floor with a wall on it, of any number of polygons: the floor stays whole.
#[test]
fn a_floor_with_a_wall_stays_whole() {
    for walls in 1..=4_u32 {
        let at = |x: u32, y: u32| 7 * y + x;
        let cells = (0..6).flat_map(|y| (0..6).map(move |x| (x, y)));
        let floor =
            cells.map(|(x, y)| vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
        let wall = (0..walls).map(|x| vec![at(x + 1, 3), at(x + 2, 3), 50 + x, 49 + x]);
        let polygons: Vec<_> = floor.chain(wall).collect();
        let polygons: Vec<_> = polygons.iter().map(Vec::as_slice).collect();
        let (mesh, report) = repaired(50 + walls, &polygons);
        assert_eq!(report.crowded_edges, walls as usize);
        // The wall has a copy of each vertex that it shared.
        assert_eq!(report.split_vertices, walls as usize + 1);
        assert_eq!(mesh.holes().count(), 2);
        assert_eq!(validate_level(&mesh, Level::Simple), Ok(()));
    }
}

#[test]
fn points_are_merged_within_a_tolerance() {
    let at = |x: f64| DVec3::new(x, 0.0, 0.0);
    let up = DVec3::Y;
    // Two triangles whose shared edge is there twice, nearly; -0 is 0.
    let positions = [at(0.0), at(1.0), up, at(-0.0), at(1.0 + 1e-7), -up];
    let polygons = vec![vec![0, 1, 2], vec![4, 3, 5]];
    let apart = repair(&positions, &polygons, None);
    assert_eq!((apart.mesh.edge_count(), apart.report.merged_vertices), (6, 0));
    let equal = repair(&positions, &polygons, Some(0.0));
    // One vertex alone would pinch the surface, and is split again.
    assert_eq!((equal.mesh.vertex_count(), equal.report.merged_vertices), (6, 1));
    let close = repair(&positions, &polygons, Some(1e-6));
    assert_eq!((close.mesh.edge_count(), close.report.merged_vertices), (5, 2));
    assert_eq!(close.vertices, [0, 1, 2, 5]);
    // A chain does not collapse: no point moves farther than the tolerance.
    let chain: Vec<_> = (0..10).map(|i| at(f64::from(i) * 0.6)).collect();
    let merged = repair(&chain, &[], Some(1.0));
    assert_eq!(merged.vertices, [0, 2, 4, 6, 8]);
    // Tolerances of all sizes, and places far out, are answered at once.
    for tolerance in [1e-320, 1e-9, 1e3, 1e300] {
        let far: Vec<_> = (0..3000).map(|i| at(f64::from(i) * 1e299)).collect();
        repair(&far, &[], Some(tolerance));
    }
}

fn read(text: &str, repair: Option<Repair>) -> Result<MeshFile, String> {
    read_mesh_from("t.obj", FileFormat::Obj, text.as_bytes(), repair).map_err(|e| e.to_string())
}

fn text(file: &MeshFile) -> String {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, FileFormat::Obj, file).unwrap();
    String::from_utf8(bytes).unwrap()
}

const BROKEN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\nv 6 6 6\n\
    vt 0 0\nvt 1 0\nvt 0 1\ng a\nf 1/1 2/2 3/3\ng b\nf 2/2 1/1 4/3\nusemtl red\nf 1/1 2/2 5/3\n\
    f 1 2 2\nf 4/1 5/2 6/3\nf 6/3 5/2 4/1\nf 4 5 6\n";

#[test]
fn all_faults_are_told_by_kind() {
    let error = read(BROKEN, None).unwrap_err();
    assert!(error.starts_with("t.obj: "), "{error}");
    for kind in ["1 face with a vertex twice: line 16,", " of three faces or more: line "] {
        assert!(error.contains(kind), "{error}");
    }
    // A face that is there twice is told as that, and not by its sides.
    let error = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 1\n", None).unwrap_err();
    assert!(error.contains("t.obj:5: the faces of lines 4 and 5 are the same"), "{error}");
    // Three, of which the first lies back to back to the others.
    let error = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\nf 2 1 3\n", None).unwrap_err();
    assert!(error.contains("t.obj:6: the faces of lines 5 and 6 are the same"), "{error}");
    // Of many only the first are.
    let mut file = String::new();
    for i in 0..20 {
        file += &format!("v {i} 0 0\nv {i} 1 0\nv {i} 0 1\nv {i} 1 1\nv {i} 2 2\n");
        let n = i * 5;
        file += &format!("f {} {} {}\nf {} {} {}\n", n + 1, n + 2, n + 3, n + 1, n + 4, n + 5);
    }
    let error = read(&file, None).unwrap_err();
    assert!(error.contains("20 pinched vertices: line 7, the faces of lines 6 and 7"), "{error}");
    assert!(error.ends_with("; …"), "{error}");
}

#[test]
fn corners_groups_and_numbers_survive() {
    let file = read(BROKEN, Some(Repair::default())).unwrap();
    validate(&file.mesh).unwrap();
    let report = file.repaired.unwrap();
    assert_eq!((report.degenerate_faces, report.doubled_faces), (1, 1));
    let written = text(&file);
    // Texture coordinates stay at their corners, groups and materials with their faces.
    assert_eq!(written.matches("f ").count(), 5);
    assert_eq!(
        written.lines().filter(|line| line.starts_with("f ") && line.contains('/')).count(),
        5
    );
    assert!(written.contains("\ng a\nf 1/1 2/2 3/3\ng b\nf "), "{written}");
    assert!(written.contains("usemtl red\n"), "{written}");
    // Written and read again it is a mesh, the same.
    assert_eq!(text(&read(&written, None).unwrap()), written);
    // Vertices have the numbers of the file; what was split off has none.
    assert!((1..=6).all(|n| file.vertex_by_number(n).is_some()));
    assert_eq!(file.vertex_by_number(7), None);
    assert_eq!(file.face_by_number(4), None);
    assert!(file.face_by_number(5).is_some());
}

#[test]
fn merged_vertices_leave_what_differs_to_the_corners() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n\
        property float z\nproperty float s\nproperty float t\nproperty int part\n\
        element face 2\nproperty list uchar int vertex_indices\nend_header\n\
        0 0 0 0 0 7\n1 0 0 1 0 7\n0 1 0 0 1 7\n0 1 0 0.5 0.5 7\n1 0 0 0.25 0 7\n1 1 0 1 1 8\n\
        3 0 1 2\n3 3 4 5\n";
    let repair = Some(Repair { merge: Some(0.0) });
    let file = read_mesh_from("t.ply", FileFormat::Ply, ply.as_bytes(), repair).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.edge_count()), (4, 5));
    assert!(file.mesh.find_column(ElementKind::Halfedge, "uv").is_some());
    assert!(file.mesh.find_column(ElementKind::Vertex, "part").is_some());
    let mut obj = Vec::new();
    write_mesh_to(&mut obj, FileFormat::Obj, &file).unwrap();
    let obj = String::from_utf8(obj).unwrap();
    assert!(obj.contains("f 1/1 2/2 3/3\nf 3/4 2/5 4/6\n"), "{obj}");
}

proptest! {
    /// Whatever the polygons, the result is a mesh of level simple or close to it that a second
    /// repair leaves, and all faces of three different corners are there still or were doubled.
    #[test]
    fn any_polygons_become_a_mesh(
        polygons in proptest::collection::vec(proptest::collection::vec(0u32..9, 0..6), 0..16),
        merge in proptest::option::of(0.0..0.6),
    ) {
        let first = repair(&points(8), &polygons, merge);
        prop_assert_eq!(validate(&first.mesh), Ok(()));
        prop_assert!(first.mesh.is_polygons());
        let second = again(&first.mesh);
        prop_assert!(!second.report.is_changed(), "{:?}", second.report);
        prop_assert!(equal_up_to_renumbering(&first.mesh, &second.mesh));
        prop_assert_eq!(first.faces.len(), first.mesh.face_count());
        for (h, &corner) in first.mesh.halfedges().zip(&first.corners) {
            // Each corner is at the place of the vertex that it had, or one close to it.
            let had = *polygons.iter().flatten().nth(corner as usize).unwrap();
            let [now, then] = [first.mesh.position(first.mesh.vertex(h)), points(8)[had as usize]];
            prop_assert!(now.distance(then) <= merge.unwrap_or(0.0));
        }
    }
}
