//! Files as their formats mean them: what other programs wrote is understood, and what is written
//! means the same to them.

use glam::DVec3;
use hedgerow::mesh::{
    ElementKind, Encoding, FileFormat, Mesh, MeshFile, Repair, Value, read_mesh_from, shape,
};

use crate::files::{of_mujoco, read, write};

/// A text as bytes of UTF-8 with a byte order mark, and of UTF-16 in both orders.
fn marked(text: &str) -> [Vec<u8>; 3] {
    let text = format!("\u{feff}{text}");
    let letters = || text.encode_utf16();
    [
        text.clone().into_bytes(),
        letters().flat_map(u16::to_le_bytes).collect(),
        letters().flat_map(u16::to_be_bytes).collect(),
    ]
}

fn text(format: FileFormat, file: &MeshFile) -> String {
    String::from_utf8(write(format, file)).unwrap()
}

fn value(mesh: &Mesh, kind: ElementKind, name: &str, index: u32) -> Option<Value> {
    mesh.value(mesh.find_column(kind, name)?, index)
}

fn repaired(format: FileFormat, bytes: &[u8]) -> Result<MeshFile, String> {
    read_mesh_from("t", format, bytes, Some(Repair::default())).map_err(|error| error.to_string())
}

#[test]
fn text_is_no_binary_stl() {
    let mut file = MeshFile::from_mesh(shape::icosahedron());
    file.encoding = Encoding::Ascii;
    let stl = text(FileFormat::Stl, &file);
    for bytes in marked(&stl) {
        let file = read(FileFormat::Stl, &bytes).unwrap();
        assert_eq!((file.mesh.vertex_count(), file.mesh.face_count()), (12, 20));
    }
    // Numbers of triangles made of letters are no damage that a repair passes over.
    for other in [&stl["solid hedgerow".len()..], &"<!DOCTYPE html>\n".repeat(30)] {
        let told = "t: this is no STL file: it is a text that does not begin with `solid`";
        assert_eq!(read(FileFormat::Stl, other.as_bytes()).unwrap_err(), told);
        assert_eq!(repaired(FileFormat::Stl, other.as_bytes()).unwrap_err(), told);
    }
    // A program that did not know their number in advance.
    file.encoding = Encoding::LittleEndian;
    let mut bytes = write(FileFormat::Stl, &file);
    bytes[80..84].fill(0);
    let told = "t: its header declares 0 triangles, and there is room for 20";
    assert_eq!(read(FileFormat::Stl, &bytes).unwrap_err(), told);
    assert_eq!(repaired(FileFormat::Stl, &bytes).unwrap().mesh.face_count(), 20);
}

#[test]
fn colours_of_off_have_a_point_or_are_bytes() {
    let mut mesh = shape::icosahedron();
    let red = Value::Vec3(DVec3::X);
    for kind in [ElementKind::Vertex, ElementKind::Face] {
        mesh.add_column(kind, "color", red).unwrap();
    }
    let written = text(FileFormat::Off, &MeshFile::from_mesh(mesh));
    assert_eq!(written.matches(" 1.0 0.0 0.0 1.0\n").count(), 12, "{written}");
    assert_eq!(written.matches(" 1.0 0.0 0.0\n").count(), 20, "{written}");
    let off = |colour: &str| {
        let head = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
        let text = format!("{head}3 0 1 2 {colour}\n3 0 2 3 0 0 1\n");
        let file = read(FileFormat::Off, text.as_bytes()).unwrap();
        (value(&file.mesh, ElementKind::Face, "color", 0), file.losses())
    };
    assert_eq!(off("1 0 0"), (Some(Value::Vec3(DVec3::X / 255.0)), vec![]));
    assert_eq!(off("1.0 0 0"), (Some(red), vec![]));
    assert_eq!(off("1 0. 0 1"), (Some(red), vec![]));
    assert_eq!(off("255 0 0"), (Some(red), vec![]));
    assert_eq!(off("255 0 0 oops").1, ["1 face with a word behind it, first in line 7"]);
}

#[test]
fn heads_of_off_are_taken_as_they_are_found() {
    let body = "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
    for head in ["OFF3 1 0\n", "off\n3 1 0\n", "COFF3 1 0\n", "3 1 0\n", "# c\n\nOFF 3 1\n"] {
        let bytes = format!("{head}{body}").into_bytes();
        assert_eq!(read(FileFormat::Off, &bytes).unwrap().mesh.face_count(), 1, "{head}");
        assert_eq!(FileFormat::of_bytes(&bytes), FileFormat::Off, "{head}");
    }
}

