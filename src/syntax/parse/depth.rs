//! The nesting depth of an item, measured before it is parsed.
//!
//! The parser and all later stages walk the tree recursively, so its depth is bounded here: open
//! brackets, and the operators, dots and branches chained inside them.

use crate::syntax::token::{Token, TokenKind as T};

/// The maximum depth of a tree.
pub(super) const DEEPEST: usize = 256;

/// An open bracket, and the length of the chain before it.
struct Open {
    bracket: T,
    chained: usize,
}

/// The first token at which the tree would exceed the maximum depth.
pub(super) fn too_deep(tokens: &[Token]) -> Option<Token> {
    let mut open: Vec<Open> = Vec::new();
    let mut total = 0;
    let mut chained = 0;
    let mut before = None;
    for &token in tokens {
        let kind = token.kind;
        if restarts(before, kind) {
            total -= chained;
            chained = 0;
        }
        match kind {
            T::LeftBrace | T::LeftParen | T::LeftBracket => {
                open.push(Open { bracket: kind, chained });
                total += 1;
                chained = 0;
            }
            T::RightBrace | T::RightParen | T::RightBracket => {
                while let Some(last) = open.pop_if(|last| closes(kind, last.bracket)) {
                    total = total - chained - 1;
                    chained = last.chained;
                    if last.bracket == opening(kind) {
                        break;
                    }
                }
            }
            kind if chains(kind) => {
                total += 1;
                chained += 1;
            }
            _ => {}
        }
        if total > DEEPEST {
            return Some(token);
        }
        before = Some(kind);
    }
    None
}

fn opening(closing: T) -> T {
    match closing {
        T::RightBrace => T::LeftBrace,
        T::RightParen => T::LeftParen,
        _ => T::LeftBracket,
    }
}

/// A closing brace also closes the brackets left open inside it; other closing brackets do not
/// reach beyond their braces.
fn closes(closing: T, bracket: T) -> bool {
    closing == T::RightBrace || bracket != T::LeftBrace
}

/// True if a token makes the enclosing value deeper.
fn chains(kind: T) -> bool {
    kind.is_binary() || matches!(kind, T::Not | T::Must | T::Dot | T::If | T::Else)
}

/// True if a chain ends before a token: at a mark that is not part of a value, and where one value
/// follows another.
fn restarts(before: Option<T>, kind: T) -> bool {
    match kind {
        T::Comma | T::Colon | T::DoubleColon | T::Equals | T::Arrow | T::FatArrow | T::Bar => true,
        kind if chains(kind) && !matches!(kind, T::If | T::Not | T::Must) => false,
        T::LeftBrace
        | T::LeftParen
        | T::LeftBracket
        | T::RightBrace
        | T::RightParen
        | T::RightBracket => false,
        _ => before.is_some_and(|before| {
            matches!(
                before,
                T::Word | T::Int | T::Real | T::Text | T::TextTail | T::True | T::False
            ) || matches!(before, T::RightParen | T::RightBracket | T::RightBrace)
                || before.is_soft()
        }),
    }
}
