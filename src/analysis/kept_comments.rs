//! Comments in the text that a fix replaces: they stay.

use crate::diagnostic::{Diagnostic, Edit};
use crate::source::{FileId, Sources, Span};
use crate::syntax::lex;

/// Adds to fixes the comments that they would lose, each on a line of its own before the line where
/// the edit begins.
pub(super) fn keep_comments(told: &mut [Diagnostic], sources: &Sources) {
    for fix in told.iter_mut().flat_map(|told| &mut told.fixes) {
        let kept = fix.edits.iter().filter_map(|edit| kept(edit, &fix.edits, sources));
        for kept in kept.collect::<Vec<Edit>>() {
            match fix.edits.iter_mut().find(|edit| edit.span.start == kept.span.start) {
                Some(edit) => edit.text.insert_str(0, &kept.text),
                None => fix.edits.push(kept),
            }
        }
    }
}

/// The edit that inserts the comments lost by an edit, if there are any.
fn kept(edit: &Edit, all: &[Edit], sources: &Sources) -> Option<Edit> {
    let old = sources.slice(edit.span);
    if !old.contains("//") {
        return None;
    }
    let mut lost = comments(old);
    for comment in comments(&edit.text) {
        if let Some(at) = lost.iter().position(|lost| *lost == comment) {
            lost.remove(at);
        }
    }
    let text = sources.get(edit.span.file).text();
    let line = line_before(text, edit.span.start as usize, all);
    let rest = &text[line..];
    let indentation = &rest[..rest.len() - rest.trim_start_matches([' ', '\t']).len()];
    let lines = lost.iter().map(|comment| format!("{indentation}{comment}\n"));
    let span = Span::new(edit.span.file, line, line);
    (!lost.is_empty()).then(|| Edit { span, text: lines.collect() })
}

fn comments(text: &str) -> Vec<&str> {
    let lexed = lex(FileId::default(), text);
    lexed.comments.iter().filter_map(|comment| text.get(comment.span.range())).collect()
}

/// The beginning of a line at or before a place that no edit replaces.
fn line_before(text: &str, place: usize, edits: &[Edit]) -> usize {
    let line = text[..place].rfind('\n').map_or(0, |end| end + 1);
    let over = edits.iter().map(|edit| edit.span.range());
    match over.into_iter().find(|over| over.start < line && line < over.end) {
        Some(over) => line_before(text, over.start, edits),
        None => line,
    }
}
