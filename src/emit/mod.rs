//! Proved operations as pointer code in other languages.
//!
//! [`cpp`] makes the classic four-phase function over a pointer-based halfedge mesh, [`rust`] a
//! plain function over [`crate::mesh`]. Both spell the same routine, which is built from the
//! proof and not from the machine's code: the names of the drawing stay, tests and assignments
//! that change nothing are left out, and a guard becomes walks and tests on the mesh as it is.
//!
//! The code assumes a mesh in order, and of the level of the guard, where there is one.

// An operation as a routine.
mod around;
mod build;
mod callee;
mod expression;
mod guard;
mod matching;
mod names;
mod reassign;
mod routine;
mod term;
mod walks;
mod wide;

// A routine as text.
mod cpp;
mod lines;
mod rust;
mod spell;

use crate::diagnostic::Diagnostic;
use crate::source::Span;

pub use cpp::{Style, StyleError, cpp};
pub use rust::rust;

/// What cannot be emitted, and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotEmitted {
    /// What it is: "a text".
    pub what: String,
    /// Where it stands in the source.
    pub span: Span,
}

impl NotEmitted {
    fn new(what: impl Into<String>, span: Span) -> Self {
        Self {
            what: what.into(),
            span,
        }
    }

    /// The failure as a diagnostic.
    pub fn diagnostic(&self) -> Diagnostic {
        let message = format!("{} cannot be emitted", self.what);
        Diagnostic::error("not-emitted", message, self.span).note(
            "`hedgerow plan` shows the operation as a table, and `hedgerow apply` and `run` carry it out",
        )
    }
}
