//! What loops visit, and when writes happen.

use super::*;
use hedgerow::mesh::{ElementKind, VertexId, shape};

#[test]
fn a_loop_does_not_visit_what_is_born_inside() {
    let mut mesh = shape::icosahedron();
    let (report, lines) = run_body(
        &mut mesh,
        "for e in edges { split(e) }
         print count(edges), count(vertices), count(faces)",
    );
    assert_eq!(applied(&report, "split"), 30);
    assert_eq!(lines, ["120 42 80"]);
}

#[test]
fn a_slot_freed_before_a_loop_and_filled_inside_is_not_visited() {
    let mut mesh = shape::icosphere(1);
    let (report, lines) = run_body(
        &mut mesh,
        "var done = false
         for e in edges { if not done { if collapse(e, 100.0) { done = true } } }
         print count(edges)
         for e in edges { split(e) }
         print count(edges)",
    );
    assert_eq!(applied(&report, "collapse"), 1);
    assert_eq!(lines[0], "117");
    assert_eq!(applied(&report, "split"), 117);
    // The three edges that went left their slots to some that came.
    let edges = mesh.capacity(ElementKind::Edge);
    assert_eq!(lines[1], (117 * 4).to_string());
    assert_eq!(edges, 117 * 4);
}

#[test]
fn a_loop_does_not_visit_what_is_gone() {
    let mut mesh = shape::icosphere(2);
    let before = mesh.edge_count() as u64;
    let (report, lines) = run_body(
        &mut mesh,
        "var turns = 0
         for e in edges { turns = turns + 1  collapse(e, 100.0) }
         print turns",
    );
    let gone = applied(&report, "collapse");
    let turns: u64 = lines[0].parse().unwrap();
    assert!(gone > 20);
    // Each collapse takes three edges away, itself among them.
    assert!(turns < before && turns + 2 * gone >= before, "{turns} {gone}");
    assert_eq!(gone + refused(&report, "collapse"), turns);
}

/// A face that has become a hole is not a face any more, and the other way round.
#[test]
fn a_loop_over_faces_does_not_visit_what_has_become_a_hole() {
    let (_, lines) = run_alone(
        &mut shape::cube(),
        "op open(f: face) { before { face f: v =P=> v } after { hole f: v =P=> v } }
         op fill(f: face) { before { hole f: v =P=> v } after { face f: v =P=> v } }
         script main() {
           var turns = 0
           for f in faces { turns = turns + 1  for g in faces { if g != f { open(g) } } }
           print turns, count(faces), count(holes)
           turns = 0
           for f in holes { turns = turns + 1  for g in holes { if g != f { fill(g) } } }
           print turns, count(faces), count(holes)
           turns = 0
           for v in vertices {
             for f in v.faces { turns = turns + 1  for g in v.faces { if g != f { open(g) } } }
             break
           }
           print turns
         }",
        &[],
    )
    .unwrap();
    assert_eq!(lines, ["1 1 5", "1 5 1", "1"]);
}

#[test]
fn what_fails_in_an_update_writes_nothing_of_it() {
    let mut mesh = shape::cube();
    let before = mesh.clone();
    let script = "script main() {
      var left = 3
      update v in vertices {
        left = left - 1
        v.position = v.position * (6 div left)
      }
    }";
    let failure = try_run(&mut mesh, script, &[]).unwrap_err();
    assert_eq!(failure.diagnostic.code, "division-by-zero");
    assert!(mesh.vertices().all(|v| mesh.position(v) == before.position(v)));
}

#[test]
fn where_is_asked_when_the_turn_comes() {
    let lines = printed(
        &mut shape::cube(),
        "var turns = 0
         for v in vertices where turns < 3 { turns = turns + 1 }
         print turns",
    );
    assert_eq!(lines, ["3"]);
}

#[test]
fn elements_around_one_are_listed_first() {
    let lines = printed(
        &mut shape::octahedron(),
        "for v in vertices where degree(v) == 4 {
           var first = true
           for w in v.neighbors {
             if first { for e in w.edges { split(e) } first = false }
             print w
           }
           return
         }",
    );
    assert_eq!(lines.len(), 4);
}

/// Without an op in its body a loop around an element walks its orbit; with one, the elements are
/// listed first. If the op does nothing, both visit the same.
#[test]
fn a_walk_visits_what_a_list_would() {
    let around = [
        ("vertices", "halfedges"),
        ("vertices", "edges"),
        ("vertices", "faces"),
        ("vertices", "neighbors"),
        ("faces", "halfedges"),
        ("faces", "vertices"),
        ("faces", "edges"),
        ("edges", "vertices"),
        ("edges", "faces"),
    ];
    // Two faces are open, so that holes lie around elements.
    let meshes = [shape::grid(3, 2), shape::pillow(3), shape::octahedron()];
    let (mut compared, mut printed) = (0, 0);
    for mesh in meshes {
        for (all, inner) in around {
            let script = |op: &str| {
                format!(
                    "op open(f: face) {{ before {{ face f: v =P=> v }} after {{ hole f: v =P=> v }} }}
                     attr seen: vertex int = 0
                     fn twice(n: int) -> int {{ n * 2 }}
                     script main() {{
                       var opened = 0
                       for f in faces where opened < 2 {{ must open(f)  opened = opened + 1 }}
                       var turns = 0
                       for x in {all} {{
                         for y in x.{inner} where turns mod 7 != 3 {{
                           turns = turns + 1
                           {op}
                           if turns mod 5 == 0 {{ continue }}
                           for z in x.{inner} {{
                             turns = turns + twice(1)
                             for v in vertices {{ v.seen = v.seen + 1  break }}
                             if turns mod 11 == 0 {{ break }}
                             print x, y, z, turns
                           }}
                           print x, y
                           if turns mod 13 == 0 {{ break }}
                         }}
                         turns = turns + 1
                       }}
                       print turns, sum(v.seen for v in vertices)
                     }}"
                )
            };
            let walked = run_alone(&mut mesh.clone(), &script(""), &[]).unwrap().1;
            let idle = "if turns < 0 { for f in faces { open(f) } }";
            let listed = run_alone(&mut mesh.clone(), &script(idle), &[]).unwrap().1;
            assert_eq!(walked, listed, "{all}.{inner}");
            compared += 1;
            printed += walked.len();
        }
    }
    assert!(compared == 27 && printed > 1000, "{compared}, {printed}");
}

