//! Emitted C++, compiled with g++.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use glam::DVec3;
use hedgerow::diagram::Type;
use hedgerow::emit::{Style, cpp};
use hedgerow::mesh::{EdgeId, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};
use tempfile::TempDir;

use support::emission::columns;
use support::emission::places::{
    Argument, Done, Stopped, Tally, arguments, by_machine, compare, places, report,
};
use support::emission::subjects::{Subject, emissions, folder};
use support::meshes::Dice;

/// Whether there is a compiler. In CI there has to be one.
fn has_compiler() -> bool {
    let found = Command::new("g++").arg("--version").output().is_ok();
    if !found {
        assert!(std::env::var_os("CI").is_none(), "CI needs g++");
        eprintln!("SKIPPED: there is no g++, so emitted C++ is neither compiled nor run");
    }
    found
}

fn compile(folder: &Path) {
    let output = Command::new("g++")
        .args(["-std=c++17", "-O0", "-Wall", "-Wextra", "-Werror", "-pedantic"])
        .args(["-o", "driver", "driver.cpp"])
        .current_dir(folder)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "g++ says\n{said}");
}

/// The function that calls an op by its number.
fn calls(subjects: &[&Subject]) -> String {
    let mut text =
        String::from("bool call(int op, Built& b) {\n  Mesh& mesh = b.mesh;\n  switch (op) {\n");
    for (at, subject) in subjects.iter().enumerate() {
        let mut reads = String::new();
        let mut args = Vec::new();
        for (number, param) in subject.params.iter().enumerate() {
            let read = match param.ty {
                Type::Vertex => "b.v[number()]",
                Type::Halfedge => "b.h[number()]",
                Type::Edge => "b.e[number()]",
                Type::Face => "b.f[number()]",
                Type::Real => "real()",
                Type::Vec3 => "Vector(0, 0, 0)",
                _ => "number()",
            };
            writeln!(reads, "      auto x{number} = {read};").unwrap();
            if param.ty == Type::Vec3 {
                for part in ["x", "y", "z"] {
                    writeln!(reads, "      x{number}.{part} = real();").unwrap();
                }
            }
            args.push(format!("x{number}"));
        }
        let (name, args) = (&subject.name, args.join(", "));
        writeln!(text, "    case {at}: {{\n{reads}      return applied(mesh, OPERATION({name}, {args}));\n    }}").unwrap();
    }
    text + "  }\n  return false;\n}\n"
}

fn table(mesh: &Mesh) -> String {
    let capacity = |kind| mesh.capacity(kind) as u32;
    let counts = [ElementKind::Vertex, ElementKind::Halfedge, ElementKind::Edge, ElementKind::Face];
    let mut text = String::from("mesh");
    for kind in counts {
        assert!((0..capacity(kind)).all(|id| mesh.is_alive(kind, id)), "no gaps");
        write!(text, " {}", capacity(kind)).unwrap();
    }
    text.push('\n');
    let attributes = |kind, id| {
        let numbers = columns::numbers(mesh, kind, id).into_iter();
        numbers.map(|x| format!(" {x:?}")).collect::<String>() + "\n"
    };
    for h in mesh.halfedges() {
        let (next, twin) = (mesh.next(h).0, mesh.twin(h).0);
        let (vertex, edge, face) = (mesh.vertex(h).0, mesh.edge(h).0, mesh.face(h).0);
        write!(text, "{next} {twin} {vertex} {edge} {face}").unwrap();
        text.push_str(&attributes(ElementKind::Halfedge, h.0));
    }
    for v in mesh.vertices() {
        let DVec3 { x, y, z } = mesh.position(v);
        write!(text, "{} {x:?} {y:?} {z:?}", mesh.vertex_halfedge(v).0).unwrap();
        text.push_str(&attributes(ElementKind::Vertex, v.0));
    }
    for e in mesh.edges() {
        write!(text, "{}", mesh.edge_halfedge(e).0).unwrap();
        text.push_str(&attributes(ElementKind::Edge, e.0));
    }
    for f in mesh.faces() {
        let (halfedge, hole) = (mesh.face_halfedge(f).0, u8::from(mesh.is_hole(f)));
        write!(text, "{halfedge} {hole}").unwrap();
        text.push_str(&attributes(ElementKind::Face, f.0));
    }
    text
}

