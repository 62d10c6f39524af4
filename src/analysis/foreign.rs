//! Syntax of other languages in items that parse as something else.
//!
//! `h.face is None` parses as three values, `flip(mesh, e)` as a call, and `n--` and `--m` on two
//! lines as one value. All errors of the resolver on such lines have one cause, which is reported
//! instead.

use std::collections::HashSet;

use super::files::{Part, touches};
use crate::diagnostic::Diagnostic;
use crate::source::{Sources, Span};
use crate::syntax::written_elsewhere;

/// The codes of diagnostics that foreign syntax may cause.
const UNKNOWN: [&str; 7] = [
    "two-kinds",
    "unknown-field",
    "unknown-function",
    "unknown-name",
    "unknown-result",
    "unknown-type",
    "unused-value",
];

/// Replaces the errors of the resolver on some lines by those of the foreign syntax in them.
pub(super) fn tell_as_elsewhere(parts: &[Part], told: &mut Vec<Diagnostic>, sources: &Sources) {
    for part in parts {
        let source = sources.get(part.file);
        let line_at = |place: u32| source.line_column(place as usize).0;
        let line = |span: Span| line_at(span.start);
        for item in &part.parsed.tree.items {
            let whole = item.span();
            let inside = |error: &Diagnostic| touches(whole, error.span());
            let unknown =
                told.iter().filter(|error| inside(error) && UNKNOWN.contains(&error.code));
            // An error with a fix is understood as it is.
            let places = unknown.filter(|error| error.fixes.is_empty()).map(Diagnostic::span);
            let lines: Vec<_> =
                places.map(|place| line_at(place.start)..=line_at(place.end)).collect();
            if lines.is_empty() {
                continue;
            }
            let tokens = &part.parsed.tokens;
            let begin = tokens.partition_point(|token| token.span.start < whole.start);
            let end = tokens.partition_point(|token| token.span.start < whole.end);
            let asked = |span: Span| {
                let line = line(span);
                lines.iter().any(|lines| lines.contains(&line))
            };
            let found = written_elsewhere(source.text(), &tokens[begin..end], asked);
            let lines: HashSet<_> = found.iter().map(|found| line(found.span())).collect();
            told.retain(|error| !inside(error) || !lines.contains(&line(error.span())));
            told.extend(found);
        }
    }
}
