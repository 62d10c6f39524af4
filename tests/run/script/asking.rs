//! `can` and `why`, random numbers, scripts that call scripts, and levels asked anew.

use super::*;
use hedgerow::mesh::{VertexId, identical, shape};
use hedgerow::{Program, Session};
use support::dice::Dice;

/// Ops with and without a guard.
const MIXED: &str = r#"
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  guard simple
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
op turn(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}
op both(e: edge) {
  guard simple
  steps {
    must flip(e)
    must flip(e)
    require random() < 2 else "never"
  }
}
op never(e: edge) {
  steps {
    must turn(e)
    print "turned"
    require false else "by no means"
  }
}
"#;

fn lines_of(mesh: &mut Mesh, script: &str) -> Vec<String> {
    run_alone(mesh, &format!("{MIXED}\n{script}"), &[]).unwrap().1
}

#[test]
fn what_is_asked_is_what_a_call_does() {
    let mut mesh = shape::triangle_grid(4, 3);
    let lines = lines_of(
        &mut mesh,
        "script main() {
           repeat 3 {
             for e in edges {
               let can_it = can flip(e)
               let reason = why flip(e)
               let twice = can both(e)
               assert can_it == (reason == \"\")
               if flip(e) { assert can_it must flip(e) } else { assert not can_it }
               if both(e) { assert twice } else { assert not twice }
             }
             for e in shuffle(edges) where can flip(e) { must flip(e) }
           }
         }",
    );
    assert!(lines.is_empty());
}

#[test]
fn to_ask_writes_and_counts_nothing() {
    let mut mesh = shape::icosphere(1);
    let before = mesh.clone();
    let script = "script main() {
      for e in edges {
        print can flip(e), why never(e), can both(e), random(1000)
        break
      }
      print count(can flip(e) for e in edges), random(1000)
    }";
    let (report, lines) = run_alone(&mut mesh, &format!("{MIXED}\n{script}"), &[]).unwrap();
    assert!(identical(&before, &mesh));
    assert!(report.ops.iter().all(|op| op.applied == 0 && op.refused.is_empty()), "{report:?}");
    assert!(lines[0].starts_with("true by no means true "), "{lines:?}");
    assert!(lines[1].starts_with("120 "), "{lines:?}");
    let drawn = "script main() { print random(1000) print random(1000) }";
    let without = lines_of(&mut mesh, drawn);
    let last = |line: &String| line.split(' ').next_back().unwrap().to_owned();
    assert_eq!(lines.iter().map(last).collect::<Vec<_>>(), without);
}

#[test]
fn why_tells_the_reason_of_a_call() {
    let lines = lines_of(
        &mut shape::tetrahedron(),
        "script main() { for e in edges { print why flip(e) break } }",
    );
    assert_eq!(lines, ["two edges would join `v2` and `v3`"]);
}

/// A key that asks is computed anew whenever the answer may have changed.
#[test]
fn a_key_that_asks_stays_current() {
    for mut mesh in [shape::triangle_grid(5, 5), shape::icosphere(1), shape::triangle_torus(4, 3)] {
        lines_of(
            &mut mesh,
            "script main() {
               var turns = 0
               drain e in edges by (if can flip(e) { length(e) } else { infinity }) while turns < 60 {
                 must flip(e)
                 turns = turns + 1
               }
               turns = 0
               drain e in edges by (if can both(e) { -length(e) } else { infinity }) while turns < 60 {
                 must both(e)
                 must flip(e)
                 turns = turns + 1
               }
             }",
        );
    }
}

#[test]
fn the_same_seed_gives_the_same_numbers() {
    let program = "script main() {
      print random(6), random(6), random(1000000), random():full
    }"
    .replace("random():full", "\"{random():full}\"");
    let (_, analysis) = analyse(&program);
    let with = |seed| {
        let prepared = prepare(&analysis.program, 0, &analysis.plans).unwrap().with_seed(seed);
        let mut lines = Lines::default();
        run(&prepared, &mut shape::cube(), &[], &mut lines).unwrap();
        lines.0.remove(0)
    };
    assert_eq!(with(0), with(0));
    assert_ne!(with(0), with(1));
    // On every machine.
    assert_eq!([with(0), with(7)], EXPECTED);
}

const EXPECTED: [&str; 2] = ["3 4 103019 0.4165890778296456", "4 1 839627 0.9810977250149351"];

#[test]
fn a_shuffle_visits_each_once() {
    let lines = lines_of(
        &mut shape::cube(),
        "attr seen: edge int = 0
         script main() {
           for e in shuffle(edges) { e.seen = e.seen + 1 print e }
           assert all(e.seen == 1 for e in edges)
           for f in faces { for v in shuffle(f.vertices) where boundary(v) { assert false } }
         }",
    );
    let mut sorted = lines.clone();
    sorted.sort();
    sorted.dedup();
    assert_eq!(sorted.len(), 12);
    let number = |line: &String| line.split(' ').next_back().unwrap().parse::<u32>().unwrap();
    assert!(!lines.iter().map(number).is_sorted(), "{lines:?}");
}

#[test]
fn nothing_is_chosen_of_nothing() {
    let failure = run_alone(&mut shape::cube(), "script main() { print random(0) }", &[]);
    assert_eq!(failure.unwrap_err().diagnostic.code, "nothing-to-choose");
}

