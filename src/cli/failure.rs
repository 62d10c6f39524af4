//! Failures of commands: the message, and the exit code.

use std::fmt::Display;
use std::process::ExitCode;

use super::output::complain;

/// The reason why a command ends without success.
#[derive(Debug)]
pub(super) enum Failure {
    /// Something is not proved, or a script failed; the reason is printed already.
    NotProved,
    /// A file, an argument or a mesh is at fault.
    Usage(String),
    /// The operation was refused.
    Refused(String),
    /// The reason is printed already.
    Silent(ExitCode),
}

impl Failure {
    /// A failure of usage or of a file.
    pub fn usage(message: impl Display) -> Self {
        Self::Usage(message.to_string())
    }

    /// The reason, if it is not printed already.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Failure::NotProved | Failure::Silent(_) => None,
            Failure::Usage(message) | Failure::Refused(message) => Some(message),
        }
    }

    /// Prints the reason to standard error.
    pub fn tell(&self) {
        match self {
            Failure::NotProved | Failure::Silent(_) => {}
            Failure::Usage(message) => complain(&format!("error: {message}")),
            Failure::Refused(reason) => complain(&format!("refused: {reason}")),
        }
    }

    /// The code the process ends with.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Failure::NotProved => ExitCode::from(1),
            Failure::Usage(_) => ExitCode::from(2),
            Failure::Refused(_) => ExitCode::from(3),
            Failure::Silent(code) => *code,
        }
    }
}
