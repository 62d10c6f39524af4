//! Occurrences of a name: its declaration and its mentions, and how to rename it.

use super::names::{Mention, Symbol, SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::source::Span;
use crate::syntax::tree::Item;
use crate::syntax::{TokenKind, parse};

/// The place that declares the name at a byte, or draws it first; perhaps in another file.
pub fn definition(snapshot: &Snapshot, offset: usize) -> Option<Span> {
    let mention = snapshot.names().at(offset)?;
    let symbol = snapshot.names().symbol(mention.symbol);
    match symbol.kind {
        SymbolKind::Elsewhere => declared_elsewhere(snapshot, &symbol.name),
        _ => symbol.definition,
    }
}

/// The item of a file that is used, by its name.
fn declared_elsewhere(snapshot: &Snapshot, name: &str) -> Option<Span> {
    let items = snapshot.seen().flat_map(|(_, tree)| &tree.items);
    let mut names = items.filter_map(|item| match item {
        Item::Op(op) => Some(&op.name),
        Item::Script(script) => Some(&script.name),
        Item::Fn(function) => Some(&function.name),
        Item::Attr(attr) => Some(&attr.name),
        Item::Use(_) | Item::Test(_) | Item::Broken(_) => None,
    });
    names.find(|known| known.text == name).map(|name| name.span)
}

/// An item that more than one file may name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shared {
    /// The file that declares it, as it is called among the sources.
    pub file: String,
    /// Its name.
    pub name: String,
}

/// The item whose name stands at a byte, whichever file declares it.
pub fn shared(snapshot: &Snapshot, offset: usize) -> Option<Shared> {
    let mention = snapshot.names().at(offset)?;
    let symbol = snapshot.names().symbol(mention.symbol);
    if symbol.item.is_some() {
        return None;
    }
    let place = definition(snapshot, offset)?;
    Some(Shared {
        file: snapshot.sources().get(place.file).name().to_owned(),
        name: symbol.name.clone(),
    })
}

/// The mentions in a text of an item that may be declared in another file.
pub fn mentions_of_shared(snapshot: &Snapshot, shared: &Shared) -> Vec<Mention> {
    let names = snapshot.names();
    let own_name = snapshot.sources().get(snapshot.file()).name();
    let symbol = names.symbols().find(|(_, symbol)| {
        let declared_here = own_name == shared.file;
        let is_elsewhere = symbol.kind == SymbolKind::Elsewhere;
        symbol.item.is_none()
            && symbol.name == shared.name
            && declared_here != is_elsewhere
            && (declared_here || declared_in(snapshot, shared))
    });
    symbol.map_or_else(Vec::new, |(id, _)| names.mentions_of(id).copied().collect())
}

/// True if the name means the item of that file here.
fn declared_in(snapshot: &Snapshot, shared: &Shared) -> bool {
    declared_elsewhere(snapshot, &shared.name)
        .is_some_and(|place| snapshot.sources().get(place.file).name() == shared.file)
}

/// All mentions of the name at a byte, in the order of the text: in a rule, on both sides.
pub fn occurrences(snapshot: &Snapshot, offset: usize) -> Vec<Mention> {
    let Some(mention) = snapshot.names().at(offset) else {
        return Vec::new();
    };
    let names = snapshot.names();
    names.mentions_of(mention.symbol).copied().collect()
}

/// The mention at a byte, if its name can be changed here.
///
/// # Errors
///
/// Says why it cannot.
pub fn renameable(snapshot: &Snapshot, offset: usize) -> Result<Mention, String> {
    let found = snapshot.names().at(offset);
    let mention = found.ok_or("there is no name here that this file declares")?;
    let symbol = snapshot.names().symbol(mention.symbol);
    if symbol.kind == SymbolKind::Elsewhere {
        let Some(shared) = shared(snapshot, offset) else {
            return Err(format!("`{}` is not declared in this file", symbol.name));
        };
        if shared.file.starts_with(crate::library::FOLDER) {
            return Err(format!(
                "`{}` is declared in `{}`, which ships with the language",
                symbol.name, shared.file
            ));
        }
    }
    Ok(mention)
}

/// The edits that rename the name at a byte everywhere.
///
/// # Errors
///
/// Says why the name cannot be changed, or not to this.
pub fn rename(snapshot: &Snapshot, offset: usize, to: &str) -> Result<Vec<Edit>, String> {
    let mention = renameable(snapshot, offset)?;
    let to = to.trim();
    if !is_name(to) {
        return Err(format!(
            "`{to}` is no name: a name has letters, digits and `_`, does not begin with a \
             digit, may end in primes, and is no keyword"
        ));
    }
    if let Some(taken) = taken(snapshot, mention.symbol, to) {
        return Err(format!("there is already {} `{to}` here", a_word(taken)));
    }
    let names = snapshot.names();
    let edit = |mention: &Mention| Edit { span: mention.span, text: to.to_owned() };
    Ok(names.mentions_of(mention.symbol).map(edit).collect())
}

/// The edits that rename an item in a text that may not be the one that declares it.
///
/// # Errors
///
/// Says why it cannot be changed to this.
pub fn rename_shared(snapshot: &Snapshot, item: &Shared, to: &str) -> Result<Vec<Edit>, String> {
    let mentions = mentions_of_shared(snapshot, item);
    if let Some(first) = mentions.first()
        && let Some(taken) = taken(snapshot, first.symbol, to)
    {
        let file = snapshot.sources().get(snapshot.file()).name();
        let what = a_word(taken);
        return Err(format!("there is already {what} `{to}` in `{file}`"));
    }
    let edits =
        mentions.into_iter().map(|mention| Edit { span: mention.span, text: to.to_owned() });
    Ok(edits.collect())
}

/// True if a text can be a name.
fn is_name(text: &str) -> bool {
    let tokens = parse(Default::default(), text).tokens;
    matches!(tokens.as_slice(), [only] if only.kind.is_name() && only.span.range() == (0..text.len()))
        && TokenKind::KEYWORDS.iter().all(|(word, kind)| *word != text || kind.is_soft())
}

/// Another name that would be the same as this one, renamed.
fn taken<'s>(snapshot: &'s Snapshot, symbol: SymbolId, to: &str) -> Option<&'s Symbol> {
    let names = snapshot.names();
    let own = names.symbol(symbol);
    let meets = |other: &Symbol| {
        if own.item.is_none() || other.item.is_none() {
            return own.item.is_none() && other.item.is_none();
        }
        let same_rule = own.rule.is_none() || other.rule.is_none() || own.rule == other.rule;
        own.item == other.item && same_rule
    };
    let mut others = names.symbols();
    let found = others.find(|(id, other)| *id != symbol && other.name == to && meets(other));
    found.map(|(_, other)| other)
}

/// The thing that a name stands for, in words, with an article.
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
