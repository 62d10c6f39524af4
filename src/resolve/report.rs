//! What is said about one item, and whether the item is lost.
//!
//! An item may be lost without a word of ours: the parser has spoken already, or
//! another item that it needs has. Every function that answers `None` here has
//! left its reason in the [`Report`].

use crate::diagnostic::Diagnostic;

/// The diagnostics of one item.
#[derive(Debug, Default)]
pub(super) struct Report {
    diagnostics: Vec<Diagnostic>,
    failed: bool,
}

impl Report {
    /// Takes in a diagnostic; an error loses the item.
    pub(super) fn add(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.is_error();
        self.diagnostics.push(diagnostic);
    }

    /// Whether something has been said with this note.
    pub(super) fn says(&self, note: &str) -> bool {
        self.diagnostics.iter().any(|told| told.notes.iter().any(|known| known == note))
    }

    /// Loses the item without a word, since the reason stands elsewhere.
    pub(super) fn fail(&mut self) {
        self.failed = true;
    }

    /// Whether the item is lost.
    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    /// What was said.
    pub(super) fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.diagnostics
    }
}
