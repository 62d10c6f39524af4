//! The pass over the tokens of an item that replaces foreign syntax.

use super::finding::{Found, Match};
use super::misspelt::keyword_meant;
use super::place::{Braces, CODE, DRAWING, HEAD, Item, PARTS, Places};
use super::sign::{Around, Sign, sign};
use super::table::{forms, forms_from};
use crate::diagnostic::Edit;
use crate::syntax::token::{Token, TokenKind as T};
use std::ops::Range;

/// The maximum number of replacements in one item, per token.
const MOST: usize = 4;

/// The keywords that begin something, by the place where they do.
const BEGINNINGS: &[(Places, &[T])] = &[
    (HEAD, &[T::Op, T::Script, T::Fn, T::Attr, T::Use, T::Test, T::Private]),
    (PARTS, &[T::Before, T::After, T::Require, T::Guard, T::Alias, T::Rule, T::Steps]),
    (DRAWING, &[T::Face, T::Hole, T::Loop, T::Edge, T::Vertex, T::New, T::Keep, T::Erase]),
    (
        CODE,
        &[
            T::Let,
            T::Var,
            T::If,
            T::Parallel,
            T::For,
            T::While,
            T::Repeat,
            T::Drain,
            T::Update,
            T::Print,
            T::Assert,
            T::Require,
            T::Return,
            T::Must,
        ],
    ),
];

/// The tokens of an item after foreign syntax has been replaced.
pub struct Mended {
    pub tokens: Vec<Token>,
    /// The findings, in the order of the text.
    pub found: Vec<Found>,
}

/// Replaces the foreign syntax in an item that cannot be parsed.
pub fn mend(text: &str, tokens: &[Token]) -> Mended {
    let mut item = Item::new(text, tokens);
    let mut braces = Braces::new();
    let mut found = Vec::new();
    let mut left = tokens.len().saturating_mul(MOST).saturating_add(MOST);
    let mut at = 0;
    while let Some(kind) = item.kind(at) {
        let place = braces.place();
        let known = matching(&item, at, braces.places(&item, at), braces.begins(&item, at))
            .filter(|_| left > 0);
        if let Some((number, parts)) = known {
            let hit = Match { form: &forms()[number], item: &item, parts };
            found.push(hit.found(number));
            let (range, written) = (hit.all(), hit.written());
            item.tokens.splice(range, written);
            left -= 1;
            continue;
        }
        if kind == T::Foreign {
            found.push(foreign(&mut item, at, place));
            continue;
        }
        let begins = braces.begins(&item, at);
        if let Some((meant, told)) = misspelt(&item, at, place).filter(|_| begins) {
            item.tokens[at].kind = meant;
            found.push(told);
        }
        braces.pass(item.tokens[at].kind);
        item.pass(at);
        at += 1;
    }
    found.sort_by_key(|found| (found.span.start, found.span.end));
    Mended { tokens: item.tokens, found }
}

/// The first line of the table that matches at a token, and the tokens of each element.
fn matching(
    item: &Item,
    at: usize,
    places: Places,
    begins: bool,
) -> Option<(usize, Vec<Range<usize>>)> {
    forms_from(item.word(at)).iter().find_map(|&number| {
        let form = &forms()[number];
        let parts = (form.place & places != 0).then(|| form.seen().matched(item, at, begins))??;
        parts.last().is_some_and(|last| last.end > at).then_some((number, parts))
    })
}

/// A foreign sign that the table does not list.
fn foreign(item: &mut Item, at: usize, place: Places) -> Found {
    let span = item.tokens[at].span;
    let (span, written) = item.comment(at).unwrap_or((span, item.word(at)));
    let (before, behind) = item.around(span.start, span.end);
    let around = Around {
        before: before.rsplit('\n').next().unwrap_or(""),
        behind: behind.split('\n').next().unwrap_or(""),
        at_item: place == HEAD && begins_item(behind),
        place,
    };
    let Sign { kind, says, fix } = sign(written, span, around);
    let first = item.word(at).chars().next().map_or(0, u32::from);
    let code = match kind {
        Some(T::Real) => "malformed-number",
        _ => "unknown-character",
    };
    match kind {
        Some(kind) => item.tokens[at].kind = kind,
        None => drop(item.tokens.remove(at)),
    }
    Found {
        what: usize::MAX - first as usize,
        span,
        says,
        edits: fix.map(|(span, text)| vec![Edit { span, text }]),
        ends: false,
        code,
    }
}

/// True if a text begins with an item that has a doc comment.
fn begins_item(text: &str) -> bool {
    let word = text.split_whitespace().next();
    matches!(word, Some("op" | "script" | "fn" | "attr" | "private"))
}

/// A misspelling of a keyword that can begin something here.
fn misspelt(item: &Item, at: usize, place: Places) -> Option<(T, Found)> {
    if item.kind(at) != Some(T::Word) {
        return None;
    }
    let next = item.kind(at + 1);
    let is_behind_block = at > 0 && item.kind(at - 1) == Some(T::RightBrace);
    let goes_on = match place {
        PARTS => true,
        DRAWING | HEAD => next.is_some_and(|next| next.is_wordlike() || next == T::Text),
        _ if is_behind_block && matches!(next, Some(T::LeftBrace | T::If)) => {
            let meant = keyword_meant(item.word(at), [T::Else])?;
            return Some((meant, item.misspelt(at, meant)?));
        }
        _ => {
            let starts_value = |kind: T| {
                kind.is_wordlike() || matches!(kind, T::Int | T::Real | T::Text | T::TextHead)
            };
            next.is_some_and(starts_value) && !item.ends_line(at + 1)
        }
    };
    let (_, beginnings) = BEGINNINGS.iter().find(|(here, _)| *here == place && goes_on)?;
    let meant = keyword_meant(item.word(at), beginnings.iter().copied())?;
    Some((meant, item.misspelt(at, meant)?))
}
