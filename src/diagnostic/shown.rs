//! Text that is safe to show on a terminal.
//!
//! Names, reasons, file names and the output of programs are untrusted. On a terminal, an escape
//! sequence in them could move the cursor, hide lines or set the clipboard, and a change of the
//! direction of writing could make a text look like another.

use std::borrow::Cow;

/// A text without the characters that control a terminal, except line ends and tabs.
pub fn shown(text: &str) -> Cow<'_, str> {
    match text.chars().all(|character| showable(character) == character) {
        true => Cow::Borrowed(text),
        false => Cow::Owned(text.chars().map(showable).collect()),
    }
}

/// A character, or its replacement if it would move the cursor, change the direction of writing, or
/// end a line other than with `\n`.
pub(super) fn showable(character: char) -> char {
    match character {
        '\n' | '\t' => character,
        '\r' | '\u{2028}' | '\u{2029}' | '\u{FEFF}' => ' ',
        '\u{61C}' | '\u{200E}'..='\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => {
            '\u{FFFD}'
        }
        control if control.is_control() => '\u{FFFD}',
        shown => shown,
    }
}
