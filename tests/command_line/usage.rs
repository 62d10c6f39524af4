//! Commands that ask for what is not there.

use crate::bench::{Bench, example, flip};

#[test]
fn no_such_command() {
    let bench = Bench::new();
    for arguments in [
        &[][..],
        &["dance"],
        &["check"],
        &["info"],
        &["info", "a.obj", "b.obj"],
        &["check", "a.hedge", "--format", "xml"],
        &["run", "a.hedge"],
        &["apply", "a.hedge", "a.obj", "-o", "b.obj"],
    ] {
        bench.fails(2, arguments, "--help");
    }
    assert!(bench.succeeds(&["--help"]).contains("Exit codes"));
    assert!(bench.succeeds(&["--version"]).starts_with("hedgerow "));
}

#[test]
fn no_such_operation_or_script() {
    let bench = Bench::with_square();
    let flip = example("flip.hedge");
    let remesh = example("remesh.hedge");
    let part = |file: &str, name: &str| format!("{file}::{name}");
    for (arguments, words) in [
        (["plan", &part(&flip, "flop")], "did you mean `flip`?"),
        (["plan", &part(&flip, "knot")], "it has `flip`, `flip_any`"),
        (
            ["plan", &flip],
            "write FILE::NAME with one of `flip`, `flip_any`",
        ),
        (["plan", "::"], "cannot read"),
        (["plan", &part(&flip, "")], "no operation ``"),
    ] {
        bench.fails(2, &arguments, words);
    }
    let run = |script: &str, words: &str| {
        bench.fails(2, &["run", script, "square.obj", "-o", "out.obj"], words);
    };
    run(&flip, "the file has no script");
    run(&part(&remesh, "simplify"), "it has `remesh`");
    assert!(!bench.has("out.obj"));
}

#[test]
fn settings() {
    let bench = Bench::with_square();
    let remesh = example("remesh.hedge");
    for (set, words) in [
        ("iterations", "write NAME=VALUE"),
        ("=3", "no parameter"),
        ("rounds=3", "it has `target`, `iterations`"),
        ("iterations=", "wants a whole number"),
        ("iterations=1.5", "wants a whole number"),
        ("iterations=99999999999999999999", "wants a whole number"),
        ("target=wide", "wants a number"),
        ("target=nan", "wants a number"),
        ("target=inf", "wants a number"),
        ("target=1,2,3", "wants a number"),
    ] {
        let arguments = ["run", &remesh, "square.obj", "-o", "out.obj", "--set", set];
        bench.fails(2, &arguments, words);
    }
    let twice = ["--set", "iterations=1", "--set", "iterations=2"];
    let arguments = ["run", &remesh, "square.obj", "-o", "out.obj"];
    bench.fails(2, &[&arguments[..], &twice].concat(), "iterations");
    assert!(!bench.has("out.obj"));
}

#[test]
fn places() {
    let bench = Bench::with_square();
    for (at, words) in [
        ("", "is no place"),
        ("edge", "is no place"),
        ("edge:1", "is no place"),
        ("edge:1-2-3", "is no place"),
        ("edge:0-1", "no vertex 0"),
        ("edge:-1-2", "is no place"),
        ("edge:1.5-2", "is no place"),
        ("edge:99999999999-1", "is no place"),
        ("corner:1", "is no place"),
        ("e=", "is no place"),
        ("edge:1-9", "no vertex 9"),
        ("edge:2-4", "no edge joins"),
        ("edge:1-1", "no edge joins"),
        ("vertex:1", "`e` is of type edge"),
        ("x=edge:1-3", "it has `e`"),
    ] {
        let arguments = ["apply", &flip(), "square.obj", "-o", "out.obj", "--at", at];
        bench.fails(2, &arguments, words);
    }
    let set = [
        "apply",
        &flip(),
        "square.obj",
        "-o",
        "out.obj",
        "--at",
        "edge:1-3",
        "--set",
        "e=3",
    ];
    bench.fails(2, &set, "give --at e=PLACE");
    assert!(!bench.has("out.obj"));
}
