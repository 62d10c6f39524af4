//! Incremental parsing: items whose text has not changed are reused.

use super::file::{Parsed, parse_with};
use crate::source::{FileId, Span};
use crate::syntax::shift::moved;
use crate::syntax::tree::Item;
use std::collections::HashMap;

/// Parses the new text of a file, given that the old text `was` parsed to `earlier`. Returns the
/// same as [`parse`](super::parse).
pub fn parse_again(file: FileId, text: &str, was: &str, earlier: &Parsed) -> Parsed {
    parse_with(file, text, &Known::of(was, earlier))
}

/// Items that have been parsed, by their texts. Only items that could be read as they are written
/// are kept, since the report of an error can depend on the surrounding text.
#[derive(Debug, Default)]
pub(super) struct Known<'t>(HashMap<&'t str, (u32, &'t Item)>);

impl<'t> Known<'t> {
    fn of(text: &'t str, read: &'t Parsed) -> Self {
        let items = read.tree.items.iter().map(|item| (item.span(), item));
        let right = items.filter(|(span, _)| !read.tree.is_misread(*span));
        let named =
            right.filter_map(|(span, item)| Some((text.get(span.range())?, (span.start, item))));
        Self(named.collect())
    }

    /// The item at a span, if an item with the same text is known.
    pub(super) fn item(&self, text: &str, span: Span) -> Option<Item> {
        let (was, item) = self.0.get(text.get(span.range())?)?;
        let by = i64::from(span.start) - i64::from(*was);
        Some(moved(item, i32::try_from(by).ok()?))
    }
}
