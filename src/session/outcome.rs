//! Outcomes of calls of operations.

use std::fmt;
use std::sync::Arc;

use crate::mesh::Element;

/// The outcome of a call of an operation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It has been applied, with the element that it returned, if it returns one.
    Applied(Option<Element>),
    /// It does not apply here, and the mesh is unchanged.
    Refused(Reason),
}

impl Outcome {
    /// True if it has been applied.
    pub fn is_applied(&self) -> bool {
        matches!(self, Self::Applied(_))
    }

    /// The element that it returned.
    pub fn result(&self) -> Option<Element> {
        match self {
            Self::Applied(result) => *result,
            Self::Refused(_) => None,
        }
    }

    /// The reason why it refused.
    pub fn reason(&self) -> Option<&Reason> {
        match self {
            Self::Applied(_) => None,
            Self::Refused(reason) => Some(reason),
        }
    }
}

/// The reason why an operation refuses: one of [`Op::reasons`](super::Op::reasons).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reason {
    /// Its number among them.
    pub number: usize,
    /// Its text.
    pub text: Arc<str>,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Whether an operation would be applied at an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There is no such element.
    Gone,
    /// It would be applied.
    Applies,
    /// It would refuse, for the reason of this number.
    Refuses(usize),
}
