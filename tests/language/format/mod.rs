//! What the formatter makes of texts: pages, every program of this repository, and noise.

mod noise;
mod programs;

use std::ops::Range;

use hedgerow::format::{Edit, edits, edits_of_lines, format};
use hedgerow::source::FileId;
use hedgerow::syntax::parse;

/// What formatting changes in a text.
fn all_edits(text: &str) -> Vec<Edit> {
    let file = FileId(0);
    edits(file, text, &parse(file, text)).unwrap()
}

/// What it changes on some lines.
fn line_edits(text: &str, lines: Range<usize>) -> Vec<Edit> {
    let file = FileId(0);
    edits_of_lines(file, text, &parse(file, text), lines).unwrap()
}

/// A text formatted; a refusal is a mistake of the formatter.
fn formatted(text: &str) -> String {
    match format(FileId(0), text) {
        Ok(formatted) => formatted.text,
        Err(refusal) => panic!("{refusal} ({refusal:?}):\n{text}"),
    }
}

/// A text with some of its white space exchanged.
fn edited(text: &str, edits: &[Edit]) -> String {
    let mut edited = text.to_owned();
    for edit in edits.iter().rev() {
        assert!(text[edit.range.clone()].trim().is_empty(), "{edit:?}");
        edited.replace_range(edit.range.clone(), &edit.text);
    }
    edited
}

#[test]
fn pages_hold() {
    let count = support::pages::check("language/format", |case| {
        let answer = match case.kind {
            "formatted" => formatted(case.input),
            "lines-2-to-3" => edited(case.input, &line_edits(case.input, 1..3)),
            kind => panic!("{}: what is `{kind}`?", case.place),
        };
        if case.kind == "formatted" {
            assert_eq!(edited(case.input, &all_edits(case.input)), answer);
        }
        answer
    });
    assert!(count >= 12, "only {count} cases");
}

#[test]
fn line_ends_and_the_byte_order_mark_stay() {
    let text = "\u{FEFF}// a\r\nattr  x:vertex real // b\r\n\r\n\r\nuse\"c\"";
    let expected = "\u{FEFF}// a\r\nattr x: vertex real  // b\r\n\r\nuse \"c\"\r\n";
    assert_eq!(formatted(text), expected);
    assert_eq!(formatted(""), "");
    assert_eq!(formatted(" \n\t\n"), "");
    assert_eq!(formatted("\n\n// a\n\n\n// b"), "// a\n\n// b\n");
}

#[test]
fn edits_are_small() {
    let text = "op flip(e: edge) {\n  before { edge e: a | b }\n  after {  edge e: b | a }\n}\n";
    let edits = all_edits(text);
    assert_eq!(edits.len(), 1);
    assert_eq!(&text[edits[0].range.clone()], "  ");
    assert_eq!(edits[0].text, " ");
}
