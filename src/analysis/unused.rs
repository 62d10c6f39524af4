//! Names that are declared and never read: of variables there is a warning, the others are faint in
//! editors.

use super::files::Part;
use super::names::{Names, Role, Symbol, SymbolId, SymbolKind};
use super::snapshot::Snapshot;
use crate::diagnostic::{Diagnostic, Edit, Fix};
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

/// The parameters and private items of a text that nothing reads or calls; a name that begins with
/// `_` may go unused.
pub fn unused(snapshot: &Snapshot) -> Vec<Unused> {
    let names = snapshot.names();
    let unread = names.symbols().filter(|(id, symbol)| !is_used(names, *id, symbol));
    let told = unread.filter_map(|(_, symbol)| {
        let what = what(snapshot, symbol)?;
        Some(Unused { span: symbol.definition?, name: symbol.name.clone(), what })
    });
    told.collect()
}

/// A warning for each variable of a file that nothing reads. A loop or an aggregate has to name its
/// element, so that name may go unused, as may one that begins with `_`.
pub(super) fn unused_variables(names: &Names, part: &Part) -> Vec<Diagnostic> {
    let tokens = &part.parsed.tokens;
    let is_let = |place: Span| {
        let at = tokens.partition_point(|token| token.span.start < place.start);
        let before = at.checked_sub(1).and_then(|at| tokens.get(at));
        before.is_some_and(|word| matches!(word.kind, TokenKind::Let | TokenKind::Var))
    };
    let told = names.symbols().filter_map(|(id, symbol)| {
        if symbol.kind != SymbolKind::Variable || is_used(names, id, symbol) {
            return None;
        }
        let place = symbol.definition.filter(|place| is_let(*place))?;
        let is_set = names.mentions_of(id).any(|mention| mention.role == Role::Written);
        let message = match is_set {
            true => format!("`{}` is set and never read", symbol.name),
            false => format!("`{}` is never read", symbol.name),
        };
        let text = || "_".to_owned();
        let mentions = names.mentions_of(id);
        let edits = mentions.map(|at| Edit { span: at.span.before(), text: text() }).collect();
        let title = format!("name it `_{}`, which may go unread", symbol.name);
        let warning = Diagnostic::warning("unused-variable", message, place);
        Some(Diagnostic { fixes: vec![Fix { title, edits }], ..warning })
    });
    told.collect()
}

/// Whether a name is read or called, or may go unused.
fn is_used(names: &Names, id: SymbolId, symbol: &Symbol) -> bool {
    let is_read = |role: Role| !matches!(role, Role::Declared | Role::Written);
    symbol.name.starts_with('_') || names.mentions_of(id).any(|mention| is_read(mention.role))
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
        SymbolKind::Attribute => private("attribute"),
        SymbolKind::Op => private("op"),
        SymbolKind::Function => private("function"),
        SymbolKind::Script => private("script"),
        _ => None,
    }
}
