//! Numbers as text, with the fewest digits that read back as the same number.

use std::io::{self, Write};
use std::ops::Range;

use crate::mesh::parallel;

/// An output text, collected into large pieces.
pub(super) struct Printer<'o> {
    /// `None` if everything is collected.
    output: Option<&'o mut dyn Write>,
    text: Vec<u8>,
}

/// The size of a piece, in bytes.
const PIECE: usize = 1 << 16;

/// The number of lines that a thread prints at a time.
pub(super) const PART: usize = 1 << 13;

impl<'o> Printer<'o> {
    pub(super) fn new(output: &'o mut dyn Write) -> Self {
        Self { output: Some(output), text: Vec::with_capacity(PIECE + 1024) }
    }

    /// A printer that collects everything.
    pub(super) fn gathering() -> Self {
        Self { output: None, text: Vec::new() }
    }

    /// Prints the given number of lines, in parts of [`PART`] lines on all cores: `print` prints
    /// the lines of a range.
    pub(super) fn in_parts(
        &mut self,
        lines: usize,
        print: impl Fn(&mut Printer, Range<usize>) -> io::Result<()> + Sync,
    ) -> io::Result<()> {
        if parallel::threads() == 1 || lines <= PART {
            let mut parts = (0..lines).step_by(PART);
            return parts.try_for_each(|start| print(self, start..lines.min(start + PART)));
        }
        let parts = (0..lines).step_by(PART).map(|start| start..lines.min(start + PART));
        let printed = |part| {
            let mut printer = Printer::gathering();
            print(&mut printer, part).map(|()| printer.text)
        };
        parallel::in_order(parts, printed, |text| {
            self.text.extend_from_slice(&text?);
            self.flush_if_full()
        })
    }

    #[inline]
    pub(super) fn bytes(&mut self, bytes: &[u8]) {
        self.text.extend_from_slice(bytes);
    }

    #[inline]
    pub(super) fn word(&mut self, word: &str) {
        self.bytes(word.as_bytes());
    }

    #[inline]
    pub(super) fn int(&mut self, value: i64) {
        self.word(itoa::Buffer::new().format(value));
    }

    /// A real as Rust prints it, what is not a number without a sign: without an exponent, and without a point if it is whole.
    #[inline]
    pub(super) fn real(&mut self, value: f64) {
        let whole = value as i64;
        if whole as f64 == value && value.abs() < 1e15 {
            if value == 0.0 && value.is_sign_negative() {
                self.word("-");
            }
            return self.int(whole);
        }
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format(one_nan(value));
        // Where two shortest texts are equally far off, Rust picks the greater, but `zmij` may not;
        // such numbers have few binary places but many digits.
        let may_be_tie = text.len() >= 17 && (value * f64::from(1 << 24)).fract() == 0.0;
        if value.is_finite() && !may_be_tie && !text.contains('e') {
            self.word(text.strip_suffix(".0").unwrap_or(text));
        } else {
            self.word(&value.to_string());
        }
    }

    /// Each real with a blank before it.
    #[inline]
    pub(super) fn reals(&mut self, values: &[f64]) {
        for &value in values {
            self.bytes(b" ");
            self.real(value);
        }
    }

    /// Ends a line, and writes the collected text if it is large.
    #[inline]
    pub(super) fn end_line(&mut self) -> io::Result<()> {
        self.bytes(b"\n");
        self.flush_if_full()
    }

    /// Writes the collected text if it is large.
    #[inline]
    pub(super) fn flush_if_full(&mut self) -> io::Result<()> {
        if self.text.len() < PIECE { Ok(()) } else { self.flush() }
    }

    pub(super) fn flush(&mut self) -> io::Result<()> {
        if let Some(output) = &mut self.output {
            output.write_all(&self.text)?;
            self.text.clear();
        }
        Ok(())
    }
}

/// The same number; all that are not numbers become one, whose sign and payload are arbitrary.
#[inline]
pub(super) fn one_nan(value: f64) -> f64 {
    if value.is_nan() { f64::NAN } else { value }
}
