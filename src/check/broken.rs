//! What is told of a rule that is not proved.

use super::arrangement::Arc;
use super::problem::Problem;
use super::witness::Outcome;
use crate::diagnostic::Diagnostic;

/// The laws that a rule breaks.
pub(super) struct Broken {
    /// The messages.
    pub problems: Vec<Problem>,
    /// For law 7 the arcs of the case that fails.
    pub arcs: Option<Vec<Arc>>,
    /// The outcome of carrying it out, if that has been tried.
    pub outcome: Option<Outcome>,
}

impl From<Vec<Problem>> for Broken {
    fn from(problems: Vec<Problem>) -> Self {
        Self { problems, arcs: None, outcome: None }
    }
}

/// Nothing, if there are no problems.
pub(super) fn stop_at(problems: Vec<Problem>) -> Result<(), Broken> {
    if problems.is_empty() { Ok(()) } else { Err(problems.into()) }
}

/// The report on a rule that is not proved.
pub(super) struct Rejected {
    /// Every law it breaks.
    pub diagnostics: Vec<Diagnostic>,
    /// The outcome when it is carried out literally.
    pub outcome: Outcome,
}
