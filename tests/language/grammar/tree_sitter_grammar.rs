//! The grammar for tree-sitter reads what hedgerow reads, and its queries fit its trees.

use super::programs::{files, is_known_to_differ, is_read, mutated, of_pages};
use hedgerow::syntax::TokenKind;
use std::collections::BTreeSet;
use support::dice::Dice;
use tree_sitter::{Language, Parser, Query, QueryCursor, StreamingIterator};

fn language() -> Language {
    tree_sitter_hedgerow::LANGUAGE.into()
}

fn reader() -> Parser {
    let mut parser = Parser::new();
    parser.set_language(&language()).unwrap();
    parser
}

/// Whether both read a text, after they have been found to agree.
fn both_read(parser: &mut Parser, text: &str) -> bool {
    let Some(read) = is_read(text) else {
        return false;
    };
    let tree = parser.parse(text, None).unwrap();
    let here = !tree.root_node().has_error();
    assert_eq!(
        here,
        read,
        "tree-sitter says {here}, hedgerow {read}:\n{text}\n{}",
        tree.root_node()
    );
    read
}

#[test]
fn keywords_are_those_of_the_lexer() {
    let language = language();
    let kinds = 0..u16::try_from(language.node_kind_count()).unwrap();
    let is_word = |kind: &&str| kind.chars().all(|c| c.is_ascii_lowercase());
    let known = kinds
        .filter(|&kind| !language.node_kind_is_named(kind))
        .filter_map(|kind| language.node_kind_for_id(kind))
        .filter(is_word);
    let mut known: BTreeSet<_> = known.collect();
    // Statements and values of one word are nodes with that name.
    known.extend(["break", "continue", "true", "false"]);
    known.remove("end");
    let words: BTreeSet<_> = TokenKind::KEYWORDS.iter().map(|&(word, _)| word).collect();
    assert_eq!(known, words);
    let mut reader = reader();
    for word in words {
        both_read(&mut reader, &format!("script {word}() {{ let {word} = {word} }}"));
        let fields = format!("script s() {{ x.{word} = y.{word} }} attr a: {word} {word}");
        assert!(both_read(&mut reader, &fields), "{word}");
    }
}

#[test]
fn every_program_is_read_exactly_when_hedgerow_reads_it() {
    let mut reader = reader();
    let (files, pages) = (files(), of_pages());
    assert!(files.len() >= 8 && pages.len() > 200);
    for text in &files {
        assert!(both_read(&mut reader, text), "{text}");
    }
    let alike = pages.iter().filter(|text| !is_known_to_differ(text));
    let read = alike.filter(|text| both_read(&mut reader, text));
    assert!(read.count() > 150);
}

#[test]
fn changed_programs_are_read_exactly_when_hedgerow_reads_them() {
    let mut reader = reader();
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut programs = of_pages();
    programs.retain(|text| is_read(text) == Some(true) && text.len() < 2000);
    let mut read = 0;
    for round in 0..3000 {
        let mut text = programs[round % programs.len()].clone();
        for _ in 0..=dice.below(2) {
            text = mutated(&text, &mut dice);
        }
        if is_known_to_differ(&text) {
            continue;
        }
        read += usize::from(both_read(&mut reader, &text));
    }
    assert!((150..2700).contains(&read), "{read} of 3000 are read");
}

#[test]
fn numbers_and_texts_are_told_apart_as_by_the_lexer() {
    let mut reader = reader();
    let words = [
        "1", "1.5", "1e3", "1e-3", "2E+5", "4g3", "4e3x", "1.5x", "1_0", "1.e", "1e", "1.5e3",
        "1.", ".5", "\"a\"", "\"\\n\"", "\"\\q\"", "\"a", "x'", "x''y", "v[0](1)", "v[i](1)",
        "f (1)", "(v)(1)",
    ];
    let read = words.iter().filter(|word| {
        let value = both_read(&mut reader, &format!("script s() {{ let x = {word} }}"));
        both_read(&mut reader, &format!("script s() {{ {word} {word} }}"));
        value
    });
    assert_eq!(read.count(), 13);
}

#[test]
fn queries_fit() {
    let language = language();
    let text = files().join("\n");
    let tree = reader().parse(&text, None).unwrap();
    for (name, query) in [
        ("highlights", tree_sitter_hedgerow::HIGHLIGHTS_QUERY),
        ("folds", tree_sitter_hedgerow::FOLDS_QUERY),
        ("locals", tree_sitter_hedgerow::LOCALS_QUERY),
        ("indents", tree_sitter_hedgerow::INDENTS_QUERY),
    ] {
        let query = Query::new(&language, query).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut cursor = QueryCursor::new();
        let mut matches = cursor.matches(&query, tree.root_node(), text.as_bytes());
        let mut count = 0;
        while matches.next().is_some() {
            count += 1;
        }
        assert!(count > 100, "{name} matches {count} times");
    }
}

#[test]
fn every_keyword_is_coloured() {
    let highlights = tree_sitter_hedgerow::HIGHLIGHTS_QUERY;
    for (word, _) in TokenKind::KEYWORDS {
        let (quoted, node) = (format!("\"{word}\""), format!("({word})"));
        let named = highlights.contains(&quoted) || highlights.contains(&node);
        assert!(named, "`{word}` has no colour");
    }
}
