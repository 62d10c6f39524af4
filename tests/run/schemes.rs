//! The scripts of `std/subdivide.hedge`, `std/dual.hedge` and `std/components.hedge` whose results
//! can be written down from lists of polygons alone, against such lists, and the cut of a ring of
//! quads from each of its edges.
//!
//! The reference knows no halfedges: it finds the polygon at each directed side in a map.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use glam::DVec3;
use hedgerow::mesh::{ElementKind, Level, Mesh, Polygons, Value, VertexId, shape, validate_level};
use hedgerow::{Argument, Program, Session};
use support::dice::Dice;

const PROGRAM: &str = "
use \"std/components.hedge\"
use \"std/delete.hedge\"
use \"std/dual.hedge\"
use \"std/polygon.hedge\"
use \"std/subdivide.hedge\"
script prepare() {
  for e in shuffle(edges) where not boundary(e) and random() < 0.3 {
    if all(degree(v) > 3 for v in e.vertices) { dissolve_edge(e) }
  }
}
script delete_two_corners() {
  var i = 0
  for f in faces {
    f.marked = i == 0 or i == 3
    i = i + 1
  }
  delete_marked()
}
script bisect_some() {
  for e in shuffle(edges) where random() < 0.3 { must polygon::bisect(e) }
}
";

/// Positions, and the corners of each polygon.
type Lists = (Vec<DVec3>, Vec<Vec<usize>>);

fn lists(mesh: &Mesh) -> Lists {
    let (positions, polygons) = mesh.to_polygons();
    let corners = |polygon: &[u32]| polygon.iter().map(|&v| v as usize).collect();
    (positions, polygons.iter().map(corners).collect())
}

/// A mesh with the vertices moved a little, so that no two places are the same and none is special.
fn moved(mesh: &Mesh, dice: &mut Dice) -> Mesh {
    let (mut positions, polygons) = mesh.to_polygons();
    for position in &mut positions {
        let by = [0; 3].map(|_| dice.below(1000) as f64 / 5000.0);
        *position += DVec3::from_array(by);
    }
    Mesh::from_polygons(&positions, &polygons).unwrap()
}

/// The polygon at each directed side, and which of its sides it is.
fn sides(polygons: &[Vec<usize>]) -> BTreeMap<(usize, usize), (usize, usize)> {
    let of = |(number, corners): (usize, &Vec<usize>)| {
        let ends = corners.iter().zip(corners.iter().cycle().skip(1));
        let sides: Vec<_> = ends.enumerate().map(|(k, (&v, &w))| ((v, w), (number, k))).collect();
        sides
    };
    polygons.iter().enumerate().flat_map(of).collect()
}

/// The corner before one of a polygon.
fn before(corners: &[usize], k: usize) -> usize {
    corners[(k + corners.len() - 1) % corners.len()]
}

/// For each vertex what lies around it, counterclockwise: the corners of polygons, and for one of the
/// boundary, at the two ends, what `border` says of the directed sides there.
fn around<T>(
    polygons: &[Vec<usize>],
    corner: impl Fn(usize, usize) -> T,
    border: impl Fn(usize, usize) -> T,
) -> Vec<Vec<T>> {
    let sides = sides(polygons);
    let mut ahead: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    sides.keys().for_each(|&(v, w)| ahead.entry(v).or_default().push(w));
    let ring = |(v, targets): (usize, Vec<usize>)| {
        let open = targets.iter().find(|&&w| !sides.contains_key(&(w, v)));
        let first = *open.unwrap_or(&targets[0]);
        let mut ring: Vec<T> = open.map(|&w| border(v, w)).into_iter().collect();
        let mut w = first;
        while let Some(&(polygon, k)) = sides.get(&(v, w)) {
            ring.push(corner(polygon, k));
            w = before(&polygons[polygon], k);
            if w == first {
                return ring;
            }
        }
        ring.push(border(v, w));
        ring
    };
    ahead.into_iter().map(ring).collect()
}

