//! What people write who come from other languages, and how it is written here.

use super::failure::Failure;
use super::report::Around;
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::token::{Token, TokenKind as T};

/// How far the beginning of a condition is looked for, in tokens.
const FARTHEST: usize = 64;

const COMMENT: &str = "a comment begins with `//` and ends with its line";

/// Tells how something is written here, if it is written so elsewhere.
pub(super) fn told_here(told: Diagnostic, failure: &Failure, around: &Around) -> Diagnostic {
    let tokens = around.item;
    let at = tokens.partition_point(|token| token.span.start < failure.span.start);
    let (before, rest) = tokens.split_at(at);
    let [here, after @ ..] = rest else {
        return told;
    };
    let last = before.last().map(|token| token.kind);
    let touches = |one: &Token, other: &Token| one.span.end == other.span.start;
    match here.kind {
        T::Equals if before.last().is_some_and(|last| is_sign(last, here)) => {
            told.note("a change is written out: `x = x + 1`")
        }
        T::Equals if in_condition(before) => written(told, here.span, "=="),
        T::Bar => match after.first().filter(|next| next.kind == T::Bar) {
            Some(next) if touches(here, next) => written(told, here.span.to(next.span), "or"),
            _ => told,
        },
        T::Edge if last == Some(T::In) => written(told, here.span, "edges"),
        T::Vertex if last == Some(T::In) => written(told, here.span, "vertices"),
        T::Face if last == Some(T::In) => written(told, here.span, "faces"),
        T::Hole if last == Some(T::In) => written(told, here.span, "holes"),
        T::Slash if after.first().is_some_and(|next| next.kind == T::Star) => told.note(COMMENT),
        T::Star if last == Some(T::Slash) => told.note(COMMENT),
        T::LeftBracket => told.note("there are no lists; a vector is `vec3(x, y, z)`"),
        T::Comma if in_bare_parentheses(before) => told.note("a vector is `vec3(x, y, z)`"),
        T::Dot if last == Some(T::Dot) => {
            told.note("there are no ranges; `repeat n { … }` does something `n` times")
        }
        T::Word if failure.wanted.has(T::LeftBrace) => match around.text.get(here.span.range()) {
            Some("then" | "do") => told.note("a block stands in braces"),
            _ => told,
        },
        _ => told,
    }
}

fn written(told: Diagnostic, span: Span, word: &str) -> Diagnostic {
    told.saying(format!("here it is written `{word}`"))
        .fix(format!("write `{word}`"), span, word)
}

/// Whether a token makes one sign with an equals sign behind it, as in `+=`.
fn is_sign(token: &Token, equals: &Token) -> bool {
    let signs = [T::Plus, T::Minus, T::Star, T::Slash];
    signs.contains(&token.kind) && token.span.end == equals.span.start
}

/// Whether what comes behind these tokens belongs to a condition.
fn in_condition(before: &[Token]) -> bool {
    let near = before.iter().rev().take(FARTHEST).map(|token| token.kind);
    let mut words = near.skip_while(|kind| {
        let is_word = kind.is_keyword() && !matches!(kind, T::And | T::Or | T::Not);
        let is_end = matches!(kind, T::LeftBrace | T::RightBrace | T::Equals);
        !is_word && !is_end
    });
    matches!(
        words.next(),
        Some(T::If | T::While | T::Where | T::Assert | T::Require)
    )
}

/// Whether the parentheses around what comes behind these tokens belong to no call.
fn in_bare_parentheses(before: &[Token]) -> bool {
    let mut closed = 0;
    for (at, token) in before.iter().enumerate().rev().take(FARTHEST) {
        match token.kind {
            T::RightParen => closed += 1,
            T::LeftParen if closed > 0 => closed -= 1,
            T::LeftParen => {
                let called = at.checked_sub(1).map(|last| before[last].kind);
                return called.is_some_and(|kind| !kind.is_name() && kind != T::Hole);
            }
            T::LeftBrace | T::RightBrace => return false,
            _ => {}
        }
    }
    false
}
