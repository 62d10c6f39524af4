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
    let mut read = ReadText { value: String::with_capacity(token.len()), unknown: Vec::new() };
    let mut chars = token.char_indices().skip(1).peekable();
    while let Some((at, character)) = chars.next() {
        match character {
            '"' => break,
            '\\' => match chars.next() {
                Some((_, 'n')) => read.value.push('\n'),
                Some((_, 't')) => read.value.push('\t'),
                Some((_, same @ ('"' | '\\' | '{' | '}'))) => read.value.push(same),
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

/// The values in a text token, each a place between braces within it; the last one runs to the
/// closing quote if its brace is missing.
pub(super) struct Holes {
    /// What stands between the braces, and before a format.
    pub values: Vec<Range<usize>>,
    /// Whether the brace of the last is missing.
    pub is_open: bool,
}

/// Finds the values in a text token: `"mean {mean(len):.3}"` has one.
pub(super) fn holes(token: &str) -> Holes {
    let mut holes = Holes { values: Vec::new(), is_open: false };
    let mut begun: Option<Hole> = None;
    let mut chars = token.char_indices();
    while let Some((at, character)) = chars.next() {
        match (&mut begun, character) {
            (_, '\\') => {
                chars.next();
            }
            (None, '{') => {
                begun = Some(Hole { start: at + 1, depth: 0, format: None });
            }
            (Some(hole), '{') => hole.depth += 1,
            (Some(hole), '}') if hole.depth > 0 => hole.depth -= 1,
            (Some(hole), ':') if hole.depth == 0 => hole.format = hole.format.or(Some(at)),
            (Some(hole), '}') => {
                holes.values.push(hole.start..hole.format.unwrap_or(at));
                begun = None;
            }
            _ => {}
        }
    }
    if let Some(hole) = begun {
        holes.is_open = true;
        let end = token.len() - usize::from(token.ends_with('"'));
        holes.values.push(hole.start..end.max(hole.start));
    }
    holes
}

/// A value of which the end is not seen yet.
struct Hole {
    start: usize,
    /// How many braces are open in it.
    depth: usize,
    /// Where its format begins.
    format: Option<usize>,
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
    fn values_in_texts_are_found() {
        let found = |token: &str| {
            let holes = holes(token);
            let values = holes.values.into_iter().map(|hole| token[hole].to_owned());
            (values.collect::<Vec<_>>(), holes.is_open)
        };
        let none: [&str; 0] = [];
        assert_eq!(found(r#""a \{b\} }""#), (none.map(String::from).to_vec(), false));
        let two = ["x.y", "if c { 1 } else { 2 }"].map(String::from).to_vec();
        assert_eq!(found(r#""{x.y:.3}{if c { 1 } else { 2 }}""#), (two, false));
        assert_eq!(found(r#""a {b""#), (vec!["b".to_owned()], true));
        assert_eq!(found(r#""{""#), (vec![String::new()], true));
    }

    #[test]
    fn a_text_may_break_off_anywhere() {
        assert_eq!(read_text("\"").value, "");
        assert_eq!(read_text("\"ab\\").value, "ab\\");
        assert_eq!(read_text("").value, "");
    }
}
