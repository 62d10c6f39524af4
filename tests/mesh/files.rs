//! Meshes in files of each format: what survives the way out and in, what is refused, and that
//! whatever the bytes are, they are answered.

use glam::{DMat3, DVec2, DVec3};
use hedgerow::mesh::{
    ElementKind, Encoding, FileFormat, FileReason, Mesh, MeshFile, MshVersion, Repair, Value,
    VertexId, equal_up_to_renumbering, read_mesh, read_mesh_from, same_connectivity, shape,
    validate, write_mesh_to,
};

pub(super) fn read(format: FileFormat, bytes: &[u8]) -> Result<MeshFile, String> {
    read_mesh_from("t", format, bytes, None).map_err(|error| error.to_string())
}

pub(super) fn write(format: FileFormat, file: &MeshFile) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, format, file).unwrap();
    bytes
}

const ENCODINGS: [Encoding; 3] = [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];

/// A mesh with an attribute of every type on every kind of element.
pub(super) fn attributed(mut mesh: Mesh) -> Mesh {
    let defaults = [
        ("flag", Value::Bool(true)),
        ("part", Value::Int(-7)),
        ("crease", Value::Real(0.1)),
        ("drift", Value::Vec2(DVec2::new(0.5, -0.25))),
        ("tangent", Value::Vec3(DVec3::X)),
        ("weights", Value::Vec4(glam::DVec4::ONE)),
        ("frame", Value::Mat3(DMat3::IDENTITY)),
        ("bind", Value::Mat4(glam::DMat4::IDENTITY)),
        ("color", Value::Vec3(DVec3::ONE)),
        ("normal", Value::Vec3(DVec3::ZERO)),
        ("uv", Value::Vec2(DVec2::ZERO)),
    ];
    for kind in ElementKind::ALL {
        for (name, default) in defaults {
            add_attribute(&mut mesh, kind, name, default);
        }
    }
    mesh
}

/// Adds an attribute with a value at every other element.
fn add_attribute(mesh: &mut Mesh, kind: ElementKind, name: &str, default: Value) {
    let ids: Vec<u32> = match kind {
        ElementKind::Vertex => mesh.vertices().map(|v| v.0).collect(),
        // Holes have no corners and no line in a file.
        ElementKind::Halfedge => {
            mesh.halfedges().filter(|&h| !mesh.is_hole(mesh.face(h))).map(|h| h.0).collect()
        }
        ElementKind::Edge => mesh.edges().map(|e| e.0).collect(),
        ElementKind::Face => mesh.faces().filter(|&f| !mesh.is_hole(f)).map(|f| f.0).collect(),
    };
    let column = mesh.add_column(kind, name, default).unwrap();
    for &id in ids.iter().step_by(2) {
        let x = f64::from(id) / 3.0;
        let value = match default {
            Value::Bool(_) => Value::Bool(id % 3 == 0),
            Value::Int(_) => Value::Int(i64::from(id) - 40_000_000_000),
            Value::Real(_) => Value::Real(x),
            Value::Vec2(_) => Value::Vec2(DVec2::new(x, -x)),
            Value::Vec3(_) => Value::Vec3(DVec3::new(x, 0.5, -0.0)),
            Value::Vec4(_) => Value::Vec4(glam::DVec4::splat(x)),
            Value::Mat3(_) => Value::Mat3(DMat3::from_diagonal(DVec3::splat(x))),
            Value::Mat4(_) => Value::Mat4(glam::DMat4::from_scale(DVec3::splat(x))),
        };
        assert!(mesh.set_value(column, id, value));
    }
}

/// A PLY file returns all attributes of a mesh: values, types and defaults.
fn returns_attributes(file: &MeshFile) {
    assert!(file.unheld(FileFormat::Ply).is_empty());
    let mut back = read(FileFormat::Ply, &write(FileFormat::Ply, file)).unwrap();
    assert_eq!(back.losses(), [""; 0]);
    assert_eq!(back.encoding, file.encoding);
    back.bring_all();
    let (ours, theirs) = (&file.mesh, &back.mesh);
    let names = |mesh: &Mesh| {
        let all = mesh.public_columns();
        let mut all: Vec<_> = all.map(|(id, it)| format!("{} {}", id.kind, it.name())).collect();
        all.sort_unstable();
        all
    };
    assert_eq!(names(ours), names(theirs));
    for (id, column) in ours.public_columns() {
        let other = theirs.find_column(id.kind, column.name()).unwrap();
        let (name, kind) = (column.name(), id.kind);
        let [a, b] = [column, theirs.column(other).unwrap()].map(|c| c.default_value());
        assert!(a.is_identical(b), "{kind} {name}: {a:?} {b:?}");
        for index in 0..ours.capacity(kind) as u32 {
            let corner = hedgerow::mesh::HalfedgeId(index);
            let in_hole = kind == ElementKind::Halfedge && ours.is_hole(ours.face(corner))
                || kind == ElementKind::Face && ours.is_hole(hedgerow::mesh::FaceId(index));
            if let (false, Some(value)) = (in_hole, ours.value(id, index)) {
                let read = theirs.value(other, index).unwrap();
                assert!(value.is_identical(read), "{kind} {name}: {value:?} {read:?}");
            }
        }
    }
}

