//! Links to the other files that a text uses.

use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::tree::Item;

/// The path of a `use`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The path between its quotes.
    pub span: Span,
    /// The path, as it is written.
    pub path: String,
}

/// The files that a text uses.
pub fn links(snapshot: &Snapshot) -> Vec<Link> {
    let used = snapshot.items().iter().filter_map(|item| match item {
        Item::Use(used) => Some(used),
        _ => None,
    });
    used.map(|used| {
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
