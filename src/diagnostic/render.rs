//! Diagnostics on a terminal.

use super::Diagnostic;
use crate::source::Sources;

/// How to print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rendering {
    /// Whether to colour.
    pub colour: bool,
    /// How many diagnostics to print at most; the rest is counted.
    pub most: usize,
}

/// Prints diagnostics as text.
pub fn render(_diagnostics: &[Diagnostic], _sources: &Sources, _how: Rendering) -> String {
    String::new()
}
