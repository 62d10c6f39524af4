//! Reading the body of a file: a table of numbers for each property.

use super::header::{Element, Header, Property, Scalar};
use crate::mesh::file::contents::Contents;
use crate::mesh::file::error::{Failure, FileReason};
use crate::mesh::file::format::Encoding;
use crate::mesh::file::kept::{Kept, MISSING};
use crate::mesh::file::scan::{Scanner, no_number, shown};

/// The note on rows of a text that have more than their properties.
const SURPLUS: [&str; 2] =
    ["line with more than the header declares", "lines with more than the header declares"];

/// The numbers of a property, row by row.
#[derive(Default)]
pub(super) struct Table {
    pub(super) numbers: Vec<f64>,
    /// The ends of the lists of each row; empty for single numbers.
    pub(super) ends: Vec<usize>,
}

impl Table {
    pub(super) fn is_empty(&self) -> bool {
        self.numbers.is_empty() && self.ends.is_empty()
    }

    /// Keeps the first rows.
    fn truncate(&mut self, rows: usize, is_list: bool) {
        if is_list {
            self.ends.truncate(rows);
        }
        self.numbers.truncate(if is_list { self.ends.last().copied().unwrap_or(0) } else { rows });
    }

    /// Adds a row without a value, so that those behind it keep their numbers.
    fn push_none(&mut self, is_list: bool) {
        if is_list {
            self.ends.push(self.numbers.len());
        } else {
            self.numbers.push(f64::NAN);
        }
    }

    /// The length of the lists, if it is the same for all.
    pub(super) fn common_length(&self) -> Option<usize> {
        let first = *self.ends.first()?;
        let mut before = 0;
        let alike = self.ends.iter().all(|&end| end - std::mem::replace(&mut before, end) == first);
        alike.then_some(first)
    }
}

/// The body, which follows the head.
pub(super) struct Body<'t> {
    encoding: Encoding,
    bytes: &'t [u8],
    scanner: Scanner<'t>,
    lines: u32,
    /// The number of rows that have not been read.
    rows: usize,
    /// True if each row of a text has a line of its own; `None` as long as it does not matter.
    has_lines: Option<bool>,
    /// True if the file ended before all its elements were read.
    pub(super) is_cut_off: bool,
}

impl<'t> Body<'t> {
    pub(super) fn new(header: &Header, text: &'t [u8]) -> Self {
        let is_text = header.encoding == Encoding::Ascii;
        let rows = header.elements.iter().filter(|element| !element.properties.is_empty());
        Self {
            encoding: header.encoding,
            bytes: text,
            scanner: Scanner::new(if is_text { text } else { b"" }),
            lines: header.lines,
            rows: rows.fold(0, |rows, element| element.count.saturating_add(rows)),
            has_lines: None,
            is_cut_off: false,
        }
    }

    /// The line in the file, if it is a text.
    fn line(&self) -> Option<u32> {
        (self.encoding == Encoding::Ascii).then(|| self.lines + self.scanner.line())
    }

    fn left(&self) -> usize {
        if self.encoding == Encoding::Ascii { self.scanner.rest().len() } else { self.bytes.len() }
    }

    /// The maximum number of elements that fit into what is left.
    fn room(&self, element: &Element) -> usize {
        // The last number of a text needs no blank after it.
        (self.left() + 1) / element.least_size(self.encoding).max(1)
    }

    /// Fails if the head declares more elements than can be numbered.
    pub(super) fn expect_numbers(&self, element: &Element) -> Result<(), Failure> {
        if element.count < MISSING as usize {
            return Ok(());
        }
        let words = format!(
            "the header declares {} elements `{}`, but only {} bytes follow",
            element.count,
            shown(element.name.as_bytes()),
            self.left()
        );
        Err((None, FileReason::Malformed(words)))
    }

    /// The tables of an element, with the complete rows only.
    pub(super) fn read(
        &mut self,
        element: &Element,
        contents: &mut Contents,
    ) -> Result<Vec<Table>, Failure> {
        let mut tables = self.tables(element);
        if element.properties.is_empty() {
            return Ok(tables);
        }
        let is_text = self.encoding == Encoding::Ascii;
        for row in 0..element.count {
            self.rows = self.rows.saturating_sub(1);
            self.scanner.next_line();
            let begin = self.scanner.line();
            let is_whole = match self.row(element, &mut tables) {
                Err((line, FileReason::Malformed(words))) if is_text => {
                    contents.damage.add(line, || words);
                    self.scanner.end_line();
                    for (property, table) in element.properties.iter().zip(&mut tables) {
                        table.truncate(row, property.list.is_some());
                        table.push_none(property.list.is_some());
                    }
                    continue;
                }
                read => read?,
            };
            if !is_whole {
                contents.damage.add(self.line(), || {
                    let name = shown(element.name.as_bytes());
                    format!("the file ends within {name} {} of {}", row + 1, element.count)
                });
                for (property, table) in element.properties.iter().zip(&mut tables) {
                    table.truncate(row, property.list.is_some());
                }
                self.is_cut_off = true;
                break;
            }
            if is_text && self.scanner.skip_surplus(begin, self.rows, &mut self.has_lines) {
                contents.kept.note(SURPLUS, self.lines + begin);
            }
        }
        Ok(tables)
    }

