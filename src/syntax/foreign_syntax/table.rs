//! The table of foreign forms and their equivalents here, `table.txt`, which tells how it is read.

use super::pattern::Pattern;
use super::place::{ANY, CODE, DRAWING, HEAD, PARAMETERS, PARTS, Places};
use crate::syntax::token::TokenKind;
use logos::Logos;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::LazyLock;

/// The lines of the table, in the order in which they are tried.
const TABLE: &str = include_str!("table.txt");

/// A piece of a template, which replaces a pattern.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Its place in the template.
    pub place: Range<usize>,
    /// The name of the hole, if it is one.
    pub hole: Option<&'static str>,
    /// Its token kind and its text.
    pub kind: TokenKind,
    pub word: &'static str,
}

/// A foreign form.
#[derive(Debug)]
pub(super) struct Form {
    pub place: Places,
    pub says: &'static str,
    seen: Pattern,
    ours: Vec<Piece>,
    fix: Option<(Vec<Piece>, &'static str)>,
}

impl Form {
    /// A line of the table behind its sign; where the fix `is_certain`, it is the last part.
    fn of(place: Places, says: &'static str, line: &'static str, is_certain: bool) -> Self {
        let mut parts = line.split("==>").map(str::trim);
        let [seen, ours] = [(); 2].map(|()| parts.next().unwrap_or_default());
        let fix = parts.next().or(is_certain.then_some(ours));
        let ours = pieces(ours);
        let is_ours = |piece: &Piece| {
            piece.hole.is_some()
                || piece.kind.spelling().is_some()
                || piece.kind == TokenKind::Int
                || piece.word == "main"
        };
        debug_assert!(ours.iter().all(is_ours), "`{line}` is not of the language");
        Self { place, says, seen: Pattern::of(seen), ours, fix: fix.map(|fix| (pieces(fix), fix)) }
    }

    /// The pattern that matches it.
    pub(super) fn seen(&self) -> &Pattern {
        &self.seen
    }

    /// The pieces with which the rest of the item is parsed.
    pub(super) fn ours(&self) -> &[Piece] {
        &self.ours
    }

    /// The pieces of the fix and its template; empty if there is no fix.
    pub(super) fn fix(&self) -> (&[Piece], &'static str) {
        self.fix.as_ref().map_or((&[], ""), |(pieces, template)| (pieces, template))
    }

    /// True if there is a fix.
    pub(super) fn is_sure(&self) -> bool {
        self.fix.is_some()
    }

    /// True if the rest of the item may not be parsed as it was meant.
    pub(super) fn ends(&self) -> bool {
        self.fix.as_ref().is_none_or(|(fix, _)| fix.len() != self.ours.len())
    }

    /// The holes in the message.
    pub(super) fn holes_of_says(&self) -> impl Iterator<Item = &'static str> {
        pieces(self.says).into_iter().filter_map(|piece| piece.hole)
    }
}

/// The parsed table.
pub(super) fn forms() -> &'static [Form] {
    static FORMS: LazyLock<Vec<Form>> = LazyLock::new(|| {
        let (mut place, mut says) = (ANY, "");
        let forms = TABLE.lines().filter_map(|line| {
            let (sign, rest) = line.split_once(' ').unwrap_or((line, ""));
            match sign {
                ":" => says = rest,
                "+" | "-" => return Some(Form::of(place, says, rest, sign == "+")),
                _ if line.starts_with('[') => place = places(line),
                _ => {}
            }
            None
        });
        forms.collect()
    });
    &FORMS
}

/// The places in brackets.
fn places(line: &str) -> Places {
    let words = line.trim_matches(['[', ']']).split(' ');
    words.fold(0, |places, word| {
        places
            | match word {
                "head" => HEAD,
                "parts" => PARTS,
                "drawing" => DRAWING,
                "code" => CODE,
                "parameters" => PARAMETERS,
                _ => ANY,
            }
    })
}

/// The numbers of the forms that can begin with a token of this spelling, in order.
pub(super) fn forms_from(word: &str) -> &'static [usize] {
    static BY_WORD: LazyLock<HashMap<&str, Vec<usize>>> = LazyLock::new(|| {
        let numbers = |word: &str| {
            let can_begin =
                |form: &Form| form.seen.first_words().is_none_or(|all| all.contains(&word));
            (0..forms().len()).filter(|&number| can_begin(&forms()[number])).collect()
        };
        let words = forms().iter().filter_map(|form| form.seen.first_words()).flatten();
        // Under no word, those that begin with any.
        words.copied().chain([""]).map(|word| (word, numbers(word))).collect()
    });
    BY_WORD.get(word).or_else(|| BY_WORD.get("")).map(Vec::as_slice).unwrap_or_default()
}

fn pieces(template: &'static str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut at = 0;
    while let Some(rest) = template.get(at..).filter(|rest| !rest.is_empty()) {
        let skipped = rest.len() - rest.trim_start().len();
        if skipped > 0 {
            at += skipped;
            continue;
        }
        let hole = rest.strip_prefix('$').map(|hole| {
            let end = hole.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(hole.len());
            &hole[..end]
        });
        let hole = hole.filter(|hole| !hole.is_empty());
        let (kind, length) = match hole {
            Some(hole) => (TokenKind::Word, hole.len() + 1),
            None => {
                let until = rest.find(['$', ' ']).filter(|&until| until > 0);
                let mut lexer = TokenKind::lexer(&rest[..until.unwrap_or(rest.len())]);
                let kind = lexer.next().and_then(Result::ok).unwrap_or(TokenKind::Word);
                (kind, lexer.slice().len().max(rest.chars().next().map_or(1, char::len_utf8)))
            }
        };
        let place = at..at + length;
        pieces.push(Piece { word: &template[place.clone()], place, hole, kind });
        at += length;
    }
    pieces
}
