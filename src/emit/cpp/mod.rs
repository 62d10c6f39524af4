//! Routines as C++17.

mod function;
pub mod headers;
mod pattern;
mod preview;
mod signature;
mod spelling;
mod statement;
mod steps;
mod style;
mod support;

pub use function::cpp;
pub use pattern::StyleError;
pub use style::Style;
