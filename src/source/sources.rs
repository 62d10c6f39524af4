//! The texts that a run reads.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::{FileId, LineTable, Span};

/// One text, its name and its lines.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
    lines: LineTable,
}

impl Source {
    /// The name of the file in messages, usually its path as the user wrote it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its line table.
    pub fn lines(&self) -> &LineTable {
        &self.lines
    }

    /// The 1-based line and the 1-based column, counted in characters, of a byte.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let offset = self.text.floor_char_boundary(offset);
        let line = self.lines.line(offset);
        let start = self.lines.start(line).unwrap_or(0);
        (line + 1, self.text[start..offset].chars().count() + 1)
    }
}

/// All texts, in the order in which they were added.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    files: Vec<Source>,
    /// The files by all of their names.
    named: HashMap<String, FileId>,
}

impl Sources {
    /// No texts.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a text with its name.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> FileId {
        let text = text.into();
        let lines = LineTable::new(&text);
        let name = name.into();
        let file = FileId(self.files.len() as u32);
        self.name(file, name.clone());
        self.files.push(Source { name, text, lines });
        file
    }

    /// Lets a text be found by another name, too, if no other has it.
    pub fn name(&mut self, file: FileId, name: impl Into<String>) {
        self.named.entry(name.into()).or_insert(file);
    }

    /// The text with the given id, which comes from [`Sources::add`] of this collection. For any
    /// other, as that of an error without a place, it is an empty text without a name.
    pub fn get(&self, file: FileId) -> &Source {
        static NONE: LazyLock<Source> = LazyLock::new(|| Source {
            name: String::new(),
            text: String::new(),
            lines: LineTable::new(""),
        });
        self.files.get(file.0 as usize).unwrap_or(&NONE)
    }

    /// The first text with the given name.
    pub fn find(&self, name: &str) -> Option<FileId> {
        self.named.get(name).copied()
    }

    /// The ids of all texts.
    pub fn ids(&self) -> impl Iterator<Item = FileId> + use<> {
        (0..self.files.len() as u32).map(FileId)
    }

    /// The text a span covers.
    pub fn slice(&self, span: Span) -> &str {
        self.get(span.file).text().get(span.range()).unwrap_or("")
    }
}
