//! Routines as Rust.

mod callee;
mod function;
mod sheet;
mod spelling;
mod statement;
mod steps;
mod support;

pub use function::rust;
