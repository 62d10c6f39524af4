//! The variable whose value is being written, from the tokens alone.

use super::cursor_context::before;
use super::following_words::{begins_statement, ends_value, goes_on, kind};
use super::snapshot::Snapshot;
use crate::source::Span;
use crate::syntax::TokenKind as T;

/// The name of the variable whose value begins before a byte and has not ended there: it is not
/// known yet.
pub(super) fn being_declared(snapshot: &Snapshot, offset: usize) -> Option<Span> {
    let tokens = before(snapshot, offset);
    if tokens.last().is_some_and(|last| ends_value(last.kind)) {
        return None;
    }
    let mut closed = 0_usize;
    for at in (0..tokens.len()).rev() {
        match kind(tokens, at)? {
            _ if closed == 0 && begins_statement(tokens, at + 1) => return None,
            T::RightParen | T::RightBrace => closed += 1,
            T::LeftParen | T::LeftBrace => closed = closed.saturating_sub(1),
            _ if closed > 0 => {}
            T::Let | T::Var => return Some(tokens.get(at + 1)?.span),
            T::Colon | T::Comma | T::Equals | T::If | T::Else => {}
            kind if !goes_on(kind) => return None,
            _ => {}
        }
    }
    None
}
