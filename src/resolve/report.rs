//! Reports: the messages about one item, and whether the item is lost.
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
    /// Names of which enough has been said.
    confused: Vec<String>,
}

impl Report {
    /// Takes in a diagnostic; an error loses the item.
    pub(super) fn add(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.is_error();
        let begins = |word: &String| {
            let rest = diagnostic.message.strip_prefix('`');
            let rest = rest.and_then(|rest| rest.strip_prefix(word.as_str()));
            rest.is_some_and(|rest| rest.starts_with(['`', '[']))
        };
        if !self.confused.iter().any(begins) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Takes in no more of what is said of a name.
    pub(super) fn confuse(&mut self, word: &str) {
        self.confused.push(word.to_owned());
    }

    /// True if enough has been said of a name.
    pub(super) fn is_confused(&self, word: &str) -> bool {
        self.confused.iter().any(|known| known == word)
    }

    /// True if something has been said with this note.
    pub(super) fn says(&self, note: &str) -> bool {
        self.diagnostics.iter().any(|told| told.notes.iter().any(|known| known == note))
    }

    /// Loses the item without a word, since the reason stands elsewhere.
    pub(super) fn fail(&mut self) {
        self.failed = true;
    }

    /// True if the item is lost.
    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    /// The messages.
    pub(super) fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.diagnostics
    }
}
