//! Suggestions for misspelt words.

use strsim::damerau_levenshtein;

use crate::diagnostic::Diagnostic;
use crate::source::Span;

/// The candidate closest to `word`, if no more than a third of its letters differ;
/// among equals the first.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    let most = length / 3;
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        if candidate == word || candidate.chars().count().abs_diff(length) > most {
            continue;
        }
        let distance = damerau_levenshtein(word, candidate);
        if distance <= most && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// Labels the primary place of `diagnostic` with the candidate closest to `word`, if there is one,
/// and adds the fix that writes it at `span`, unless the digits differ: those are meant.
pub(super) fn suggest<'a>(
    diagnostic: Diagnostic,
    word: &str,
    span: Span,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    suggest_if(diagnostic, (word, span), candidates, |meant| digits(word) == digits(meant))
}

/// The same for functions and ops: their short names are so dense that one letter makes another,
/// and the one that is meant `fits` the call.
pub(super) fn suggest_function<'a>(
    diagnostic: Diagnostic,
    word: &str,
    span: Span,
    candidates: impl IntoIterator<Item = &'a str>,
    fits: impl Fn(&str) -> bool,
) -> Diagnostic {
    suggest_if(diagnostic, (word, span), candidates, |meant| is_slip(word, meant) && fits(meant))
}

fn suggest_if<'a>(
    diagnostic: Diagnostic,
    (word, span): (&str, Span),
    candidates: impl IntoIterator<Item = &'a str>,
    is_certain: impl Fn(&str) -> bool,
) -> Diagnostic {
    let Some(meant) = closest(word, candidates) else { return diagnostic };
    let diagnostic = diagnostic.saying(format!("did you mean `{meant}`?"));
    match is_certain(meant) {
        true => diagnostic.fix(format!("write `{meant}`"), span, meant),
        false => diagnostic,
    }
}

/// The number of letters of a short name: `cos` and `cosh`, `sin` and `sign` are two.
const SHORT: usize = 4;

/// True if a word that is close to a function is certainly a misspelling of it: with the same
/// digits, and a short one with its letters in another order, left out or doubled.
fn is_slip(word: &str, meant: &str) -> bool {
    let letters = |word: &str| word.chars().collect::<Vec<_>>();
    let sorted = |word: &str| {
        let mut letters = letters(word);
        letters.sort_unstable();
        letters
    };
    let single = |word: &str| {
        let mut letters = letters(word);
        letters.dedup();
        letters
    };
    let mut rest = meant.chars();
    digits(word) == digits(meant)
        && (letters(word).len().min(letters(meant).len()) > SHORT
            || sorted(word) == sorted(meant)
            || word.chars().all(|letter| rest.any(|other| other == letter))
            || single(word) == single(meant))
}

fn digits(word: &str) -> String {
    word.chars().filter(char::is_ascii_digit).collect()
}
