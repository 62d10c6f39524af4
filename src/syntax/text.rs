//! Texts in quotes: their escapes and embedded values.

use std::ops::Range;

/// The value of a text token, and its unknown escapes.
pub struct ReadText {
    /// The text; an unknown escape is kept as it is.
    pub value: String,
    /// Unknown escapes and their places within the token.
    pub unknown: Vec<(Range<usize>, String)>,
}

/// Decodes the escapes of a text token; the closing quote may be missing.
pub fn read_text(token: &str) -> ReadText {
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

/// The embedded values of a text token, as ranges in it. If its brace is missing, the last one
/// extends to the closing quote.
pub struct Holes {
    /// The ranges of the values, without braces and formats.
    pub values: Vec<Range<usize>>,
    /// True if the closing brace of the last value is missing.
    pub is_open: bool,
    /// True if a brace within that value is open, too: its text goes on behind a quote.
    pub is_nested: bool,
}

/// Finds the values in a text token: `"mean {mean(len):.3}"` has one.
pub fn holes(token: &str) -> Holes {
    let mut holes = Holes { values: Vec::new(), is_open: false, is_nested: false };
    let mut begun: Option<Hole> = None;
    let mut chars = token.char_indices().peekable();
    while let Some((at, character)) = chars.next() {
        match (&mut begun, character) {
            (_, '\\') => {
                chars.next();
            }
            // Part of a qualified name.
            (Some(_), ':') if chars.peek().is_some_and(|(_, next)| *next == ':') => {
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
        holes.is_nested = hole.depth > 0;
        let end = token.len() - usize::from(token.ends_with('"'));
        holes.values.push(hole.start..end.max(hole.start));
    }
    holes
}

/// A value whose end has not been found yet.
struct Hole {
    start: usize,
    /// The number of open braces in it.
    depth: usize,
    /// The start of its format.
    format: Option<usize>,
}
