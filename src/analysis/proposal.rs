//! Changes that only the user can decide on, and the names in them.

use super::names::{SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::diagram::Kind;

/// The change as an imperative, and its edits.
pub(super) type Proposal = (String, Vec<Edit>);

/// A name as it is written in a list: that of a family with its index.
pub(super) fn written(snapshot: &Snapshot, id: SymbolId) -> String {
    let symbol = snapshot.names().symbol(id);
    let behind = symbol
        .definition
        .and_then(|drawn| snapshot.sources().get(drawn.file).text().get(drawn.end as usize..));
    let index = behind.and_then(|rest| rest.strip_prefix('['));
    let letter = index.map(|rest| {
        let end = rest.find(|letter: char| !letter.is_alphanumeric() && letter != '_');
        &rest[..end.unwrap_or(0)]
    });
    match letter {
        Some(letter) => format!("{}[{letter}]", symbol.name),
        None => symbol.name.clone(),
    }
}

pub(super) fn kind_of(snapshot: &Snapshot, id: SymbolId) -> Option<Kind> {
    match snapshot.names().symbol(id).kind {
        SymbolKind::Element(kind) => kind,
        _ => None,
    }
}
