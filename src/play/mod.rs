//! A workbench: a program and a mesh, and everything that a page asks about them.
//!
//! [`Workbench::answer`] takes a question and returns an answer, both as JSON, with binary data
//! where there are many numbers. A page uses one in its own browser (WebAssembly), or one behind
//! `hedgerow play`, without knowing which. No question makes it panic: a failure is an error in
//! words, and leaves the mesh as it was.
//!
//! For undo, copies of the mesh are kept, as many as a limit of memory allows. A script is stepped
//! through, back and forth, along the [history](crate::mesh::History) of its run. States that do
//! not fit into memory are recomputed by running it again up to there: runs are deterministic.

mod ask;
mod broken;
mod code;
mod element;
mod frame;
mod layout;
mod message;
mod past;
mod run;
mod view;
mod workbench;

pub use message::Message;
pub use workbench::{Host, Workbench};
