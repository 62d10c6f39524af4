//! From bytes to lines and columns, and back.

/// Where each line of a text begins.
#[derive(Clone, Debug)]
pub struct LineTable {
    starts: Vec<u32>,
}

impl LineTable {
    /// Reads the line ends (`\n`; a `\r` before it belongs to the line) of `text`.
    pub fn new(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n');
        let starts = std::iter::once(0)
            .chain(ends.map(|(at, _)| u32::try_from(at + 1).unwrap_or(u32::MAX)))
            .collect();
        Self { starts }
    }

    /// How many lines there are; at least one.
    pub fn line_count(&self) -> usize {
        self.starts.len()
    }

    /// The 0-based line that holds the byte at `offset`.
    pub fn line(&self, offset: usize) -> usize {
        self.starts.partition_point(|&start| start as usize <= offset) - 1
    }

    /// The first byte of a 0-based line, or `None` behind the last line.
    pub fn start(&self, line: usize) -> Option<usize> {
        self.starts.get(line).map(|&start| start as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_lies_in_the_line_that_starts_last_before_it() {
        let table = LineTable::new("ab\n\ncd");
        assert_eq!(table.line_count(), 3);
        let lines: Vec<_> = (0..=6).map(|offset| table.line(offset)).collect();
        assert_eq!(lines, [0, 0, 0, 1, 2, 2, 2]);
        assert_eq!(table.start(2), Some(4));
        assert_eq!(table.start(3), None);
    }
}
