//! Everything an editor or a command may ask of a program; plain data out.
//!
//! [`Analysis`] takes a text all the way: tree, program, proofs, plans, and every
//! diagnostic met on the way. Whatever is in order is there, however broken the rest is.

mod argument;
mod examined;
mod files;
mod program;
mod verdict;

pub use crate::check::{Argument, Counterexample, Proved};
pub use argument::{RuleArgument, why_proved};
pub use examined::Examined;
pub use files::{Nowhere, Reader};
pub use program::Analysis;
pub use verdict::{GuardVerdict, ProvedStatement, RuleVerdict, Verdict, verdicts};
