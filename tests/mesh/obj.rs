//! OBJ in and out: what survives, what is refused and in which words.

use std::path::Path;

use glam::DVec3;
use hedgerow::mesh::{
    BareFaces, ElementKind, FaceId, FileError, FileFormat, HalfedgeId, Level, Mesh, MeshFile,
    VertexId, equal_up_to_renumbering, identical, read_mesh, read_mesh_from, shape, validate,
    validate_level, write_mesh, write_mesh_to,
};
use hedgerow::{Program, Session};
use proptest::prelude::*;

fn read(text: &str) -> MeshFile {
    read_bytes(text.as_bytes()).unwrap()
}

fn read_bytes(bytes: &[u8]) -> Result<MeshFile, FileError> {
    read_mesh_from("t.obj", FileFormat::Obj, bytes, None)
}

fn text(obj: &MeshFile) -> String {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, FileFormat::Obj, obj).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn corners(mesh: &Mesh, f: u32) -> Vec<u32> {
    mesh.face_vertices(FaceId(f)).map(|v| v.0).collect()
}

#[test]
fn example_meshes_make_the_round_trip() {
    for name in ["bunny", "teapot"] {
        let path = format!("{}/examples/meshes/{name}.obj", env!("CARGO_MANIFEST_DIR"));
        let first = read_mesh(Path::new(&path), None).unwrap();
        validate(&first.mesh).unwrap();
        let original = std::fs::read_to_string(&path).unwrap();
        let lines = |key: &str| original.lines().filter(|line| line.starts_with(key)).count();
        assert_eq!(first.mesh.vertex_count(), lines("v "));
        assert_eq!(first.mesh.face_count(), lines("f "));
        assert_eq!(validate_level(&first.mesh, Level::Simple), Ok(()));
        let written = text(&first);
        let second = read(&written);
        assert!(identical(&first.mesh, &second.mesh));
        assert!(equal_up_to_renumbering(&first.mesh, &second.mesh));
        assert_eq!(text(&second), written);
    }
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn malformed_files_are_refused_in_words() {
    let cases = [
        ("v 0 0\n", "1: `v` needs three numbers; in a plane the third is 0"),
        ("\n\nv 0 x 0\n", "3: `x` is not a number"),
        ("v 0 \\\n0 x\nv 1 1 1\n", "1: `x` is not a number"),
        ("v 0 0 \u{e9}\n", "1: `\u{e9}` is not a number"),
        ("v 0,0 0 0\n", "1: `0,0` is not a number; numbers are written with a point"),
        ("vn 0 0,5 1\n", "1: `0,5` is not a number; numbers are written with a point"),
        (
            "v 0 0 0\nv 0 NaN 0\nv 1 1 1\n",
            "2: vertex 2 has a coordinate that is not a finite number",
        ),
        ("v 0 0 1e999\n", "1: vertex 1 has a coordinate that is not a finite number"),
        ("vt\n", "1: `vt` needs a number or more"),
        ("vn 1 2\n", "1: `vn` needs three numbers"),
        ("T\nf 1 2 x\n", "4: `x` is not a corner of a face"),
        ("T\nf 1 2 3.0\n", "4: `3.0` is not a corner of a face"),
        ("T\nf 1 2 3/1/1/1\n", "4: `3/1/1/1` is not a corner of a face"),
        ("T\nf 1 2 /1\n", "4: `/1` is not a corner of a face"),
        (
            "T\nf 0 1 2\n",
            "4: 0 is not an index: they count from 1, or back from -1; the faces seem to count vertices \
             from 0, and the format counts from 1",
        ),
        ("T\nf 1 2 4\nv 0 0\n", "5: `v` needs three numbers; in a plane the third is 0"),
        ("T\nf 1 2 4\nf 1 2 3\n", "4: there is no vertex 4: the file has 3 vertices"),
        ("T\nf 1 2 -4\n", "4: there is no vertex -4: the file has 3 vertices"),
        (
            "T\nf 1 2 99999999999999999\n",
            "4: there is no vertex 99999999999999999: the file has 3 vertices",
        ),
        (
            "T\nvt 0 0\nf 1/1 2/1 3/2\n",
            "5: there is no texture coordinate 2: the file has 1 texture coordinate",
        ),
        ("T\nf 1//1 2 3\n", "4: there is no normal 1: the file has 0 normals"),
        ("T\n#\nf 1 2\n", "5: a face needs 3 corners or more, and this has 2 corners"),
        ("T\nf\n", "4: a face needs 3 corners or more, and this has 0 corners"),
        ("T\nf 1 2 2\n", "4: the face has vertex 2 as a corner twice"),
        (
            "T\nT\n\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
            "10: the faces of lines 8, 9 and 10 share the edge between vertices 1 and 2, and an edge has two sides",
        ),
        (
            "T\nT\nf 1 2 3\nf 1 2 4\n",
            "8: the faces of lines 7 and 8 both run from vertex 1 to vertex 2, so one of them is turned over",
        ),
        (
            "T\nT\nf 1 2 3\nf 1 4 5\n",
            "8: the faces of lines 7 and 8 meet at vertex 1 only, so the surface is pinched there",
        ),
    ];
    for (file, words) in cases {
        let file = file.replace("T\n", TRIANGLE);
        let error = read_bytes(file.as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), format!("t.obj:{words}"), "{file}");
    }
    let error = read_mesh(Path::new("/nowhere/at/all.obj"), None).unwrap_err();
    assert!(error.to_string().starts_with("/nowhere/at/all.obj: "));
}

