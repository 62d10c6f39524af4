//! The types of names, as far as they are known.

use super::names::{SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagram::Type;
use crate::syntax::{Token, TokenKind};

/// The type of what a name stands for, as far as it is known.
pub fn type_of(snapshot: &Snapshot, id: SymbolId) -> Option<Type> {
    let symbol = snapshot.names().symbol(id);
    if let Some(ty) = &symbol.ty {
        return Type::named(ty);
    }
    if let SymbolKind::Element(Some(kind)) = symbol.kind {
        return kind.element_type();
    }
    let place = symbol.definition?;
    if let Some(known) = snapshot.type_at(place) {
        return Some(known);
    }
    // `for e in edges`: known even where the script cannot be parsed.
    let tokens = &snapshot.parsed().tokens;
    let at = tokens.iter().position(|token| token.span == place)?;
    type_of_elements(snapshot, tokens.get(at + 2..)?)
}

/// The type of the elements of the sequence that begins at some tokens, as far as it is known.
pub(super) fn type_of_elements(snapshot: &Snapshot, sequence: &[Token]) -> Option<Type> {
    let head = sequence.iter().take_while(|token| {
        let goes_on = token.kind.is_wordlike() || token.kind == TokenKind::Dot;
        goes_on && !matches!(token.kind, TokenKind::Where | TokenKind::By)
    });
    let mut words = head.map(|token| snapshot.sources().slice(token.span));
    words.find_map(|word| match word {
        "vertices" | "neighbors" => Some(Type::Vertex),
        "halfedges" | "ears" | "patch" => Some(Type::Halfedge),
        "edges" => Some(Type::Edge),
        "faces" | "holes" => Some(Type::Face),
        _ => None,
    })
}
