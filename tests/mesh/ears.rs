//! Faces cut into triangles: ears, and patches that bend least.

use glam::{DVec2, DVec3};
use hedgerow::mesh::{FaceId, HalfedgeId, Mesh, Polygons, VertexId};
use robust::{Coord, orient2d};

/// Greater than zero where the three places run counterclockwise; the sign is exact.
fn turn(places: [DVec2; 3]) -> f64 {
    let [a, b, c] = places.map(|at| Coord { x: at.x, y: at.y });
    orient2d(a, b, c)
}

/// A face with corners in the plane.
fn face(corners: &[DVec2]) -> Mesh {
    let places: Vec<_> = corners.iter().map(|at| at.extend(0.0)).collect();
    let polygon: Vec<u32> = (0..corners.len() as u32).collect();
    let polygons: Polygons = std::iter::once(polygon).collect();
    Mesh::from_polygons(&places, &polygons).unwrap()
}

/// The triangles that are cut off, and the one that is left.
fn triangles(mesh: &Mesh, order: &[HalfedgeId]) -> Vec<[DVec2; 3]> {
    let mut left: Vec<_> = mesh.face_halfedges(FaceId(0)).collect();
    let place = |h: &HalfedgeId| mesh.position(mesh.vertex(*h)).truncate();
    let mut triangles = Vec::new();
    for ear in order {
        let at = left.iter().position(|h| h == ear).expect("a corner goes once");
        let count = left.len();
        triangles.push([at + count - 1, at, at + 1].map(|at| place(&left[at % count])));
        left.remove(at);
    }
    assert_eq!(left.len(), 3);
    triangles.push([0, 1, 2].map(|at| place(&left[at])));
    triangles
}

/// None is turned over, and together they are as large as the face: so none overlap.
fn expect_no_overlap(corners: &[DVec2]) {
    let mesh = face(corners);
    let triangles = triangles(&mesh, &mesh.ears(FaceId(0)));
    assert_eq!(triangles.len(), corners.len() - 2);
    assert!(triangles.iter().all(|&triangle| turn(triangle) >= 0.0));
    let total: f64 = triangles.iter().map(|&triangle| turn(triangle) / 2.0).sum();
    let area = mesh.area(FaceId(0));
    assert!((total - area).abs() < 1e-9 * area, "{total} instead of {area}");
}

fn around(count: usize, radius: impl Fn(usize) -> f64) -> Vec<DVec2> {
    let angle = |at: usize| std::f64::consts::TAU * at as f64 / count as f64;
    (0..count).map(|at| radius(at) * DVec2::from_angle(angle(at))).collect()
}

#[test]
fn concave_faces_are_cut_without_overlaps() {
    expect_no_overlap(&around(2000, |_| 1.0));
    expect_no_overlap(&around(2000, |at| if at % 2 == 0 { 1.0 } else { 0.2 }));
    expect_no_overlap(&around(1500, |at| 1.0 + ((at * at * 7919) % 101) as f64 / 40.0));
    // A comb, and a wall that winds in and back out again.
    let comb = (0..500).flat_map(|at| {
        let x = f64::from(at);
        [DVec2::new(1001.0 - 2.0 * x, 1.0), DVec2::new(1000.0 - 2.0 * x, 900.0)]
    });
    let foot = [DVec2::new(0.0, 0.0), DVec2::new(1002.0, 0.0)];
    expect_no_overlap(&foot.into_iter().chain(comb).collect::<Vec<_>>());
    let spiral = |wall: f64| {
        (0..600).map(move |at| {
            let angle = f64::from(at) / 20.0;
            (1.0 + angle + wall) * DVec2::from_angle(angle)
        })
    };
    let inwards: Vec<_> = spiral(0.0).collect();
    expect_no_overlap(&spiral(1.5).chain(inwards.into_iter().rev()).collect::<Vec<_>>());
}

#[test]
fn corners_on_one_line_are_cut_too() {
    let side =
        |from: DVec2, to: DVec2| (0..300).map(move |at| from.lerp(to, f64::from(at) / 300.0));
    let corners = [(0.0, 0.0), (300.0, 0.0), (300.0, 300.0), (0.0, 300.0)];
    let corners = corners.map(|(x, y)| DVec2::new(x, y));
    let square = (0..4).flat_map(|at| side(corners[at], corners[(at + 1) % 4]));
    expect_no_overlap(&square.collect::<Vec<_>>());
}

#[test]
fn the_best_shape_comes_first() {
    // A square with a corner cut off: the two right angles beside the cut go last.
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1.0, 4.0), (0.0, 3.0)];
    let mesh = face(&corners.map(|(x, y)| DVec2::new(x, y)));
    let order = mesh.ears(FaceId(0));
    assert_eq!(mesh.vertex(order[0]), VertexId(1));
}

#[test]
fn a_triangle_has_nothing_to_cut() {
    let mesh = face(&around(3, |_| 1.0));
    assert!(mesh.ears(FaceId(0)).is_empty());
    assert!(mesh.patch(FaceId(0)).is_empty());
}

