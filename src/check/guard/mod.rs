//! Levels: the conditions of meshes beyond maps that an operation may break, and the weakest guard
//! against that.
//!
//! On a mesh of a level, an operation can break the level only where its drawing brings
//! things together that were apart. So each condition of the level becomes a [`Statement`]
//! about one orbit of `after`, made of drawn pieces and of paths, fans and arcs that stay
//! as they were. Each is an [`Obligation`]: proved from the drawing, from the level before
//! or from a `require`, or left over as a test. A guard makes the tests that are left, and
//! no others; `keeps LEVEL` demands that none is.
//!
//! # Why these statements are all
//!
//! A condition about orbits that have not changed holds because it held before. The possible
//! changes:
//!
//! * A loop changes only if `after` draws it: its size, and which vertices it meets
//!   (`surface`). Other loops keep their halfedges, but a corner of theirs can move from
//!   one vertex to another with a fan or an outer halfedge. The vertex it moves to is drawn.
//! * So two corners of one loop at one vertex, where there were none, lie either in a loop
//!   of `after`, where one of them is named or both are on paths; or both in pieces outside
//!   of the drawing, that have come to one vertex from two.
//! * A vertex loses spokes, or gains a corner in a hole, only if it is drawn, or lies on a
//!   path that goes from a face to a hole.
//! * A vertex of two spokes or more with one hole at most has a face. And the two sides of
//!   an edge are two corners at either of its ends: if both were holes, the end would have
//!   two of them, or a single spoke. So "a face around each vertex" and "a face along each
//!   edge" follow from the rest and are never tested.
//! * That no edge ends where it begins follows too: the face along it would meet that vertex
//!   twice.
//! * Two edges have the same ends, and did not, only if one of them is drawn and new, or
//!   moved an end; or if a fan has brought it to a vertex that has other spokes
//!   (`simple`). Two faces have the same corners, and had not, only if one of them is
//!   drawn with other corners than before, or a fan has brought one of its corners to a
//!   vertex with faces from elsewhere; both then lie around any of these corners.
//!
//! The tests look at the result itself, so a statement that could be proved but is not costs time,
//! but no exactness.

mod evidence;
mod obligation;
mod simple;
mod sketch;
mod surface;

pub use obligation::{Condition, Obligation, Statement};

use crate::diagram::{Drawing, Level};

/// The obligations of a level for a rule: what is proved, and what is left to test.
pub(super) fn obligations(drawing: &Drawing, level: Level) -> Vec<Obligation> {
    let sketch = sketch::Sketch::new(drawing);
    let mut obligations = Vec::new();
    if level >= Level::Surface {
        obligations.extend(surface::obligations(&sketch));
    }
    if level >= Level::Simple {
        obligations.extend(simple::obligations(&sketch));
    }
    obligations
}