#[test]
fn formats_are_known_by_their_first_bytes() {
    let file = MeshFile::from_mesh(shape::icosahedron());
    let mut stl = write(FileFormat::Stl, &file);
    stl.extend([0; 3]);
    let msh = [b"$Comments\nx\n$EndComments\n", &write(FileFormat::Msh, &file)[..]].concat();
    let halfedges = [b"# c\n\n", &write(FileFormat::Halfedges, &file)[..]].concat();
    let ply = [b"\xef\xbb\xbf", &write(FileFormat::Ply, &file)[..]].concat();
    let cases = [
        (FileFormat::Stl, stl),
        (FileFormat::Msh, msh),
        (FileFormat::Msh, of_mujoco()),
        (FileFormat::Halfedges, halfedges),
        (FileFormat::Ply, ply),
        (FileFormat::Obj, write(FileFormat::Obj, &file)),
        (FileFormat::Obj, b"mtllib a\n".to_vec()),
        (FileFormat::Obj, Vec::new()),
    ];
    for (format, bytes) in cases {
        assert_eq!(FileFormat::of_bytes(&bytes), format);
    }
    for format in FileFormat::ALL {
        let packed = read(format, b"\x1f\x8b\x08\0").unwrap_err();
        assert_eq!(packed, "t: it is compressed: unpack it first");
    }
    let ending = FileFormat::of(std::path::Path::new("a.obj.gz")).unwrap_err().to_string();
    assert_eq!(ending, "no compressed mesh (`.gz`) is read or written: unpack it first");
}

#[test]
fn groups_of_gmsh_keep_their_numbers() {
    let old = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 30 \"inlet\"\n\
        2 7 \"wall\"\n2 9 \"wall\"\n$EndPhysicalNames\n$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 1 1 0\n\
        40 0 1 0\n50 -1 0 0\n$EndNodes\n$Elements\n4\n1 2 2 7 1 10 20 30\n2 2 2 30 1 10 30 40\n\
        3 2 2 5 1 10 40 50\n4 2 2 9 1 10 50 20\n$EndElements\n";
    let new = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"wall\"\n\
        $EndPhysicalNames\n$Entities\n0 0 2 0\n1 0 0 0 1 1 0 1 7 0\n2 0 0 0 1 1 0 1 5 0\n\
        $EndEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n\
        $Elements\n2 2 1 2\n2 1 2 1\n1 1 2 3\n2 2 2 1\n2 1 3 4\n$EndElements\n";
    let told = "1 group with the name of another one, which its number is now, first in line 8";
    for (msh, losses) in [(old, vec![told]), (new, vec![])] {
        let mut file = read(FileFormat::Msh, msh.as_bytes()).unwrap();
        assert_eq!(file.losses(), losses);
        let written = text(FileFormat::Msh, &file);
        let back = read(FileFormat::Msh, written.as_bytes()).unwrap();
        assert_eq!(text(FileFormat::Msh, &back), written);
        if msh == old {
            assert!(
                written.contains("$PhysicalNames\n2\n2 7 \"wall\"\n2 30 \"inlet\"\n"),
                "{written}"
            );
            for element in ["1 2 2 7 2 1 2 3", "2 2 2 30 3 ", "3 2 2 5 4 ", "4 2 2 9 5 "] {
                assert!(written.contains(&format!("\n{element}")), "{written}");
            }
        } else {
            assert!(written.contains("$PhysicalNames\n1\n2 7 \"wall\"\n"), "{written}");
            assert!(written.contains(" 1 7 0\n") && written.contains(" 1 5 0\n"), "{written}");
        }
        // Groups of an OBJ file get the numbers that are free.
        let obj = text(FileFormat::Obj, &file).replace("g wall", "g rim");
        file = read(FileFormat::Obj, obj.as_bytes()).unwrap();
        assert!(text(FileFormat::Msh, &file).contains("\n2 1 \"rim\"\n"), "{obj}");
    }
}

#[test]
fn sections_of_gmsh_without_values_take_no_memory() {
    let head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n";
    let section = |name: &str, values: &str| {
        format!("$NodeData\n1\n\"{name}\"\n1\n0\n3\n0\n1\n{values}\n$EndNodeData\n")
    };
    let msh = [head, &section("none", "0"), &section("one", "1\n1 5")].concat();
    let file = read(FileFormat::Msh, msh.as_bytes()).unwrap();
    let names: Vec<_> = file.mesh.public_columns().map(|(_, column)| column.name()).collect();
    assert_eq!(names, ["one"]);
}

