//! A routine as text, in Rust or in C++: one walk over it, in which both are spelled side by side.

/// A text in the language of a printer: the first in Rust, the second in C++.
macro_rules! say {
    ($printer:expr, $rust:literal, $cpp:literal) => {
        match $printer.style {
            None => format!($rust),
            Some(_) => format!($cpp),
        }
    };
}

mod aggregate;
mod calls;
mod item;
mod lines;
mod spelled;
mod spellings;
mod statement;
pub(super) mod support;
mod term;

pub(super) use item::Part;
pub(super) use lines::Lines;

use super::cpp::Style;
use crate::diagram::Type;

/// A printer of routines.
#[derive(Default)]
pub(super) struct Printer<'s> {
    /// The style of C++; `None` in Rust.
    pub style: Option<&'s Style>,
    pub lines: Lines,
    /// The statement that leaves the current attempt.
    pub refusal: &'static str,
    /// The value of a `return` without one; empty for none.
    pub applied: String,
    /// True if values are returned in `Some`, since a function in Rust may refuse.
    pub wraps: bool,
    /// True if the caller has checked that the attributes exist.
    pub is_asked: bool,
    /// True where the names of the mesh class are not in scope.
    pub is_outside: bool,
    /// True if writes are noted in a journal.
    pub is_noted: bool,
    /// The preview on which pointers are noted instead.
    pub preview: Option<String>,
}

impl<'s> Printer<'s> {
    /// A printer of C++ in a style, or of Rust without one.
    pub fn new(style: Option<&'s Style>) -> Self {
        Self {
            style,
            lines: Lines::new(if style.is_none() { 4 } else { 2 }),
            wraps: style.is_none(),
            ..Self::default()
        }
    }

    /// Runs `print`, and takes the lines that it adds.
    pub fn apart(&mut self, print: impl FnOnce(&mut Self)) -> String {
        let inner = self.lines.inner();
        let outer = std::mem::replace(&mut self.lines, inner);
        print(self);
        std::mem::replace(&mut self.lines, outer).finish()
    }

    /// The name of a type.
    pub fn ty(&self, ty: Type) -> String {
        match self.style {
            Some(style) => style.ty(ty, self.is_outside),
            None => super::rust::ty(ty).into(),
        }
    }
}
