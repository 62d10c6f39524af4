//! Loops that several threads take: the results are those of one.

use std::collections::BTreeSet;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::library;
use hedgerow::mesh::{Mesh, identical, shape};
use hedgerow::rewrite::{Engine, Unwatched, Watch};
use hedgerow::run::{prepare, run};
use hedgerow::set_threads;
use hedgerow::source::Sources;
use support::dice::Dice;

const PROGRAM: &str = "
use \"std/triangle.hedge\"
attr heat: vertex real = 0
attr level: face int = 1
attr sharp: edge bool = false
attr rank: edge int = 0
attr way: halfedge vec3 = vec3(0)
attr frame: vertex mat4 = mat4(0)
attr half: vertex vec2 = vec2(0, 0)
attr is_wrong: vertex bool = false

fn warmth(v: vertex) -> real { mean(w.heat + length(w.position - v.position) for w in v.neighbors) }
fn mean_edge() -> edge { argmin(abs(length(e) - 0.25) for e in edges) }
fn is_near(v: vertex) -> bool { v.position.z > -0.2 and degree(v) > 0 }
fn warm(t: real) {
  update v in vertices where is_near(v) { v.heat = t * warmth(v) v.position = mix(v.position, vec3(t), 0.25) }
}
fn test_neighbors() {
  update v in vertices {
    v.is_wrong = v.is_wrong
        or sum(w.position.x for w in v.neighbors) != sum(h.twin.vertex.position.x for h in v.halfedges)
        or sum(h.target.position.x for h in v.halfedges where h.target.heat > 0)
            != sum(h.twin.vertex.position.x for h in v.halfedges where h.twin.vertex.heat > 0)
        or max(length(h) * h.target.heat for h in v.halfedges)
            != max(length(h) * h.twin.vertex.heat for h in v.halfedges)
  }
  assert not any(v.is_wrong for v in vertices)
}
fn cool(t: int) { update f in faces { f.level = 100 div (f.level - t) } }
fn depth(n: int) -> int { if n <= 0 { return 0 } return 1 + depth(n - 1) }
fn deepen(calls: int, n: int) {
  if calls <= 0 { update f in faces { f.level = depth(n) } } else { deepen(calls - 1, n) }
}
";

fn analyse(body: &str) -> Analysis {
    let text = format!("{PROGRAM}\nscript main() {{\n{body}\n}}");
    let mut sources = Sources::new();
    let file = sources.add("threads.hedge", &text);
    let analysis = Analysis::with(&mut sources, file, &mut Nowhere);
    assert!(analysis.is_sound(), "{:#?}", analysis.diagnostics);
    analysis
}

/// What a script with this body makes of a mesh, or why it stops, with any number of threads and
/// on any engine the same.
fn run_with_all(body: &str, mesh: &Mesh) -> (Mesh, Result<(), String>) {
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let analysis = analyse(body);
    let mut first: Option<(Mesh, Result<(), String>)> = None;
    for threads in [1, 2, 5] {
        set_threads(NonZeroUsize::new(threads));
        for engine in [Engine::Machine, Engine::Native, Engine::NativeAtOnce] {
            let script = analysis.script("main").unwrap();
            let mut prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
            prepared.use_engine(engine);
            let mut mesh = mesh.clone();
            let done = run(&prepared, &mut mesh, &[], &mut Unwatched);
            let done = done.map(drop).map_err(|failure| format!("{:?}", failure.diagnostic));
            match &first {
                None => first = Some((mesh, done)),
                Some((known, was)) => {
                    assert_eq!(&done, was, "{threads} threads, {engine:?}: {body}");
                    assert!(identical(known, &mesh), "{threads} threads, {engine:?}: {body}");
                }
            }
        }
    }
    set_threads(None);
    first.unwrap()
}

/// Scripts with these bodies come to their end, and change the mesh; with all the same.
fn change_with_all(bodies: &[&str]) {
    for body in bodies {
        let mesh = shape::icosphere(3);
        let (after, done) = run_with_all(body, &mesh);
        assert_eq!(done, Ok(()), "{body}");
        assert!(!identical(&after, &mesh), "{body}");
    }
}

