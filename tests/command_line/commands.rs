//! Every command, for people and for programs.

use crate::bench::{Bench, TETRAHEDRON, example, flip};

#[test]
fn check_tells_what_was_proved() {
    let bench = Bench::new();
    let told = bench.succeeds(&["check", &example("flip.hedge"), &example("split.hedge")]);
    assert!(
        told.contains("proved  flip      1 case  V ±0  E ±0  F ±0  grows with the degree of `v2`"),
        "{told}"
    );
    assert!(
        told.contains("proved  split interior  1 case  V +1  E +3  F +2  constant time"),
        "{told}"
    );
    let told = bench.json(&["check", &example("split.hedge")]);
    assert_eq!(told["proved"], true);
    let rule = &told["files"][0]["ops"][0]["rules"][1];
    assert_eq!((&rule["holes"], &rule["loops"]), (&0.into(), &0.into()));
    assert_eq!(rule["rule"], "border");
    assert_eq!(rule["edges"], 2);
    assert_eq!(rule["constant_time"], true);
}

#[test]
fn steps_that_call_nothing() {
    let bench = Bench::new();
    bench.write("a.hedge", "op lift(v: vertex) {\n  steps { v.position = vec3(0, 0, 1) }\n}\n");
    let told = bench.succeeds(&["check", "a.hedge"]);
    assert!(told.ends_with("proved  lift  in steps\n"), "{told}");
    let told = bench.succeeds(&["plan", "a.hedge"]);
    assert_eq!(told, "lift is done in steps, and calls no operation\n");
}

/// The flip of the first page, without its guard.
const BARE_FLIP: &str = "op flip(e: edge) {\n  before {\n    \
    face f0: v0 -a-> v1 -b-> v2 -c-> v0\n    face f1: v1 -d-> v0 -g-> v3 -h-> v1\n    \
    edge e: a | d\n  }\n  after {\n    face f0: v3 -a-> v2 -c-> v0 -g-> v3\n    \
    face f1: v2 -d-> v3 -h-> v1 -b-> v2\n    edge e: a | d\n  }\n}\n";

#[test]
fn check_tells_what_is_not_kept() {
    let bench = Bench::new();
    bench.write("flip.hedge", BARE_FLIP);
    let told = bench.succeeds(&["check", "flip.hedge"]);
    let line =
        "\n      the mesh stays a surface, but perhaps not simple; `guard simple` would add ";
    assert!(told.contains(line), "{told}");
    let json = bench.json(&["check", "flip.hedge"]);
    let only = &json["files"][0]["ops"][0]["rules"][0]["keeps_only"];
    assert_eq!(only["level"], "surface");
    let count = only["untested"].as_u64().unwrap();
    assert!(told.contains(&format!("{line}{count} test\n")), "{told}");
    // As many tests as the guard makes.
    bench.write("flip.hedge", BARE_FLIP.replace("  after {", "  guard simple\n  after {"));
    let told = bench.succeeds(&["check", "-v", "flip.hedge"]);
    assert_eq!(told.matches("tested: ").count() as u64, count, "{told}");
    assert!(!told.contains("keeps a "), "{told}");
}

#[test]
fn holes_are_counted_apart_and_what_turns_is_told() {
    let bench = Bench::new();
    bench.write(
        "holes.hedge",
        "op close(f: face) {\n  before { hole f: v0 -a-> v1 =P=> v0 }\n  \
         after { face f: v0 -a-> v1 =P=> v0 }\n}\n\
         op grow(f: face) {\n  before { loop f: each i { v[i] -h[i]-> } }\n  after {\n    \
         new w a[i] b[i] e[i] g[i]\n    hole g[i]: v[i] -h[i]-> v[i+1] -a[i]-> w -b[i]-> v[i]\n    \
         edge e[i]: a[i] | b[i+1]\n    erase f\n    w.position = centroid(f)\n  }\n}\n",
    );
    let told = bench.succeeds(&["check", "holes.hedge"]);
    assert!(told.contains("V ±0  E ±0  F +1  holes -1"), "{told}");
    assert!(told.contains("\n      note: the hole `f` becomes a face\n"), "{told}");
    assert!(told.contains("V +1  E +n  F ±0  holes +n  loops -1"), "{told}");
    let json = bench.json(&["check", "holes.hedge"]);
    let rule = &json["files"][0]["ops"][0]["rules"][0];
    assert_eq!((&rule["faces"], &rule["holes"]), (&1.into(), &(-1).into()));
    assert_eq!(rule["turned"][0], "the hole `f` becomes a face");
    let rule = &json["files"][0]["ops"][1]["rules"][0];
    assert_eq!(rule["per_index"]["holes"], 1);
}

