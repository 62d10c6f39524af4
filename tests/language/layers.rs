//! The house is in order: each layer names only layers it may know.
//!
//! Within one crate the compiler does not hold the walls; this does, by reading the paths
//! `crate::layer` and `crate::{layer, layer}` of every file of a layer's folder.

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
    ("lower", &["source", "mesh", "diagram", "check", "resolve"]),
    ("compile", &["source", "mesh", "diagram", "check", "lower", "rewrite"]),
    ("draw", &["source", "diagram", "mesh"]),
    ("emit", &["source", "diagnostic", "diagram", "check", "lower", "resolve"]),
    ("format", &["source", "diagnostic", "syntax"]),
    ("resolve", &["source", "diagnostic", "syntax", "diagram"]),
    ("run", &["source", "mesh", "diagnostic", "diagram", "rewrite", "compile", "lower", "resolve"]),
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
            "draw",
            "analysis",
        ],
    ),
    ("lessons", &["mesh", "rewrite", "analysis", "session"]),
    (
        "play",
        &[
            "source", "mesh", "library", "diagram", "rewrite", "run", "draw", "emit", "analysis",
            "session", "lessons",
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
            "lessons",
            "play",
            "lsp",
        ],
    ),
];

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a layer is a folder");
    let paths = entries.map(|entry| entry.expect("a readable entry").path());
    paths.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
}

/// The layers that a text names, as `crate::layer` or in `crate::{layer::…, layer}`.
fn named(text: &str) -> BTreeSet<&str> {
    let mut named = BTreeSet::new();
    // What is commented out names nothing; lines are looked at from where their code begins.
    for (at, _) in text.match_indices("crate::") {
        let line = text[..at].rsplit('\n').next().unwrap_or("");
        if line.trim_start().starts_with("//") {
            continue;
        }
        let path = &text[at + "crate::".len()..];
        match path.strip_prefix('{') {
            Some(group) => named.extend(members(group)),
            None => named.extend([word(path)]),
        }
    }
    named.remove("");
    named
}

/// The word at the beginning of a text.
fn word(text: &str) -> &str {
    let text = text.trim_start();
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    &text[..end.unwrap_or(text.len())]
}

/// The first words of the paths of a group, up to the brace that closes it.
fn members(group: &str) -> Vec<&str> {
    let mut depth = 0;
    let mut members = vec![word(group)];
    for (at, letter) in group.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => members.push(word(&group[at + 1..])),
            _ => {}
        }
    }
    members
}

#[test]
fn paths_and_groups_of_paths_name_layers() {
    let text = "use crate::mesh::Mesh;\n// crate::cli\nuse crate::{\n    draw::{self, page},\n    run,\n};";
    assert_eq!(named(text), BTreeSet::from(["draw", "mesh", "run"]));
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
