//! Operations in steps: all or nothing, wherever they are called.

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{ElementKind, Level, Mesh, identical, shape, validate_level};
use hedgerow::rewrite::{Machine, Outcome, Watch};
use hedgerow::run::{Report, prepare, run};
use hedgerow::source::Sources;

fn analyse(text: &str) -> Analysis {
    let mut sources = Sources::new();
    let root = sources.add("test.hedge", text);
    Analysis::with(&mut sources, root, &mut Nowhere)
}

fn sound(text: &str) -> Analysis {
    let analysis = analyse(text);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    analysis
}

fn codes(text: &str) -> Vec<&'static str> {
    let diagnostics = analyse(text).diagnostics;
    diagnostics.iter().map(|found| found.code).collect()
}

#[derive(Default)]
struct Lines(Vec<String>);

impl Watch for Lines {
    fn print(&mut self, line: &str) {
        self.0.push(line.to_owned());
    }
}

/// Runs the script `main`; gives what it printed.
fn run_main(mesh: &mut Mesh, analysis: &Analysis) -> (Report, Vec<String>) {
    let script = analysis.script("main").unwrap();
    let prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
    let mut lines = Lines::default();
    let report = run(&prepared, mesh, &[], &mut lines).unwrap();
    (report, lines.0)
}

fn meshes() -> Vec<Mesh> {
    vec![
        shape::tetrahedron(),
        shape::cube(),
        shape::octahedron(),
        shape::pillow(4),
        shape::fan(4),
        shape::tube(3, 2),
        shape::tube(4, 1),
        shape::single_polygon(5),
        shape::grid(2, 3),
        shape::triangle_grid(3, 3),
        shape::torus(3, 4),
    ]
}

#[test]
fn refused_steps_leave_no_trace() {
    let analysis = sound("use \"std/polygon.hedge\"");
    let mut machine = Machine::new(&analysis.plans);
    machine.trust_level(Level::Surface);
    let (mut applied, mut refused) = (0, 0);
    for (op, kind) in [
        ("dissolve_vertex", ElementKind::Vertex),
        ("bevel_vertex", ElementKind::Vertex),
        ("bevel_edge", ElementKind::Edge),
        ("extrude", ElementKind::Face),
        ("inset_vertex", ElementKind::Face),
        ("collapse_face", ElementKind::Face),
        ("open_face", ElementKind::Face),
    ] {
        let plan = analysis.plans[analysis.op(op).unwrap()].as_ref().unwrap();
        let mut seen = 0;
        for original in meshes() {
            for at in 0..original.capacity(kind) {
                let mut mesh = original.clone();
                let mut args = vec![at as u64];
                args.resize(plan.params.len(), 0);
                seen += 1;
                match machine.apply(&mut mesh, plan, &args).unwrap() {
                    Outcome::Applied { .. } => {
                        validate_level(&mesh, Level::Surface).unwrap();
                        assert!(!identical(&mesh, &original), "{op} did nothing");
                        applied += 1;
                    }
                    Outcome::Refused { reason } => {
                        assert!(reason.is_some(), "{op} gives no reason");
                        assert!(identical(&mesh, &original), "{op} left a trace");
                        refused += 1;
                    }
                }
            }
        }
        assert!(seen > 60, "{op}: {seen} places");
    }
    println!("{applied} applied, {refused} refused");
    assert!(applied > 400 && refused > 60);
}

const MARKS: &str = "use \"std/map.hedge\"
attr mark: vertex int = 0
op shrink(e: edge) -> vertex {
  guard surface
  steps {
    let v = must contract(e)
    v.mark = v.mark + 1
    must straighten(v)
    return v
  }
}
";

