//! A closing brace that is taken away from a program: the fix gives the same program again.

use std::fs;

use hedgerow::source::FileId;
use hedgerow::syntax::{TokenKind, parse};

/// The text with the fix that closes a block, if there is one.
fn closed(text: &str) -> Option<String> {
    let told = parse(FileId(0), text).diagnostics;
    let fix = told.iter().flat_map(|told| &told.fixes).find(|fix| fix.title == "close it here")?;
    let [edit] = fix.edits.as_slice() else { panic!("{fix:?}") };
    let mut text = text.to_owned();
    text.replace_range(edit.span.range(), &edit.text);
    Some(text)
}

fn words(text: &str) -> String {
    text.split_whitespace().collect()
}

#[test]
fn a_brace_that_is_taken_away_comes_back() {
    let folders = ["examples", "src/library/std"];
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let files = files.map(|entry| entry.unwrap().path());
    let (mut taken, mut back) = (0, 0);
    let mut wrong = Vec::new();
    for file in files.filter(|file| file.extension().is_some_and(|end| end == "hedge")) {
        let text = fs::read_to_string(&file).unwrap();
        for token in parse(FileId(0), &text).tokens {
            if token.kind != TokenKind::RightBrace {
                continue;
            }
            let mut broken = text.clone();
            broken.replace_range(token.span.range(), "");
            taken += 1;
            if let Some(closed) = closed(&broken) {
                back += 1;
                if words(&closed) != words(&text) {
                    let line = text[..token.span.start as usize].lines().count();
                    wrong.push(format!("{}:{line}", file.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(back * 10 > taken * 9, "only {back} of {taken}");
}
