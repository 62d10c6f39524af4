//! Routines as Rust.

mod callee;
mod function;
mod matrix;
mod preview;
mod spelling;
mod statement;
mod steps;
mod support;

pub use function::rust;
pub(super) use support::written_out;