#[test]
fn ply_holds_all_attributes() {
    for mesh in [shape::cube(), shape::tube(4, 2), shape::icosahedron()] {
        for encoding in ENCODINGS {
            let mut file = MeshFile::from_mesh(attributed(mesh.clone()));
            file.encoding = encoding;
            returns_attributes(&file);
        }
    }
}

#[test]
fn ply_holds_attributes_whatever_their_names() {
    // They are names of properties in files of other programs, or become some.
    let names = "x y z nx ny nz red green blue green_ alpha color normal uv s t u v r g b texcoord \
        texcoord_ vertex_indices vertex_index vertex1 object group material smoothing texture_u \
        texture_v diffuse_red as vertex x' é";
    let defaults = [
        Value::Bool(true),
        Value::Int(-7),
        Value::Real(0.1),
        Value::Real(1.0),
        Value::Vec2(DVec2::ZERO),
        Value::Vec2(DVec2::new(0.5, -0.0)),
        Value::Vec3(DVec3::ZERO),
        Value::Vec3(DVec3::ONE),
        Value::Vec3(DVec3::X),
        Value::Mat3(DMat3::IDENTITY),
    ];
    let mut dice = Dice(7);
    for round in 0..120 {
        let mesh = [shape::cube(), shape::tube(4, 2), shape::icosahedron()][round % 3].clone();
        let mut text = b"o a\nusemtl b\n".to_vec();
        text.extend(write(FileFormat::Obj, &MeshFile::from_mesh(mesh)));
        let mut file = read(FileFormat::Obj, &text).unwrap();
        file.encoding = ENCODINGS[round / 3 % 3];
        for kind in ElementKind::ALL {
            for name in names.split_whitespace() {
                // Some are left out.
                if let Some(&default) = defaults.get(dice.roll(2 * defaults.len())) {
                    add_attribute(&mut file.mesh, kind, name, default);
                }
            }
        }
        returns_attributes(&file);
    }
}

#[test]
fn polygons_make_the_round_trip_in_each_format() {
    let meshes = [shape::cube(), shape::icosahedron(), shape::tube(4, 2), shape::single_polygon(7)];
    for mesh in meshes {
        let largest = mesh.faces().filter(|&f| !mesh.is_hole(f)).map(|f| mesh.face_size(f)).max();
        for format in FileFormat::ALL {
            for encoding in ENCODINGS {
                for version in [MshVersion::V2, MshVersion::V4] {
                    let mut file = MeshFile::from_mesh(mesh.clone());
                    (file.encoding, file.msh_version) = (encoding, version);
                    let mut bytes = Vec::new();
                    let written = write_mesh_to(&mut bytes, format, &file);
                    let most = match format {
                        FileFormat::Stl => 3,
                        FileFormat::Msh => 4,
                        _ => usize::MAX,
                    };
                    if largest.unwrap() > most {
                        assert!(matches!(written, Err(FileReason::Unheld(_))));
                        continue;
                    }
                    written.unwrap();
                    let back = read(format, &bytes).unwrap();
                    validate(&back.mesh).unwrap();
                    assert_eq!(back.losses(), [""; 0]);
                    let is_stl = format == FileFormat::Stl;
                    assert!(is_stl || equal_up_to_renumbering(&mesh, &back.mesh), "{format}");
                    assert_eq!(mesh.face_count(), back.mesh.face_count());
                    assert_eq!(mesh.edge_count(), back.mesh.edge_count());
                    let mut again = back;
                    if format == FileFormat::Ply || is_stl && encoding == Encoding::Ascii {
                        assert_eq!(again.encoding, encoding);
                    }
                    again.encoding = encoding;
                    assert_eq!(write(format, &again), bytes, "{format}");
                }
            }
        }
    }
}

const OBJ: &str = "mtllib a b.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n\
    vt 0 0\nvt 1 0\nvt 1 1\no box\ng left side\nusemtl red#3\ns 1\nf 1/1 2/2 3/3\ng right\nf 1/1 3/3 4/2\n";

#[test]
fn materials_groups_and_attributes_are_in_one_file() {
    let obj = read(FileFormat::Obj, OBJ.as_bytes()).unwrap();
    for encoding in ENCODINGS {
        let mut file = obj.clone();
        file.encoding = encoding;
        let ply = read(FileFormat::Ply, &write(FileFormat::Ply, &file)).unwrap();
        assert_eq!(write(FileFormat::Obj, &ply), write(FileFormat::Obj, &obj));
        assert_eq!(ply.losses(), [""; 0]);
    }
    // A Gmsh file holds the groups.
    let msh = read(FileFormat::Msh, &write(FileFormat::Msh, &obj)).unwrap();
    let text = String::from_utf8(write(FileFormat::Obj, &msh)).unwrap();
    assert!(text.contains("g left side\nf 1 2 3\ng right\nf 1 3 4\n"), "{text}");
    let lost = obj.lost_groups(FileFormat::Stl);
    assert!(lost.contains(&"groups"), "{lost:?}");
    let others: Vec<_> = lost.into_iter().filter(|word| *word != "groups").collect();
    assert_eq!(obj.lost_groups(FileFormat::Msh), others);
    assert_eq!(obj.lost_groups(FileFormat::Ply), [""; 0]);
}

