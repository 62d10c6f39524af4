//! Routines as Rust.

mod callee;
mod function;
mod sheet;
mod spelling;
mod statement;
mod support;

pub use function::rust;
