//! Parts of files that are not in the mesh: each is reported, refused or written back.

use hedgerow::mesh::{Encoding, FileFormat, Repair, read_mesh_from};

use crate::files::{read, write};

/// What is reported of a file that is read.
fn told(format: FileFormat, bytes: &[u8]) -> Vec<String> {
    read(format, bytes).unwrap().losses()
}

/// A triangle and an isolated vertex, with further elements and rows.
fn ply(elements: &str, rows: &str) -> Vec<u8> {
    let head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_indices\n";
    let body = "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n";
    format!("{head}{elements}{body}{rows}").into_bytes()
}

#[test]
fn edges_that_no_face_has_are_reported() {
    let edges = |rows: &str| {
        let ends = "property int vertex1\nproperty int vertex2\n";
        let count = rows.lines().count();
        [format!("element edge {count}\n{ends}property uchar sharp\n"), rows.to_owned()]
    };
    let cases = [
        ("0 1 1\n2 0 0\n", None),
        ("0 3 1\n", Some("1 edge that no face has, first in row 1")),
        ("0 1 1\n0 7 1\n-1 2 1\n", Some("2 edges that no face has, first in row 2")),
    ];
    for (rows, expected) in cases {
        let [elements, rows] = edges(rows);
        let bare = elements.replace("property uchar sharp\n", "");
        let without: String =
            rows.lines().map(|row| format!("{}\n", &row[..row.len() - 2])).collect();
        for bytes in [ply(&elements, &rows), ply(&bare, &without)] {
            assert_eq!(told(FileFormat::Ply, &bytes), Vec::from_iter(expected));
            let repaired = read_mesh_from("t", FileFormat::Ply, &bytes, Some(Repair::default()));
            assert_eq!(repaired.unwrap().losses(), Vec::from_iter(expected));
        }
    }
    let lists = "element edge 2\nproperty list uchar int vertex_indices\n";
    let expected = "2 elements `edge` without `vertex1` and `vertex2`";
    assert_eq!(told(FileFormat::Ply, &ply(lists, "2 0 1\n2 1 2\n")), [expected]);
}

#[test]
fn what_follows_the_last_element_is_reported() {
    let line = "1 line behind the last element that the header declares, first in line 15";
    let lines = "2 lines behind the last element that the header declares, first in line 15";
    let cases =
        [("", None), ("\n \n", None), ("3 0 3 1\n", Some(line)), ("3 0 3 1\n\nx", Some(lines))];
    for (rows, expected) in cases {
        assert_eq!(told(FileFormat::Ply, &ply("", rows)), Vec::from_iter(expected));
    }
    let off = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n\nx\n";
    assert_eq!(told(FileFormat::Off, off), ["2 lines behind the last face, first in line 7"]);

    let one = read(FileFormat::Ply, &ply("", "")).unwrap();
    for (format, element) in [(FileFormat::Ply, "element"), (FileFormat::Stl, "triangle")] {
        let mut file = one.clone();
        file.encoding = Encoding::LittleEndian;
        let mut bytes = write(format, &file);
        bytes.push(b'\n');
        assert_eq!(told(format, &bytes), [""; 0]);
        bytes.extend([1; 49]);
        let expected = format!("50 bytes behind the last {element} that the header declares");
        assert_eq!(told(format, &bytes), [expected]);
    }
}

#[test]
fn what_is_there_twice_is_refused() {
    let ply = |element: &str| {
        read(FileFormat::Ply, &ply(&format!("element {element} 1\n"), "")).unwrap_err()
    };
    assert_eq!(ply("vertex"), "t:9: the element `vertex` is there twice");
    assert_eq!(ply("face"), "t:9: the element `face` is there twice");
    let msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n7 0 0 0\n7 1 0 0\n$EndNodes\n";
    assert_eq!(read(FileFormat::Msh, msh.as_bytes()).unwrap_err(), "t:7: node 7 is there twice");
}

#[test]
fn comments_of_ply_are_written_back() {
    let comments = "comment TextureFile a.png\nobj_info made by  hand\ncomment\n\
        comment attribute of a mesh\ncomment material 1 of two\ncomment \u{e9}\n\
        comment group 0 by name\n";
    let mut file = read(FileFormat::Ply, &ply(comments, "")).unwrap();
    assert_eq!(file.losses(), [""; 0]);
    for encoding in [Encoding::Ascii, Encoding::BigEndian] {
        file.encoding = encoding;
        let written = write(FileFormat::Ply, &file);
        let text = String::from_utf8_lossy(&written);
        assert!(text.contains(&format!(" 1.0\n{comments}element vertex")), "{text}");
        assert_eq!(write(FileFormat::Ply, &read(FileFormat::Ply, &written).unwrap()), written);
    }
}

#[test]
fn signs_and_comments_are_no_reason_to_refuse_a_file() {
    let obj = "v +1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nf +1/+1 2 -1/1\n";
    let file = read(FileFormat::Obj, obj.as_bytes()).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.edge_count()), (3, 3));
    for corner in ["+", "+-1", "-+1", "1/+", "++1"] {
        let error = read(FileFormat::Obj, obj.replace("+1/+1", corner).as_bytes()).unwrap_err();
        assert_eq!(error, format!("t:5: `{corner}` is not a corner of a face"));
    }
    let msh = "$Comments\nx\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
        $Nodes\n1\n1 0 0 0\n$EndNodes\n";
    let told = told(FileFormat::Msh, msh.as_bytes());
    assert_eq!(told, ["1 section `$Comments`, first in line 1"]);
}
