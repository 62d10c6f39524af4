//! Pages: a program, and beneath it all that is said about it.
//!
//! With `UPDATE_PAGES=1` the expectations are written anew; read the difference.

use std::fs;
use std::path::Path;

use crate::resolve::told::told;

const PROGRAM: &str = "```hedge\n";
const TOLD: &str = "```text\n";
const END: &str = "```\n";

/// The page with what is really said, and the headings of the cases that differ.
fn rewritten(page: &str) -> (String, Vec<String>, usize) {
    let mut out = String::new();
    let (mut rest, mut wrong, mut cases) = (page, Vec::new(), 0);
    while let Some((head, tail)) = rest.split_once(PROGRAM) {
        let (program, tail) = tail.split_once(END).expect("a program ends");
        let told = told(program);
        let between = tail.trim_start();
        let expected = between.strip_prefix(TOLD);
        let (expected, tail) = match expected {
            Some(expected) => expected.split_once(END).expect("an expectation ends"),
            None => ("", tail),
        };
        if expected != told {
            let heading = head.lines().rfind(|line| line.starts_with('#'));
            wrong.push(format!(
                "{}\nexpected:\n{expected}told:\n{told}",
                heading.unwrap_or("the first case")
            ));
        }
        out += &format!("{head}{PROGRAM}{program}{END}");
        if !told.is_empty() {
            out += &format!("\n{TOLD}{told}{END}");
        }
        rest = tail;
        cases += 1;
    }
    (out + rest, wrong, cases)
}

fn check(name: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/language/resolve").join(name);
    let page = fs::read_to_string(&path).expect("the page is there");
    let (out, wrong, cases) = rewritten(&page);
    assert!(cases > 0, "a page has cases");
    if std::env::var_os("UPDATE_PAGES").is_some() {
        fs::write(&path, out).expect("the page can be written");
    } else {
        assert!(wrong.is_empty(), "{name}:\n{}", wrong.join("\n"));
    }
}

#[test]
fn families() {
    check("families.md");
}

#[test]
fn items() {
    check("items.md");
}

#[test]
fn rules() {
    check("rules.md");
}

#[test]
fn names() {
    check("names.md");
}

#[test]
fn drawings() {
    check("drawings.md");
}

#[test]
fn conditions() {
    check("conditions.md");
}

#[test]
fn expressions() {
    check("expressions.md");
}

#[test]
fn attributes() {
    check("attributes.md");
}

#[test]
fn scripts() {
    check("scripts.md");
}

#[test]
fn functions() {
    check("functions.md");
}

#[test]
fn tests() {
    check("tests.md");
}
