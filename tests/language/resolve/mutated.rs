//! Programs with one word missing or in the place of another: whatever comes of it, it
//! is told.

use hedgerow::resolve::resolve;
use hedgerow::source::Sources;
use hedgerow::syntax::parse;

use crate::resolve::examples::PROGRAM;

/// Resolves a text that may not parse, and asserts that no item is lost in silence.
/// Says whether the program is whole.
fn is_whole(text: &str) -> bool {
    let file = Sources::new().add("test.hedge", text);
    let parsed = parse(file, text);
    let resolved = resolve(&parsed.tree);
    let all = parsed.diagnostics.iter().chain(&resolved.diagnostics);
    let errors = all.filter(|diagnostic| diagnostic.is_error()).count();
    let ops = &resolved.program.ops;
    let whole = ops.iter().all(|op| op.diagram.is_some()) && resolved.program.scripts.len() == 1;
    if errors == 0 {
        assert!(whole, "an item is lost in silence:\n{text}");
    }
    if parsed.diagnostics.is_empty() && errors > 0 {
        assert!(!whole, "an item with an error is there:\n{text}");
    }
    whole
}

/// The words of a text, as ranges of bytes.
fn words(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut words: Vec<std::ops::Range<usize>> = Vec::new();
    for (at, c) in text.char_indices() {
        let end = at + c.len_utf8();
        let in_word = c.is_alphanumeric() || c == '_' || c == '\'';
        match words.last_mut() {
            Some(last) if in_word && last.end == at => last.end = end,
            _ if in_word => words.push(at..end),
            _ => {}
        }
    }
    words
}

fn replaced(range: std::ops::Range<usize>, word: &str) -> String {
    let mut text = PROGRAM.to_owned();
    text.replace_range(range, word);
    text
}

#[test]
fn without_a_word() {
    assert!(is_whole(PROGRAM));
    let lost = words(PROGRAM).into_iter();
    let lost = lost.filter(|word| !is_whole(&replaced(word.clone(), "")));
    assert!(lost.count() > 300);
}

#[test]
fn with_a_word_in_the_place_of_another() {
    let all = words(PROGRAM);
    let mut lost = 0;
    for (number, word) in all.iter().enumerate() {
        let other = all[(number * 7 + 13) % all.len()].clone();
        let text = replaced(word.clone(), &PROGRAM[other]);
        lost += usize::from(!is_whole(&text));
    }
    assert!(lost > 200);
}
