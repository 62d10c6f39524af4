//! Suggestions for misspelt words.

use strsim::damerau_levenshtein;

use crate::diagnostic::Diagnostic;
use crate::source::Span;

/// The candidate closest to `word`, if no more than a third of its letters differ;
/// among equals the first.
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = word.chars().count();
    if length > LONGEST {
        return None;
    }
    let most = length / 3;
    let counts = letter_counts(word);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        if candidate == word {
            continue;
        }
        // An edit changes two counts at most.
        let others = letter_counts(candidate);
        let apart: usize = counts.iter().zip(others).map(|(a, b)| a.abs_diff(b)).sum();
        if apart > 2 * most {
            continue;
        }
        let distance = damerau_levenshtein(word, candidate);
        if distance <= most && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

/// The number of letters of the longest word that is compared with others.
const LONGEST: usize = 64;

/// How often letters occur; some share a count.
fn letter_counts(word: &str) -> [usize; 32] {
    let mut counts = [0; 32];
    word.chars().for_each(|letter| counts[letter as usize % 32] += 1);
    counts
}

/// The longest candidate whose words are among those of `word`: `flip` of `flip_edge`.
fn part_of<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let is_part = |candidate: &&&str| {
        let mut parts = candidate.split('_');
        candidate.len() >= SHORT && parts.all(|part| word.split('_').any(|other| other == part))
    };
    candidates.iter().filter(is_part).max_by_key(|candidate| candidate.len()).copied()
}

/// Labels the primary place of `diagnostic` with the candidate closest to `word`, if there is one,
/// and adds the fix that writes it at `span`, if it is certain.
pub(super) fn suggest<'a>(
    diagnostic: Diagnostic,
    word: &str,
    span: Span,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    suggested(diagnostic, (word, span), closest(word, candidates), |_| true)
}

/// The same for functions and ops: the one that is meant also `fits` the call.
pub(super) fn suggest_function<'a>(
    diagnostic: Diagnostic,
    word: &str,
    span: Span,
    candidates: impl IntoIterator<Item = &'a str>,
    fits: impl Fn(&str) -> bool,
) -> Diagnostic {
    let all: Vec<_> = candidates.into_iter().collect();
    let close = closest(word, all.iter().copied()).or_else(|| part_of(word, &all));
    suggested(diagnostic, (word, span), close, fits)
}

fn suggested(
    diagnostic: Diagnostic,
    (word, span): (&str, Span),
    meant: Option<&str>,
    fits: impl Fn(&str) -> bool,
) -> Diagnostic {
    let Some(meant) = meant else { return diagnostic };
    let diagnostic = diagnostic.saying(format!("did you mean `{meant}`?"));
    let is_certain = is_slip(word, meant) && fits(meant);
    diagnostic.when(is_certain, |told| told.fix(format!("write `{meant}`"), span, meant))
}

/// The number of letters of a short name: `cos` and `cosh`, `sin` and `sign` are two.
const SHORT: usize = 4;

/// True if a word that is close to a name is certainly a misspelling of it: with the same digits,
/// and its letters in another order, left out or doubled, capital, or with an `s` behind; or, in a
/// long one, with one other letter behind the first. This holds for each part of a name: `min_z` is
/// not `min_x`, and `next_min` not `min`.
fn is_slip(word: &str, meant: &str) -> bool {
    let [word, meant] = [word, meant].map(str::to_lowercase);
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
    let is_slip_of_part = |(word, meant): (&str, &str)| {
        let mut rest = meant.chars();
        let is_long = letters(word).len().min(letters(meant).len()) > SHORT;
        word == meant
            || word.strip_suffix('s') == Some(meant)
            || sorted(word) == sorted(meant)
            || word.chars().all(|letter| rest.any(|other| other == letter))
            || single(word) == single(meant)
            || is_long
                && word.chars().next() == meant.chars().next()
                && damerau_levenshtein(word, meant) == 1
    };
    let parts = |word: &str| word.split('_').count();
    digits(&word) == digits(&meant)
        && parts(&word) == parts(&meant)
        && word.split('_').zip(meant.split('_')).all(is_slip_of_part)
}

fn digits(word: &str) -> String {
    word.chars().filter(char::is_ascii_digit).collect()
}
