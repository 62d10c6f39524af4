//! Programs as a library: operations and scripts called from Rust, again and again.
//!
//! A [`Program`] is read, proved and compiled once. A [`Session`] has a mesh and what is needed to
//! call operations and scripts of one program on it without delay: a machine, the columns of
//! attributes, the level that the mesh is known to have. A call costs what the machine costs.
//!
//! It is assumed that the mesh is valid, as every mesh is that was built from polygons. Nothing
//! that a caller gives makes a session panic: what does not fit is an [`Error`], and the mesh is as
//! it was.

mod error;
mod item;
mod program;

mod arguments;
mod attributes;
mod outcome;
mod values;

mod engine;
mod level;
mod marks;
mod masks;
#[cfg(feature = "draw")]
mod picture;
mod questions;
#[allow(clippy::module_inception)]
mod session;

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