/// The mesh of the tables that the driver prints.
fn mesh_of<'t>(words: &mut impl Iterator<Item = &'t str>) -> Mesh {
    let mut mesh = Mesh::default();
    let mut numbers = words.map(|word| word.parse::<f64>().unwrap());
    let mut count = || numbers.next().unwrap() as u32;
    let [vertices, halfedges, edges, faces] = [count(), count(), count(), count()];
    (0..vertices).for_each(|_| _ = mesh.add_vertex());
    (0..halfedges).for_each(|_| _ = mesh.add_halfedge());
    (0..edges).for_each(|_| _ = mesh.add_edge());
    (0..faces).for_each(|_| _ = mesh.add_face());
    columns::add(&mut mesh);
    for h in (0..halfedges).map(HalfedgeId) {
        let mut id = || numbers.next().unwrap() as u32;
        let next = HalfedgeId(id());
        mesh.set_next(h, next);
        mesh.set_prev(next, h);
        mesh.set_twin(h, HalfedgeId(id()));
        mesh.set_vertex(h, VertexId(id()));
        mesh.set_edge(h, EdgeId(id()));
        mesh.set_face(h, FaceId(id()));
        columns::set_numbers(&mut mesh, ElementKind::Halfedge, h.0, &mut numbers);
    }
    for v in (0..vertices).map(VertexId) {
        let mut number = || numbers.next().unwrap();
        mesh.set_vertex_halfedge(v, HalfedgeId(number() as u32));
        mesh.set_position(v, DVec3::new(number(), number(), number()));
        columns::set_numbers(&mut mesh, ElementKind::Vertex, v.0, &mut numbers);
    }
    for e in (0..edges).map(EdgeId) {
        let halfedge = numbers.next().unwrap();
        mesh.set_edge_halfedge(e, HalfedgeId(halfedge as u32));
        columns::set_numbers(&mut mesh, ElementKind::Edge, e.0, &mut numbers);
    }
    for f in (0..faces).map(FaceId) {
        let mut number = || numbers.next().unwrap();
        mesh.set_face_halfedge(f, HalfedgeId(number() as u32));
        mesh.set_hole(f, number() != 0.0);
        columns::set_numbers(&mut mesh, ElementKind::Face, f.0, &mut numbers);
    }
    mesh
}

/// What the driver has done with one call.
fn done<'t>(words: &mut impl Iterator<Item = &'t str>) -> Done {
    match words.next() {
        Some("applied") => {
            let result: i64 = words.next().unwrap().parse().unwrap();
            Ok(Some((mesh_of(words), u32::try_from(result).ok())))
        }
        Some("refused") => Ok(None),
        Some("stopped") => Err(Stopped),
        word => panic!("the driver says {word:?}"),
    }
}

/// The style of the class with accessors.
pub fn accessors() -> Style {
    let mut style = Style::default();
    for text in [
        "accessors",
        "mesh=HalfEdgeMesh",
        "member=yes",
        "halfedge=half_edge",
        "prev=prev",
        "Vertex=V",
        "Halfedge=H",
        "Edge=E",
        "Face=F",
        "Vector=course::Vec",
        "Vector2=course::Two",
        "Vector4=course::Four",
        "Matrix4=course::Matrix",
        "erase_vertex=delete_vertex({of})",
        "erase_halfedge=delete_halfedge({of})",
        "erase_edge=delete_edge({of})",
        "erase_face=delete_face({of})",
    ] {
        style.set(text).unwrap();
    }
    style
}

