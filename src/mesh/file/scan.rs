//! Words and numbers of a text, byte by byte.
//!
//! A scanner has a position in a text and counts lines. Lines end in LF, CR LF or CR. Where a
//! format allows continued lines, a backslash at the end of one is a blank.

use std::borrow::Cow;

/// A position in a text.
pub(super) struct Scanner<'t> {
    text: &'t [u8],
    at: usize,
    line: u32,
    continues: bool,
    /// True if a comment may directly follow a word.
    comments_stick: bool,
}

impl<'t> Scanner<'t> {
    pub(super) fn new(text: &'t [u8]) -> Self {
        let text = without_mark(text);
        Self { text, at: 0, line: 1, continues: false, comments_stick: false }
    }

    /// A scanner of a part of a text that may have continued lines.
    pub(super) fn with_continued_lines(text: &'t [u8]) -> Self {
        Self { text, at: 0, line: 1, continues: true, comments_stick: false }
    }

    /// A scanner of a text in which every `#` begins a comment.
    pub(super) fn with_sticking_comments(text: &'t [u8]) -> Self {
        Self { comments_stick: true, ..Self::new(text) }
    }

    /// The line, from 1.
    pub(super) fn line(&self) -> u32 {
        self.line
    }

    /// The number of bytes that have been read.
    pub(super) fn position(&self) -> usize {
        self.at
    }

