//! Completions at a cursor, the likeliest first.

mod choice;

mod offer;

// What is offered, by the place of the cursor.
mod drawing;
mod field;
mod path;
mod value;
mod words;

// What is known of the value before a dot.
mod operand;

pub use choice::{Choice, Completion};
pub use offer::completions;
