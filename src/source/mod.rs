//! Files, spans and line tables.
//!
//! A [`Span`] is a range of bytes in one file; every diagnostic carries one. [`Sources`] owns the
//! texts and translates byte offsets to lines and columns. Nothing here knows what the texts mean.

mod line_table;
mod sources;
mod span;

pub use line_table::LineTable;
pub use sources::{Source, Sources};
pub use span::{FileId, Span};
