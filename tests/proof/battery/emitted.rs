//! Ops that were accepted, written as C++ and compiled in one batch: they do what the machine
//! does, and what they leave is a mesh.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;

use hedgerow::check::{Proved, check};
use hedgerow::compile::compile;
use hedgerow::diagram::{Op, Type};
use hedgerow::emit::{Selection, Style, cpp};
use hedgerow::mesh::{ElementKind, Mesh, same_connectivity, validate};
use hedgerow::resolve::Program;
use hedgerow::rewrite::{Machine, Outcome};
use hedgerow::source::Sources;
use tempfile::TempDir;

use crate::battery::bases::read_back;
use crate::battery::judge::{TRIED, sizes};
use crate::battery::trial::{Pool, Trial};
use support::reference::printing::mesh_text;
use support::reference::random::Random;

/// What is called, and what the machine makes of it.
struct Call {
    op: usize,
    place: Vec<u32>,
    mesh: Mesh,
    expected: Option<Mesh>,
}

/// Compiles ops, and holds what they do at places of the pool against the machine.
pub fn do_what_the_machine_does(texts: &[&str], pool: &Pool, seed: u64) {
    if Command::new("g++").arg("--version").output().is_err() {
        assert!(std::env::var_os("CI").is_none(), "CI needs g++");
        eprintln!("SKIPPED: there is no g++, so emitted C++ is neither compiled nor run");
        return;
    }
    let mut sources = Sources::new();
    let mut proved: Vec<Option<Proved>> = Vec::new();
    let mut calls = Vec::new();
    let mut random = Random::new(seed);
    for (at, text) in texts.iter().enumerate() {
        let (name, rest) = text["op ".len()..].split_once('(').expect("an op");
        let text = format!("op {name}_{at}({rest}");
        let (of, op) = read_back(&text).expect("it was read before");
        let proof = check(&op).expect("it was accepted before");
        let plan = compile(&proof, &of, &Arc::default()).expect("a small op");
        let tried = sizes(&op, &text, TRIED);
        for Trial { mesh, places } in pool.trials(&tried, &mut random) {
            // Emitted code has no place for an isolated vertex.
            if mesh.vertices().any(|v| mesh.vertex_halfedge(v).is_none()) {
                continue;
            }
            for place in places.into_iter().take(12) {
                let slots: Vec<_> = place.iter().map(|&element| u64::from(element)).collect();
                let mut result = mesh.clone();
                let outcome = Machine::default().apply(&mut result, &plan, &slots);
                let applied = matches!(outcome, Ok(Outcome::Applied { .. }));
                let expected = applied.then_some(result);
                calls.push(Call { op: at, place, mesh: mesh.clone(), expected });
            }
        }
        sources = of;
        proved.push(Some(proof));
    }
    let ops: Vec<_> = (0..proved.len()).collect();
    let program = Program::default();
    let selection = Selection {
        program: &program,
        proved: &proved,
        sources: &sources,
        ops: &ops,
        exhaustive: false,
    };
    let text = cpp(&selection, &Style::default()).expect("drawn ops can be emitted");
    let output = run(&text, &proved, &calls);
    let mut words = output.split_whitespace();
    let mut applied = 0;
    for call in &calls {
        let Call { op, place, mesh, expected } = call;
        let emitted = match words.next() {
            Some("applied") => Some(read(&mut words)),
            Some("refused") => None,
            word => panic!("the driver says {word:?} of {}", texts[*op]),
        };
        let told = || format!("{}at {place:?} of\n{}", texts[*op], mesh_text(mesh));
        match (expected, emitted) {
            (None, None) => {}
            (Some(expected), Some(emitted)) => {
                applied += 1;
                let valid = validate(&emitted);
                assert_eq!(valid, Ok(()), "emitted: {}makes\n{}", told(), mesh_text(&emitted));
                let same = same_connectivity(expected, &emitted);
                assert!(same, "emitted: {}makes\n{}", told(), mesh_text(&emitted));
            }
            (Some(_), None) => panic!("emitted code refuses what the machine applies: {}", told()),
            (None, Some(_)) => panic!("emitted code applies what the machine refuses: {}", told()),
        }
    }
    println!("{} ops emitted, {} calls, {applied} applied", texts.len(), calls.len());
    assert!(applied > texts.len(), "only {applied} of {} calls applied", calls.len());
}

