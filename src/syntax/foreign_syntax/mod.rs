//! Foreign syntax: what people write who come from other languages, mesh libraries and courses, and
//! how it is written here.
//!
//! A text that is right is never looked at here. Where an item cannot be read, its tokens are
//! compared with a table of such ways of writing; what is found is told once, with
//! the way out, and put into the words of the language, so that the rest of the item is read
//! as it was meant.

mod pattern;

mod table;

mod place;

mod sign;

mod finding;

mod report;

mod mend;

mod types;

use super::token::Token;
use crate::diagnostic::Diagnostic;
use crate::source::Span;

pub use finding::Found;
pub use mend::{Mended, mend};
pub(super) use report::tell;
pub use types::type_word;

/// The foreign syntax on some lines of an item that can be read, but not understood.
pub fn written_elsewhere(
    text: &str,
    item: &[Token],
    is_asked: impl Fn(Span) -> bool,
) -> Vec<Diagnostic> {
    let mut found = mend(text, item).found;
    found.retain(|found| is_asked(found.span));
    tell(text, found)
}
