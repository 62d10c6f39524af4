//! The pages for people: the reference names every diagnostic there is, and no other; the
//! ops that it and the README show are proved, and what is said of the broken one is said.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use hedgerow::analysis::Analysis;
use hedgerow::diagnostic::{Rendering, render};
use hedgerow::format::format;
use hedgerow::source::{FileId, Sources};
use hedgerow::syntax::parse;

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

/// The texts in quotes that are a code: words in lower case, joined by hyphens.
fn codes(folder: &Path, found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            codes(&path, found);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let (text, _) = text.split_once("#[cfg(test)]").unwrap_or((&text, ""));
        let is_code = |text: &&str| {
            text.contains('-')
                && text
                    .split('-')
                    .all(|word| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase()))
        };
        for line in text.lines() {
            let quoted = line.split('"').skip(1).step_by(2);
            found.extend(quoted.filter(is_code).map(String::from));
        }
    }
}

#[test]
fn every_code_is_in_the_reference() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut known = BTreeSet::from(["interrupted".to_owned()]);
    for layer in ["analysis", "check", "compile", "emit", "resolve", "run", "session", "syntax"] {
        codes(&root.join("src").join(layer), &mut known);
    }
    let page = read("grammar/reference.md");
    let (_, section) = page.split_once("\n## Diagnostics\n").unwrap();
    let (section, _) = section.split_once("\n## ").unwrap_or((section, ""));
    let rows = section.lines().filter_map(|line| line.strip_prefix("| `"));
    let listed: BTreeSet<_> =
        rows.filter_map(|row| Some(row.split_once('`')?.0.to_owned())).collect();
    let missing: Vec<_> = known.difference(&listed).collect();
    let invented: Vec<_> = listed.difference(&known).collect();
    assert!(missing.is_empty(), "not in the reference: {missing:?}");
    assert!(invented.is_empty(), "in no source: {invented:?}");
}

/// What stands between a line of ticks and the next.
fn fences(page: &str) -> Vec<String> {
    let parts = page.split("\n```").skip(1).step_by(2);
    parts.filter_map(|fence| Some(fence.split_once('\n')?.1.to_owned() + "\n")).collect()
}

fn said(name: &str, text: &str) -> String {
    let mut sources = Sources::new();
    let file = sources.add(name, text);
    let analysis = Analysis::of(&sources, file);
    let how = Rendering { colour: false, most: usize::MAX };
    render(&analysis.diagnostics, &sources, how)
}

#[test]
fn the_ops_of_the_pages_are_proved_but_for_the_broken_one() {
    let (mut proved, mut broken) = (0, 0);
    for name in ["grammar/reference.md", "README.md"] {
        let fences = fences(&read(name));
        for (at, text) in fences.iter().enumerate() {
            if !(text.contains("op ") && text.contains("before {")) || text.contains("error[") {
                continue;
            }
            let next = fences.get(at + 1).map_or("", String::as_str);
            match next.strip_prefix("$ hedgerow check broken.hedge\n") {
                Some(shown) => {
                    assert_eq!(said("broken.hedge", text).trim_end(), shown.trim_end());
                    broken += 1;
                }
                None => {
                    assert_eq!(said(name, text), "");
                    proved += 1;
                }
            }
        }
    }
    assert!(proved >= 3, "{proved} drawings in the pages");
    assert_eq!(broken, 1);
}

#[test]
fn the_programs_of_the_pages_are_formatted() {
    let mut count = 0;
    for name in ["grammar/reference.md", "README.md"] {
        for text in fences(&read(name)) {
            if !parse(FileId(0), &text).diagnostics.is_empty() {
                continue;
            }
            assert_eq!(format(FileId(0), &text).unwrap().text, text, "{name}");
            count += 1;
        }
    }
    assert!(count > 10, "only {count} programs");
}

#[test]
fn the_tests_of_the_readme_pass() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("refine.hedge");
    let fences = fences(&read("README.md"));
    let [program] = fences.iter().filter(|text| text.contains("\ntest \"")).collect::<Vec<_>>()[..]
    else {
        panic!("one program with tests");
    };
    fs::write(&path, program).unwrap();
    for arguments in [["test"].as_slice(), &["fmt", "--check"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_hedgerow"));
        let done = command.args(arguments).arg(&path).output().unwrap();
        assert!(done.status.success(), "{arguments:?}: {done:?}");
    }
}