/// Compiles the ops with the driver, and feeds it the calls.
fn run(text: &str, proved: &[Option<Proved>], calls: &[Call]) -> String {
    let bench = TempDir::new().expect("a folder");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let write = |name: &str, text: &str| fs::write(bench.path().join(name), text).expect("a file");
    let header = fs::read_to_string(folder.join("emit/fields.h")).expect("the header");
    write("mesh.h", &header);
    let driver = fs::read_to_string(folder.join("proof/battery/driver.h")).expect("the driver");
    write("driver.h", &driver);
    let ops = proved.iter().flatten().map(Proved::op);
    let cases: String = ops.enumerate().map(|(at, op)| case(at, op)).collect();
    let call = format!(
        "bool call(int op, Built& b) {{\n  switch (op) {{\n{cases}  }}\n  return false;\n}}\n"
    );
    write("main.cpp", &format!("#include \"mesh.h\"\n{text}\n#include \"driver.h\"\n{call}"));
    let compiled = Command::new("g++")
        .args(["-std=c++17", "-O0", "-o", "main", "main.cpp"])
        .current_dir(bench.path())
        .output()
        .expect("g++ runs");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let mut input = String::new();
    for Call { op, place, mesh, .. } in calls {
        let place: Vec<_> = place.iter().map(u32::to_string).collect();
        writeln!(input, "{}{op} {}", table(mesh), place.join(" ")).expect("a string");
    }
    let mut driver = Command::new(bench.path().join("main"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the driver runs");
    let mut stdin = driver.stdin.take().expect("it reads");
    let feed = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = driver.wait_with_output().expect("it ends");
    let fed = feed.join().expect("it was fed");
    let text = String::from_utf8(output.stdout).expect("text");
    if !output.status.success() || fed.is_err() {
        // Each call that came to an end has a line that says what became of it.
        let is_answer = |line: &&str| line.starts_with("applied") || *line == "refused";
        let done = text.lines().filter(is_answer).count();
        let op = calls.get(done).and_then(|call| proved[call.op].as_ref());
        let place = calls.get(done).map(|call| (&call.place, mesh_text(&call.mesh)));
        let name = op.map(|proved| &proved.op().name);
        panic!("the driver ends with {} in {name:?} at {place:?}", output.status);
    }
    text
}

/// What calls an op by its number.
fn case(at: usize, op: &Op) -> String {
    let reads = op.params.iter().map(|param| match param.ty {
        Type::Vertex => "b.v[number()]",
        Type::Halfedge => "b.h[number()]",
        Type::Edge => "b.e[number()]",
        _ => "b.f[number()]",
    });
    let reads: Vec<_> = reads.collect();
    let lets = reads.iter().enumerate();
    let lets: String = lets.map(|(at, read)| format!("      auto x{at} = {read};\n")).collect();
    let args: String = (0..reads.len()).map(|at| format!(", x{at}")).collect();
    format!("    case {at}: {{\n{lets}      return bool({}(b.mesh{args}));\n    }}\n", op.name)
}

/// The pointers of a mesh without gaps.
fn table(mesh: &Mesh) -> String {
    let kinds = [ElementKind::Vertex, ElementKind::Halfedge, ElementKind::Edge, ElementKind::Face];
    let mut text: String = kinds.map(|kind| format!("{} ", mesh.capacity(kind))).concat();
    for h in mesh.halfedges() {
        let it = mesh.halfedge(h);
        let ids = [it.next.0, it.twin.0, it.vertex.0, it.edge.0, it.face.0];
        text.push_str(&ids.map(|id| format!("{id} ")).concat());
    }
    let vertices = mesh.vertices().map(|v| mesh.vertex_halfedge(v).0);
    let pointers = vertices.chain(mesh.edges().map(|e| mesh.edge_halfedge(e).0));
    text.extend(pointers.map(|id| format!("{id} ")));
    for f in mesh.faces() {
        write!(text, "{} {} ", mesh.face_halfedge(f).0, u8::from(mesh.is_hole(f))).expect("text");
    }
    text
}

/// The mesh that the driver prints, pointer by pointer.
fn read<'t>(words: &mut impl Iterator<Item = &'t str>) -> Mesh {
    let mut number = || words.next().and_then(|word| word.parse::<u32>().ok()).expect("a number");
    let mut mesh = Mesh::default();
    let [vertices, halfedges, edges, faces] = [number(), number(), number(), number()];
    (0..vertices).for_each(|_| _ = mesh.add_vertex());
    (0..halfedges).for_each(|_| _ = mesh.add_halfedge());
    (0..edges).for_each(|_| _ = mesh.add_edge());
    (0..faces).for_each(|_| _ = mesh.add_face());
    use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, VertexId};
    for h in (0..halfedges).map(HalfedgeId) {
        let next = HalfedgeId(number());
        mesh.set_next(h, next);
        mesh.set_prev(next, h);
        mesh.set_twin(h, HalfedgeId(number()));
        mesh.set_vertex(h, VertexId(number()));
        mesh.set_edge(h, EdgeId(number()));
        mesh.set_face(h, FaceId(number()));
    }
    (0..vertices).for_each(|v| mesh.set_vertex_halfedge(VertexId(v), HalfedgeId(number())));
    (0..edges).for_each(|e| mesh.set_edge_halfedge(EdgeId(e), HalfedgeId(number())));
    for f in (0..faces).map(FaceId) {
        mesh.set_face_halfedge(f, HalfedgeId(number()));
        mesh.set_hole(f, number() != 0);
    }
    mesh
}
