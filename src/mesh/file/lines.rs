//! The statements of a file: lines without comments, continued ones joined.

use std::io::{self, BufRead};

/// Reads one statement at a time into one buffer.
pub(super) struct Statements<R> {
    input: R,
    text: Vec<u8>,
    first_line: u32,
    last_line: u32,
    after_return: bool,
}

impl<R: BufRead> Statements<R> {
    pub(super) fn new(input: R) -> Self {
        Self { input, text: Vec::new(), first_line: 0, last_line: 0, after_return: false }
    }

    /// Goes to the next statement, which may be blank; false at the end of the file.
    pub(super) fn advance(&mut self) -> io::Result<bool> {
        self.text.clear();
        self.first_line = self.last_line.saturating_add(1);
        loop {
            let start = self.text.len();
            if !self.read_line()? {
                return Ok(start > 0);
            }
            if self.last_line == 0 && self.text.starts_with(b"\xef\xbb\xbf") {
                self.text.drain(..3);
            }
            self.last_line = self.last_line.saturating_add(1);
            if let Some(comment) = comment_start(&self.text[start..]) {
                self.text.truncate(start + comment);
                return Ok(true);
            }
            let length = self.text.trim_ascii_end().len();
            self.text.truncate(length.max(start));
            if self.text.len() == start || self.text.last() != Some(&b'\\') {
                return Ok(true);
            }
            self.text.pop();
            self.text.push(b' ');
        }
    }

    /// Appends a line without its end, which is any of LF, CR LF and CR; false if there
    /// is none.
    fn read_line(&mut self) -> io::Result<bool> {
        let mut found = false;
        loop {
            let bytes = match self.input.fill_buf() {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                bytes => bytes?,
            };
            if bytes.is_empty() {
                return Ok(found);
            }
            // Half a line end may be left from the line before.
            if std::mem::take(&mut self.after_return) && bytes[0] == b'\n' {
                self.input.consume(1);
                continue;
            }
            found = true;
            let end = bytes.iter().position(|&b| b == b'\n' || b == b'\r');
            self.text.extend_from_slice(&bytes[..end.unwrap_or(bytes.len())]);
            let Some(end) = end else {
                let all = bytes.len();
                self.input.consume(all);
                continue;
            };
            self.after_return = bytes[end] == b'\r';
            self.input.consume(end + 1);
            return Ok(true);
        }
    }

    pub(super) fn text(&self) -> &[u8] {
        &self.text
    }

    /// The line where the statement begins.
    pub(super) fn line(&self) -> u32 {
        self.first_line
    }
}

/// Where a comment begins: at a `#` that stands first or after a blank, so that names
/// may have one inside.
fn comment_start(line: &[u8]) -> Option<usize> {
    let mut from = 0;
    while let Some(found) = line[from..].iter().position(|&b| b == b'#') {
        let at = from + found;
        if at == 0 || line[at - 1].is_ascii_whitespace() {
            return Some(at);
        }
        from = at + 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statements(text: &[u8]) -> Vec<(u32, String)> {
        let mut statements = Statements::new(text);
        let mut all = Vec::new();
        while statements.advance().unwrap() {
            let text = String::from_utf8_lossy(statements.text());
            all.push((statements.line(), text.split_whitespace().collect::<Vec<_>>().join(" ")));
        }
        all
    }

    #[test]
    fn continued_lines_are_one_statement() {
        let found = statements(b"f 1 \\\r\n 2 \\\n3\nv 1\\");
        assert_eq!(found, [(1, "f 1 2 3".to_owned()), (4, "v 1".to_owned())]);
    }

    #[test]
    fn lines_end_in_three_ways() {
        let lines: Vec<u32> = statements(b"a\r\n\nb\rc\\\r\nd\r").iter().map(|s| s.0).collect();
        assert_eq!(lines, [1, 2, 3, 4]);
        // Across the ends of a small buffer too.
        let input = io::BufReader::with_capacity(2, &b"a\r\nb\r\n"[..]);
        let mut statements = Statements::new(input);
        while statements.advance().unwrap() {}
        assert_eq!(statements.last_line, 2);
    }

    #[test]
    fn comments_end_a_line_and_are_not_continued() {
        let found = statements(b"\xef\xbb\xbf# c:\\dir\\\ng a#b # x \\\n\xff# y\nv");
        let texts: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(texts, ["", "g a#b", "\u{fffd}#y".replace("#y", "# y").as_str(), "v"]);
    }
}