    /// The bytes that have not been read yet.
    pub(super) fn rest(&self) -> &'t [u8] {
        &self.text[self.at..]
    }

    /// Skips some bytes.
    pub(super) fn skip(&mut self, bytes: usize) {
        self.at = (self.at + bytes).min(self.text.len());
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at == self.text.len()
    }

    #[inline]
    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    /// The start of the next line, if a backslash at this position continues the line.
    #[cold]
    fn continuation(&self) -> Option<usize> {
        if !self.continues {
            return None;
        }
        let mut at = self.at + 1;
        loop {
            match self.text.get(at) {
                None => return Some(at),
                Some(b'\n') => return Some(at + 1),
                Some(b'\r') if self.text.get(at + 1) == Some(&b'\n') => return Some(at + 2),
                Some(b'\r') => return Some(at + 1),
                Some(byte) if byte.is_ascii_whitespace() => at += 1,
                Some(_) => return None,
            }
        }
    }

    /// Skips blanks and continued line ends; true if another word of the line follows.
    #[inline]
    pub(super) fn next_word(&mut self) -> bool {
        let begins = |byte: u8| byte > b'#' && byte != b'\\';
        match self.rest() {
            [b' ', next, ..] if begins(*next) => {
                self.at += 1;
                true
            }
            [next, ..] if begins(*next) => true,
            [b'\n', ..] => false,
            _ => self.skip_blanks(),
        }
    }

    fn skip_blanks(&mut self) -> bool {
        let start = self.at;
        loop {
            match self.peek() {
                None | Some(b'\n' | b'\r') => return false,
                Some(b' ' | b'\t' | b'\x0b' | b'\x0c') => self.at += 1,
                Some(b'\\') => match self.continuation() {
                    Some(next) => {
                        self.line +=
                            u32::from(next < self.text.len() || self.text[next - 1] != b'\\');
                        self.at = next;
                    }
                    None => return true,
                },
                // A comment begins a line or follows a blank, so that names may contain `#`.
                Some(b'#') if self.comments_stick => return false,
                Some(b'#') => {
                    return self.at == start
                        && self.at > 0
                        && !self.text[self.at - 1].is_ascii_whitespace();
                }
                Some(_) => return true,
            }
        }
    }

    /// The next word of the line.
    pub(super) fn word(&mut self) -> Option<&'t [u8]> {
        if !self.next_word() {
            return None;
        }
        let start = self.at;
        while let Some(byte) = self.peek() {
            if byte.is_ascii_whitespace()
                || byte == b'\x0b'
                || (byte == b'\\' && self.continuation().is_some())
                || (byte == b'#' && self.comments_stick)
            {
                break;
            }
            self.at += 1;
        }
        Some(&self.text[start..self.at])
    }

    /// The next word of the line as a number; `Err` if it is another word.
    #[inline]
    pub(super) fn number(&mut self) -> Option<Result<f64, &'t [u8]>> {
        if !self.next_word() {
            return None;
        }
        let start = self.at;
        if let Ok((number, length)) = fast_float2::parse_partial(&self.text[start..]) {
            self.at += length;
            match self.peek() {
                None | Some(b' ' | b'\n' | b'\r' | b'\t' | b'\x0b' | b'\x0c') => {
                    return Some(Ok(number));
                }
                Some(b'\\') if self.continuation().is_some() => return Some(Ok(number)),
                Some(b'#') if self.comments_stick => return Some(Ok(number)),
                Some(_) => self.at = start,
            }
        }
        self.word().map(Err)
    }

    /// The value of the digits at this position; `None` if there are none, or more than eighteen.
    #[inline]
    pub(super) fn digits(&mut self) -> Option<u64> {
        let start = self.at;
        let mut value = 0u64;
        while let Some(byte) = self.peek()
            && byte.is_ascii_digit()
            && self.at - start < 19
        {
            value = value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
            self.at += 1;
        }
        (1..=18).contains(&(self.at - start)).then_some(value)
    }

    /// The word at this position, if it is a number of one to nine digits.
    #[inline]
    pub(super) fn whole_number(&mut self) -> Option<u32> {
        let rest = self.rest();
        let (mut value, mut length) = (0_u32, 0);
        for digit in rest.iter().map(|byte| byte.wrapping_sub(b'0')).take_while(|digit| *digit < 10)
        {
            value = value.wrapping_mul(10).wrapping_add(digit.into());
            length += 1;
        }
        let ends = matches!(rest.get(length), None | Some(b' ' | b'\n' | b'\r' | b'\t'));
        ((1..=9).contains(&length) && ends).then(|| {
            self.at += length;
            value
        })
    }

    /// Skips a byte, if it is the next. Returns whether it was.
    #[inline]
    pub(super) fn take(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == Some(byte);
        self.at += usize::from(is_next);
        is_next
    }

    /// Skips to the start of the next line, past continued lines.
    #[inline]
    pub(super) fn end_line(&mut self) {
        if self.peek() == Some(b'\n') {
            self.at += 1;
            self.line += 1;
            return;
        }
        // The rest is a comment, or words that are not used.
        while self.next_word() {
            self.word();
        }
        while let Some(byte) = self.peek() {
            self.at += 1;
            if byte == b'\n' || byte == b'\r' {
                if byte == b'\r' {
                    self.take(b'\n');
                }
                self.line += 1;
                return;
            }
        }
    }

    /// Skips the words behind a row of a table that are more than it should have; true if there are
    /// some. Where rows do not have lines of their own, the words belong to the next row. They have
    /// if this one does, which began in the line `begin`, and as many lines follow as `rows`;
    /// `has_lines` keeps the answer.
    #[inline]
    pub(super) fn skip_surplus(
        &mut self,
        begin: u32,
        rows: usize,
        has_lines: &mut Option<bool>,
    ) -> bool {
        if !self.next_word() {
            return false;
        }
        let is_surplus = *has_lines.get_or_insert_with(|| {
            let lines = self.rest().split(|byte| matches!(byte, b'\n' | b'\r')).skip(1);
            let has_words = |line: &&[u8]| line.first().is_some_and(|first| *first != b'#');
            let lines = lines.map(<[u8]>::trim_ascii).filter(has_words);
            self.line == begin && lines.count() == rows
        });
        if is_surplus {
            self.end_line();
        }
        is_surplus
    }

    /// Skips to the next line that has a word; false at the end of the text.
    pub(super) fn next_line(&mut self) -> bool {
        while !self.next_word() {
            if self.is_at_end() {
                return false;
            }
            self.end_line();
        }
        true
    }

    /// All words of the line as written, without a comment.
    pub(super) fn text(&mut self) -> Cow<'t, [u8]> {
        if !self.next_word() {
            return Cow::Borrowed(b"");
        }
        let (start, line) = (self.at, self.line);
        let mut end = start;
        while self.next_word() {
            self.word();
            end = self.at;
        }
        if line == self.line {
            return Cow::Borrowed(&self.text[start..end]);
        }
        // A continued line: a blank replaces what was between its parts.
        let all = &self.text[start..end];
        let mut joined = Vec::new();
        let mut parts = Scanner::with_continued_lines(all);
        while let Some(word) = parts.word() {
            if !joined.is_empty() {
                joined.push(b' ');
            }
            joined.extend_from_slice(word);
        }
        Cow::Owned(joined)
    }
}

/// A text without its byte order mark.
pub(super) fn without_mark(text: &[u8]) -> &[u8] {
    text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)
}

/// The advice for a word that would be a number with a point in place of its comma.
pub(super) const POINT: &str = "; numbers are written with a point";

/// The message for a word that is in place of a number.
#[cold]
pub(super) fn no_number(word: &[u8]) -> String {
    let point = if word.contains(&b',') { POINT } else { "" };
    format!("`{}` is not a number{point}", shown(word))
}

/// The start of a word, for a message.
pub(super) fn shown(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(&word[..word.len().min(40)]);
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