/// What Doo-Sabin and midedge have in common: the corner points are given.
fn cut_off((positions, polygons): &Lists, point: impl Fn(&[DVec3], usize) -> DVec3) -> Lists {
    let (mut points, mut corner, mut border) = (Vec::new(), BTreeMap::new(), BTreeMap::new());
    for (number, corners) in polygons.iter().enumerate() {
        let places: Vec<_> = corners.iter().map(|&v| positions[v]).collect();
        for k in 0..corners.len() {
            corner.insert((number, k), points.len());
            points.push(point(&places, k));
        }
    }
    let sides = sides(polygons);
    for &(v, w) in sides.keys().filter(|&&(v, w)| !sides.contains_key(&(w, v))) {
        for (from, to) in [(v, w), (w, v)] {
            border.insert((from, to), points.len());
            points.push(0.75 * positions[from] + 0.25 * positions[to]);
        }
    }
    let inner = |(number, corners): (usize, &Vec<usize>)| {
        (0..corners.len()).map(|k| corner[&(number, k)]).collect()
    };
    let mut faces: Vec<Vec<usize>> = polygons.iter().enumerate().map(inner).collect();
    let ends = |&(number, k): &(usize, usize)| {
        [corner[&(number, (k + 1) % polygons[number].len())], corner[&(number, k)]]
    };
    for ((v, w), at) in &sides {
        let beyond = match sides.get(&(*w, *v)) {
            Some(beyond) if v < w => ends(beyond),
            Some(_) => continue,
            None => [border[&(*v, *w)], border[&(*w, *v)]],
        };
        faces.push([ends(at), beyond].concat());
    }
    faces.extend(around(polygons, |number, k| corner[&(number, k)], |v, w| border[&(v, w)]));
    // A face with two sides is an edge.
    faces.retain(|corners| corners.len() > 2);
    (points, faces)
}

fn doo_sabin(corners: &[DVec3], k: usize) -> DVec3 {
    let n = corners.len() as f64;
    let weight = |j: usize| match j == k {
        true => (n + 5.0) / (4.0 * n),
        false => (3.0 + 2.0 * (TAU * (j as f64 - k as f64) / n).cos()) / (4.0 * n),
    };
    corners.iter().enumerate().map(|(j, &corner)| weight(j) * corner).sum()
}

fn midedge(corners: &[DVec3], k: usize) -> DVec3 {
    let n = corners.len();
    let (ahead, behind) = (corners[(k + 1) % n], corners[(k + n - 1) % n]);
    let middles = [0.5 * (corners[k] + ahead), 0.5 * (corners[k] + behind)];
    0.5 * (middles[0] + middles[1])
}

fn dual((positions, polygons): &Lists) -> Lists {
    let middle = |corners: &Vec<usize>| {
        corners.iter().map(|&v| positions[v]).sum::<DVec3>() / corners.len() as f64
    };
    let mut points: Vec<_> = polygons.iter().map(middle).collect();
    let (sides, mut border) = (sides(polygons), BTreeMap::new());
    for &(v, w) in sides.keys().filter(|&&(v, w)| !sides.contains_key(&(w, v))) {
        border.extend([((v, w), points.len()), ((w, v), points.len())]);
        points.push(0.5 * (positions[v] + positions[w]));
    }
    let mut faces = around(polygons, |number, _| number, |v, w| border[&(v, w)]);
    faces.retain(|corners| corners.len() > 2);
    (points, faces)
}

/// Modified butterfly subdivision.
struct Butterfly<'a> {
    positions: &'a [DVec3],
    /// The third corner of the triangle at each directed side.
    third: BTreeMap<(usize, usize), usize>,
    /// The next vertex along the boundary, and the one before.
    ahead: BTreeMap<usize, usize>,
    behind: BTreeMap<usize, usize>,
}

impl<'a> Butterfly<'a> {
    fn new((positions, triangles): &'a Lists) -> Self {
        let third: BTreeMap<_, _> = sides(triangles)
            .into_iter()
            .map(|(side, (number, k))| (side, before(&triangles[number], k)))
            .collect();
        let border = third.keys().filter(|&&(v, w)| !third.contains_key(&(w, v)));
        let ahead: BTreeMap<_, _> = border.copied().collect();
        let behind = ahead.iter().map(|(&v, &w)| (w, v)).collect();
        Self { positions, third, ahead, behind }
    }

