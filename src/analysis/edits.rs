//! Edits of drawings: the insertion of new statements, and how a statement is written.

use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::source::Span;
use crate::syntax::tree::{Side, Statement};

/// The edit that writes statements at the end of a side, each on a line of its own.
pub(super) fn append(snapshot: &Snapshot, side: &Side, statements: &[String]) -> Edit {
    let last = side.statements.iter().map(Statement::span).max_by_key(|span| span.end);
    let brace = snapshot.sources().slice(side.span).find('{');
    let open = side.span.start as usize + brace.map_or(0, |at| at + 1);
    let place = match last {
        Some(last) => last.after(),
        None => Span::new(side.span.file, open, open),
    };
    let indentation = match side.statements.first() {
        Some(first) => indentation(snapshot, first.span()),
        None => indentation(snapshot, side.span) + "  ",
    };
    let mut text = String::new();
    for statement in statements {
        text.push_str(&format!("\n{indentation}{statement}"));
    }
    // `after {}` on one line gets its brace on a line of its own.
    let rest = snapshot.text().get(place.end as usize..).unwrap_or("");
    if rest.trim_start_matches([' ', '\t']).starts_with('}') {
        text.push('\n');
        text.push_str(&self::indentation(snapshot, side.span));
    }
    Edit { span: place, text }
}

/// The indentation of the line of a place.
pub(super) fn indentation(snapshot: &Snapshot, place: Span) -> String {
    let before = &snapshot.text()[..place.start as usize];
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    let rest = &snapshot.text()[line..];
    let end = rest.find(|letter: char| letter != ' ' && letter != '\t');
    rest[..end.unwrap_or(0)].to_owned()
}

/// A statement as it is written.
pub(super) fn slice<'s>(snapshot: &'s Snapshot, statement: &Statement) -> &'s str {
    snapshot.sources().slice(statement.span())
}
