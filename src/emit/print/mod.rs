//! A routine as text, in Rust or in C++: one walk over it, in which both are spelled side by side.

mod item;
mod lines;
mod statement;
pub(super) mod support;

pub(super) use item::{Part, item};
pub(super) use lines::packed;

use super::language::Language;
use lines::Lines;

/// A printer of one item.
pub(super) struct Printer<'s> {
    pub language: Language<'s>,
    pub part: Part,
    pub lines: Lines,
    /// The statement that leaves the current attempt.
    pub refusal: &'static str,
    /// The value of a `return` without one; empty for none.
    pub applied: String,
    /// True if values are returned in `Some`, since a function in Rust may refuse.
    pub wraps: bool,
    /// True if writes are noted in a journal.
    pub is_noted: bool,
    /// The preview on which pointers are noted instead.
    pub preview: Option<String>,
}

impl Printer<'_> {
    /// Runs `print`, and takes the lines that it adds.
    pub fn apart(&mut self, print: impl FnOnce(&mut Self)) -> String {
        let inner = self.lines.inner();
        let outer = std::mem::replace(&mut self.lines, inner);
        print(self);
        std::mem::replace(&mut self.lines, outer).finish()
    }
}
