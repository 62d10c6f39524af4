//! Routines as C++17.

mod function;
mod sheet;
mod spelling;
mod statement;
mod steps;
mod style;
mod support;
mod types;
mod wide;

pub use function::cpp;
pub use style::{Style, StyleError};
pub(super) use support::is_written_out;
