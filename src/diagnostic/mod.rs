//! Diagnostics as data: a code, a message, places, notes and fixes.
//!
//! Every layer that can fail turns its failures into [`Diagnostic`]s in one place;
//! [`render`] prints them to a terminal, [`explain`] says what a code means. A message is one line, lower case, and can be
//! understood alone; labels point; a fix is offered only when it is surely right.

mod data;
mod explain;
mod render;
mod shown;

pub use data::{Diagnostic, Edit, Fix, Label, Severity};
pub use explain::{explain, explained};
pub use render::{Rendering, render};
pub use shown::shown;
