//! Programs that are none: a message with the place and an exit code.

use crate::bench::{Bench, example};
use crate::meshes::noise;

#[test]
fn not_a_text() {
    let bench = Bench::new();
    bench.write("noise.hedge", noise(5000));
    bench.write("latin.hedge", b"// fine\n// caf\xe9\n");
    for name in ["noise.hedge", "latin.hedge"] {
        bench.fails(2, &["check", name], "is not UTF-8 text");
    }
    bench.fails(2, &["check", "latin.hedge"], "line 2");
    bench.fails(2, &["check", "nothing.hedge"], "nothing.hedge");
    bench.fails(2, &["check", "."], "`.`");
}

#[test]
fn a_mesh_is_no_program() {
    let bench = Bench::with_square();
    bench.write("s.hedge", "script s() { }");
    for arguments in [&["run", "square.obj", "s.hedge"][..], &["check", "square.obj"]] {
        bench.fails(2, arguments, "`square.obj` is a mesh; a program is wanted here");
    }
    bench.fails(2, &["run", "s.hedge", "s.hedge"], "`s.hedge` is a program; a mesh is wanted here");
}

#[test]
fn an_empty_program_is_in_order() {
    let bench = Bench::new();
    for text in ["", "\n", "\u{feff}", "// nothing\n"] {
        bench.write("empty.hedge", text);
        assert_eq!(bench.succeeds(&["check", "empty.hedge"]), "empty.hedge: no operations\n");
    }
}

#[test]
fn what_is_checked_without_operations_is_told() {
    let bench = Bench::new();
    let text =
        "script a() { }\nscript b() { }\nfn one() -> int { 1 }\ntest \"t\" { mesh = cube() }\n";
    bench.write("my.hedge", text);
    let told = "my.hedge: 2 scripts, 1 function, 1 test, no operations\n";
    assert_eq!(bench.succeeds(&["check", "my.hedge"]), told);
    bench.write("other.hedge", "use \"my.hedge\"\nscript c() { a() }\n");
    let told = "other.hedge: 1 script, no operations\n";
    assert_eq!(bench.succeeds(&["check", "other.hedge"]), told);
}

#[test]
fn the_other_files_are_looked_at_all_the_same() {
    let bench = Bench::new();
    let said = bench.fails(2, &["check", "nothing.hedge", &example("flip.hedge")], "nothing.hedge");
    assert!(said.out.contains("proved  flip"), "{said:?}");
}

#[test]
fn depth() {
    let nested = |text: &str| text.repeat(100_000);
    refused_briefly([
        nested("("),
        nested("{"),
        format!("op f(e: edge) {{ before {}", nested("{")),
        format!("script s() {{ let x = {}1 }}", nested("(")),
        format!("script s() {{ let x = {}1 }}", nested("-")),
        format!("script s() {{ let x = {}true }}", nested("not ")),
        format!("script s() {{ let x = 1{} }}", nested(" + 1")),
        format!("script s() {{ {} }}", nested("if true { } else ")),
        format!("script s() {{ {}", nested("repeat 2 { ")),
    ]);
}

#[test]
fn brackets_by_the_million() {
    refused_briefly(["{".repeat(3 * MILLION), "}".repeat(3 * MILLION), "[".repeat(MILLION)]);
}

#[test]
fn pairs_by_the_million() {
    refused_briefly(["{}".repeat(2 * MILLION)]);
}

#[test]
fn words_by_the_million() {
    let texts = [("op ", 1), ("a", 3), ("\"", 1), ("\u{1d11e}", 1)];
    refused_briefly(texts.map(|(text, millions)| text.repeat(millions * MILLION)));
}

const MILLION: usize = 1_000_000;

/// Checks each text, which is refused in few words.
fn refused_briefly<const N: usize>(texts: [String; N]) {
    let bench = Bench::new();
    for text in texts {
        bench.write("deep.hedge", &text);
        let said = bench.fails(1, &["check", "deep.hedge"], "error[");
        let start: String = text.chars().take(40).collect();
        assert!(said.err.len() < 100_000, "{start}: {}", said.err.len());
    }
}