    /// Notes what follows the last element.
    pub(super) fn note_rest(&mut self, kept: &mut Kept) {
        let last = "element that the header declares";
        match self.encoding {
            Encoding::Ascii => kept.note_lines_behind(&mut self.scanner, last, self.lines),
            _ => kept.note_bytes_behind(self.bytes, last),
        }
    }

    fn tables(&self, element: &Element) -> Vec<Table> {
        let room = element.count.min(self.room(element));
        let table = |property: &Property| Table {
            // A list has several numbers for each row. The capacity is bounded by the size of the
            // file.
            numbers: Vec::with_capacity(room * if property.list.is_some() { 3 } else { 1 }),
            ends: Vec::with_capacity(if property.list.is_some() { room } else { 0 }),
        };
        element.properties.iter().map(table).collect()
    }

    /// Reads a row into the tables; false if the file ends within it.
    fn row(&mut self, element: &Element, tables: &mut [Table]) -> Result<bool, Failure> {
        for (property, table) in element.properties.iter().zip(tables) {
            let length = match property.list {
                None => 1,
                Some(scalar) => match self.number(scalar)? {
                    Some(length) if length >= 0.0 && length.fract() == 0.0 => length as usize,
                    Some(length) => {
                        let words = format!("{length} is not a length of a list");
                        return Err((self.line(), FileReason::Malformed(words)));
                    }
                    None => return Ok(false),
                },
            };
            if self.encoding != Encoding::Ascii {
                let Some(size) = length.checked_mul(property.scalar.size()) else {
                    return Ok(false);
                };
                let Some((numbers, rest)) = self.bytes.split_at_checked(size) else {
                    return Ok(false);
                };
                self.bytes = rest;
                let is_big = self.encoding == Encoding::BigEndian;
                decode(property.scalar, numbers, is_big, &mut table.numbers);
            } else {
                for _ in 0..length {
                    match self.number(property.scalar)? {
                        Some(number) => table.numbers.push(number),
                        None => return Ok(false),
                    }
                }
            }
            if property.list.is_some() {
                table.ends.push(table.numbers.len());
            }
        }
        Ok(true)
    }

    /// The next number; `None` at the end of the file.
    #[inline]
    fn number(&mut self, scalar: Scalar) -> Result<Option<f64>, Failure> {
        if self.encoding != Encoding::Ascii {
            let Some((number, rest)) = self.bytes.split_at_checked(scalar.size()) else {
                return Ok(None);
            };
            self.bytes = rest;
            if let (Scalar::U8, &[byte]) = (scalar, number) {
                return Ok(Some(f64::from(byte)));
            }
            let mut numbers = Vec::new();
            decode(scalar, number, self.encoding == Encoding::BigEndian, &mut numbers);
            return Ok(numbers.first().copied());
        }
        if !self.scanner.next_line() {
            return Ok(None);
        }
        match self.scanner.number() {
            Some(Ok(number)) => Ok(Some(number)),
            Some(Err(word)) => Err((self.line(), FileReason::Malformed(no_number(word)))),
            None => Ok(None),
        }
    }
}

/// Appends the numbers encoded by the bytes.
#[inline]
fn decode(scalar: Scalar, bytes: &[u8], is_big: bool, numbers: &mut Vec<f64>) {
    macro_rules! decode {
        ($type:ty) => {{
            let (chunks, _) = bytes.as_chunks::<{ size_of::<$type>() }>();
            numbers.extend(chunks.iter().map(|&chunk| match is_big {
                true => <$type>::from_be_bytes(chunk) as f64,
                false => <$type>::from_le_bytes(chunk) as f64,
            }));
        }};
    }
    match scalar {
        Scalar::I8 => decode!(i8),
        Scalar::U8 => decode!(u8),
        Scalar::I16 => decode!(i16),
        Scalar::U16 => decode!(u16),
        Scalar::I32 => decode!(i32),
        Scalar::U32 => decode!(u32),
        Scalar::F32 => decode!(f32),
        Scalar::F64 => decode!(f64),
    }
}
