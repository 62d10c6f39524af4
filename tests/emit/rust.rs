//! Emitted Rust, compiled with the tests.

use std::fmt::Write as _;
use std::fs;

use hedgerow::diagram::Type;
use hedgerow::emit::rust;

use crate::emitted;
use crate::meshes::Dice;
use crate::places::{Tally, arguments, by_machine, compare, places, report};
use crate::subjects::{Subject, folder, functions, subjects};

/// The text of `emitted.rs`: all operations, and a function that calls one by its name.
fn text(subjects: &[Subject]) -> String {
    let proved: Vec<_> = subjects.iter().map(|subject| &subject.proved).collect();
    let mut text = String::from("// Written by the test `rust_is_as_committed` with UPDATE=1.\n");
    text.push_str(&rust(&proved, &functions(subjects)).unwrap());
    text.push_str(
        "\n/// Calls an operation: whether it applied, and its result.\n\
         pub fn call(name: &str, mesh: &mut Mesh, a: &[crate::places::Argument]) -> (bool, Option<u32>) {\n    \
         use crate::places::Argument::*;\n    match (name, a) {\n",
    );
    for Subject { name, proved, .. } in subjects {
        let (mut patterns, mut args) = (Vec::new(), Vec::new());
        for (at, param) in proved.op().params.iter().enumerate() {
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
        let call = format!("{name}(mesh, {args})");
        let call = match proved.op().result {
            Some(_) => format!("{{ let r = {call}; (r.is_some(), r.map(|r| r.0)) }}"),
            None => format!("({call}, None)"),
        };
        writeln!(text, "        (\"{name}\", &[{patterns}]) => {call},").unwrap();
    }
    text + "        _ => panic!(\"{name} is not there\"),\n    }\n}\n"
}

#[test]
fn rust_is_as_committed() {
    let text = text(&subjects());
    let path = folder("tests/emit/emitted.rs");
    if std::env::var_os("UPDATE").is_some_and(|value| value == "1") {
        fs::write(path, text).unwrap();
    } else {
        let committed = fs::read_to_string(path).unwrap();
        assert!(
            committed == text,
            "emitted.rs is another: UPDATE=1 writes it anew"
        );
    }
}

#[test]
fn rust_does_what_the_machine_does() {
    let subjects = subjects();
    let mut tallies = vec![Tally::default(); subjects.len()];
    let mut dice = Dice(7);
    for place in places() {
        for (subject, tally) in subjects.iter().zip(&mut tallies) {
            if place.level < subject.plan.level {
                continue;
            }
            for arguments in arguments(subject, &place.mesh, 40, &mut dice) {
                let machine = by_machine(subject, &place.mesh, &arguments);
                let mut mesh = place.mesh.clone();
                let (applied, result) = emitted::call(&subject.name, &mut mesh, &arguments);
                let emitted = applied.then_some((mesh, result));
                compare(subject, &arguments, tally, 1e-12, [&machine, &emitted]);
                if let (Some((_, expected)), Some((_, result))) = (&machine, &emitted) {
                    assert_eq!(expected, result, "{}", subject.name);
                }
            }
        }
    }
    let tallies: Vec<_> = subjects.iter().zip(tallies).collect();
    report("Rust", &tallies);
}
