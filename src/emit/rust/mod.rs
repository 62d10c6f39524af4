//! Routines as Rust.

mod function;
mod helper;
mod spelling;

pub use function::rust;