#[test]
fn a_level_that_all_steps_keep_is_kept_and_known() {
    let analysis = sound(
        "use \"std/triangle.hedge\"
         op bare(e: edge) {
           before { face f0: v0 -a-> v1 -b-> v2 -c-> v0  face f1: v1 -d-> v0 -g-> v3 -h-> v1
                    edge e: a | d }
           after { face f0: v3 -a-> v2 -c-> v0 -g-> v3  face f1: v2 -d-> v3 -h-> v1 -b-> v2
                   edge e: a | d }
         }
         op as_it_is(e: edge) { steps { must flip(e) } }
         op of_both(e: edge) { steps { must flip(e) must bare(e) } }
         op guarded(e: edge) { guard simple steps { must bare(e) } }
         op of_steps(e: edge) { steps { must as_it_is(e) must guarded(e) } }",
    );
    let (surface, simple) = (Level::Surface, Level::Simple);
    for (op, keeps, after) in [
        ("as_it_is", &[surface, simple][..], simple),
        ("of_both", &[surface], surface),
        ("guarded", &[surface, simple], simple),
        ("of_steps", &[surface, simple], simple),
    ] {
        let plan = analysis.plans[analysis.op(op).unwrap()].as_ref().unwrap();
        assert_eq!(plan.keeps, keeps, "{op}");
        let mut mesh = shape::icosahedron();
        let mut machine = Machine::new(&analysis.plans);
        machine.trust_level(Level::Map);
        let outcome = machine.apply(&mut mesh, plan, &[0]).unwrap();
        assert!(matches!(outcome, Outcome::Applied { .. }), "{op}");
        // What was found before a step is known after the steps, and need not be found again.
        let known = if op == "guarded" { Level::Map } else { after };
        assert_eq!(machine.level(), known, "{op}");
        validate_level(&mesh, after).unwrap();
    }
}

