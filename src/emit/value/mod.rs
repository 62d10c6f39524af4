//! Values as text: expressions of a program, and what statements are made of.

mod aggregate;
mod expression;
mod language;
mod spellings;
mod term;

pub(super) use expression::{ORDINARY, is_plain, is_spelled, is_surely_finite};
pub(super) use language::unique;
pub(super) use spellings::{rows, spelling};
pub(super) use term::{Precedence, Term, bare};
