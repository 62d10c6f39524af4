//! Values as text: expressions of a program, and what statements are made of.

mod aggregate;
mod expression;
mod language;
mod spellings;
mod term;

pub(super) use expression::{is_plain, is_spelled};
pub(super) use language::unique;
pub(super) use spellings::{rows, spelling};
pub(super) use term::{Precedence, Term, bare};
