//! Declared operations compared with the same operations written by hand on the same mesh core, on
//! bare arrays, and with the crate `alum`.
//!
//!     cargo bench --bench operations
//!
//! All variants run in turn, round by round, in one process. The best round of each counts, and the
//! ratios are what to quote: the speed of the processor drifts, the ratios hardly do. An operation
//! is called directly, on the machine and as native code, and in a loop of a script, which is
//! native code too; the time of the empty loop is subtracted. Then the ways to call an operation of
//! the library are compared: the machine, native code, a session, a mask over all edges, and an
//! application, which is prepared again for each call. Then scripts of the library, on the machine
//! and as native code.

mod alum;
mod by_hand;
mod lean;

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{EdgeId, Mesh, identical, read_mesh, shape};
use hedgerow::rewrite::{Engine, Machine, Outcome, Plan, Unwatched};
use hedgerow::run::{Application, Argument};
use hedgerow::source::Sources;
use hedgerow::{Program, Session};

use alum::Alum;
use lean::Lean;

const ROUNDS: usize = 9;

const FLIP: &str = include_str!("../../examples/flip.hedge");
const SPLIT: &str = include_str!("../../examples/split.hedge");
const TRIANGLE: &str = include_str!("../../src/library/std/triangle.hedge");

fn main() {
    let mesh = shape::triangle_torus(200, 205);
    let count = mesh.face_count();
    println!("{count} triangles, nanoseconds per operation, best of {ROUNDS} rounds; to by hand");
    println!(
        "{:<24}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}   {:>9}{:>9}{:>9}",
        "",
        "arrays",
        "alum",
        "by hand",
        "machine",
        "native",
        "script",
        "machine",
        "native",
        "script"
    );
    // Without its guard and its properties, a flip is an op on maps.
    let raw = TRIANGLE.replace("guard simple", "").replace(" keeps triangles, euler, boundary", "");
    for is_random in [false, true] {
        let order =
            |name: &str| format!("{name}, {}", if is_random { "random" } else { "in order" });
        let flip = (Lean::flip as ByLean, Alum::flip as ByAlum, by_hand::flip as ByHand);
        let flip_raw = (Lean::flip_raw as ByLean, Alum::flip_raw as ByAlum, by_hand::flip_raw as _);
        let split = (Lean::split as ByLean, Alum::split as ByAlum, by_hand::split as _);
        let collapse = (Lean::collapse as ByLean, Alum::collapse as ByAlum, by_hand::collapse as _);
        compare(&order("flip raw"), &mesh, (&raw, "flip"), flip_raw, is_random);
        compare(&order("flip"), &mesh, (FLIP, "flip"), flip, is_random);
        compare(&order("std flip"), &mesh, (TRIANGLE, "flip"), flip, is_random);
        compare(&order("split"), &mesh, (SPLIT, "split"), split, is_random);
        compare(&order("std collapse"), &mesh, (TRIANGLE, "collapse"), collapse, is_random);
    }
    let mesh = shape::triangle_torus(70, 71);
    println!("\n{} triangles, nanoseconds per call", mesh.face_count());
    println!(
        "{:<22}{:>9}{:>9}{:>9}{:>9}{:>13}",
        "", "machine", "native", "session", "asked", "application"
    );
    for op in ["flip", "split", "collapse"] {
        call("std/triangle.hedge", op, &mesh);
    }
    for op in ["flip", "collapse"] {
        call("std/polygon.hedge", op, &mesh);
    }
    let bunny = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/meshes/bunny.obj");
    let bunny = read_mesh(Path::new(bunny), None).expect("an example").mesh;
    // `SCRIPTS=large cargo bench` takes minutes longer.
    let large = std::env::var("SCRIPTS").is_ok_and(|which| which == "large");
    let torus = match large {
        true => shape::triangle_torus(600, 400),
        false => shape::triangle_torus(120, 125),
    };
    for (name, mesh) in [("bunny", &bunny), ("torus", &torus)] {
        println!("\n{name}, {} triangles, seconds", mesh.face_count());
        println!("{:<22}{:>9}{:>9}{:>9}", "", "machine", "native", "ratio");
        script("std/subdivide.hedge", "loop_subdivide()", mesh);
        script("std/remesh.hedge", "remesh(0, 1)", mesh);
        script("std/smooth.hedge", "laplacian()", mesh);
        script("std/simplify.hedge", "simplify(-1, 1, 0.5)", mesh);
    }
}

