//! Names that languages, headers and emitted code keep to themselves, drawn in operations, and
//! the C++ and Rust of them compiled.

use std::fmt::Write as _;
use std::fs;

use hedgerow::analysis::Analysis;
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::source::Sources;
use tempfile::TempDir;

use hedgerow::emit::reserved::{plain, unreserved};

use crate::compiled::compiler::{compile, folder, has_compiler};
use crate::rust::{through_support, with_support};

/// Keywords and alternative tokens of C++ to C++23, and of Rust to 2024 with those kept for later;
/// macros and types of headers; names of the mesh class and of what is emitted.
const WORDS: &str = include_str!("words.txt");

/// Words that the language itself keeps, so that no program has them as names.
fn is_free(op: &str, word: &str) -> bool {
    let text = format!(
        "op {op}({word}: edge) {{ before {{ loop a: v -b-> w =P=> v  edge {word}: b | c }} after {{ loop a: v -b-> w =P=> v  keep {word} }} }}"
    );
    let mut sources = Sources::new();
    let file = sources.add("word.hedge", text);
    Analysis::of(&sources, file).is_sound()
}

/// For each word an operation that is called so, a parameter, a halfedge, a vertex with a prime, a
/// path, a family, a rule, a function and its variable.
fn program() -> String {
    let mut text = String::new();
    for (at, word) in words().into_iter().enumerate() {
        let next = format!("plain_{at}");
        writeln!(
            text,
            "fn twice_{at}({word}: real) -> real {{ let {next} = {word} * 2  {next} + {word} }}
op {word}_of_{at}({word}: edge, share: real = 0.5) {{
  rule {word} {{
    before {{
      face f0: {word}' -a-> v1 -b-> v2 =P=> {word}'
      face f1: v1 -d-> {word}' =Q=> v1
      edge {word}: a | d
    }}
    require twice_{at}(share) > 0.0 else \"ends in {word} \\\\\"
    after {{
      {word}'.position = mix({word}'.position, v1.position, share)
      keep f0 f1 {word}
    }}
  }}
  rule second {{
    before {{ loop {word}_: u -g-> w ={word}__P=> u  edge {word}: g | h }}
    after {{
      u.position = w.position
      keep {word}_ {word}
    }}
  }}
}}
op corner_{at}({word}: halfedge) -> f {{
  before {{ face f: p -{word}-> q -y-> r -z-> p }}
  after {{ keep f }}
}}
op ring_{at}(face_{at}: face) {{
  before {{ face face_{at}: each i {{ {word}[i] -h[i]-> }} }}
  guard surface
  after {{
    new v a[i] b[i] e[i] g[i]
    face g[i]: {word}[i] -h[i]-> {word}[i+1] -a[i]-> v -b[i]-> {word}[i]
    edge e[i]: a[i] | b[i+1]
    erase face_{at}
    v.position = centroid(face_{at})
  }}
}}"
        )
        .unwrap();
    }
    for word in words().into_iter().filter(|word| is_free(word, "e")) {
        writeln!(
            text,
            "op {word}(e: edge) {{ before {{ loop f: v -a-> w =P=> v  edge e: a | b }} require {word}'(2) > 1 else \"no\" after {{ keep e f }} }}
fn {word}'(x: real) -> real {{ x }}"
        )
        .unwrap();
    }
    text
}

fn words() -> Vec<&'static str> {
    let mut words: Vec<_> = WORDS.split_whitespace().collect();
    words.sort();
    words.dedup();
    words.retain(|word| is_free("f", word));
    assert!(words.len() > 150, "only {} words", words.len());
    words
}

#[test]
fn reserved_words_are_names_like_others() {
    let mut sources = Sources::new();
    let file = sources.add("words.hedge", program());
    let analysis = Analysis::of(&sources, file);
    let first = analysis.diagnostics.iter().find(|told| told.is_error());
    assert!(analysis.is_sound(), "{first:?}");
    let ops: Vec<_> = (0..analysis.program.ops.len()).collect();
    let selection = Selection {
        program: &analysis.program,
        proved: &analysis.proved,
        sources: &sources,
        ops: &ops,
        exhaustive: false,
    };
    let bench = TempDir::new().unwrap();
    let write = |name: &str, text: &str| fs::write(bench.path().join(name), text).unwrap();

    write("words.rs", &through_support(&rust(&selection).unwrap()));
    let args = ["--edition=2024", "--crate-type=lib", "--emit=metadata", "-Awarnings", "words.rs"];
    let support = with_support();
    compile(bench.path(), "rustc", &[&args[..], &support.each_ref().map(String::as_str)].concat());
    if !has_compiler() {
        return;
    }
    let code = cpp(&selection, &Style::default()).unwrap();
    let header = fs::read_to_string(folder("tests/emit/fields.h")).unwrap();
    write("mesh.h", &header);
    // Headers whose macros and types are in the way of names.
    let others = "#include <cassert>\n#include <cerrno>\n#include <climits>\n#include <cmath>\n#include <cstdarg>\n#include <cstdint>\n#include <cstdio>\n#include <cstdlib>\n#include <sys/types.h>\n#include <sys/sysmacros.h>\n";
    write("words.cpp", &format!("{others}#include \"mesh.h\"\n{code}"));
    for standard in ["-std=gnu++17", "-std=c++20"] {
        let args = [standard, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "words.cpp"];
        compile(bench.path(), "g++", &args);
    }
}

#[test]
fn what_languages_and_macros_keep_gets_something_behind_it() {
    let kept = ["VertexRef".to_string()];
    for (word, free) in [
        ("v0", "v0"),
        ("P", "P"),
        ("P2", "P2"),
        ("co_await", "co_await_"),
        ("bitand", "bitand_"),
        ("Self", "Self_"),
        ("gen", "gen_"),
        ("NULL", "NULL_"),
        ("M_PI", "M_PI_"),
        ("stdin", "stdin_"),
        ("VertexRef", "VertexRef_"),
        ("Vertex", "Vertex"),
    ] {
        assert_eq!(unreserved(word, &kept), free);
    }
}

#[test]
fn names_are_single_words() {
    for (name, word) in [("h'", "h_"), ("h''", "h_2"), ("_x", "x_x"), ("a__b", "a_b")] {
        assert_eq!(plain(name), word);
    }
}