#[test]
fn colours_of_materials_are_attributes_of_faces() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.obj");
    std::fs::write(&path, OBJ).unwrap();
    std::fs::write(folder.path().join("a b.mtl"), "newmtl red#3\nKd 1 0.5 0\n").unwrap();
    let mut file = read_mesh(&path, None).unwrap();
    file.bring_all();
    let color = file.mesh.find_column(ElementKind::Face, "color").unwrap();
    assert_eq!(file.mesh.value(color, 1), Some(Value::Vec3(DVec3::new(1.0, 0.5, 0.0))));
    // A library that is no file is not opened.
    std::fs::remove_file(folder.path().join("a b.mtl")).unwrap();
    std::fs::create_dir(folder.path().join("a b.mtl")).unwrap();
    let file = read_mesh(&path, None).unwrap();
    assert_eq!(file.read_materials(), (Vec::new(), vec!["a b.mtl".to_owned()]));
}

#[test]
fn off_and_msh_hold_what_they_can() {
    let mut mesh = shape::icosahedron();
    for (name, value) in [
        ("normal", Value::Vec3(DVec3::Z)),
        ("color", Value::Vec3(DVec3::new(0.5, 0.25, 1.0))),
        ("alpha", Value::Real(0.5)),
        ("uv", Value::Vec2(DVec2::new(0.1, 0.2))),
    ] {
        mesh.add_column(ElementKind::Vertex, name, value).unwrap();
    }
    mesh.add_column(ElementKind::Face, "color", Value::Vec3(DVec3::new(0.0, 0.5, 0.0))).unwrap();
    let file = MeshFile::from_mesh(mesh);
    assert!(file.unheld(FileFormat::Off).is_empty());
    let bytes = write(FileFormat::Off, &file);
    assert!(bytes.starts_with(b"STCNOFF\n12 20 30\n"));
    let back = read(FileFormat::Off, &bytes).unwrap();
    assert!(same_connectivity(&file.mesh, &back.mesh));
    assert_eq!(write(FileFormat::Off, &back), bytes);
    assert_eq!(back.mesh.public_columns().count(), 5);

    assert_eq!(file.unheld(FileFormat::Msh).len(), 1);
    let mut marked = MeshFile::from_mesh(shape::icosahedron());
    let mark = marked.mesh.add_column(ElementKind::Face, "marked", Value::Bool(false)).unwrap();
    assert!(marked.unheld(FileFormat::Obj).is_empty());
    assert!(marked.mesh.set_value(mark, 3, Value::Bool(true)));
    assert_eq!(marked.unheld(FileFormat::Obj).len(), 1);
    let back = read(FileFormat::Msh, &write(FileFormat::Msh, &file)).unwrap();
    let color = back.mesh.find_column(ElementKind::Face, "color").unwrap();
    assert_eq!(back.mesh.value(color, 3), Some(Value::Vec3(DVec3::new(0.0, 0.5, 0.0))));
    assert_eq!(back.mesh.public_columns().count(), 4);
}

/// A triangle in a file of MuJoCo, with normals and texture coordinates.
pub(super) fn of_mujoco() -> Vec<u8> {
    let mut bytes: Vec<u8> = [3i32, 3, 3, 1].iter().flat_map(|x| x.to_le_bytes()).collect();
    let positions = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let normals = [0.0f32, 0.0, 1.0].repeat(3);
    let texture = [0.0f32, 0.0, 0.5, 0.0, 0.0, 0.5];
    let floats = positions.iter().chain(&normals).chain(&texture);
    bytes.extend(floats.flat_map(|x| x.to_le_bytes()));
    bytes.extend([0i32, 1, 2].iter().flat_map(|x| x.to_le_bytes()));
    bytes
}

