//! `plan` as code and as data; what `draw` and `view` write.

use std::path::Path;
use std::process::Command;

use crate::bench::{Bench, example, flip};

#[test]
fn a_plan_as_data() {
    let bench = Bench::new();
    let said = bench.succeeds(&["plan", &flip(), "--as", "json"]);
    let told: serde_json::Value = serde_json::from_str(&said).unwrap();
    let plan = &told["plans"][0];
    assert_eq!((&plan["op"], &plan["params"][0]["type"]), (&"flip".into(), &"edge".into()));
    let rows = plan["rules"][0]["reassign"].as_array().unwrap();
    let sets = |row: &&serde_json::Value| row["kind"] == "set" && row["executed"] == true;
    assert!(rows.iter().filter(sets).count() > 10, "{said}");
    assert_eq!(plan["refusals"][0]["phase"], "match");
}

#[test]
fn a_plan_as_code() {
    let bench = Bench::new();
    let cpp = bench.succeeds(&["plan", &flip(), "--as", "cpp"]);
    assert!(cpp.contains("    a->next = c;\n    a->vertex = v3;\n"), "{cpp}");
    let style = ["--style", "accessors", "--style", "member=yes"];
    let cpp = bench.succeeds(&[&["plan", &flip(), "--as", "cpp"], &style[..]].concat());
    assert!(cpp.contains("bool Halfedge_Mesh::flip(EdgeRef e) {"), "{cpp}");
    assert!(cpp.contains("a->next() = c;"), "{cpp}");
    // Without an operation, all of the file.
    let said = bench.run(&["plan", &example("remesh.hedge"), "--as", "rust", "-o", "remesh.rs"]);
    assert_eq!(said.err, "left out: `remesh`, since only operations are emitted\n");
    let rust = std::fs::read_to_string(bench.path("remesh.rs")).unwrap();
    for op in ["split", "collapse", "flip"] {
        assert!(rust.contains(&format!("pub fn {op}(mesh: &mut Mesh, e: EdgeId")), "{rust}");
    }
}

/// Nothing is left out without a word because it could not be read.
#[test]
fn of_a_broken_file_nothing_is_emitted() {
    let bench = Bench::new();
    let op = |name: &str| {
        format!(
            "op {name}(e: edge) {{\n  before {{ face f: v -a-> w =P=> v  edge e: a | d }}\n  \
             after {{ keep f e }}\n}}\n"
        )
    };
    bench.write("two.hedge", op("9f") + &op("g"));
    bench.write("gone.hedge", format!("use \"nope.hedge\"\n{}", op("g")));
    bench.write("none.hedge", op("new"));
    for (file, code, words) in [
        ("two.hedge", 1, "malformed-number"),
        ("gone.hedge", 1, "missing-file"),
        ("none.hedge", 2, "the file has no operation"),
        ("none.hedge", 2, "syntax-error"),
    ] {
        for language in ["cpp", "rust", "json"] {
            bench.fails(code, &["plan", file, "--as", language, "-o", "out"], words);
            assert!(!bench.has("out"));
        }
    }
    bench.fails(2, &["draw", "none.hedge"], "syntax-error");
    // What is asked for by its name is whole.
    bench.succeeds(&["plan", "two.hedge::g", "--as", "cpp"]);
}

#[test]
fn of_a_file_with_scripts_alone_what_they_call_is_emitted() {
    let bench = Bench::new();
    let text = "use \"std/triangle.hedge\"\nscript s() { for e in edges { flip(e) } }\n";
    bench.write("s.hedge", text);
    let said = bench.run(&["plan", "s.hedge", "--as", "cpp"]);
    assert!(said.out.contains("bool flip(Mesh&"), "{}", said.out);
    assert!(!said.out.contains("collapse("), "{}", said.out);
    assert!(said.err.contains("left out: `s`, since only operations are emitted"), "{}", said.err);
}

#[test]
fn an_op_that_is_called_as_a_word_of_the_language_gets_another_name() {
    let bench = Bench::new();
    let op =
        "op delete(v: vertex) {\n  before { face f: v -a-> w =P=> v }\n  after { keep f }\n}\n";
    bench.write("d.hedge", op);
    let cpp = bench.succeeds(&["plan", "d.hedge", "--as", "cpp"]);
    assert!(cpp.contains("bool delete_(Mesh&"), "{cpp}");
}