#[test]
fn a_program_cut_anywhere_has_a_message() {
    let bench = Bench::new();
    for name in ["collapse.hedge", "remesh.hedge"] {
        let text = std::fs::read_to_string(example(name)).unwrap();
        let start = text.find("op ").unwrap() + 3;
        let mut cut = 0;
        for end in (start..text.len() - 3).step_by(97) {
            bench.write("cut.hedge", &text[..text.floor_char_boundary(end)]);
            let said = bench.run(&["check", "cut.hedge"]);
            // A cut between two items leaves a whole program.
            assert!(matches!(said.code, 0 | 1), "{end}: {said:?}");
            assert_eq!(said.code == 1, said.err.contains("error["), "{end}: {said:?}");
            cut += said.code;
        }
        assert!(cut > 10, "{name}");
    }
}

#[test]
fn nothing_runs_that_is_not_proved() {
    let bench = Bench::with_square();
    bench.write(
        "bad.hedge",
        "op drop(e: edge) {
           before { loop f: v0 -a-> v1 =P=> v0  edge e: a | d }
           after { keep f }
         }
         script s() { for e in edges { drop(e) } }",
    );
    let words = "error[missing-reassignment]";
    for arguments in [
        &["plan", "bad.hedge"][..],
        &["apply", "bad.hedge", "square.obj", "--at", "edge:1-2", "-o", "out.obj"],
        &["run", "bad.hedge", "square.obj", "-o", "out.obj"],
    ] {
        bench.fails(1, arguments, words);
    }
    assert!(!bench.has("out.obj"));
}

const FORGOTTEN: &str = "\
op poke(f: face) -> c {
  before {
    face f: v0 -h0→ v1 -h1→ v2 -h2→ v0
  }
  after {
    new c, f0, f1, f2, a0, b0, a1, b1, a2, b2
    face f0: v0 -h0-> v1 -a0-> c -b0-> v0
    face f1: v1 -h1-> v2 -a1-> c -b1-> v1
    face f2: v2 -h2-> v0 -a2-> c -b2-> v2
    delete f
    c.position = centroid(f);
  }
}
";

#[test]
fn what_is_sure_is_written_until_nothing_is_left() {
    let bench = Bench::new();
    bench.write("poke.hedge", FORGOTTEN);
    let said = bench.run(&["check", "--fix", "poke.hedge"]);
    assert_eq!(said.code, 0, "{said:?}");
    assert!(said.out.contains("proved  poke"), "{said:?}");
    assert!(said.err.contains("fixes written"), "{said:?}");
    let mended = bench.read("poke.hedge");
    for words in ["-h0-> v1", "erase f\n", "edge e1: a0 | b1", "b2 e1 e2 e3\n"] {
        assert!(mended.contains(words), "{words}:\n{mended}");
    }
    let again = bench.run(&["check", "--fix", "poke.hedge"]);
    assert!(!again.err.contains("written"), "{again:?}");
    assert_eq!(bench.read("poke.hedge"), mended);
    // Lines keep their ends.
    let with_crlf = |text: &str| text.replace('\n', "\r\n");
    bench.write("windows.hedge", with_crlf(FORGOTTEN));
    bench.run(&["check", "--fix", "windows.hedge"]);
    assert_eq!(bench.read("windows.hedge"), with_crlf(&mended));
}

/// An error of syntax hides others; a fix is not weighed against these.
#[test]
fn what_is_written_wrongly_is_mended_whatever_it_hides() {
    let bench = Bench::new();
    let text = "op move(v: vertex, d: vec3) {\n  before { vertex v: * }\n  \
                after { keep v v.position += d }\n}\n";
    bench.write("move.hedge", text);
    let said = bench.run(&["check", "--fix", "move.hedge"]);
    let mended = bench.read("move.hedge");
    assert!(mended.contains("v.position = v.position + d"), "{said:?}");
}

/// Each round mends one level, and the text becomes longer.
#[test]
fn a_fix_whose_error_comes_back_again_and_again_is_not_written() {
    let bench = Bench::new();
    let nested = |depth: usize| {
        let inside = (0..depth)
            .fold("true".to_owned(), |inside, at| format!("all(x{at} in faces: {inside})"));
        format!("script main() {{\n  print {inside}\n}}\nscript more() {{\n  print .5\n}}\n")
    };
    for (depth, is_mended) in [(4, true), (24, false)] {
        let text = nested(depth);
        bench.write("all.hedge", &text);
        let said = bench.run(&["check", "--fix", "all.hedge"]);
        assert_eq!(said.code == 0, is_mended, "{said:?}");
        // The other fixes are written all the same.
        let mended = bench.read("all.hedge");
        assert!(mended.contains("print 0.5"), "{mended}");
        assert_eq!(mended.contains(": "), !is_mended, "{mended}");
    }
}

