//! Operations to guard. Each starts at a halfedge, so that there is at most one match.

use hedgerow::analysis::Analysis;
use hedgerow::rewrite::Plan;
use hedgerow::source::Sources;

/// An operation with `GUARD` in place of its guard.
pub struct Op {
    pub name: &'static str,
    pub text: &'static str,
    /// Whether it has a second halfedge.
    pub two: bool,
}

const fn op(name: &'static str, text: &'static str) -> Op {
    let two = false;
    Op { name, text, two }
}

pub const OPS: &[Op] = &[
    op(
        "flip",
        "op flip(a: halfedge) {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }
          GUARD
          after {
            face f0: v3 -a-> v2 -c-> v0 -g-> v3
            face f1: v2 -d-> v3 -h-> v1 -b-> v2
            edge e: a | d
          }
        }",
    ),
    op(
        "flip_any",
        "op flip_any(a: halfedge) {
          before {
            face f0: v0 -a-> v1 -b-> v2 =P=> v0
            face f1: v1 -d-> v0 -g-> v3 =Q=> v1
            edge e: a | d
          }
          GUARD
          after {
            face f0: v3 -a-> v2 =P=> v0 -g-> v3
            face f1: v2 -d-> v3 =Q=> v1 -b-> v2
            edge e: a | d
          }
        }",
    ),
    op(
        "split",
        "op split(a: halfedge) -> m {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
          }
          GUARD
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
        }",
    ),
    op(
        "split_border",
        "op split_border(a: halfedge) -> m {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            hole f1: v1 -d-> v0 =P=> v1
            edge e: a | d
          }
          GUARD
          after {
            new m p q r t f2 e1 e2
            face f0: v0 -a-> m -p-> v2 -c-> v0
            face f2: m -q-> v1 -b-> v2 -r-> m
            hole f1: v1 -d-> m -t-> v0 =P=> v1
            edge e: a | t      edge e1: q | d
            edge e2: p | r
            m.position = (v0.position + v1.position) / 2
          }
        }",
    ),
    op(
        "bisect",
        "op bisect(a: halfedge) -> m {
          before {
            loop f0: v0 -a-> v1 =P=> v0
            loop f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
          }
          GUARD
          after {
            new m p q e1
            loop f0: v0 -a-> m -p-> v1 =P=> v0
            loop f1: v1 -d-> m -q-> v0 =Q=> v1
            edge e: a | q
            edge e1: p | d
            m.position = (v0.position + v1.position) / 2
          }
        }",
    ),
    op(
        "collapse",
        "op collapse(a: halfedge) -> v0 {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            face f1: v1 -d-> v0 -g-> v3 -h-> v1
            edge e: a | d
            edge eb: b | b'    edge ec: c | c'
            edge eg: g | g'    edge eh: h | h'
            vertex v1: d h' *S b
          }
          GUARD
          after {
            edge eb: b' | c'
            edge eg: g' | h'
            vertex v0: h' *S c' *
            vertex v2: b' *
            vertex v3: g' *
            erase v1 e a d b c g h f0 f1 ec eh
            v0.position = (v0.position + v1.position) / 2
          }
        }",
    ),
    op(
        "collapse_border",
        "op collapse_border(a: halfedge) -> v0 {
          before {
            face f0: v0 -a-> v1 -b-> v2 -c-> v0
            hole f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
            edge eb: b | b'    edge ec: c | c'
            vertex v1: d *S b
          }
          GUARD
          after {
            edge eb: b' | c'
            hole f1: v0 =Q=> v0
            vertex v0: *S c' *
            vertex v2: b' *
            erase v1 e a d b c f0 ec
            v0.position = (v0.position + v1.position) / 2
          }
        }",
    ),
    op(
        "contract",
        "op contract(a: halfedge) -> v0 {
          before {
            loop f0: v0 -a-> v1 =P=> v0
            loop f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
            vertex v1: d *S
          }
          GUARD
          after {
            loop f0: v0 =P=> v0
            loop f1: v0 =Q=> v0
            vertex v0: * *S
            erase v1 e a d
            v0.position = (v0.position + v1.position) / 2
          }
        }",
    ),
    op(
        "dissolve_edge",
        "op dissolve_edge(a: halfedge) -> f0 {
          before {
            face f0: v0 -a-> v1 =P=> v0
            face f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
          }
          GUARD
          after {
            face f0: v1 =P=> v0 =Q=> v1
            erase e a d f1
          }
        }",
    ),
    op(
        "dissolve_into_hole",
        "op dissolve_into_hole(a: halfedge) -> f0 {
          before {
            hole f0: v0 -a-> v1 =P=> v0
            face f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
          }
          GUARD
          after {
            hole f0: v1 =P=> v0 =Q=> v1
            erase e a d f1
          }
        }",
    ),
    op(
        "dissolve_any",
        "op dissolve_any(a: halfedge) -> f0 {
          before {
            loop f0: v0 -a-> v1 =P=> v0
            loop f1: v1 -d-> v0 =Q=> v1
            edge e: a | d
          }
          GUARD
          after {
            loop f0: v1 =P=> v0 =Q=> v1
            erase e a d f1
          }
        }",
    ),
    op(
        "open_face",
        "op open_face(a: halfedge) -> f {
          before { face f: v0 -a-> v1 =P=> v0 }
          GUARD
          after { hole f: v0 -a-> v1 =P=> v0 }
        }",
    ),
    op(
        "fill_hole",
        "op fill_hole(a: halfedge) -> f {
          before { hole f: v0 -a-> v1 =P=> v0 }
          GUARD
          after { face f: v0 -a-> v1 =P=> v0 }
        }",
    ),
    op(
        "zip",
        "op zip(a: halfedge) -> v0 {
          before {
            hole f: v0 -a-> v1 -b-> v2 =P=> v0
            edge ea: a | a'    edge eb: b | b'
            vertex v2: b' *S
          }
          GUARD
          after {
            hole f: v0 =P=> v0
            edge ea: a' | b'
            vertex v0: b' *S *
            vertex v1: a' *
            erase a b eb v2
          }
        }",
    ),
    op(
        "refill",
        "op refill(a: halfedge) {
          before {
            loop f: v0 -a-> v1 -b-> v2 =P=> v0
            edge e: a | d
            vertex v1: b d
          }
          GUARD
          after {
            loop f: v0 -a-> v1 -b-> v2 =P=> v0
            keep e v1
          }
        }",
    ),
    Op {
        name: "connect",
        text: "op connect(a: halfedge, b: halfedge) -> e {
          before {
            face f: v0 -a-> v1 =P=> v2 -b-> v3 =Q=> v0
          }
          GUARD
          after {
            new e x y g
            face f: v0 -a-> v1 =P=> v2 -x-> v0
            face g: v0 -y-> v2 -b-> v3 =Q=> v0
            edge e: x | y
          }
        }",
        two: true,
    },
    Op {
        name: "part_vertex",
        text: "op part_vertex(a: halfedge, b: halfedge) -> w {
          before {
            loop f0: v -a-> v1 =P=> v
            loop f1: v -b-> v2 =Q=> v
            vertex v: a *S b *T
          }
          GUARD
          after {
            new w e x y
            loop f0: v -a-> v1 =P=> w -y-> v
            loop f1: w -b-> v2 =Q=> v -x-> w
            edge e: x | y
            vertex v: a x *T
            vertex w: b y *S
            w.position = v.position
          }
        }",
        two: true,
    },
];

/// The plan of the op in a text, if the op is proved.
pub fn try_compiled(text: &str) -> Option<Plan> {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge", text);
    let analysis = Analysis::of(&sources, file);
    let plan = analysis.plans.first()?.clone();
    plan.filter(|_| analysis.is_sound())
}

fn compiled(text: &str) -> Plan {
    try_compiled(text).unwrap_or_else(|| panic!("not proved:\n{text}"))
}

impl Op {
    pub fn guarded(&self, level: &str) -> Plan {
        compiled(&self.text.replace("GUARD", &format!("guard {level}")))
    }

    pub fn bare(&self) -> Plan {
        compiled(&self.text.replace("GUARD", ""))
    }
}
