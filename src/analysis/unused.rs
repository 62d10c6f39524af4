//! Names that are declared and never read: editors show them faint.

use super::cursor_context::before;
use super::names::{Role, Symbol, SymbolKind};
use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::TokenKind;
use crate::syntax::tree::Item;

/// A declared name that nothing reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unused {
    /// The place of its declaration.
    pub span: Span,
    pub name: String,
    /// The kind of thing it names, in a word.
    pub what: &'static str,
}

/// The parameters, variables and private items of a text that nothing reads or calls. A loop or an
/// aggregate has to name its element, so that name may go unused, as may one that begins with `_`.
pub fn unused(snapshot: &Snapshot) -> Vec<Unused> {
    let names = snapshot.names();
    let is_read = |role: Role| !matches!(role, Role::Declared | Role::Written);
    let told = names.symbols().filter_map(|(id, symbol)| {
        let is_meant = symbol.name.starts_with('_')
            || names.mentions_of(id).any(|mention| is_read(mention.role));
        if is_meant {
            return None;
        }
        let what = what(snapshot, symbol)?;
        Some(Unused { span: symbol.definition?, name: symbol.name.clone(), what })
    });
    told.collect()
}

/// The kind of a name, in a word, if it is one that something should read.
fn what(snapshot: &Snapshot, symbol: &Symbol) -> Option<&'static str> {
    let definition = symbol.definition?;
    let private = |what| {
        let mut names = snapshot.items().iter().filter_map(Item::private_name);
        names.any(|name| name.span == definition).then_some(what)
    };
    match symbol.kind {
        SymbolKind::Parameter => Some("parameter"),
        SymbolKind::Element(_) if symbol.ty.is_some() => Some("parameter"),
        SymbolKind::Variable => {
            let before = before(snapshot, definition.start as usize).last();
            let is_of_loop = before.is_some_and(|word| {
                matches!(word.kind, TokenKind::For | TokenKind::Update | TokenKind::Drain)
            });
            (!is_of_loop).then_some("variable")
        }
        SymbolKind::Attribute => private("attribute"),
        SymbolKind::Op => private("op"),
        SymbolKind::Function => private("function"),
        SymbolKind::Script => private("script"),
        _ => None,
    }
}
