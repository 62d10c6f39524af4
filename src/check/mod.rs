//! Proves that an operation keeps every valid mesh valid, or says why not.
//!
//! The theorem: if [`check`] accepts an op, then for every valid mesh and every match the
//! rewritten mesh is valid: no pointer dangles, `twin` is a pairing without fixed points,
//! `next` a permutation, and faces, edges and vertices are in one-to-one correspondence with
//! the orbits of `next`, `twin` and next spoke, each with a `halfedge` in its own orbit.
//!
//! It is decided by a small enumeration, since a diagram changes `next` and `twin` only at
//! the names it draws; the rest of the mesh matters only by how it joins the loose ends of
//! the drawing. The laws, one file each, in order:
//!
//! 1. 2. `names_are_accounted_for`: every name, and every pointer of every name;
//! 3. `next_is_permutation`
//! 4. `twin_is_involution`
//! 5. `nothing_dangles`
//! 6. `ends_agree`
//! 7. `vertices_are_orbits`, by way of `port`s, `chain`s and `arrangement`s;
//! 8. `new_is_placed`.
//!
//! Rules with `families` are unrolled, and proved for cycles of every size at once by the
//! argument of `family_rings`.
//!
//! Before all of them, `start` tests that a parameter is drawn. A drawing that would apply almost
//! nowhere is refused as well (`fans_have_room`).
//!
//! A `before` that alone contradicts itself is reported alone (`before`).
//!
//! To show the effect of a rejected rule, `witness` carries it out on a mesh, and `mend` offers
//! fixes that are certain: names to keep, list or erase, edges by their ends (`pairing`), a vertex
//! that takes the spokes of an erased one (`fan_repair`), and several of these together (`joint`).
//! For a proved rule, `reach` finds the order in which the names are bound, and `properties` checks
//! the claims of `keeps` against the drawing; [`guard`] knows the conditions of the levels, and
//! those that a guard has to test. Only this module makes a [`Proved`], and only that can be
//! compiled. Nothing here depends on the machine.

mod alias;
mod argument;
mod arrangement;
mod before;
mod broken;
mod case;
mod chain;
mod change;
mod claims;
mod cost;
mod distinct_names;
mod ends_agree;
mod facts;
mod families;
mod family_orbits;
mod family_rings;
mod fan_repair;
mod fans_have_room;
mod fold;
mod forgotten;
pub mod guard;
mod joint;
mod keeps;
pub mod matching;
mod mend;
mod names_are_accounted_for;
mod new_is_placed;
mod next_is_permutation;
mod nothing_dangles;
mod outside;
mod pairing;
mod pointer;
mod port;
mod problem;
mod proof;
mod properties;
mod property_not_kept;
mod proved;
mod reach;
mod repairs;
mod ring_problems;
mod sizes;
mod stale;
mod star_order;
mod start;
mod statements;
mod twin_is_involution;
mod unknown_names;
mod vertices_are_orbits;
mod witness;

pub use alias::{Identification, Verdict, identifications};
pub use argument::Argument;
pub use before::contradictions;
pub use change::Change;
pub use facts::{Facts, Turned};
pub use proof::Proof;
pub use properties::SizeChange;
pub use proved::{Proved, Rejection, check, closing, examine};
pub use witness::{Counterexample, Outcome, try_out};
