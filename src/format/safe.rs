//! The door: nothing is answered that lost a word, or that would look different next time.

use super::file::formatted;
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use crate::syntax::{CommentKind, Parsed, TokenKind, parse, parse_again};
use std::fmt;

/// A text, formatted.
#[derive(Clone, Debug)]
pub struct Formatted {
    /// The new text.
    pub text: String,
    /// What is wrong with the old one; where something is, it stayed as it was.
    pub diagnostics: Vec<Diagnostic>,
}

/// Why a text is left alone: a mistake of the formatter, noticed in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A token or a comment would change, at this byte of the text.
    WouldChange(usize),
    /// Formatting a second time would change the text again, at this byte of the first result.
    NotStable(usize),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::WouldChange(_) => f.write_str("formatting would change more than white space"),
            Self::NotStable(_) => f.write_str("formatting twice would not give the same"),
        }
    }
}

impl std::error::Error for Refusal {}

/// Formats a text. Items with mistakes stay as they are.
///
/// # Errors
///
/// If the result would differ from the text in anything but white space, or would be formatted
/// differently once more. Both are mistakes of this program; the text should be left as it is.
pub fn format(file: FileId, source: &str) -> Result<Formatted, Refusal> {
    let parsed = parse(file, source);
    let (text, again) = kept(file, source, &parsed)?;
    let twice = formatted(&text, &again);
    if twice != text {
        let same = text.bytes().zip(twice.bytes());
        let place = same.take_while(|(one, other)| one == other).count();
        return Err(Refusal::NotStable(place));
    }
    Ok(Formatted {
        text,
        diagnostics: parsed.diagnostics,
    })
}

/// The new text, which has all words of the old one, and what it says.
pub(super) fn kept(
    file: FileId,
    source: &str,
    parsed: &Parsed,
) -> Result<(String, Parsed), Refusal> {
    let text = formatted(source, parsed);
    let again = parse_again(file, &text, source, parsed);
    if let Some(place) = first_difference(source, parsed, &text, &again) {
        return Err(Refusal::WouldChange(place));
    }
    Ok((text, again))
}

/// Where two texts differ in more than white space: a place in the first.
fn first_difference(one: &str, old: &Parsed, other: &str, new: &Parsed) -> Option<usize> {
    let mut olds = words(one, old);
    let mut news = words(other, new);
    loop {
        match (olds.next(), news.next()) {
            (None, None) => break,
            (Some((_, old)), Some((_, new))) if old == new => {}
            (Some((span, _)), _) => return Some(span.start as usize),
            (None, Some(_)) => return Some(one.len()),
        }
    }
    let mut lost = leftovers(other, new).map(|(_, what)| what);
    let differing = leftovers(one, old).find(|(_, what)| lost.next() != Some(*what));
    match differing {
        Some((place, _)) => Some(place),
        None => lost.next().map(|_| one.len()),
    }
}

/// What a token or comment is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word<'t> {
    Token(TokenKind, &'t str),
    Comment(CommentKind, &'t str),
}

/// All tokens and comments, in order.
fn words<'t>(source: &'t str, parsed: &'t Parsed) -> impl Iterator<Item = (Span, Word<'t>)> {
    let said = |span: Span| source.get(span.range()).unwrap_or("");
    let tokens = parsed.tokens.iter();
    let mut tokens = tokens
        .map(move |token| (token.span, Word::Token(token.kind, said(token.span))))
        .peekable();
    let comments = parsed.comments.iter();
    let mut comments = comments
        .map(move |comment| {
            (
                comment.span,
                Word::Comment(comment.kind, said(comment.span)),
            )
        })
        .peekable();
    std::iter::from_fn(move || match (tokens.peek(), comments.peek()) {
        (Some((token, _)), Some((comment, _))) if comment.start < token.start => comments.next(),
        (Some(_), _) => tokens.next(),
        (None, _) => comments.next(),
    })
}

/// The places of all tokens and comments, in order.
pub(super) fn places<'t>(
    source: &'t str,
    parsed: &'t Parsed,
) -> impl Iterator<Item = Span> + use<'t> {
    words(source, parsed).map(|(span, _)| span)
}

/// The characters that belong to no token, no comment and no white space, and their places.
pub(super) fn leftovers<'t>(
    source: &'t str,
    parsed: &'t Parsed,
) -> impl Iterator<Item = (usize, char)> + use<'t> {
    let mut at = 0;
    let end = Span::new(FileId(0), source.len(), source.len());
    let gaps = places(source, parsed).chain([end]).map(move |span| {
        let from = std::mem::replace(&mut at, span.end as usize);
        (from, source.get(from..span.start as usize).unwrap_or(""))
    });
    let is_space = |c: char| c.is_ascii_whitespace() || c == '\u{FEFF}';
    gaps.flat_map(move |(from, gap)| {
        gap.char_indices()
            .filter(move |&(_, c)| !is_space(c))
            .map(move |(at, c)| (from + at, c))
    })
}
