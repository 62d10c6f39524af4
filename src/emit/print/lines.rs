//! Indented lines.

/// A text that grows line by line.
#[derive(Debug, Default)]
pub(in crate::emit) struct Lines {
    text: String,
    depth: usize,
    unit: usize,
    /// The depth at which these lines are added to others.
    outer: usize,
}

impl Lines {
    /// An empty text whose blocks are indented by `unit` spaces.
    pub fn new(unit: usize) -> Self {
        Self { unit, ..Self::default() }
    }

    /// Lines of a block in these, which are added later.
    pub fn inner(&self) -> Self {
        Self { unit: self.unit, outer: self.outer + self.depth + 1, ..Self::default() }
    }

    /// Adds lines of a block.
    pub fn add(&mut self, text: &str) {
        for line in text.lines() {
            match line {
                "" => self.blank(),
                line => self.line(line),
            }
        }
    }

    /// Adds a line.
    pub fn line(&mut self, text: &str) {
        if !text.is_empty() {
            self.text.push_str(&" ".repeat(self.depth * self.unit));
            self.text.push_str(text);
        }
        self.text.push('\n');
    }

    /// Adds a line that opens a block.
    pub fn open(&mut self, text: &str) {
        self.line(text);
        self.depth += 1;
    }

    /// Adds a line that closes a block.
    pub fn close(&mut self, text: &str) {
        self.depth = self.depth.saturating_sub(1);
        self.line(text);
    }

    /// Adds a line that closes a block and opens another one.
    pub fn reopen(&mut self, text: &str) {
        self.close(text);
        self.depth += 1;
    }

    /// Adds an empty line, unless a block has just begun or there is one already.
    pub fn blank(&mut self) {
        if !self.text.trim_end_matches('\n').ends_with('{') && !self.text.ends_with("\n\n") {
            self.text.push('\n');
        }
    }

    /// The text.
    pub fn finish(self) -> String {
        self.text
    }

    /// Adds a comment, wrapped where lines would become too long.
    pub fn comment(&mut self, text: &str) {
        let depth = self.outer + self.depth;
        let width = 96usize.saturating_sub(depth * self.unit + 3).max(20);
        for line in packed(plain(text).split_whitespace(), " ", width) {
            self.line(&comment("//", &line));
        }
    }
}

/// Words on lines of at most this width, if none of them is longer; there is at least one line.
pub(in crate::emit) fn packed<'w>(
    words: impl IntoIterator<Item = &'w str>,
    separator: &str,
    width: usize,
) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words {
        match lines.last_mut() {
            Some(line) if line.is_empty() => line.push_str(word),
            Some(line)
                if (line.chars().chain(separator.chars()).chain(word.chars())).count() <= width =>
            {
                line.extend([separator, word]);
            }
            _ => lines.push(word.to_string()),
        }
    }
    lines
}

/// A comment line. A backslash at its end would continue it on the next line in C++, so something
/// is put behind it.
pub(in crate::emit) fn comment(mark: &str, text: &str) -> String {
    let text = plain(text);
    let text = text.trim_end();
    match text.ends_with('\\') {
        true => format!("{mark} {text} ."),
        false => format!("{mark} {text}").trim_end().to_string(),
    }
}

/// A text on one line, without what compilers reject in comments: control characters, and those
/// that change the direction of writing.
fn plain(text: &str) -> String {
    let is_indexed = |c: char| {
        matches!(c, '\u{61c}' | '\u{200e}'..='\u{200f}' | '\u{202a}'..='\u{202e}')
            || matches!(c, '\u{2028}'..='\u{2029}' | '\u{2066}'..='\u{2069}')
    };
    text.chars().map(|c| if c.is_control() || is_indexed(c) { ' ' } else { c }).collect()
}
