//! The table of foreign forms and their equivalents here. [`pattern`](super::pattern) describes the
//! syntax of patterns; of several that match, the first counts.
//!
//! In a message, `{}` stands for the text of the first literal element of the pattern, and `$a` for
//! the text of the hole of that name.

mod assignments;
mod code;
mod items;
mod lists;
mod loops;
mod parts;
mod signs;
mod statements;
mod values;
mod variables;

use super::pattern::Pattern;
use super::place::{ANY, CODE, DRAWING, HEAD, PARTS, Places};
use crate::syntax::token::TokenKind;
use logos::Logos;
use std::collections::HashMap;
use std::ops::Range;
use std::sync::LazyLock;

/// A line of the table.
struct Line {
    /// Where it stands, if not where the other lines of its list do.
    place: Option<Places>,
    seen: &'static str,
    ours: &'static str,
    fix: Option<&'static str>,
    says: &'static str,
}

/// A form whose meaning is certain; `ours` is both the fix and what the rest is parsed with.
const fn sure(seen: &'static str, ours: &'static str, says: &'static str) -> Line {
    Line { place: None, seen, ours, fix: Some(ours), says }
}

/// A form whose meaning is certain, but whose `fix` differs from `ours`, with which the rest of the
/// item is parsed.
const fn fixed(
    seen: &'static str,
    ours: &'static str,
    fix: &'static str,
    says: &'static str,
) -> Line {
    Line { place: None, seen, ours, fix: Some(fix), says }
}

/// A form without a fix; the rest of the item is parsed as if it were `ours`.
const fn told(seen: &'static str, ours: &'static str, says: &'static str) -> Line {
    Line { place: None, seen, ours, fix: None, says }
}

impl Line {
    /// The same form in other places.
    const fn at(self, place: Places) -> Self {
        Self { place: Some(place), ..self }
    }
}

const STEPS: &str = "an op is drawn, `before { … } after { … }`; one that calls others has `steps { … }`, and a script or `fn` statements of any kind";
const VALUES: &str =
    "a drawing has no variables: a value is written where it is used, or computed by a `fn`";
const TYPED: &str = "a type stands behind its name: `$n: $t`";

/// The lines of the table, in the order in which they are tried, each list with the places where
/// its lines stand.
const LINES: &[(Places, &[Line])] = &[
    (ANY, signs::LINES),
    (HEAD, items::LINES),
    (PARTS, parts::LINES),
    (DRAWING, lists::LINES),
    (DRAWING, statements::LINES),
    (DRAWING, assignments::LINES),
    (CODE, loops::LINES),
    (CODE, variables::LINES),
    (CODE, code::LINES),
    (CODE | PARTS, values::LINES),
    (ANY, signs::ENDS),
];

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
    fn of(place: Places, line: &Line) -> Self {
        let ours = pieces(line.ours);
        let is_ours = |piece: &Piece| {
            piece.hole.is_some()
                || piece.kind.spelling().is_some()
                || piece.kind == TokenKind::Int
                || piece.word == "main"
        };
        debug_assert!(ours.iter().all(is_ours), "`{}` is not of the language", line.ours);
        Self {
            place: line.place.unwrap_or(place),
            says: line.says,
            seen: Pattern::of(line.seen),
            ours,
            fix: line.fix.map(|fix| (pieces(fix), fix)),
        }
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
        let lists = LINES.iter();
        lists.flat_map(|(place, lines)| lines.iter().map(|line| Form::of(*place, line))).collect()
    });
    &FORMS
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
