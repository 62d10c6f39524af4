//! Reasons why a text is not a dump.

use std::fmt;

use crate::mesh::attribute::AttributeType;
use crate::mesh::id::Element;

/// The reason why a file is not a dump, and its line, from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DumpError {
    pub line: usize,
    pub reason: DumpReason,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DumpReason {
    /// A line that does not begin with a word of the format.
    Unknown(String),
    /// A line that does not have this form.
    NotOfForm(&'static str),
    NotAnId {
        text: String,
        /// Ids are smaller than this.
        below: u32,
    },
    NotANumber(String),
    /// A text that is not a value of the type of its attribute.
    NotAValue(AttributeType),
    /// An attribute that is already declared for its kind.
    AttributeTwice(String),
    /// A value for an element that has no line above it.
    ValueOf(Element),
    /// A `value` line before the first `attribute` of its table.
    NoAttribute,
    /// An element with two lines.
    Twice(Element),
    /// An element before the first `mesh`.
    NoMesh,
}

impl fmt::Display for DumpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: ", self.line)?;
        match &self.reason {
            DumpReason::Unknown(word) => write!(f, "`{word}` begins no line of a dump"),
            DumpReason::NotOfForm(form) => write!(f, "expected `{form}`"),
            DumpReason::NotAnId { text, below } => write!(f, "`{text}` is not an id below {below}"),
            DumpReason::NotANumber(text) => write!(f, "`{text}` is not a number"),
            DumpReason::NotAValue(ty) => write!(f, "expected a value of type {ty}"),
            DumpReason::AttributeTwice(name) => {
                write!(f, "the attribute `{name}` has a line already")
            }
            DumpReason::ValueOf(element) => write!(f, "{element} has no line above this value"),
            DumpReason::NoAttribute => write!(f, "no `attribute` line comes before it"),
            DumpReason::Twice(element) => write!(f, "{element} has a line already"),
            DumpReason::NoMesh => write!(f, "no `mesh` line comes before it"),
        }
    }
}

impl std::error::Error for DumpError {}
