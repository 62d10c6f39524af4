//! What people write who come from other languages, mesh libraries and courses, and how it is
//! written here.
//!
//! A text that can be read is never looked at here. Where an item cannot, its tokens are
//! compared with a [table] of such ways of writing; what is found is told once, with
//! the way out, and put into the words of the language, so that the rest of the item is read
//! as it was meant.

mod pattern;

mod table;

mod place;

mod sign;

mod found;

mod told;

mod mend;

pub(super) use found::Found;
pub(super) use mend::{Mended, mend};
pub(super) use told::tell;