#[test]
fn attributes_are_undone_as_well() {
    let analysis = sound(&format!(
        "{MARKS}
script main() {{
  for e in edges {{
    if let v = shrink(e) {{ print \"applied\" }}
  }}
  print sum(v.mark for v in vertices), count(vertices)
}}"
    ));
    let mut mesh = shape::cube();
    let before = mesh.clone();
    let (report, lines) = run_main(&mut mesh, &analysis);
    assert_eq!(lines, ["0 8"]);
    assert!(mesh.vertices().eq(before.vertices()));
    // Steps are not counted, and the whole with the reason of the step that refused.
    let [shrink] = report.ops.as_slice() else {
        panic!("{report:?}");
    };
    assert_eq!((shrink.name.as_str(), shrink.applied), ("shrink", 0));
    let times: u64 = shrink.refused.iter().map(|(_, times)| times).sum();
    assert_eq!(times, 12);
}

#[test]
fn steps_are_called_like_any_op() {
    let analysis = sound(
        "use \"std/polygon.hedge\"
script main() {
  for v in vertices { if let f = bevel_vertex(v, 0.3) { print degree(f) } }
  for f in faces where degree(f) > 3 { must inset_vertex(f) }
  for e in edges { flip(e) }
  print count(vertices) - count(edges) + count(faces)
}",
    );
    let mut mesh = shape::cube();
    let (report, lines) = run_main(&mut mesh, &analysis);
    assert_eq!(lines, [&["3"; 8][..], &["2"]].concat());
    validate_level(&mesh, Level::Surface).unwrap();
    let names: Vec<_> = report.ops.iter().map(|op| op.name.as_str()).collect();
    assert_eq!(names.len(), 3, "{names:?}");
}

#[test]
fn a_require_among_the_steps_refuses_all_of_them() {
    let analysis = sound(
        "use \"std/polygon.hedge\"
/// Leaves a face with twice as many sides, if none of its edges is longer than that.
op halve(f: face, longest: real) {
  guard surface
  require degree(f) > 2 else \"never\"
  steps {
    drain e in f.edges by -length(e) while length(e) > 0.5 {
      require length(e) <= longest else \"an edge is too long\"
      must bisect(e)
    }
    for e in f.edges { require length(e) > 0.1 }
  }
}
script main() {
  for f in faces { halve(f, 0.9) halve(f, 1) print degree(f) break }
  let short = vec3(0.25)
  update v in vertices { v.position = v.position * short }
  for f in faces where degree(f) == 4 { halve(f, 1)  print degree(f)  break }
  assert degree(faces_first()) > 2
}
fn faces_first() -> face { argmin(1 for f in faces) }",
    );
    let mut mesh = shape::single_polygon(4);
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for (v, [x, y]) in mesh.clone().vertices().zip(corners) {
        mesh.set_position(v, [x, y, 0.0].into());
    }
    let (report, lines) = run_main(&mut mesh, &analysis);
    assert_eq!(lines, ["8"]);
    let [halve] = report.ops.as_slice() else {
        panic!("{report:?}");
    };
    assert_eq!(halve.applied, 1);
    assert_eq!(halve.refused, [("an edge is too long".to_owned(), 1)]);
}

#[test]
fn what_steps_may_not_be() {
    let around = "op a(e: edge) { steps { must b(e) } } op b(e: edge) { steps { must a(e) } }";
    assert_eq!(codes(around), ["cyclic-steps"; 2]);
    let claims = "op a(e: edge) keeps euler, constant_time { guard surface steps { } }";
    assert_eq!(codes(claims), ["property-not-kept"]);
    let value = "op a(e: edge) -> real { steps { return 1.0 } }";
    assert_eq!(codes(value), ["not-an-element"]);
    let open = "op a(e: edge) -> face { steps { } }";
    assert_eq!(codes(open), ["missing-return"]);
    let both = "op a(e: edge) { before { edge e: a | b } steps { } }";
    assert_eq!(codes(both), ["misplaced-part"]);
}

#[test]
fn steps_with_a_wrong_head_have_no_plan() {
    for (head, code) in [
        ("keeps nonsense { ", "unknown-property"),
        ("keeps constant_time { ", "property-not-kept"),
        ("{ guard nonsense ", "unknown-level"),
        ("{ alias e f guard surface ", "cannot-alias"),
        ("-> real { ", "not-an-element"),
    ] {
        let analysis = analyse(&format!("op a(e: edge) {head} steps {{ }} }}"));
        let codes: Vec<_> = analysis.diagnostics.iter().map(|found| found.code).collect();
        assert_eq!(codes, [code]);
        assert_eq!(analysis.plans[0], None, "{head}");
    }
}

/// A face that is reached from two sides has the corners that it should have, but another
/// halfedge than the drawing says.
#[test]
fn a_refusal_names_what_differs() {
    let analysis = sound(
        "op doublet(v: vertex) -> f {
           before {
             face f: v -a-> w -b-> x -c-> u -d-> v
             face g: v -k-> u -l-> y -m-> w -n-> v
             edge e1: a | n
             edge e2: k | d
           }
           after {
             face f: w -b-> x -c-> u -l-> y -m-> w
             erase v a n k d e1 e2 g
           }
         }
         op quad(f: face) {
           before { face f: v -a-> w -b-> x -c-> u -d-> v }
           after { keep f }
         }
         script main() {
           for v in vertices { print why doublet(v) }
           for f in faces { print why quad(f) }
         }",
    );
    let (_, lines) = run_main(&mut shape::cube(), &analysis);
    assert_eq!(lines[..8], ["`m.next` is not `n`"; 8]);
    assert_eq!(lines[8..], [""; 6]);
    let (_, lines) = run_main(&mut shape::tetrahedron(), &analysis);
    assert_eq!(lines[..4], ["`f` is not a quad"; 4]);
    assert_eq!(lines[4..], ["`f` is not a quad"; 4]);
}

/// A reason that names what a step draws names the step.
#[test]
fn a_reason_about_the_drawing_of_a_step_names_the_step() {
    let text = "use \"std/triangle.hedge\"
        op remove(e: edge) { steps { must flip(e) } }
        script main() { for e in edges where not can remove(e) { print why remove(e) } }";
    let analysis = sound(text);
    for (mut mesh, reason) in [
        (shape::tetrahedron(), "in `flip`, two edges would join `v2` and `v3`"),
        (shape::triangle_grid(1, 1), "in `flip`, "),
    ] {
        let (_, lines) = run_main(&mut mesh, &analysis);
        assert!(lines[0].starts_with(reason), "{lines:?}");
    }
}
