//! The written grammar and the lexer know the same words.

use hedgerow::syntax::TokenKind;
use std::collections::BTreeSet;

const GRAMMAR: &str = include_str!("../../../grammar/hedgerow.ebnf");

/// What the grammar quotes, outside of its comments.
fn quoted() -> BTreeSet<&'static str> {
    let mut rest = GRAMMAR;
    let mut found = BTreeSet::new();
    while let Some(at) = rest.find(['"', '\'', '(']) {
        let (mark, behind) = rest[at..].split_at(1);
        if mark == "(" {
            let comment = behind.strip_prefix('*');
            rest = comment.map_or(behind, |inside| inside.split_once("*)").unwrap().1);
            continue;
        }
        let (word, after) = behind.split_once(mark).unwrap();
        found.insert(word);
        rest = after;
    }
    found
}

#[test]
fn keywords_are_those_of_the_lexer() {
    let is_word = |word: &&str| word.chars().all(|c| c.is_ascii_lowercase()) && word.len() > 1;
    let written: BTreeSet<_> = quoted().into_iter().filter(is_word).collect();
    let keywords = TokenKind::KEYWORDS.iter().map(|&(word, _)| word);
    let formats = ["full"]; // of values in a text: no word elsewhere
    let known: BTreeSet<_> = keywords.chain(formats).collect();
    assert_eq!(written, known);
}

#[test]
fn every_mark_of_the_lexer_is_written() {
    let written = quoted();
    for (mark, _) in TokenKind::MARKS {
        assert!(written.contains(mark), "`{mark}` is not in the grammar");
    }
}
