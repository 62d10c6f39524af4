//! Renaming: the edits that change a name wherever it is mentioned, and a check that programs still
//! mean the same afterwards.
//!
//! Whether a rename is refused is not deduced but tried: the renamed programs are analyzed.

use std::collections::HashMap;

use super::names::{Mention, Names, Symbol, SymbolId, SymbolKind};
use super::occurrences::{Shared, a_word, mentions_of_shared, occurrences, shared};
use super::snapshot::Snapshot;
use super::soundness::Known;
use crate::diagnostic::{Diagnostic, Edit};
use crate::resolve::is_constant;
use crate::syntax::is_name;

/// The mention at a byte, if its name can be changed here.
///
/// # Errors
///
/// Says why it cannot.
pub fn renameable(snapshot: &Snapshot, offset: usize) -> Result<Mention, String> {
    let found = snapshot.names().at(offset);
    let mention = found.ok_or("there is no name here that this file declares")?;
    let symbol = snapshot.names().symbol(mention.symbol);
    match shared(snapshot, offset) {
        None if symbol.kind == SymbolKind::Elsewhere => {
            Err(format!("`{}` is not declared in this file", symbol.name))
        }
        Some(shared) if shared.file.starts_with(crate::library::FOLDER) => Err(format!(
            "`{}` is declared in `{}`, which ships with the language",
            symbol.name, shared.file
        )),
        _ => Ok(mention),
    }
}

/// The edits that rename the name at a byte throughout the text.
///
/// # Errors
///
/// Says why the name cannot be changed, or not to `to`.
pub fn rename(snapshot: &Snapshot, offset: usize, to: &str) -> Result<Vec<Edit>, String> {
    let mention = renameable(snapshot, offset)?;
    let to = to.trim();
    if !is_name(to) {
        return Err(format!(
            "`{to}` is not a name: a name has letters, digits and `_`, does not begin with a \
             digit, may end in primes, and is no keyword"
        ));
    }
    let names = snapshot.names();
    if names.symbol(mention.symbol).item.is_some() && is_constant(to) {
        return Err(format!("`{to}` is a value of the language"));
    }
    if let Some(taken) = taken(snapshot, mention.symbol, to) {
        return Err(format!("there is already {} `{to}` here", a_word(taken)));
    }
    let edit = |mention: Mention| Edit { span: mention.span, text: to.to_owned() };
    Ok(occurrences(snapshot, offset).into_iter().map(edit).collect())
}

/// The edits that rename an item in a text that may not be the one that declares it.
///
/// # Errors
///
/// Says why it cannot be changed to `to`.
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

/// Another name that would clash with this one once it is renamed.
fn taken<'s>(snapshot: &'s Snapshot, symbol: SymbolId, to: &str) -> Option<&'s Symbol> {
    let names = snapshot.names();
    let own = names.symbol(symbol);
    let mut others = names.symbols();
    let found = others.find(|(id, other)| *id != symbol && other.name == to && own.meets(other));
    found.map(|(_, other)| other)
}

/// Tries a rename on a program: `texts` are the changed texts of files, by their names.
///
/// # Errors
///
/// The first new error, or that some name would refer to something else.
pub fn stays_the_same(
    snapshot: &Snapshot,
    texts: &HashMap<String, String>,
    to: &str,
) -> Result<(), String> {
    let own = snapshot.sources().get(snapshot.file()).name();
    let text = texts.get(own).map_or(snapshot.text(), String::as_str);
    let renamed = Snapshot::new(own, text, &mut Known { sources: snapshot.sources(), texts });
    let is_error = |told: &&Diagnostic| told.is_error();
    let mut known: Vec<_> = snapshot.told().filter(is_error).map(|told| told.code).collect();
    for told in renamed.told().filter(is_error) {
        match known.iter().position(|code| *code == told.code) {
            Some(at) => drop(known.swap_remove(at)),
            None => return Err(told.message.clone()),
        }
    }
    let meant = |names: &Names| -> Vec<_> {
        names.mentions().iter().map(|mention| (mention.symbol, mention.role)).collect()
    };
    match meant(snapshot.names()) == meant(renamed.names()) {
        true => Ok(()),
        false => Err(format!("`{to}` means something else where the name stands")),
    }
}