#[test]
fn other_programs_files_are_read() {
    // Bytes as colours, `u v`, and a face with a texture for each corner, as MeshLab writes them.
    let ply = "ply\r\nformat ascii 1.0\r\ncomment VCGLIB generated\r\nobj_info x\r\n\
        element vertex 3\r\nproperty float x\r\nproperty float y\r\nproperty float z\r\n\
        property uchar red\r\nproperty uchar green\r\nproperty uchar blue\r\nproperty uchar alpha\r\n\
        property double quality\r\nelement face 1\r\nproperty list uchar uint vertex_index\r\n\
        property list uchar float texcoord\r\nproperty int texnumber\r\nelement blob 2\r\n\
        property int x\r\nend_header\r\n\
        0 0 0 255 0 51 255 0.5\r\n1 0 0 0 0 0 255 1\r\n0 1 0 0 0 0 128 2\r\n\
        3 0 1 2 6 0 0 1 0 0 1 4\r\n1\r\n2\r\n";
    let mut file = read(FileFormat::Ply, ply.as_bytes()).unwrap();
    file.bring_all();
    let names: Vec<_> = file.mesh.public_columns().map(|(_, c)| c.name().to_owned()).collect();
    assert_eq!(names, ["color", "alpha", "quality", "uv", "texnumber"]);
    let color = file.mesh.find_column(ElementKind::Vertex, "color").unwrap();
    assert_eq!(file.mesh.value(color, 0), Some(Value::Vec3(DVec3::new(1.0, 0.0, 0.2))));
    assert_eq!(file.losses(), ["2 elements `blob`"]);

    let stl = "SOLID\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1e0 0 0\n \
        vertex 0 1 0\n endloop\n endfacet\nendsolid\nsolid b\nendsolid b\n";
    assert_eq!(read(FileFormat::Stl, stl.as_bytes()).unwrap().mesh.face_count(), 1);
    // Binary files that begin with `solid`.
    let mut bytes = write(FileFormat::Stl, &MeshFile::from_mesh(shape::icosahedron()));
    bytes[..6].copy_from_slice(b"solid ");
    assert_eq!(read(FileFormat::Stl, &bytes).unwrap().mesh.vertex_count(), 12);

    let off =
        "# a comment\nOFF # counts\n4 2\n0 0 0  1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n\n3 0 2 3\n";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.edge_count()), (4, 5));

    // Strips of triangles, as older scans have them; a number below 0 ends one.
    let strips = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n\
        property float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n5 0 1 2 3 -1\n3 2 3 4\n";
    let file = read(FileFormat::Ply, strips.as_bytes()).unwrap();
    assert_eq!((file.mesh.face_count(), file.mesh.edge_count()), (3, 7));
    let areas = file.mesh.faces().filter(|&f| !file.mesh.is_hole(f)).map(|f| file.mesh.area(f));
    assert_eq!(areas.sum::<f64>(), 1.5);
    assert_eq!(file.losses(), [""; 0]);

    // Comments that stick to numbers, what Geomview puts before, coordinates that are not three.
    let off = "appearance{ texture {\nfile x } }\nCOFF\n3 1 0\n0 0 0 1 0 0#red\n\
        1 0 0 0 1 0\n0 1 0 0 0 1 # blue\n3 0 1 2#all\n";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert!(file.mesh.find_column(ElementKind::Vertex, "color").is_some());
    assert_eq!(file.losses(), ["1 description of the appearance, first in line 1"]);
    let off = "4OFF\n3 1 0\n0 0 0 1\n4 0 0 2\n0 1 0 1\n3 0 1 2\n";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert_eq!(file.mesh.position(VertexId(1)), DVec3::X * 2.0);
    assert_eq!(file.losses(), ["1 vertex whose last coordinate divides the others"]);
    let off = "4nOFF 2\n3 1 0\n0 0 1 4 0 2 0 1 1\n3 0 1 2\n";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert_eq!(file.mesh.position(VertexId(1)), DVec3::X * 2.0);
    let off = "nOFF\n5\n3 1 0\n0 0 0 7 7 1 0 0 7 7 0 1 0 7 7\n3 0 1 2\n";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert_eq!(file.mesh.position(VertexId(2)), DVec3::Y);
    let told = "3 vertices of more than three coordinates, which have the first three";
    assert_eq!(file.losses(), [told]);

    // Letters of 16 bits.
    for is_big in [false, true] {
        let letters = "\u{feff}v 0 0 0\nv 1 0 0\nv 0 1 0\ng \u{e9}\nf 1 2 3\n".encode_utf16();
        let bytes: Vec<u8> =
            letters.flat_map(|c| if is_big { c.to_be_bytes() } else { c.to_le_bytes() }).collect();
        let file = read(FileFormat::Obj, &bytes).unwrap();
        assert!(String::from_utf8(write(FileFormat::Obj, &file)).unwrap().contains("g \u{e9}\n"));
    }

    // MuJoCo: counts, positions, normals, texture coordinates, triangles.
    let mut bytes = of_mujoco();
    let file = read(FileFormat::Msh, &bytes).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.face_count()), (3, 1));
    let uv = file.mesh.find_column(ElementKind::Vertex, "uv").unwrap();
    assert_eq!(file.mesh.value(uv, 1), Some(Value::Vec2(DVec2::new(0.5, 0.0))));
    bytes.pop();
    assert!(read(FileFormat::Msh, &bytes).is_err());

    let msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\nx\n$EndComments\n\
        $PhysicalNames\n2\n1 1 \"rim\"\n2 7 \"top\"\n$EndPhysicalNames\n\
        $Nodes\n4\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n$EndNodes\n\
        $Elements\n3\n1 1 2 1 1 10 20\n2 2 2 7 1 10 20 30\n3 4 2 9 1 10 20 30 40\n$EndElements\n\
        $NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n4\n10 1.5\n20 2\n30 3\n40 4\n$EndNodeData\n";
    let file = read(FileFormat::Msh, msh.as_bytes()).unwrap();
    let heat = file.mesh.find_column(ElementKind::Vertex, "heat").unwrap();
    assert_eq!(file.mesh.value(heat, 0), Some(Value::Real(1.5)));
    assert!(String::from_utf8(write(FileFormat::Obj, &file)).unwrap().contains("g top\nf 1 2 3"));
    let told = [
        "1 section `$Comments`, first in line 4",
        "2 elements that are neither triangles nor quads",
    ];
    assert_eq!(file.losses(), told);
    // Bytes, in blocks.
    let mut bytes = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n3\n".to_vec();
    for (tag, at) in [(1i32, [0.0f64; 3]), (2, [1.0, 0.0, 0.0]), (3, [0.0, 1.0, 0.0])] {
        bytes.extend(tag.to_le_bytes());
        at.iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    }
    bytes.extend(b"\n$EndNodes\n$Elements\n1\n");
    [2i32, 1, 2, 5, 0, 1, 1, 2, 3].iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    bytes.extend(b"\n$EndElements\n");
    assert_eq!(read(FileFormat::Msh, &bytes).unwrap().mesh.face_count(), 1);
    let mut bytes = b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n".to_vec();
    let size = |bytes: &mut Vec<u8>, x: u64| bytes.extend(x.to_le_bytes());
    let int = |bytes: &mut Vec<u8>, x: i32| bytes.extend(x.to_le_bytes());
    [1, 3, 1, 3].iter().for_each(|&x| size(&mut bytes, x));
    [2, 1, 0].iter().for_each(|&x| int(&mut bytes, x));
    [3, 1, 2, 3].iter().for_each(|&x| size(&mut bytes, x));
    [0.0f64, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        .iter()
        .for_each(|x| bytes.extend(x.to_le_bytes()));
    bytes.extend(b"\n$EndNodes\n$Elements\n");
    [1, 1, 1, 1].iter().for_each(|&x| size(&mut bytes, x));
    [2, 1, 2].iter().for_each(|&x| int(&mut bytes, x));
    [1, 1, 1, 2, 3].iter().for_each(|&x| size(&mut bytes, x));
    bytes.extend(b"\n$EndElements\n");
    assert_eq!(read(FileFormat::Msh, &bytes).unwrap().mesh.face_count(), 1);
}

