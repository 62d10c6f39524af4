//! The operations of a course, emitted for its mesh class by the command that its students would
//! write, compiled as its build does, and held against what the course expects of them.

use std::fs;
use std::process::Command;

use tempfile::TempDir;

use crate::compiler::{compile, folder, has_compiler};

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
        fs::copy(folder("tests/compiled/scotty3d").join(file), bench.path().join(file)).unwrap();
    }
    let args = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-o", "expected"];
    let files = ["local.cpp", "halfedge.cpp", "expected.cpp"];
    compile(bench.path(), "g++", &[&args[..], &files].concat());
    let run = Command::new(bench.path().join("expected")).output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
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
