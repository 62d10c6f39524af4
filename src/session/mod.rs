//! The library interface: operations and scripts called from Rust, repeatedly.
//!
//! A [`Program`] is read, proved and compiled once. A [`Session`] has a mesh and what is needed to
//! call operations and scripts of one program on it without setup: a machine, the columns of
//! attributes, the level that the mesh is known to have. A call costs what the machine costs.
//!
//! The mesh is assumed to be valid, as is every mesh built from polygons. No argument of a caller
//! makes a session panic: invalid ones give an [`Error`], and the mesh is unchanged.

mod error;
mod item;
mod program;

mod arguments;
mod attributes;
mod outcome;
mod values;

mod binding;
mod engine;
mod level;
mod marks;
mod masks;
#[cfg(feature = "draw")]
mod picture;
mod questions;
#[allow(clippy::module_inception)]
mod session;

use std::sync::atomic::{AtomicU64, Ordering};

pub use arguments::{Arguments, Given};
pub use error::Error;
pub use item::{Function, Op, Parameter, Script};
pub use marks::Mark;
pub use masks::KeptMask;
pub use outcome::{Outcome, Reason, Verdict};
pub use program::Program;
pub use questions::Match;
pub use session::Session;
pub use values::Values;

pub use crate::run::Argument;

/// A number that no other call returns, in any session: a name for what a session makes.
fn new_name() -> u64 {
    static MADE: AtomicU64 = AtomicU64::new(1);
    MADE.fetch_add(1, Ordering::Relaxed)
}
