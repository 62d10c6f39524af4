//! Operations in steps, and functions, as routines.
//!
//! Everything that they call is emitted before them. Where the mesh of a language can undo changes,
//! that is all; where it cannot, everything that is called writes through a journal.

mod body;
mod calls;
mod comments;
mod journal;

pub(super) use body::Writer;
pub(super) use journal::journaled;