#[test]
fn a_file_is_emitted_with_its_steps_and_what_they_call_once() {
    let bench = Bench::new();
    for (language, heads) in [
        (
            "cpp",
            [
                "\nstd::optional<Mesh::EdgeRef> connect(Mesh& mesh, ",
                "\nstd::optional<Mesh::FaceRef> bevel_edge(Mesh& mesh, ",
                "\ninline std::optional<Mesh::VertexRef> contract(Journal& journal, ",
                "\nclass Journal {",
            ],
        ),
        (
            "rust",
            [
                "\npub fn connect(mesh: &mut Mesh, ",
                "\npub fn bevel_edge(mesh: &mut Mesh, ",
                "\nfn contract(mesh: &mut Mesh, ",
                "\nfn all_or_nothing<T>(",
            ],
        ),
    ] {
        let said = bench.run(&["plan", "std/polygon.hedge", "--as", language]);
        assert_eq!((said.code, said.err.as_str()), (0, ""));
        for head in heads {
            assert_eq!(said.out.matches(head).count(), 1, "{head}");
        }
    }
}

#[test]
fn steps_are_told_as_data() {
    let said = Bench::new().succeeds(&["plan", "std/polygon.hedge::bevel_vertex", "--as", "json"]);
    let told: serde_json::Value = serde_json::from_str(&said).unwrap();
    let plan = &told["plans"][0];
    assert_eq!(plan["calls"], serde_json::json!(["bisect", "remove", "cut"]));
    assert_eq!(plan["level"], "surface");
    assert_eq!(plan["rules"], serde_json::json!([]));
    let reasons = plan["refusals"].as_array().unwrap().iter();
    let reasons: Vec<_> = reasons.map(|refusal| refusal["reason"].as_str().unwrap()).collect();
    assert_eq!(reasons[0], "the vertex has fewer than three edges");
    assert!(reasons.contains(&"a vertex would keep a single edge"));
}

#[test]
fn steps_that_cannot_be_emitted_say_so() {
    let bench = Bench::new();
    bench.write(
        "s.hedge",
        "use \"std/polygon.hedge\"\n\
         op part(f: face) {\n  steps {\n    drain e in f.edges by length(e) { bisect(e) }\n    \
         must connect(f.halfedge, f.halfedge.next.next)\n  }\n}\n",
    );
    for language in ["cpp", "rust"] {
        let arguments = ["plan", "s.hedge::part", "--as", language];
        let said = bench.fails(1, &arguments, "error[not-emitted]");
        assert!(said.err.contains("a `drain` cannot be emitted"), "{}", said.err);
        assert!(said.err.contains("s.hedge:4:5"), "{}", said.err);
    }
}

#[test]
fn one_op_that_cannot_be_emitted_keeps_no_other_back() {
    let bench = Bench::new();
    let op = |name: &str, asked: &str| {
        format!(
            "op {name}(e: edge) {{\n  before {{ edge e: a | b  loop f: v -a-> w =P=> v }}\n  \
             {asked}\n  after {{ keep e f }}\n}}\n"
        )
    };
    let text = op("turn", "") + &op("f", "require \"a\" == \"b\"");
    bench.write("two.hedge", text);
    for language in ["cpp", "rust"] {
        let said = bench.run(&["plan", "two.hedge", "--as", language]);
        assert_eq!(said.code, 0, "{}", said.err);
        assert!(said.out.contains(" turn("), "{}", said.out);
        assert!(said.err.contains("left out: `f`, since a text cannot"), "{}", said.err);
    }
}

#[test]
fn what_cannot_be_emitted_has_a_place() {
    let bench = Bench::new();
    bench.write(
        "text.hedge",
        "op f(e: edge) {\n  before { edge e: a | b  loop f: v -a-> w =P=> v }\n  require \"a\" == \"b\"\n  after { keep e f }\n}\n",
    );
    let said = bench.fails(1, &["plan", "text.hedge", "--as", "cpp"], "error[not-emitted]");
    assert!(said.err.contains("text.hedge:3:11"), "{}", said.err);
    assert_eq!(said.out, "");
    bench.fails(2, &["plan", &flip(), "--as", "cpp", "--style", "x=y"], "a style has no `x`");
    bench.fails(
        2,
        &["plan", &flip(), "--as", "cpp", "--style", "function.flop=turn"],
        "no operation `flop` is emitted; there is `flip`",
    );
    bench.fails(2, &["plan", &flip(), "--style", "fields"], "--as cpp");
    bench.fails(
        2,
        &["plan", &flip(), "--as", "cpp", "-o", "no/a.cpp"],
        "the folder `no` does not exist",
    );
}

