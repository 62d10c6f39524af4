//! Routines as Rust.

mod function;

pub use function::rust;
pub(super) use function::ty;
