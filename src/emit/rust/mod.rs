//! Routines as Rust.

mod function;
mod preview;
mod spelling;
mod statement;
mod steps;

pub use function::rust;
