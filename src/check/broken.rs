//! Reports on rules that are not proved.

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
    /// The outcome of carrying the rule out, if that has been tried.
    pub outcome: Option<Outcome>,
}

impl Broken {
    /// True if rings of spokes of `after` are joined or divided.
    pub fn is_of_rings(&self) -> bool {
        let mut codes = self.problems.iter().map(|problem| problem.diagnostic.code);
        codes.all(|code| ["two-vertices-one-ring", "vertex-splits"].contains(&code))
    }
}

impl From<Vec<Problem>> for Broken {
    fn from(problems: Vec<Problem>) -> Self {
        Self { problems, arcs: None, outcome: None }
    }
}

/// Returns the problems as an error, if there are any.
pub(super) fn stop_at(problems: Vec<Problem>) -> Result<(), Broken> {
    if problems.is_empty() { Ok(()) } else { Err(problems.into()) }
}

/// The report on a rule that is not proved.
pub(super) struct Rejected {
    /// Every law it breaks.
    pub diagnostics: Vec<Diagnostic>,
    /// The outcome when the rule is carried out literally.
    pub outcome: Outcome,
}
