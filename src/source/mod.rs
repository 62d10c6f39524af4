//! Files, spans and line tables.
//!
//! A [`Span`] is a range of bytes in one file; everything that can be wrong carries one.
//! [`Sources`] owns the texts and answers where a byte stands, in UTF-8 bytes, in UTF-16
//! units and in characters. Nothing here knows what the texts say.

mod line_table;
mod sources;
mod span;

pub use line_table::LineTable;
pub use sources::{Source, Sources};
pub use span::{FileId, Span};
