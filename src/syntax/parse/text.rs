//! Texts with embedded values: `"mean {mean(len):.3} of {n}"`.
//!
//! The tokens are cut at the braces: `"mean {`, the value, `:.3} of {`, the value, `}"`. The format
//! between a value and its closing brace determines how it is printed.

use super::failure::{Failure, Mistake};
use super::input::{Rule, slice};
use crate::source::Span;
use crate::syntax::text::read_text;
use crate::syntax::token::TokenKind as T;
use crate::syntax::tree::{Digits, Expr, Piece};
use chumsky::prelude::*;

/// The maximum number of digits after the point.
pub(super) const MOST_DIGITS: u8 = 17;

/// The pieces of a text with at least one embedded value.
pub(super) fn text_with_values<'t>(expression: Rule<'t, Expr>) -> Rule<'t, Vec<Piece>> {
    let head = select! { T::TextHead => () }.map_with(|(), scene| unquoted(slice(scene)));
    let behind = |kind: T| {
        let token = just(kind);
        token.validate(|_, scene, emitter| {
            let (digits, text) = cut(slice(scene));
            let digits = digits.unwrap_or_else(|| {
                let span: Span = scene.span();
                emitter.emit(Failure::mistake(Mistake::UnknownFormat, span));
                Digits::Few
            });
            (digits, text)
        })
    };
    let value = expression.clone().then(behind(T::TextMiddle));
    let last = expression.then(behind(T::TextTail));
    head.then(value.repeated().collect::<Vec<_>>())
        .then(last)
        .map(|((head, values), last)| {
            let mut pieces = vec![Piece::Text(head)];
            for (value, (digits, text)) in values.into_iter().chain([last]) {
                pieces.extend([Piece::Value(value, digits), Piece::Text(text)]);
            }
            pieces.retain(|piece| *piece != Piece::Text(String::new()));
            pieces
        })
        .boxed()
}

/// The text of a token after its first character, without the brace at its end.
fn unquoted(token: &str) -> String {
    read_text(token.strip_suffix('{').unwrap_or(token)).value
}

/// The format before the brace that ends a value, and the text after it. `None` if the format is
/// unknown.
fn cut(token: &str) -> (Option<Digits>, String) {
    let end = token.find('}').unwrap_or(0);
    let text = unquoted(&token[end..]);
    let digits = match token[..end].trim().strip_prefix(':').map(str::trim) {
        None => Some(Digits::Few),
        Some("full") => Some(Digits::All),
        Some(format) => {
            let count = format.strip_prefix('.').and_then(|count| count.parse().ok());
            count.filter(|&count: &u8| count <= MOST_DIGITS).map(Digits::Behind)
        }
    };
    (digits, text)
}
