//! Lowering: decisions that all back ends share.
//!
//! For a proved operation: what is tested, in which order, and the reasons to refuse. Register
//! code, C++, Rust and the table of an operation are written from the lists that are made here, and
//! decide none of it again. The pointers that phase 3 sets are listed by
//! [`Drawing::reassignments`](crate::diagram::Drawing::reassignments).
//!
//! For the statements of scripts, functions and operations in steps: the variables that they use,
//! what they call, their effects on a mesh, and which values are finite.

mod guard;
mod hoist;
mod matching;
mod operation;
mod symmetric;
mod words;

mod effects;
mod finite;
mod variables;

pub use effects::{AllEffects, Effects};
pub use finite::{ORDINARY, is_surely_finite};
pub use guard::{Guard, GuardTest, PreviewReads, Question, StarWalk};
pub use hoist::{Hoisted, hoist, may_stop};
pub use matching::{Begin, EmptyPath, Matching, Step, Test, Tries, Walk, WalkTest};
pub use operation::{Condition, Element, Operation, Value};
pub use variables::Variables;
pub use words::{bound as bound_word, source as source_word};
