//! Conversion between positions of the protocol and byte offsets.
//!
//! A line ends with `\n`, `\r\n` or `\r` alone. A column counts UTF-8 bytes, UTF-16 units or
//! characters, as agreed with the client. A position outside of the text is moved to the nearest
//! one before it that exists: to the end of its line, or the start of its character.

use gen_lsp_types::{Position, PositionEncodingKind, Range};

/// The unit that a column counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Bytes.
    Utf8,
    /// UTF-16 units, which every client supports.
    #[default]
    Utf16,
    /// Characters.
    Utf32,
}

impl Encoding {
    /// The encoding for a client that offers these, by the protocol's words: UTF-8 if possible.
    pub fn agreed(offered: &[&str]) -> Self {
        let known = [("utf-8", Self::Utf8), ("utf-16", Self::Utf16), ("utf-32", Self::Utf32)];
        let found = known.into_iter().find(|(word, _)| offered.contains(word));
        found.map_or(Self::Utf16, |(_, encoding)| encoding)
    }

    /// The protocol's word for it.
    pub fn kind(self) -> PositionEncodingKind {
        match self {
            Self::Utf8 => PositionEncodingKind::UTF8,
            Self::Utf16 => PositionEncodingKind::UTF16,
            Self::Utf32 => PositionEncodingKind::UTF32,
        }
    }

    /// The number of units of a character.
    fn units(self, character: char) -> usize {
        match self {
            Self::Utf8 => character.len_utf8(),
            Self::Utf16 => character.len_utf16(),
            Self::Utf32 => 1,
        }
    }
}

/// The starts of the lines of a text.
#[derive(Clone, Debug)]
pub struct Lines {
    starts: Vec<usize>,
    /// The end of each character that has more bytes than units, and how many more all have up to
    /// there: so a column is found without counting the characters before it.
    surplus: Vec<(usize, usize)>,
    encoding: Encoding,
}

impl Lines {
    pub fn new(text: &str, encoding: Encoding) -> Self {
        let bytes = text.as_bytes();
        let ends = bytes.iter().enumerate().filter(|&(at, &byte)| {
            byte == b'\n' || byte == b'\r' && bytes.get(at + 1) != Some(&b'\n')
        });
        let starts = std::iter::once(0).chain(ends.map(|(at, _)| at + 1));
        let mut sum = 0;
        let surplus = text.char_indices().filter_map(|(at, character)| {
            let more = character.len_utf8() - encoding.units(character);
            sum += more;
            (more > 0).then_some((at + character.len_utf8(), sum))
        });
        Self { starts: starts.collect(), surplus: surplus.collect(), encoding }
    }

    /// The byte at a position.
    pub fn offset(&self, text: &str, position: Position) -> usize {
        let Some(&start) = self.starts.get(position.line as usize) else { return text.len() };
        let next = self.starts.get(position.line as usize + 1);
        let line = &text[start..next.copied().unwrap_or(text.len())];
        let line = line.trim_end_matches(['\r', '\n']);
        let wanted = position.character as usize;
        if self.encoding == Encoding::Utf8 {
            return start + line.floor_char_boundary(wanted);
        }
        let mut units = 0;
        for (at, character) in line.char_indices() {
            units += self.encoding.units(character);
            if units > wanted {
                return start + at;
            }
        }
        start + line.len()
    }

    /// The position of a byte.
    pub fn position(&self, text: &str, offset: usize) -> Position {
        let offset = text.floor_char_boundary(offset);
        let line = self.starts.partition_point(|&start| start <= offset) - 1;
        let character = self.units_before(offset) - self.units_before(self.starts[line]);
        Position { line: narrow(line), character: narrow(character) }
    }

    /// The units of the text before a byte that begins a character.
    fn units_before(&self, offset: usize) -> usize {
        let longer = self.surplus.partition_point(|&(end, _)| end <= offset);
        offset - longer.checked_sub(1).map_or(0, |last| self.surplus[last].1)
    }

    /// The range between two bytes.
    pub fn range(&self, text: &str, range: std::ops::Range<usize>) -> Range {
        Range { start: self.position(text, range.start), end: self.position(text, range.end) }
    }
}

/// A count in the 32 bits of the protocol; larger ones saturate.
pub fn narrow(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
