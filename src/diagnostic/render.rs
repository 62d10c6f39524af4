//! Diagnostics on a terminal.
//!
//! A diagnostic may point anywhere: spans are clamped to their text and to whole characters, and
//! places in unknown files are left out.

use super::data as diagnostic;
use super::shown::{showable, shown};
use super::{Diagnostic, Fix, Severity};
use crate::source::{FileId, Source, Sources, Span};
use ariadne::{Cache, Color, Config, Fmt, IndexType, Label, Report, ReportKind};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// The maximum length of a line that is shown, in bytes; for longer ones only the place is given.
const WIDEST: usize = 400;

/// The maximum number of labels without text that are drawn.
const MOST_SILENT: usize = 4;

/// The style of printing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rendering {
    /// True to print in colour.
    pub colour: bool,
    /// The maximum number of diagnostics to print; the rest is counted.
    pub most: usize,
}

/// Prints diagnostics as text.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, how: Rendering) -> String {
    let mut page = Page {
        texts: Texts { sources, read: BTreeMap::new() },
        colour: how.colour,
        out: String::new(),
    };
    for diagnostic in diagnostics.iter().take(how.most) {
        page.diagnostic(diagnostic);
    }
    let mut out = page.out;
    let left = diagnostics.get(how.most..).unwrap_or_default();
    if !left.is_empty() {
        out.push_str(&rest(left));
    }
    out
}

/// The line that counts the diagnostics that are not printed.
fn rest(left: &[Diagnostic]) -> String {
    let errors = left.iter().filter(|left| left.is_error()).count();
    let warnings = left.len() - errors;
    let counted = |count: usize, word: &str| match count {
        0 => None,
        1 => Some(format!("1 more {word}")),
        count => Some(format!("{count} more {word}s")),
    };
    let parts = [counted(errors, "error"), counted(warnings, "warning")];
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    format!("… and {}\n", parts.join(" and "))
}

/// A span as `ariadne` expects it, in characters.
type SourceRange = (FileId, Range<usize>);

struct Page<'s> {
    texts: Texts<'s>,
    colour: bool,
    out: String,
}

impl Page<'_> {
    fn diagnostic(&mut self, diagnostic: &Diagnostic) {
        let (word, colour) = match diagnostic.severity {
            Severity::Error => ("error", Color::Red),
            Severity::Warning => ("warning", Color::Yellow),
        };
        let head = format!("{word}[{}]", diagnostic.code);
        let head = self.painted(&head, colour);
        self.line(&format!("{head}: {}", shown(&diagnostic.message)));
        match self.drawn(&diagnostic.labels, colour) {
            Some(drawn) => self.out.push_str(&drawn),
            None => self.listed(&diagnostic.labels),
        }
        for note in &diagnostic.notes {
            self.remark("note", note);
        }
        for fix in &diagnostic.fixes {
            let place = fix_place(fix, self.texts.sources);
            self.remark("help", &format!("{}{place}", fix.title));
        }
        self.line("");
    }

    /// Prints labels as text, without the source.
    fn listed(&mut self, labels: &[diagnostic::Label]) {
        for label in in_order(labels) {
            let place = place_in_words(label.span, self.texts.sources);
            let colon = if label.text.is_empty() { "" } else { ": " };
            if let Some(place) = place {
                self.line(&format!("  at {place}{colon}{}", shown(&label.text)));
            }
        }
    }

    /// The source with its labels; `None` if the primary label points into no source, or if a line
    /// is too long to show.
    fn drawn(&mut self, labels: &[diagnostic::Label], colour: Color) -> Option<String> {
        let (primary, _) = labels.split_first()?;
        let place = self.texts.place(primary.span)?;
        if labels.iter().any(|label| self.texts.is_wide(label.span)) {
            return None;
        }
        let config = Config::new()
            .with_color(self.colour)
            .with_index_type(IndexType::Char)
            .with_tab_width(4);
        let mut report = Report::build(ReportKind::Error, place).with_config(config);
        let mut silent = 0;
        for (at, label) in in_order(labels).into_iter().enumerate() {
            silent += usize::from(label.text.is_empty());
            if label.text.is_empty() && silent > MOST_SILENT && !std::ptr::eq(label, primary) {
                continue;
            }
            let Some(place) = self.texts.place(label.span) else { continue };
            let is_primary = std::ptr::eq(label, primary);
            let (colour, priority) = if is_primary { (colour, 1) } else { (Color::Blue, 0) };
            let text = if label.text.is_empty() { "here" } else { &*shown(&label.text) };
            let order = i32::try_from(at).unwrap_or(i32::MAX);
            let label = Label::new(place).with_message(text).with_color(colour);
            report = report.with_label(label.with_priority(priority).with_order(order));
        }
        let mut drawn = Vec::new();
        let written = report.finish().write(&mut self.texts, &mut drawn);
        written.ok()?;
        // Text without a label is light grey otherwise, which cannot be read on a light terminal.
        let drawn = String::from_utf8_lossy(&drawn).replace("\u{1b}[38;5;249m", "\u{1b}[39m");
        let (_, below_head) = drawn.split_once('\n')?;
        Some(below_head.lines().map(|line| format!("{}\n", line.trim_end())).collect())
    }

    fn remark(&mut self, word: &str, text: &str) {
        let word = self.painted(word, Color::Cyan);
        self.line(&format!("  {word}: {}", shown(text)));
    }

    fn painted(&self, text: &str, colour: Color) -> String {
        if self.colour { text.fg(colour).to_string() } else { text.to_owned() }
    }

    fn line(&mut self, line: &str) {
        self.out.push_str(line);
        self.out.push('\n');
    }
}

