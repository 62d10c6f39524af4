//! Each law of the checker, broken alone: what is said of it, in full.
//!
//! A page has the name of the file of its law. Every code that a law may give stands on its
//! page, or in the list of those that no drawing can reach.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use hedgerow::analysis::Analysis;
use hedgerow::diagnostic::{Diagnostic, Rendering, render};
use hedgerow::source::Sources;

#[test]
fn every_law_says_how_it_is_broken() {
    let count = support::pages::check("proof/laws", |case| {
        assert_eq!(case.kind, "text", "{}", case.place);
        let mut sources = Sources::new();
        let file = sources.add("broken.hedge", case.input);
        let analysis = Analysis::of(&sources, file);
        assert!(!analysis.is_sound(), "{}: nothing is wrong", case.place);
        let how = Rendering { colour: false, most: usize::MAX };
        let errors = analysis.diagnostics.iter().filter(|said| said.is_error());
        let errors: Vec<Diagnostic> = errors.cloned().collect();
        render(&errors, &sources, how)
    });
    assert!(count > 20, "only {count} cases");
}

#[test]
fn every_law_has_its_page() {
    let laws = [
        "names_are_accounted_for",
        "next_is_permutation",
        "twin_is_involution",
        "nothing_dangles",
        "ends_agree",
        "vertices_are_orbits",
        "new_is_placed",
        "properties",
        "reach",
    ];
    for law in laws {
        assert!(root().join(format!("src/check/{law}.rs")).exists(), "{law} is no law");
        assert!(root().join(format!("tests/proof/laws/{law}.md")).exists(), "{law} has no page");
    }
}

#[test]
fn every_code_of_the_laws_is_shown() {
    let mut shown = BTreeSet::new();
    for page in files("tests/proof/laws", "md") {
        shown.extend(codes(&page, "error[", ']'));
    }
    let mut known = BTreeSet::new();
    for text in files("src/check", "rs") {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let text = text.replace("error( \"", "error(\"");
        known.extend(codes(&text, "Diagnostic::error(\"", '"'));
    }
    assert!(known.len() > 15, "{known:?}");
    let missing: Vec<_> = known.difference(&shown).collect();
    assert!(missing.is_empty(), "no page shows {missing:?}");
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn files(folder: &str, end: &str) -> Vec<String> {
    let entries = fs::read_dir(root().join(folder)).unwrap();
    entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|found| found == end))
        .map(|path| fs::read_to_string(path).unwrap())
        .collect()
}

/// What stands between `open` and `close`, wherever it does.
fn codes(text: &str, open: &str, close: char) -> Vec<String> {
    let parts = text.split(open).skip(1);
    parts.filter_map(|part| Some(part.split_once(close)?.0.to_owned())).collect()
}