#[test]
fn a_file_that_counts_from_another_number_is_told_so() {
    let places = "0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0";
    let obj = |faces: &str| format!("v {places}\n{faces}");
    let off = |faces: &str| format!("OFF\n4 2 0\n{}\n{faces}", places.replace("v ", ""));
    let told = |format, text: String| read(format, text.as_bytes()).unwrap_err();
    let error = told(FileFormat::Obj, obj("f 0 1 2\nf 0 2 3\n"));
    let start = "its faces seem to count vertices from 0, and the format counts from 1";
    assert!(error.ends_with(start), "{error}");
    let error = told(FileFormat::Off, off("3 1 2 3\n3 1 3 4\n"));
    let start = "the faces seem to count vertices from 1, and the format counts from 0";
    assert!(error.ends_with(start), "{error}");
    // Indices that are wrong from whatever number they count.
    for (format, text) in [
        (FileFormat::Obj, obj("f 0 1 2\nf 1 3 4\n")),
        (FileFormat::Obj, obj("f 1/0 2/0 3/0\n")),
        (FileFormat::Obj, obj("f 0 1 2\nf 1 3 7\n")),
        (FileFormat::Off, off("3 0 1 2\n3 1 3 4\n")),
        (FileFormat::Off, off("3 1 2 3\n3 1 3 9\n")),
    ] {
        let error = told(format, text);
        assert!(!error.contains("count vertices"), "{error}");
    }
}

#[test]
fn rows_with_more_numbers_than_declared_keep_the_others_in_place() {
    // Colours that the first line does not tell.
    let off = "OFF\n4 2 0\n0 0 0 255 0 0\n1 0 0\n1 1 0 255 # 0\n\n0 1 0 1\n3 0 1 2\n3 0 2 3";
    let file = read(FileFormat::Off, off.as_bytes()).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.face_count()), (4, 2));
    let told = "3 vertices with more than the first word of the file says, first in line 3";
    assert_eq!(file.losses(), [told]);
    let ply = |rows: &str| {
        let text = format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
             property float z\nelement face 2\nproperty list uchar uint vertex_index\nend_header\n\
             {rows}"
        );
        read(FileFormat::Ply, text.as_bytes()).unwrap()
    };
    let file = ply("0 0 0 7\r\n1 0 0 7\r\n1 1 0 7\r\n0 1 0 7\r\n3 0 1 2 9 9\r\n3 0 2 3 9\r\n");
    let area = |MeshFile { mesh, .. }: &MeshFile| {
        mesh.faces().filter(|&f| !mesh.is_hole(f)).map(|f| mesh.area(f)).sum::<f64>()
    };
    assert_eq!((file.mesh.face_count(), area(&file)), (2, 1.0));
    assert_eq!(file.losses(), ["6 lines with more than the header declares, first in line 10"]);
    // Rows that do not have lines of their own.
    for rows in [
        "0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2\n3 0 2 3\n",
        "0 0 0 1 0 0\n\n1 1 0 0\n\n1 0\n3 0 1 2 3\n0 2 3\n",
        "0 0 0 1 0 0\n1 1 0\n0 1 0\n3 0\n1 2\n3\n0 2 3\n",
        "0 0\n0 1\n0 0\n1 1\n0 0\n1 0\n3 0\n1 2\n3 0\n2 3\n",
        "0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3",
    ] {
        let file = ply(rows);
        assert_eq!((file.mesh.face_count(), area(&file)), (2, 1.0), "{rows}");
        assert_eq!(file.losses(), [""; 0]);
    }
}

