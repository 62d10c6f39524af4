//! Routines as C++17.

mod function;
pub mod headers;
mod pattern;
mod signature;
mod style;
pub(in crate::emit) mod support;

pub(in crate::emit) use function::CALLED;
pub use function::cpp;
pub use pattern::{StyleError, style_patterns};
pub use style::Style;
