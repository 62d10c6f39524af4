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
fn completions_name_every_command_and_complete_files() {
    let bench = Bench::new();
    let help = bench.succeeds(&["--help"]);
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let commands = listed.map_while(|line| line.split_whitespace().next());
    let commands: Vec<_> = commands.collect();
    assert!(commands.len() > 10);
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = bench.succeeds(&["completions", shell]);
        for command in &commands {
            assert!(script.contains(command), "{command} is not completed in {shell}");
        }
    }
    let zsh = bench.succeeds(&["completions", "zsh"]);
    let ops = zsh.lines().filter(|line| line.contains("_files") && line.contains("operation"));
    assert!(ops.count() > 0);
    bench.fails(2, &["completions", "tcsh"], "bash, elvish, fish, powershell, zsh");
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
        (["plan", &flip], "write FILE::NAME with one of `flip`, `flip_any`"),
        (["draw", &flip], "one of `flip`, `flip_any`, or `--html` for one page of all"),
        (["plan", "::"], "cannot read"),
        (["plan", &part(&remesh, "remesh")], "only operations are drawn, applied and emitted"),
        (["plan", &part(&remesh, "remesh")], "remesh.hedge::remesh MESH` runs it"),
        (["plan", "std/polygn.hedge::flip"], "did you mean `std/polygon.hedge`?"),
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
fn a_value_among_the_arguments() {
    let bench = Bench::with_square();
    let remesh = example("remesh.hedge");
    let arguments = ["run", &remesh, "square.obj", "-o", "out.obj", "target=0.1"];
    bench.fails(2, &arguments, "'--set target=0.1'");
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
    bench.write("go.hedge", "script go(size: real, at: vec3, n: int) { print size }");
    let arguments = ["run", "go.hedge", "square.obj", "--set", "n=1"];
    bench.fails(2, &arguments, "`--set size=0.5`");
    bench.fails(2, &arguments, "`--set at=1,0.5,2`");
    bench.fails(1, &["run", "std/simplify", "square.obj"], "`--set faces_left=1000`");
    let both = ["run", "std/simplify", "square.obj", "--set", "faces_left=1", "--set", "ratio=0.9"];
    bench.fails(1, &both, "give `faces_left` or `ratio`, not both");
}

#[test]
fn in_json_bad_usage_is_an_error_too() {
    let bench = Bench::with_square();
    for (arguments, words) in [
        (&["info", "--format", "json", "--threads", "0", "square.obj"][..], "--threads"),
        (&["info", "--format=json"], "required arguments"),
        (&["run", "--format", "json", "x.hedge", "square.obj", "n=1"], "--set n=1"),
    ] {
        let said = bench.run(arguments);
        assert_eq!(said.code, 2, "{said:?}");
        let told: serde_json::Value = serde_json::from_str(&said.out).unwrap();
        assert!(told["error"].as_str().unwrap().contains(words), "{said:?}");
        assert!(said.err.starts_with("error: "), "{said:?}");
    }
}

/// A pillow of two triangles with one edge contracted is two faces between two vertices.
#[test]
fn of_several_edges_between_two_vertices_one_is_chosen() {
    let bench = Bench::new();
    let pillow = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\n";
    bench.write("pillow.obj", pillow);
    let op = "std/map.hedge::contract";
    let apply = |from, at, to| bench.run(&["apply", op, from, "--at", at, "-o", to]);
    let said = apply("pillow.obj", "edge:2-3", "lens.halfedges");
    assert_eq!((said.code, said.err.as_str()), (0, ""), "{said:?}");
    let op = "std/map.hedge::sprout";
    let at = |at| bench.run(&["apply", op, "lens.halfedges", "--at", at, "-o", "x.halfedges"]);
    let said = at("edge:0-1");
    assert_eq!(said.code, 0, "{said:?}");
    let words = "note: 2 edges join the vertices 0 and 1: halfedge:0-1#1 between face 0 and face 1, \
                 halfedge:0-1#2 between face 1 and face 0; the first is taken";
    assert!(said.err.contains(words), "{said:?}");
    let mut written = Vec::new();
    for place in ["edge:0-1#1", "edge:0-1#2", "halfedge:0", "halfedge:1", "halfedge:3"] {
        let said = at(place);
        if said.code == 0 {
            assert_eq!(said.err, "", "{place}");
            written.push(bench.read("x.halfedges"));
        } else {
            assert!(said.err.contains("the mesh has no halfedge"), "{said:?}");
        }
    }
    written.sort();
    written.dedup();
    assert!(written.len() > 1, "each of the two edges is chosen");
}