#[test]
fn what_depends_on_something_broken_says_so() {
    let bench = Bench::new();
    let op = std::fs::read_to_string(example("flip.hedge")).unwrap();
    let op = op.replace("  after {", "  require mid(v0)\n  after {");
    let text = format!(
        "fn bad(v: vertex) -> bool {{ nothing(v) }}\nfn mid(v: vertex) -> bool {{ bad(v) }}\n{op}\
         op both(e: edge) {{ steps {{ must flip(e) }} }}\n"
    );
    bench.write("a.hedge", text);
    let said = bench.run(&["check", "a.hedge"]);
    assert_eq!(said.code, 1, "{said:?}");
    assert!(said.out.contains("not proved  flip"), "{said:?}");
    assert!(said.out.contains("depends on `bad`, which has an error"), "{said:?}");
    assert!(said.out.contains("depends on `flip`, which has an error"), "{said:?}");
    assert_eq!(said.err.matches("error[").count(), 1, "{said:?}");
    // An attribute without a type leaves the values of new elements open.
    let poke = std::fs::read_to_string(example("../src/library/std/subdivide.hedge")).unwrap();
    let poke = poke.split("/// Inserts a vertex at the centroid").nth(1).unwrap();
    let poke = &poke[poke.find("op poke").unwrap()..=poke.find("\n}").unwrap() + 1];
    let poke = poke.replace("m.fresh    = true", "");
    bench.write("c.hedge", format!("attr parent: vertex halfedge\n{poke}\n"));
    let said = bench.run(&["check", "c.hedge"]);
    assert!(said.out.contains("depends on `parent`, which has an error"), "{said:?}");
    // A script is called one.
    bench.write(
        "d.hedge",
        "script smooth() { update v in vertices { print 1 } }\nscript demo() { smooth() }\n",
    );
    let said = bench.run(&["run", "d.hedge::demo", "cube()"]);
    assert!(said.err.contains("`smooth` has an error, and this depends on it"), "{said:?}");
    assert!(said.err.contains("this script has an error"), "{said:?}");
    // So do steps that call a function.
    bench.write(
        "b.hedge",
        "use \"std/triangle.hedge\"
        fn bad(e: edge) -> edge { if e == e { return e } nothing }
        op steps_of(e: edge) { steps { let x = bad(e) must flip(x) } }
        op around(e: edge) { steps { must again(e) } }
        op again(e: edge) { steps { must again(e) must flip(e) } }
        script fine() { for e in edges { flip(e) } }
        script steps_run() { for e in edges { steps_of(e) } }",
    );
    let said = bench.run(&["check", "b.hedge"]);
    assert!(said.out.contains("steps_of  depends on `bad`"), "{said:?}");
    assert!(said.out.contains("around    depends on `again`"), "{said:?}");
    assert_eq!(said.err.matches("error[cyclic-steps]").count(), 1, "{said:?}");
    // A script that depends on nothing of that runs when it is named.
    let run = |script: &str| bench.run(&["run", script, "octahedron()"]);
    assert_eq!(run("b.hedge::fine").code, 0);
    let said = run("b.hedge::steps_run");
    assert!(said.code == 1 && said.err.contains("unproved-op"), "{said:?}");
    let said = run("b.hedge");
    assert!(said.code == 1 && said.err.contains("`hedgerow run b.hedge::fine`"), "{said:?}");
}

#[test]
fn ops_of_one_name_are_told_apart_by_their_files() {
    let bench = Bench::with_square();
    let uses = "use \"std/triangle.hedge\"\nuse \"std/polygon.hedge\"\n";
    let steps = "steps { must triangle::flip(e) must polygon::flip(e) }";
    bench.write("both.hedge", format!("{uses}op both(e: edge) {{ guard simple {steps} }}\n"));
    let told = bench.succeeds(&["check", "both.hedge"]);
    assert!(told.contains("in steps: triangle::flip, polygon::flip"), "{told}");
    let [one, other] = ["triangle", "polygon"]
        .map(|file| bench.succeeds(&["plan", &format!("both.hedge::{file}::flip")]));
    assert_ne!(one, other);
}

