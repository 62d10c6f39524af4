//! The types of names, as far as they are known.

use super::names::{SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagram::Type;

/// The type of what a name stands for, as far as it is known.
pub fn type_of(snapshot: &Snapshot, id: SymbolId) -> Option<Type> {
    let symbol = snapshot.names().symbol(id);
    let named = |word: &str| Type::ALL.into_iter().find(|ty| ty.word() == word);
    if let Some(ty) = &symbol.ty {
        return named(ty);
    }
    if let SymbolKind::Element(Some(kind)) = symbol.kind {
        return named(kind.word());
    }
    let place = symbol.definition?;
    let mut variables = snapshot.program().variables();
    if let Some(known) = variables.find(|known| known.span == place) {
        return Some(known.ty);
    }
    // `for e in edges`: known even where the script cannot be parsed.
    let tokens = &snapshot.parsed().tokens;
    let at = tokens.iter().position(|token| token.span == place)?;
    let sequence = tokens.get(at + 2..)?;
    let words = sequence.iter().map(|token| snapshot.sources().slice(token.span));
    words
        .zip(sequence)
        .take_while(|(_, token)| {
            token.kind.is_wordlike() || token.kind == crate::syntax::TokenKind::Dot
        })
        .map(|(word, _)| word)
        .filter(|word| *word != ".")
        .find_map(|word| match word {
            "vertices" | "neighbors" => Some(Type::Vertex),
            "halfedges" | "ears" | "patch" => Some(Type::Halfedge),
            "edges" => Some(Type::Edge),
            "faces" | "holes" => Some(Type::Face),
            _ => None,
        })
}