#[test]
fn updates_do_what_one_thread_does() {
    let bodies = [
        "update v in vertices { v.position = mix(v.position, mean(w.position for w in v.neighbors), 0.5) }",
        "repeat 3 { update v in vertices where is_near(v) { v.heat = warmth(v) + v.position.x } }",
        "update f in faces { f.level = f.level + count(g == f for g in faces) + depth(degree(f)) }",
        "update e in edges where length(e) > 0.1 { e.sharp = not e.sharp }",
        "update h in halfedges { h.way = normal(h.face) * 0.5 h.vertex.heat = h.vertex.heat + 1 }",
        "update v in vertices { let w = v.halfedge.target if w.position.z > 0 { w.heat = v.position.x } }",
        "var far = 0.5
         update v in vertices { let here = v.position.x if here > far { v.heat = here } else { v.heat = far } }",
        "var turns = 0.0
         update v in vertices { turns = turns + 1 v.heat = turns }",
        "for v in vertices where v.position.x > 0.9 {
           update w in vertices { w.heat = w.heat + dot(w.position, v.position) }
         }",
        "update v in vertices {
           if v.position.x < 0 { v.half = vec2(v.position.x, v.heat) v.half = 2 * v.half }
           v.frame = v.position.y * mat4(1) + v.frame v.heat = v.half.x
         }",
        "update v in vertices { v.heat = random() }",
        "warm(0.5) warm(0.25) cool(9)",
    ];
    change_with_all(&bodies);
}

/// Loops that ask for the neighbors of all vertices again read lists of them, until an operation is
/// applied. Loops over halfedges read none if they ask for more than their targets.
#[test]
fn neighbors_are_those_of_the_mesh_as_it_is() {
    let stir = [
        "for e in edges where e.halfedge.vertex.position.x > 0.2 { flip(e) }",
        "for e in edges where length(e) > 0.2 { split(e) }",
        "for e in edges where e.halfedge.vertex.position.z > 0.3 { collapse(e) }",
        "if count(can split(e) for e in edges) > 0 { for v in vertices { v.heat = 1 } }",
        "split(argmax(length(e) for e in edges))",
        "for e in edges { if can flip(e) { flip(e) break } }",
        "drain e in edges by length(e) while count(edges) > 150 { collapse(e) }",
    ];
    let smooth = "repeat 3 {
           update v in vertices where degree(v) > 2 {
             if any(w.position.x > 0.9 for w in v.neighbors) { v.heat = sum(w.heat for w in v.neighbors) }
             v.position = mix(v.position, mean(w.position for w in v.neighbors), 0.5)
           }
           let most = max(sum(w.heat for w in v.neighbors where w != v.halfedge.target) for v in vertices)
           for v in vertices { v.heat = v.heat - most }
         }";
    // A vertex with many neighbors, a boundary, other polygons than triangles.
    let meshes =
        [shape::icosphere(2), shape::fan(90), shape::triangle_grid(9, 9), shape::grid(9, 9)];
    let stir =
        stir.map(|stir| format!("{stir} repeat 3 {{ warm(0.5) test_neighbors() }}")).join("\n");
    let body = format!("repeat 3 {{ warm(0.5) }} {stir} {smooth}");
    for mesh in &meshes {
        let (after, done) = run_with_all(&body, mesh);
        assert_eq!(done, Ok(()));
        assert!(!identical(&after, mesh));
    }
}

