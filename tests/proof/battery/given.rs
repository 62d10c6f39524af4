//! Where several elements are given, or a face is drawn as one path: the reference says that
//! matching begins at each halfedge in turn.

use std::sync::Arc;

use hedgerow::check::check;
use hedgerow::compile::compile;
use hedgerow::mesh::{Level, Mesh, shape};
use hedgerow::rewrite::{Machine, Outcome, Plan};

use crate::battery::bases::read_back;
use crate::battery::emitted::do_what_the_machine_does;
use crate::battery::trial::Pool;
use support::meshes::{Dice, meshes};

/// The family of the face begins at the twin of the halfedge that is given.
const TWIN: &str = "op twin(f: face, b[0]: halfedge) {
  before {
    face f: each i { v[i] -a[i]-> }
    edge e[i]: a[i] | b[i]
  }
  after { keep f e[i] }
}";

/// Some corner of the face has three edges.
const CORNER: &str = "op corner(f: face) {
  before { face f: v =P=> v }
  require degree(v) == 3 else \"no corner has three edges\"
  after { face f: v =P=> v }
}";

fn plan(text: &str) -> Plan {
    let (sources, op) = read_back(text).expect("it is in order");
    let proved = check(&op).expect("it is right");
    compile(&proved, &sources, &Arc::default()).expect("a small op")
}

fn applies(plan: &Plan, mesh: &Mesh, given: &[u32]) -> bool {
    let slots: Vec<_> = given.iter().map(|&element| u64::from(element)).collect();
    let outcome = Machine::default().apply(&mut mesh.clone(), plan, &slots);
    matches!(outcome.expect("nothing traps"), Outcome::Applied { .. })
}

#[test]
fn a_second_parameter_turns_the_family_of_the_first() {
    let (plan, mesh) = (plan(TWIN), shape::cube());
    let mut applied = 0;
    for f in mesh.faces() {
        for b in mesh.halfedges() {
            let fits = mesh.face(mesh.twin(b)) == f;
            assert_eq!(applies(&plan, &mesh, &[f.0, b.0]), fits, "{f} and {b}");
            applied += usize::from(fits);
        }
    }
    assert_eq!(applied, 24);
}

#[test]
fn a_face_that_is_one_path_is_tried_at_each_corner() {
    let plan = plan(CORNER);
    for start in 0..4 {
        let mut mesh = shape::grid(2, 2);
        for f in mesh.faces().collect::<Vec<_>>() {
            let turned = mesh.face_halfedges(f).nth(start).expect("it has four sides or more");
            mesh.set_face_halfedge(f, turned);
        }
        let mut faces = mesh.faces().filter(|&f| !mesh.is_hole(f));
        assert!(faces.all(|f| applies(&plan, &mesh, &[f.0])), "begun at {start}");
        let cube = shape::octahedron();
        assert!(cube.faces().all(|f| !applies(&plan, &cube, &[f.0])));
    }
}

/// What the link condition says of an edge, whatever lies at it.
const LINK: &str = "op contracts(e: edge) {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
  }
  require link_condition(e) else \"no\"
  after { keep f0 f1 e }
}";

#[test]
fn emitted_code_knows_the_link_condition_of_polygons() {
    let mut meshes = meshes(Level::Simple, &mut Dice(5));
    meshes.retain(|mesh| mesh.halfedge_count() < 120);
    assert!(meshes.len() > 20);
    do_what_the_machine_does(&[LINK], &Pool::of(meshes), 4);
}

#[test]
fn emitted_code_tries_as_many() {
    do_what_the_machine_does(&[TWIN, CORNER], &Pool::new(120, 60, 3), 3);
}
