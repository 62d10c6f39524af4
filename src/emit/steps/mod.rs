//! Operations in steps, and functions that do more than compute a value, as routines.
//!
//! What they call is emitted before them. Where the mesh of a language can undo what was done
//! to it, that is all; where it cannot, all that is called writes through a journal.

mod body;
mod calls;
mod comments;
mod deeds;
mod items;
mod keep;

pub(super) use items::{Item, Items, items};
