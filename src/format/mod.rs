//! Text to the same text, written as drawings are meant to be read.
//!
//! Names, colons, arrows and bars of consecutive statements of a drawing stand in columns; code is
//! indented by braces and broken where a line would be longer than [`WIDTH`]. What the author
//! decides stays: blank lines (one at most), edges that share a line, and blocks of one
//! statement that stand on one line. Only white space changes: every token and every comment
//! comes out as it went in, which is looked at each time before anything is answered, and
//! formatting twice changes nothing, which [`format()`] looks at, too.
//!
//! An item with a mistake in it stays as it is, so a file can be formatted while it is typed.
//!
//! [`format()`] answers with a whole text, [`edits`] and [`edits_of_lines`] with the white space to
//! exchange, for editors.

mod printer;

mod value;

mod action;

mod grid;

mod drawing;

mod item;

mod remark;

mod commas;

mod words;

mod file;

mod safe;

mod edit;

pub use edit::{Edit, edits, edits_of_lines};
pub use printer::WIDTH;
pub use safe::{Formatted, Refusal, format};
