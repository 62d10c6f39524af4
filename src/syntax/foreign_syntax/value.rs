//! The end of a value in a foreign text.

use super::pattern::paired;
use super::place::Item;
use crate::syntax::token::TokenKind as T;

/// The end of a name without a subscript, with what is read behind it.
pub(super) fn place_end(item: &Item, at: usize) -> Option<usize> {
    let mut end = item.name_end(at).filter(|&end| end == at + 1)?;
    while item.kind(end) == Some(T::Dot) && item.kind(end + 1).is_some_and(T::is_wordlike) {
        end += 2;
    }
    Some(end)
}

/// The end of a number, or of a name with what is read and called behind it.
pub(super) fn operand_end(item: &Item, at: usize) -> Option<usize> {
    match item.kind(at)? {
        T::Int | T::Real => Some(at + 1),
        _ => owner_ends(item, at).first().copied(),
    }
}

/// The ends of a name with what is read and called behind it, the last first.
pub(super) fn owner_ends(item: &Item, at: usize) -> Vec<usize> {
    let step = |&end: &usize| match item.kind(end)? {
        T::Dot if item.kind(end + 1).is_some_and(T::is_wordlike) => Some(end + 2),
        T::LeftParen if item.touches(end) => parentheses_end(item, end),
        _ => None,
    };
    let mut ends: Vec<_> = std::iter::successors(item.name_end(at), step).collect();
    ends.reverse();
    ends
}

/// The end of the parentheses that begin at a token.
fn parentheses_end(item: &Item, at: usize) -> Option<usize> {
    let closing = paired(item, at + 1, |_| false).pop()?;
    (item.kind(closing) == Some(T::RightParen)).then_some(closing + 1)
}

/// The end of a value with all of its operators and choices, `c ? x : y`, if a statement or nothing
/// follows.
pub(super) fn whole_end(item: &Item, at: usize) -> Option<usize> {
    let mut end = joined_end(item, at)?;
    while item.word(end) == "?" {
        let colon = joined_end(item, end + 1).filter(|&end| item.word(end) == ":")?;
        end = joined_end(item, colon + 1)?;
    }
    let is_next = |kind: T| kind.is_wordlike() || kind == T::RightParen;
    let is_comment =
        item.begins_comment(end) || item.comment(end).is_some() || item.word(end) == "#";
    let ends = item.ends_line(end) || is_comment || item.kind(end).is_some_and(is_next);
    ends.then_some(end)
}

/// The end of operands with operators between them.
fn joined_end(item: &Item, at: usize) -> Option<usize> {
    let mut end = at;
    loop {
        while matches!(item.word(end), "-" | "not" | "!") {
            end += 1;
        }
        end = part_end(item, end)?;
        let is_joined = item.kind(end).is_some_and(T::is_binary)
            && !item.begins_comment(end)
            && !item.is_step(end);
        if !is_joined && !matches!(item.word(end), "&&" | "||" | "%") {
            return Some(end);
        }
        end += 1;
    }
}

/// The end of an operand, a text, or a value in parentheses.
fn part_end(item: &Item, at: usize) -> Option<usize> {
    match item.kind(at)? {
        T::LeftParen => parentheses_end(item, at),
        T::True | T::False | T::Text => Some(at + 1),
        _ => operand_end(item, at),
    }
}

/// True if a token stands in a statement, but not in a value outside parentheses.
pub(super) fn is_of_statement(kind: T) -> bool {
    matches!(
        kind,
        T::Comma
            | T::Equals
            | T::Let
            | T::Var
            | T::For
            | T::While
            | T::Repeat
            | T::Drain
            | T::Update
            | T::Print
            | T::Assert
            | T::Return
            | T::Must
            | T::Parallel
            | T::Break
            | T::Continue
    )
}
