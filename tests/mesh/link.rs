//! The link condition holds exactly where a collapse, carried out to the letter, leaves
//! a simple mesh.

use hedgerow::mesh::{EdgeId, Level, Mesh, Polygons, shape, validate_level};

/// Merges the ends of `e`, and of each triangle at it the other two edges, whatever comes of it.
///
/// ```text
///       x                x
///     /   \              |
///    a --- b     ->     ab
///     \   /              |
///       y                y
/// ```
fn collapse(mesh: &mut Mesh, e: EdgeId) {
    let h = mesh.edge_halfedge(e);
    let t = mesh.twin(h);
    let (a, b) = (mesh.vertex(h), mesh.vertex(t));
    for spoke in mesh.spokes(b).collect::<Vec<_>>() {
        mesh.set_vertex(spoke, a);
    }
    for side in [h, t] {
        let f = mesh.face(side);
        let (next, prev) = (mesh.next(side), mesh.prev(side));
        if mesh.is_hole(f) || mesh.face_size(f) > 3 {
            mesh.set_next(prev, next);
            mesh.set_prev(next, prev);
            mesh.set_face_halfedge(f, next);
            mesh.set_vertex_halfedge(a, next);
            continue;
        }
        let (over_next, over_prev) = (mesh.twin(next), mesh.twin(prev));
        mesh.set_twin(over_next, over_prev);
        mesh.set_twin(over_prev, over_next);
        let kept = mesh.edge(prev);
        mesh.erase_edge(mesh.edge(next));
        mesh.set_edge(over_next, kept);
        mesh.set_edge_halfedge(kept, over_next);
        mesh.set_vertex_halfedge(mesh.vertex(prev), over_next);
        mesh.set_vertex_halfedge(a, over_prev);
        mesh.erase_halfedge(next);
        mesh.erase_halfedge(prev);
        mesh.erase_face(f);
    }
    mesh.erase_halfedge(h);
    mesh.erase_halfedge(t);
    mesh.erase_edge(e);
    mesh.erase_vertex(b);
}

/// The mesh of some of the faces of `whole`, if they are one.
fn part(whole: &Mesh, wanted: impl Fn(usize) -> bool) -> Option<Mesh> {
    let positions: Vec<_> = whole.vertices().map(|v| whole.position(v)).collect();
    let faces = whole.faces().filter(|&f| !whole.is_hole(f) && wanted(f.index()));
    let corners = |f| whole.face_vertices(f).map(|v| v.0).collect::<Vec<_>>();
    Mesh::from_polygons(&positions, &faces.map(corners).collect::<Polygons>()).ok()
}

/// How many edges may be collapsed, and how many not.
fn check(mesh: &Mesh) -> [usize; 2] {
    if validate_level(mesh, Level::Simple).is_err() {
        return [0, 0];
    }
    let mut counts = [0, 0];
    for e in mesh.edges() {
        let mut result = mesh.clone();
        collapse(&mut result, e);
        let outcome = validate_level(&result, Level::Simple);
        assert_eq!(mesh.link_condition(e), outcome.is_ok(), "{e} of {mesh:?}: {outcome:?}");
        counts[usize::from(outcome.is_ok())] += 1;
    }
    counts
}

#[test]
fn on_every_part_of_small_shapes() {
    let mut total = [0, 0];
    for whole in [shape::tetrahedron(), shape::octahedron(), shape::triangle_grid(2, 2)] {
        for subset in 0u32..1 << whole.face_count() {
            if let Some(mesh) = part(&whole, |f| subset >> f & 1 == 1) {
                let [no, yes] = check(&mesh);
                total = [total[0] + no, total[1] + yes];
            }
        }
    }
    assert!(total.iter().all(|&count| count > 500), "{total:?}");
}

