//! The house is in order: each layer names only layers it may know.
//!
//! Within one crate the compiler does not hold the walls; this does, by reading the paths
//! `crate::layer` of every file of a layer's folder.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Each layer, and the layers it may name.
const LAYERS: &[(&str, &[&str])] = &[
    ("source", &[]),
    ("mesh", &[]),
    ("library", &[]),
    ("diagnostic", &["source"]),
    ("diagram", &["source", "mesh"]),
    ("rewrite", &["mesh", "source"]),
    ("syntax", &["source", "diagnostic"]),
    ("check", &["source", "diagnostic", "diagram", "mesh"]),
    ("compile", &["source", "mesh", "diagram", "check", "rewrite"]),
    ("draw", &["source", "diagram", "mesh"]),
    ("emit", &["source", "diagnostic", "diagram", "check", "compile", "resolve"]),
    ("format", &["source", "diagnostic", "syntax"]),
    ("resolve", &["source", "diagnostic", "syntax", "diagram"]),
    ("run", &["source", "mesh", "diagnostic", "diagram", "rewrite", "compile", "resolve"]),
    (
        "analysis",
        &[
            "source",
            "mesh",
            "library",
            "diagnostic",
            "diagram",
            "rewrite",
            "syntax",
            "check",
            "compile",
            "resolve",
            "run",
        ],
    ),
    (
        "session",
        &[
            "source",
            "mesh",
            "library",
            "diagnostic",
            "diagram",
            "rewrite",
            "compile",
            "resolve",
            "run",
            "analysis",
        ],
    ),
    ("lsp", &["source", "diagnostic", "diagram", "draw", "library", "format", "analysis"]),
    (
        "cli",
        &[
            "source",
            "mesh",
            "library",
            "diagnostic",
            "syntax",
            "diagram",
            "rewrite",
            "resolve",
            "run",
            "draw",
            "emit",
            "format",
            "analysis",
            "session",
            "lsp",
        ],
    ),
];

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a layer is a folder");
    let paths = entries.map(|entry| entry.expect("a readable entry").path());
    paths.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// The layers that a text names as `crate::layer`.
fn named(text: &str) -> BTreeSet<&str> {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let paths = code.flat_map(|line| line.split("crate::").skip(1));
    paths
        .map(|path| path.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or(""))
        .filter(|word| !word.is_empty())
        .collect()
}

#[test]
fn layers_name_only_what_lies_below_them() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut read = 0;
    for (layer, may_name) in LAYERS {
        for file in files_below(&source.join(layer)) {
            let text = fs::read_to_string(&file).expect("a source file");
            for name in named(&text) {
                let allowed = name == *layer || may_name.contains(&name);
                assert!(allowed, "{} names `{name}`, which {layer} may not", file.display());
            }
            read += 1;
        }
    }
    assert!(read > 50, "only {read} files were read");
}

#[test]
fn every_folder_is_a_layer() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let folders: BTreeSet<_> = fs::read_dir(source)
        .expect("src")
        .map(|entry| entry.expect("a readable entry").path())
        .filter(|path| path.is_dir())
        .map(|path| path.file_name().expect("a name").to_string_lossy().into_owned())
        .collect();
    let layers: BTreeSet<_> = LAYERS.iter().map(|(layer, _)| layer.to_string()).collect();
    assert_eq!(folders, layers);
}
