//! `drain` against a loop that computes all keys anew in each turn.

use super::*;
use hedgerow::mesh::{ElementKind, identical, shape};

/// What is drained how.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drained<'t> {
    /// `edges`, `e`
    pub(super) elements: &'t str,
    pub(super) key: &'t str,
    pub(super) condition: &'t str,
    pub(super) body: &'t str,
}

const ATTRIBUTES: &str = "
attr visits: edge int = 0
attr heat: vertex real = 1
";

const DECLARATIONS: &str = "
attr known: edge real = 0/0
attr queued: edge bool = false
attr known: vertex real = 0/0
attr queued: vertex bool = false
attr known: face real = 0/0
attr queued: face bool = false
attr known: halfedge real = 0/0
attr queued: halfedge bool = false
";

impl Drained<'_> {
    pub(super) fn quick(self) -> String {
        let Self { elements, key, condition, body } = self;
        format!(
            "{DECLARATIONS}
             script main() {{
               var turns = 0
               drain x in {elements} by {key} while turns < 300 and ({condition}) {{
                 turns = turns + 1
                 print x
                 {body}
               }}
             }}"
        )
    }

    /// Step by step what the reference says of `drain`.
    pub(super) fn slow(self) -> String {
        let Self { elements, key, condition, body } = self;
        format!(
            "{DECLARATIONS}
             script main() {{
               var turns = 0
               while true {{
                 for x in {elements} {{
                   let key: real = {key}
                   if key != x.known {{ x.known = key  x.queued = key < infinity }}
                 }}
                 var least: real = infinity
                 for x in {elements} where x.queued {{ if x.known < least {{ least = x.known }} }}
                 if least == infinity {{ return }}
                 var found = false
                 for x in {elements} where not found and x.queued and x.known == least {{
                   found = true
                   if not (turns < 300 and ({condition})) {{ return }}
                   x.queued = false
                   turns = turns + 1
                   print x
                   {body}
                 }}
               }}
             }}"
        )
    }
}

/// Takes the attributes away that only the slow reading needs.
pub(super) fn forget_keys(mesh: &mut Mesh) {
    for kind in ElementKind::ALL {
        for name in ["known", "queued"] {
            if let Some(column) = mesh.find_column(kind, name) {
                mesh.remove_column(column);
            }
        }
    }
}

const CASES: [Drained<'_>; 16] = [
    Drained {
        elements: "edges",
        key: "length(x)",
        condition: "count(faces) > 20",
        body: "collapse(x, 100.0)",
    },
    Drained {
        elements: "edges",
        key: "-length(x)",
        condition: "length(x) > 0.4",
        body: "split(x)",
    },
    // Keys with ties, of what is around the edge.
    Drained {
        elements: "edges",
        key: "degree(x.halfedge.vertex) + degree(x.halfedge.target)",
        condition: "true",
        body: "flip(x)  x.visits = x.visits + 1",
    },
    // Those that are left get another turn when a key changes.
    Drained {
        elements: "edges",
        key: "if x.visits > 2 { infinity } else { length(x) + x.visits }",
        condition: "true",
        body: "if x.visits < 10 { x.visits = x.visits + 1 }  collapse(x, 0.9)",
    },
    Drained {
        elements: "edges",
        key: "if boundary(x) { infinity } else { -angle(normal(x.halfedge.face), normal(x.halfedge.twin.face)) }",
        condition: "true",
        body: "if turns mod 3 == 0 { collapse(x, 100.0) } else { if turns mod 3 == 1 { split(x) } else { flip(x) } }",
    },
    // New elements take the places of erased ones.
    Drained {
        elements: "edges",
        key: "abs(length(x) - 0.5)",
        condition: "true",
        body: "if length(x) > 0.5 { split(x) } else { collapse(x, 100.0) }",
    },
    Drained {
        elements: "vertices",
        key: "-(degree(x))",
        condition: "degree(x) > 5",
        body: "var done = false  for e in x.edges where not done { if flip(e) { done = true } }",
    },
    Drained {
        elements: "vertices",
        key: "sum(w.heat for w in x.neighbors) / degree(x)",
        condition: "true",
        body: "x.heat = x.heat * 0.5  for w in x.neighbors where w.heat < 3 { w.heat = w.heat + x.heat }",
    },
    Drained {
        elements: "vertices",
        key: "length(mean(w.position for w in x.neighbors) - x.position) + dot(normal(x), vec3(0, 0, 0.1))",
        condition: "true",
        body: "update w in x.neighbors { w.position = mix(w.position, mean(u.position for u in w.neighbors), 0.3) }",
    },
    Drained {
        elements: "faces",
        key: "area(x) + 0 * x.halfedge.prev.vertex.heat",
        condition: "area(x) < 1",
        body: "collapse(x.halfedge.edge, 100.0)",
    },
    Drained {
        elements: "faces",
        key: "-max(distance(h.vertex, h.target) for h in x.halfedges) + 0.01 * distance(centroid(x), vec3(1, 1, 1))",
        condition: "true",
        body: "split(x.halfedge.next.edge)",
    },
    Drained {
        elements: "halfedges",
        key: "if x.face == x.edge.halfedge.face { length(x) } else { length(x.next) + 1 }",
        condition: "true",
        body: "if turns mod 2 == 0 { flip(x.edge) } else { collapse(x.edge, 100.0) }",
    },
    // All of the mesh is read.
    Drained {
        elements: "edges",
        key: "abs(length(x) - mean(length(e) for e in edges)) + count(vertices) * 0.001",
        condition: "turns < 25",
        body: "if turns mod 2 == 0 { split(x) } else { collapse(x, 100.0) }",
    },
    Drained {
        elements: "edges",
        key: "if link_condition(x) { length(x) } else { length(x) + 10 }",
        condition: "length(x) < 10",
        body: "collapse(x, 100.0)",
    },
    Drained {
        elements: "vertices",
        key: "if any(boundary(w) and adjacent(w, x) for w in x.neighbors) { infinity } else { min(length(e) for e in x.edges) }",
        condition: "true",
        body: "for e in x.edges { collapse(e, 0.8) }",
    },
    // The key reads a variable that changes.
    Drained {
        elements: "edges",
        key: "if turns mod 7 < 3 { length(x) } else { -length(x) }",
        condition: "true",
        body: "flip(x)",
    },
];

