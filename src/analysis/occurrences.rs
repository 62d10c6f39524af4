//! Occurrences of a name: its declaration and its mentions.

use std::ops::Range;

use super::names::{Mention, Symbol, SymbolKind};
use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::tree::{Item, split_qualified};

/// The place that declares the name at a byte, or draws it first; perhaps in another file.
pub fn definition(snapshot: &Snapshot, offset: usize) -> Option<Span> {
    let mention = snapshot.names().at(offset)?;
    declared(snapshot, snapshot.names().symbol(mention.symbol))
}

fn declared(snapshot: &Snapshot, symbol: &Symbol) -> Option<Span> {
    match symbol.kind {
        SymbolKind::Elsewhere => called_elsewhere(snapshot, &symbol.name),
        _ => symbol.definition,
    }
}

/// The place of an op, script or function of a used file, by its name, which may
/// be qualified.
fn called_elsewhere(snapshot: &Snapshot, name: &str) -> Option<Span> {
    let (items, name) = snapshot.items_for(name);
    let mut names = items.filter_map(|item| match item {
        Item::Op(op) => Some(&op.name),
        Item::Script(script) => Some(&script.name),
        Item::Fn(function) => Some(&function.name),
        Item::Attr(_) | Item::Use(_) | Item::Test(_) | Item::Broken(_) => None,
    });
    names.find(|known| known.text == name).map(|name| name.span)
}

/// An item that more than one file may name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    /// The file that declares it, by its name in the sources.
    pub file: String,
    pub name: String,
    /// The place of its name in the file.
    pub place: Range<usize>,
}

/// The item whose name is at a byte, whichever file declares it.
pub fn shared(snapshot: &Snapshot, offset: usize) -> Option<Shared> {
    let mention = snapshot.names().at(offset)?;
    shared_item(snapshot, snapshot.names().symbol(mention.symbol))
}

/// The item that a symbol stands for, if other files may name it.
pub(super) fn shared_item(snapshot: &Snapshot, symbol: &Symbol) -> Option<Shared> {
    if symbol.item.is_some() {
        return None;
    }
    let place = declared(snapshot, symbol)?;
    Some(Shared {
        file: snapshot.sources().get(place.file).name().to_owned(),
        name: split_qualified(&symbol.name).1.to_owned(),
        place: place.range(),
    })
}

/// The mentions in a text of an item that may be declared in another file.
pub fn mentions_of_shared(snapshot: &Snapshot, shared: &Shared) -> Vec<Mention> {
    let names = snapshot.names();
    let of_name =
        names.symbols().filter(|(_, symbol)| split_qualified(&symbol.name).1 == shared.name);
    let symbols =
        of_name.filter(|(_, symbol)| shared_item(snapshot, symbol).as_ref() == Some(shared));
    symbols.flat_map(|(id, _)| names.mentions_of(id)).copied().collect()
}

/// All mentions of the name at a byte; those of a name of a rule are on both sides. An item is also
/// mentioned by a name with its file: `polygon::flip`.
pub fn occurrences(snapshot: &Snapshot, offset: usize) -> Vec<Mention> {
    if let Some(shared) = shared(snapshot, offset) {
        return mentions_of_shared(snapshot, &shared);
    }
    let Some(mention) = snapshot.names().at(offset) else { return Vec::new() };
    snapshot.names().mentions_of(mention.symbol).copied().collect()
}

/// The kind of thing that a name stands for, with an article.
pub fn a_word(symbol: &Symbol) -> &'static str {
    match symbol.kind {
        SymbolKind::Op => "an op",
        SymbolKind::Rule => "a rule",
        SymbolKind::Script => "a script",
        SymbolKind::Function => "a function",
        SymbolKind::Attribute => "an attribute",
        SymbolKind::Element(Some(kind)) => kind.a_word(),
        SymbolKind::Element(None) => "a name",
        SymbolKind::Parameter => "a parameter",
        SymbolKind::Index => "an index",
        SymbolKind::Variable => "a variable",
        SymbolKind::Elsewhere => "something",
    }
}

/// The path of a `use` at a byte, without quotes.
pub fn used_path(snapshot: &Snapshot, offset: usize) -> Option<&str> {
    match snapshot.item_at(offset)? {
        (_, Item::Use(used)) if used.path_span.touches(offset) => Some(&used.path),
        _ => None,
    }
}
