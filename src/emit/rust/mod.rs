//! Routines as Rust.

mod function;
mod spelling;
mod statement;
mod steps;

pub use function::rust;