#[test]
fn keys_are_as_if_all_were_computed_in_each_turn() {
    let meshes = [
        shape::icosphere(1),
        shape::triangle_grid(4, 3),
        shape::triangle_torus(4, 5),
        shape::tetrahedron(),
    ];
    let (mut turns, mut long) = (0, 0);
    for case in CASES {
        for mesh in &meshes {
            let [mut quick, mut slow] = [mesh.clone(), mesh.clone()];
            let (report, visited) =
                try_run(&mut quick, &format!("{ATTRIBUTES}{}", case.quick()), &[]).unwrap();
            let (expected_report, expected) =
                try_run(&mut slow, &format!("{ATTRIBUTES}{}", case.slow()), &[]).unwrap();
            let first = visited.iter().zip(&expected).position(|(x, y)| x != y);
            assert_eq!(visited, expected, "{case:?}: differs at turn {first:?}");
            assert_eq!(report, expected_report, "{case:?}");
            [&mut quick, &mut slow].into_iter().for_each(forget_keys);
            assert!(identical(&quick, &slow), "{case:?}");
            turns += visited.len();
            long += usize::from(visited.len() > 20);
        }
    }
    assert!(turns > 4000 && long > 30, "{turns} turns, {long} of many");
}

#[test]
fn a_drain_inside_of_another_keeps_the_keys_of_both() {
    let quick = "
        attr a: vertex real = 1
        script main() {
          var turns = 0
          drain v in vertices by v.a + degree(v) while turns < 60 {
            print v
            turns = turns + 1
            drain e in v.edges by length(e) + e.halfedge.vertex.a while turns mod 4 != 0 {
              print e
              turns = turns + 1
              if let m = split(e) { m.a = v.a + 1  v.a = v.a + 0.25 }
            }
            v.a = v.a + 1
          }
        }";
    let slow = "
        attr a: vertex real = 1
        attr known: vertex real = 0/0
        attr queued: vertex bool = false
        attr key: edge real = 0/0
        attr waits: edge bool = false
        attr mine: edge bool = false
        script main() {
          var turns = 0
          var more = true
          while more {
            for v in vertices where v.a + degree(v) != v.known {
              v.known = v.a + degree(v)
              v.queued = true
            }
            var done = false
            more = false
            for v in vertices where v.queued {
              if not done and v.known == min(w.known for w in vertices where w.queued) {
                done = true
                more = turns < 60
                if more {
                  v.queued = false
                  print v
                  turns = turns + 1
                  for e in edges { e.mine = false  e.key = 0/0 }
                  for e in v.edges { e.mine = true  }
                  var again = true
                  while again {
                    for e in edges where e.mine {
                      let key = length(e) + e.halfedge.vertex.a
                      if key != e.key { e.key = key  e.waits = true }
                    }
                    again = false
                    var found = false
                    for e in edges where e.mine and e.waits and not found {
                      if e.key == min(f.key for f in edges where f.mine and f.waits) {
                        found = true
                        if turns mod 4 != 0 {
                          again = true
                          e.waits = false
                          print e
                          turns = turns + 1
                          if let m = split(e) { m.a = v.a + 1  v.a = v.a + 0.25 }
                        }
                      }
                    }
                  }
                  v.a = v.a + 1
                }
              }
            }
          }
        }";
    let (_, visited) = try_run(&mut shape::icosphere(1), quick, &[]).unwrap();
    let (_, expected) = try_run(&mut shape::icosphere(1), slow, &[]).unwrap();
    assert_eq!(visited, expected);
    assert!(visited.len() >= 60, "{}", visited.len());
}