#[test]
fn places() {
    let bench = Bench::with_square();
    for (at, words) in [
        ("", "is not a place"),
        ("edge", "is not a place"),
        ("edge:1", "does not number its edges: write edge:A-B"),
        ("edge:1-3#0", "there is no edge:1-3#0; there is edge:1-3#1 between"),
        ("edge:1-3#2", "there is no edge:1-3#2"),
        ("edge:1-3#", "is not a place"),
        ("vertex:0", "`e` is of type edge, but the place is of type vertex"),
        ("edge:1-2-3", "is not a place"),
        ("edge:0-1", "no vertex 0; the first is 1, whatever"),
        ("edge:-1-2", "is not a place"),
        ("edge:1.5-2", "is not a place"),
        ("edge:99999999999-1", "is not a place"),
        ("corner:1", "is not a place"),
        ("e=", "is not a place"),
        ("edge:1-9", "no vertex 9"),
        ("edge:2-4", "no edge joins"),
        ("edge:1-1", "no edge joins"),
        ("vertex:1", "`e` is of type edge"),
        ("x=edge:1-3", "the elements are `e`"),
    ] {
        let arguments = ["apply", &flip(), "square.obj", "-o", "out.obj", "--at", at];
        bench.fails(2, &arguments, words);
    }
    let set = ["apply", &flip(), "square.obj", "-o", "out.obj", "--at", "edge:1-3", "--set", "e=3"];
    bench.fails(2, &set, "give --at e=PLACE");
    assert!(!bench.has("out.obj"));
}

#[test]
fn what_cannot_be_shown_is_said_before_anything_is_written() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { }");
    let both = ["run", "s.hedge", "square.obj", "-o", "-", "--picture", "-"];
    bench.fails(2, &both, "cannot both be written to `-`");
    let picture = ["--picture", "p.svg", "--attribute", "nope"];
    let wrong = [&["run", "s.hedge", "square.obj", "-o", "n.obj"][..], &picture].concat();
    bench.fails(2, &wrong, "nope");
    assert_eq!(bench.files(), ["s.hedge", "square.obj"]);
}

#[test]
fn what_was_applied_is_told_where_the_result_cannot_be_written() {
    let bench = Bench::with_square();
    let text = "use \"std/polygon.hedge\"
                op slit(e: edge) {
                  before {
                    face f: a -h-> b =P=> a
                    face g: b -k-> a =Q=> b
                    edge e: h | k
                  }
                  after {
                    new n e2 x y
                    face f: a -h-> b =P=> a
                    face g: b -k-> a =Q=> b
                    hole n: a -x-> b -y-> a
                    edge e: h | y
                    edge e2: k | x
                  }
                }
                script s() { for e in edges { slit(e) } }";
    bench.write("s.hedge", text);
    let said = bench.fails(2, &["run", "s.hedge", "square.obj", "-o", "n.obj"], "n.halfedges");
    assert!(said.err.contains("slit        1        4"), "{said:?}");
}

#[cfg(unix)]
#[test]
fn links_that_lead_nowhere_or_to_a_device() {
    use std::os::unix::fs::symlink;
    let bench = Bench::with_square();
    for name in ["gone.obj", "gone.hedge"] {
        symlink("nowhere", bench.path(name)).unwrap();
    }
    let words = "there is no such file; it is a link to `nowhere`";
    bench.fails(2, &["info", "gone.obj"], words);
    bench.fails(2, &["check", "gone.hedge"], words);
    for name in ["zero.obj", "zero.ply", "zero.halfedges"] {
        symlink("/dev/zero", bench.path(name)).unwrap();
        bench.fails(2, &["info", name], "it is a device");
    }
}

#[test]
fn a_table_is_of_one_operation() {
    let bench = Bench::with_square();
    bench.write("two.hedge", "op one(e: edge) { }\nop two(e: edge) { }\n");
    bench.fails(2, &["plan", "two.hedge"], "which operation?");
    let help = bench.succeeds(&["plan", "--help"]);
    assert!(help.contains("without one, as data or code"), "{help}");
    bench.fails(2, &["info", "own.HEDGE"], "`own.HEDGE` is a program; a mesh is wanted here");
}
