//! The type of the value before a dot.
//!
//! Around the dot the text is unfinished, and often cannot be parsed. A chain of words is followed
//! from its first name. Any other value is resolved as that of a variable, in a function in front of
//! the text whose parameters are the names in the value.

use std::collections::BTreeMap;

use super::field::attributes;
use crate::analysis::cursor_context::item_near;
use crate::analysis::files::Reader;
use crate::analysis::loop_heads::bound_near;
use crate::analysis::snapshot::Snapshot;
use crate::analysis::types::type_of;
use crate::diagram::Type;
use crate::resolve::fields;
use crate::source::Span;
use crate::syntax::{Token, TokenKind as T};

/// The name of the variable and of its function, which no program would choose.
const NAME: &str = "before_the_dot''";

/// The type of the value that some tokens are, before a byte.
pub(super) fn type_of_operand(
    snapshot: &Snapshot,
    offset: usize,
    operand: &[Token],
    reader: &mut dyn Reader,
) -> Option<Type> {
    let is_chain = |token: &Token| token.kind.is_wordlike() || token.kind == T::Dot;
    match operand.iter().all(is_chain) {
        true => type_of_chain(snapshot, offset, operand),
        false => type_of_value(snapshot, offset, operand, reader),
    }
}

fn type_of_chain(snapshot: &Snapshot, offset: usize, chain: &[Token]) -> Option<Type> {
    let words = chain.iter().filter(|token| token.kind != T::Dot);
    let mut words = words.map(|token| snapshot.sources().slice(token.span));
    let mut ty = type_of_name(snapshot, offset, words.next()?)?;
    for word in words {
        let declared = || attributes(snapshot, ty).find(|attr| attr.name.text == *word);
        ty = match fields(ty).into_iter().find(|field| field.name == word) {
            Some(known) => known.ty?,
            None => Type::named(&declared()?.ty.text)?,
        };
    }
    Some(ty)
}

fn type_of_value(
    snapshot: &Snapshot,
    offset: usize,
    value: &[Token],
    reader: &mut dyn Reader,
) -> Option<Type> {
    let words: Vec<_> = value.iter().map(|token| snapshot.sources().slice(token.span)).collect();
    let kind = |at: Option<usize>| at.and_then(|at| value.get(at)).map(|token| token.kind);
    let is_name = |at: &usize| {
        let before = kind(at.checked_sub(1));
        kind(Some(*at)).is_some_and(T::is_name)
            && !matches!(before, Some(T::Dot | T::DoubleColon))
            && !matches!(kind(at.checked_add(1)), Some(T::LeftParen | T::DoubleColon))
    };
    let names = (0..value.len()).filter(is_name).map(|at| words[at]);
    let typed = names.filter_map(|name| Some((name, type_of_name(snapshot, offset, name)?)));
    let typed: BTreeMap<_, _> = typed.collect();
    let params = typed.iter().map(|(name, ty)| format!("{name}: {}", ty.word()));
    let head = format!("fn {NAME}({}) {{ let ", params.collect::<Vec<_>>().join(", "));
    let text = format!("{head}{NAME} = {} }}\n{}", words.join(" "), snapshot.text());
    let resolved = snapshot.next(&text, reader);
    resolved.type_at(Span::new(resolved.file(), head.len(), head.len() + NAME.len()))
}

/// The type of what a name stands for at a byte.
fn type_of_name(snapshot: &Snapshot, offset: usize, name: &str) -> Option<Type> {
    let bound = bound_near(snapshot, offset);
    if let Some((_, ty)) = bound.into_iter().rfind(|(bound, _)| *bound == name) {
        return ty;
    }
    let (item, _) = item_near(snapshot, offset)?;
    // Of several variables of a name, the last before the cursor is the likeliest.
    let symbol = snapshot
        .names()
        .symbols()
        .filter(|(_, symbol)| {
            let is_before = symbol.definition.is_none_or(|place| (place.start as usize) < offset);
            symbol.name == name && symbol.item == Some(item) && is_before
        })
        .last();
    type_of(snapshot, symbol?.0)
}
