//! Compilation of proved operations to plans, and of typed expressions to register code.
//!
//! [`compile`] takes a value that only the checker makes, so an unproved operation cannot run. It
//! lays out the four phases (collect, allocate, reassign, erase) twice: as code for the machine,
//! and as a table to read. The table is exhaustive; the code leaves out what provably does not
//! change.

mod operation;
mod output;

mod bind;
mod collect;
mod collected;
mod guard;
mod walk;

mod assign;
mod reassign;
mod write_target;

mod expression;
mod index_loop;
mod registers;
mod run;

pub use expression::{Orbit, Scope, arguments, copy, each, lower, lower_into, narrow, width};
pub use operation::compile;