#[test]
fn explain_tells_of_codes_words_and_functions() {
    let bench = Bench::new();
    let told = bench.succeeds(&["explain", "functions"]);
    assert!(told.contains("degree(vertex), …"), "{told}");
    assert!(told.lines().count() > 50, "{told}");
    let told = bench.succeeds(&["explain", "properties"]);
    assert!(told.contains("\nboundary ") && told.contains("\nmap "), "{told}");
    let told = bench.succeeds(&["explain", "degree"]);
    assert!(told.contains("degree(face) -> int"), "{told}");
    let told = bench.succeeds(&["explain", "missing-reassignment"]);
    assert!(told.starts_with("missing-reassignment"), "{told}");
    let told = bench.succeeds(&["explain", "error[stale-vertex]: a spoke of `v1`"]);
    assert!(told.starts_with("stale-vertex"), "{told}");
    let told = bench.succeeds(&["explain", "smooth"]);
    assert!(told.contains("std/smooth.hedge\n\nSmoothing: "), "{told}");
    assert!(told.contains("  script  laplacian"), "{told}");
    bench.fails(2, &["explain", "nothing"], "explain functions");
    for (word, meant) in [
        ("Catmull-Clark", "catmull_clark"),
        ("link condition", "link_condition"),
        ("border", "boundary"),
        ("witness", "counterexample"),
        ("poke", "inset_vertex"),
        ("star", "star"),
    ] {
        let told = bench.succeeds(&["explain", word]);
        assert!(told.starts_with(&format!("{meant}\n\n")), "{word}: {told}");
    }
}

#[test]
fn a_test_tells_how_meshes_differ() {
    let bench = Bench::new();
    bench.write("differ.hedge", "test \"a\" { mesh = cube()  assert mesh == octahedron() }");
    let said = bench.run(&["test", "differ.hedge"]);
    assert_eq!(said.code, 1);
    let counts = "the mesh has 8 vertices, the other 6; the mesh has 6 faces, the other 8";
    assert!(said.out.contains(counts) || said.err.contains(counts), "{}", said.err);
}

#[test]
fn check_tells_what_is_wrong() {
    let bench = Bench::new();
    let flip = std::fs::read_to_string(example("flip.hedge")).unwrap();
    let broken = flip.replacen("    edge e: a | d\n  }\n}", "  }\n}", 1);
    assert_ne!(flip, broken);
    bench.write("broken.hedge", broken);
    let said = bench.fails(1, &["check", "broken.hedge"], "error[missing-reassignment]");
    assert!(said.err.contains("insert `edge e: a | d`"), "{}", said.err);
    assert!(said.out.contains("not proved  flip\n"), "{}", said.out);
    assert!(said.out.contains("proved      flip_any"), "{}", said.out);

    let said = bench.run(&["check", "broken.hedge", "--format", "json"]);
    assert_eq!((said.code, said.err.as_str()), (1, ""));
    let told: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(told["proved"], false);
    let error = &told["files"][0]["diagnostics"][0];
    assert_eq!(error["code"], "missing-reassignment");
    assert_eq!(error["labels"][0]["line"], 20);
    assert_eq!(error["labels"][0]["file"], "broken.hedge");
    assert_eq!(error["fixes"][0]["edits"][0]["file"], "broken.hedge");
    assert_eq!(error["fixes"][0]["edits"][0]["text"], "\n    edge e: a | d");
}

