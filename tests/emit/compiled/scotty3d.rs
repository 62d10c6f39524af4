//! The operations of a course, emitted for its mesh class by the command that its students would
//! write, compiled as its build does, and held against what the course expects of them.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use serde_json::Value as Json;
use tempfile::TempDir;

use crate::compiled::compiler::{compile, folder, has_compiler};

/// What `hedgerow` prints; it has to succeed.
pub fn hedgerow(args: &[&str]) -> String {
    let done = Command::new(env!("CARGO_BIN_EXE_hedgerow")).args(args).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

#[test]
fn the_course_finds_what_it_expects() {
    if !has_compiler() {
        return;
    }
    let bench = TempDir::new().unwrap();
    let emitted = bench.path().join("local.cpp").display().to_string();
    let plan = ["plan", "std/scotty3d.hedge", "--as", "cpp", "--for", "scotty3d"];
    hedgerow(&[&plan[..], &["-o", &emitted]].concat());
    for file in ["halfedge.h", "halfedge.cpp", "expected.cpp"] {
        fs::copy(folder("tests/emit/compiled/scotty3d").join(file), bench.path().join(file))
            .unwrap();
    }
    let args = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "expected"];
    let files = ["local.cpp", "halfedge.cpp", "expected.cpp"];
    compile(bench.path(), "g++", &[&args[..], &files].concat());
    let run = Command::new(bench.path().join("expected")).output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
}

/// A list of polygons as the program reads it.
fn polygons(value: &Json, out: &mut String) {
    let [vertices, faces] = ["vertices", "faces"].map(|key| value[key].as_array().unwrap());
    writeln!(out, "{} {}", vertices.len(), faces.len()).unwrap();
    for list in vertices {
        list.as_array().unwrap().iter().for_each(|x| write!(out, "{x} ").unwrap());
    }
    for list in faces {
        let list = list.as_array().unwrap();
        write!(out, "\n{}", list.len()).unwrap();
        list.iter().for_each(|x| write!(out, " {x}").unwrap());
    }
    out.push('\n');
}

/// The cases of `local_ops.json.gz` on which all agree, for the program in `cases.cpp`.
fn cases() -> (String, usize) {
    let packed = fs::File::open(folder("tests/run/data").join("local_ops.json.gz")).unwrap();
    let table: Json = serde_json::from_reader(flate2::read::GzDecoder::new(packed)).unwrap();
    let mut out = String::new();
    let mut count = 0;
    for case in table["cases"].as_array().unwrap() {
        if !case["ambiguous"].is_null() {
            continue;
        }
        count += 1;
        let elements = case["element"].as_array().unwrap();
        let [name, op] = [&case["name"], &case["op"]].map(|text| text.as_str().unwrap());
        writeln!(out, "{name} {op} {}", elements.len()).unwrap();
        for element in elements {
            let at: Vec<Json> = match element["kind"].as_str().unwrap() {
                "vertex" => vec![element["index"].clone()],
                "edge" => element["halfedge"].as_array().unwrap().clone(),
                _ => element["loop"].as_array().unwrap().clone(),
            };
            write!(out, "{}", at.len()).unwrap();
            at.iter().for_each(|number| write!(out, " {number}").unwrap());
            out.push('\n');
        }
        polygons(&table["meshes"][case["mesh"].as_str().unwrap()], &mut out);
        match &case["expect"] {
            Json::String(refuse) => writeln!(out, "{refuse}").unwrap(),
            expect => {
                writeln!(out, "done {}", expect["counts"]["edges"]).unwrap();
                polygons(expect, &mut out);
            }
        }
    }
    (out, count)
}

#[test]
fn every_case_of_the_table_is_reproduced() {
    if !has_compiler() {
        return;
    }
    let bench = TempDir::new().unwrap();
    let emitted = bench.path().join("local.cpp").display().to_string();
    let plan = ["plan", "std/scotty3d.hedge", "--as", "cpp", "--for", "scotty3d"];
    hedgerow(&[&plan[..], &["-o", &emitted]].concat());
    for file in ["halfedge.h", "halfedge.cpp", "cases.cpp"] {
        fs::copy(folder("tests/emit/compiled/scotty3d").join(file), bench.path().join(file))
            .unwrap();
    }
    let args = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "cases"];
    compile(
        bench.path(),
        "g++",
        &[&args[..], &["local.cpp", "halfedge.cpp", "cases.cpp"]].concat(),
    );
    let (cases, count) = cases();
    fs::write(bench.path().join("cases.txt"), cases).unwrap();
    let input = fs::File::open(bench.path().join("cases.txt")).unwrap();
    let run = Command::new(bench.path().join("cases")).stdin(input).output().unwrap();
    let said = String::from_utf8_lossy(&run.stdout);
    println!("{said}");
    assert!(run.status.success(), "{said}");
    let counts = said.lines().flat_map(|line| line.split(' ').skip(1));
    let counts: Vec<usize> = counts.map(|count| count.parse().unwrap()).collect();
    assert_eq!(counts.iter().sum::<usize>(), count);
    assert_eq!(counts.len(), 24, "{said}");
    assert!(count > 1_000, "{count} cases");
}

#[test]
fn a_target_is_a_file_that_users_can_write() {
    let bench = TempDir::new().unwrap();
    let path = bench.path().join("mine.target");
    let target = hedgerow(&["std", "scotty3d.target"]);
    fs::write(&path, target.replace("=flip_edge", "=turn")).unwrap();
    let path = path.display().to_string();
    let plan =
        |target| hedgerow(&["plan", "std/polygon.hedge::flip", "--as", "cpp", "--for", target]);
    let (own, shipped) = (plan(&path), plan("scotty3d"));
    let head = "std::optional<Halfedge_Mesh::EdgeRef> Halfedge_Mesh::flip_edge(EdgeRef e) {";
    assert!(shipped.contains(head), "{shipped}");
    assert_eq!(own.replace("::turn(", "::flip_edge("), shipped);
}
