//! Typed expressions to register code.
//!
//! The registers of names and variables are the [`Scope`]'s business, so that the same lowering
//! serves the diagrams of operations and scripts. An expression writes nothing but registers and
//! buffers of its own: the code around it can still refuse, or trap, with the mesh as it was.
//!
//! It is assumed that types are right: an ill-typed expression gives code that computes
//! nonsense, though nothing worse.

mod angle;
mod builtin;
mod collection;
mod fold;
mod operator;
mod pointer;
mod scope;
mod value;

pub use collection::{each, elements};
pub use scope::{Scope, copy, element_kind, width};
pub(super) use value::halfedge_field;
pub use value::{arguments, attribute, function_number, lower, lower_into};
