//! Slips of the pen: a keyword that is misspelt, or a word or sign that is wrong or missing, where
//! the grammar wants it and can then go on.

use std::ops::Range;

use super::failure::{Failure, Phrase};
use super::file::failures;
use crate::syntax::foreign_syntax::{Found, Mended, is_misspelt, keyword_meant, mend};
use crate::syntax::token::{Token, TokenKind as T};

/// The maximum number of slips in one item.
const MOST: usize = 8;

/// The maximum number of tokens of an item in which slips are looked for, since each is tried.
const LONGEST: usize = 20_000;

/// The operators that are words.
const OPERATORS: [T; 4] = [T::And, T::Or, T::Div, T::Mod];

/// The keywords that are read as a name if they are misspelt, so that parsing fails behind them.
const PREFIXES: [T; 7] = [T::Not, T::Can, T::Why, T::If, T::Each, T::Fn, T::Op];

/// Signs for which another is written.
const SIGNS: [(T, T); 3] =
    [(T::Arrow, T::Greater), (T::FatArrow, T::Greater), (T::Equals, T::Equal)];

/// A slip: tokens in place of which another stands.
struct Slip {
    place: Range<usize>,
    meant: T,
    found: Found,
}

impl Slip {
    fn mended(&self, tokens: &[Token]) -> Vec<Token> {
        let mut mended = tokens.to_vec();
        let (kind, span) = (self.meant, self.found.span);
        mended.splice(self.place.clone(), [Token { kind, span }]);
        mended
    }
}

/// The tokens of an item that cannot be parsed after its slips and foreign syntax are replaced.
pub(super) fn mended(text: &str, tokens: &[Token], failed: &[Failure]) -> Mended {
    let mut tokens = tokens.to_vec();
    let mut found = Vec::new();
    let mut failure = first(failed);
    while let Some(here) = &failure
        && found.len() < MOST
        && tokens.len() < LONGEST
    {
        let Some((slip, mended, next)) = without_slip(text, &tokens, here) else { break };
        found.push(slip);
        (tokens, failure) = (mended, next);
    }
    if failure.is_some() || found.is_empty() {
        let others = mend(text, &tokens);
        found.extend(others.found);
        tokens = others.tokens;
    }
    Mended { tokens, found }
}

/// The slip where parsing failed, the tokens without it, and where parsing then fails.
fn without_slip(
    text: &str,
    tokens: &[Token],
    failure: &Failure,
) -> Option<(Found, Vec<Token>, Option<Failure>)> {
    let at = index(tokens, failure);
    slips(text, tokens, at, failure).into_iter().find_map(|slip| {
        let mended = slip.mended(tokens);
        let next = first(&failures(text, &mended));
        let goes_on = next.as_ref().is_none_or(|next| index(&mended, next) > at + 1);
        goes_on.then_some((slip.found, mended, next))
    })
}

/// The first failure at which parsing could not go on.
fn first(failed: &[Failure]) -> Option<Failure> {
    let failed = failed.iter().filter(|failure| failure.mistake.is_none());
    failed.min_by_key(|failure| failure.span.start).cloned()
}

/// The index of the token at which parsing failed.
fn index(tokens: &[Token], failure: &Failure) -> usize {
    tokens.partition_point(|token| token.span.start < failure.span.start)
}

/// What may have slipped where parsing failed.
fn slips(text: &str, tokens: &[Token], at: usize, failure: &Failure) -> Vec<Slip> {
    let keywords = failure.wanted.tokens().filter(|kind| kind.is_keyword());
    let is_in_value = failure.wanted.phrases().any(|phrase| phrase == Phrase::Operator);
    let wanted = keywords.chain(OPERATORS.into_iter().filter(|_| is_in_value));
    let here = misspelt(text, tokens, at, wanted);
    let before = at.checked_sub(1).and_then(|at| misspelt(text, tokens, at, PREFIXES));
    let other = only(text, tokens, at, failure).or_else(|| brace(text, tokens, at, failure));
    here.into_iter().chain(before).chain(other).collect()
}

/// A word that is most likely one of several keywords.
fn misspelt(
    text: &str,
    tokens: &[Token],
    at: usize,
    wanted: impl IntoIterator<Item = T>,
) -> Option<Slip> {
    let token = tokens.get(at).copied().filter(|token| token.kind == T::Word)?;
    let meant = keyword_meant(text.get(token.span.range())?, wanted)?;
    Some(Slip { place: at..at + 1, meant, found: is_misspelt(text, token, meant) })
}

/// The only token that is wanted, if another sign stands for it or it is a forgotten `in`.
fn only(text: &str, tokens: &[Token], at: usize, failure: &Failure) -> Option<Slip> {
    let mut wanted = failure.wanted.tokens();
    let mut phrases = failure.wanted.phrases();
    let meant = wanted.next().filter(|_| phrases.all(Phrase::is_weak))?;
    let here = tokens.get(at).filter(|_| wanted.next().is_none())?;
    let written = text.get(here.span.range())?;
    let ours = meant.spelling()?;
    if SIGNS.contains(&(meant, here.kind)) {
        return Some(slip(
            tokens,
            at..at + 1,
            meant,
            format!("here `{written}` is written `{ours}`"),
        ));
    }
    // `x of xs`, `least x in xs`, `i from 0`: the word is one too many, or stands for another.
    let is_other =
        tokens.get(at + 1).is_some_and(|next| matches!(next.kind, T::In | T::Word | T::Int));
    let is_forgotten = meant == T::In && here.kind.is_wordlike() && !is_other;
    is_forgotten.then(|| slip(tokens, at..at, meant, format!("`in` stands before `{written}`")))
}

/// A `{` that is missing, or for which something else stands, if fewer are opened than closed.
fn brace(text: &str, tokens: &[Token], at: usize, failure: &Failure) -> Option<Slip> {
    let count = |kind: T| tokens.iter().filter(|token| token.kind == kind).count();
    let is_missing = failure.wanted.has(T::LeftBrace) && at > 0;
    let here = tokens.get(at).filter(|_| is_missing)?;
    if count(T::RightBrace) <= count(T::LeftBrace) {
        return None;
    }
    let (place, says) = match text.get(here.span.range()) {
        Some(":" | "then" | "do") => (at..at + 1, "a block stands in braces: it begins with `{`"),
        _ => (at..at, "a block stands in braces: its `{` is missing"),
    };
    Some(slip(tokens, place, T::LeftBrace, says.to_owned()))
}

/// The slip of another token in place of some, or behind the one before it.
fn slip(tokens: &[Token], place: Range<usize>, meant: T, says: String) -> Slip {
    let before = place.start.checked_sub(1).map(|at| tokens[at].span.after()).unwrap_or_default();
    let span = tokens[place.clone()].first().map_or(before, |token| token.span);
    let is_apart = span.start > before.start || SIGNS.iter().any(|(ours, _)| *ours == meant);
    let ours = meant.spelling().unwrap_or("");
    let text = if is_apart { ours.to_owned() } else { format!(" {ours}") };
    Slip { place, meant, found: Found::slip(span, says, text) }
}
