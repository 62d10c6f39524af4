//! Proved operations as pointer code in other languages.
//!
//! `cpp` makes the classic four-phase function over a pointer-based halfedge mesh, `rust` a plain
//! function over [`crate::mesh`]. Both spell the same routine, which is built from [`crate::lower`]
//! and not from the machine's code: the names of the drawing are kept, tests and assignments that
//! change nothing are left out, and a guard becomes tests on a preview of the mesh.
//!
//! Operations in steps call others, and apply whole or not at all; `steps` makes routines of them,
//! and of the functions that they call.
//!
//! A value is text from the start, and so are statements that are the same wherever they stand; what
//! depends on its place is spelled when an item is printed.
//!
//! The code assumes a valid mesh, which is of the level of the guard if there is one.

// What is emitted.
mod item;
mod items;
mod selection;

// What all of it is spelled with.
#[macro_use]
mod language;
mod names;
pub mod reserved;
mod value;

// An operation as a routine.
mod build;
mod guard;
mod matching;
mod reassign;
mod routine;
mod statement;
mod walks;

// Operations in steps and functions as routines.
mod steps;

// A routine as text.
pub mod cpp;
mod print;
mod rust;

use crate::diagnostic::Diagnostic;
use crate::source::Span;

pub use cpp::{Style, StyleError, cpp, style_patterns};
pub use rust::rust;
pub use selection::Selection;

/// A part of a program that cannot be emitted, and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotEmitted {
    /// The part: "a text".
    pub what: String,
    pub span: Span,
    /// The reason, if it is not just that there is no code for it.
    pub why: Option<String>,
}

impl NotEmitted {
    fn new(what: impl Into<String>, span: Span) -> Self {
        Self { what: what.into(), span, why: None }
    }

    /// The failure as a diagnostic.
    pub fn diagnostic(&self) -> Diagnostic {
        let message = format!("{} cannot be emitted", self.what);
        let diagnostic = Diagnostic::error("not-emitted", message, self.span);
        if let Some(why) = &self.why {
            return diagnostic.note(why.clone());
        }
        diagnostic.note(
            "`hedgerow plan` shows the operation as a table, and `hedgerow apply` and `run` carry it out",
        )
    }
}
