//! A document that a client has open.

use std::cell::OnceCell;
use std::ops::Range;
use std::rc::Rc;
use std::time::{Duration, Instant};

use gen_lsp_types::{Location, Position, TextDocumentContentChangeEvent, TextDocumentItem, Uri};

use super::files::{Files, name};
use super::position::{Encoding, Lines};
use crate::analysis::Snapshot;
use crate::source::Span;

/// A document: its text, and the analysis of that.
#[derive(Debug)]
pub(super) struct Document {
    uri: Uri,
    version: i32,
    text: String,
    lines: Lines,
    encoding: Encoding,
    files: Files,
    snapshot: OnceCell<Rc<Snapshot>>,
    /// The snapshot of an earlier text, whose results the next one reuses.
    earlier: Option<Rc<Snapshot>>,
    /// True if diagnostics have been published for this version.
    pub(super) is_published: bool,
    /// The time of opening, until the diagnostics so far have been published early once.
    waiting_since: Option<Instant>,
}

/// The time after which the diagnostics so far of a new document are published.
const PATIENCE: Duration = Duration::from_millis(500);

impl Document {
    pub(super) fn new(item: TextDocumentItem, encoding: Encoding, files: Files) -> Self {
        let TextDocumentItem { uri, version, text, .. } = item;
        Self {
            files,
            lines: Lines::new(&text, encoding),
            uri,
            version,
            text,
            encoding,
            snapshot: OnceCell::new(),
            earlier: None,
            is_published: false,
            // A browser has no such clock; there diagnostics are published only when all is proved.
            waiting_since: (!cfg!(target_family = "wasm")).then(Instant::now),
        }
    }

    /// True if the diagnostics so far are due to be published, as proving takes a while: only once.
    pub(super) fn is_kept_waiting(&mut self) -> bool {
        let is_due = self.waiting_since.is_some_and(|since| since.elapsed() > PATIENCE);
        if is_due {
            self.waits_no_longer();
        }
        is_due
    }

    /// From now on diagnostics are published only when all is proved.
    pub(super) fn waits_no_longer(&mut self) {
        self.waiting_since = None;
    }

    pub(super) fn uri(&self) -> &Uri {
        &self.uri
    }

    /// The name by which other programs use it.
    pub(super) fn name(&self) -> String {
        name(&self.uri)
    }

    pub(super) fn version(&self) -> i32 {
        self.version
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// A text with the line ends of the document.
    pub(super) fn with_own_line_ends(&self, text: &str) -> String {
        match self.text.contains("\r\n") {
            true => text.replace("\r\n", "\n").replace('\n', "\r\n"),
            false => text.to_owned(),
        }
    }

    /// Applies changes in order: each refers to the text that the previous ones have made.
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
        self.files.hold(&self.uri, &self.text);
        self.forget();
    }

    /// Discards the snapshot if the text uses a file of this name; returns whether it does.
    pub(super) fn file_changed(&mut self, name: &str) -> bool {
        let is_used = self.uses(name);
        if is_used {
            self.forget();
        }
        is_used
    }

    /// Discards the snapshot, as the text or what it depends on may have changed.
    fn forget(&mut self) {
        if let Some(snapshot) = self.snapshot.take() {
            self.earlier = Some(snapshot);
        }
        self.is_published = false;
    }

    /// The analysis of the text.
    pub(super) fn snapshot(&self) -> &Rc<Snapshot> {
        self.snapshot.get_or_init(|| {
            let mut files = self.files.clone();
            Rc::new(match &self.earlier {
                Some(earlier) => earlier.next(&self.text, &mut files),
                None => Snapshot::new(&name(&self.uri), &self.text, &mut files),
            })
        })
    }

    /// True if the text, as it was read last, uses a file of this name.
    fn uses(&self, file: &str) -> bool {
        let read = self.snapshot.get().or(self.earlier.as_ref());
        read.is_some_and(|snapshot| snapshot.looks_for(file))
    }

    /// The location of a span, perhaps in another file.
    pub(super) fn location(&self, span: Span) -> Option<Location> {
        let snapshot = self.snapshot();
        if span.file == snapshot.file() {
            return Some(Location { uri: self.uri.clone(), range: self.range(span) });
        }
        let source = snapshot.sources().get(span.file);
        let uri = self.files.uri(source.name(), source.text())?;
        let lines = Lines::new(source.text(), self.encoding);
        Some(Location { uri, range: lines.range(source.text(), span.range()) })
    }

    /// The beginning of a file that the text uses.
    pub(super) fn used_file(&self, path: &str) -> Option<Location> {
        let file = self.snapshot().used_file(path)?;
        self.location(Span::new(file, 0, 0))
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

    pub(super) fn range_of(&self, bytes: Range<usize>) -> gen_lsp_types::Range {
        self.lines.range(&self.text, bytes)
    }

    pub(super) fn bytes(&self, range: gen_lsp_types::Range) -> Range<usize> {
        let start = self.offset(range.start);
        start..self.offset(range.end).max(start)
    }
}
