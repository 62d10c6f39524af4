//! A proved operation, decided: what is asked, in which order and why it is refused.
//!
//! Register code, C++, Rust and the table of an operation spell the lists that are made here, and
//! decide nothing of it again. The pointers that phase 3 sets are listed by
//! [`Drawing::reassignments`](crate::diagram::Drawing::reassignments).

mod guard;

pub use guard::{Condition, Guard, GuardTest, PreviewReads, Question, StarWalk};
