//! Scripts know the level of their mesh: an op with a guard runs on no other.

use hedgerow::analysis::Analysis;
use hedgerow::mesh::{ElementKind, Level, Mesh, shape, validate_level};
use hedgerow::rewrite::Unwatched;
use hedgerow::run::{Argument, Failure, Report, apply, prepare, run};
use hedgerow::source::Sources;

const OPS: &str = "
op collapse(e: edge) -> v0 {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
    edge eb: b | b'    edge ec: c | c'
    edge eg: g | g'    edge eh: h | h'
    vertex v1: d h' *S b
  }
  guard simple
  after {
    edge eb: b' | c'
    edge eg: g' | h'
    vertex v0: h' *S c' *
    vertex v2: b' *
    vertex v3: g' *
    erase v1 e a d b c g h f0 f1 ec eh
    v0.position = (v0.position + v1.position) / 2
  }
}
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  REQUIRE
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
script main() {
  for e in edges { flip(e) }
  for e in edges { collapse(e) }
}";

fn run_on(mesh: &mut Mesh, require: &str) -> Result<Report, Box<Failure>> {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", OPS.replace("REQUIRE", require));
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap();
    run(&prepared, mesh, &[], &mut Unwatched)
}

const NOT_ADJACENT: &str = "require not adjacent(v2, v3)";

#[test]
fn what_keeps_the_level_may_come_before() {
    let mut mesh = shape::icosphere(2);
    let report = run_on(&mut mesh, NOT_ADJACENT).unwrap();
    assert!(report.ops.iter().all(|op| op.applied > 0), "{report:?}");
    assert!(!report.ops[0].refused.is_empty(), "{report:?}");
    validate_level(&mesh, Level::Simple).unwrap();
}

#[test]
fn what_may_break_the_level_may_not() {
    let failure = run_on(&mut shape::icosphere(1), "").unwrap_err();
    assert_eq!(failure.diagnostic.code, "below-level");
    assert_eq!(
        failure.diagnostic.message,
        "`collapse` is for meshes of level simple, and after `flip` this one is not"
    );
}

#[test]
fn a_mesh_below_the_level_is_refused_with_the_place() {
    let mut mesh = shape::pillow(3);
    let before = mesh.clone();
    let failure = run_on(&mut mesh, NOT_ADJACENT).unwrap_err();
    assert_eq!(failure.diagnostic.code, "below-level");
    assert_eq!(failure.diagnostic.notes, ["face 0 and face 1 have the same corners"]);
    assert!(hedgerow::mesh::identical(&before, &mesh));
}

/// An op in steps has no level of its own; the step that has one asks for it.
#[test]
fn applied_alone_a_step_asks_for_its_level() {
    let steps =
        "op both(e: edge) -> vertex { steps { flip(e)  let v = must collapse(e)  return v } }";
    let mut sources = Sources::new();
    let text = format!("{}\n{steps}", OPS.replace("REQUIRE", ""));
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    assert!(analysis.is_sound(), "{:?}", analysis.diagnostics);
    let op = analysis.program.ops.iter().position(|op| op.name == "both").unwrap();
    let mut mesh = shape::pillow(3);
    let before = mesh.clone();
    let arguments = [("e".to_owned(), Argument::Element(ElementKind::Edge, 0))];
    let applied = apply(&analysis.program, op, &analysis.plans, &mut mesh, &arguments);
    let told = applied.unwrap_err().diagnostic;
    assert_eq!(told.code, "below-level");
    assert_eq!(
        told.message,
        "`collapse`, a step of `both`, is for meshes of level simple, and this one is not"
    );
    assert!(hedgerow::mesh::identical(&before, &mesh));
}
