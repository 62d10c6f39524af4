//! Failures of commands: the message, and the exit code.

use std::fmt::Display;
use std::process::ExitCode;

use serde::Serialize;

use super::check::{DiagnosticReport, reports};
use super::output::{eprint_diagnostics, eprint_wrapped, print_json};
use crate::diagnostic::Diagnostic;
use crate::source::Sources;

/// The reason why a command ends without success.
#[derive(Debug)]
pub(super) enum Failure {
    /// Something is not proved, or a script failed; the reason is printed already.
    NotProved,
    /// A file, an argument or a mesh is at fault.
    Usage(String),
    /// The operation was refused.
    Refused(String),
    /// These diagnostics, which are printed already.
    Told(Vec<DiagnosticReport>, ExitCode),
    /// The reason is printed already.
    Silent(ExitCode),
}

/// A failure as data.
#[derive(Serialize)]
struct Report<'f> {
    error: &'f str,
    diagnostics: &'f [DiagnosticReport],
}

impl Failure {
    /// A failure of usage or of a file.
    pub fn usage(message: impl Display) -> Self {
        Self::Usage(message.to_string())
    }

    /// A failure for these diagnostics, which are printed.
    pub fn of(diagnostics: &[Diagnostic], sources: &Sources, code: u8) -> Self {
        eprint_diagnostics(diagnostics, sources);
        Self::Told(reports(diagnostics, sources), code.into())
    }

    /// Prints the failure as JSON to standard output, unless that has been done.
    pub fn tell_json(&self) -> Result<(), Self> {
        let (error, diagnostics) = match self {
            Failure::Usage(message) => (message.as_str(), [].as_slice()),
            Failure::Told(told, _) => match told.iter().find(|told| told.is_error()) {
                Some(first) => (first.message.as_str(), told.as_slice()),
                None => return Ok(()),
            },
            Failure::NotProved | Failure::Refused(_) | Failure::Silent(_) => return Ok(()),
        };
        print_json(&Report { error, diagnostics })
    }

    /// The reason, if it is not printed already.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Failure::NotProved | Failure::Told(..) | Failure::Silent(_) => None,
            Failure::Usage(message) | Failure::Refused(message) => Some(message),
        }
    }

    /// Prints the reason to standard error.
    pub fn tell(&self) {
        match self {
            Failure::NotProved | Failure::Told(..) | Failure::Silent(_) => {}
            Failure::Usage(message) => eprint_wrapped("error: ", message),
            Failure::Refused(reason) => eprint_wrapped("refused: ", reason),
        }
    }

    /// The code the process ends with.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Failure::NotProved => ExitCode::from(1),
            Failure::Usage(_) => ExitCode::from(2),
            Failure::Refused(_) => ExitCode::from(3),
            Failure::Told(_, code) | Failure::Silent(code) => *code,
        }
    }
}
