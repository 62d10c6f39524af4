//! Error recovery of the grammar.
//!
//! A rule that fails is replaced by a skip to the next token that certainly begins something else.
//! Skips stop at keywords, which cannot occur inside what is skipped, and at the brace that closes
//! the surroundings. Every token is skipped at most once at each level of braces.

use super::failure::Failure;
use super::input::{Extra, Rule, Tokens};
use super::report;
use crate::source::Span;
use crate::syntax::token::TokenKind as T;
use chumsky::input::InputRef;
use chumsky::prelude::*;

type Input<'t, 'p> = InputRef<'t, 'p, Tokens<'t>, Extra<'t>>;

/// True if a token begins a part of an op.
pub(super) fn begins_part(kind: T) -> bool {
    matches!(kind, T::Before | T::Require | T::Guard | T::Alias | T::After | T::Rule)
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
            | T::Require
            | T::Return
            | T::Break
            | T::Continue
    )
}

/// True if what is skipped of a statement of a drawing ends before a token.
pub(super) fn follows_drawing_statement(input: &mut Input, kind: T, level: usize) -> bool {
    kind.begins_drawing_statement()
        || begins_part(kind)
        || kind == T::RightBrace && level == 0
        || kind.is_name() && begins_assignment(input)
}

/// True if what is skipped of a statement of a block ends before a token.
pub(super) fn follows_action(input: &mut Input, kind: T, level: usize) -> bool {
    level == 0
        && (kind == T::RightBrace
            || begins_action(kind)
            || matches!(kind, T::Parallel | T::For | T::If | T::Must | T::Word)
                && begins_line(input))
}

/// Skips the rest of a pair of parentheses, and the closing one if it comes before the next
/// statement or brace.
pub(super) fn parentheses<'t>() -> Rule<'t, Span> {
    custom(|input: &mut Input<'t, '_>| {
        let start = input.cursor();
        let mut level = 0_usize;
        let mut is_field = false;
        while let Some(kind) = input.peek() {
            if !is_field && ends_parentheses(kind) {
                break;
            }
            is_field = kind == T::Dot;
            input.skip();
            match kind {
                T::LeftParen => level += 1,
                T::RightParen if level == 0 => break,
                T::RightParen => level -= 1,
                _ => {}
            }
        }
        Ok(input.span_since(&start))
    })
    .boxed()
}

/// Skips the rest of a part of an op.
pub(super) fn part<'t>() -> Rule<'t, Span> {
    skip(|_, kind, level| begins_part(kind) || kind == T::RightBrace && level == 0)
}

/// Skips the rest of the head of an item.
pub(super) fn item_head<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| {
        matches!(kind, T::LeftBrace | T::RightBrace | T::Arrow | T::Keeps) || begins_part(kind)
    })
}

/// A closing parenthesis; if it is missing before a brace or the next statement, that is reported
/// and parsing continues.
pub(super) fn right_paren<'t>() -> Rule<'t, ()> {
    let lack = custom(|input: &mut Input<'t, '_>| {
        let start = input.cursor();
        match input.peek() {
            Some(kind) if !ends_parentheses(kind) => Err(Failure::at(input.span_since(&start))),
            _ => Ok(()),
        }
    });
    just(T::RightParen).ignored().recover_with(via_parser(lack)).boxed()
}

fn ends_parentheses(kind: T) -> bool {
    matches!(kind, T::LeftBrace | T::RightBrace)
        || begins_action(kind)
        || kind.begins_drawing_statement()
        || begins_part(kind)
}

/// Skips to the braces of an item.
pub(super) fn to_braces<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| matches!(kind, T::LeftBrace | T::RightBrace) || begins_part(kind))
}

/// Skips to the block that follows the head of a statement.
pub(super) fn header<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| {
        matches!(kind, T::LeftBrace | T::RightBrace | T::Where | T::By) || begins_action(kind)
    })
}

/// Skips the rest of an entry of a list in parentheses.
pub(super) fn entry<'t>() -> Rule<'t, Span> {
    skip_from_first(|_, kind, _| {
        matches!(
            kind,
            T::Comma | T::RightParen | T::LeftBrace | T::RightBrace | T::Arrow | T::Keeps
        )
    })
}

/// Skips everything that is left.
pub(super) fn rest<'t>() -> Rule<'t, Span> {
    skip(|_, _, _| false)
}

type Stop = for<'t, 'p> fn(&mut Input<'t, 'p>, T, usize) -> bool;

/// Skips one token, and then up to where `stop` holds; fails if there is no token, so that no
/// repetition loops indefinitely. The last argument of `stop` counts the braces opened on the way;
/// a skip ends after the brace that closes the outermost of them, unless `else` follows.
pub(super) fn skip<'t>(stop: Stop) -> Rule<'t, Span> {
    skipping(stop, true)
}

/// The same from the first token on: what is skipped may be empty.
pub(super) fn skip_from_first<'t>(stop: Stop) -> Rule<'t, Span> {
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

/// Consumes nothing, and fails if no assignment begins here, so that the failure is at the start of
/// the statement.
pub(super) fn assignment_ahead<'t>() -> Rule<'t, ()> {
    custom(|input: &mut Input<'t, '_>| {
        let start = input.save();
        let named = input.next().is_some_and(T::is_name);
        let goes_on = matches!(input.peek(), Some(T::Dot | T::LeftBracket));
        let first = input.span_since(start.cursor());
        input.rewind(start);
        if named && goes_on { Ok(()) } else { Err(Failure::at(first)) }
    })
    .boxed()
}

/// True if `name.attribute =` or `name[…].attribute =` comes next.
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

/// True if the next token is the first of its line.
fn begins_line(input: &mut Input) -> bool {
    let start = input.save();
    input.skip();
    let span = input.span_since(start.cursor());
    input.rewind(start);
    report::begins_line(input.state().0, span)
}
