//! Operations in steps, and functions, as routines.
//!
//! Everything that is called is emitted before them. Where the mesh of a language can undo what was
//! done to it, that is all; where it cannot, all that is called writes through a journal.

mod body;
mod calls;
mod comments;
mod items;
mod journal;

pub(super) use items::{Item, Items, items};