#[test]
fn draw_writes_pictures() {
    let bench = Bench::new();
    bench.succeeds(&["draw", &flip(), "-o", "flip.svg"]);
    let svg = std::fs::read_to_string(bench.path("flip.svg")).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{svg}");
    bench.succeeds(&["draw", &flip(), "-o", "flip.png"]);
    assert!(std::fs::read(bench.path("flip.png")).unwrap().starts_with(b"\x89PNG"));
    let text = bench.succeeds(&["draw", &flip(), "--as", "text"]);
    assert!(text.contains("v0"), "{text}");
    let page = bench.succeeds(&["draw", &example("split.hedge"), "--html"]);
    assert!(page.contains("<svg") && page.contains("proved: "), "{page}");
    bench.write("steps.hedge", "op lift(v: vertex) { steps { v.position = vec3(0, 0, 1) } }");
    let page = bench.succeeds(&["draw", "steps.hedge", "--html"]);
    assert!(page.contains("done in steps") && !page.contains("<pre></pre>"), "{page}");
    let before = bench.files();
    bench.fails(
        2,
        &["draw", &flip(), "-o", "nowhere/p.svg"],
        "nowhere/p.svg: the folder `nowhere` does not exist",
    );
    bench.fails(2, &["draw", &flip(), "-o", "flip.gif"], "neither .svg nor .png");
    bench.fails(2, &["draw", &flip()], "where should the picture go?");
    assert_eq!(bench.files(), before);
}

#[test]
fn run_writes_a_picture_of_the_result() {
    let bench = Bench::with_square();
    let remesh = example("remesh.hedge");
    let run = ["run", &remesh, "square.obj", "-o", "out.obj", "--set", "iterations=1", "--picture"];
    bench.succeeds(&[&run[..], &["out.svg"]].concat());
    assert!(std::fs::read_to_string(bench.path("out.svg")).unwrap().starts_with("<svg"));
    std::fs::remove_file(bench.path("out.obj")).unwrap();
    let before = bench.files();
    bench.fails(2, &[&run[..], &["out.gif"]].concat(), "neither .svg nor .png");
    bench.fails(2, &[&run[..], &["no/out.png"]].concat(), "the folder `no` does not exist");
    assert_eq!(bench.files(), before, "nothing is done in vain");
}

#[test]
fn view_writes_pictures() {
    let bench = Bench::with_square();
    for name in ["square.svg", "square.png"] {
        bench.succeeds(&["view", "square.obj", "-o", name, "--size", "64"]);
        assert!(bench.path(name).metadata().unwrap().len() > 100);
    }
    let view = ["view", "square.obj", "-o", "v.png", "--from"];
    bench.succeeds(&[&view[..], &["-1,-2,3"]].concat());
    bench.fails(2, &[&view[..], &["0,0,0"]].concat(), "is not a direction");
    bench.fails(2, &["view", "square.obj", "-o", "no/v.png"], "the folder `no` does not exist");
    bench.fails(2, &["view", "nothing.obj", "-o", "w.png"], "nothing.obj");
}

#[test]
fn pictures_show_attributes() {
    let bench = Bench::with_square();
    let program = "attr height: vertex real = 0\nattr height: face int = 2\n\
        script s() { for v in vertices { v.height = v.position.x } \
        for f in faces { f.height = 3 } }\n";
    bench.write("s.hedge", program);
    let run = ["run", "s.hedge", "square.obj", "-o", "s.halfedges"];
    let picture = ["--picture", "s.png", "--attribute"];
    bench.succeeds(&[&run[..], &picture, &["vertex.height"]].concat());
    assert!(bench.path("s.png").metadata().unwrap().len() > 100);
    let view = ["view", "s.halfedges", "--size", "64", "-o", "v.svg"];
    let shown = |name| [&view[..], &["--attribute", name]].concat();
    bench.succeeds(&shown("face.height"));
    let both = "write one of `vertex.height`, `face.height`";
    bench.fails(2, &shown("height"), both);
    let none = "no attribute `width`: it has `vertex.height`, `face.height`";
    bench.fails(2, &shown("width"), none);
    let plain = ["view", "square.obj", "-o", "v.svg", "--attribute", "x"];
    bench.fails(2, &plain, "no attribute `x`: it has none");
}

