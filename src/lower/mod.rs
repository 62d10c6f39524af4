//! A program, decided for all that spell it.
//!
//! Of a proved operation: what is asked, in which order and why it is refused. Register code, C++,
//! Rust and the table of an operation spell the lists that are made here, and decide nothing of it
//! again. The pointers that phase 3 sets are listed by
//! [`Drawing::reassignments`](crate::diagram::Drawing::reassignments).
//!
//! Of the statements of scripts, functions and operations in steps: which variables they use, what
//! they call, and what that does to a mesh.

mod guard;
mod hoist;
mod matching;
mod operation;
mod symmetric;
mod words;

mod effects;
mod variables;

pub use effects::{AllEffects, Effects};
pub use guard::{Guard, GuardTest, PreviewReads, Question, StarWalk};
pub use hoist::{Hoisted, hoist};
pub use matching::{Begin, EmptyPath, Matching, Step, Test, Tries, Walk, WalkTest};
pub use operation::{Condition, Element, Operation, Value};
pub use variables::Variables;
pub use words::{bound as bound_word, source as source_word};
