//! How the grammar gets over what it cannot read.
//!
//! A rule that fails is replaced by a skip to the next token that surely begins something
//! else. Skips are bounded by keywords, which stand nowhere inside of what is skipped, and
//! by the brace that closes what surrounds it; every token is skipped at most once in each
//! level of braces.

use super::failure::Failure;
use super::input::{Extra, Rule, Tokens};
use crate::source::Span;
use crate::syntax::token::TokenKind as T;
use chumsky::input::InputRef;
use chumsky::prelude::*;

type Input<'t, 'p> = InputRef<'t, 'p, Tokens<'t>, Extra<'t>>;

/// Whether a token begins a part of an op.
pub(super) fn begins_part(kind: T) -> bool {
    matches!(kind, T::Before | T::Require | T::Guard | T::After | T::Rule)
}

fn begins_drawing_statement(kind: T) -> bool {
    matches!(
        kind,
        T::Face | T::Hole | T::Loop | T::Edge | T::Vertex | T::New | T::Keep | T::Erase
    )
}

fn begins_action(kind: T) -> bool {
    matches!(
        kind,
        T::Let
            | T::Var
            | T::Repeat
            | T::While
            | T::Drain
            | T::Update
            | T::Print
            | T::Assert
            | T::Return
            | T::Break
            | T::Continue
    )
}

/// Skips what is left of a statement of a drawing.
pub(super) fn drawing_statement<'t>() -> Rule<'t, Span> {
    skip(|input, kind, level| {
        begins_drawing_statement(kind)
            || begins_part(kind)
            || kind == T::RightBrace && level == 0
            || kind.is_name() && begins_assignment(input)
    })
}

/// Skips what is left of a statement of a block.
pub(super) fn action<'t>() -> Rule<'t, Span> {
    skip(|input, kind, level| {
        level == 0
            && (kind == T::RightBrace
                || begins_action(kind)
                || matches!(kind, T::For | T::If | T::Must | T::Word) && begins_line(input))
    })
}

/// Skips what is left of a part of an op.
pub(super) fn part<'t>() -> Rule<'t, Span> {
    skip(|_, kind, level| begins_part(kind) || kind == T::RightBrace && level == 0)
}

/// Skips to the block that follows a header.
pub(super) fn header<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| {
        matches!(kind, T::LeftBrace | T::RightBrace | T::Where | T::By) || begins_action(kind)
    })
}

/// Skips what is left of an entry of a list in parentheses.
pub(super) fn entry<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| {
        matches!(
            kind,
            T::Comma | T::RightParen | T::LeftBrace | T::RightBrace | T::Arrow | T::Keeps
        )
    })
}

/// Skips all that is left.
pub(super) fn rest<'t>() -> Rule<'t, Span> {
    skip(|_, _, _| false)
}

type Stop = for<'t, 'p> fn(&mut Input<'t, 'p>, T, usize) -> bool;

/// Skips one token, and then up to where `stop` holds; fails where there is no token, so
/// that no repetition stands still. The last argument of `stop` counts
/// the braces that were opened on the way; a skip ends behind the last one that closes.
fn skip<'t>(stop: Stop) -> Rule<'t, Span> {
    skipping(stop, true)
}

fn skip_from_first<'t>(stop: Stop) -> Rule<'t, Span> {
    skipping(stop, false)
}

fn skipping<'t>(stop: Stop, first_goes: bool) -> Rule<'t, Span> {
    custom(move |input: &mut Input<'t, '_>| {
        let start = input.cursor();
        if first_goes && input.peek().is_none() {
            return Err(Failure::at(input.span_since(&start)));
        }
        let mut level = 0;
        let mut free = first_goes;
        while let Some(kind) = input.peek() {
            if !free && stop(input, kind, level) {
                break;
            }
            free = false;
            input.skip();
            match kind {
                T::LeftBrace => level += 1,
                T::RightBrace if level > 1 => level -= 1,
                T::RightBrace if level == 1 && input.peek() != Some(T::Else) => break,
                T::RightBrace => level = 0,
                _ => {}
            }
        }
        Ok(input.span_since(&start))
    })
    .boxed()
}

/// Whether `name.attribute =` or `name[…].attribute =` comes next.
fn begins_assignment(input: &mut Input) -> bool {
    const LONGEST_SUBSCRIPT: usize = 4;
    let start = input.save();
    input.skip();
    if input.peek() == Some(T::LeftBracket) {
        for _ in 0..=LONGEST_SUBSCRIPT {
            if input.next() == Some(T::RightBracket) {
                break;
            }
        }
    }
    let mut next = || input.next();
    let begins =
        next() == Some(T::Dot) && next().is_some_and(T::is_wordlike) && next() == Some(T::Equals);
    input.rewind(start);
    begins
}

/// Whether the next token is the first of its line.
fn begins_line(input: &mut Input) -> bool {
    let start = input.save();
    input.skip();
    let span = input.span_since(start.cursor());
    input.rewind(start);
    let text = input.state().0;
    let before = text.get(..span.start as usize).unwrap_or("");
    before.trim_end_matches([' ', '\t']).ends_with('\n') || span.start == 0
}
