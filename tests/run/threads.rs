//! Loops that several threads take: the results are those of one.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{Mesh, identical, shape};
use hedgerow::rewrite::{Engine, Unwatched, Watch};
use hedgerow::run::{prepare, run};
use hedgerow::set_threads;
use hedgerow::source::Sources;
use support::dice::Dice;

const PROGRAM: &str = "
attr heat: vertex real
attr level: face int = 1
attr sharp: edge bool
attr way: halfedge vec3

fn warmth(v: vertex) -> real { mean(w.heat + length(w.position - v.position) for w in v.neighbors) }
fn is_near(v: vertex) -> bool { v.position.z > -0.2 and degree(v) > 0 }
fn warm(t: real) {
  update v in vertices where is_near(v) { v.heat = t * warmth(v) v.position = mix(v.position, vec3(t), 0.25) }
}
fn cool(t: int) { update f in faces { f.level = 100 div (f.level - t) } }
fn depth(n: int) -> int { if n <= 0 { return 0 } return 1 + depth(n - 1) }
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
        "update v in vertices { v.heat = random() }",
        "warm(0.5) warm(0.25) cool(9)",
    ];
    for body in bodies {
        let mesh = shape::icosphere(3);
        let (after, done) = run_with_all(body, &mesh);
        assert_eq!(done, Ok(()), "{body}");
        assert!(!identical(&after, &mesh), "{body}");
    }
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

/// Interrupts at the turn that comes after so many.
struct Impatient(usize);

impl Watch for Impatient {
    fn turn(&mut self, _depth: u16, _done: u64, _total: Option<u64>) -> ControlFlow<()> {
        self.tick()
    }

    fn tick(&mut self) -> ControlFlow<()> {
        self.0 = self.0.saturating_sub(1);
        if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn all_threads_are_interrupted() {
    // It would take hours.
    let body = "update v in vertices { v.heat = sum(sum(sum(length(e) for e in edges) for f in faces) for w in vertices) }";
    let analysis = analyse(body);
    let script = analysis.script("main").unwrap();
    let mut prepared = prepare(&analysis.program, script, &analysis.plans).unwrap();
    prepared.use_engine(Engine::NativeAtOnce);
    let mut mesh = shape::icosphere(4);
    let before = mesh.clone();
    let stopped = run(&prepared, &mut mesh, &[], &mut Impatient(3));
    assert_eq!(stopped.unwrap_err().diagnostic.code, "interrupted");
    let heat = |mesh: &Mesh| {
        let column = mesh.find_column(hedgerow::mesh::ElementKind::Vertex, "heat");
        column.map(|column| mesh.values::<f64>(column).unwrap().iter().sum::<f64>())
    };
    assert_eq!(heat(&mesh).unwrap_or(0.0), heat(&before).unwrap_or(0.0));
}