#[test]
fn all_that_is_legal_is_read() {
    let file = b"\xef\xbb\xbf# caf\xe9 c:\\x\\\r\n\
        mtllib a b.mtl\r\n\
        v 0 0 0 1.0\r\nv 1 0 0 \\\r\n 0.5\r\n\tv  1  1\t0 # corner\r\n\
        curv 0 1 1 2\r\nsomething else \xff\r\n\
        g left\r\nf 1 -2 \\\r\n -1 \r\n\
        o second thing\nusemtl red\nl 1 2\np 1\n\
        v 0 1 0\ns 1\nf 1 3 4 5 6 7\n\
        v 0 .5 0\nv 0 +2.5e-1 0\nv 5 5 5\nv 9 9 9\n";
    let obj = read_bytes(&file[..]).unwrap();
    validate(&obj.mesh).unwrap();
    assert_eq!((obj.mesh.vertex_count(), obj.mesh.face_count()), (8, 2));
    assert_eq!(corners(&obj.mesh, 0), [0, 1, 2]);
    // Vertices 5, 6 and 7 come after the face that names them.
    assert_eq!(corners(&obj.mesh, 1), [0, 2, 3, 4, 5, 6]);
    assert_eq!(obj.mesh.position(VertexId(5)), DVec3::new(0.0, 0.25, 0.0));
    assert_eq!(obj.mesh.position(VertexId(7)), DVec3::splat(9.0));
    assert!(obj.mesh.vertex_halfedge(VertexId(7)).is_none());
    let expected = "mtllib a b.mtl\n\
        v 0 0 0\nv 1 0 0 0.5\nv 1 1 0\nv 0 1 0\nv 0 0.5 0\nv 0 0.25 0\nv 5 5 5\nv 9 9 9\n\
        g left\nf 1 2 3\no second thing\nusemtl red\ns 1\nf 1 3 4 5 6 7\n";
    assert_eq!(text(&obj), expected);
    assert_eq!(text(&read(expected)), expected);
}

#[test]
fn many_vertices_before_and_between_faces() {
    // More than one roll of vertices, and faces of the first that name the last.
    let mut file = String::new();
    for i in 0..9000 {
        file.push_str(&format!("v {i} 0 0\n"));
        if i == 5000 {
            file.push_str("f 1 9000 3\n");
        }
    }
    let obj = read(&file);
    assert_eq!(corners(&obj.mesh, 0), [0, 8999, 2]);
    assert!((0..9000).all(|i| obj.mesh.position(VertexId(i)).x == f64::from(i)));
}

#[test]
fn groups_do_not_tear_and_are_kept() {
    let file = format!("{TRIANGLE}v 1 1 0\ng a\nusemtl m\nf 1 2 3\ng b\nf 2 4 3\n");
    let obj = read(&file);
    assert_eq!((obj.mesh.edge_count(), obj.mesh.hole_count()), (5, 1));
    assert_eq!(text(&obj), file);
}

