//! The other files that a text names.

use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::tree::Item;

/// The path of a `use`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The path between its quotes.
    pub span: Span,
    /// The path, from the folder of the text on.
    pub path: String,
}

/// The files that a text uses. What ships with the language is in no file.
pub fn links(snapshot: &Snapshot) -> Vec<Link> {
    let used = snapshot.items().iter().filter_map(|item| match item {
        Item::Use(used) => Some(used),
        _ => None,
    });
    let files = used.filter(|used| !used.path.starts_with("std/"));
    files
        .map(|used| {
            let quotes = used.path_span;
            Link {
                span: Span {
                    start: (quotes.start + 1).min(quotes.end),
                    end: quotes.end.saturating_sub(1).max(quotes.start),
                    ..quotes
                },
                path: used.path.clone(),
            }
        })
        .collect()
}
