//! Foreign syntax: forms from other languages, mesh libraries and courses, and their equivalents
//! here.
//!
//! Valid text never comes here. Where an item cannot be parsed, its tokens are compared with a
//! table of foreign forms. Each finding is reported once, with a correction, and replaced by its
//! equivalent, so that the rest of the item is parsed as it was meant.

mod finding;
mod mend;
mod misspelt;
mod pattern;
mod place;
mod report;
mod sign;
mod table;
mod types;
mod value;

use super::token::Token;
use crate::diagnostic::Diagnostic;
use crate::source::Span;

pub use finding::Found;
pub use mend::{Mended, mend};
pub(super) use misspelt::{is_misspelt, keyword_meant};
pub(super) use report::tell;
pub use types::type_word;

/// The foreign syntax on some lines of an item that parses but cannot be resolved.
pub fn written_elsewhere(
    text: &str,
    item: &[Token],
    is_asked: impl Fn(Span) -> bool,
) -> Vec<Diagnostic> {
    let mut found = mend(text, item).found;
    found.retain(|found| is_asked(found.span));
    tell(text, found)
}
