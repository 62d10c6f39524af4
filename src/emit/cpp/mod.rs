//! Routines as C++17.

mod function;
pub mod headers;
mod pattern;
mod signature;
mod style;
pub(in crate::emit) mod support;

pub use function::cpp;
pub use pattern::StyleError;
pub use style::Style;