#[test]
fn colors_are_kept_and_vertices_without_are_white() {
    let file = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n";
    let mut obj = read(file);
    assert_eq!(text(&obj), file);
    let color = obj.mesh.find_column(ElementKind::Vertex, "color").unwrap();
    assert_eq!(obj.mesh.values::<DVec3>(color).unwrap()[2], DVec3::new(0.0, 0.0, 0.5));
    obj.mesh.add_vertex();
    assert!(text(&obj).contains("v 0 0 0 1 1 1\n"));
    let some = "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n";
    let white = "v 0 0 0 1 0 0\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0.5\nf 1 2 3\n";
    assert_eq!(text(&read(some)), white);
    assert_eq!(read(some).losses(), ["1 vertex without a colour, which is white now"]);
}

#[test]
fn corners_keep_texture_and_normals() {
    let head = format!("{TRIANGLE}v 1 1 0\nvt 0\nvt 0.25\nvn 0 0 1\nvn 0 1 0\n");
    let file = format!("{head}f 1/1/1 2/2/1 3/1/2\nf 2/1 4/2 3/1\n");
    let obj = read(&file);
    assert_eq!(text(&obj), file);
    assert_eq!(obj.texture_coordinates().len(), 2);
    assert_eq!(
        (obj.texture_index(HalfedgeId(1)), obj.normal_index(HalfedgeId(4))),
        (Some(1), None)
    );
    // Only some corners of the second face have one.
    let file = format!("{head}f 1//1 2//1 3//2\nf 2/1 4 3/1\n");
    assert_eq!(text(&read(&file)), format!("{head}f 1//1 2//1 3//2\nf 2 4 3\n"));
    // Negative ones count back from where they stand.
    let file =
        format!("{TRIANGLE}v 1 1 0\nvt 0 0\nvt 1 0\nf 1/-2 2/-1 3/-2\nvt 5 5\nf 2/-1 4/2 3/1\n");
    let obj = read(&file);
    let rows: Vec<_> = (0..6).map(|h| obj.texture_index(HalfedgeId(h)).unwrap()).collect();
    assert_eq!(rows, [0, 1, 0, 2, 1, 0]);
    // A halfedge that starts elsewhere is no longer that corner.
    let mut obj = read(&format!("{TRIANGLE}v 1 1 0\nvt 0\nf 1/1 2/1 3/1\nf 2/1 4/1 3/1\n"));
    let old = VertexId(1);
    let spokes: Vec<_> = obj.mesh.spokes(old).collect();
    let new = obj.mesh.add_vertex();
    spokes.iter().for_each(|&h| obj.mesh.set_vertex(h, new));
    obj.mesh.set_vertex_halfedge(new, spokes[0]);
    obj.mesh.set_vertex_halfedge(old, HalfedgeId::NONE);
    assert!(text(&obj).ends_with("f 1 5 3\nf 5 4 3\n"));
}

