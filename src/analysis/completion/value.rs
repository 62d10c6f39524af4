//! Completions in values.

use super::choice::{Choice, Completion};
use super::drawing::named;
use super::words::{ACTIONS, keywords};
use crate::analysis::cursor_context::{Start, item_near, rule_near};
use crate::analysis::names::{Names, Symbol, SymbolId, SymbolKind};
use crate::analysis::snapshot::Snapshot;
use crate::analysis::types::type_of;
use crate::diagram::{Kind, Type};
use crate::resolve::{fields, function_words, sequence_words, signatures};
use crate::syntax::tree::Item;

/// Completions in a value; a statement, where one may begin.
pub(super) fn values(snapshot: &Snapshot, offset: usize, start: Start) -> Vec<Completion> {
    let mut found = Vec::new();
    if start == Start::Statement {
        found.extend(keywords(ACTIONS));
    }
    let sequence_rank = if start == Start::Sequence { 0 } else { 4 };
    let sequences = sequence_words();
    found.extend(sequences.map(|word| Completion::new(word, Choice::Variable, sequence_rank)));
    found.extend(variables(snapshot, offset));
    for word in function_words() {
        let forms = signatures(word);
        let detail = forms.first().map_or(String::new(), |way| {
            let gives = way.gives.map(|ty| format!(" -> {}", ty.word()));
            format!("({}){}", way.takes.join(", "), gives.unwrap_or_default())
        });
        let snippet = format!("{word}($1)");
        found.push(Completion {
            detail,
            ..Completion::new(word, Choice::Function, 3).with(&snippet)
        });
    }
    let seen = snapshot.seen_items(None);
    found.extend(snapshot.items().iter().chain(seen).filter_map(called));
    for word in ["if", "true", "false", "not", "can", "why", "pi"] {
        found.push(Completion::new(word, Choice::Keyword, 6));
    }
    found
}

/// What the used files of a name declare, to be called.
pub(super) fn of_file(snapshot: &Snapshot, file: &str) -> Vec<Completion> {
    snapshot.seen_items(Some(file)).filter_map(called).collect()
}

/// The call of an item.
fn called(item: &Item) -> Option<Completion> {
    let (name, choice) = match item {
        Item::Op(op) => (&op.name.text, Choice::Op),
        Item::Fn(function) => (&function.name.text, Choice::Function),
        Item::Script(script) => (&script.name.text, Choice::Function),
        _ => return None,
    };
    Some(Completion::new(name, choice, 2).with(&format!("{name}($1)")))
}

/// The variables and parameters of the item around a byte; in an op also the elements it draws.
fn variables(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let names = snapshot.names();
    let Some((item, node)) = item_near(snapshot, offset) else {
        return Vec::new();
    };
    let is_op = matches!(node, Item::Op(_));
    let rule = rule_near(snapshot, offset).map(|(_, rule, _)| rule);
    let before =
        |symbol: &Symbol| symbol.definition.is_some_and(|place| (place.end as usize) < offset);
    let own = names.symbols().filter(|(_, symbol)| {
        symbol.item == Some(item) && (symbol.rule.is_none() || symbol.rule == rule)
    });
    own.filter_map(|(id, symbol)| match symbol.kind {
        SymbolKind::Element(Some(kind)) if is_op && !matches!(kind, Kind::Path | Kind::Fan) => {
            Some(named(symbol, kind, 1))
        }
        SymbolKind::Parameter => Some(variable(snapshot, id, symbol)),
        SymbolKind::Variable if before(symbol) => Some(variable(snapshot, id, symbol)),
        _ => None,
    })
    .collect()
}

fn variable(snapshot: &Snapshot, id: SymbolId, symbol: &Symbol) -> Completion {
    let ty = type_of(snapshot, id).map_or("", Type::word);
    Completion {
        detail: ty.to_owned(),
        ..Completion::new(symbol.name.clone(), Choice::Variable, 1)
    }
}

/// The completions after the dot of a chain.
pub(super) fn of_chain(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Vec<Completion> {
    let Some(ty) = chain_type(snapshot, offset, chain) else {
        return Vec::new();
    };
    let field = |name: &str, ty: Option<Type>, rank| Completion {
        detail: ty.map_or("sequence", Type::word).to_owned(),
        ..Completion::new(name, Choice::Field, rank)
    };
    let mut found: Vec<_> = fields(ty)
        .into_iter()
        .map(|known| field(known.name, known.ty, u8::from(!known.is_attribute)))
        .collect();
    for item in snapshot.items() {
        if let Item::Attr(attr) = item
            && attr.kind.text == ty.word()
        {
            let word = attr.name.text.clone();
            found.push(Completion {
                detail: attr.ty.text.clone(),
                ..Completion::new(word, Choice::Field, 0)
            });
        }
    }
    found
}

fn chain_type(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Option<Type> {
    let (first, rest) = chain.split_first()?;
    let (item, _) = item_near(snapshot, offset)?;
    let names: &Names = snapshot.names();
    // Of several variables of a name, the last before the cursor is the likeliest.
    let symbol = names
        .symbols()
        .filter(|(_, symbol)| {
            let is_before = symbol.definition.is_none_or(|place| (place.start as usize) < offset);
            symbol.name == *first && symbol.item == Some(item) && is_before
        })
        .last();
    let mut ty = type_of(snapshot, symbol?.0)?;
    for word in rest {
        let known = fields(ty).into_iter().find(|field| field.name == word)?;
        ty = known.ty?;
    }
    Some(ty)
}