#[test]
fn aggregates_and_keys_are_those_of_one_thread() {
    let bodies = [
        "for v in vertices { v.heat = 1 / 3 * v.position.x }
         let all = sum(v.heat for v in vertices where is_near(v))
         for v in vertices { v.heat = all + mean(w.heat for w in vertices) }",
        "let n = count(length(e) > 0.3 for e in edges where not boundary(e)) + count(faces)
         for v in vertices { v.heat = n }",
        "let n = count(is_near(v) for v in vertices)
         for v in vertices { v.heat = n }",
        "let here = mean(v.position for v in vertices where v.position.x > 0.1)
         let q = sum(outer(normal(f), centroid(f)) for f in faces)
         for v in vertices { v.position = q * v.position + here }",
        "for v in vertices { v.heat = min(degree(v) for v in vertices) + max(w.position.z for w in vertices) }
         for f in faces { f.level = max(degree(f) for f in faces) }",
        "let v = argmax(round(4 * v.position.y) for v in vertices)
         let w = argmin(abs(w.position.x) for w in vertices where w != v)
         v.heat = 1 w.heat = w.heat + 2",
        "let fixed = 2.5
         for v in vertices { v.heat = sum(fixed for f in faces) + sum(degree(f) for f in faces) }",
        "var round = 0.0
         while sum(v.heat for v in vertices) < 5000 and round < 30 {
           for v in vertices { v.heat = v.heat + round }
           round = round + 1
         }",
        "var rank = 0.0
         drain v in vertices by dot(v.position, vec3(1, 2, 3)) + warmth(v) while rank < 300 {
           v.heat = rank
           rank = rank + 1
         }",
        "for e in edges where e.halfedge.vertex.position.x > 0.2 { collapse(e) }
         for f in faces where normal(f).z > 0.9 { f.level = 7 }
         let here = mean(centroid(f) for f in faces) * sum(degree(h) for h in holes)
         let n = count(degree(v) > 6 for v in vertices)
         drain e in edges by length(e) while count(edges) > 60 + n { collapse(e) }
         for v in vertices { v.position = v.position + here + vec3(n, 0, 0) }",
        "var rank = 0
         drain f in faces by round(2 * centroid(f).x) { f.level = rank rank = rank + 1 }",
        "var far = 0.0
         drain e in edges by if e.sharp { infinity } else { length(e) + far } while far < 2 {
           e.sharp = true
           e.halfedge.vertex.position = e.halfedge.vertex.position * 1.25
           far = far + 0.125
         }",
    ];
    change_with_all(&bodies);
}

#[test]
fn filters_tested_ahead_are_those_of_one_thread() {
    let bodies = [
        "parallel for e in edges where length(e) > 0.15 { split(e) }",
        "parallel for e in edges where not boundary(e) and is_near(e.halfedge.vertex) { collapse(e) }
         parallel for e in edges where can flip(e) and degree(e.halfedge.vertex) > 6 { flip(e) }",
        "for v in vertices { v.heat = v.position.x }
         parallel for v in vertices where warmth(v) > mean(warmth(w) for w in vertices) { v.heat = 9 }",
        "var sum = 0.0
         parallel for f in shuffle(faces) where sum < 3 and normal(f).z > 0 {
           sum = sum + random()
           f.level = round(100 * sum)
         }",
        "for v in vertices where degree(v) == 5 {
           parallel for h in v.halfedges where length(h) > 0.05 and h.target.heat == 0 { h.target.heat = 1 }
         }",
        "drain e in edges by -length(e) while length(e) > 0.16 {
           split(e)
           parallel for v in vertices where v.heat < 1 and degree(v) > 5 { v.heat = v.heat + 0.5 }
         }",
        "parallel for e in edges where length(e) > 0.15 {
           for h in e.halfedge.vertex.halfedges { h.target.heat = h.target.heat + 1 }
           if e.halfedge.target.heat > 3 { break }
         }",
    ];
    change_with_all(&bodies);
}

/// It is a `for` over the elements that another loop has marked before.
#[test]
fn a_parallel_for_is_a_for_over_what_passed_before() {
    let mut dice = Dice(7);
    for _ in 0..12 {
        let bound = 0.13 + 0.002 * dice.below(20) as f64;
        let filters = [
            format!("length(x) > {bound}"),
            format!("can collapse(x) and length(x) < {bound}"),
            "degree(x.halfedge.vertex) + degree(x.halfedge.target) > 11".to_owned(),
        ];
        let bodies = ["split(x)", "collapse(x)", "flip(x)", "if n < 40 { split(x) } n = n + 1"];
        let filter = &filters[dice.below(filters.len())];
        let body = bodies[dice.below(bodies.len())];
        let parallel = format!("var n = 0 parallel for x in edges where {filter} {{ {body} }}");
        let marked = format!(
            "var n = 0
             for x in edges where {filter} {{ x.sharp = true }}
             for x in edges where x.sharp and {filter} {{ {body} }}"
        );
        let [parallel, marked] = [parallel, marked].map(|body| {
            let (mesh, done) = run_with_all(&body, &shape::icosphere(3));
            assert_eq!(done, Ok(()), "{body}");
            mesh.to_polygons()
        });
        assert_eq!(parallel, marked, "{filter} {body}");
    }
}