#[test]
fn run_writes_a_mesh_and_a_table() {
    let bench = Bench::new();
    let arguments = [
        "run",
        &example("remesh.hedge"),
        &example("meshes/bunny.obj"),
        "-o",
        "out.obj",
        "--set",
        "iterations=1",
    ];
    let told = bench.succeeds(&arguments);
    for words in ["op        applied  refused", "holes", "seconds: load "] {
        assert!(told.contains(words), "{told}");
    }
    let summary = bench.json(&["info", "out.obj"]);
    assert_eq!(summary["measures"]["genus"], 0, "{summary}");
    assert_eq!(summary["level"], "simple", "{summary}");

    // As data, what the script prints goes the other way.
    let said = bench.run(&[&arguments[..], &["--format", "json"]].concat());
    assert_eq!(said.code, 0);
    assert!(said.err.contains("aiming at edges"), "{}", said.err);
    let told: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(told["script"], "remesh");
    assert_eq!(told["before"]["vertices"], 1839);
    assert_eq!(told["ops"][0]["op"], "split");
}

#[test]
fn a_failure_is_data_where_data_is_wanted() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { print 1 div (count(vertices) - 4) }");
    let error = |code, arguments: &[&str]| -> serde_json::Value {
        let said = bench.run(&[arguments, &["--format", "json"]].concat());
        assert_eq!(said.code, code, "{said:?}");
        serde_json::from_str(&said.out).expect("JSON")
    };
    let told = error(1, &["run", "s.hedge", "square.obj"]);
    assert_eq!(told["error"], "division by zero");
    assert_eq!(told["diagnostics"][0]["labels"][0]["line"], 1);
    for command in [&["run", "s.hedge", "no.obj"][..], &["info", "no.obj"]] {
        let told = error(2, command);
        assert_eq!(told["error"], "cannot read `no.obj`: there is no such file", "{told}");
    }
    for command in ["check", "test"] {
        let told = error(2, &[command, "no.hedge", "s.hedge"]);
        let error = told["files"][0]["error"].as_str().expect("a reason");
        assert!(error.contains("cannot read `no.hedge`"), "{told}");
        assert_eq!(told["files"][1]["file"], "s.hedge");
    }
}

#[test]
fn a_shape_stands_in_place_of_a_mesh() {
    let bench = Bench::new();
    bench.succeeds(&["convert", "torus(12, 8)", "t.obj"]);
    bench.succeeds(&["convert", "torus(12, 8)", "-o", "u.obj"]);
    assert_eq!(bench.read("t.obj"), bench.read("u.obj"));
    let summary = bench.json(&["info", "t.obj"]);
    assert_eq!((&summary["faces"], &summary["measures"]["genus"]), (&96.into(), &1.into()));
    bench.fails(2, &["info", "torus(2, 8)"], "`torus` wants a number from 3");
    bench.fails(2, &["info", "tours(12, 8)"], "nothing makes a mesh under the name `tours`");
    bench.fails(2, &["info", "grid(-1, 2)"], "`grid` wants a number from 1");
    bench.fails(2, &["info", "sphere(2)"], "`icosphere`");
    bench.fails(2, &["info", "cube"], "`cube(…)`");
    bench.fails(2, &["convert", "t.obj"], "<OUTPUT>");
    // An element as scripts print it.
    bench.write("p.hedge", "script p() { for e in edges where not boundary(e) { print e break } }");
    let printed = bench.run(&["run", "p.hedge", "icosphere(1)"]);
    let element = printed.out.lines().next().expect("a line");
    let apply = ["apply", "std/triangle.hedge::flip", "icosphere(1)", "-o", "f.obj", "--at"];
    bench.succeeds(&[&apply[..], &[element]].concat());
    bench.fails(2, &[&apply[..], &["edge 1000"]].concat(), "the mesh has no edge 1000");
    bench.fails(2, &[&apply[..], &["edge:10"]].concat(), "'edge N' as scripts print it");
    // Elements have the numbers that they would have in a file.
    bench.succeeds(&["convert", "icosphere(1)", "i.obj"]);
    for place in ["edge:2-13", "edge:13-2"] {
        bench.succeeds(&[&apply[..], &[place]].concat());
        let of_file = ["apply", "std/triangle.hedge::flip", "i.obj", "-o", "g.obj", "--at", place];
        bench.succeeds(&of_file);
        assert_eq!(bench.read("f.obj"), bench.read("g.obj"));
    }
}

