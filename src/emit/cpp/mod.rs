//! Routines as C++17.

mod function;
mod headers;
mod pattern;
mod sheet;
mod spelling;
mod statement;
mod steps;
mod style;
mod support;
mod types;
mod wide;

pub use function::cpp;
pub use pattern::StyleError;
pub use style::Style;
pub(super) use support::is_written_out;
