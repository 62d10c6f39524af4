//! A document that a client has open.

use std::cell::OnceCell;
use std::ops::Range;
use std::rc::Rc;

use gen_lsp_types::{Position, TextDocumentContentChangeEvent, Uri};

use super::position::{Encoding, Lines};
use super::uri;
use crate::analysis::Snapshot;
use crate::source::Span;

/// A document: its text, and what is understood of it.
#[derive(Debug)]
pub(super) struct Document {
    uri: Uri,
    version: i32,
    text: String,
    lines: Lines,
    encoding: Encoding,
    snapshot: OnceCell<Rc<Snapshot>>,
    /// The snapshot of an earlier text, from which the next one learns.
    earlier: Option<Rc<Snapshot>>,
    /// Whether diagnostics have been published for this version.
    pub(super) is_published: bool,
}

impl Document {
    pub(super) fn new(uri: Uri, version: i32, text: String, encoding: Encoding) -> Self {
        Self {
            lines: Lines::new(&text, encoding),
            uri,
            version,
            text,
            encoding,
            snapshot: OnceCell::new(),
            earlier: None,
            is_published: false,
        }
    }

    pub(super) fn uri(&self) -> &Uri {
        &self.uri
    }

    pub(super) fn version(&self) -> i32 {
        self.version
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// Takes in changes, in order: each is about the text that the ones before have made.
    pub(super) fn change(&mut self, version: i32, changes: Vec<TextDocumentContentChangeEvent>) {
        for change in changes {
            match change {
                TextDocumentContentChangeEvent::TextDocumentContentChangePartial(part) => {
                    let start = self.lines.offset(&self.text, part.range.start);
                    let end = self.lines.offset(&self.text, part.range.end).max(start);
                    self.text.replace_range(start..end, &part.text);
                }
                TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(whole) => {
                    self.text = whole.text;
                }
            }
            self.lines = Lines::new(&self.text, self.encoding);
        }
        self.version = version;
        self.forget();
    }

    /// Has the text read again, as what it depends on may have changed.
    pub(super) fn forget(&mut self) {
        if let Some(snapshot) = self.snapshot.take() {
            self.earlier = Some(snapshot);
        }
        self.is_published = false;
    }

    /// What is understood of the text.
    pub(super) fn snapshot(&self) -> &Rc<Snapshot> {
        self.snapshot.get_or_init(|| {
            Rc::new(match &self.earlier {
                Some(earlier) => earlier.next(&self.text),
                None => Snapshot::new(&self.name(), &self.text),
            })
        })
    }

    /// What the document is called in messages.
    fn name(&self) -> String {
        match uri::path(&self.uri) {
            Some(path) => path.display().to_string(),
            None => self.uri.0.clone(),
        }
    }

    pub(super) fn offset(&self, position: Position) -> usize {
        self.lines.offset(&self.text, position)
    }

    pub(super) fn position(&self, offset: usize) -> Position {
        self.lines.position(&self.text, offset)
    }

    pub(super) fn range(&self, span: Span) -> gen_lsp_types::Range {
        self.lines.range(&self.text, span.range())
    }

    pub(super) fn bytes(&self, range: gen_lsp_types::Range) -> Range<usize> {
        let start = self.offset(range.start);
        start..self.offset(range.end).max(start)
    }
}