#[test]
fn on_random_parts_and_after_collapses() {
    let mut state = 7u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize
    };
    let wholes = [
        shape::icosahedron(),
        shape::triangle_torus(3, 4),
        shape::triangle_grid(4, 3),
        shape::icosphere(1),
    ];
    let mut total = [0, 0];
    for round in 0..100 {
        let whole = &wholes[round % wholes.len()];
        let dropped: Vec<usize> = (0..round % 5).map(|_| random() % whole.face_count()).collect();
        let Some(mut mesh) = part(whole, |f| !dropped.contains(&f)) else {
            continue;
        };
        // Collapse on, which makes small stars and tetrahedra.
        loop {
            let [no, yes] = check(&mesh);
            total = [total[0] + no, total[1] + yes];
            let open: Vec<EdgeId> = mesh.edges().filter(|&e| mesh.link_condition(e)).collect();
            if open.is_empty() {
                break;
            }
            collapse(&mut mesh, open[random() % open.len()]);
            mesh.recycle();
        }
    }
    assert!(total.iter().all(|&count| count > 2_000), "{total:?}");
}

/// On a mesh that is no simple one, too, the faces at the edge are compared.
#[test]
fn faces_with_the_same_corners_are_not_kept() {
    let pillow = shape::pillow(4);
    assert!(pillow.edges().all(|e| !pillow.link_condition(e)));
}

/// Merges the two faces at an edge.
fn merge_faces(mesh: &mut Mesh, e: EdgeId) {
    let h = mesh.edge_halfedge(e);
    let t = mesh.twin(h);
    let (f, g) = (mesh.face(h), mesh.face(t));
    for half in mesh.loop_from(t).collect::<Vec<_>>() {
        mesh.set_face(half, f);
    }
    for (side, other) in [(h, t), (t, h)] {
        let (prev, next) = (mesh.prev(side), mesh.next(other));
        mesh.set_next(prev, next);
        mesh.set_prev(next, prev);
        mesh.set_vertex_halfedge(mesh.vertex(side), next);
        mesh.set_face_halfedge(f, next);
    }
    mesh.erase_halfedge(h);
    mesh.erase_halfedge(t);
    mesh.erase_edge(e);
    mesh.erase_face(g);
}

#[test]
fn on_random_polygons() {
    let mut state = 11u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize
    };
    let wholes = [
        shape::icosahedron(),
        shape::cube(),
        shape::torus(3, 3),
        shape::torus(3, 4),
        shape::triangle_grid(3, 3),
        shape::octahedron(),
        shape::grid(3, 2),
        shape::tube(3, 2),
    ];
    let mut total = [0, 0];
    for round in 0..240 {
        let whole = &wholes[round % wholes.len()];
        let dropped: Vec<usize> = (0..round % 3).map(|_| random() % whole.face_count()).collect();
        let Some(mut mesh) = part(whole, |f| !dropped.contains(&f)) else {
            continue;
        };
        for _ in 0..random() % 8 {
            let edges: Vec<EdgeId> = mesh.edges().collect();
            let e = edges[random() % edges.len()];
            let sides = [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))];
            let [f, g] = sides.map(|side| mesh.face(side));
            if f == g || mesh.is_hole(f) || mesh.is_hole(g) {
                continue;
            }
            let mut merged = mesh.clone();
            merge_faces(&mut merged, e);
            if validate_level(&merged, Level::Simple).is_ok() {
                mesh = merged;
            }
        }
        let [no, yes] = check(&mesh);
        total = [total[0] + no, total[1] + yes];
    }
    assert!(total.iter().all(|&count| count > 1_000), "{total:?}");
}

fn collapsible(mesh: &Mesh) -> usize {
    mesh.edges().filter(|&e| mesh.link_condition(e)).count()
}

#[test]
fn known_counts() {
    assert_eq!(collapsible(&shape::tetrahedron()), 0);
    assert_eq!(collapsible(&shape::single_polygon(3)), 0);
    assert_eq!(collapsible(&shape::pillow(3)), 0);
    assert_eq!(collapsible(&shape::octahedron()), 12);
    assert_eq!(collapsible(&shape::icosahedron()), 30);
    assert_eq!(collapsible(&shape::cube()), 12);
    // The outer edge of two triangles: yes; the diagonal would pinch: no.
    assert_eq!(collapsible(&shape::triangle_grid(1, 1)), 4);
}

#[test]
fn large_stars_count_alike() {
    // A spoke of a wide fan has both ends on the boundary only at its rim.
    let mesh = shape::fan(100);
    let spokes = 100;
    let rim = 100;
    assert_eq!(collapsible(&mesh), spokes + rim);
    assert_eq!(collapsible(&shape::fan(5)), 10);
}
