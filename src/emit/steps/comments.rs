//! The comments before statements.

use crate::source::{Sources, Span};

/// The lines of comment right before a place, and the comment after it on its line.
pub(super) fn comments(sources: &Sources, span: Span) -> Vec<String> {
    let text = sources.get(span.file).text();
    let mut lines = text.get(..span.start as usize).unwrap_or("").rsplit('\n');
    // The lines above belong to a statement only if it begins its line.
    let begins = lines.next().is_some_and(|line| line.trim().is_empty());
    let above = lines.map_while(|line| line.trim().strip_prefix("//")).take_while(|_| begins);
    let mut found: Vec<_> = above.map(|line| line.trim().to_string()).collect();
    found.reverse();
    let behind = text.get(span.end as usize..).unwrap_or("");
    let behind = behind.split('\n').next().unwrap_or("").trim();
    found.extend(behind.strip_prefix("//").map(|it| it.trim().to_string()));
    found
}
