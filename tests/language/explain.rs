//! Every diagnostic code is explained, and every explanation holds.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use hedgerow::analysis::Analysis;
use hedgerow::diagnostic::{explain, explained};
use hedgerow::source::Sources;

/// The codes of the diagnostics of a program.
fn codes(text: &str) -> Vec<&'static str> {
    let mut sources = Sources::new();
    let file = sources.add("explained.hedge", text);
    let analysis = Analysis::of(&sources, file);
    analysis.diagnostics.iter().map(|diagnostic| diagnostic.code).collect()
}

#[test]
fn every_program_shows_its_code() {
    let mut wrong = Vec::new();
    let mut shown = 0;
    for (code, _) in explained() {
        let text = explain(code).expect("a listed code is explained");
        let Some((_, program)) = text.split_once("```hedge\n") else {
            continue;
        };
        let (program, _) = program.split_once("\n```").expect("a program ends");
        shown += 1;
        let found = codes(program);
        if !found.contains(&code) {
            wrong.push(format!("{code}: {found:?}"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(shown > 60, "only {shown} programs");
}

/// All words in quotes that look like a code, in the files that make diagnostics.
fn written(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            written(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("a source file");
            let words = text.split('"').skip(1).step_by(2);
            let is_code = |word: &&str| {
                word.contains('-')
                    && word.chars().all(|c| c.is_ascii_lowercase() || c == '-')
                    && !word.starts_with('-')
            };
            found.extend(words.filter(is_code).map(String::from));
        }
    }
}

#[test]
fn every_code_is_explained() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = BTreeSet::new();
    for layer in ["syntax", "resolve", "check", "run", "emit", "analysis", "session"] {
        written(&source.join(layer), &mut found);
    }
    assert!(found.len() > 70, "only {} codes were found", found.len());
    let missing: Vec<_> = found.iter().filter(|code| explain(code).is_none()).collect();
    assert_eq!(missing, Vec::<&String>::new());
}