#[test]
fn properties_of_ply_keep_their_values_whatever_else_there_is() {
    let names = "s t u v a-b a_b color red green blue";
    let properties: String =
        names.split(' ').map(|name| format!("property float {name}\n")).collect();
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\n{properties}element face 1\nproperty list uchar int vertex_indices\n\
         end_header\n{}3 0 1 2\n",
        ["0 0", "1 0", "0 1"].map(|at| format!("{at} 0 1 2 3 4 5 6 7 8 9 10\n")).concat()
    );
    let mut file = read(FileFormat::Ply, ply.as_bytes()).unwrap();
    let told = [
        "1 vertex attribute that is `color_` now, since another is `color`",
        "1 vertex attribute that is `a_b_` now, since another is `a_b`",
    ];
    assert_eq!(file.losses(), told);
    for _ in 0..2 {
        let at = |name| value(&file.mesh, ElementKind::Vertex, name, 0);
        assert_eq!(at("uv"), Some(Value::Vec2(glam::DVec2::new(1.0, 2.0))));
        assert_eq!(at("color"), Some(Value::Vec3(DVec3::new(8.0, 9.0, 10.0))));
        for (name, real) in [("u", 3.0), ("v", 4.0), ("a_b_", 5.0), ("a_b", 6.0), ("color_", 7.0)] {
            assert_eq!(at(name), Some(Value::Real(real)), "{name}");
        }
        file = read(FileFormat::Ply, &write(FileFormat::Ply, &file)).unwrap();
    }
}

#[test]
fn faces_without_texture_coordinates_and_normals_stay_without() {
    let points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (rows, corner) in [
        ("vt 0.5 0.5\nvn 0 0 1\n", "1/1"),
        ("vt 0.5 0.5 1\nvn 0 0 1\n", "1/1"),
        ("vt 0.5 0.5\n", "1/"),
        ("vn 0 0 1\n", "/1"),
    ] {
        let face = format!("f 1/{corner} 2/{corner} 3/{corner}\n").replace("/ ", " ");
        let obj = format!("{points}{rows}{}f 1 3 4\n", face.replace("/\n", "\n"));
        let mut file = read(FileFormat::Obj, obj.as_bytes()).unwrap();
        assert_eq!(text(FileFormat::Obj, &file), obj);
        for encoding in [Encoding::Ascii, Encoding::BigEndian] {
            file.encoding = encoding;
            let ply = read(FileFormat::Ply, &write(FileFormat::Ply, &file)).unwrap();
            assert_eq!(text(FileFormat::Obj, &ply), obj);
            assert_eq!(ply.losses(), [""; 0]);
            let [texture, normals] = ply.bare_faces();
            assert_eq!(texture.without, usize::from(rows.contains("vt")));
            assert_eq!(normals.without, usize::from(rows.contains("vn")));
        }
    }
    let part = format!("{points}vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3\nf 1/1 3/1 4/1\n");
    let [texture, normals] = read(FileFormat::Obj, part.as_bytes()).unwrap().bare_faces();
    assert_eq!([texture.new, texture.partial, texture.without], [0, 1, 0]);
    assert_eq!([normals.new, normals.partial, normals.without], [0, 1, 1]);
}

#[test]
fn names_are_bytes() {
    let obj = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng caf\xe9\nf 1 2 3\ng caf\xe8\nf 1 3 4\n";
    let file = read(FileFormat::Obj, obj).unwrap();
    let ply = read(FileFormat::Ply, &write(FileFormat::Ply, &file)).unwrap();
    assert_eq!(write(FileFormat::Obj, &ply), obj);
}

#[test]
fn what_an_obj_file_cannot_take_back_is_told() {
    let ply = "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment object 0 A\n\
        comment material 0 red\nelement vertex 4\nproperty float x\nproperty float y\n\
        property float z\nelement face 2\nproperty list uchar int vertex_indices\n\
        property int object\nproperty int material\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\
        3 0 1 2 0 -1\n3 0 2 3 -1 0\n";
    let file = read(FileFormat::Ply, ply.as_bytes()).unwrap();
    assert_eq!(file.overruled_faces(), [1, 0]);
    assert_eq!(file.lost_groups(FileFormat::Obj), ["texture files"]);
    assert_eq!(file.lost_groups(FileFormat::Ply), [""; 0]);
}