#[test]
fn a_script_takes_elements_by_the_numbers_of_the_file() {
    let bench = Bench::new();
    bench.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    bench.write(
        "a.hedge",
        "use \"std/triangle.hedge\"\n\
         script s(a: vertex, e: edge, by: real = 1) {\n\
           if flip(e) { a.position = by * a.position }\n\
           print \"{a.position} {length(e)}\"\n\
         }\n",
    );
    let run = |more: &[&str]| bench.run(&[&["run", "a.hedge", "m.obj"], more].concat());
    let by_order = run(&["--at", "vertex:2", "--at", "edge:1-3", "--set", "by=3"]);
    assert!(by_order.out.contains("(3, 0, 0) 3.1622"), "{by_order:?}");
    let by_name = run(&["--at", "e=edge:3-1", "--at", "a=vertex:2", "--set", "by=3", "--reorder"]);
    assert_eq!(by_name.out.lines().next(), by_order.out.lines().next(), "{by_name:?}");
    for (more, says) in [
        (vec!["--at", "vertex:2"], "`e` is missing: give --at e=edge:A-B"),
        (vec!["--at", "vertex:2", "--at", "edge:2-4"], "no edge joins the vertices 2 and 4"),
        (vec!["--at", "vertex:9", "--at", "edge:1-3"], "no vertex 9"),
        (vec!["--at", "face:1", "--at", "edge:1-3"], "`a` is of type vertex"),
        (vec!["--at", "b=vertex:1"], "the elements are `a`, `e`"),
        (vec!["--set", "a=2", "--at", "edge:1-3"], "`a` is an element: give --at a=PLACE"),
    ] {
        let said = run(&more);
        assert_eq!(said.code, 2, "{said:?}");
        assert!(said.err.contains(says), "{more:?}: {said:?}");
    }
}

/// What is asked for decides, with all that it names: errors of others are counted in a line.
#[test]
fn errors_of_others_are_only_counted() {
    let bench = Bench::with_square();
    bench.write(
        "s.hedge",
        "op bad(e: edge) {
  before { loop f: v0 -a-> v1 =P=> v0 edge e: a | b }
  after { keep f edge e: a | x }
}
op good(f: face) { before { face f: v0 -a-> v1 =P=> v0 } after { keep f } }
op both(e: edge) { steps { must bad(e) } }
fn wrong() -> int { true }
fn through() -> int { wrong() }
script runs() { for f in faces { good(f) } }
script stops() { print through() }
test \"passes\" { mesh = cube() for bad in faces { must good(bad) } }
test \"fails\" { mesh = cube() for e in edges { must bad(e) } }
",
    );
    let others = |said: &str, count: &str| {
        assert!(
            said.contains(&format!("{count} in other items: `hedgerow check s.hedge`")),
            "{said}"
        );
    };
    let runs = bench.run(&["run", "s.hedge::runs", "square.obj"]);
    assert!(runs.code == 0 && !runs.err.contains("error["), "{runs:?}");
    others(&runs.err, "2 errors");
    let stops =
        bench.fails(1, &["run", "s.hedge::stops", "square.obj"], "`wrong` gives an int").err;
    assert!(!stops.contains("unknown-name"), "{stops}");
    others(&stops, "1 error");
    let at = ["square.obj", "--at", "edge:1-3"];
    for op in ["bad", "both"] {
        let op = format!("s.hedge::{op}");
        let told = bench.fails(1, &[&["apply", &op][..], &at].concat(), "unknown-name").err;
        assert!(!told.contains("type-mismatch"), "{told}");
        others(&told, "1 error");
    }
    let passes = bench.run(&["test", "s.hedge", "--filter", "pass"]);
    assert!(passes.code == 0 && !passes.err.contains("error["), "{passes:?}");
    others(&passes.err, "2 errors");
    let fails = bench.fails(1, &["test", "s.hedge", "--filter", "fail"], "unknown-name").err;
    others(&fails, "1 error");
    let none = bench.run(&["test", "s.hedge", "--filter", "pass", "--exact"]);
    assert!(none.err.contains("no test"), "{none:?}");
    // Without a filter the whole file is asked for.
    let all = bench.fails(1, &["test", "s.hedge"], "`wrong` gives an int").err;
    assert!(all.contains("unknown-name") && !all.contains("in other items"), "{all}");
}
