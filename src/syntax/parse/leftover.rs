//! A closing brace behind an item that closes nothing.

use crate::diagnostic::Diagnostic;
use crate::syntax::token::{Token, TokenKind as T};

/// The error that there is a brace too many, if one of the tokens behind a whole item closes
/// nothing: what stands between the two was most likely meant to be in the item.
pub(super) fn brace_too_many(item: &[Token], behind: &[Token]) -> Option<Diagnostic> {
    let end = item.last().filter(|last| last.kind == T::RightBrace)?;
    let mut open = 0_usize;
    for token in behind {
        match token.kind {
            T::LeftBrace => open += 1,
            T::RightBrace if open == 0 => {
                let told = Diagnostic::error("syntax-error", "there is a `}` too many", token.span);
                let told = told.saying("this one closes nothing");
                return Some(told.label(end.span, "this one already closes the item"));
            }
            T::RightBrace => open -= 1,
            T::Foreign => return None,
            _ => {}
        }
    }
    None
}
