//! Completions at a cursor, the likeliest first.

mod choice;

mod offer;

// What is offered, by the place of the cursor.
mod drawing;
mod path;
mod value;
mod words;

pub use choice::{Choice, Completion};
pub use offer::completions;
