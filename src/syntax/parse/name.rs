//! Names, subscripts, types and texts.

use super::failure::{Failure, Mistake, Phrase};
use super::input::{Rule, Scene, slice};
use crate::source::Span;
use crate::syntax::text::read_text;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{Ident, Index, Name, qualified};
use chumsky::prelude::*;

pub(super) fn ident_here(scene: &mut Scene) -> Ident {
    Ident { text: slice(scene).to_owned(), span: scene.span() }
}

/// A keyword used as the name of a function.
pub(super) fn name_here(scene: &mut Scene) -> Name {
    Name { ident: ident_here(scene), index: None, span: scene.span() }
}

/// A name without a subscript.
pub(super) fn ident<'t>() -> Rule<'t, Ident> {
    select! { kind if T::is_name(kind) => () }
        .map_with(|(), scene| ident_here(scene))
        .labelled(Phrase::Name)
        .boxed()
}

/// A qualified name: `triangle::flip`.
pub(super) fn qualified_name<'t>() -> Rule<'t, Name> {
    // It goes on as an operator would.
    let mark = just(T::DoubleColon).labelled(Phrase::Operator);
    ident()
        .then_ignore(mark)
        .then(ident())
        .map_with(|(file, name), scene| {
            let (text, span) = (qualified(&file.text, &name.text), scene.span());
            Name { ident: Ident { text, span }, index: None, span }
        })
        .boxed()
}

/// A word where no statement can begin, so that keywords are allowed too: a field, a type.
pub(super) fn word<'t>() -> Rule<'t, Ident> {
    select! { kind if T::is_wordlike(kind) => () }
        .map_with(|(), scene| ident_here(scene))
        .labelled(Phrase::Name)
        .boxed()
}

/// The name of a type.
pub(super) fn type_word<'t>() -> Rule<'t, Ident> {
    word().labelled(Phrase::Type).boxed()
}

/// A name of a drawing: `v0`, `v[i+1]`, `a[0]`.
pub(super) fn name<'t>() -> Rule<'t, Name> {
    ident()
        .then(subscript().or_not())
        .map_with(|(ident, index), scene| Name { ident, index, span: scene.span() })
        .boxed()
}

/// A name in a list; not one before a dot, which begins the next statement, `v.position = …`.
pub(super) fn listed_name<'t>() -> Rule<'t, Name> {
    name().then_ignore(just(T::Dot).not()).boxed()
}

/// `[i]`, `[i+1]`, `[0]`
fn subscript<'t>() -> Rule<'t, Index> {
    let int = select! { T::Int => () }.map_with(|(), scene| int_here(scene));
    let sign = just(T::Plus).to(1).or(just(T::Minus).to(-1));
    let offset = sign.then(int);
    let moved = ident()
        .then(offset.or_not())
        .map(|(variable, offset)| (Some(variable), offset.unwrap_or((1, 0))));
    let fixed = sign.or_not().then(int).map(|(sign, int)| {
        let variable: Option<Ident> = None;
        (variable, (sign.unwrap_or(1), int))
    });
    moved
        .or(fixed)
        .labelled(Phrase::Index)
        .map_with(|(variable, (sign, int)), scene| Index {
            variable,
            offset: sign * int,
            span: scene.span(),
        })
        .delimited_by(just(T::LeftBracket).labelled(Phrase::Subscript), just(T::RightBracket))
        .boxed()
}

/// The value of an int token; one that is too large has been reported and becomes the maximum.
pub(super) fn int_here(scene: &mut Scene) -> i64 {
    slice(scene).trim_end_matches(|c: char| !c.is_ascii_digit()).parse().unwrap_or(i64::MAX)
}

/// A text in quotes and its place.
pub(super) fn text<'t>() -> Rule<'t, (String, Span)> {
    select! { T::Text => () }
        .map_with(|(), scene| (read_text(slice(scene)).value, scene.span()))
        .labelled(Phrase::Text)
        .boxed()
}

/// A text where embedded values are not allowed.
pub(super) fn plain_text<'t>() -> Rule<'t, (String, Span)> {
    let inside = any().and_is(just(T::TextTail).not()).repeated();
    let with_values = just(T::TextHead)
        .ignore_then(inside)
        .ignore_then(just(T::TextTail))
        .validate(|_, scene, emitter| {
            let span = scene.span();
            emitter.emit(Failure::mistake(Mistake::ValuesInText, span));
            (String::new(), span)
        });
    text().or(with_values).boxed()
}
