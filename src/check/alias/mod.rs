//! Identification of names: which meshes a drawing excludes because its names are distinct.
//!
//! Different names are different elements, so a match that would make two of them one is refused.
//! Whether that is necessary is decided here: the two are made one in the drawing itself, with all
//! that follows ([`closure`]: the twins of one halfedge are one, its ends, its loop, and two
//! statements of one loop [`overlap`]). The result is a rule like any other, a [`quotient`], and
//! the laws decide: it is proved, or it breaks a mesh, or no mesh matches it ([`verdict`]).
//!
//! An `alias` lets names be one. The op is then proved for each set of its names that can be one
//! ([`allowed`]), and keeps only what it keeps in all of these cases; only then is the test left
//! out.

mod allowed;
mod closure;
mod overlap;
mod quotient;
mod verdict;

pub(super) use allowed::{allowed, drawable_where_one};
pub(super) use quotient::{Quotient, is_rotated};
pub use verdict::{Identification, Verdict, identifications};