#[test]
fn a_plan_tells_which_pointers_are_kept() {
    let bench = Bench::new();
    let said = bench.succeeds(&["plan", &flip()]);
    // The face keeps its halfedge, which may be any of its loop; a row that named one would lie.
    assert!(said.contains(" · e.halfedge   as it was\n"), "{said}");
    assert!(!said.contains(" · e.halfedge   ="), "{said}");
    assert!(said.ends_with("\n· unchanged: not executed\n"), "{said}");
    assert!(!said.contains("h9.next"), "{said}");
}

#[test]
fn every_assignment_of_the_tutorial_is_written_down() {
    let bench = Bench::new();
    let tutorial = ["plan", &example("tutorial.hedge"), "--exhaustive"];
    let table = bench.succeeds(&tutorial);
    let code = ["--as", "cpp", "--style", "accessors"];
    let code = bench.succeeds(&[&tutorial[..], &code].concat());
    let inside = [
        ("h0", "h1 h3 v3 e0 f0"),
        ("h1", "h2 h7 v2 e2 f0"),
        ("h2", "h0 h8 v0 e3 f0"),
        ("h3", "h4 h0 v2 e0 f1"),
        ("h4", "h5 h9 v3 e4 f1"),
        ("h5", "h3 h6 v1 e1 f1"),
        ("h6", "h6->next() h5 v2 e1 h6->face()"),
        ("h7", "h7->next() h1 v0 e2 h7->face()"),
        ("h8", "h8->next() h2 v3 e3 h8->face()"),
        ("h9", "h9->next() h4 v1 e4 h9->face()"),
    ];
    let mut wanted = Vec::new();
    for (half, values) in inside {
        let pointers = ["next", "twin", "vertex", "edge", "face"].into_iter();
        wanted.extend(pointers.zip(values.split(' ')).map(|(pointer, value)| {
            let row = match value.contains('>') {
                true => format!("{half}.{pointer} as it was"),
                false => format!("{half}.{pointer} = {value}"),
            };
            (row, format!("{half}->{pointer}() = {value};"))
        }));
    }
    let others = "v0 h2 v1 h5 v2 h3 v3 h0 e0 h0 e1 h5 e2 h1 e3 h2 e4 h4 f0 h0 f1 h3";
    let others: Vec<_> = others.split(' ').collect();
    for pair in others.chunks(2) {
        let (of, half) = (pair[0], pair[1]);
        wanted.push((format!("{of}.halfedge"), format!("{of}->halfedge() = {half};")));
    }
    assert_eq!(wanted.len(), 61);
    let rows: Vec<_> = table.lines().map(|row| row.split_whitespace().collect()).collect();
    let rows: Vec<String> = rows.into_iter().map(|row: Vec<_>| row.join(" ")).collect();
    for (row, line) in wanted {
        assert!(rows.iter().any(|known| known.trim_start_matches("· ").starts_with(&row)), "{row}");
        assert!(code.contains(&format!("\n  {line}\n")), "{line}\n{code}");
    }
}

/// The example in C++ is built and run as its first lines say.
#[test]
fn the_example_in_cpp_runs() {
    if Command::new("g++").arg("--version").output().is_err() {
        assert!(std::env::var_os("CI").is_none(), "CI needs g++");
        eprintln!("SKIPPED: there is no g++");
        return;
    }
    let bench = Bench::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/cpp");
    for name in ["mesh.h", "main.cpp"] {
        bench.write(name, std::fs::read(folder.join(name)).unwrap());
    }
    bench.succeeds(&["plan", "std/triangle.hedge", "--as", "cpp", "-o", "triangle.h"]);
    let main = bench.path("main");
    let built = Command::new("g++")
        .args(["-std=c++17", "-Wall", "-Wextra", "-Werror", "-D_GLIBCXX_DEBUG", "main.cpp", "-o"])
        .arg(&main)
        .current_dir(main.parent().unwrap())
        .output()
        .unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let done = Command::new(&main).output().unwrap();
    assert_eq!(
        String::from_utf8_lossy(&done.stdout),
        "flipped: 1\nsplit at 0.5 0.5 0: 4 faces, 5 vertices\n\
         collapsed: 1: 2 faces, 4 vertices\n"
    );
}