#[test]
fn shortest_paths_come_out_of_a_drain() {
    // Dijkstra's algorithm: who is reached comes into the queue again.
    let script = "
        attr far: vertex real = infinity
        script main() {
          var first = true
          for v in vertices where first { v.far = 0  first = false }
          var turns = 0
          drain v in vertices by v.far {
            turns = turns + 1
            for w in v.neighbors where v.far + 1 < w.far { w.far = v.far + 1 }
          }
          print turns, max(v.far for v in vertices), sum(v.far for v in vertices)
        }";
    let (_, lines) = try_run(&mut shape::icosahedron(), script, &[]).unwrap();
    // One at 0, five at 1, five at 2, one at 3; each is taken once.
    assert_eq!(lines, ["12 3 18"]);
}

#[test]
fn a_key_that_is_not_a_number_stops_the_script() {
    let script = "script main() { drain v in vertices by sqrt(v.position.x) { print v } }";
    let failure = try_run(&mut shape::cube(), script, &[]).unwrap_err();
    assert_eq!(failure.diagnostic.code, "key-not-a-number");
    assert!(failure.diagnostic.span().start > 0);
}

#[test]
fn slots_are_used_again_while_a_drain_runs() {
    let mut mesh = shape::icosphere(1);
    let script = "
        script main() {
          var turns = 0
          drain e in edges by abs(length(e) - 0.5) while turns < 3000 {
            turns = turns + 1
            if count(edges) < 130 { split(e) } else { collapse(e, 100.0) }
          }
        }";
    let (report, _) = try_run(&mut mesh, script, &[]).unwrap();
    assert!(applied(&report, "split") > 100, "{report:?}");
    assert!(mesh.capacity(ElementKind::Edge) < 200);
}

#[test]
fn leaving_a_drain_ends_it() {
    let lines = printed(
        &mut shape::cube(),
        "var n = 0
         repeat 3 {
           drain v in vertices by -v.position.x {
             n = n + 1
             if n mod 2 == 0 { continue }
             if n > 2 { break }
           }
         }
         print n
         drain v in vertices by v.position.x { print v  return }",
    );
    assert_eq!(lines[0], "7");
    assert_eq!(lines.len(), 2);
}

#[test]
fn functions_give_keys_and_leave_their_own_drains() {
    let script = "
        fn reach(v: vertex) -> real { max(distance(w, vec3(0, 0, 0)) for w in v.neighbors) + v.heat }
        attr heat: vertex real = 0
        fn coldest(f: face) -> vertex {
          drain w in f.vertices by w.heat { return w }
          return f.halfedge.vertex
        }
        script main() {
          var turns = 0
          drain v in vertices by reach(v) while turns < 40 {
            turns = turns + 1
            for f in v.faces { let w = coldest(f)  w.heat = w.heat + 1 }
          }
          print turns, sum(v.heat for v in vertices)
        }";
    let (_, lines) = try_run(&mut shape::icosahedron(), script, &[]).unwrap();
    assert_eq!(lines, ["40 200"]);
}

#[test]
fn large_meshes_are_drained_in_order() {
    // Large enough that the drain looks ahead; what it looks at is erased and made meanwhile.
    let mut mesh = shape::triangle_grid(100, 100);
    let script = "
        attr last: vertex real = -1
        attr heat: face real = 1
        script main() {
          var turns = 0
          drain e in edges by abs(length(e) - 1.1) while turns < 500 {
            turns = turns + 1
            if turns mod 3 == 0 { split(e) } else { collapse(e, 100.0) }
          }
          var so_far = -1.0
          for v in vertices { v.last = random() }
          drain v in vertices by v.last { assert v.last >= so_far  so_far = v.last }
          so_far = -1.0
          for f in faces { f.heat = random() }
          drain f in faces by f.heat { assert f.heat >= so_far  so_far = f.heat }
          so_far = -infinity
          drain h in halfedges by h.vertex.last + h.target.last {
            assert h.vertex.last + h.target.last >= so_far
            so_far = h.vertex.last + h.target.last
          }
        }";
    let (report, _) = try_run(&mut mesh, script, &[]).unwrap();
    assert!(applied(&report, "split") > 50 && applied(&report, "collapse") > 50, "{report:?}");
}

#[test]
fn an_int_is_a_key_if_reals_tell_it_apart() {
    for (key, is_one) in [
        ("-9007199254740993", false),
        ("-9007199254740992", true),
        ("9007199254740992", true),
        ("9007199254740993", false),
        ("-9223372036854775807 - 1", false),
        ("9223372036854775807", false),
    ] {
        let script = format!("script main() {{ drain v in vertices by {key} {{ print v }} }}");
        match try_run(&mut shape::cube(), &script, &[]) {
            Ok((_, lines)) => assert!(is_one && lines.len() == 8, "{key}"),
            Err(failure) => {
                assert!(!is_one, "{key}");
                assert!(failure.diagnostic.message.contains("beyond 2^53"), "{key}");
            }
        }
    }
}
