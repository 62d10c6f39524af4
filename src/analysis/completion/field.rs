//! Completions after a dot.

use super::choice::{Choice, Completion};
use super::operand::type_of_operand;
use crate::analysis::files::Reader;
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Type;
use crate::resolve::fields;
use crate::syntax::Token;
use crate::syntax::tree::{Attr, Item};

/// The fields of the value that some tokens are.
pub(super) fn fields_of(
    snapshot: &Snapshot,
    offset: usize,
    operand: &[Token],
    reader: &mut dyn Reader,
) -> Vec<Completion> {
    let Some(ty) = type_of_operand(snapshot, offset, operand, reader) else { return Vec::new() };
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
        docs: attr.docs.clone(),
        ..Completion::new(attr.name.text.clone(), Choice::Field, 0)
    }));
    found
}

/// The attributes of elements of a type that the text or a file it uses declares.
pub(super) fn attributes(snapshot: &Snapshot, of: Type) -> impl Iterator<Item = &Attr> {
    let items = snapshot.items().iter().chain(snapshot.seen_items(None));
    items.filter_map(move |item| match item {
        Item::Attr(attr) if attr.kind.text == of.word() => Some(attr),
        _ => None,
    })
}
