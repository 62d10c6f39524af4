//! Routines as Rust.

mod callee;
mod function;
mod sheet;
mod spelling;
mod statement;
mod steps;
mod support;
mod wide;

pub use function::rust;
pub(super) use support::written_out;
