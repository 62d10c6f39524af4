//! Meshes that are read in an order in which neighbors stand near each other: the file written is
//! the same, numbers lead to the same elements, and neighbors are near.

use std::path::Path;

use hedgerow::mesh::{
    ElementKind, FileFormat, Mesh, MeshFile, Polygons, Repair, equal_up_to_renumbering, read_mesh,
    read_mesh_from, read_mesh_reordered, shape, validate, write_mesh_to,
};

use super::files::attributed;

fn written(format: FileFormat, file: &MeshFile) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_mesh_to(&mut bytes, format, file).unwrap();
    bytes
}

/// A mesh with its vertices and faces in a scattered order.
fn scattered(mesh: &Mesh) -> Mesh {
    let (positions, polygons) = mesh.to_polygons();
    let count = positions.len();
    // A number without a factor in common with the count goes through all.
    let step = (count / 3..).find(|&step| gcd(step, count) == 1).unwrap();
    let vertices: Vec<usize> = (0..count).map(|v| v * step % count).collect();
    let mut numbers = vec![0; count];
    (0..).zip(&vertices).for_each(|(number, &v)| numbers[v] = number);
    let mut faces: Vec<Vec<u32>> = polygons
        .iter()
        .map(|corners| corners.iter().map(|&v| numbers[v as usize]).collect())
        .collect();
    faces.sort_by_key(|corners| (corners[0].wrapping_mul(0x9e37_79b9), corners[1]));
    let positions: Vec<_> = vertices.iter().map(|&v| positions[v]).collect();
    Mesh::from_polygons(&positions, &faces.iter().collect::<Polygons>()).unwrap()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Reads a file as it stands and reordered, which is the same to who reads what is written.
fn read_both(path: &Path, repair: Option<Repair>) -> [MeshFile; 2] {
    let plain = read_mesh(path, repair).unwrap();
    let reordered = read_mesh_reordered(path, repair).unwrap();
    validate(&reordered.mesh).unwrap();
    let format = FileFormat::of(path).unwrap();
    let texts = [&plain, &reordered].map(|file| written(format, file));
    // Edges, and the parts of a face that was divided, have another order.
    let has_order = format != FileFormat::Ply && repair.is_none();
    assert!(!has_order || texts[0] == texts[1], "{}", path.display());
    let again = texts.map(|text| read_mesh_from("t", format, &text, None).unwrap().mesh);
    assert!(equal_up_to_renumbering(&again[0], &again[1]), "{}", path.display());
    for kind in ElementKind::ALL {
        assert_eq!(plain.mesh.count(kind), reordered.mesh.count(kind));
    }
    for v in reordered.mesh.vertices() {
        let number = reordered.vertex_number(v);
        assert_eq!(number.and_then(|number| reordered.vertex_by_number(number)), number.map(|_| v));
        let there = number.and_then(|number| plain.vertex_by_number(number));
        let there = there.map(|there| plain.mesh.position(there));
        assert!(there.is_none_or(|there| there == reordered.mesh.position(v)));
    }
    for f in reordered.mesh.faces().filter(|&f| !reordered.mesh.is_hole(f)) {
        let number = reordered.face_number(f).unwrap();
        // Of several parts the first.
        let first = reordered.face_by_number(number).unwrap();
        assert_eq!(reordered.face_number(first), Some(number));
    }
    [plain, reordered]
}

#[test]
fn what_is_written_is_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let grid = shape::grid(7, 5);
    for mesh in [attributed(scattered(&grid)), attributed(scattered(&shape::triangle_torus(9, 7)))]
    {
        let file = MeshFile::from_mesh(mesh);
        for name in ["a.obj", "a.ply", "a.off", "a.msh"] {
            let path = folder.path().join(name);
            std::fs::write(&path, written(FileFormat::of(&path).unwrap(), &file)).unwrap();
            let [plain, reordered] = read_both(&path, None);
            assert_ne!(plain.mesh.positions(), reordered.mesh.positions());
            assert!(reordered.repaired.is_none());
        }
    }
}

#[test]
fn groups_and_texture_coordinates_stay_where_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    let text = "v 5 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 5 1 0\n\
        vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\ng far\nusemtl red\nf 3/1 1/2 6/3 5/4\ng near\nf 2/1 3/2 4/3\n\
        usemtl blue\nf 3/2 5/4 4/3\n";
    std::fs::write(&path, text).unwrap();
    let [_, reordered] = read_both(&path, None);
    assert_eq!(reordered.face_by_number(1).and_then(|f| reordered.face_number(f)), Some(1));
}

#[test]
fn repaired_polygons_stay_repaired() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    // Two triangles that meet in a vertex, one twice, a vertex that lies nowhere, a third at an edge.
    let text = "v 9 0 0\nv 0 0 0\nv 1 0 0\nv nan 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 1\n\
        f 2 3 5\nf 2 6 7\nf 7 2 6\nf 3 2 7\nf 2 3 8\n";
    std::fs::write(&path, text).unwrap();
    assert!(read_mesh_reordered(&path, None).is_err());
    let [plain, reordered] = read_both(&path, Some(Repair::default()));
    assert_eq!(plain.repaired, reordered.repaired);
    assert!(plain.repaired.is_some_and(|report| report.is_changed()));
}

/// Half of all pairs of numbers are no farther apart.
fn middle(pairs: impl Iterator<Item = (u32, u32)>) -> u32 {
    let mut apart: Vec<u32> = pairs.map(|(a, b)| a.abs_diff(b)).collect();
    apart.sort_unstable();
    apart[apart.len() / 2]
}

#[test]
fn neighbors_are_near() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.obj");
    let file = MeshFile::from_mesh(scattered(&shape::triangle_torus(80, 61)));
    std::fs::write(&path, written(FileFormat::Obj, &file)).unwrap();
    let both = read_both(&path, None).map(|file| file.mesh);
    let ends = both
        .each_ref()
        .map(|mesh| middle(mesh.halfedges().map(|h| (mesh.vertex(h).0, mesh.target(h).0))));
    assert!(ends[1] * 8 < ends[0], "{ends:?}");
    let twins = both.each_ref().map(|mesh| middle(mesh.halfedges().map(|h| (h.0, mesh.twin(h).0))));
    assert!(twins[1] * 8 < twins[0], "{twins:?}");
}
