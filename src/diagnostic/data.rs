//! A diagnostic and its parts.

use std::ops::Range;

use crate::source::Span;

/// The severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The program is valid, but probably not what was intended.
    Warning,
    /// The program cannot be used.
    Error,
}

/// A place with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The text of the label; may be empty.
    pub text: String,
}

/// One replacement in a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Edit {
    /// The span that is replaced; empty to insert.
    pub span: Span,
    /// The replacement text.
    pub text: String,
}

/// A part of a text after edits, and their places in it, in the order of the text; `None` if they
/// overlap, or one lies outside of it.
pub fn applied<'e>(
    text: &str,
    part: Range<usize>,
    edits: impl IntoIterator<Item = &'e Edit>,
) -> Option<(String, Vec<Range<usize>>)> {
    let mut edits: Vec<&Edit> = edits.into_iter().collect();
    edits.sort_by_key(|edit| edit.span.start);
    let (mut out, mut places, mut at) = (String::new(), Vec::new(), part.start);
    for edit in edits {
        out.push_str(text.get(at..edit.span.start as usize)?);
        places.push(out.len()..out.len() + edit.text.len());
        out.push_str(&edit.text);
        at = edit.span.end as usize;
    }
    out.push_str(text.get(at..part.end)?);
    Some((out, places))
}

/// A change that is certain to resolve the diagnostic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// The change, in the imperative: "insert `edge e2: c | c'`".
    pub title: String,
    /// The replacements; they do not overlap.
    pub edits: Vec<Edit>,
}

/// A message to the author of the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Its severity.
    pub severity: Severity,
    /// A stable name in kebab case, which `hedgerow explain` documents.
    pub code: &'static str,
    /// One line in lower case that can be understood on its own.
    pub message: String,
    /// The places it is about; the first label is the primary one.
    pub labels: Vec<Label>,
    /// Remarks that explain it.
    pub notes: Vec<String>,
    /// Changes that are certain to resolve it.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    /// An error with its primary place.
    pub fn error(code: &'static str, message: impl Into<String>, span: Span) -> Self {
        Self::new(Severity::Error, code, message.into(), span)
    }

    /// A warning with its primary place.
    pub fn warning(code: &'static str, message: impl Into<String>, span: Span) -> Self {
        Self::new(Severity::Warning, code, message.into(), span)
    }

    fn new(severity: Severity, code: &'static str, message: String, span: Span) -> Self {
        let labels = vec![Label { span, text: String::new() }];
        Self { severity, code, message, labels, notes: Vec::new(), fixes: Vec::new() }
    }

    /// Sets the text at the primary place.
    pub fn saying(mut self, text: impl Into<String>) -> Self {
        self.labels[0].text = text.into();
        self
    }

    /// Adds a label at another place.
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Adds a note.
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// Offers a fix of one edit.
    pub fn fix(mut self, title: impl Into<String>, span: Span, text: impl Into<String>) -> Self {
        let edits = vec![Edit { span, text: text.into() }];
        self.fixes.push(Fix { title: title.into(), edits });
        self
    }

    /// The diagnostic with what `add` makes of `more`, if there is any.
    pub fn with<T>(self, more: Option<T>, add: impl FnOnce(Self, T) -> Self) -> Self {
        match more {
            Some(more) => add(self, more),
            None => self,
        }
    }

    /// The diagnostic with what `add` adds, if that is so.
    pub fn when(self, is_so: bool, add: impl FnOnce(Self) -> Self) -> Self {
        if is_so { add(self) } else { self }
    }

    /// The primary place.
    pub fn span(&self) -> Span {
        self.labels[0].span
    }

    /// True if the program cannot be used.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
