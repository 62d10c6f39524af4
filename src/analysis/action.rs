//! A change that is offered.

use crate::diagnostic::{Diagnostic, Edit};

/// The purpose of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Purpose {
    /// It surely mends a diagnostic.
    Fix,
    /// It may mend one: a person decides.
    Proposal,
    /// It writes the same otherwise, or writes what would follow.
    Rewrite,
}

/// A change that is offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Action {
    /// The change, as an imperative.
    pub title: String,
    /// Its purpose.
    pub purpose: Purpose,
    /// The replacements; they do not overlap.
    pub edits: Vec<Edit>,
    /// The diagnostic that it is about.
    pub mends: Option<Diagnostic>,
}