#[test]
fn what_is_there_of_a_damaged_file_is_kept_on_demand() {
    let ply = |encoding: Encoding| {
        let mut file = MeshFile::from_mesh(shape::cube());
        file.encoding = encoding;
        write(FileFormat::Ply, &file)
    };
    let cut = |mut bytes: Vec<u8>, by: usize| {
        bytes.truncate(bytes.len() - by);
        bytes
    };
    let stl = write(FileFormat::Stl, &MeshFile::from_mesh(shape::icosahedron()));
    let head = "ply\nformat ascii 1.0\nmade by hand\nelement vertex 3\nproperty float x\n\
        property float y\nproperty float z\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n";
    let loop_of_four = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n\
        vertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n\
        vertex 2 0 0\nvertex 0 2 0\nvertex 0 3 0\nendloop\nendfacet\nendsolid x\n";
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    // What is told, vertices and faces that are left, damaged places.
    let cases = [
        (FileFormat::Ply, cut(ply(Encoding::Ascii), 4), "within face 6 of 6", [8, 5], 1),
        (FileFormat::Ply, cut(ply(Encoding::LittleEndian), 3), "within face 6 of 6", [8, 5], 1),
        (FileFormat::Ply, cut(ply(Encoding::BigEndian), 110), "within vertex 8 of 8", [7, 0], 1),
        (
            FileFormat::Ply,
            head.into(),
            "t:3: `made by hand` is not a line of the header",
            [3, 1],
            1,
        ),
        (FileFormat::Stl, cut(stl, 120), "20 triangles, and there is room for 17", [12, 17], 1),
        (FileFormat::Stl, loop_of_four.into(), "a loop of STL has three vertices", [3, 1], 1),
        (
            FileFormat::Stl,
            loop_of_four.replace("1 0 0", "1 x 0").replace("vertex 0 3 0\n", "").into(),
            "t:5: `x` is not a number",
            [3, 1],
            1,
        ),
        (
            FileFormat::Stl,
            loop_of_four.replace("vertex 0 3 0", "vertex 0 3 0\nvertex 1 3 0\nvertex 2 3 0").into(),
            "t:17: a loop of STL has three vertices",
            [3, 1],
            1,
        ),
        (
            FileFormat::Stl,
            loop_of_four[..loop_of_four.find("outer loop\nvertex 0 0 0\nvertex 2").unwrap()].into(),
            "the file ends before `endsolid`",
            [3, 1],
            1,
        ),
        // A loop behind the solid.
        (
            FileFormat::Stl,
            loop_of_four
                .replace(
                    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2",
                    "endsolid\nvertex 2",
                )
                .replace("vertex 0 3 0\nendloop\nendfacet\nendsolid x\n", "")
                .into(),
            "the file ends before `endsolid`",
            [3, 1],
            1,
        ),
        (
            FileFormat::Stl,
            loop_of_four.replace("vertex 0 3 0\nendloop\nendfacet\n", "").into(),
            "the file ends before `endsolid`",
            [3, 1],
            1,
        ),
        (
            FileFormat::Off,
            b"OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3".to_vec(),
            "the file ends where a vertex of a face should stand",
            [4, 1],
            1,
        ),
        (
            FileFormat::Off,
            b"STCNOFF\n4 3 0\n0 0 0 0 0 1 1 0 0 1 0 0\n1 x 0\n0 1 0 0 0 1 1 0 0 1 0 0\n\
              1 1 0 0 0 1 1 0 0 1 0 0\n3 0 2 3\n3 0 1 y 0 0\n3 0 1 2\n"
                .to_vec(),
            "t:4: `x` stands where a coordinate should",
            [3, 1],
            2,
        ),
        (
            FileFormat::Ply,
            head.replace("made by hand\n", "")
                .replace("face 1", "face 3")
                .replace("1 0 0 0 1 0\n", "\n1 x 0\n0 1 0\n")
                .replace("vertex 3", "vertex 4")
                .replace("3 0 1 2", "1 1 0\n3 0 2 3\n3 0 y 2 1\n3 0 1 2")
                .into(),
            "t:11: `x` is not a number",
            [3, 1],
            2,
        ),
        (
            FileFormat::Msh,
            b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n\
              $EndNodes\n$Elements\n4\n1 2 0 1 2 3\n2 2 0 1 2"
                .to_vec(),
            "t:13: the file ends where a number should stand",
            [3, 1],
            1,
        ),
        (
            FileFormat::Msh,
            b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                .to_vec(),
            "the section `$Nodes` does not end",
            [3, 0],
            1,
        ),
        (
            FileFormat::Off,
            b"COFF\n4 2 0\n0 0 0 1 0 0\n1 0 0 1 1 1\n0 1 0".to_vec(),
            "the file ends where",
            [3, 0],
            1,
        ),
        (
            FileFormat::Obj,
            format!("{triangle}f 1 2 x\nvn 1 y 2\nf 1 2 3\nf 2/ 4/- 3\n").into(),
            "t:5: `x` is not a corner of a face",
            [4, 1],
            3,
        ),
        (
            FileFormat::Obj,
            format!("v 1 2.\nv 0 0 3.1+e2\n{triangle}f 1 2 3\nf 3 4 5\nf 0 4 5\n").into(),
            "t:1: `v` needs three numbers; in a plane the third is 0",
            [4, 1],
            2,
        ),
    ];
    for (format, bytes, told, [vertices, faces], places) in cases {
        let error = read(format, &bytes).unwrap_err();
        assert!(error.contains(told), "{error}");
        let file = read_mesh_from("t", format, &bytes, Some(Repair::default())).unwrap();
        validate(&file.mesh).unwrap();
        assert_eq!([file.mesh.vertex_count(), file.mesh.face_count()], [vertices, faces], "{told}");
        assert_eq!(file.repaired.unwrap().damaged_places, places, "{told}");
        assert!(error.contains(&file.damage.unwrap().1), "{error}");
    }
}

