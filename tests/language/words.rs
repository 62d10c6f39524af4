//! Words of the language: each is explained, and one is offered where another is meant.

use hedgerow::analysis::{MEANINGS, functions, meaning, word};
use hedgerow::diagram::{Property, Type};
use hedgerow::resolve::{closest, fields, function_words, mesh_and_constant_words, sequence_words};
use hedgerow::syntax::{TokenKind, parse};

#[test]
fn every_word_is_explained() {
    let types = Type::ALL.iter().map(|ty| ty.word());
    let fields = Type::ALL.iter().flat_map(|ty| fields(*ty)).map(|field| field.name);
    let keywords = TokenKind::KEYWORDS.iter().map(|(word, _)| *word);
    let properties = Property::ALL.iter().map(|property| property.word());
    let mut count = 0;
    for word in keywords
        .chain(function_words())
        .chain(mesh_and_constant_words())
        .chain(sequence_words())
        .chain(types)
        .chain(fields)
        .chain(properties)
        .chain(["map", "surface", "simple"])
    {
        let found = meaning(word).unwrap_or_default();
        assert!(!found.is_empty(), "`{word}` is not explained");
        count += 1;
    }
    assert!(count > 150, "only {count} words");
}

#[test]
fn every_function_is_explained_once() {
    let functions = functions();
    assert!(functions.len() > 50, "{functions:?}");
    for name in functions {
        let found = word(name).expect("a function is a word");
        assert!(!found.forms.is_empty(), "{name} is called somehow");
        assert!(!found.meaning.is_empty(), "{name} means something");
    }
    let mut words: Vec<_> = MEANINGS.iter().map(|(word, _)| *word).collect();
    words.sort_unstable();
    let all = words.len();
    words.dedup();
    assert_eq!(words.len(), all, "a word has one meaning");
}

#[test]
fn a_third_of_the_letters_may_differ() {
    let words = ["length", "link_condition", "v0"];
    assert_eq!(closest("lenght", words), Some("length"));
    assert_eq!(closest("linkcondition", words), Some("link_condition"));
    assert_eq!(closest("v1", words), None, "too short to guess");
    assert_eq!(closest("width", words), None);
}

/// A meaning quotes the language: each quoted piece can be read where it would stand.
#[test]
fn what_a_meaning_quotes_can_be_read() {
    const AROUND: [(&str, &str); 7] = [
        ("", ""),
        ("script s() { ", " }"),
        ("script s() { let x = ", " }"),
        ("script s() { print \"", "\" }"),
        ("op t(e: edge) { ", " }"),
        ("op t(e: edge) { before { ", " } after { } }"),
        ("op t(e: edge) { before { } ", " after { } }"),
    ];
    let (mut count, mut unread) = (0, Vec::new());
    for (word, meaning) in MEANINGS.iter() {
        for quoted in meaning.split('`').skip(1).step_by(2) {
            let written = quoted.replace("where …", "where true");
            let written = written.replace(": …", ": v -a-> w -b-> v").replace('…', "");
            let is_read = |(before, after): &(&str, &str)| {
                let text = format!("{before}{written}{after}");
                parse(Default::default(), &text).diagnostics.is_empty()
            };
            let is_part = ["*", "=", "->"].contains(&quoted)
                || TokenKind::KEYWORDS.iter().any(|(known, _)| *known == quoted);
            if !is_part && !AROUND.iter().any(is_read) {
                unread.push(format!("{word}: `{quoted}`"));
            }
            count += 1;
        }
    }
    assert_eq!(unread, Vec::<String>::new());
    assert!(count > 60, "only {count}");
}