/// Nor is it asked of what depends on it: a function, an attribute, an operation, another script.
#[test]
fn nothing_that_is_written_wrongly_is_run() {
    let bench = Bench::with_square();
    bench.write(
        "s.hedge",
        "attr x: vertex real = true
attr y: vertex real = 7 % 2
fn bad() -> real { 7 % 2 }
op moved(v: vertex) { steps { var x = 1 x += 1 v.position = vec3(x) } }
script a() { var x = 1 x += 1 print x }
script b() { print 0x10 }
script c() { print 99999999999999999999999 }
script d() { for v in vertices { v.x = 1 } }
script e() { for v in vertices { v.y = 1 } }
script f() { print bad() }
script g() { a() }
script h() { for v in vertices { moved(v) } }
script i() { if count(edges) > 3 { print 1 } elif count(edges) > 1 { print 2 } }
test \"t\" { mesh = cube() assert 7 % 2 == 1 }
test \"u\" { mesh = cube() assert bad() == 1 }
script sound() { print 5 }
",
    );
    bench.write("u.hedge", "use \"s.hedge\" script u() { print bad() }");
    for script in ["a", "b", "c", "d", "e", "f", "g", "h", "i"] {
        let script = format!("s.hedge::{script}");
        bench.fails(1, &["run", &script, "square.obj", "-o", "o.obj"], "error");
    }
    bench.fails(1, &["run", "u.hedge", "square.obj", "-o", "o.obj"], "error");
    bench.fails(1, &["run", "u.hedge::u", "square.obj", "-o", "o.obj"], "error");
    let apply = ["apply", "s.hedge::moved", "square.obj", "--at", "vertex:1", "-o", "o.obj"];
    bench.fails(1, &apply, "error");
    let tested = bench.run(&["test", "s.hedge"]);
    assert!(tested.out.ends_with("0 passed, 1 failed, 1 not run\n"), "{}", tested.out);
    assert_eq!(bench.files(), ["s.hedge", "square.obj", "u.hedge"]);
    // Characters that belong to nothing, many of them, and beside other errors of the lexer.
    let mut many: String =
        (0..30).map(|n| format!("script s{n}() {{ print {n} - $ 3 }}\n")).collect();
    many += "op o(e: edge) { before { edge e: a $ | d } after { edge e: a | d } }\n";
    many += "script last() { print \"no end\n}\n";
    bench.write("many.hedge", &many);
    for script in ["s0", "s15", "s16", "s17", "s29", "last"] {
        let script = format!("many.hedge::{script}");
        bench.fails(1, &["run", &script, "square.obj", "-o", "o.obj"], "error");
    }
    let apply = ["apply", "many.hedge::o", "square.obj", "--at", "edge:1-2", "-o", "o.obj"];
    bench.fails(1, &apply, "error");
    std::fs::remove_file(bench.path("many.hedge")).unwrap();
    // The way out names a script that runs.
    bench.fails(1, &["run", "s.hedge", "square.obj"], "`hedgerow run s.hedge::sound`");
    let sound = bench.run(&["run", "s.hedge::sound", "square.obj"]);
    assert!(sound.code == 0 && sound.out.starts_with("5\n"), "{sound:?}");
}

