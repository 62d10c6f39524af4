//! Emitted Rust, compiled with `rustc` into a program that holds it against the machine.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use hedgerow::diagram::Type;
use hedgerow::emit::rust;
use support::emission::subjects::{Emission, Subject, emissions};
use tempfile::TempDir;

/// A program of all operations, those of an emission in a module of their own, and a function
/// that calls one by its name.
fn text(emissions: &[Emission]) -> String {
    let mut text = String::new();
    for emission in emissions {
        let code = through_support(&rust(&emission.selection()).unwrap());
        writeln!(text, "mod {} {{\n{code}}}", emission.name).unwrap();
    }
    text.push_str(
        "use support::emission::{hold_rust, places::Argument::{self, *}};\n\
         use support::hedgerow::mesh::glam::DVec3;\n\
         use support::hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};\n\
         fn call(name: &str, mesh: &mut Mesh, a: &[Argument]) -> (bool, Option<u32>) {\n    \
         match (name, a) {\n",
    );
    for emission in emissions {
        for subject in &emission.subjects {
            text.push_str(&arm(&emission.name, subject));
        }
    }
    text + "        _ => panic!(\"{name} is not there\"),\n    }\n}\n\
            fn main() {\n    hold_rust(call);\n}\n"
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

/// Emitted code that knows its crates by way of the tests' own, of which there is one build.
pub fn through_support(code: &str) -> String {
    code.replace("use hedgerow::", "use support::hedgerow::")
}

/// The arguments of `rustc` for the tests' own crate.
pub fn with_support() -> [String; 4] {
    let test = env::current_exe().unwrap();
    let folder = test.parent().unwrap();
    let dependencies = format!("dependency={}", folder.display());
    let support = format!("support={}", built(folder).display());
    ["-L".into(), dependencies, "--extern".into(), support]
}

/// The library of the tests' own crate, as it was built for this test: the newest beside it.
fn built(folder: &Path) -> PathBuf {
    let files = fs::read_dir(folder).expect("the test lies in a folder");
    let files = files.map(|file| file.expect("a readable entry").path()).filter(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libsupport-") && name.ends_with(".rlib")
    });
    let written = |path: &PathBuf| fs::metadata(path).and_then(|file| file.modified()).ok();
    files.max_by_key(written).expect("the tests are linked with it")
}

#[test]
fn rust_does_what_the_machine_does() {
    let bench = TempDir::new().unwrap();
    fs::write(bench.path().join("main.rs"), text(&emissions())).unwrap();
    let cargo = env::var_os("CARGO").map(PathBuf::from);
    let compiler = cargo.map(|cargo| cargo.with_file_name("rustc")).filter(|path| path.exists());
    let output = Command::new(compiler.unwrap_or("rustc".into()))
        .args(["--edition=2024", "-Dwarnings", "-Adead_code", "main.rs"])
        .args(with_support())
        .current_dir(bench.path())
        .output()
        .expect("rustc runs");
    assert!(output.status.success(), "rustc says\n{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(bench.path().join("main")).output().expect("it runs");
    print!("{}", String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
