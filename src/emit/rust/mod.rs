//! Routines as Rust.

mod function;
mod matrix;
mod preview;
mod spelling;
mod statement;
mod steps;

pub use function::rust;
