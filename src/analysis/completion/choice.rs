//! A completion, and its kind.

use std::ops::Range;

use crate::analysis::words::meaning;
use crate::diagnostic::Edit;
use crate::diagram::Kind;

/// The kind of a completion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    Keyword,
    Type,
    Property,
    Element(Kind),
    Variable,
    Field,
    Function,
    Op,
    File,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    pub word: String,
    /// Its kind.
    pub choice: Choice,
    /// A detail that is worth seeing beside it; may be empty.
    pub detail: String,
    /// Its documentation, a line each.
    pub docs: Vec<String>,
    /// The text to write, with places to fill as `$1`, `${2:name}`; the word itself if `None`.
    pub snippet: Option<String>,
    /// The bytes that it replaces; the word at the cursor if `None`.
    pub replaced: Option<Range<usize>>,
    /// What else has to be inserted: the `use` of its file.
    pub insertion: Option<Edit>,
    /// The rank: the smaller, the likelier.
    pub rank: u8,
}

impl Completion {
    pub(super) fn new(word: impl Into<String>, choice: Choice, rank: u8) -> Self {
        let word = word.into();
        let detail = meaning(&word).unwrap_or("").to_owned();
        Self {
            detail,
            word,
            choice,
            docs: Vec::new(),
            snippet: None,
            replaced: None,
            insertion: None,
            rank,
        }
    }

    /// The call of something: its signature, and its documentation, a line each.
    pub(super) fn call(name: &str, signature: String, docs: Vec<String>, choice: Choice) -> Self {
        let call = Self::new(name, choice, 2).with(&format!("{name}($1)"));
        Self { detail: signature, docs, ..call }
    }

    pub(super) fn with(mut self, snippet: &str) -> Self {
        self.snippet = Some(snippet.to_owned());
        self
    }
}
