//! Lowering of typed expressions to register code.
//!
//! The [`Scope`] provides the registers of names and variables, so that the same lowering serves
//! the diagrams of operations and scripts. An expression writes only registers and buffers of its
//! own: the code around it can still refuse, or trap, with the mesh unchanged.
//!
//! Expressions are assumed to be well typed: an ill-typed one gives code that computes meaningless
//! values, but does no other harm.

mod angle;
mod builtin;
mod collection;
mod fold;
mod operator;
mod pointer;
mod scope;
mod value;

pub use collection::{Orbit, each};
pub use scope::{Scope, copy, width};
pub use value::{arguments, lower, lower_into, narrow};
pub(super) use value::{element_field, halfedge_field};