    /// The neighbors of an inner vertex, from one of them on.
    fn ring(&self, v: usize, first: usize) -> Vec<usize> {
        let mut ring = vec![first];
        loop {
            match self.third[&(v, ring[ring.len() - 1])] {
                w if w == first => return ring,
                w => ring.push(w),
            }
        }
    }

    fn is_regular(&self, v: usize, w: usize) -> bool {
        self.ahead.contains_key(&v) || self.ring(v, w).len() == 6
    }

    fn one_sided(&self, v: usize, w: usize) -> DVec3 {
        let ring = self.ring(v, w);
        let n = ring.len() as f64;
        let weight = |j: usize| {
            let turn = TAU * j as f64 / n;
            match ring.len() {
                3 => [5.0 / 12.0, -1.0 / 12.0, -1.0 / 12.0][j],
                4 => [3.0 / 8.0, 0.0, -1.0 / 8.0, 0.0][j],
                _ => (0.25 + turn.cos() + 0.5 * (2.0 * turn).cos()) / n,
            }
        };
        let pull: DVec3 = (0..ring.len()).map(|j| weight(j) * self.positions[ring[j]]).sum();
        0.75 * self.positions[v] + pull
    }

    /// What lies across the side from v to w of a triangle, seen from its third corner.
    fn across(&self, v: usize, w: usize) -> DVec3 {
        match self.third.get(&(w, v)) {
            Some(&beyond) => self.positions[beyond],
            None => self.positions[v] + self.positions[w] - self.positions[self.third[&(v, w)]],
        }
    }

    fn point(&self, v: usize, w: usize) -> DVec3 {
        let at = |v: usize| self.positions[v];
        let (Some(&a), Some(&b)) = (self.third.get(&(v, w)), self.third.get(&(w, v))) else {
            let (v, w) = if self.third.contains_key(&(v, w)) { (v, w) } else { (w, v) };
            let beside = at(self.behind[&v]) + at(self.ahead[&w]);
            return 9.0 / 16.0 * (at(v) + at(w)) - beside / 16.0;
        };
        match (self.is_regular(v, w), self.is_regular(w, v)) {
            (true, true) => {
                let wings = [(w, a), (a, v), (v, b), (b, w)].map(|(v, w)| self.across(v, w));
                let wings: DVec3 = wings.into_iter().sum();
                0.5 * (at(v) + at(w)) + (at(a) + at(b)) / 8.0 - wings / 16.0
            }
            (true, false) => self.one_sided(w, v),
            (false, true) => self.one_sided(v, w),
            (false, false) => 0.5 * (self.one_sided(v, w) + self.one_sided(w, v)),
        }
    }
}

fn butterfly(old: &Lists) -> Lists {
    let scheme = Butterfly::new(old);
    let (mut points, mut middle) = (old.0.clone(), BTreeMap::new());
    for &(v, w) in scheme.third.keys() {
        if !middle.contains_key(&(w, v)) {
            middle.insert((v, w), points.len());
            points.push(scheme.point(v, w));
        }
    }
    let middle = |v, w| *middle.get(&(v, w)).unwrap_or_else(|| &middle[&(w, v)]);
    let mut faces = Vec::new();
    for corners in &old.1 {
        let [a, b, c] = corners[..] else { panic!("not a triangle") };
        let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
        faces.extend([vec![a, x, z], vec![b, y, x], vec![c, z, y], vec![x, y, z]]);
    }
    (points, faces)
}

