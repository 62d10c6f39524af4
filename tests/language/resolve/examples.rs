//! Whole programs that resolve.

use hedgerow::diagram::{Kind, NameId, Spoke, Type};
use hedgerow::resolve::StatementKind;

use crate::resolve::told::{resolved, told};

/// Operations and a script, as they are published.
pub const PROGRAM: &str = r#"
/// Rotates an edge between two triangles by one corner.
op flip(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  require not adjacent(v2, v3) else "the edge v2 v3 is already there"
  after {
    face f0: v3 -a-> v2 -c-> v0 -g-> v3
    face f1: v2 -d-> v3 -h-> v1 -b-> v2
    edge e: a | d
  }
}

/// Splits an edge between two triangles at its midpoint; returns the new vertex.
op split(e: edge) -> m {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
  }
  after {
    new m p q r s t u f2 f3 e1 e2 e3
    face f0: v0 -a-> m -p-> v2 -c-> v0
    face f2: m -q-> v1 -b-> v2 -r-> m
    face f1: v1 -d-> m -s-> v3 -h-> v1
    face f3: m -t-> v0 -g-> v3 -u-> m
    edge e: a | t      edge e1: q | d
    edge e2: p | r     edge e3: s | u
    m.position = (v0.position + v1.position) / 2
  }
}

/// Merges the two ends of an edge between triangles; v1 goes.
op collapse(e: edge) -> v0 {
  before {
    face f0: v0 -a-> v1 -b-> v2 -c-> v0
    face f1: v1 -d-> v0 -g-> v3 -h-> v1
    edge e: a | d
    edge eb: b | b'    edge ec: c | c'
    edge eg: g | g'    edge eh: h | h'
    vertex v1: d h' *S b
  }
  require link_condition(e) else "the ends have a common neighbour"
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

op flip_any(e: edge) {
  before {
    face f0: v0 -a-> v1 -b-> v2 =P=> v0
    face f1: v1 -d-> v0 -g-> v3 =Q=> v1
    edge e: a | d
  }
  after {
    face f0: v3 -a-> v2 =P=> v0 -g-> v3
    face f1: v2 -d-> v3 =Q=> v1 -b-> v2
    edge e: a | d
  }
}

op contract(e: edge) -> v0 {
  before {
    loop f0: v0 -a-> v1 =P=> v0
    loop f1: v1 -d-> v0 =Q=> v1
    edge e: a | d
    vertex v1: d *S
  }
  after {
    loop f0: v0 =P=> v0
    loop f1: v0 =Q=> v0
    vertex v0: * *S
    erase v1 e a d
    v0.position = (v0.position + v1.position) / 2
  }
}

/// Moves the edges of a mesh towards one length.
script remesh(target: real = 0, iterations: int = 5) {
  let len = if target > 0 { target } else { mean(length(e) for e in edges) }
  repeat iterations {
    for e in edges where length(e) > 4/3 * len { split(e) }
    for e in edges where length(e) < 4/5 * len and link_condition(e) { collapse(e) }
    for e in edges where not boundary(e) {
      let excess = sum(degree(v) - 6 for v in e.vertices)
      if excess > 2 { flip(e) }
    }
    update v in vertices where not boundary(v) {
      let around = mean(w.position for w in v.neighbors)
      let n = normal(v)
      v.position = around - n * dot(n, around - v.position)
    }
  }
  print "edges", count(edges), "mean", mean(length(e) for e in edges)
}
"#;

#[test]
fn the_published_program_resolves() {
    assert_eq!(told(PROGRAM), "");
    let (resolved, _) = resolved(PROGRAM);
    assert_eq!(resolved.program.ops.len(), 5);
    assert!(resolved.program.ops.iter().all(|op| op.diagram.is_some()));
    assert_eq!(resolved.program.scripts.len(), 1);
}

#[test]
fn names_are_numbered_in_order_of_first_mention() {
    let (resolved, _) = resolved(PROGRAM);
    let split = resolved.program.ops[1].diagram.as_ref().unwrap();
    assert_eq!(split.result, Some(Type::Vertex));
    let rule = &split.rules[0];
    let words: Vec<&str> = rule.names.iter().map(|name| name.text.as_str()).collect();
    let expected = "f0 v0 a v1 b v2 c f1 d g v3 h e m p q r s t u f2 f3 e1 e2 e3";
    assert_eq!(words.join(" "), expected);
    assert_eq!(rule.params, [Some(NameId(12))]);
    assert_eq!(rule.created.len(), 12);
    assert_eq!(rule.assignments.len(), 1);
}

#[test]
fn fans_without_a_name_are_the_rest() {
    let (resolved, _) = resolved(PROGRAM);
    let contract = resolved.program.ops[4].diagram.as_ref().unwrap();
    let rule = &contract.rules[0];
    let [Spoke::Rest(_), Spoke::Fan(fan)] = rule.after.stars[0].spokes[..] else {
        panic!("`* *S` is a rest and a fan");
    };
    assert_eq!(rule.kind(fan.name), Kind::Fan);
}

#[test]
fn an_unnamed_path_is_that_of_its_loop_on_both_sides() {
    let (resolved, _) = resolved(
        "op o(e: edge) {
           before { face f: v -a-> w => v  edge e: a | d }
           after { face f: w -a-> v => w  keep e }
         }",
    );
    let rule = &resolved.program.ops[0].diagram.as_ref().unwrap().rules[0];
    let before = rule.before.loops[0].items[1].item.name;
    assert_eq!(before, rule.after.loops[0].items[1].item.name);
    assert_eq!(rule.quoted(before), "the path of `f`");
    assert_eq!(rule.after.kept.len(), 1);
    assert_eq!(rule.after.edges.len(), 1, "what is kept is restated");
    assert_eq!(rule.after.edges[0].span, rule.after.kept[0].span);
}

#[test]
fn must_gives_a_value_or_stops() {
    let (resolved, _) = resolved(
        "op o(v: vertex) -> v {
           before { vertex v: a * } after { keep v }
         }
         script s() {
           for v in vertices { let w = must o(v)
             print w.position
           }
         }",
    );
    assert_eq!(resolved.diagnostics, []);
    let script = &resolved.program.scripts[0];
    let StatementKind::For { body, .. } = &script.body.block[0].kind else {
        panic!("the script is a loop");
    };
    let StatementKind::Apply { variable, otherwise, .. } = &body[0].kind else {
        panic!("the op is asked");
    };
    assert_eq!(script.body.variables[variable.unwrap() as usize].name, "w");
    assert!(matches!(otherwise[0].kind, StatementKind::Refused { .. }));
}
