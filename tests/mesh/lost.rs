//! Parts of files that are not in the mesh: each is reported, refused or written back.

use hedgerow::mesh::{FileFormat, MeshFile, Repair, read_mesh_from};

fn read(format: FileFormat, bytes: &[u8]) -> Result<MeshFile, String> {
    read_mesh_from("t", format, bytes, None).map_err(|error| error.to_string())
}

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
fn signs_and_comments_are_no_reason_to_refuse_a_file() {
    let obj = "v +1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nf +1/+1 2 -1/1\n";
    let file = read(FileFormat::Obj, obj.as_bytes()).unwrap();
    assert_eq!((file.mesh.vertex_count(), file.mesh.edge_count()), (3, 3));
    for corner in ["+", "+-1", "-+1", "1/+", "++1"] {
        let error = read(FileFormat::Obj, obj.replace("+1/+1", corner).as_bytes()).unwrap_err();
        assert_eq!(error, format!("t:5: `{corner}` is not a corner of a face"));
    }
    let msh = "$Comments\nx\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    let told = told(FileFormat::Msh, msh.as_bytes());
    assert_eq!(told, ["1 section `$Comments`, first in line 1"]);
}
