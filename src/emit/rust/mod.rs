//! Routines as Rust.

mod function;
mod spelling;

pub use function::rust;