#[test]
fn a_parallel_for_visits_in_the_order_of_a_for() {
    let loops = ["edges", "shuffle(edges)", "mean_edge().halfedge.vertex.edges"].map(|xs| {
        ["", "parallel "].map(|word| {
            let body = format!(
                "var rank = 0
                 {word}for x in {xs} where length(x) > 0.14 {{ rank = rank + 1 x.rank = rank }}"
            );
            let (mesh, done) = run_with_all(&body, &shape::icosphere(3));
            assert_eq!(done, Ok(()), "{body}");
            let column = mesh.find_column(hedgerow::mesh::ElementKind::Edge, "rank").unwrap();
            mesh.values::<i64>(column).unwrap().to_vec()
        })
    });
    for [one, other] in loops {
        assert_eq!(one, other);
        assert!(one.contains(&2));
    }
}

#[test]
fn what_fails_in_an_aggregate_a_filter_or_a_key_is_that_of_one_thread() {
    let bodies = [
        "let n = sum(100 div (f.level - 1) for f in faces)",
        "let x = min(v.position.x for v in vertices where v.position.x > 9)",
        "let x = argmax(v.heat for v in vertices where v.heat > 9)",
        "let a = sum(length(e) for e in edges)
         assert a + (a + (a + sum(length(e) for e in edges))) < 0",
        "assert sum(length(e) for e in edges) < 0 or all(length(e) < 0.1 for e in edges)",
        "let n = sum(9223372036854775807 for f in faces)",
        "let n = sum(depth(100000) for f in faces where normal(f).z > 0.5)",
        "parallel for f in faces where 100 div (f.level - 1) > 2 { f.level = 3 }",
        "parallel for v in vertices where v.position.x > 0 and depth(2000) > 1 { v.heat = 1 }",
        "drain v in vertices by 0 / (v.position.x - v.position.x) { v.heat = 1 }",
        "drain v in vertices by max(w.heat for w in v.neighbors where w.position.z > 0.9) { v.heat = 1 }",
    ];
    for body in bodies {
        let mesh = shape::icosphere(3);
        let (after, done) = run_with_all(body, &mesh);
        assert!(done.is_err(), "{body}");
        assert_eq!(after.to_polygons().0, mesh.to_polygons().0, "{body}");
    }
}

#[test]
fn as_many_calls_are_nested_as_on_one_thread() {
    let mesh = shape::icosphere(2);
    for calls in [0, 1, 3, 80, 500] {
        let outcomes = (996 - calls..1003 - calls).map(|n| {
            let in_script = format!("update f in faces {{ f.level = depth({}) }}", n + calls);
            let in_function = format!("deepen({calls}, {n})");
            [in_script, in_function].map(|body| run_with_all(&body, &mesh).1.is_ok())
        });
        let outcomes: Vec<_> = outcomes.collect();
        for place in 0..2 {
            let done = outcomes.iter().filter(|outcome| outcome[place]).count();
            assert!(0 < done && done < outcomes.len(), "{calls}: {outcomes:?}");
        }
    }
}

#[test]
fn loops_of_the_library_are_for_several_threads() {
    let (mut loops, mut others) = (0, BTreeSet::new());
    for file in library::files() {
        let mut sources = Sources::new();
        let id = sources.add(file.name, file.text);
        let analysis = Analysis::with(&mut sources, id, &mut Nowhere);
        for script in 0..analysis.program.scripts.len() {
            let prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
            let functions = &prepared.code().functions;
            for part in prepared.code().with_called().into_iter().flat_map(|code| &code.parts) {
                match part {
                    Some(part) if part.reads_only(functions) => loops += 1,
                    _ => drop(others.insert(file.name)),
                }
            }
        }
    }
    assert!(loops > 15, "{loops}");
    assert!(others.is_empty(), "{others:?}");
}

