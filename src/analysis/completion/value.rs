//! Completions in values.

use super::choice::{Choice, Completion};
use super::drawing::named;
use super::words::{ACTIONS, REQUIRE, keywords};
use crate::analysis::being_declared::being_declared;
use crate::analysis::cursor_context::{Start, item_near, letters_before, op_near, rule_near};
use crate::analysis::library_hints::{Importable, importable};
use crate::analysis::loop_heads::bound_near;
use crate::analysis::names::{Symbol, SymbolKind};
use crate::analysis::signature::Head;
use crate::analysis::snapshot::Snapshot;
use crate::analysis::types::type_of;
use crate::analysis::words::meaning;
use crate::diagram::{Kind, Type};
use crate::resolve::{constants, function_words, mesh_words, sequence_words, signatures};
use crate::syntax::tree::Item;

/// Completions in a value; a statement, where one may begin.
pub(super) fn values(snapshot: &Snapshot, offset: usize, start: Start) -> Vec<Completion> {
    let mut found = Vec::new();
    if start == Start::Statement {
        found.extend(keywords(ACTIONS));
        let in_steps = op_near(snapshot, offset).is_some_and(|(_, op)| op.steps.is_some());
        found.extend(keywords(&[REQUIRE]).into_iter().filter(|_| in_steps));
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
        let docs = meaning(word).map(str::to_owned).into_iter().collect();
        let call = Completion::call(word, detail, docs, Choice::Function);
        found.push(Completion { rank: function_rank, ..call });
    }
    let seen = snapshot.seen_items(None);
    found.extend(snapshot.items().iter().chain(seen).filter_map(|item| called(snapshot, item)));
    let can_call = can_call(snapshot, offset);
    found.extend(of_library(snapshot, offset, can_call));
    let must = can_call.then_some("must");
    let words = ["if", "true", "false", "not", "can", "why"].into_iter().chain(must);
    for word in words.chain(constants()) {
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
    let call = |Importable { name, file, is_function, signature, docs, insertion }: Importable| {
        let choice = if is_function { Choice::Function } else { Choice::Op };
        let call = Completion::call(name, format!("{signature}, in {file}"), docs, choice);
        Completion { insertion: Some(insertion), rank: 9, ..call }
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
    snapshot.seen_items(Some(file)).filter_map(|item| called(snapshot, item)).collect()
}

/// The call of an item.
fn called(snapshot: &Snapshot, item: &Item) -> Option<Completion> {
    let head = Head::of(item)?;
    let choice = if matches!(item, Item::Op(_)) { Choice::Op } else { Choice::Function };
    let signature = head.signature(snapshot);
    Some(Completion::call(head.name, signature, head.docs.to_vec(), choice))
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