#[test]
fn a_script_that_fails_points_at_the_place_and_writes_nothing() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { print 1 div (count(vertices) - 4) }");
    bench.fails(1, &["run", "s.hedge", "square.obj", "-o", "out.obj"], "s.hedge:1:20");
    assert_eq!(bench.files(), ["s.hedge", "square.obj"]);
}

#[test]
fn apply_does_one_thing_at_one_place() {
    let bench = Bench::with_square();
    let at = ["--at", "edge:1-3", "-o", "out.obj"];
    let told = bench.succeeds(&[&["apply", &flip(), "square.obj"], &at[..]].concat());
    assert_eq!(told, "applied flip\nnow      4 vertices, 5 edges, 2 faces\n");
    assert!(bench.read("out.obj").contains("f 4 2 3\n"), "{}", bench.read("out.obj"));

    let split = example("split.hedge");
    let told = bench.json(&[&["apply", &split, "square.obj"], &at[..]].concat());
    assert_eq!(told["applied"], true);
    assert_eq!(told["result"], "vertex:5");
    assert_eq!(told["after"]["faces"], 4);
    let created = told["created"].as_array().unwrap();
    assert!(created.contains(&"face:3".into()), "{told}");
}

#[test]
fn apply_without_an_output_tries() {
    let bench = Bench::with_square();
    let told = bench.run(&["apply", &flip(), "square.obj", "--at", "edge:1-3"]);
    assert!(told.code == 0 && told.out.contains("applied flip"), "{told:?}");
    assert!(told.err.contains("the result is not kept; `-o FILE` writes it"), "{told:?}");
    let report = bench.json(&["apply", &flip(), "square.obj", "--at", "edge:1-3"]);
    assert_eq!(report["applied"], true);
    let told = bench.run(&["apply", &flip(), "square.obj", "--at", "edge:1-2"]);
    assert_eq!(told.code, 3, "{told:?}");
}

#[test]
fn a_refusal_has_a_code_a_reason_and_no_output() {
    let bench = Bench::new();
    bench.write("t.obj", TETRAHEDRON);
    let arguments = ["apply", &flip(), "t.obj", "--at", "edge:1-2", "-o", "out.obj"];
    let said = bench.fails(3, &arguments, "refused: the edge v2 v3 is already there\n");
    assert_eq!(said.out, "");
    let said = bench.fails(3, &[&arguments[..], &["--format", "json"]].concat(), "refused: ");
    let told: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(told["applied"], false);
    assert_eq!(told["refused"], "the edge v2 v3 is already there");
    assert_eq!(told["before"], told["after"]);
    assert_eq!(bench.files(), ["t.obj"]);
}

#[test]
fn an_edge_is_taken_the_way_it_is_written() {
    let bench = Bench::with_square();
    bench.write(
        "from.hedge",
        "op pull(e: edge) -> v0 {
           before { loop f: v0 -a-> v1 =P=> v0  edge e: a | d }
           after { keep f e  v0.position = v1.position }
         }",
    );
    for (at, moved) in
        [("edge:1-3", "v 1 1 0\nv 1 0 0\n"), ("edge:3-1", "v 0 0 0\nv 1 0 0\nv 0 0 0\n")]
    {
        bench.succeeds(&["apply", "from.hedge", "square.obj", "--at", at, "-o", "out.obj"]);
        let out = bench.read("out.obj");
        assert!(out.starts_with(moved), "{at}: {out}");
    }
}