#[test]
fn numbers_follow_the_file() {
    let mut obj = read("v 0 0 0\nv 7 7 7\nv 1 0 0\nv 0 1 0\nf 1 3 4\n");
    assert_eq!(obj.vertex_by_number(2), Some(VertexId(1)));
    assert_eq!((obj.vertex_by_number(0), obj.vertex_by_number(5)), (None, None));
    assert_eq!((obj.face_by_number(1), obj.face_by_number(2)), (Some(FaceId(0)), None));
    // A new vertex takes the slot of an old one, but not its number.
    obj.mesh.erase_vertex(VertexId(1));
    assert_eq!(obj.vertex_by_number(2), None);
    obj.mesh.recycle();
    let new = obj.mesh.add_vertex();
    assert_eq!(new, VertexId(1));
    assert_eq!((obj.vertex_by_number(2), obj.vertex_number(new)), (None, None));
    assert_eq!(obj.vertex_number(VertexId(3)), Some(4));
    let numbers = obj.written_numbers();
    let written: Vec<_> = (0..5).map(|v| numbers.vertex(VertexId(v))).collect();
    assert_eq!(written, [Some(1), Some(4), Some(2), Some(3), None]);
    assert_eq!((numbers.face(FaceId(0)), numbers.face(FaceId(1))), (Some(1), None));
    assert_eq!(text(&obj), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\n");
    obj.mesh.set_hole(FaceId(0), true);
    assert_eq!(obj.written_numbers().face(FaceId(0)), None);
}

#[test]
fn new_faces_come_last_in_the_group_of_their_halfedges() {
    let file = format!("{TRIANGLE}v 1 1 0\nv 2 0 0\ng a\nf 1 2 3\ng b\nf 2 4 3\ng c\nf 2 5 4\n");
    let mut obj = read(&file);
    // The first face goes, a new one gets its slot and its loop.
    let h = obj.mesh.face_halfedge(FaceId(0));
    let walk: Vec<_> = obj.mesh.loop_from(h).collect();
    obj.mesh.erase_face(FaceId(0));
    obj.mesh.recycle();
    let new = obj.mesh.add_face();
    obj.mesh.set_face_halfedge(new, h);
    walk.iter().for_each(|&h| obj.mesh.set_face(h, new));
    validate(&obj.mesh).unwrap();
    assert!(text(&obj).ends_with("g b\nf 2 4 3\ng c\nf 2 5 4\ng a\nf 1 2 3\n"));
}

/// Runs the script `main` of a program on the mesh of a file.
fn run_on(program: &str, obj: &mut MeshFile) {
    let program = Program::parse("test.hedge", program).unwrap();
    let mut session = Session::new(&program, std::mem::take(&mut obj.mesh));
    session.run(&program.script("main").unwrap(), ()).unwrap();
    obj.mesh = session.into_mesh();
}

#[test]
fn new_faces_are_in_the_groups_of_those_they_were_cut_from() {
    // A grid of quads in columns, each column another group.
    let mut file = String::new();
    for (y, x) in (0..6).flat_map(|y| (0..6).map(move |x| (y, x))) {
        file += &format!("v {x} {y} 0\n");
    }
    for x in 1..6 {
        file += &format!("usemtl m{x}\n");
        for corner in (0..5).map(|y| 6 * y + x) {
            file += &format!("f {} {} {} {}\n", corner, corner + 1, corner + 7, corner + 6);
        }
    }
    let programs = [
        "use \"std/triangulate.hedge\" script main() { triangulate() }",
        "use \"std/subdivide.hedge\" script main() { catmull_clark(3) }",
        "use \"std/subdivide.hedge\" script main() { linear_quads(2) }",
        "use \"std/triangulate.hedge\" use \"std/subdivide.hedge\" \
         script main() { triangulate() linear(3) }",
        "use \"std/polygon.hedge\" script main() { for f in faces { inset_vertex(f) } }",
        "use \"std/polygon.hedge\" script main() { for f in faces { extrude(f, 0.0, 0.5) } }",
    ];
    for program in programs {
        let mut obj = read(&file);
        run_on(program, &mut obj);
        let written = text(&obj);
        let mut points: Vec<f64> = Vec::new();
        let (mut group, mut faces) = (0, 0);
        for line in written.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            match words[0] {
                "v" => points.push(words[1].parse().unwrap()),
                "usemtl" => group = words[1][1..].parse().unwrap(),
                "f" => {
                    let xs = words[1..].iter().map(|v| points[v.parse::<usize>().unwrap() - 1]);
                    let middle = xs.sum::<f64>() / (words.len() - 1) as f64;
                    assert_eq!(middle.floor() as i32 + 1, group, "{program}: {line}");
                    faces += 1;
                }
                _ => {}
            }
        }
        assert!(faces >= 50, "{program}: only {faces} faces");
    }
}

#[test]
fn corners_without_a_seam_keep_their_texture_through_flips() {
    let mut file = String::new();
    for (y, x) in (0..5).flat_map(|y| (0..5).map(move |x| (y, x))) {
        file += &format!("v {x} {y} 0\nvt {x} {y}\n");
    }
    for c in (0..4).flat_map(|y| (1..5).map(move |x| 5 * y + x)) {
        file += &format!("f {0}/{0} {1}/{1} {2}/{2}\n", c, c + 1, c + 6);
        file += &format!("f {0}/{0} {1}/{1} {2}/{2}\n", c, c + 6, c + 5);
    }
    let mut obj = read(&file);
    let flip = "use \"std/triangle.hedge\" script main() { for e in edges { flip(e) } }";
    run_on(flip, &mut obj);
    assert_eq!(obj.bare_faces(), [BareFaces::default(); 2]);
    let written = text(&obj);
    let faces = written.lines().filter_map(|line| line.strip_prefix("f "));
    for corner in faces.flat_map(|face| face.split(' ')) {
        let (vertex, texture) = corner.split_once('/').unwrap();
        assert_eq!(vertex, texture);
    }
}

#[test]
fn a_mesh_from_nowhere_is_written_in_order() {
    let obj = MeshFile::from_mesh(shape::single_polygon(3));
    assert!(text(&obj).ends_with("f 1 2 3\n"));
    assert!(equal_up_to_renumbering(&read(&text(&obj)).mesh, &obj.mesh));
}

