//! Formatting: the same program, written so that its drawings are easy to read.
//!
//! Names, colons, arrows and bars of consecutive statements of a drawing are aligned in columns;
//! code is indented by braces and broken where a line would be longer than [`WIDTH`]. The author's
//! choices are kept: blank lines (at most one), edges that share a line, and blocks of one
//! statement that are on one line. Only white space and commas between names change: every other
//! token and every comment is kept, which is checked before anything is returned, and formatting
//! twice changes nothing, which [`format()`] checks, too.
//!
//! An item with an error in it is unchanged, so a file can be formatted while it is being typed.
//!
//! [`format()`] returns a whole text, [`edits`] and [`edits_of_lines`] the white space to replace,
//! for editors.

mod printer;

mod value;

mod action;

mod grid;

mod drawing;

mod item;

mod remark;

mod commas;

mod words;

mod torn;

mod file;

mod safe;

mod edit;

pub use edit::{Edit, edits, edits_of_lines};
pub use printer::WIDTH;
pub use safe::{Formatted, Refusal, format};
