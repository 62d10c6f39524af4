//! Where a name is declared and mentioned, and what renaming it takes.

use super::names::{Mention, Symbol, SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::source::Span;
use crate::syntax::tree::Item;
use crate::syntax::{TokenKind, parse};

/// The place that declares the name at a byte, or draws it first.
pub fn definition(snapshot: &Snapshot, offset: usize) -> Option<Span> {
    let mention = snapshot.names().at(offset)?;
    snapshot.names().symbol(mention.symbol).definition
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
        return Err(format!("`{}` is not declared in this file", symbol.name));
    }
    Ok(mention)
}

/// What changes the name at a byte everywhere.
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
    let edit = |mention: &Mention| Edit {
        span: mention.span,
        text: to.to_owned(),
    };
    Ok(names.mentions_of(mention.symbol).map(edit).collect())
}

/// Whether a text can be a name.
fn is_name(text: &str) -> bool {
    let tokens = parse(Default::default(), text).tokens;
    matches!(tokens.as_slice(), [only] if only.kind.is_name() && only.span.range() == (0..text.len()))
        && TokenKind::KEYWORDS
            .iter()
            .all(|(word, kind)| *word != text || kind.is_soft())
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

/// What a name stands for, in words, with an article.
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
