//! A change that is offered.

use crate::diagnostic::{Diagnostic, Edit};

/// The purpose of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Purpose {
    /// A certain fix of a diagnostic.
    Fix,
    /// A possible fix of a diagnostic; the user decides.
    Proposal,
    /// An equivalent form, or text that would be written next.
    Rewrite,
}

/// A change that is offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Action {
    /// The change, as an imperative.
    pub title: String,
    pub purpose: Purpose,
    /// The replacements; they do not overlap.
    pub edits: Vec<Edit>,
    /// The diagnostic that it resolves, if that is known.
    pub mends: Option<Diagnostic>,
}
