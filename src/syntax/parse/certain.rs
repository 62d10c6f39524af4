//! Fixes are tried: one that leaves an error without a fix where it was applied is not offered.

use super::file::parse_once;
use crate::diagnostic::{Diagnostic, Edit, applied};
use crate::source::{LineTable, Span};
use std::collections::{BTreeSet, HashSet};
use std::ops::Range;

/// Removes the fixes of errors of one item that are not certain.
pub(super) fn keep_certain(text: &str, item: Span, told: &mut [Diagnostic]) {
    let fixes = told.iter().flat_map(|told| &told.fixes);
    let mut edits: Vec<Edit> = fixes.flat_map(|fix| fix.edits.iter().cloned()).collect();
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits.dedup_by(|next, last| next.span.start < last.span.end);
    let (Some(first), Some(last)) = (edits.first(), edits.last()) else { return };
    let start = first.span.start.min(item.start) as usize;
    let end = last.span.end.max(item.end) as usize;
    let Some((mended, places)) = applied(text, start..end, &edits) else { return };
    let lines = LineTable::new(&mended);
    let left = parse_once(item.file, &mended).diagnostics;
    let left = left.iter().filter(|left| left.is_error() && left.fixes.is_empty());
    let left: BTreeSet<usize> = left.map(|left| lines.line(left.span().start as usize)).collect();
    let is_wrong = |place: &Range<usize>| {
        left.range(lines.line(place.start)..=lines.line(place.end)).next().is_some()
    };
    let wrong = edits.iter().zip(&places).filter(|(_, place)| is_wrong(place));
    let wrong: HashSet<Span> = wrong.map(|(edit, _)| edit.span).collect();
    for told in told {
        told.fixes.retain(|fix| !fix.edits.iter().any(|edit| wrong.contains(&edit.span)));
    }
}