#[test]
fn heads_that_claim_too_much_fail_at_once() {
    let million = "1000000000000";
    let ply = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex {million}\nproperty float x\n\
             property float y\nproperty float z\nend_header\n0 0 0\n"
        )
    };
    let mut stl = vec![b' '; 84];
    stl[80..].copy_from_slice(&u32::MAX.to_le_bytes());
    stl.extend([0; 50]);
    let msh = |version: &str, body: &str| {
        format!("$MeshFormat\n{version} 0 8\n$EndMeshFormat\n{body}").into_bytes()
    };
    let cases = [
        (FileFormat::Ply, ply("ascii").into_bytes()),
        (FileFormat::Ply, ply("binary_little_endian").into_bytes()),
        (
            FileFormat::Ply,
            ply("binary_big_endian").replace("float x", "list uint double x").into_bytes(),
        ),
        (FileFormat::Off, format!("OFF\n{million} 1 0\n0 0 0\n").into_bytes()),
        (FileFormat::Off, format!("OFF\n1 1 0\n0 0 0\n{million} 0 0 0\n").into_bytes()),
        (FileFormat::Stl, stl),
        (FileFormat::Msh, msh("2.2", &format!("$Nodes\n{million}\n1 0 0 0\n$EndNodes\n"))),
        (
            FileFormat::Msh,
            msh("2.2", &format!("$Elements\n{million}\n1 2 0 1 1 1\n$EndElements\n")),
        ),
        (
            FileFormat::Msh,
            msh("4.1", &format!("$Nodes\n1 {million} 1 1\n2 1 0 {million}\n1\n0 0 0\n")),
        ),
        (FileFormat::Msh, msh("4.1", &format!("$Entities\n0 0 {million} 0\n1 0\n"))),
    ];
    for (format, bytes) in cases {
        let start = std::time::Instant::now();
        let error = read(format, &bytes).unwrap_err();
        // Not a matter of seconds, also on a machine that has much else to do.
        assert!(start.elapsed().as_secs() < 20, "{error}");
        assert!(error.len() < 200 && !error.contains('\n'), "{error}");
    }
}

#[test]
fn unknown_endings_and_garbage_are_refused_in_words() {
    let of = |name: &str| FileFormat::of(std::path::Path::new(name)).map_err(|e| e.to_string());
    assert_eq!(of("a.PLY"), Ok(FileFormat::Ply));
    assert_eq!(of("a"), Ok(FileFormat::Obj));
    let told = "no mesh is read from or written to `.fbx`: name it .obj, .ply, .stl, .off, .msh or \
        .halfedges";
    assert_eq!(of("a.fbx"), Err(told.into()));
    let cases = [
        (FileFormat::Ply, "", "t:1: the head does not end: `end_header` is missing"),
        (FileFormat::Ply, "plx\n", "t:1: a PLY file begins with a line `ply`"),
        (
            FileFormat::Ply,
            "ply\nformat ascii 1.0\nelement vertex x\n",
            "t:3: `element vertex x` is not a line of the header of a PLY file",
        ),
        (FileFormat::Stl, "hello", "t: this is no STL file: it is too short"),
        (FileFormat::Stl, "solid\nvertex 1 2\n", "t:2: `vertex` needs three numbers"),
        (FileFormat::Off, "OFX\n", "t:1: `OFX` is not `OFF`, with a prefix or without"),
        (FileFormat::Off, "XOFF\n", "t:1: `XOFF` is not `OFF`, with a prefix or without"),
        (FileFormat::Off, "nOFF 0\n", "t:1: 0 is not a number of coordinates"),
        (FileFormat::Off, "appearance {\nOFF", "t:2: the braces of `appearance` do not end"),
        (
            FileFormat::Off,
            "4OFF\n3 1 0\n0 0 0 1 1 0 0 0 0 1 0 2\n3 0 1 2\n",
            "t:3: vertex 2 has a coordinate that is not a finite number",
        ),
        (FileFormat::Off, "OFF\n1 0 0\n0 x 0\n", "t:3: `x` stands where a coordinate should"),
        (
            FileFormat::Off,
            "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 3\n",
            "t:4: there is no vertex 3: there are 3, counted from 0",
        ),
        (FileFormat::Msh, "$Nodes\n", "t:2: a Gmsh file begins with `$MeshFormat`"),
        (
            FileFormat::Msh,
            "$MeshFormat\n4.0 0 8\n$EndMeshFormat\n",
            "t:2: version 4 of Gmsh files is not read: 2.2 and 4.1 are",
        ),
    ];
    for (format, text, told) in cases {
        assert_eq!(read(format, text.as_bytes()).unwrap_err(), told);
    }
}