/// How far the vertices of one lie from those of the other, at most; the faces must be the same.
fn farthest(ours: &Lists, theirs: &Lists, name: &str) -> f64 {
    assert_eq!((ours.0.len(), ours.1.len()), (theirs.0.len(), theirs.1.len()), "{name}");
    let mut order: Vec<_> = (0..theirs.0.len()).collect();
    order.sort_by(|&a, &b| theirs.0[a].x.total_cmp(&theirs.0[b].x));
    let mut worst: f64 = 0.0;
    let nearest = |&place: &DVec3| {
        let from = order.partition_point(|&v| theirs.0[v].x < place.x - 1e-6);
        let near = order[from..].iter().take_while(|&&v| theirs.0[v].x < place.x + 1e-6);
        let distance = |v: usize| theirs.0[v].distance(place);
        let nearest = near.copied().min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        let nearest = nearest.unwrap_or_else(|| panic!("{name}: none near {place}"));
        worst = worst.max(distance(nearest));
        nearest
    };
    let number: Vec<_> = ours.0.iter().map(nearest).collect();
    let canonical = |corners: Vec<usize>| {
        let least = (0..corners.len()).min_by_key(|&k| corners[k]).unwrap();
        [&corners[least..], &corners[..least]].concat()
    };
    let numbered = |corners: &Vec<usize>| corners.iter().map(|&v| number[v]).collect();
    let mut found: Vec<_> = ours.1.iter().map(numbered).map(canonical).collect();
    let mut wanted: Vec<_> = theirs.1.iter().cloned().map(canonical).collect();
    found.sort_unstable();
    wanted.sort_unstable();
    // Thousands of numbers: they are not shown.
    assert!(found == wanted, "{name}: other faces");
    worst
}

/// A mesh after a script of the program.
fn after(program: &Program, script: &str, mesh: &Mesh) -> Mesh {
    let mut session = Session::new(program, mesh.clone());
    session.run(&program.script(script).unwrap(), ()).unwrap();
    session.into_mesh()
}

fn meshes(program: &Program) -> Vec<(&'static str, Mesh)> {
    let mut dice = Dice(5);
    let plain = [
        ("tetrahedron", shape::tetrahedron()),
        ("octahedron", shape::octahedron()),
        ("icosahedron", shape::icosahedron()),
        ("cube", shape::cube()),
        ("triangle", shape::single_polygon(3)),
        ("polygon", shape::single_polygon(7)),
        ("disk of three", shape::fan(3)),
        ("disk of seven", shape::fan(7)),
        ("grid", shape::grid(4, 3)),
        ("triangle grid", shape::triangle_grid(4, 3)),
        ("torus", shape::torus(5, 4)),
        ("triangle torus", shape::triangle_torus(7, 5)),
        ("tube", shape::tube(6, 3)),
        ("icosphere", shape::icosphere(2)),
    ];
    let mut all: Vec<_> =
        plain.iter().map(|(name, mesh)| (*name, moved(mesh, &mut dice))).collect();
    for name in ["icosphere", "triangle grid", "triangle torus"] {
        let (_, mesh) = plain.iter().find(|(other, _)| *other == name).unwrap();
        all.push(("polygons", moved(&after(program, "prepare", mesh), &mut dice)));
        all.push(("cut edges", moved(&after(program, "bisect_some", mesh), &mut dice)));
    }
    all
}

#[test]
fn schemes_give_the_lists_that_their_rules_give() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    type Reference = fn(&Lists) -> Lists;
    let schemes: [(&str, Reference); 4] = [
        ("doo_sabin", |old| cut_off(old, doo_sabin)),
        ("midedge", |old| cut_off(old, midedge)),
        ("dual", dual),
        ("butterfly", butterfly),
    ];
    let mut compared = BTreeMap::<&str, usize>::new();
    for (name, mesh) in meshes(&program) {
        let old = lists(&mesh);
        let triangles = old.1.iter().all(|corners| corners.len() == 3);
        for (script, reference) in schemes {
            // At a vertex with two edges the two points of the midedge scheme are one.
            let meet = script == "midedge" && name == "cut edges";
            if meet || script == "butterfly" && !triangles {
                continue;
            }
            let new = after(&program, script, &mesh);
            validate_level(&new, Level::Surface).unwrap();
            let worst = farthest(&lists(&new), &reference(&old), &format!("{name}, {script}"));
            assert!(worst < 1e-14, "{name}, {script}: {worst}");
            *compared.entry(script).or_default() += 1;

            // Two rounds are one after the other.
            let again = after(&program, script, &new);
            let twice = reference(&lists(&new));
            let worst = farthest(&lists(&again), &twice, &format!("{name}, {script} twice"));
            assert!(worst < 1e-14, "{name}, {script} twice: {worst}");
        }
    }
    assert!(compared.values().all(|&count| count >= 9), "{compared:?}");
}

