//! Completions in values.

use super::choice::{Choice, Completion};
use super::drawing::named;
use super::words::{ACTIONS, keywords};
use crate::analysis::being_declared::being_declared;
use crate::analysis::cursor_context::{Start, item_near, letters_before, op_near, rule_near};
use crate::analysis::library_hints::{Importable, importable};
use crate::analysis::loop_heads::bound_near;
use crate::analysis::names::{Names, Symbol, SymbolKind};
use crate::analysis::snapshot::Snapshot;
use crate::analysis::types::type_of;
use crate::diagram::{Kind, Type};
use crate::resolve::{fields, function_words, mesh_words, sequence_words, signatures};
use crate::syntax::tree::{Attr, Item};

/// Completions in a value; a statement, where one may begin.
pub(super) fn values(snapshot: &Snapshot, offset: usize, start: Start) -> Vec<Completion> {
    let mut found = Vec::new();
    if start == Start::Statement {
        found.extend(keywords(ACTIONS));
    }
    // A statement may go on with a value, but does not begin with one.
    let (function_rank, word_rank) = if start == Start::Statement { (7, 8) } else { (3, 6) };
    if start == Start::Default {
        found.push(Completion::new("inherited", Choice::Keyword, 2).with("inherited($1)"));
    }
    if matches!(item_near(snapshot, offset), Some((_, Item::Test(_)))) {
        found.push(Completion::new("mesh", Choice::Variable, 1));
        found.push(Completion::new("refuses", Choice::Function, 1).with("refuses($1)"));
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
            ..Completion::new(word, Choice::Function, function_rank).with(&snippet)
        });
    }
    let seen = snapshot.seen_items(None);
    found.extend(snapshot.items().iter().chain(seen).filter_map(called));
    let can_call = can_call(snapshot, offset);
    found.extend(of_library(snapshot, offset, can_call));
    let must = can_call.then_some("must");
    for word in ["if", "true", "false", "not", "can", "why", "pi"].into_iter().chain(must) {
        found.push(Completion::new(word, Choice::Keyword, word_rank));
    }
    found
}

/// What the library has of the word that is being written, in files that are not used yet.
fn of_library(snapshot: &Snapshot, offset: usize, can_call: bool) -> Vec<Completion> {
    let letters = letters_before(snapshot, offset);
    if letters.is_empty() {
        return Vec::new();
    }
    let found = importable(snapshot, letters).into_iter();
    let found = found.filter(|item| can_call || item.is_function);
    let call = |Importable { name, file, is_function, insertion }: Importable| Completion {
        detail: file.to_owned(),
        insertion: Some(insertion),
        ..Completion::new(name, if is_function { Choice::Function } else { Choice::Op }, 9)
            .with(&format!("{name}($1)"))
    };
    found.map(call).collect()
}

/// True if ops can be called at a byte, in a script, a test or steps.
fn can_call(snapshot: &Snapshot, offset: usize) -> bool {
    let is_drawn = op_near(snapshot, offset).is_some_and(|(_, op)| op.steps.is_none());
    let item = item_near(snapshot, offset).map(|(_, item)| item);
    matches!(item, Some(Item::Script(_) | Item::Test(_) | Item::Op(_))) && !is_drawn
}

/// What a mesh of a test can be.
pub(super) fn meshes(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let made = mesh_words().map(|(word, takes)| {
        let call = if takes { format!("{word}($1)") } else { format!("{word}()") };
        Completion::new(word, Choice::Function, 0).with(&call)
    });
    made.chain(variables(snapshot, offset)).collect()
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
    let bound = bound_near(snapshot, offset).into_iter().map(|(name, ty)| variable(name, ty));
    let Some((item, node)) = item_near(snapshot, offset) else { return bound.collect() };
    let is_op = matches!(node, Item::Op(_));
    let rule = rule_near(snapshot, offset).map(|(_, rule, _)| rule);
    let declared = being_declared(snapshot, offset);
    let before = |symbol: &Symbol| {
        let definition = symbol.definition.filter(|_| symbol.definition != declared);
        definition.is_some_and(|place| (place.end as usize) < offset)
    };
    let own = names.symbols().filter(|(_, symbol)| {
        symbol.item == Some(item) && (symbol.rule.is_none() || symbol.rule == rule)
    });
    let own = own.filter_map(|(id, symbol)| match symbol.kind {
        SymbolKind::Element(Some(kind)) if is_op && !matches!(kind, Kind::Path | Kind::Fan) => {
            Some(named(symbol, kind, 1))
        }
        SymbolKind::Variable if !before(symbol) => None,
        SymbolKind::Parameter | SymbolKind::Variable => {
            Some(variable(&symbol.name, type_of(snapshot, id)))
        }
        _ => None,
    });
    own.chain(bound).collect()
}

fn variable(name: &str, ty: Option<Type>) -> Completion {
    Completion {
        detail: ty.map_or("", Type::word).to_owned(),
        ..Completion::new(name, Choice::Variable, 1)
    }
}

/// The completions after the dot of a chain.
pub(super) fn of_chain(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Vec<Completion> {
    let Some(ty) = chain_type(snapshot, offset, chain) else { return Vec::new() };
    let field = |name: &str, ty: Option<Type>, rank| Completion {
        detail: ty.map_or("sequence", Type::word).to_owned(),
        ..Completion::new(name, Choice::Field, rank)
    };
    let mut found: Vec<_> = fields(ty)
        .into_iter()
        .map(|known| field(known.name, known.ty, u8::from(!known.is_attribute)))
        .collect();
    found.extend(attributes(snapshot, ty).map(|attr| Completion {
        detail: attr.ty.text.clone(),
        ..Completion::new(attr.name.text.clone(), Choice::Field, 0)
    }));
    found
}

/// The attributes of elements of a type that the text or a file it uses declares.
fn attributes(snapshot: &Snapshot, of: Type) -> impl Iterator<Item = &Attr> {
    let items = snapshot.items().iter().chain(snapshot.seen_items(None));
    items.filter_map(move |item| match item {
        Item::Attr(attr) if attr.kind.text == of.word() => Some(attr),
        _ => None,
    })
}

fn chain_type(snapshot: &Snapshot, offset: usize, chain: &[String]) -> Option<Type> {
    let (first, rest) = chain.split_first()?;
    let mut ty = type_of_name(snapshot, offset, first)?;
    for word in rest {
        let declared = || attributes(snapshot, ty).find(|attr| attr.name.text == *word);
        ty = match fields(ty).into_iter().find(|field| field.name == word) {
            Some(known) => known.ty?,
            None => Type::named(&declared()?.ty.text)?,
        };
    }
    Some(ty)
}

/// The type of what a name stands for at a byte.
fn type_of_name(snapshot: &Snapshot, offset: usize, name: &str) -> Option<Type> {
    let bound = bound_near(snapshot, offset);
    if let Some((_, ty)) = bound.into_iter().rfind(|(bound, _)| *bound == name) {
        return ty;
    }
    let (item, _) = item_near(snapshot, offset)?;
    let names: &Names = snapshot.names();
    // Of several variables of a name, the last before the cursor is the likeliest.
    let symbol = names
        .symbols()
        .filter(|(_, symbol)| {
            let is_before = symbol.definition.is_none_or(|place| (place.start as usize) < offset);
            symbol.name == name && symbol.item == Some(item) && is_before
        })
        .last();
    type_of(snapshot, symbol?.0)
}
