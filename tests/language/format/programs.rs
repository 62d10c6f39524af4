//! Every program of this repository.

use super::formatted;
use std::fs;
use std::path::{Path, PathBuf};

fn files_below(folder: &Path, end: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_below(&path, end, found);
        } else if path.extension().is_some_and(|extension| extension == end) {
            found.push(path);
        }
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The programs of the pages of all tests, whatever is wrong with them.
pub fn of_pages() -> Vec<String> {
    let mut pages = Vec::new();
    files_below(&root().join("tests"), "md", &mut pages);
    pages.sort();
    let texts = pages.iter().map(|page| fs::read_to_string(page).unwrap());
    let programs = texts.flat_map(|text| {
        let fences = text.split("```hedge\n").skip(1);
        let inside = fences.filter_map(|rest| Some(rest.split_once("```")?.0.to_owned()));
        inside.collect::<Vec<_>>()
    });
    programs.collect()
}

#[test]
fn examples_are_formatted() {
    let mut files = Vec::new();
    for folder in ["examples", "src/library/std"] {
        files_below(&root().join(folder), "hedge", &mut files);
    }
    assert!(files.len() >= 8, "only {} files", files.len());
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        assert!(formatted(&text) == text, "`hedgerow fmt {}` would change it", file.display());
    }
}

#[test]
fn programs_of_pages_keep_their_words() {
    let programs = of_pages();
    assert!(programs.len() > 200, "only {} programs", programs.len());
    let changed = programs.iter().filter(|text| formatted(text) != **text);
    assert!(changed.count() > 20);
}