/// Labels in the order of their places, the file of the first label first, so that each file is
/// shown once.
fn in_order(labels: &[diagnostic::Label]) -> Vec<&diagnostic::Label> {
    let home = labels.first().map(|primary| primary.span.file);
    let mut sorted: Vec<_> = labels.iter().collect();
    sorted.sort_by_key(|label| {
        let Span { file, start, end } = label.span;
        (Some(file) != home, file, end, start)
    });
    sorted
}

/// ` (file:line:column)` of the first edit.
fn fix_place(fix: &Fix, sources: &Sources) -> String {
    let Some(edit) = fix.edits.first() else { return String::new() };
    let place = place_in_words(edit.span, sources);
    place.map_or_else(String::new, |place| format!(" ({place})"))
}

/// `file:line:column`
fn place_in_words(span: Span, sources: &Sources) -> Option<String> {
    let source = source_of(sources, span.file)?;
    let (line, column) = source.line_column(span.start as usize);
    Some(format!("{}:{line}:{column}", shown(source.name())))
}

fn source_of(sources: &Sources, file: FileId) -> Option<&Source> {
    sources.ids().any(|known| known == file).then(|| sources.get(file))
}

/// The sources in the form that `ariadne` reads, each converted once.
struct Texts<'s> {
    sources: &'s Sources,
    read: BTreeMap<FileId, ariadne::Source>,
}

impl Texts<'_> {
    /// A span clamped to its text and to whole characters.
    fn place(&self, span: Span) -> Option<SourceRange> {
        let text = source_of(self.sources, span.file)?.text();
        let start = text.floor_char_boundary(span.start as usize);
        let end = text.ceil_char_boundary(span.end as usize).max(start);
        let before = text[..start].chars().count();
        let within = text[start..end].chars().count();
        Some((span.file, before..before + within))
    }

    /// True if the first or the last line of a span is longer than [`WIDEST`].
    fn is_wide(&self, span: Span) -> bool {
        let Some(source) = source_of(self.sources, span.file) else { return false };
        let lines = source.lines();
        [span.start, span.end].into_iter().any(|offset| {
            let line = lines.line(offset as usize);
            let start = lines.start(line).unwrap_or(0);
            let end = lines.start(line + 1).unwrap_or(source.text().len());
            end - start > WIDEST
        })
    }
}

impl Cache<FileId> for &mut Texts<'_> {
    type Storage = String;

    fn fetch(&mut self, file: &FileId) -> Result<&ariadne::Source, impl fmt::Debug> {
        let source = source_of(self.sources, *file).ok_or("a place in an unknown file")?;
        let text = || source.text().chars().map(showable).collect::<String>();
        Ok::<_, &str>(self.read.entry(*file).or_insert_with(|| ariadne::Source::from(text())))
    }

    fn display<'a>(&self, file: &'a FileId) -> Option<impl fmt::Display + 'a> {
        source_of(self.sources, *file).map(|source| shown(source.name()).into_owned())
    }
}