/// The same everywhere: a linear congruence (Knuth's constants), its upper half.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 33) as usize) % sides.max(1)
    }
}

/// Small files of each format, some bytes changed: whatever comes of it, it is answered, and what
/// is read is a mesh that is written and read again as it is. For longer, from another seed:
///
///     HEDGEROW_FUZZ=1000000 HEDGEROW_SEED=9 cargo test --release --test mesh mutated
#[test]
fn mutated_files_are_answered() {
    let mut seeds = Vec::new();
    for mesh in [attributed(shape::tetrahedron()), shape::icosahedron(), shape::tube(3, 1)] {
        for format in FileFormat::ALL {
            for (encoding, version) in
                ENCODINGS.into_iter().zip([MshVersion::V2, MshVersion::V4, MshVersion::V4])
            {
                let mut file = MeshFile::from_mesh(mesh.clone());
                (file.encoding, file.msh_version) = (encoding, version);
                let mut bytes = Vec::new();
                if write_mesh_to(&mut bytes, format, &file).is_ok() {
                    seeds.push((format, bytes));
                }
            }
        }
    }
    seeds.push((FileFormat::Obj, OBJ.as_bytes().to_vec()));
    let letters = OBJ.encode_utf16().flat_map(u16::to_le_bytes);
    seeds.push((FileFormat::Obj, b"\xff\xfe".iter().copied().chain(letters).collect()));
    seeds.push((FileFormat::Msh, of_mujoco()));
    let off = "appearance { }\nSTCN4nOFF 2 3 1 0\n\
        0 0 1 0 0 1 1 0 0 1 0 0\n1 0 1 0 0 1 0 1 0 1 1 0\n0 1 2 0 0 1 0 0 1 1 0 1\n3 0 1 2 1 1 0\n";
    seeds.push((FileFormat::Off, off.as_bytes().to_vec()));
    let words: [&[u8]; 12] = [
        b"-1",
        b"1e999",
        b"nan",
        b"999999999999",
        b"\n",
        b" ",
        b"\\\n",
        b"#",
        b"list",
        b"\"",
        b"$End",
        b"f 1 2 3\n",
    ];
    let setting = |name: &str, otherwise: u64| {
        std::env::var(name).map_or(otherwise, |value| value.parse().expect("a number"))
    };
    let turns = setting("HEDGEROW_FUZZ", 6000) as usize;
    let mut dice = Dice(setting("HEDGEROW_SEED", 7));
    let (mut read, mut refused) = (0, 0);
    for turn in 0..turns {
        let (format, seed) = &seeds[turn % seeds.len()];
        let mut bytes = seed.clone();
        for _ in 0..1 + dice.roll(2) {
            let at = dice.roll(bytes.len());
            match dice.roll(5) {
                0 => bytes[at] = dice.roll(256) as u8,
                1 => bytes[at] ^= 1 << dice.roll(8),
                2 => bytes.truncate(at.max(1)),
                3 => drop(bytes.splice(at..at, words[dice.roll(words.len())].iter().copied())),
                _ => {
                    let end = (at + dice.roll(20)).min(bytes.len());
                    bytes.drain(at..end);
                }
            }
            if bytes.is_empty() {
                bytes.push(b'x');
            }
        }
        let repair = (turn % 2 == 0).then_some(Repair { merge: (turn % 4 == 0).then_some(0.0) });
        match read_mesh_from("t", *format, &bytes, repair) {
            Ok(file) => {
                read += 1;
                assert_eq!(validate(&file.mesh), Ok(()), "{format} {turn}");
                let mut text = Vec::new();
                if write_mesh_to(&mut text, *format, &file).is_ok() {
                    // A file of points joins again what was split.
                    let again = repair.filter(|_| *format == FileFormat::Stl);
                    let back = read_mesh_from("t", *format, &text, again);
                    let back = back.map_err(|error| panic!("{format} {turn}: {error}")).unwrap();
                    let is_stl = *format == FileFormat::Stl;
                    assert!(is_stl || same_connectivity(&file.mesh, &back.mesh), "{format} {turn}");
                }
            }
            Err(error) => {
                refused += 1;
                let is_mendable = error.is_mendable();
                assert!(!(is_mendable && repair.is_some()), "{format} {turn}: {error}");
            }
        }
    }
    assert!(read * 12 > turns && refused * 6 > turns, "{read} {refused}");
}

/// The sign of what is not a number depends on how it was computed; in a file it does not.
#[test]
fn what_is_not_a_number_is_written_in_one_form() {
    for format in [FileFormat::Ply, FileFormat::Obj, FileFormat::Halfedges] {
        for encoding in ENCODINGS {
            let [one, other] = [f64::NAN, -f64::NAN].map(|nan| {
                let mut mesh = shape::cube();
                let weight = Value::Vec2(DVec2::new(nan, 1.0));
                mesh.add_column(ElementKind::Vertex, "weight", weight).unwrap();
                mesh.add_column(ElementKind::Face, "size", Value::Real(nan)).unwrap();
                let mut file = MeshFile::from_mesh(mesh);
                file.encoding = encoding;
                write(format, &file)
            });
            assert!(one == other, "{format}");
        }
    }
}
