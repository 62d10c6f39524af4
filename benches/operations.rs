//! Declared operations beside the same operations written by hand on the same mesh core.
//!
//!     cargo bench --bench operations
//!
//! Both run in turn, round by round, in one process; the best round of each counts, and the
//! ratio is what to quote: the machine's speed drifts, the ratio hardly does. Then the ways to call
//! an operation of the library beside each other: the machine alone, a session, and an application
//! that is made ready anew for each call.

use std::hint::black_box;
use std::time::Instant;

use hedgerow::analysis::{Analysis, Nowhere};
use hedgerow::mesh::{EdgeId, ElementKind, HalfedgeId, Mesh, shape};
use hedgerow::rewrite::{Machine, Outcome, Plan, Unwatched};
use hedgerow::run::{Application, Argument};
use hedgerow::source::Sources;
use hedgerow::{Program, Session};

const ROUNDS: usize = 15;

const FLIP: &str = include_str!("../examples/flip.hedge");
const SPLIT: &str = include_str!("../examples/split.hedge");

fn main() {
    let mesh = shape::triangle_torus(200, 205);
    println!("{} triangles, nanoseconds per operation, best of {ROUNDS} rounds", mesh.face_count());
    println!("{:<22}{:>9}{:>9}{:>9}", "", "by hand", "declared", "ratio");
    compare("flip, checked", &mesh, &plan(FLIP, "flip"), flip_by_hand);
    compare("split", &mesh, &plan(SPLIT, "split"), split_by_hand);
    let mesh = shape::triangle_torus(70, 71);
    println!("\n{} triangles, nanoseconds per call", mesh.face_count());
    println!("{:<22}{:>9}{:>9}{:>9}{:>13}", "", "machine", "session", "asked", "application");
    for op in ["flip", "split", "collapse"] {
        call("std/triangle.hedge", op, &mesh);
    }
    for op in ["flip", "collapse"] {
        call("std/polygon.hedge", op, &mesh);
    }
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
    // Machine, session, asked.
    let mut best = [f64::MAX; 3];
    for _ in 0..5 {
        let mut copy = mesh.clone();
        let mut machine = Machine::new(&analysis.plans);
        let mut slots = vec![0, 0.5_f64.to_bits()];
        let mut applied = [0; 2];
        let start = Instant::now();
        for edge in &edges {
            if copy.edge_alive(*edge) {
                machine.trust_level(plan.level);
                slots[0] = u64::from(edge.0);
                let outcome = machine.apply(&mut copy, plan, &slots);
                applied[0] += usize::from(matches!(outcome, Ok(Outcome::Applied { .. })));
            }
        }
        best[0] = best[0].min(start.elapsed().as_nanos() as f64);
        let mut session = Session::new(&program, mesh.clone());
        let start = Instant::now();
        for edge in &edges {
            if session.is_alive(*edge) {
                let outcome = session.apply(&op, *edge).expect("it has a value");
                applied[1] += usize::from(outcome.is_applied());
            }
        }
        best[1] = best[1].min(start.elapsed().as_nanos() as f64);
        assert_eq!(applied[0], applied[1], "both do the same");
        let mut session = Session::new(&program, mesh.clone());
        let start = Instant::now();
        black_box(session.mask(&op, ()).expect("it has a value"));
        best[2] = best[2].min(start.elapsed().as_nanos() as f64);
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
    let [machine, session, asked] = best.map(|all| all / edges.len() as f64);
    let level = format!("{name}, level {}", plan.level);
    println!("{level:<22}{machine:>9.1}{session:>9.1}{asked:>9.1}{application:>13.1}");
}

fn plan(text: &str, op: &str) -> Plan {
    let mut sources = Sources::new();
    let file = sources.add(op, text);
    let analysis = Analysis::of(&sources, file);
    let index = analysis.op(op).expect("the example declares the op");
    analysis.plans[index].clone().expect("the example's op is proved")
}

/// Applies both to every edge of a fresh copy of the mesh, in order.
fn compare(name: &str, mesh: &Mesh, plan: &Plan, by_hand: fn(&mut Mesh, EdgeId) -> bool) {
    let edges: Vec<EdgeId> = mesh.edges().collect();
    let (mut hand, mut declared) = (f64::MAX, f64::MAX);
    for _ in 0..ROUNDS {
        let (by_hand, applied_by_hand) = time(mesh, &edges, by_hand);
        let mut machine = Machine::default();
        let (by_plan, applied_by_plan) = time(mesh, &edges, |mesh, edge| {
            let outcome = machine.apply(mesh, plan, &[u64::from(edge.0)]);
            matches!(outcome, Ok(Outcome::Applied { .. }))
        });
        assert_eq!(applied_by_hand, applied_by_plan, "both do the same");
        assert!(applied_by_plan > 0, "something was applied");
        hand = hand.min(by_hand);
        declared = declared.min(by_plan);
    }
    println!("{name:<22}{hand:>9.1}{declared:>9.1}{:>9.2}", declared / hand);
}

fn time(
    mesh: &Mesh,
    edges: &[EdgeId],
    mut apply: impl FnMut(&mut Mesh, EdgeId) -> bool,
) -> (f64, usize) {
    let mut mesh = mesh.clone();
    let start = Instant::now();
    let applied = edges.iter().filter(|&&edge| apply(&mut mesh, edge)).count();
    let nanoseconds = start.elapsed().as_nanos() as f64;
    black_box(mesh.count(ElementKind::Edge));
    (nanoseconds / edges.len() as f64, applied)
}

/// The halfedges of the triangle at `a`, or `None`.
fn triangle(mesh: &Mesh, a: HalfedgeId) -> Option<[HalfedgeId; 3]> {
    let b = mesh.next(a);
    let c = mesh.next(b);
    (!mesh.is_hole(mesh.face(a)) && mesh.next(c) == a).then_some([a, b, c])
}

fn link(mesh: &mut Mesh, from: HalfedgeId, to: HalfedgeId) {
    mesh.set_next(from, to);
    mesh.set_prev(to, from);
}

fn flip_by_hand(mesh: &mut Mesh, edge: EdgeId) -> bool {
    let a = mesh.edge_halfedge(edge);
    let (Some([a, b, c]), Some([d, g, h])) = (triangle(mesh, a), triangle(mesh, mesh.twin(a)))
    else {
        return false;
    };
    let [v0, v1, v2, v3] = [a, b, c, h].map(|half| mesh.vertex(half));
    let distinct = v0 != v1 && v0 != v2 && v0 != v3 && v1 != v2 && v1 != v3 && v2 != v3;
    if !distinct || mesh.adjacent(v2, v3) {
        return false;
    }
    let (f0, f1) = (mesh.face(a), mesh.face(d));
    for (from, to) in [(a, c), (c, g), (g, a), (d, h), (h, b), (b, d)] {
        link(mesh, from, to);
    }
    mesh.set_vertex(a, v3);
    mesh.set_vertex(d, v2);
    mesh.set_face(g, f0);
    mesh.set_face(b, f1);
    mesh.set_face_halfedge(f0, a);
    mesh.set_face_halfedge(f1, d);
    mesh.set_vertex_halfedge(v0, g);
    mesh.set_vertex_halfedge(v1, b);
    true
}

fn split_by_hand(mesh: &mut Mesh, edge: EdgeId) -> bool {
    let a = mesh.edge_halfedge(edge);
    let (Some([a, b, c]), Some([d, g, h])) = (triangle(mesh, a), triangle(mesh, mesh.twin(a)))
    else {
        return false;
    };
    let [v0, v1, v2, v3] = [a, b, c, h].map(|half| mesh.vertex(half));
    if v0 == v1 || v0 == v2 || v0 == v3 || v1 == v2 || v1 == v3 || v2 == v3 {
        return false;
    }
    let (f0, f1) = (mesh.face(a), mesh.face(d));
    let middle = (mesh.position(v0) + mesh.position(v1)) / 2.0;
    let m = mesh.add_vertex();
    let [p, q, r, s, t, u] = [(); 6].map(|()| mesh.add_halfedge());
    let [f2, f3] = [(); 2].map(|()| mesh.add_face());
    let [e1, e2, e3] = [(); 3].map(|()| mesh.add_edge());
    for [x, y, z] in [[a, p, c], [q, b, r], [d, s, h], [t, g, u]] {
        link(mesh, x, y);
        link(mesh, y, z);
        link(mesh, z, x);
    }
    for (half, vertex, face) in
        [(p, m, f0), (q, m, f2), (r, v2, f2), (s, m, f1), (t, m, f3), (u, v3, f3)]
    {
        mesh.set_vertex(half, vertex);
        mesh.set_face(half, face);
    }
    mesh.set_face(b, f2);
    mesh.set_face(g, f3);
    for (e, x, y) in [(edge, a, t), (e1, q, d), (e2, p, r), (e3, s, u)] {
        mesh.set_twin(x, y);
        mesh.set_twin(y, x);
        mesh.set_edge(x, e);
        mesh.set_edge(y, e);
        mesh.set_edge_halfedge(e, x);
    }
    for (face, half) in [(f0, a), (f1, d), (f2, q), (f3, t)] {
        mesh.set_face_halfedge(face, half);
    }
    mesh.set_vertex_halfedge(m, p);
    mesh.set_position(m, middle);
    true
}
