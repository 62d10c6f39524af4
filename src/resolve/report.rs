//! Reports: the diagnostics of one item, and whether the item has failed.
//!
//! An item may fail without a diagnostic here: the parser has reported it already, or another item
//! that it needs has failed. Every function of `resolve` that returns `None` has recorded the
//! reason in the [`Report`].

use crate::diagnostic::Diagnostic;

/// The diagnostics of one item.
#[derive(Debug, Default)]
pub(super) struct Report {
    diagnostics: Vec<Diagnostic>,
    failed: bool,
    failed_silently: bool,
    /// Names about which nothing more is reported.
    suppressed: Vec<String>,
}

impl Report {
    /// Adds a diagnostic; an error marks the item as failed.
    pub(super) fn add(&mut self, diagnostic: Diagnostic) {
        self.failed |= diagnostic.is_error();
        let begins = |word: &String| {
            let rest = diagnostic.message.strip_prefix('`');
            let rest = rest.and_then(|rest| rest.strip_prefix(word.as_str()));
            rest.is_some_and(|rest| rest.starts_with(['`', '[']))
        };
        if !self.suppressed.iter().any(begins) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Adds an error, and gives nothing in place of what has it.
    pub(super) fn reject<T>(&mut self, error: Diagnostic) -> Option<T> {
        self.add(error);
        None
    }

    /// Drops further diagnostics whose message starts with this name.
    pub(super) fn suppress(&mut self, word: &str) {
        self.suppressed.push(word.to_owned());
    }

    /// True if nothing more is reported about this name.
    pub(super) fn is_suppressed(&self, word: &str) -> bool {
        self.suppressed.iter().any(|known| known == word)
    }

    /// True if a diagnostic has this note.
    pub(super) fn says(&self, note: &str) -> bool {
        self.diagnostics.iter().any(|told| told.notes.iter().any(|known| known == note))
    }

    /// Marks the item as failed without a diagnostic: the reason is reported elsewhere.
    pub(super) fn fail(&mut self) {
        self.failed = true;
        self.failed_silently = true;
    }

    /// Marks the item as failed without a diagnostic, and gives nothing in place of what failed.
    pub(super) fn fail_silently<T>(&mut self) -> Option<T> {
        self.fail();
        None
    }

    /// True if all errors have this code, and nothing else has failed.
    pub(super) fn has_only(&self, code: &str) -> bool {
        let mut errors = self.diagnostics.iter().filter(|told| told.is_error());
        !self.failed_silently && errors.all(|error| error.code == code)
    }

    /// True if the item has failed.
    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    pub(super) fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.diagnostics
    }
}