/// The declarations of the member functions that a text defines, which the class wants.
pub fn declared(text: &str) -> String {
    let signature = |line: &&str| {
        line.contains(" HalfEdgeMesh::") && line.ends_with(") {") && !line.starts_with([' ', 'i'])
    };
    let declared = text.lines().filter(signature);
    declared
        .map(|line| line.replacen(" HalfEdgeMesh::", " ", 1))
        .map(|line| line.replace(") {", ");\n").replace("HalfEdgeMesh::", ""))
        .collect()
}

/// Compiles the ops in a style and holds the driver against the machine.
fn run(title: &str, style: &Style, header: &str, tolerance: f64, most: usize) {
    let emissions = emissions();
    let texts = emissions.iter();
    let text: String = texts.map(|emission| cpp(&emission.selection(), style).unwrap()).collect();
    let mut subjects: Vec<_> = emissions.iter().flat_map(|emission| &emission.subjects).collect();
    // Refusals that hang by the last bit of a length fall the other way for short reals.
    subjects.retain(|subject| tolerance < 1e-8 || !hangs_by_a_bit(subject));
    let bench = TempDir::new().unwrap();
    let declared = declared(&text);
    let write = |name: &str, text: &str| fs::write(bench.path().join(name), text).unwrap();
    write("declared.h", &declared);
    write("mesh.h", &fs::read_to_string(folder("tests/emit").join(header)).unwrap());
    write("driver.h", &fs::read_to_string(folder("tests/emit/driver.h")).unwrap());
    let calls = calls(&subjects);
    write("driver.cpp", &format!("#include \"mesh.h\"\n{text}\n#include \"driver.h\"\n{calls}"));
    compile(bench.path());

    let mut dice = Dice(5);
    let mut input = String::new();
    let mut expected = Vec::new();
    for place in places() {
        input.push_str(&table(&place.mesh));
        for (at, subject) in subjects.iter().enumerate() {
            if place.level < subject.plan.level {
                continue;
            }
            for arguments in arguments(subject, &place.mesh, most, &mut dice) {
                write!(input, "call {at}").unwrap();
                for argument in &arguments {
                    match argument {
                        Argument::Element(id) => write!(input, " {id}").unwrap(),
                        Argument::Bool(value) => write!(input, " {}", u8::from(*value)).unwrap(),
                        Argument::Int(value) => write!(input, " {value}").unwrap(),
                        Argument::Real(value) => write!(input, " {value:?}").unwrap(),
                        Argument::Vec3([x, y, z]) => write!(input, " {x:?} {y:?} {z:?}").unwrap(),
                    }
                }
                input.push('\n');
                let machine = by_machine(subject, &place, &arguments);
                expected.push((at, arguments, machine));
            }
        }
    }
    let mut driver = Command::new(bench.path().join("driver"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut stdin = driver.stdin.take().unwrap();
    let feed = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = driver.wait_with_output().unwrap();
    assert!(output.status.success(), "the driver ends with {}", output.status);
    feed.join().unwrap().unwrap();
    let output = String::from_utf8(output.stdout).unwrap();
    let mut words = output.split_whitespace();
    let mut tallies = vec![Tally::default(); subjects.len()];
    for (at, arguments, machine) in &expected {
        let emitted = done(&mut words);
        let tally = &mut tallies[*at];
        compare(subjects[*at], arguments, tally, tolerance, [machine, &emitted]);
    }
    assert_eq!(words.next(), None);
    let tallies: Vec<_> = subjects.into_iter().zip(tallies).collect();
    report(title, &tallies);
}

fn hangs_by_a_bit(subject: &Subject) -> bool {
    subject.name.starts_with("values_") || subject.name.starts_with("remesh_")
}

#[test]
fn cpp_with_fields_does_what_the_machine_does() {
    if has_compiler() {
        run("C++, fields", &Style::default(), "fields.h", 1e-9, 40);
    }
}

#[test]
fn cpp_with_accessors_does_what_the_machine_does() {
    if !has_compiler() {
        return;
    }
    run("C++, accessors", &accessors(), "accessors.h", 1e-4, 8);
}