/// The numbers of vertices, edges, faces and holes.
fn counts(mesh: &Mesh) -> [usize; 4] {
    let holes = mesh.faces().filter(|&f| mesh.is_hole(f)).count();
    let faces = mesh.faces().count() - holes;
    [mesh.vertices().count(), mesh.edges().count(), faces, holes]
}

#[test]
fn the_numbers_of_elements_follow_from_those_before() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    for (name, mesh) in meshes(&program) {
        if name == "cut edges" {
            continue;
        }
        let [v, e, f, holes] = counts(&mesh);
        let border = mesh.edges().filter(|&e| {
            let h = mesh.edge_halfedge(e);
            mesh.is_hole(mesh.face(h)) || mesh.is_hole(mesh.face(mesh.twin(h)))
        });
        let b = border.count();
        let now = |script| counts(&after(&program, script, &mesh));
        assert_eq!(now("doo_sabin"), [2 * e + b, 4 * e + b, v + e + f, holes], "{name}");
        assert_eq!(now("midedge"), now("doo_sabin"), "{name}");
        assert_eq!(now("dual"), [f + b, e + b, v, holes], "{name}");
        if mesh.faces().filter(|&f| !mesh.is_hole(f)).all(|f| mesh.face_size(f) == 3) {
            assert_eq!(now("butterfly"), [v + e, 2 * e + 3 * f, 4 * f, holes], "{name}");
        }
    }
}

#[test]
fn components_are_those_that_sides_join() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    let mut dice = Dice(9);
    for count in 1..9 {
        // Parts of a strip, and closed surfaces, in any order.
        let (mut positions, mut polygons) = (Vec::new(), Polygons::new());
        for _ in 0..count {
            let parts = [shape::cube(), shape::grid(3, 1), shape::fan(5)];
            let (places, faces) = parts[dice.below(3)].to_polygons();
            for corners in faces.iter() {
                let by = positions.len() as u32;
                polygons.push(&corners.iter().map(|v| v + by).collect::<Vec<_>>());
            }
            positions.extend(places);
        }
        let mut order: Vec<Vec<u32>> = polygons.iter().map(<[u32]>::to_vec).collect();
        for k in (1..order.len()).rev() {
            order.swap(k, dice.below(k + 1));
        }
        let mesh = Mesh::from_polygons(&positions, &order.iter().collect()).unwrap();
        let mut session = Session::new(&program, mesh);
        let label = program.function("label_components").unwrap();
        let found = session.call(&label, ()).unwrap();
        assert_eq!(found, Some(Argument::Int(count as i64)));
        let mesh = session.mesh();
        let column = mesh.find_column(ElementKind::Face, "component").unwrap();
        let component = |f| match mesh.value(column, f) {
            Some(Value::Int(component)) => component,
            other => panic!("{other:?}"),
        };
        let mut seen = 0;
        for face in mesh.faces().filter(|&f| !mesh.is_hole(f)) {
            let own = component(face.0);
            // In the order of their first faces.
            assert!(own <= seen);
            seen = seen.max(own + 1);
            for h in mesh.face_halfedges(face) {
                let beyond = mesh.face(mesh.twin(h));
                assert!(mesh.is_hole(beyond) || component(beyond.0) == own);
            }
        }
        assert_eq!(seen, count as i64);
    }
}

