//! A workbench: a program and a mesh, and everything that a page asks about them.
//!
//! [`Workbench::answer`] takes a question and gives an answer, both as JSON with bytes beside it
//! where there are many numbers. A page speaks with one in its own browser (WebAssembly), or with
//! one behind `hedgerow play`; it does not know which. Nothing that is asked makes it panic: what
//! cannot be answered is an error in words, and the mesh is as it was.
//!
//! The past is kept as copies of the mesh, as many as a limit of memory allows. A script is
//! stepped through, back and forth, along the [history](crate::mesh::History) of its run. What does
//! not fit into memory is had by running it again up to there: runs are the same each time.

mod ask;
mod broken;
mod code;
mod element;
mod layout;
mod message;
mod past;
mod run;
mod view;
mod workbench;

pub use message::Message;
pub use workbench::{Host, Workbench};
