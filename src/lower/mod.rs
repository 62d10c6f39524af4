//! A proved operation, decided: what is asked, in which order and why it is refused.
//!
//! Register code, C++, Rust and the table of an operation spell the lists that are made here, and
//! decide nothing of it again. The pointers that phase 3 sets are listed by
//! [`Drawing::reassignments`](crate::diagram::Drawing::reassignments).

mod guard;
mod hoist;
mod matching;
mod operation;
mod symmetric;
mod words;

pub use guard::{Guard, GuardCondition, GuardTest, PreviewReads, Question, StarWalk};
pub use hoist::{Hoisted, hoist};
pub use matching::{Begin, EmptyPath, Matching, Step, Test, Tries, Walk, WalkTest};
pub use operation::{Condition, Element, Operation, Value};
pub use words::{bound as bound_word, source as source_word};
