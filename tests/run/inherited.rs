//! Attributes that new elements take over from what they come from.

use hedgerow::mesh::shape;
use hedgerow::{Program, Session};

/// A cube whose sides, ridges and corners are marked, and changes of it that move no surface: they
/// hold what geometry tells of each place.
const MARKED: &str = r#"
use "std/polygon.hedge"
use "std/triangle.hedge"
use "std/triangulate.hedge"
use "std/subdivide.hedge"
attr side: face int = inherited(0)
attr ridge: edge bool = inherited(false)
attr corner: halfedge vec3 = inherited(vec3(9))

fn is_outside(x: real) -> bool { abs(x) > 1 - 1e-9 }
fn side_of(p: vec3) -> int {
  if is_outside(p.x) { return if p.x > 0 { 1 } else { 2 } }
  if is_outside(p.y) { return if p.y > 0 { 3 } else { 4 } }
  if p.z > 0 { 5 } else { 6 }
}
fn lies_on_a_ridge(e: edge) -> bool {
  let p = midpoint(e)
  (is_outside(p.x) and is_outside(p.y)) or (is_outside(p.y) and is_outside(p.z))
    or (is_outside(p.x) and is_outside(p.z))
}
script mark() {
  for f in faces { f.side = side_of(centroid(f)) }
  for e in edges { e.ridge = lies_on_a_ridge(e) }
  for h in halfedges { h.corner = h.vertex.position }
}
script act(kind: int) {
  if kind == 0 { linear_quads() }
  if kind == 1 { for f in faces { must inset_vertex(f) } }
  if kind == 2 { for e in edges { if length(e) > 0.1 { must polygon::bisect(e) } } }
  if kind == 3 { triangulate() }
  if kind == 4 { triangulate() for e in edges { if length(e) > 0.1 { triangle::split(e, 0.4) } } }
  if kind == 5 { for f in faces { extrude(f, 0, 0.2) } }
  if kind == 6 { triangulate() linear() }
}
script compare() {
  for f in faces { assert f.side == side_of(centroid(f)) }
  for e in edges { assert e.ridge == lies_on_a_ridge(e) }
  for h in halfedges {
    assert h.corner == vec3(9) or distance(h.corner, h.vertex.position) < 1e-9
  }
  assert count(h.corner != vec3(9) for h in halfedges) >= 24
}
"#;

#[test]
fn places_of_a_surface_keep_their_marks_through_the_library() {
    let program = Program::parse("marked", MARKED).unwrap();
    let script = |name| program.script(name).unwrap();
    for first in 0..7 {
        for second in 0..7 {
            let mut session = Session::new(&program, shape::cube());
            session.run(&script("mark"), ()).unwrap();
            for kind in [first, second] {
                session.run(&script("act"), [("kind", i64::from(kind))]).unwrap();
                let compared = session.run(&script("compare"), ());
                compared.unwrap_or_else(|error| panic!("{first}, {second}: {error}"));
            }
        }
    }
}

#[test]
fn labels_cover_what_is_remeshed() {
    let text = r#"
        use "std/remesh.hedge"
        attr label: face int = inherited(0)
        script go() {
          for f in faces { f.label = if centroid(f).z > 0 { 1 } else { 2 } }
          remesh(0.2)
          assert all(f.label > 0 for f in faces)
          let upper = sum(area(f) for f in faces where f.label == 1)
          assert abs(upper / sum(area(f) for f in faces) - 0.5) < 0.02
        }"#;
    let program = Program::parse("labels", text).unwrap();
    let mut session = Session::new(&program, shape::icosphere(2));
    session.run(&program.script("go").unwrap(), ()).unwrap();
}

/// What an operation sets stays, and what comes from nothing has the default.
#[test]
fn an_assignment_stands_and_the_default_is_for_the_rest() {
    let text = r#"
        attr label: face int = inherited(7)
        attr crease: edge int = inherited(0)
        op split(e: edge) -> m {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }
          after {
            new m f2 f3 e1 e2 e3 i j k l n o
            face f0: v0 -a-> m -j-> v2 -c-> v0
            face f2: m -i-> v1 -b-> v2 -k-> m
            face f1: m -d-> v0 -g-> v3 -l-> m
            face f3: v1 -n-> m -o-> v3 -h-> v1
            edge e: a | d
            edge e1: i | n
            edge e2: j | k
            edge e3: l | o
            m.position = midpoint(e)
            f3.label = 5
          }
        }
        script go() {
          for f in faces { f.label = 3 }
          for e in edges {
            e.crease = 4
            let m = must split(e)
            assert count(f.label == 3 for f in faces) == 5
            assert count(f.label == 5 for f in faces) == 1
            assert count(g.crease == 4 for g in m.edges) == 2
            assert count(g.crease == 0 for g in m.edges) == 2
            break
          }
        }"#;
    let program = Program::parse("split", text).unwrap();
    let mut session = Session::new(&program, shape::tetrahedron());
    session.run(&program.script("go").unwrap(), ()).unwrap();
}

/// A corner is found by its name, or as the start of a path behind a name
#[test]
fn a_halfedge_inherits_from_the_corner_where_a_path_begins() {
    let text = r#"
        attr uv: halfedge vec3 = inherited(vec3(9))
        op chord(f: face, h: halfedge) {
          before { face f: v0 -h-> v1 =P=> v0 }
          after {
            new x y k g
            face f: v0 -h-> v1 -x-> v0
            face g: v0 -y-> v1 =P=> v0
            edge k: x | y
          }
        }
        op dig(f: face, h: halfedge) {
          before { face f: v1 =P=> v0 -h-> v1 }
          after {
            new x y k g
            face f: v0 -h-> v1 -x-> v0
            face g: v1 =P=> v0 -y-> v1
            edge k: x | y
          }
        }
        script act(last: bool) {
          for h in halfedges { h.uv = h.vertex.position }
          for h in halfedges where not hole(h.face) {
            if last { must dig(h.face, h) } else { must chord(h.face, h) }
          }
          for h in halfedges { assert h.uv == h.vertex.position }
        }"#;
    let program = Program::parse("chord", text).unwrap();
    for last in [false, true] {
        let mut session = Session::new(&program, shape::grid(2, 2));
        session.run(&program.script("act").unwrap(), [("last", last)]).unwrap();
    }
}

/// Both edges along a cut are marked as the one that is cut.
#[test]
fn an_edge_that_is_cut_open_is_marked_on_both_sides() {
    let text = r#"
        attr seam: edge int = inherited(0)
        op slit(e: edge) -> x {
          before {
            face f: v0 -a-> v1 =P=> v0
            edge e: a | d
          }
          after {
            new x p q e1
            face f: v0 -a-> v1 =P=> v0
            hole x: v1 -p-> v0 -q-> v1
            edge e: a | p
            edge e1: d | q
          }
        }
        script go() {
          var n = 1
          for e in edges {
            e.seam = n
            n = n + 1
            must slit(e)
          }
          assert count(edges) == 12
          assert all(e.seam > 0 and boundary(e) for e in edges)
          assert all(count(o.seam == e.seam for o in edges) == 2 for e in edges)
        }"#;
    let program = Program::parse("slit", text).unwrap();
    let mut session = Session::new(&program, shape::tetrahedron());
    session.run(&program.script("go").unwrap(), ()).unwrap();
}
