//! Meshes as arrays.

use glam::DVec3;
use hedgerow::mesh::{Mesh, Polygons, VertexId, same_up_to_renumbering, shape};

#[test]
fn a_mesh_goes_to_arrays_and_back() {
    let mut mesh = shape::octahedron();
    let (positions, triangles) = mesh.to_triangles().expect("it has triangles only");
    assert_eq!((positions.len(), triangles.len()), (6, 8));
    let back = Mesh::from_triangles(&positions, &triangles).unwrap();
    assert!(same_up_to_renumbering(&mesh, &back, 0.0));
    // Dead slots are left out.
    let alone = mesh.add_vertex();
    let kept = mesh.add_vertex();
    mesh.erase_vertex(alone);
    mesh.set_position(kept, DVec3::X);
    let (positions, _) = mesh.to_polygons();
    assert_eq!((positions.len(), positions[6]), (7, DVec3::X));
    assert_eq!(mesh.positions()[VertexId(7).index()], DVec3::X);
    assert!(shape::cube().to_triangles().is_err());
}

#[test]
fn parts_are_looked_at() {
    let parts = |ends: &[usize]| Polygons::from_parts(vec![0, 1, 2, 3], ends.to_vec());
    assert_eq!(parts(&[4]), Some([[0, 1, 2, 3]].into_iter().collect()));
    assert!(parts(&[3]).is_none() && parts(&[4, 3]).is_none() && parts(&[5]).is_none());
    assert!(parts(&[]).is_none() && Polygons::from_parts(vec![], vec![]).is_some());
}