#[test]
fn what_is_no_place_is_not_written() {
    let mut obj = read(&format!("{TRIANGLE}f 1 2 3\n"));
    obj.mesh.set_position(VertexId(1), DVec3::new(f64::INFINITY, 0.0, 0.0));
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    std::fs::write(&path, "before").unwrap();
    let error = write_mesh(&path, &obj).unwrap_err().to_string();
    assert!(error.ends_with("a.obj: vertex 2 has a coordinate that is not a finite number"));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "before");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_missing_folder_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("gone").join("a.obj");
    let error = write_mesh(&path, &read(TRIANGLE)).unwrap_err().to_string();
    assert!(error.contains("gone` does not exist"), "{error}");
    assert!(write_mesh(folder.path(), &read(TRIANGLE)).is_err());
}

#[cfg(unix)]
#[test]
fn modes_and_links_are_respected() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let mode = |path: &Path| std::fs::metadata(path).unwrap().permissions().mode() & 0o777;
    let obj = read(TRIANGLE);
    let (new, plain) = (folder.path().join("new.obj"), folder.path().join("plain"));
    write_mesh(&new, &obj).unwrap();
    std::fs::write(&plain, "").unwrap();
    assert_eq!(mode(&new), mode(&plain));
    std::fs::set_permissions(&new, std::fs::Permissions::from_mode(0o640)).unwrap();
    let link = folder.path().join("link.obj");
    symlink("new.obj", &link).unwrap();
    let bigger = read(&format!("{TRIANGLE}v 4 4 4\n"));
    write_mesh(&link, &bigger).unwrap();
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(std::fs::read_to_string(&new).unwrap(), text(&bigger));
    assert_eq!(mode(&new), 0o640);
    let dangling = folder.path().join("dangling.obj");
    symlink("later.obj", &dangling).unwrap();
    write_mesh(&dangling, &obj).unwrap();
    assert_eq!(std::fs::read_to_string(folder.path().join("later.obj")).unwrap(), text(&obj));
}

proptest! {
    #[test]
    fn any_bytes_are_answered(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = read_bytes(&bytes[..]);
    }

    /// Lines that look like a file, so that the far ends are reached.
    #[test]
    fn any_lines_are_answered(lines in proptest::collection::vec(
        "(v( -?[0-9.]{1,3}){3}|f( -?[0-6](/[0-3]?(/[0-3])?)?){3,5}|f 1 2 3|v[tn] 1 2 3|g [ab]|\\\\|[vfl#] ?)",
        0..25,
    )) {
        let start = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 1\nvt 0 0\nvn 0 0 1\n".to_owned();
        if let Ok(obj) = read_bytes((start + &lines.join("\n")).as_bytes()) {
            prop_assert_eq!(validate(&obj.mesh), Ok(()));
            let written = text(&obj);
            let again = read_bytes(written.as_bytes()).unwrap();
            prop_assert!(identical(&obj.mesh, &again.mesh) || written.contains("vt") || written.contains("vn"));
            prop_assert!(equal_up_to_renumbering(&obj.mesh, &again.mesh));
            prop_assert_eq!(text(&again), written);
        }
    }
}

#[test]
fn reals_are_printed_as_rust_prints_them() {
    let mut state = 1u64;
    let mut values = vec![0.0, -0.0, 1e15, 1e16, 123456789012345678.0, 1e-5, 1e-7, 5e-324];
    values.extend([f64::MAX, 0.1 + 0.2, 1e22, 100.5, -3.25]);
    for _ in 0..20_000 {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        values.push(f64::from_bits(state));
        values.push((state >> 40) as f64 / 1000.0);
    }
    values.retain(|value| value.is_finite());
    let mut mesh = Mesh::default();
    for at in values.chunks_exact(3) {
        let v = mesh.add_vertex();
        mesh.set_position(v, DVec3::new(at[0], at[1], at[2]));
    }
    let written = text(&MeshFile::from_mesh(mesh));
    let lines = written.lines().filter_map(|line| line.strip_prefix("v "));
    let words: Vec<_> = lines.flat_map(|line| line.split(' ')).collect();
    assert_eq!(words.len(), values.len() / 3 * 3);
    for (word, value) in words.into_iter().zip(values) {
        assert_eq!(word, value.to_string());
    }
}