#[test]
fn several_elements_are_given_by_name_or_in_order() {
    let bench = Bench::new();
    bench.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    let connect = example("connect.hedge");
    let with = |places: &[&str]| {
        let places = places.iter().flat_map(|place| ["--at", place]);
        let arguments = ["apply", &connect, "quad.obj", "-o", "out.obj"];
        bench.run(&arguments.into_iter().chain(places).collect::<Vec<_>>())
    };
    for places in [
        ["a=halfedge:1-2", "b=halfedge:3-4"],
        ["halfedge:1-2", "halfedge:3-4"],
        ["b=halfedge:3-4", "edge:1-2"],
    ] {
        let said = with(&places);
        assert_eq!((said.code, said.err.as_str()), (0, ""));
        assert!(said.out.contains("edge:"), "{}", said.out);
    }
    for (places, words) in [
        (&["halfedge:1-2"][..], "`b` is missing"),
        (&["halfedge:1-2", "halfedge:3-4", "face:1"], "too many"),
        (&["a=halfedge:1-2"], "`b` is missing"),
        (&["a=halfedge:1-2", "a=halfedge:3-4"], "`a` is given twice"),
        (&["a=halfedge:1-2", "b=vertex:3"], "`b` is of type halfedge"),
    ] {
        let said = with(places);
        assert_eq!(said.code, 2, "{said:?}");
        assert!(said.err.contains(words), "{said:?}");
    }
}

#[test]
fn plan_prints_four_phases() {
    let bench = Bench::new();
    let told = bench.succeeds(&["plan", &flip()]);
    let phases = ["1. collect", "2. allocate", "3. reassign", "4. erase"];
    let places: Vec<_> = phases.iter().map(|phase| told.find(phase)).collect();
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{told}");
    assert!(told.contains("\n   a.next       = c\n"), "{told}");
    assert!(told.contains("\n · a.face       = f0\n"), "{told}");
    let widest = told.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(80), "{told}");
}

#[test]
fn run_says_that_it_replaced_what_it_read() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { }\n");
    let told = bench.run(&["run", "s.hedge", "square.obj", "-o", "./square.obj"]);
    assert_eq!((told.code, &*told.err), (0, "`square.obj` is replaced by the result\n"));
    let told = bench.run(&["run", "s.hedge", "square.obj", "-o", "other.obj"]);
    assert_eq!((told.code, &*told.err), (0, ""));
}

#[test]
fn info_writes_extreme_sizes_with_exponents() {
    let bench = Bench::new();
    for (size, told) in [
        (
            "1e308",
            "(0.000000e0, 0.000000e0, 0.000000e0) to (1.000000e308, 1.000000e308, 0.000000e0)",
        ),
        ("1e-9", "(0.000000e0, 0.000000e0, 0.000000e0) to (1.000000e-9, 1.000000e-9, 0.000000e0)"),
    ] {
        bench.write("m.obj", format!("v 0 0 0\nv {size} 0 0\nv 0 {size} 0\nf 1 2 3\n"));
        let info = bench.succeeds(&["info", "m.obj"]);
        assert!(info.contains(told), "{info}");
    }
}

#[test]
fn info_describes_a_mesh() {
    let bench = Bench::with_square();
    let told = bench.succeeds(&["info", "square.obj"]);
    for words in
        ["vertices              4\n", "valid, of level simple", "holes                 1\n"]
    {
        assert!(told.contains(words), "{told}");
    }
    let told = bench.json(&["info", "square.obj"]);
    assert_eq!(told["vertices"], 4);
    assert_eq!(told["holes"], 1);
    let told = bench.succeeds(&["info", &example("meshes/bunny.obj")]);
    for words in [
        "  volume                194.288372\n",
        "  bounding box          (-4.958475, -0.003149, -3.729833) to (4.948850, 9.654748, 3.810639)\n",
    ] {
        assert!(told.contains(words), "{told}");
    }
}

#[test]
fn every_line_of_help_fits_a_terminal() {
    let bench = Bench::new();
    for command in [
        "",
        "check",
        "run",
        "apply",
        "plan",
        "draw",
        "view",
        "explain",
        "info",
        "test",
        "play",
        "learn",
        "std",
        "lsp",
        "fmt",
        "convert",
        "completions",
    ] {
        let arguments = [command, "--help"];
        let arguments = arguments.into_iter().filter(|word| !word.is_empty());
        let told = bench.succeeds(&arguments.collect::<Vec<_>>());
        for line in told.lines() {
            assert!(line.chars().count() <= 80, "{command}: {line}");
        }
    }
}

