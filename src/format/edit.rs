//! The white space that formatting changes, gap by gap, as edits for an editor.

use super::commas::without_commas;
use super::safe::{Refusal, kept};
use super::words::Words;
use crate::source::{FileId, LineTable, Span};
use crate::syntax::Parsed;
use std::ops::Range;

/// A range of white space, and its replacement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The bytes to remove.
    pub range: Range<usize>,
    /// The text to insert.
    pub text: String,
}

/// The changes that formatting makes to a parsed text, in order; the edits do not overlap.
///
/// # Errors
///
/// If the result would differ from the text in anything but white space and commas between names: a
/// bug in this program. (Whether formatting again would change the result is not checked here,
/// since the caller waits; [`format`](super::format) checks it.)
pub fn edits(file: FileId, source: &str, parsed: &Parsed) -> Result<Vec<Edit>, Refusal> {
    let (formatted, again) = kept(file, source, parsed)?;
    let (plain, said) = without_commas(source, parsed);
    let (old, new) = (
        gaps(&plain, Words::of(&plain, &said)),
        gaps(&formatted, Words::lexed(&formatted, &again)),
    );
    let pairs = old.into_iter().zip(new);
    let edits = pairs.filter_map(|(old, new)| {
        let new = formatted.get(new)?;
        (source.get(old.clone()) != Some(new)).then(|| Edit { range: old, text: new.to_owned() })
    });
    Ok(edits.collect())
}

/// The changes that formatting makes on some lines, counted from 0; the end of `lines` is
/// exclusive.
///
/// # Errors
///
/// As [`edits`].
pub fn edits_of_lines(
    file: FileId,
    source: &str,
    parsed: &Parsed,
    lines: Range<usize>,
) -> Result<Vec<Edit>, Refusal> {
    let table = LineTable::new(source);
    let start = table.start(lines.start).unwrap_or(source.len());
    // The indentation of the first line follows the line break before it.
    let start = start.saturating_sub(1);
    let end = table.start(lines.end).unwrap_or(source.len());
    let edits = edits(file, source, parsed)?.into_iter();
    let inside = edits.filter(|edit| start <= edit.range.end && edit.range.start < end);
    let own = inside.filter_map(|edit| match edit.range.end < end || end == source.len() {
        true => Some(edit),
        false => before_last_line(source, &edit),
    });
    Ok(own.collect())
}

/// The part of an edit before the line that it ends on, whose indentation stays.
fn before_last_line(source: &str, edit: &Edit) -> Option<Edit> {
    let old = source.get(edit.range.clone())?;
    let old = &old[..old.rfind('\n')?];
    let text = edit.text[..edit.text.rfind('\n')?].to_owned();
    let range = edit.range.start..edit.range.start + old.len();
    (old != text).then_some(Edit { range, text })
}

/// The gaps before each token and comment, and after the last.
fn gaps(text: &str, words: Words) -> Vec<Range<usize>> {
    let end = Span::new(FileId(0), text.len(), text.len());
    let mut at = 0;
    words
        .places()
        .chain([end])
        .map(|span| {
            let from = std::mem::replace(&mut at, span.end as usize);
            from..span.start as usize
        })
        .collect()
}
