//! Text as it may be shown.
//!
//! Names, reasons, file names and what programs print come from others. On a terminal an escape
//! sequence among them could move the cursor, hide lines or set the clipboard, and a change of the
//! direction of writing could make a text look like another.

use std::borrow::Cow;

/// A text of which nothing is left that a terminal would obey but line ends and tabs.
pub fn shown(text: &str) -> Cow<'_, str> {
    match text.chars().all(|character| showable(character) == character) {
        true => Cow::Borrowed(text),
        false => Cow::Owned(text.chars().map(showable).collect()),
    }
}

/// A character as it may be shown: none that moves the cursor or turns the direction of writing,
/// and none that ends a line but `\n`.
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