#[test]
fn a_script_may_only_print() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { print \"{count(vertices)} vertices\" }\n");
    let files = bench.files();
    let said = bench.run(&["run", "s.hedge", "square.obj"]);
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.out.starts_with("4 vertices\n"), "{}", said.out);
    assert!(said.err.contains("`-o FILE` writes it"), "{}", said.err);
    assert_eq!(bench.files(), files);
}

#[test]
fn a_mesh_is_written_as_what_its_name_says() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { }\n");
    for name in ["out.gltf", "out.halfedge", "out.png"] {
        let arguments = ["run", "s.hedge", "square.obj", "-o", name];
        bench.fails(2, &arguments, "name it .obj, .ply, .stl, .off, .msh or .halfedges");
        assert!(!bench.has(name));
    }
    for name in ["out.OBJ", "out.halfedges", "out", "out.ply", "out.off", "out.msh"] {
        bench.succeeds(&["run", "s.hedge", "square.obj", "-o", name]);
        assert!(bench.has(name));
    }
}

#[test]
fn what_no_obj_file_can_hold_stays_unwritten() {
    let bench = Bench::new();
    // Two tetrahedra on one triangle: to collapse an edge of it makes three faces share one.
    let solid = "v 0 0 0\nv 2 0 0\nv 1 2 0\nv 1 1 1\nv 1 1 -1\n\
        f 1 2 4\nf 2 3 4\nf 3 1 4\nf 2 1 5\nf 3 2 5\nf 1 3 5\n";
    bench.write("solid.obj", solid);
    let collapse = ["apply", "std/polygon.hedge::collapse", "solid.obj", "--at", "edge:1-2", "-o"];
    let into = |file| [&collapse[..], &[file]].concat();
    let said = bench.fails(2, &into("solid.obj"), "no list of polygons holds this mesh");
    assert!(said.err.contains("solid.halfedges"), "{}", said.err);
    let why = "; `collapse` may do that, and `guard simple` in it refuses where it would; write it";
    assert!(said.err.contains(why), "{}", said.err);
    bench.write(
        "s.hedge",
        "use \"std/polygon.hedge\"\nscript s() {\n  \
        for e in edges where all(degree(v) == 3 or degree(v) == 4 for v in e.vertices) {\n    \
        collapse(e) break\n  }\n}\n",
    );
    let run = ["run", "s.hedge", "solid.obj", "-o", "solid.obj"];
    let said = bench.run(&run);
    assert!(said.code == 0 || said.err.contains(why), "{said:?}");
    assert_eq!(bench.read("solid.obj"), solid);
    bench.succeeds(&into("solid.halfedges"));
    bench.succeeds(&["info", "solid.halfedges"]);
}

#[test]
fn steps_may_call_what_is_for_a_higher_level() {
    let bench = Bench::with_square();
    bench.write(
        "two.hedge",
        "use \"std/polygon.hedge\"\n\
         op two(f: face) -> vertex { steps { let v = must inset_vertex(f) return v } }\n\
         op three(f: face) -> vertex { steps { let v = must two(f) return v } }\n\
         script s() { for f in faces { must three(f) break } }\n",
    );
    bench.succeeds(&["run", "two.hedge::s", "square.obj", "-o", "o.obj"]);
    bench.succeeds(&["apply", "two.hedge::three", "square.obj", "--at", "face:1", "-o", "o.obj"]);
}

#[test]
fn an_operation_is_not_run_and_a_script_not_applied() {
    let bench = Bench::with_square();
    bench.fails(2, &["run", &flip(), "square.obj"], "hedgerow apply");
    bench.write("s.hedge", "script s() { }\n");
    let arguments = ["apply", "s.hedge::s", "square.obj", "--at", "edge:1-2", "-o", "x.obj"];
    bench.fails(2, &arguments, "hedgerow run");
}

