//! Texts in quotes: their escapes undone.

use std::ops::Range;

/// A text as it was meant, and the escapes that mean nothing.
pub(super) struct ReadText {
    /// The text; an unknown escape stands for itself.
    pub value: String,
    /// Unknown escapes and their places within the token.
    pub unknown: Vec<(Range<usize>, String)>,
}

/// Undoes the escapes of a text token; the closing quote may be missing.
pub(super) fn read_text(token: &str) -> ReadText {
    let mut read = ReadText {
        value: String::with_capacity(token.len()),
        unknown: Vec::new(),
    };
    let mut chars = token.char_indices().skip(1).peekable();
    while let Some((at, character)) = chars.next() {
        match character {
            '"' => break,
            '\\' => match chars.next() {
                Some((_, 'n')) => read.value.push('\n'),
                Some((_, 't')) => read.value.push('\t'),
                Some((_, same @ ('"' | '\\'))) => read.value.push(same),
                Some((end, other)) => {
                    let escape = format!("\\{other}");
                    read.value.push_str(&escape);
                    read.unknown.push((at..end + other.len_utf8(), escape));
                }
                None => read.value.push('\\'),
            },
            character => read.value.push(character),
        }
    }
    read
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_are_undone_and_unknown_ones_are_told() {
        let read = read_text(r#""a\n\"\\\q""#);
        assert_eq!(read.value, "a\n\"\\\\q");
        assert_eq!(read.unknown, [(8..10, r"\q".to_owned())]);
    }

    #[test]
    fn a_text_may_break_off_anywhere() {
        assert_eq!(read_text("\"").value, "");
        assert_eq!(read_text("\"ab\\").value, "ab\\");
        assert_eq!(read_text("").value, "");
    }
}