#[test]
fn scripts_call_scripts() {
    let lines = lines_of(
        &mut shape::cube(),
        "fn twice(n: int) { shown(n) shown(n, vec3(1, 2, 3)) }
         script shown(n: int, at: vec3 = vec3(0, 0, n), m: int = 6 + n) {
           if n > 100 { return }
           print n, at, m
         }
         script main() {
           shown(1)
           twice(2)
           for f in faces { shown(7, vec3(1), 4) break }
           shown(101)
         }",
    );
    assert_eq!(lines, ["1 (0, 0, 1) 7", "2 (0, 0, 2) 8", "2 (1, 2, 3) 8", "7 (1, 1, 1) 4"]);
}

#[test]
fn a_script_that_calls_itself_is_stopped() {
    let failure = run_alone(&mut shape::cube(), "script main() { main() }", &[]).unwrap_err();
    assert_eq!(failure.diagnostic.code, "calls-too-deep");
}

#[test]
fn operations_in_steps_nest_deeply_but_not_without_end() {
    let ops = |depth: usize| {
        let outer = |at| format!("op f{at}(v: vertex) {{ steps {{ must f{}(v) }} }}\n", at + 1);
        let inner = "op f_(v: vertex) { before { loop f: v -a-> w =P=> v } after { keep f
                     v.position = vec3(7) } }\n";
        let ops: String = (0..depth - 1).map(outer).collect();
        ops + &inner.replace("f_", &format!("f{}", depth - 1))
    };
    let nested = |depth: usize| {
        let call = "script main() { for v in vertices { must f0(v) print v.position.x break } }";
        run_alone(&mut shape::cube(), &(ops(depth) + call), &[])
    };
    assert_eq!(nested(64).unwrap().1, ["7"]);
    assert_eq!(nested(65).unwrap_err().diagnostic.code, "calls-too-deep");
    // As deep as from a script.
    let applied = |depth: usize| {
        let program = Program::parse("nested.hedge", &ops(depth)).unwrap();
        let mut session = Session::new(&program, shape::cube());
        session.apply(&program.op("f0").unwrap(), VertexId(0)).map_err(|error| error.code())
    };
    assert!(applied(64).is_ok());
    assert_eq!(applied(65).unwrap_err(), "calls-too-deep");
}

#[test]
fn a_guarded_op_may_follow_any_other() {
    for mut mesh in [shape::triangle_grid(6, 5), shape::icosphere(2)] {
        // Turned four times, an edge is back.
        let script = "script main() {
          for e in edges where not boundary(e) {
            repeat 4 { must turn(e) }
            flip(e)
          }
          for e in edges { if can flip(e) { must flip(e) must turn(e) } }
        }";
        lines_of(&mut mesh, script);
    }
}

/// What is asked is undone, and with it what its steps have found about the level: a script does the
/// same with questions as without.
#[test]
fn questions_change_nothing() {
    let ops = "
op open(f: face) {
  before { face f: v -a-> w =P=> v }
  after { hole f: v -a-> w =P=> v }
}
op probe(f: face, e: edge) {
  steps {
    must open(f)
    flip(e)
  }
}";
    let calls = ["turn(e)", "flip(e)", "open(f)", "both(e)", "never(e)", "probe(f, e)"];
    let mut dice = Dice(29);
    let (mut done, mut stopped) = (0, 0);
    for round in 0..40 {
        let mut body = String::new();
        for _ in 0..1 + dice.below(5) {
            let mut call = || calls[dice.below(calls.len())];
            let (asked, other, called) = (call(), call(), call());
            let question = format!("if asks {{ if can {asked} {{ }} print why {other} }}");
            body += &format!("f = e.halfedge.face {question} {called}\n");
        }
        let script = format!(
            "script main(asks: bool) {{ for e in edges {{ var f = e.halfedge.face\n{body} }} }}"
        );
        let program = format!("{MIXED}\n{ops}\n{script}");
        // Two faces of a pillow have the same corners, until one of them is opened.
        for shape in [shape::pillow(3), shape::pillow(4), shape::tetrahedron(), shape::grid(2, 1)] {
            let [without, with] = ["false", "true"].map(|asks| {
                let mut mesh = shape.clone();
                let done = run_alone(&mut mesh, &program, &[("asks", asks)]);
                (done.map(|(report, _)| report).map_err(|told| told.diagnostic), mesh)
            });
            // A question stops, too, on a mesh below the level that it is for.
            assert!(without.0.is_ok() || with.0.is_err(), "round {round}: {script}");
            if with.0.is_ok() {
                assert_eq!(without.0, with.0, "round {round}: {script}");
                assert!(identical(&without.1, &with.1), "round {round}: {script}");
            }
            match with.0 {
                Ok(_) => done += 1,
                Err(_) => stopped += 1,
            }
        }
    }
    assert!(done > 10 && stopped > 40, "{done} done, {stopped} stopped");
}

#[test]
fn below_the_level_it_is_said_where_and_after_what() {
    let script = "script main() { for e in edges { turn(e) } for e in edges { flip(e) } }";
    let mut mesh = shape::tetrahedron();
    let failure = run_alone(&mut mesh, &format!("{MIXED}\n{script}"), &[]).unwrap_err();
    let said = failure.diagnostic;
    assert_eq!(said.code, "below-level");
    assert_eq!(
        said.message,
        "`flip` is for meshes of level simple, and after `turn` this one is not"
    );
    assert_eq!(said.notes.len(), 1, "{said:?}");
}