/// Runs a script of the library on both engines.
fn script(file: &str, call: &str, mesh: &Mesh) {
    let text = format!("use \"{file}\"\nscript main() {{ {call} }}");
    let program = Program::parse("bench.hedge", &text).expect("the library is sound");
    let main = program.script("main").expect("it is there");
    let mut best = [f64::MAX; 2];
    let mut results = Vec::new();
    for _ in 0..3 {
        for (best, engine) in best.iter_mut().zip([Engine::Machine, Engine::Native]) {
            let mut session = Session::new(&program, mesh.clone());
            session.use_engine(engine);
            let start = Instant::now();
            session.run(&main, ()).expect("it comes to its end");
            *best = best.min(start.elapsed().as_secs_f64());
            results.push(session.into_mesh());
        }
    }
    assert!(results.iter().all(|result| identical(result, &results[0])), "both do the same");
    let [machine, native] = best;
    println!("{call:<22}{machine:>9.3}{native:>9.3}{:>9.2}", native / machine);
}

/// Calls an operation at every edge.
fn call(file: &str, name: &str, mesh: &Mesh) {
    let mut sources = Sources::new();
    let text = hedgerow::library::file(file).expect("the library has it").text;
    let root = sources.add(file, text);
    let analysis = Analysis::with(&mut sources, root, &mut Nowhere);
    let index = analysis.op(name).expect("the library has it");
    let plan = analysis.plans[index].as_ref().expect("it is proved");
    let program = Program::load(file).expect("the library is sound");
    let op = program.op(name).expect("the library has it");
    let edges: Vec<EdgeId> = mesh.edges().collect();
    // Machine, native, session, asked.
    let mut best = [f64::MAX; 4];
    for _ in 0..5 {
        let mut slots = vec![0, 0.5_f64.to_bits()];
        let mut applied = [0; 3];
        for (at, engine) in [Engine::Machine, Engine::Native].into_iter().enumerate() {
            let mut copy = mesh.clone();
            let mut machine = Machine::new(&analysis.plans);
            machine.use_engine(engine);
            let start = Instant::now();
            for edge in &edges {
                if copy.edge_alive(*edge) {
                    machine.trust_level(plan.level);
                    slots[0] = u64::from(edge.0);
                    let outcome = machine.apply(&mut copy, plan, &slots);
                    applied[at] += usize::from(matches!(outcome, Ok(Outcome::Applied { .. })));
                }
            }
            best[at] = best[at].min(start.elapsed().as_nanos() as f64);
        }
        let mut session = Session::new(&program, mesh.clone());
        let start = Instant::now();
        for edge in &edges {
            if session.is_alive(*edge) {
                let outcome = session.apply(&op, *edge).expect("it has a value");
                applied[2] += usize::from(outcome.is_applied());
            }
        }
        best[2] = best[2].min(start.elapsed().as_nanos() as f64);
        assert!(applied.iter().all(|count| *count == applied[0]), "all do the same");
        let mut session = Session::new(&program, mesh.clone());
        let start = Instant::now();
        black_box(session.mask(&op, ()).expect("it has a value"));
        best[3] = best[3].min(start.elapsed().as_nanos() as f64);
    }
    let few = 20;
    let application = Application::new(&analysis.program, index, &analysis.plans);
    let application = application.expect("it is proved");
    let mut copy = mesh.clone();
    let start = Instant::now();
    for edge in edges.iter().step_by(edges.len() / few) {
        let arguments = [("e".to_owned(), Argument::from(*edge))];
        let _ = black_box(application.apply(&mut copy, &arguments, &mut Unwatched));
    }
    let application = start.elapsed().as_nanos() as f64 / few as f64;
    let [machine, native, session, asked] = best.map(|all| all / edges.len() as f64);
    let level = format!("{name}, level {}", plan.level);
    println!("{level:<22}{machine:>9.1}{native:>9.1}{session:>9.1}{asked:>9.1}{application:>13.1}");
}

fn plan(text: &str, op: &str) -> Plan {
    let mut sources = Sources::new();
    let file = sources.add(op, text);
    let analysis = Analysis::of(&sources, file);
    let index = analysis.op(op).expect("the example declares the op");
    analysis.plans[index].clone().expect("the example's op is proved")
}

type ByLean = fn(&mut Lean, u32) -> bool;
type ByAlum = fn(&mut Alum, u32) -> bool;
type ByHand = fn(&mut Mesh, EdgeId) -> bool;