#[test]
fn update_reads_old_values_everywhere() {
    let mut mesh = shape::triangle_grid(3, 3);
    let old = mesh.clone();
    let lines = printed(
        &mut mesh,
        "update v in vertices where not boundary(v) {
           v.position = mean(w.position for w in v.neighbors) + vec3(0, 0, 1)
         }
         print \"done\"",
    );
    assert_eq!(lines, ["done"]);
    let mut moved = 0;
    for v in old.vertices() {
        let around: Vec<_> = old.neighbors(v).map(|w| old.position(w)).collect();
        let expected = match old.is_boundary_vertex(v) {
            true => old.position(v),
            false => {
                moved += 1;
                let sum: glam::DVec3 = around.iter().sum();
                sum / around.len() as f64 + glam::DVec3::Z
            }
        };
        assert!((mesh.position(v) - expected).length() < 1e-12);
    }
    assert_eq!(moved, 4);
}

#[test]
fn a_write_outside_of_update_happens_at_once() {
    let mut mesh = shape::cube();
    let lines = printed(
        &mut mesh,
        "for v in vertices { v.position = vec3(1, 2, 3) }
         print sum(v.position for v in vertices)",
    );
    assert_eq!(lines, ["(8, 16, 24)"]);
}

#[test]
fn of_two_writes_to_one_element_the_last_stays() {
    let mut mesh = shape::cube();
    run_body(
        &mut mesh,
        "for v in vertices {
           update w in v.neighbors {
             w.position = vec3(1, 0, 0)
             w.position = vec3(length(w.position), 0, 0)
           }
           return
         }",
    );
    let moved = mesh.vertices().filter(|&v| mesh.position(v).y == 0.0);
    assert_eq!(moved.count(), 3);
    let target = mesh.neighbors(VertexId(0)).next().unwrap();
    assert!((mesh.position(target).x - 3f64.sqrt()).abs() < 1e-12);
}

#[test]
fn repeat_while_break_and_continue() {
    let lines = printed(
        &mut shape::cube(),
        "var n = 0
         repeat -3 { n = 1 }
         repeat 5 { n = n + 10 }
         print n
         while n > 0 {
           n = n - 1
           if n mod 2 == 0 { continue }
           if n < 40 { break }
         }
         print n
         for v in vertices {
           for w in vertices { if w == v { break } n = n + 1 }
           if n > 45 { break }
         }
         print n
         repeat 3 { n = n + 1  continue }
         print n",
    );
    assert_eq!(lines, ["50", "39", "49", "52"]);
}

#[test]
fn a_range_is_taken_without_its_end_and_its_bounds_once() {
    let lines = printed(
        &mut shape::cube(),
        "var n = 3
         for i in n - 1..2 * n where i != 4 { n = 0  print i }
         for i in 0..0 { print \"none\" }
         for i in 5..-5 { print \"none\" }
         for i in -2..9 {
           if i == -1 { continue }
           for j in i..i + 2 { print \"{i} {j}\" }
           if i == 0 { break }
         }
         for i in 0..count(faces) { n = n + i }
         print n",
    );
    assert_eq!(lines, ["2", "3", "5", "-2 -2", "-2 -1", "0 0", "0 1", "15"]);
}

#[test]
fn slots_are_used_again_between_turns_of_a_repeat() {
    let mut mesh = shape::icosphere(1);
    let before = mesh.edge_count();
    let (report, _) = run_body(
        &mut mesh,
        "repeat 20 {
           let n = count(edges)
           for e in edges { if count(edges) < n + 30 { split(e) } }
           for e in edges { if count(edges) > n { collapse(e, 100.0) } }
         }",
    );
    assert!(applied(&report, "split") > 100, "{report:?}");
    assert!(applied(&report, "collapse") > 100, "{report:?}");
    let (count, capacity) = (mesh.edge_count(), mesh.capacity(ElementKind::Edge));
    assert!(count <= before + 40 && capacity <= before + 80, "{count} {capacity}");
}

#[test]
fn no_id_is_used_again_while_a_variable_still_has_it() {
    let failure = try_run(
        &mut shape::icosphere(1),
        "script main() {
           for v in vertices {
             for e in v.edges {
               let old = e
               if collapse(e, 100.0) {
                 for f in edges { split(f) }
                 print length(old)
               }
             }
           }
         }",
        &[],
    );
    assert_eq!(failure.unwrap_err().diagnostic.code, "element-gone");
}

#[test]
fn results_and_refusals() {
    let (report, lines) = run_body(
        &mut shape::tetrahedron(),
        "for e in edges {
           if flip(e) { print \"flipped\" } else { print \"not\", e }
           flip(e)
           if let m = split(e) { print m.position }
           return
         }",
    );
    assert_eq!(lines, ["not edge 0", "(0, 1, 0)"]);
    let flip = report.ops.iter().find(|op| op.name == "flip").unwrap();
    assert_eq!(flip.refused, [("the edge is already there".to_owned(), 2)]);
    let names: Vec<_> = report.ops.iter().map(|op| op.name.as_str()).collect();
    assert_eq!(names, ["split", "flip"]);
}
