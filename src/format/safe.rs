//! Checks of the result: no token or comment is lost, and formatting again would change nothing.

use super::commas::without_commas;
use super::file::formatted;
use super::words::Words;
use crate::diagnostic::Diagnostic;
use crate::source::FileId;
use crate::syntax::{Lexed, Parsed, lex, parse};
use std::fmt;

/// A formatted text.
#[derive(Clone, Debug)]
pub struct Formatted {
    /// The new text.
    pub text: String,
    /// The errors in the old one; items with errors are unchanged.
    pub diagnostics: Vec<Diagnostic>,
}

/// The reason why a text is not formatted: a bug in the formatter, detected in time.
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

/// Formats a text. Items with errors are unchanged.
///
/// # Errors
///
/// If the result would differ from the text in anything but white space and commas between names,
/// or formatting it again would change it. Both are bugs in this program; the text should be left
/// as it is.
pub fn format(file: FileId, source: &str) -> Result<Formatted, Refusal> {
    let parsed = parse(file, source);
    let (text, _) = kept(file, source, &parsed)?;
    let twice = formatted(&text, &parse(file, &text));
    if twice != text {
        let place = text.bytes().zip(twice.bytes()).take_while(|(one, other)| one == other).count();
        return Err(Refusal::NotStable(place));
    }
    Ok(Formatted { text, diagnostics: parsed.diagnostics })
}

/// The new text and its tokens, which have been checked to be those of the old one.
pub(super) fn kept(
    file: FileId,
    source: &str,
    parsed: &Parsed,
) -> Result<(String, Lexed), Refusal> {
    let (source, parsed) = without_commas(source, parsed);
    let text = formatted(&source, &parsed);
    let again = lex(file, &text);
    let (old, new) = (Words::of(&source, &parsed), Words::lexed(&text, &again));
    if let Some(place) = first_difference(old, new) {
        return Err(Refusal::WouldChange(place));
    }
    Ok((text, again))
}

/// The first place where two texts differ in more than white space: a place in the first, or its
/// end.
fn first_difference(old: Words, new: Words) -> Option<usize> {
    let (mut olds, mut news) = (old.all(), new.all());
    loop {
        match (olds.next(), news.next()) {
            (None, None) => break,
            (Some((_, old)), Some((_, new))) if old == new => {}
            (Some((span, _)), _) => return Some(span.start as usize),
            (None, Some(_)) => return Some(old.end()),
        }
    }
    let mut kept = new.leftovers().map(|(_, what)| what);
    let lost = old.leftovers().find(|(_, what)| kept.next() != Some(*what));
    match lost {
        Some((place, _)) => Some(place),
        None => kept.next().map(|_| old.end()),
    }
}