/// Boxes whose corners are moved a little: the lid is cut along the diagonal that bends less.
#[test]
fn a_folded_lid_is_cut_where_it_bends_less() {
    let polygons: Polygons = [
        vec![0, 1, 2, 3],
        vec![7, 6, 5, 4],
        vec![4, 5, 1, 0],
        vec![5, 6, 2, 1],
        vec![6, 7, 3, 2],
        vec![7, 4, 0, 3],
    ]
    .into_iter()
    .collect();
    let mut chosen = [0, 0];
    for turn in 0..40_u32 {
        let moved = |at: u32| f64::from((turn * 31 + at * at * 17 + at * 5) % 23) / 40.0;
        let corner = |at: u32| {
            let (x, y) = [(0., 0.), (2., 0.), (2., 2.), (0., 2.)][at as usize % 4];
            let z = if at < 4 { 2.0 } else { 0.0 };
            DVec3::new(x + moved(at), y - moved(at + 1), z + 2.0 * moved(at + 2))
        };
        let places: Vec<_> = (0..8).map(corner).collect();
        let mesh = Mesh::from_polygons(&places, &polygons).unwrap();
        let normal = |corners: [usize; 3]| {
            let [a, b, c] = corners.map(|at| places[at]);
            (b - a).cross(c - a).normalize()
        };
        // The normals of the two triangles, and which walls each has beside it: wall k
        // stands at the side from k to k + 1.
        let worst = |first: usize| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|at| (first + at) % 4);
            let (one, two) = (normal([a, b, c]), normal([a, c, d]));
            let wall = |side: usize| mesh.normal(FaceId(2 + side as u32));
            let walls = [(one, wall(a)), (one, wall(b)), (two, wall(c)), (two, wall(d))];
            let least = walls.into_iter().chain([(one, two)]);
            least.map(|(n, m)| n.dot(m)).fold(f64::INFINITY, f64::min)
        };
        let cut = usize::from(worst(1) > worst(0));
        // Cut along the diagonal from `cut`, one of the other two corners goes.
        let order = mesh.patch(FaceId(0));
        assert_eq!(order.len(), 1);
        assert_eq!(mesh.vertex(order[0]).index() % 2, 1 - cut, "lid {turn}");
        chosen[cut] += 1;
    }
    assert!(chosen[0] > 3 && chosen[1] > 3, "{chosen:?}");
}

#[test]
fn a_flat_face_is_cut_into_good_shapes() {
    let place = |at: u32| {
        let angle = f64::from(at) * std::f64::consts::TAU / 6.0;
        DVec3::new(angle.cos(), angle.sin(), 0.0)
    };
    let places: Vec<_> = (0..6).map(place).collect();
    let polygons: Polygons = std::iter::once((0..6).collect::<Vec<u32>>()).collect();
    let mesh = Mesh::from_polygons(&places, &polygons).unwrap();
    let order = mesh.patch(FaceId(0));
    assert_eq!(order.len(), 3);
    let mut corners: Vec<_> = order.iter().map(|&h| mesh.vertex(h)).collect();
    corners.sort_unstable();
    corners.dedup();
    assert_eq!(corners.len(), 3, "each corner goes once");
}

/// The pairs of neighboring triangles of a filled hole that bend by more than 134 degrees.
fn folds(mesh: &Mesh, hole: FaceId, order: &[HalfedgeId]) -> usize {
    let mut left: Vec<_> = mesh.face_halfedges(hole).collect();
    assert_eq!(order.len(), left.len() - 3);
    let place = |h: HalfedgeId| mesh.position(mesh.vertex(h));
    // The normals on the other sides of what is left.
    let across = |&h: &HalfedgeId| mesh.normal(mesh.face(mesh.twin(h)));
    let mut beyond: Vec<_> = left.iter().map(across).collect();
    let mut folds = 0;
    for at in 0..=order.len() {
        let count = left.len();
        let corner =
            order.get(at).map_or(0, |corner| left.iter().position(|h| h == corner).unwrap());
        let [before, after] = [count - 1, 1].map(|by| (corner + by) % count);
        let [a, b, c] = [before, corner, after].map(|at| place(left[at]));
        let normal = (b - a).cross(c - a).normalize();
        let sides = if count == 3 { vec![before, corner, after] } else { vec![before, corner] };
        folds += sides.into_iter().filter(|&side| normal.dot(beyond[side]) < -0.7).count();
        beyond[before] = normal;
        left.remove(corner);
        beyond.remove(corner);
    }
    folds
}

/// An open cylinder of quads whose upper rim is given, bottom first.
fn cylinder(rim: &[DVec3]) -> (Mesh, FaceId) {
    let count = rim.len() as u32;
    let foot = rim.iter().map(|at| DVec3::new(at.x, at.y, -9.0));
    let places: Vec<_> = foot.chain(rim.iter().copied()).collect();
    let wall = |at: u32| vec![at, (at + 1) % count, (at + 1) % count + count, at + count];
    let polygons: Polygons = (0..count).map(wall).collect();
    let mesh = Mesh::from_polygons(&places, &polygons).unwrap();
    let is_rim = |f: &FaceId| mesh.is_hole(*f) && mesh.face_vertices(*f).any(|v| v.0 >= count);
    let hole = mesh.faces().find(is_rim).unwrap();
    (mesh, hole)
}

#[test]
fn large_holes_are_filled_without_folds() {
    let places = |count: usize, place: fn(f64, usize) -> DVec3| -> Vec<_> {
        let angle = |at: usize| std::f64::consts::TAU * at as f64 / count as f64;
        (0..count).map(|at| place(angle(at), at)).collect()
    };
    // The rim of a saddle, and a flat one with deep notches.
    let saddle = |angle: f64, _| DVec3::new(angle.cos(), angle.sin(), (2.0 * angle).sin());
    let notched = |angle: f64, at| {
        let radius = if at % 2 == 0 { 1.0 } else { 0.8 };
        DVec3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
    };
    for count in [52, 100, 128, 129, 200, 257, 1000, 5000] {
        for rim in [places(count, saddle), places(count, notched)] {
            let (mesh, hole) = cylinder(&rim);
            let order = mesh.patch(hole);
            assert_eq!(folds(&mesh, hole, &order), 0, "{count}");
        }
    }
}
