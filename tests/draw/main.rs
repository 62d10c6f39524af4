//! Pictures: those of the examples match the committed files, and every op has one.
//!
//! `UPDATE=1` rewrites the pictures of the examples; inspect them afterwards.

mod colours;
mod counterexamples;
mod examples;
mod loops;
mod meshes;
mod mutants;
mod steps;

use std::fs;
use std::path::{Path, PathBuf};

use hedgerow::analysis::Analysis;
use hedgerow::diagram::Op;
use hedgerow::draw::TextBox;
use hedgerow::source::Sources;

/// Whether the boxes of two texts overlap.
fn overlap(a: &TextBox, b: &TextBox) -> bool {
    (0..2).all(|axis| a.to[axis] > b.from[axis] && b.to[axis] > a.from[axis])
}

/// Checks that no two texts of a picture overlap; returns the number of pairs.
fn check_apart(texts: &[TextBox], name: &str) -> usize {
    let mut pairs = 0;
    for (at, a) in texts.iter().enumerate() {
        for b in &texts[..at] {
            assert!(!overlap(a, b), "{name}: `{}` covers `{}`", a.text, b.text);
            pairs += 1;
        }
    }
    pairs
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// The drawn operations of the examples, each with the stem of its file, in order.
fn example_ops() -> Vec<(String, Op)> {
    let ops = ops_in("examples");
    assert!(ops.len() > 8, "only {} operations", ops.len());
    ops
}

/// The drawn operations of the examples and of the standard library, and the examples shown for its
/// operations in steps.
fn shipped_ops() -> Vec<(String, Op)> {
    [example_ops(), ops_in("src/library/std"), steps::shipped()].concat()
}

fn ops_in(name: &str) -> Vec<(String, Op)> {
    let entries = fs::read_dir(folder(name)).expect("a folder");
    let mut paths: Vec<_> = entries
        .map(|entry| entry.expect("a readable entry").path())
        .filter(|path| path.extension().is_some_and(|end| end == "hedge"))
        .collect();
    paths.sort();
    let mut ops = Vec::new();
    for path in paths {
        let stem = path.file_stem().expect("a name").to_string_lossy();
        let text = fs::read_to_string(&path).expect("an example");
        ops.extend(ops_of(&text).into_iter().map(|op| (stem.to_string(), op)));
    }
    ops
}

/// The operations of a text that are drawn.
fn ops_of(text: &str) -> Vec<Op> {
    let mut sources = Sources::new();
    let file = sources.add("test.hedge".to_string(), text.to_string());
    let program = Analysis::of(&sources, file).program;
    program.ops.into_iter().filter_map(|op| op.diagram).collect()
}
