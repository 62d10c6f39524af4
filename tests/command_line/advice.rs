//! Arguments that make no command: each is met with one line that says what was meant.

use crate::bench::{Bench, example};

/// Runs a command beside a square, a program with a flip and one with a script; it fails, and says
/// one line in which some words stand.
fn advised(arguments: &[&str], words: &str) {
    let bench = Bench::with_square();
    bench.write("flip.hedge", std::fs::read_to_string(example("flip.hedge")).unwrap());
    bench.write("go.hedge", "script go(target: real = 1) { print target }\n");
    let told = bench.fails(2, arguments, words).err;
    let errors = told.lines().filter(|line| line.starts_with("error")).count();
    assert_eq!(errors, 1, "{arguments:?}: {told}");
}

#[test]
fn what_is_no_command() {
    advised(&["flip", "square.obj"], "hedgerow apply std/triangle::flip MESH --at PLACE -o OUT");
    advised(&["remesh", "square.obj"], "hedgerow run std/remesh::remesh MESH -o OUT");
    advised(&["flip.hedge"], "hedgerow check flip.hedge");
    advised(&["square.obj"], "hedgerow info square.obj");
    advised(&["emit", "flip.hedge::flip"], "`hedgerow plan FILE::OP --as cpp -o OUT.hpp`");
    advised(&["chekc", "flip.hedge"], "'check'");
}

#[test]
fn program_and_mesh_in_another_order() {
    advised(&["run", "square.obj"], "the program stands before it");
    advised(&["run", "square.obj", "go.hedge"], "`square.obj` is a mesh");
    advised(&["run", "go.hedge", "go.hedge"], "`go.hedge` is a program; a mesh is wanted here");
    advised(&["info", "go.hedge"], "`go.hedge` is a program; a mesh is wanted here");
    advised(&["fmt", "square.obj"], "`square.obj` is a mesh; a program is wanted here");
    advised(&["run", "flip.hedge", "flip", "square.obj"], "run flip.hedge::flip square.obj");
    advised(&["run", "flip.hedge", "square.obj"], "hedgerow apply flip.hedge::flip MESH");
}

#[test]
fn options_written_otherwise() {
    advised(&["run", "go.hedge", "square.obj", "out.obj"], "`-o out.obj`");
    advised(&["run", "go.hedge", "square.obj", "--target", "2"], "`--set target=…`");
    advised(&["run", "go.hedge", "square.obj", "--set", "target", "2"], "`--set target=2`");
    advised(&["run", "go.hedge", "square.obj", "target=2"], "--set target=2");
    let two = ["run", "go.hedge", "square.obj", "--set", "target=2", "other=3", "-o", "x.obj"];
    advised(&two, "each parameter has its own `--set`: `--set target=2 --set other=3`");
    let as_mesh = ["run", "go.hedge", "--set", "target=2", "other=3"];
    advised(&as_mesh, "the value of a parameter is given by `--set other=3`");
    let before = ["run", "go.hedge", "--set", "target=2", "other=3", "square.obj"];
    advised(&before, "`--set target=2 --set other=3`");
    advised(&["run", "go.hedge", "square.obj", "--set", "at=1", "2"], "`--set NAME=VALUE` without");
    advised(&["run", "go.hedge", "square.obj", "--seed", "x"], "a whole number from 0");
    advised(&["info", "square.obj", "--threads", "0"], "a whole number from 1 is wanted");
    advised(&["info", "square.obj", "--threads", "x"], "a whole number from 1 is wanted");
    let size = ["view", "square.obj", "-o", "x.png", "--size", "800x600"];
    advised(&size, "a whole number from 16 to 16384 is wanted");
    advised(&["play", "--port", "65536"], "a whole number from 0 to 65535 is wanted");
    advised(&["info", "square.obj", "--json"], "`--format json`");
    let place = ["apply", "flip.hedge::flip", "square.obj", "--at", "edge", "1-2", "-o", "x.obj"];
    advised(&place, "`--at edge:1-2`");
}

#[test]
fn cpp_has_another_name() {
    let bench = Bench::new();
    let emitted = |kind| bench.succeeds(&["plan", "std/triangle::flip", "--as", kind]);
    assert_eq!(emitted("c++"), emitted("cpp"));
}

#[test]
fn files_that_are_not_there() {
    advised(&["run", "go.hedge", "squere.obj"], "did you mean `square.obj`?");
    advised(&["info", "square"], "did you mean `square.obj`?");
    advised(&["info", "."], "`.` is a folder");
    advised(&["check", "."], "`./*.hedge`");
    advised(&["check", "flip.hedge::flip"], "`flip.hedge`, without `flip`");
    advised(
        &["std", "flip"],
        "`flip` is declared in `std/triangle.hedge`; `hedgerow explain flip`",
    );
    advised(&["std", "--copy", "square.obj"], "`square.obj` is a file; a folder is wanted");
}

#[test]
fn words_written_otherwise() {
    let bench = Bench::new();
    for (word, meaning) in [
        ("half-edge", "one side of an edge"),
        ("Vertices", "all vertices"),
        ("level", "a `surface`, or `simple`"),
        ("outer", "outer halfedge: a halfedge that stands in no loop"),
        ("outer halfedge", "stands in no loop"),
        ("*S", "spokes of a vertex"),
        ("=>", "a run of zero or more halfedges"),
        ("valence", "degree(vertex)"),
        ("decimate", "declared in `std/simplify.hedge`"),
        ("collapse", "op collapse(e: edge, t: real = 0.5) -> v0 keeps triangles, euler\n  Merges"),
        ("collapse", "declared in `std/polygon.hedge`"),
        ("umbrella", "fn umbrella(v: vertex) -> vec3\n"),
        ("marked", "attr marked: face bool"),
    ] {
        let told = bench.succeeds(&["explain", word]);
        assert!(told.contains(meaning), "{word}: {told}");
    }
}

#[test]
fn lists_show_whole_sentences() {
    let bench = Bench::new();
    for line in bench.succeeds(&["explain"]).lines() {
        assert!(line.ends_with('.'), "{line}");
    }
    for file in bench.succeeds(&["std"]).split("\n\n") {
        assert!(file.lines().nth(1).is_some_and(|about| about.ends_with('.')), "{file}");
        assert!(file.lines().all(|line| !line.ends_with(": G.")), "{file}");
    }
}
