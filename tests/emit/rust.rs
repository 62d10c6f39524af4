//! Emitted Rust, compiled with the tests.

use std::fmt::Write as _;
use std::fs;

use hedgerow::diagram::Type;
use hedgerow::emit::rust;
use hedgerow::mesh::identical;

use crate::emitted;
use crate::meshes::Dice;
use crate::places::{Tally, arguments, by_machine, compare, places, report};
use crate::subjects::{Emission, Subject, emissions, folder};

/// The text of `emitted.rs`: all operations, those of a program in a module of their own, and a
/// function that calls one by its name.
fn text(emissions: &[Emission]) -> String {
    let mut text = String::from("// Written by the test `rust_is_as_committed` with UPDATE=1.\n");
    for emission in emissions {
        let code = rust(&emission.selection()).unwrap();
        writeln!(text, "\nmod {} {{\n{code}}}", emission.name).unwrap();
    }
    text.push_str(
        "\nuse crate::places::Argument::{self, *};\n\
         use glam::DVec3;\n\
         use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};\n\n\
         /// Calls an operation: whether it applied, and its result.\n\
         pub fn call(name: &str, mesh: &mut Mesh, a: &[Argument]) -> (bool, Option<u32>) {\n    \
         match (name, a) {\n",
    );
    for emission in emissions {
        for subject in &emission.subjects {
            text.push_str(&arm(&emission.name, subject));
        }
    }
    text + "        _ => panic!(\"{name} is not there\"),\n    }\n}\n"
}

fn arm(module: &str, subject: &Subject) -> String {
    let name = &subject.name;
    let (mut patterns, mut args) = (Vec::new(), Vec::new());
    for (at, param) in subject.params.iter().enumerate() {
        let (pattern, arg) = match param.ty {
            Type::Vertex => ("Element", format!("VertexId(x{at})")),
            Type::Halfedge => ("Element", format!("HalfedgeId(x{at})")),
            Type::Edge => ("Element", format!("EdgeId(x{at})")),
            Type::Face => ("Element", format!("FaceId(x{at})")),
            Type::Bool => ("Bool", format!("x{at}")),
            Type::Int => ("Int", format!("x{at}")),
            Type::Real => ("Real", format!("x{at}")),
            _ => ("Vec3", format!("DVec3::from_array(x{at})")),
        };
        patterns.push(format!("{pattern}(x{at})"));
        args.push(arg);
    }
    let (patterns, args) = (patterns.join(", "), args.join(", "));
    let call = format!("{module}::{name}(mesh, {args})");
    let call = match subject.result {
        Some(_) => format!("{{ let r = {call}; (r.is_some(), r.map(|r| r.0)) }}"),
        None => format!("({call}, None)"),
    };
    format!("        (\"{name}\", &[{patterns}]) => {call},\n")
}

#[test]
fn rust_is_as_committed() {
    let text = text(&emissions());
    let path = folder("tests/emit/emitted.rs");
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        fs::write(path, text).unwrap();
    } else {
        let committed = fs::read_to_string(path).unwrap();
        assert!(committed == text, "emitted.rs is another: UPDATE=1 writes it anew");
    }
}

#[test]
fn rust_does_what_the_machine_does() {
    let emissions = emissions();
    let subjects = emissions.iter().flat_map(|emission| &emission.subjects);
    let subjects: Vec<_> = subjects.collect();
    let mut tallies = vec![Tally::default(); subjects.len()];
    let mut dice = Dice(7);
    for place in places() {
        for (&subject, tally) in subjects.iter().zip(&mut tallies) {
            if place.level < subject.plan.level {
                continue;
            }
            for arguments in arguments(subject, &place.mesh, 40, &mut dice) {
                let machine = by_machine(subject, &place, &arguments);
                let mut mesh = place.mesh.clone();
                let (applied, result) = emitted::call(&subject.name, &mut mesh, &arguments);
                assert!(
                    applied || identical(&mesh, &place.mesh),
                    "{} is refused at {arguments:?}, and leaves a trace",
                    subject.name
                );
                let emitted = applied.then_some((mesh, result));
                compare(subject, &arguments, tally, 1e-12, [&machine, &emitted]);
                if let (Some((_, expected)), Some((_, result))) = (&machine, &emitted) {
                    assert_eq!(expected, result, "{}", subject.name);
                }
            }
        }
    }
    let tallies: Vec<_> = subjects.into_iter().zip(tallies).collect();
    report("Rust", &tallies);
}
