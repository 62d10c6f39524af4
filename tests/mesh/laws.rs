//! Every law fails on a mesh that is broken in just its way, and says so in words.

use hedgerow::mesh::validate::{
    edges_are_orbits, faces_are_orbits, next_is_permutation, nothing_points_at_the_dead,
    positions_are_finite, twin_is_involution, vertices_are_orbits,
};
use hedgerow::mesh::{
    BelowLevel, EdgeId, ElementKind, FaceId, HalfedgeId, Invalid, Level, Mesh, Polygons, Summary,
    VertexId, shape, validate, validate_level,
};

fn said(result: Result<(), Invalid>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn nothing_points_at_the_dead_fails() {
    let mut mesh = shape::cube();
    mesh.erase_face(FaceId(2));
    let found = said(nothing_points_at_the_dead(&mesh));
    assert_eq!(found, "the `face` of halfedge 8 is face 2, which does not exist");
    assert!(validate(&mesh).is_err());
    let mut mesh = shape::cube();
    mesh.set_twin(HalfedgeId(3), HalfedgeId::NONE);
    assert_eq!(said(validate(&mesh)), "halfedge 3 has no `twin`");
}

#[test]
fn next_is_permutation_fails() {
    let mut mesh = shape::cube();
    mesh.set_next(HalfedgeId(0), HalfedgeId(2));
    let found = said(next_is_permutation(&mesh));
    assert_eq!(
        found,
        "after halfedge 0 comes halfedge 2, but the `prev` of halfedge 2 is halfedge 1"
    );
    let mut mesh = shape::cube();
    mesh.set_prev(HalfedgeId(1), HalfedgeId(3));
    assert!(next_is_permutation(&mesh).is_err() && twin_is_involution(&mesh).is_ok());
}

#[test]
fn twin_is_involution_fails() {
    let mut mesh = shape::cube();
    mesh.set_twin(HalfedgeId(0), HalfedgeId(0));
    assert_eq!(said(twin_is_involution(&mesh)), "halfedge 0 is its own twin");
    let mut mesh = shape::cube();
    let twin = mesh.twin(HalfedgeId(0));
    mesh.set_twin(twin, HalfedgeId(5));
    assert!(twin_is_involution(&mesh).is_err() && next_is_permutation(&mesh).is_ok());
}

#[test]
fn faces_are_orbits_fails() {
    // Two loops with one face.
    let mut mesh = shape::cube();
    for h in mesh.face_halfedges(FaceId(1)).collect::<Vec<_>>() {
        mesh.set_face(h, FaceId(0));
    }
    mesh.erase_face(FaceId(1));
    assert!(nothing_points_at_the_dead(&mesh).is_ok());
    assert_eq!(
        said(faces_are_orbits(&mesh)),
        "face 0 would be two loops, one with halfedge 0 and one with halfedge 4"
    );
    // A halfedge that names the face next door.
    let mut mesh = shape::cube();
    mesh.set_face(HalfedgeId(1), FaceId(3));
    assert_eq!(
        said(faces_are_orbits(&mesh)),
        "halfedge 0 and halfedge 1 lie in one loop, but one says face 0 and the other face 3"
    );
    // A face that claims the loop of another.
    let mut mesh = shape::cube();
    mesh.set_face_halfedge(FaceId(2), HalfedgeId(0));
    assert_eq!(
        said(faces_are_orbits(&mesh)),
        "the `halfedge` of face 2 is halfedge 0, which says face 0"
    );
    // A face without a loop.
    let mut mesh = shape::cube();
    let extra = mesh.add_face();
    mesh.set_face_halfedge(extra, HalfedgeId(0));
    assert!(faces_are_orbits(&mesh).is_err());
}

#[test]
fn edges_are_orbits_fails() {
    let mut mesh = shape::cube();
    let e = mesh.edge(HalfedgeId(0));
    mesh.set_edge(HalfedgeId(0), EdgeId(7));
    assert!(edges_are_orbits(&mesh).is_err() && faces_are_orbits(&mesh).is_ok());
    mesh.set_edge(HalfedgeId(0), e);
    assert!(validate(&mesh).is_ok());
    mesh.set_edge_halfedge(e, mesh.edge_halfedge(EdgeId(7)));
    assert!(said(edges_are_orbits(&mesh)).starts_with("the `halfedge` of edge 0 is"));
}

#[test]
fn vertices_are_orbits_fails() {
    // Vertex 1 is given the star of vertex 0 as well.
    let mut mesh = shape::cube();
    for h in mesh.spokes(VertexId(0)).collect::<Vec<_>>() {
        mesh.set_vertex(h, VertexId(1));
    }
    mesh.erase_vertex(VertexId(0));
    assert!(said(vertices_are_orbits(&mesh)).starts_with("vertex 1 would be two fans, one with"));
    let mut mesh = shape::cube();
    mesh.set_vertex_halfedge(VertexId(4), HalfedgeId::NONE);
    assert!(said(vertices_are_orbits(&mesh)).starts_with("vertex 4 has no `halfedge`, but"));
}

#[test]
fn positions_are_finite_fails() {
    let mut mesh = shape::cube();
    mesh.set_position(VertexId(5), glam::DVec3::new(0.0, f64::NAN, 1.0));
    let found = said(positions_are_finite(&mesh));
    assert_eq!(found, "vertex 5 lies at 0 NaN 1, which is not finite");
}

fn built(polygons: &[&[u32]]) -> Mesh {
    let vertices = polygons.iter().flat_map(|p| p.iter()).max().unwrap() + 1;
    let positions: Vec<_> = (0..vertices).map(|i| glam::DVec3::splat(f64::from(i))).collect();
    Mesh::from_polygons(&positions, &polygons.iter().collect::<Polygons>()).unwrap()
}

fn below(mesh: &Mesh, level: Level) -> BelowLevel {
    assert_eq!(validate(mesh), Ok(()));
    validate_level(mesh, level).unwrap_err()
}

#[test]
fn surfaces_have_faces_everywhere() {
    let mut mesh = shape::grid(2, 1);
    mesh.set_hole(FaceId(0), true);
    assert!(matches!(below(&mesh, Level::Surface), BelowLevel::Pinched { .. }));
    let mut mesh = shape::single_polygon(4);
    mesh.set_hole(FaceId(0), true);
    assert!(matches!(below(&mesh, Level::Surface), BelowLevel::Pinched { .. }));
}

/// One edge with both ends free and a loop of two around it.
fn lone_edge() -> Mesh {
    let mut mesh = Mesh::default();
    let [v, w] = [mesh.add_vertex(), mesh.add_vertex()];
    let [h, t] = [mesh.add_halfedge(), mesh.add_halfedge()];
    let (e, f) = (mesh.add_edge(), mesh.add_face());
    for (h, t, v) in [(h, t, v), (t, h, w)] {
        mesh.set_next(h, t);
        mesh.set_prev(h, t);
        mesh.set_twin(h, t);
        mesh.set_vertex(h, v);
        mesh.set_edge(h, e);
        mesh.set_face(h, f);
        mesh.set_vertex_halfedge(v, h);
    }
    mesh.set_edge_halfedge(e, h);
    mesh.set_face_halfedge(f, h);
    mesh
}

#[test]
fn a_lone_edge_is_only_a_map() {
    let mut mesh = lone_edge();
    let reason = below(&mesh, Level::Surface);
    assert_eq!(reason, BelowLevel::SmallLoop { face: FaceId(0), hole: false, size: 2 });
    assert_eq!(reason.to_string(), "face 0 has only 2 sides");
    mesh.set_hole(FaceId(0), true);
    let reason = below(&mesh, Level::Surface);
    assert_eq!(reason, BelowLevel::SmallLoop { face: FaceId(0), hole: true, size: 2 });
    let mut mesh = shape::pillow(3);
    for face in [FaceId(0), FaceId(1)] {
        mesh.set_hole(face, true);
    }
    let reason = below(&mesh, Level::Surface);
    let holes = [FaceId(0), FaceId(1)];
    assert_eq!(reason, BelowLevel::Pinched { vertex: VertexId(0), holes });
}

#[test]
fn simple_faces_differ_in_their_corners() {
    // Three corners in common are not all.
    let mesh = built(&[&[0, 1, 2, 3], &[3, 2, 1, 4]]);
    assert!(validate_level(&mesh, Level::Simple).is_ok());
    let reason = below(&shape::pillow(5), Level::Simple);
    assert_eq!(reason, BelowLevel::SameCorners { faces: [FaceId(0), FaceId(1)] });
}

#[test]
fn holes_of_two_sides_are_only_a_map() {
    // Two triangles glued along two sides of each.
    let mut mesh = shape::pillow(3);
    let (h, t) = (HalfedgeId(0), mesh.twin(HalfedgeId(0)));
    let e = mesh.edge(h);
    let [a, b] = [mesh.add_halfedge(), mesh.add_halfedge()];
    let (extra, hole) = (mesh.add_edge(), mesh.add_face());
    for (inner, outer, other, edge) in [(h, a, b, e), (t, b, a, extra)] {
        mesh.set_twin(inner, outer);
        mesh.set_twin(outer, inner);
        mesh.set_next(outer, other);
        mesh.set_prev(outer, other);
        mesh.set_edge(inner, edge);
        mesh.set_edge(outer, edge);
        mesh.set_face(outer, hole);
        mesh.set_edge_halfedge(edge, inner);
        mesh.set_vertex(outer, mesh.vertex(mesh.next(inner)));
    }
    mesh.set_face_halfedge(hole, a);
    mesh.set_hole(hole, true);
    assert!(validate(&mesh).is_ok());
    let reason = below(&mesh, Level::Surface);
    assert_eq!(reason, BelowLevel::SmallLoop { face: hole, hole: true, size: 2 });
    assert_eq!(reason.to_string(), format!("hole {} has only 2 sides", hole.0));
}

#[test]
fn an_isolated_vertex_is_fine_at_every_level() {
    let mut mesh = shape::cube();
    mesh.add_vertex();
    assert!(validate_level(&mesh, Level::Simple).is_ok());
    assert_eq!(Summary::of(&mesh).isolated_vertices, 1);
}

/// Tables with pointers to anywhere: no law may hang or panic.
#[test]
fn laws_answer_on_any_table() {
    let mut state = 1u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        match (state >> 33) as usize % (below + 3) {
            i if i < below => i as u32,
            i if i == below => u32::MAX,
            i => i as u32 + 7,
        }
    };
    let mut broken = 0;
    for round in 0..2000 {
        let mut mesh = if round % 2 == 0 { shape::cube() } else { shape::fan(4) };
        let writes = 1 + round % 9;
        for _ in 0..writes {
            let n = mesh.capacity(ElementKind::Halfedge);
            let h = HalfedgeId(random(n).min(n as u32 - 1));
            match random(11) {
                0 => mesh.set_next(h, HalfedgeId(random(n))),
                1 => mesh.set_prev(h, HalfedgeId(random(n))),
                2 => mesh.set_twin(h, HalfedgeId(random(n))),
                3 => mesh.set_vertex(h, VertexId(random(8))),
                4 => mesh.set_edge(h, EdgeId(random(12))),
                5 => mesh.set_face(h, FaceId(random(5))),
                6 => mesh.erase_halfedge(h),
                9 => mesh.set_edge_halfedge(EdgeId(random(7).min(6)), h),
                10 if mesh.edge_alive(EdgeId(6)) => mesh.erase_edge(EdgeId(6)),
                7 => mesh.set_face_halfedge(FaceId(random(4).min(3)), h),
                _ => mesh.set_vertex_halfedge(VertexId(random(5).min(4)), h),
            }
        }
        let laws = hedgerow::mesh::validate::LAWS.map(|(_, law)| law(&mesh));
        let first = laws.into_iter().find(Result::is_err).unwrap_or(Ok(()));
        assert_eq!(validate(&mesh), first, "round {round}");
        broken += usize::from(Summary::of(&mesh).invalid.is_some());
        let other = shape::cube();
        let _ = hedgerow::mesh::same_connectivity(&mesh, &other);
        assert!(hedgerow::mesh::same_connectivity(&mesh, &mesh));
        assert!(hedgerow::mesh::identical(&mesh, &mesh));
        for e in mesh.edges() {
            let _ = (mesh.link_condition(e), mesh.length(e));
        }
    }
    assert!((1200..2000).contains(&broken), "{broken}");
}
