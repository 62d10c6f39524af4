//! Diagnostics as data: a code, a message, places, notes and fixes.
//!
//! Every layer that can fail turns its failures into [`Diagnostic`]s in one place; [`render`]
//! prints them to a terminal, [`explain`] documents a code. A message is one line in lower case
//! that can be understood on its own; labels point at places; a fix is offered only when it is
//! certainly right.

mod data;
mod explain;
mod render;
mod shown;
mod words;

pub use data::{Diagnostic, Edit, Fix, Label, Severity, applied};
pub use explain::{explain, explained};
pub use render::{Rendering, render};
pub use shown::shown;
pub use words::{all_of, counted, one_of, quoted, some_of};