/// Applies each variant to every living edge of a fresh copy of the mesh, in order or in random
/// order.
fn compare(
    name: &str,
    mesh: &Mesh,
    (text, op): (&str, &str),
    (by_lean, by_alum, by_hand): (ByLean, ByAlum, ByHand),
    is_random: bool,
) {
    let mut edges: Vec<EdgeId> = mesh.edges().collect();
    let mut state = 1_u64;
    for at in (1..edges.len()).rev().filter(|_| is_random) {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        edges.swap(at, (state >> 33) as usize % (at + 1));
    }
    let plan = plan(text, op);
    let scripts = Scripts::new(text, op, is_random);
    let lean = Lean::new(mesh);
    let living = |mesh: &mut Mesh, edge: EdgeId| mesh.edge_alive(edge);
    // Arrays, alum, by hand, machine, native, script.
    let mut best = [f64::MAX; 6];
    let mut alone = f64::MAX;
    for _ in 0..ROUNDS {
        let (on_arrays, applied_on_arrays) =
            time(lean.clone(), &edges, |lean, edge| by_lean(lean, edge.0));
        best[0] = best[0].min(on_arrays);
        let (in_alum, applied_in_alum) =
            time(Alum::new(mesh), &edges, |mesh, edge| by_alum(mesh, edge.0));
        best[1] = best[1].min(in_alum);
        let (by_hand, applied_by_hand) =
            time(mesh.clone(), &edges, |mesh, edge| living(mesh, edge) && by_hand(mesh, edge));
        best[2] = best[2].min(by_hand);
        assert_eq!(applied_on_arrays, applied_by_hand, "{name}: all do the same");
        // `alum` itself decides which degenerate flips it accepts and which edges a collapse
        // leaves.
        let differs = name.contains("raw") || op == "collapse";
        assert!(differs || applied_in_alum == applied_by_hand, "{name}: all do the same");
        for (best, engine) in best[3..5].iter_mut().zip([Engine::Machine, Engine::Native]) {
            let mut machine = Machine::default();
            machine.use_engine(engine);
            let (by_plan, applied_by_plan) = time(mesh.clone(), &edges, |mesh, edge| {
                if !living(mesh, edge) {
                    return false;
                }
                machine.trust_level(plan.level);
                let outcome = machine.apply(mesh, &plan, &[u64::from(edge.0), 0.5_f64.to_bits()]);
                matches!(outcome, Ok(Outcome::Applied { .. }))
            });
            assert_eq!(applied_by_hand, applied_by_plan, "{name}: all do the same");
            assert!(applied_by_plan > 0, "something was applied");
            *best = best.min(by_plan);
        }
        let (by_script, applied_by_script) = scripts.time(mesh, "with_op");
        // A script uses its own random order.
        assert!(is_random || applied_by_hand == applied_by_script, "{name}: all do the same");
        best[5] = best[5].min(by_script);
        alone = alone.min(scripts.time(mesh, "alone").0);
    }
    best[5] -= alone;
    print!("{name:<24}");
    best.iter().for_each(|best| print!("{best:>9.1}"));
    let [_, _, hand, machine, native, script] = best;
    println!("   {:>9.2}{:>9.2}{:>9.2}", machine / hand, native / hand, script / hand);
}

/// Scripts that loop over all edges, with an operation and without.
struct Scripts(Program);

impl Scripts {
    fn new(text: &str, op: &str, is_random: bool) -> Self {
        let edges = if is_random { "shuffle(edges)" } else { "edges" };
        let text = format!(
            "{text}\nscript ready() {{ for e in edges {{ if can {op}(e) {{ break }} }} }}
            script with_op() {{ for e in {edges} {{ {op}(e) }} }}
            script alone() {{ for e in {edges} {{ }} }}"
        );
        Self(Program::parse("bench.hedge", &text).expect("the operation is sound"))
    }

    /// Nanoseconds per edge, and the number of times that the operation was applied.
    fn time(&self, mesh: &Mesh, name: &str) -> (f64, usize) {
        let [ready, script] = ["ready", name].map(|name| self.0.script(name).expect("is there"));
        let mut session = Session::new(&self.0, mesh.clone());
        // From here on, the level of the mesh is known.
        session.run(&ready, ()).expect("it comes to its end");
        let start = Instant::now();
        let report = session.run(&script, ()).expect("it comes to its end");
        let nanoseconds = start.elapsed().as_nanos() as f64;
        let applied = report.ops.iter().map(|op| op.applied as usize).sum();
        (nanoseconds / mesh.edge_count() as f64, applied)
    }
}

/// Nanoseconds per edge, and the number of times that the operation was applied.
fn time<M>(
    mut mesh: M,
    edges: &[EdgeId],
    mut apply: impl FnMut(&mut M, EdgeId) -> bool,
) -> (f64, usize) {
    let start = Instant::now();
    let applied = edges.iter().filter(|&&edge| apply(&mut mesh, edge)).count();
    let nanoseconds = start.elapsed().as_nanos() as f64;
    black_box(mesh);
    (nanoseconds / edges.len() as f64, applied)
}