/// A grid of five by five quads; the ends of its middle row are joined with those of its middle
/// column, so that these are one ring, which crosses itself.
fn knot() -> Mesh {
    let (positions, polygons) = shape::grid(5, 5).to_polygons();
    let at = |x: f64, y: f64| positions.iter().position(|p| p.x == x && p.y == y).unwrap() as u32;
    let joined = [
        (at(5.0, 2.0), at(2.0, 5.0)),
        (at(5.0, 3.0), at(3.0, 5.0)),
        (at(0.0, 2.0), at(2.0, 0.0)),
        (at(0.0, 3.0), at(3.0, 0.0)),
    ];
    let number = |v: u32| joined.iter().find(|pair| pair.0 == v).map_or(v, |pair| pair.1);
    let mut used: Vec<_> = polygons.corners().iter().map(|&v| number(v)).collect();
    used.sort_unstable();
    used.dedup();
    let corners = |corners: &[u32]| -> Vec<u32> {
        corners.iter().map(|&v| used.binary_search(&number(v)).unwrap() as u32).collect()
    };
    let positions: Vec<_> = used.iter().map(|&v| positions[v as usize]).collect();
    Mesh::from_polygons(&positions, &polygons.iter().map(corners).collect()).unwrap()
}

#[test]
fn a_ring_of_quads_is_cut_from_each_of_its_edges() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    let cut = program.op("loop_cut").unwrap();
    let meshes = [shape::cube(), shape::grid(4, 3), shape::torus(5, 4), shape::tube(6, 3), knot()];
    for mesh in meshes {
        validate_level(&mesh, Level::Surface).unwrap();
        let [v, e, f, holes] = counts(&mesh);
        let mut crossed = BTreeMap::<usize, usize>::new();
        for edge in mesh.edges() {
            let mut session = Session::new(&program, mesh.clone());
            let h = mesh.edge_halfedge(edge);
            let place = 0.75 * mesh.position(mesh.vertex(h)) + 0.25 * mesh.position(mesh.target(h));
            let outcome = session.apply(&cut, (edge, 0.25)).unwrap();
            let new = session.mesh();
            validate_level(new, Level::Surface).unwrap();
            assert!(new.faces().all(|f| new.is_hole(f) || new.face_size(f) == 4));
            let middle = VertexId(outcome.result().expect("it is applied").index);
            assert!(new.position(middle).distance(place) < 1e-12);
            let now = counts(new);
            assert_eq!(now[0] + now[2] + e, v + f + now[1]);
            assert_eq!(now[3], holes);
            *crossed.entry(now[2] - f).or_default() += 1;
            // What is cut can be cut again.
            assert!(session.apply(&cut, (edge, 0.5)).unwrap().is_applied());
        }
        // Of each ring with k edges, k of them cut it.
        assert_eq!(crossed.values().sum::<usize>(), e);
    }
    let knot = knot();
    let numbers = knot.edges().map(|edge| {
        let mut session = Session::new(&program, knot.clone());
        assert!(session.apply(&cut, edge).unwrap().is_applied());
        counts(session.mesh())[2] - 25
    });
    let numbers: Vec<_> = numbers.collect();
    // The ring has ten edges; eight of its quads become two, and the one where it crosses itself four.
    assert_eq!(numbers.iter().filter(|&&more| more == 11).count(), 10);
    assert!(numbers.iter().all(|&more| more == 11 || more == 5));
}

/// Runs a script that stops by an assertion with a message; returns the mesh that it leaves.
fn stopped(program: &Program, script: &str, mesh: Mesh, message: &str) -> Mesh {
    let mut session = Session::new(program, mesh);
    let error = session.run(&program.script(script).unwrap(), ()).unwrap_err();
    assert_eq!(error.code(), "assertion-failed");
    assert!(error.message().contains(message), "{error}");
    session.into_mesh()
}

#[test]
fn meshes_without_a_dual_are_refused_before_they_change() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    let pinched = after(&program, "delete_two_corners", &shape::grid(2, 2));
    for script in ["dual", "doo_sabin", "midedge"] {
        let left = stopped(&program, script, pinched.clone(), "two holes meet at a vertex");
        assert_eq!(lists(&pinched), lists(&left), "{script}");
    }
}

#[test]
fn two_faces_alone_have_no_dual() {
    let program = Program::parse("schemes.hedge", PROGRAM).unwrap();
    stopped(&program, "dual", shape::pillow(4), "two faces have all their sides in common");
}
