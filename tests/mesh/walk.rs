//! Walks around faces and vertices.

use hedgerow::mesh::{ElementKind, FaceId, HalfedgeId, VertexId, shape};

#[test]
fn a_walk_on_a_broken_mesh_ends() {
    let mut mesh = shape::tetrahedron();
    // 0 -> 1 -> 2 -> 1 -> ... never comes back to 0.
    let h = mesh.next(HalfedgeId(0));
    mesh.set_next(mesh.next(h), h);
    assert_eq!(mesh.loop_from(HalfedgeId(0)).count(), mesh.halfedge_count());
    mesh.set_prev(HalfedgeId(0), HalfedgeId(99));
    assert_eq!(mesh.spokes_from(HalfedgeId(0)).count(), 1);
    assert_eq!(mesh.spokes_from(HalfedgeId::NONE).count(), 0);
}

#[test]
fn spokes_run_counterclockwise() {
    let mesh = shape::fan(5);
    let around: Vec<u32> = mesh.neighbors(VertexId(0)).map(|v| v.0).collect();
    let first = around.iter().position(|&v| v == 1).unwrap();
    let turned: Vec<u32> = (0..5).map(|i| around[(first + i) % 5]).collect();
    assert_eq!(turned, [1, 2, 3, 4, 5]);
}

#[test]
fn neighbors_are_adjacent_and_others_are_not() {
    let mesh = shape::octahedron();
    for v in mesh.vertices() {
        let around: Vec<VertexId> = mesh.neighbors(v).collect();
        assert_eq!(around.len(), 4);
        for w in mesh.vertices() {
            assert_eq!(mesh.adjacent(v, w), around.contains(&w));
        }
    }
}

#[test]
fn an_element_is_written_as_its_number() {
    let ids = (VertexId(3), HalfedgeId(0), FaceId::NONE, ElementKind::Edge);
    let text = serde_json::to_string(&ids).unwrap();
    assert_eq!(text, "[3,0,4294967295,\"edge\"]");
    assert_eq!(
        serde_json::from_str::<(VertexId, HalfedgeId, FaceId, ElementKind)>(&text).unwrap(),
        ids
    );
}
