//! Errors, with the source texts to show them.

use std::fmt;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Rendering, render};
use crate::run::{Failure, Report};
use crate::source::{FileId, Sources, Span};

/// The greatest number of diagnostics that are shown.
const MOST: usize = 50;

/// No place in any text.
pub(super) const NOWHERE: Span = Span { file: FileId(u32::MAX), start: 0, end: 0 };

/// The reason why a program cannot be used, or a call was not carried out.
///
/// Its text is what the command line prints, with the places in the program. A refusal is not an
/// error: it is a regular outcome.
#[derive(Clone)]
pub struct Error(Box<Parts>);

#[derive(Clone)]
struct Parts {
    diagnostics: Vec<Diagnostic>,
    sources: Arc<Sources>,
    report: Option<Report>,
}

impl Error {
    /// An error of at least one diagnostic about these texts.
    pub(super) fn new(diagnostics: Vec<Diagnostic>, sources: &Arc<Sources>) -> Self {
        Self(Box::new(Parts { diagnostics, sources: Arc::clone(sources), report: None }))
    }

    /// An error of one diagnostic.
    pub(super) fn one(diagnostic: Diagnostic, sources: &Arc<Sources>) -> Self {
        Self::new(vec![diagnostic], sources)
    }

    /// An error of one diagnostic without a place.
    pub(super) fn nowhere(code: &'static str, message: String, sources: &Arc<Sources>) -> Self {
        Self::one(Diagnostic::error(code, message, NOWHERE), sources)
    }

    /// The failure of a script, with its report.
    pub(super) fn failure(failure: Failure, sources: &Arc<Sources>) -> Self {
        let mut error = Self::one(failure.diagnostic, sources);
        error.0.report = Some(failure.report);
        error
    }

    /// Everything that is wrong.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.0.diagnostics
    }

    /// The texts that the diagnostics refer to.
    pub fn sources(&self) -> &Sources {
        &self.0.sources
    }

    /// The stable code of the first diagnostic, in kebab case; `hedgerow explain` describes it.
    pub fn code(&self) -> &'static str {
        self.0.diagnostics.first().map_or("", |first| first.code)
    }

    /// The first diagnostic in one line.
    pub fn message(&self) -> &str {
        self.0.diagnostics.first().map_or("", |first| &first.message)
    }

    /// The report of a script up to its failure; `None` for other errors.
    pub fn report(&self) -> Option<&Report> {
        self.0.report.as_ref()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let how = Rendering { colour: false, most: MOST };
        f.write_str(render(&self.0.diagnostics, &self.0.sources, how).trim_end())
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl std::error::Error for Error {}
