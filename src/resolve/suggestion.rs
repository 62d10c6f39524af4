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
/// and adds the fix that writes it at `span`.
pub(super) fn suggest<'a>(
    diagnostic: Diagnostic,
    word: &str,
    span: Span,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Diagnostic {
    match closest(word, candidates) {
        Some(meant) => diagnostic.saying(format!("did you mean `{meant}`?")).fix(
            format!("write `{meant}`"),
            span,
            meant,
        ),
        None => diagnostic,
    }
}