#[test]
fn tests_that_cannot_be_read_are_told() {
    let bench = Bench::new();
    let tests = "test \"one\" { assert 1 == 1 }\ntest \"two\" { assert 1 = 1 }\n";
    bench.write("t.hedge", tests);
    let said = bench.run(&["test", "t.hedge"]);
    assert_eq!(said.code, 1, "{}", said.out);
    assert!(said.out.contains("  broken  two\n"), "{}", said.out);
    assert!(said.out.ends_with("1 passed, 0 failed, 1 not run\n"), "{}", said.out);
}

#[test]
fn the_help_of_a_script() {
    let bench = Bench::new();
    let script = "/// Does nothing at all,\n/// twice.\n\
        script s(n: int, at: vec3 = vec3(0, 0, 1), m: int = 2 * n) { print n, at, m }\n\
        script t() { print 1 }\n";
    bench.write("s.hedge", script);
    let told = "Does nothing at all,\ntwice.\n\n\
        Usage: hedgerow run s.hedge::s MESH [-o FILE] [--set NAME=VALUE]...\n\n\
        Parameters:\n  \
        n   int   has to be given\n  \
        at  vec3  if not given: vec3(0, 0, 1)\n  \
        m   int   if not given: 2 * n\n\n\
        Other options: hedgerow run --help\n";
    assert_eq!(bench.succeeds(&["run", "s.hedge::s", "--help"]), told);
    let both = bench.succeeds(&["run", "s.hedge", "-h"]);
    assert!(both.starts_with(told.trim_end()) && both.contains("It has no parameters."));
    bench.fails(2, &["run", "s.hedge::u", "--help"], "no script `u`");
    let own = bench.succeeds(&["run", "--help"]);
    assert!(own.contains("Usage: ") && own.contains("--picture"), "{own}");
}

#[test]
fn a_drawing_that_is_not_proved_is_told() {
    let bench = Bench::new();
    bench.write(
        "stale.hedge",
        "op cut(f: face) {\n  before { face f: v -h-> w =P=> v }\n  after { erase f }\n}\n",
    );
    let said = bench.run(&["draw", "stale.hedge", "-o", "x.svg"]);
    assert_eq!(said.code, 0, "{said:?}");
    assert!(
        said.err.contains("warning: `cut` is not proved; `hedgerow check stale.hedge` tells"),
        "{said:?}"
    );
    // The picture tells, too, also where it is seen without the warning.
    let marked = bench.run(&["draw", "stale.hedge", "--as", "text"]).out;
    assert!(marked.contains("not proved: "), "{marked}");
    bench.write("flip.hedge", BARE_FLIP);
    assert_eq!(bench.run(&["draw", "flip.hedge", "-o", "x.svg"]).err, "");
    assert!(!bench.succeeds(&["draw", "flip.hedge", "--as", "text"]).contains("proved"));
}

#[test]
fn what_is_wrong_in_other_ops_is_not_told() {
    let bench = Bench::new();
    let op = |name: &str, end: &str| {
        format!(
            "op {name}(f: face) {{ before {{ face f: v -h-> {end} =P=> v }} after {{ keep q_{name} }} }}\n"
        )
    };
    bench.write("two.hedge", op("first", "w") + &op("second", "u"));
    let said = bench.run(&["draw", "two.hedge::second", "-o", "x.svg"]);
    assert_eq!(said.code, 1, "{said:?}");
    assert!(said.err.contains("q_second") && !said.err.contains("q_first"), "{said:?}");
}

#[test]
fn a_view_without_anything_to_see_is_told() {
    let bench = Bench::new();
    bench.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    let said = bench.run(&["view", "flat.obj", "-o", "x.png"]);
    assert_eq!(said.code, 0, "{said:?}");
    assert!(said.err.contains("nothing is seen: no face has an area"), "{said:?}");
    assert_eq!(bench.run(&["view", "cube()", "-o", "x.png"]).err, "");
}
