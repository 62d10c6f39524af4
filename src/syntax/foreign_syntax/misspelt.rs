//! Keywords that are misspelt.

use strsim::damerau_levenshtein;

use super::finding::Found;
use crate::syntax::token::{Token, TokenKind as T};

/// The fewest letters of a shortened keyword: `ret` is `return`.
const SHORTENED: usize = 3;

/// The keyword, of several, that a word most likely means: it may be shortened, a letter in three may
/// be wrong, and the letters of two may be swapped.
pub(in crate::syntax) fn keyword_meant(
    word: &str,
    among: impl IntoIterator<Item = T>,
) -> Option<T> {
    let lower = word.to_lowercase();
    let distance = |kind: T| {
        let ours = kind.spelling()?;
        let distance = damerau_levenshtein(&lower, ours);
        let is_swapped = lower.chars().rev().eq(ours.chars());
        let far = lower.chars().count().max(ours.len()) / 3;
        if lower.len() >= SHORTENED && ours.starts_with(&lower) {
            return Some(0);
        }
        (distance <= far || is_swapped && distance == 1).then_some(distance)
    };
    let near = among.into_iter().filter_map(|kind| Some((distance(kind)?, kind)));
    near.min_by_key(|(distance, _)| *distance).map(|(_, kind)| kind)
}

/// The finding that a token is the misspelling of a keyword.
pub(in crate::syntax) fn is_misspelt(text: &str, token: Token, meant: T) -> Found {
    let word = text.get(token.span.range()).unwrap_or("");
    let ours = meant.spelling().unwrap_or("");
    Found::slip(token.span, format!("`{word}` is written `{ours}`"), ours.to_owned())
}
