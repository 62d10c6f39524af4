//! Running scripts on meshes.
//!
//! `prepare` lowers a script of a resolved program to register code, with the plans of the
//! operations it calls; [`run`] runs it on the machine. The outcome is a [`Report`] of the
//! operations that were applied and refused, or a [`Failure`] with a diagnostic.
//!
//! The semantics of loops is implemented here. A `for` loop visits, in order, the elements that
//! exist when it starts and still exist when their turn comes; elements created in the loop are not
//! visited. The loop lists its elements at the start, and no id is reused while it runs: erased
//! elements are recycled only where no loop over elements runs and no variable holds an element
//! that is still needed. The writes of an `update` are kept back to its end; if one element is
//! written twice, the last write wins.
//!
//! A script that fails leaves the mesh as it was at that point; the caller discards it.

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
pub(crate) use columns::{Columns, remove_stand_ins, replace_stand_in};
pub use function::Functions;
pub(crate) use prepare::prepare_function;
pub use prepare::{Prepared, prepare};
pub use report::{Failure, OpReport, Report, run};
pub(crate) use report::{diagnostic, highest_between, report};
pub use steps::{calls_of_steps, plan_steps};
pub use testing::{Conditions, Load, constructed, test};
