//! The TextMate grammar colours what the lexer finds as what it is.
//!
//! Its patterns match within a line, the first at the earliest place; that is all of TextMate
//! that this reads, and a test holds the grammar to it.

use super::programs::{files, of_pages};
use hedgerow::diagram::Type;
use hedgerow::source::FileId;
use hedgerow::syntax::{Token, TokenKind, parse};
use regex::{Captures, Regex};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

const GRAMMAR: &str = include_str!("../../../grammar/hedgerow.tmLanguage.json");

/// A pattern, and the scopes of its match and of the groups of it.
struct Pattern {
    regex: Regex,
    scopes: BTreeMap<usize, String>,
}

fn patterns() -> Vec<Pattern> {
    let grammar: Value = serde_json::from_str(GRAMMAR).unwrap();
    let parts = grammar["patterns"].as_array().unwrap().iter();
    let names = parts.map(|part| part["include"].as_str().unwrap().trim_start_matches('#'));
    let parts = names.map(|name| grammar["repository"][name]["patterns"].as_array().unwrap());
    parts.flatten().map(pattern).collect()
}

fn pattern(written: &Value) -> Pattern {
    let known = ["match", "name", "captures"];
    let keys = written.as_object().unwrap().keys();
    assert!(keys.into_iter().all(|key| known.contains(&key.as_str())), "{written}");
    let mut scopes = BTreeMap::new();
    if let Some(name) = written["name"].as_str() {
        scopes.insert(0, name.to_owned());
    }
    for (group, capture) in written["captures"].as_object().into_iter().flatten() {
        scopes.insert(group.parse().unwrap(), capture["name"].as_str().unwrap().to_owned());
    }
    Pattern { regex: Regex::new(written["match"].as_str().unwrap()).unwrap(), scopes }
}

/// The scope of each byte of a text.
fn scopes(patterns: &[Pattern], text: &str) -> Vec<String> {
    let mut scopes = vec![String::new(); text.len()];
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let words = line.trim_end_matches(['\n', '\r']);
        let mut at = 0;
        while let Some((pattern, found)) = next(patterns, words, at) {
            for (&group, scope) in &pattern.scopes {
                let range = found.get(group).map_or(0..0, |group| group.range());
                for place in range {
                    scopes[start + place].clone_from(scope);
                }
            }
            at = found.get_match().end();
        }
        start += line.len();
    }
    scopes
}

fn next<'p, 't>(
    patterns: &'p [Pattern],
    line: &'t str,
    at: usize,
) -> Option<(&'p Pattern, Captures<'t>)> {
    let found = patterns.iter().filter_map(|pattern| {
        let captures = pattern.regex.captures_at(line, at)?;
        (!captures.get_match().is_empty()).then_some((pattern, captures))
    });
    found.min_by_key(|(_, captures)| captures.get_match().start())
}

/// What a token is coloured as, by the beginning of its scope.
fn expected(kind: TokenKind) -> &'static [&'static str] {
    match kind {
        TokenKind::True | TokenKind::False => &["constant.language"],
        TokenKind::Private => &["storage.modifier"],
        kind if kind.is_keyword() => &["keyword"],
        TokenKind::Int | TokenKind::Real => &["constant.numeric", "entity.name.tag"],
        TokenKind::Text => &["string"],
        TokenKind::Word => &["variable", "entity", "storage.type"],
        TokenKind::Dot => &["punctuation", ""],
        _ => &["keyword.operator", "punctuation", "entity.name.tag"],
    }
}

