//! Scripts on meshes.
//!
//! `prepare` lowers a script of a resolved program to register code, with the plans of
//! the operations it calls; [`run`] sets the machine to work on it and says what came of
//! it: a [`Report`] of what was applied and refused, or a [`Failure`] with a diagnostic.
//!
//! The meaning of loops is kept here. A loop visits the elements that exist when it starts
//! and still exist when their turn comes, in order; what is born inside is not visited. It
//! takes a list of them at the start, and no id is reused while the loop runs: erased
//! elements are let go only where no loop over elements runs and no variable holds an
//! element that is still needed. The writes of an `update` are kept back to its end; if one
//! element is written twice, the last write stays. To leave an `update` early, by `break`
//! or `return`, is to come to its end.
//!
//! A script that fails has done what it did so far: the caller discards the mesh then.

mod call;
mod columns;
mod drain;
mod function;
pub mod live;
mod lower;
mod prepare;
mod print;
mod steps;
mod visit;

mod apply;
mod argument;
mod report;
mod testing;

pub(crate) use apply::UNKNOWN_REASON;
pub use apply::{Application, Applied, apply, arguments, attributes};
pub use argument::Argument;
pub(crate) use columns::Columns;
pub use function::Functions;
pub(crate) use prepare::prepare_function;
pub use prepare::{Prepared, prepare};
pub use report::{Failure, OpReport, Report, run};
pub(crate) use report::{diagnostic, highest_between, report};
pub use steps::{calls_of_steps, plan_steps};
pub use testing::{Conditions, Load, test};
