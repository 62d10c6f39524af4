//! The context of a cursor in a drawing, derived from the tokens before it.

use super::cursor_context::{CursorContext, Gap, Start};
use super::following_words::{ends_value, kind};
use super::names::SideName;
use crate::syntax::{Token, TokenKind as T};

/// The next part that a drawing wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    Statement,
    Face,
    Edge,
    /// The first vertex of a loop, or `each`.
    FirstVertex,
    LoopVertex,
    /// The vertex of a vertex statement.
    StarVertex,
    LoopHalfedge,
    /// A path of a loop.
    Path,
    EdgeHalfedge,
    /// The first spoke of a vertex, or `each`.
    FirstSpoke,
    Spoke,
    /// A spoke, or a statement.
    NextSpoke,
    Fan,
    /// Something new, or a statement.
    New,
    /// Something to erase, or a statement.
    Erase,
    /// Something to keep, or a statement.
    Keep,
}

/// The context in a side of a rule.
pub(super) fn side(tokens: &[Token], side: SideName, gap: Gap) -> CursorContext {
    let kinds = without_subscripts(tokens);
    match part(&kinds, side, gap) {
        // No statement begins before the period is closed.
        CursorContext::Side(_, Wanted::Statement) if is_in_period(&kinds) => CursorContext::Nowhere,
        CursorContext::Side(_, Wanted::NextSpoke) if is_in_period(&kinds) => {
            CursorContext::Side(side, Wanted::Spoke)
        }
        found => found,
    }
}

/// The kinds of some tokens without the subscripts, which may stand behind any name.
fn without_subscripts(tokens: &[Token]) -> Vec<T> {
    let mut is_inside = false;
    let kinds = (0..tokens.len()).filter_map(|at| kind(tokens, at));
    kinds
        .filter(|kind| {
            let was_inside = is_inside;
            is_inside = *kind == T::LeftBracket || is_inside && *kind != T::RightBracket;
            !is_inside && !was_inside
        })
        .collect()
}

/// True if the tokens of a drawing end in the braces of an `each`.
fn is_in_period(kinds: &[T]) -> bool {
    let each = kinds.iter().rposition(|kind| *kind == T::Each);
    each.is_some_and(|each| !kinds[each..].contains(&T::RightBrace))
}

/// The context where the tokens of a drawing end.
fn part(kinds: &[T], side: SideName, gap: Gap) -> CursorContext {
    let stops = |kind: T| {
        kind.begins_drawing_statement() || matches!(kind, T::Before | T::After | T::Equals)
    };
    let start = kinds.iter().rposition(|kind| stops(*kind));
    let Some(start) = start else { return CursorContext::Side(side, Wanted::Statement) };
    let rest = &kinds[start + 1..];
    let last = rest.last().copied();
    let has_colon = rest.contains(&T::Colon);
    if let [.., T::Each] | [.., T::Each, _] = rest {
        return CursorContext::Nowhere;
    }
    let wanted = match kinds[start] {
        T::Equals => match last {
            // `=P=>` ends with its own arrow, behind which the loop goes on.
            _ if is_path(kinds, start) && rest.contains(&T::FatArrow) => in_loop(last),
            Some(last) if ends_value(last) || last == T::RightBrace => Wanted::Statement,
            _ if is_path(kinds, start) => Wanted::Path,
            _ => return CursorContext::Value(Start::Value),
        },
        T::Face | T::Hole | T::Loop => match last {
            None => Wanted::Face,
            // Behind its first vertex.
            Some(T::Word) if !rest.contains(&T::Arrow) && !rest.contains(&T::FatArrow) => {
                return CursorContext::Nowhere;
            }
            Some(T::Colon) => Wanted::FirstVertex,
            _ if has_colon => in_loop(last),
            _ => return CursorContext::Nowhere,
        },
        T::Edge => match last {
            None => Wanted::Edge,
            Some(T::Colon | T::Bar) => Wanted::EdgeHalfedge,
            _ if !rest.contains(&T::Bar) => return CursorContext::Nowhere,
            _ => Wanted::Statement,
        },
        T::Vertex => match last {
            None => Wanted::StarVertex,
            // The name of a fan touches its asterisk.
            Some(T::Star) if gap == Gap::Nothing => Wanted::Fan,
            Some(T::Colon) => Wanted::FirstSpoke,
            Some(T::LeftBrace | T::Comma) => Wanted::Spoke,
            Some(T::RightBrace) => Wanted::Statement,
            _ if has_colon => Wanted::NextSpoke,
            _ => return CursorContext::Nowhere,
        },
        T::New => Wanted::New,
        T::Erase => Wanted::Erase,
        T::Keep => Wanted::Keep,
        _ => Wanted::Statement,
    };
    CursorContext::Side(side, wanted)
}

/// The part that a loop wants behind its colon.
fn in_loop(last: Option<T>) -> Wanted {
    match last {
        Some(T::LeftBrace | T::Arrow | T::FatArrow) => Wanted::LoopVertex,
        Some(T::Minus) => Wanted::LoopHalfedge,
        _ => Wanted::Statement,
    }
}

/// True if an `=` begins an arrow of a loop: a vertex precedes it, where a loop or a period begins
/// or after another arrow.
fn is_path(kinds: &[T], equals: usize) -> bool {
    let kind = |back: usize| equals.checked_sub(back).map(|at| kinds[at]);
    kind(1).is_some_and(T::is_wordlike)
        && matches!(kind(2), Some(T::Colon | T::LeftBrace | T::Arrow | T::FatArrow))
}
