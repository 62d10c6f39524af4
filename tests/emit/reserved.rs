//! Names that languages, headers and emitted code keep to themselves, drawn in operations, and
//! the C++ and Rust of them compiled.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use hedgerow::analysis::Analysis;
use hedgerow::emit::{Selection, Style, cpp, rust};
use hedgerow::source::Sources;
use tempfile::TempDir;

use crate::cpp::has_compiler;
use crate::subjects::folder;

/// Keywords and alternative tokens of C++ to C++23, and of Rust to 2024 with those kept for later;
/// macros and types of headers; names of the mesh class and of what is emitted.
const WORDS: &str = "
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t
    char32_t class co_await co_return co_yield compl concept const const_cast consteval constexpr
    constinit continue decltype default delete do double dynamic_cast else enum explicit export
    extern false final float for friend goto if import inline int long module mutable namespace
    new noexcept not not_eq nullptr operator or or_eq override private protected public register
    reinterpret_cast requires return short signed sizeof static static_assert static_cast struct
    switch synchronized template this thread_local throw true try typedef typeid typename union
    unsigned using virtual void volatile wchar_t while xor xor_eq
    Self abstract as async await become box crate dyn fn gen impl in let loop macro macro_rules
    match mod move mut priv pub raw ref safe self super trait type typeof unsafe unsized use where
    yield union
    NULL EOF assert errno stdin stdout stderr offsetof M_PI INFINITY NAN HUGE_VAL BUFSIZ RAND_MAX
    EXIT_SUCCESS INT_MAX SIZE_MAX DBL_MAX CHAR_BIT SEEK_SET TMP_MAX L_tmpnam P_tmpdir va_start
    isnan isinf isfinite signbit fpclassify unix linux i386 min max major minor
    size_t ptrdiff_t int8_t int32_t uint64_t FILE std main abs div exp log sqrt index link
    Mesh Vec3 VertexRef HalfedgeRef EdgeRef FaceRef mesh hedgerow journal was at element value
    new_vertex new_face erase vertices halfedges edges faces spokes degree centroid mix made
    Some None Ok Err Option Vec String Box DVec3 VertexId HalfedgeId Level HashMap f64 u32 str
    n count size result sheet rule_inside once number all list";

/// Words that the language itself keeps, so that no program has them as names.
fn is_free(word: &str) -> bool {
    let text = format!(
        "op f({word}: edge) {{ before {{ loop a: v -b-> w =P=> v  edge {word}: b | c }} after {{ loop a: v -b-> w =P=> v  keep {word} }} }}"
    );
    let mut sources = Sources::new();
    let file = sources.add("word.hedge", text);
    Analysis::of(&sources, file).is_sound()
}

/// For each word an operation that is called so, a parameter, a halfedge, a path, a family, a
/// rule, a function and its variable.
fn program() -> String {
    let mut text = String::new();
    for (at, word) in words().into_iter().enumerate() {
        let next = format!("plain_{at}");
        writeln!(
            text,
            "fn f_{at}({word}: real) -> real {{ let {next} = {word} * 2  {next} + {word} }}
op {word}_{at}({word}: edge, share: real = 0.5) {{
  rule {word} {{
    before {{
      face f0: v0 -a-> v1 -b-> v2 =P=> v0
      face f1: v1 -d-> v0 =Q=> v1
      edge {word}: a | d
    }}
    require f_{at}(share) > 0.0 else \"ends in {word} \\\\\"
    after {{
      v0.position = mix(v0.position, v1.position, share)
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
op h_{at}({word}: halfedge) -> f {{
  before {{ face f: p -{word}-> q -y-> r -z-> p }}
  after {{ keep f }}
}}
op n_{at}(face_{at}: face) {{
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
    for word in words() {
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
    words.retain(|word| is_free(word));
    assert!(words.len() > 150, "only {} words", words.len());
    words
}

fn compile(bench: &Path, compiler: &str, args: &[&str]) {
    let done = Command::new(compiler).args(args).current_dir(bench).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{compiler} {args:?} says\n{said}");
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

    write("words.rs", &rust(&selection).unwrap());
    let built = std::env::current_exe().unwrap();
    let built = built.parent().unwrap();
    let [mesh, vectors] =
        ["hedgerow", "glam"].map(|name| format!("{name}={}", library(built, name)));
    let args = ["--edition=2024", "--crate-type=lib", "--emit=metadata", "-Awarnings", "words.rs"];
    let dependencies = format!("dependency={}", built.display());
    let others = ["--extern", &mesh, "--extern", &vectors, "-L", &dependencies];
    compile(bench.path(), "rustc", &[&args[..], &others].concat());
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

/// The library of a crate that was built for this test, last.
fn library(built: &Path, name: &str) -> String {
    let is_it = |path: &PathBuf| {
        let file = path.file_name().and_then(|file| file.to_str()).unwrap_or("");
        file.starts_with(&format!("lib{name}-")) && file.ends_with(".rlib")
    };
    let all = fs::read_dir(built).unwrap().map(|entry| entry.unwrap().path());
    let last = all.filter(is_it).max_by_key(|path| path.metadata().unwrap().modified().unwrap());
    last.unwrap().display().to_string()
}
