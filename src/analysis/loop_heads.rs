//! The variables of loops and aggregates, from the tokens alone: so they are known even where the
//! head that declares them is being typed.

use super::cursor_context::begins_item;
use super::snapshot::Snapshot;
use super::types::type_of_elements;
use crate::diagram::Type;
use crate::syntax::{Token, TokenKind as T};

/// The variables of the loops and aggregates that a byte is in, the innermost last, with their
/// types as far as they are known.
pub fn bound_near(snapshot: &Snapshot, offset: usize) -> Vec<(&str, Option<Type>)> {
    let tokens = &snapshot.parsed().tokens;
    let here = tokens.partition_point(|token| (token.span.start as usize) < offset);
    let begins = |token: &Token| begins_item(snapshot, *token);
    let start = tokens[..here].iter().rposition(begins).unwrap_or(0);
    let behind = tokens[here..].iter().position(begins);
    let end = behind.map_or(tokens.len(), |count| here + count);
    let (mut binders, open) = around(tokens, start..here);
    binders.extend(ahead(&tokens[..end], here, open));
    let bound = binders.into_iter().map(|at| {
        let name = snapshot.sources().slice(tokens[at + 1].span);
        (name, type_of_elements(snapshot, &tokens[at + 3..]))
    });
    bound.collect()
}

/// True if `for x in`, `drain x in` or `update x in` begins at a token.
fn binds(tokens: &[Token], at: usize) -> bool {
    let kind = |at: usize| tokens.get(at).map(|token| token.kind);
    matches!(tokens[at].kind, T::For | T::Drain | T::Update)
        && kind(at + 1).is_some_and(T::is_wordlike)
        && kind(at + 2) == Some(T::In)
}

/// The loops and aggregates that are open where some tokens end, and the brackets that are.
fn around(tokens: &[Token], before: std::ops::Range<usize>) -> (Vec<usize>, Vec<T>) {
    let mut open: Vec<T> = Vec::new();
    // Each with the number of brackets that are open before it.
    let mut binders: Vec<(usize, usize)> = Vec::new();
    let end = before.end;
    for at in before {
        match tokens[at].kind {
            bracket @ (T::LeftBrace | T::LeftParen) => open.push(bracket),
            T::RightParen => {
                open.pop_if(|bracket| *bracket == T::LeftParen);
                binders.retain(|(_, level)| *level <= open.len());
            }
            T::RightBrace => {
                while open.pop().is_some_and(|bracket| bracket != T::LeftBrace) {}
                // Behind its block a loop has ended.
                binders.retain(|(_, level)| *level < open.len());
            }
            _ if binds(tokens, at) => binders.push((at, open.len())),
            _ => {}
        }
    }
    // In the sequence itself the variable is not known.
    let ends_sequence = |token: &Token| matches!(token.kind, T::Where | T::By | T::LeftBrace);
    let binders = binders.into_iter().map(|(at, _)| at);
    (binders.filter(|&at| tokens[at..end].iter().any(ends_sequence)).collect(), open)
}

/// The aggregates that are open at a token and declare their variable behind it, the innermost
/// last.
fn ahead(tokens: &[Token], here: usize, mut open: Vec<T>) -> Vec<usize> {
    let mut binders = Vec::new();
    let mut level = 0_usize;
    for at in here..tokens.len() {
        if open.last() != Some(&T::LeftParen) {
            break;
        }
        match tokens[at].kind {
            T::LeftBrace | T::RightBrace => break,
            T::LeftParen => level += 1,
            T::RightParen if level == 0 => {
                open.pop();
            }
            T::RightParen => level -= 1,
            T::For if level == 0 && binds(tokens, at) => binders.push(at),
            _ => {}
        }
    }
    binders.reverse();
    binders
}