#[test]
fn the_first_element_that_fails_is_told_and_nothing_is_written() {
    let bodies = [
        "update v in vertices where v.position.x < 0.5 { v.position = v.position / (v.position.x + 2 - 2 * v.position.x / v.position.x - v.position.x) }",
        "update f in faces { f.level = 10 div (f.level - 1) }",
        "cool(5) cool(-25)",
        "update f in faces { f.level = f.level * 5 }
         update f in faces where normal(f).z > 0.2 { f.level = 9223372036854775807 * (f.level + 1) }",
        "update v in vertices { v.heat = 1 / 1 v.heat = max(w.heat for w in v.neighbors where w.position.z > 0.9) }",
    ];
    for body in bodies {
        let (after, done) = run_with_all(body, &shape::icosphere(3));
        assert!(done.is_err(), "{body}");
        // Only what a first loop wrote is there.
        let untouched = shape::icosphere(3);
        let positions = |mesh: &Mesh| mesh.to_polygons().0;
        assert_eq!(positions(&after), positions(&untouched));
    }
}

/// An expression of reals over `v`.
fn real(dice: &mut Dice, depth: usize) -> String {
    if depth == 0 {
        let leaves = ["v.heat", "v.position.x", "0.25", "length(v.position)", "3.0"];
        return leaves[dice.below(leaves.len())].to_owned();
    }
    let [a, b] = [real(dice, depth - 1), real(dice, depth - 1)];
    match dice.below(7) {
        0 => format!("({a} + {b})"),
        1 => format!("({a} * {b})"),
        2 => format!("(if {a} < {b} {{ {a} }} else {{ {b} }})"),
        3 => format!("sum(w.heat * {a} for w in v.neighbors where w.position.x < {b})"),
        4 => format!("(warmth(v) - {a})"),
        5 => format!("mean(length(e) + {a} for e in v.edges)"),
        _ => format!("min({a}, {b})"),
    }
}

#[test]
fn random_updates_do_what_one_thread_does() {
    let mut dice = Dice(11);
    let mut went_through = 0;
    for _ in 0..25 {
        let [value, bound, place] = [2, 1, 1].map(|depth| real(&mut dice, depth));
        let body = format!(
            "repeat 2 {{
               update v in vertices where {bound} < 1.5 {{
                 v.heat = {value}
                 v.position = v.position + vec3(0, {place}, 0)
               }}
             }}"
        );
        let (_, done) = run_with_all(&body, &shape::icosphere(2));
        went_through += usize::from(done.is_ok());
    }
    assert!(went_through > 15, "{went_through}");
}

/// Interrupts at the iteration that comes after so many.
struct Impatient(usize);

impl Watch for Impatient {
    fn iteration(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.tick()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn all_threads_are_interrupted() {
    // Each would take hours.
    let bodies = [
        "update v in vertices { v.heat = sum(sum(sum(length(e) for e in edges) for f in faces) for w in vertices) }",
        "let x = sum(sum(sum(length(e) for e in edges) for f in faces) for w in vertices)",
        "drain w in vertices by sum(sum(length(e) for e in edges) for f in faces) { w.heat = 1 }",
        "var n = 0 while true { n = n + count(length(e) > 0.1 for e in edges) }",
        "parallel for w in vertices where sum(sum(length(e) for e in edges) for f in faces) > 0 { w.heat = 1 }",
    ];
    for body in bodies {
        is_interrupted(body);
    }
}

fn is_interrupted(body: &str) {
    let analysis = analyse(body);
    let script = analysis.script("main").unwrap();
    let mut prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
    prepared.use_engine(Engine::NativeAtOnce);
    let mut mesh = shape::icosphere(4);
    let before = mesh.clone();
    let stopped = run(&prepared, &mut mesh, &[], &mut Impatient(3));
    assert_eq!(stopped.unwrap_err().diagnostic.code, "interrupted", "{body}");
    let heat = |mesh: &Mesh| {
        let column = mesh.find_column(hedgerow::mesh::ElementKind::Vertex, "heat");
        column.map(|column| mesh.values::<f64>(column).unwrap().iter().sum::<f64>())
    };
    assert_eq!(heat(&mesh).unwrap_or(0.0), heat(&before).unwrap_or(0.0));
}