#[test]
fn every_token_of_every_program_is_coloured_as_what_it_is() {
    let patterns = patterns();
    let mut kinds = BTreeSet::new();
    let mut count = 0;
    for text in files().into_iter().chain(of_pages()) {
        let parsed = parse(FileId(0), &text);
        if !parsed.diagnostics.is_empty() {
            continue;
        }
        let scopes = scopes(&patterns, &text);
        for comment in &parsed.comments {
            let scope = &scopes[comment.span.start as usize];
            assert!(scope.starts_with("comment"), "{scope}: {}", comment.text(&text));
        }
        let mut in_text = false;
        for (at, token) in parsed.tokens.iter().enumerate() {
            // What stands in a text is coloured as text.
            match token.kind {
                TokenKind::TextHead => in_text = true,
                TokenKind::TextTail => in_text = false,
                _ => {}
            }
            if in_text || token.kind == TokenKind::TextTail {
                assert!(scopes[token.span.start as usize].starts_with("string"));
                continue;
            }
            let before = at.checked_sub(1).map(|before| parsed.tokens[before].kind);
            let word = &text[token.span.range()];
            let scope = &scopes[token.span.start as usize];
            // Behind a dot and as a type, a keyword is a word; a soft one may be a name, and
            // `hole(f)` is called.
            let declares = |after: &Token| {
                let between = &text[token.span.range().end..after.span.range().start];
                after.kind.is_keyword() && between.trim().is_empty() && !between.contains('\n')
            };
            let is_name = token.kind.is_soft()
                && (token.kind != TokenKind::Private
                    || !parsed.tokens.get(at + 1).is_some_and(declares));
            let is_word = before == Some(TokenKind::Dot)
                || scope.starts_with("storage.type")
                || is_name && scope.starts_with("variable")
                || token.kind == TokenKind::Hole && scope.starts_with("entity");
            let kind =
                if is_word && token.kind.is_wordlike() { TokenKind::Word } else { token.kind };
            let fits = expected(kind).iter().any(|start| scope.starts_with(start));
            assert!(fits, "`{word}` is coloured `{scope}` in\n{text}");
            kinds.insert(word.to_owned());
            count += 1;
        }
    }
    assert!(count > 5000, "only {count} tokens");
    let words = TokenKind::KEYWORDS.iter().map(|&(word, _)| word);
    let unseen: Vec<_> = words.filter(|&word| !kinds.contains(word)).collect();
    assert!(unseen.len() < 3, "in no program: {unseen:?}");
}

#[test]
fn every_keyword_is_named() {
    let patterns = patterns();
    for &(word, kind) in TokenKind::KEYWORDS {
        // Only before `attr`, the name of a test, a brace, and `for`.
        let text = match kind {
            TokenKind::Private => "private attr".to_owned(),
            TokenKind::Test => "test \"\"".to_owned(),
            TokenKind::Steps => "steps {".to_owned(),
            TokenKind::Parallel => "parallel for".to_owned(),
            _ => word.to_owned(),
        };
        let scope = &scopes(&patterns, &text)[0];
        let fits = expected(kind).iter().any(|start| scope.starts_with(start));
        assert!(fits, "`{word}` is coloured `{scope}`");
        let primed = format!("{word}'");
        assert_eq!(scopes(&patterns, &primed)[0], "variable.other.hedgerow", "{primed}");
    }
}

#[test]
fn every_type_is_coloured() {
    let patterns = patterns();
    for ty in Type::ALL {
        let text = format!("fn f(x: {ty}) -> {ty} {{ }}", ty = ty.word());
        let scopes = scopes(&patterns, &text);
        for (at, word) in text.match_indices(ty.word()).filter(|(at, _)| *at > 4) {
            assert_eq!(scopes[at], "storage.type.hedgerow", "{word} in {text}");
        }
    }
}

#[test]
fn emacs_colours_every_keyword() {
    let mode = include_str!("../../../editors/emacs/hedgerow-mode.el");
    let list =
        mode.split("(defconst hedgerow-keywords").nth(1).unwrap().split("))").next().unwrap();
    let listed: BTreeSet<_> = list.split('"').skip(1).step_by(2).collect();
    let words = TokenKind::KEYWORDS.iter().map(|&(word, _)| word);
    assert_eq!(listed, words.collect::<BTreeSet<_>>());
}
