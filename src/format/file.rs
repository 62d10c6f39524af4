//! A whole file: items separated by blank lines; what cannot be parsed is unchanged.

use super::printer::{Lines, Printer, WIDTH};
use super::remark;
use super::torn::would_be_torn;
use super::words::Words;
use crate::syntax::Parsed;
use crate::syntax::tree::Item;
use std::ops::Range;

const MARK: &str = "\u{FEFF}";

/// The text formatted.
pub(super) fn formatted(source: &str, parsed: &Parsed) -> String {
    let mark = if source.starts_with(MARK) { MARK } else { "" };
    let mut page = Page {
        printer: Printer::new(source, &parsed.tokens, &parsed.comments),
        text: mark.to_owned(),
        lines: Lines::new(),
        done: mark.len(),
        after: None,
    };
    let stays = Stays::new(source, parsed);
    let items = &parsed.tree.items;
    let starts = items.iter().map(|item| item.span().start as usize);
    let starts: Vec<_> = starts.chain([source.len()]).collect();
    if stays.between(0, starts[0]) {
        page.verbatim(starts[0]);
    }
    for (item, part) in items.iter().zip(starts.windows(2)) {
        if stays.between(part[0], part[1]) || would_be_torn(source, item) {
            page.verbatim(part[1]);
        } else {
            page.item(item);
        }
    }
    with_line_ends_of(source, page.end())
}

/// Ends all lines as the first line of the source ends, even where nothing else changes: another
/// line may be the first the next time.
fn with_line_ends_of(source: &str, text: String) -> String {
    let first = source.find('\n').unwrap_or(0);
    let end = if source[..first].ends_with('\r') { "\r\n" } else { "\n" };
    if end == "\n" && !text.contains('\r') {
        return text;
    }
    let mut lines = text.split('\n');
    let last = lines.next_back().unwrap_or("");
    let ended = lines.map(|line| line.trim_end_matches('\r').to_owned() + end);
    ended.chain([last.to_owned()]).collect()
}

/// The places at which something is wrong.
struct Stays {
    /// The starts and ends of diagnostics.
    told: Vec<usize>,
    /// The characters that belong to no token or comment.
    left: Vec<usize>,
    /// The items in which foreign syntax was replaced.
    mended: Vec<Range<usize>>,
}

impl Stays {
    fn new(source: &str, parsed: &Parsed) -> Self {
        let spans = parsed.diagnostics.iter().map(|found| found.span());
        let mut told: Vec<_> =
            spans.flat_map(|span| [span.start as usize, span.end as usize]).collect();
        told.sort_unstable();
        let left = Words::of(source, parsed).leftovers().map(|(at, _)| at).collect();
        let mended = parsed.mended.iter().map(|span| span.range()).collect();
        Self { told, left, mended }
    }

    /// True if something is wrong between two places.
    fn between(&self, start: usize, end: usize) -> bool {
        let inside = |places: &[usize], end: usize| {
            let first = places.partition_point(|&place| place < start);
            places.get(first).is_some_and(|&place| place < end)
        };
        // What is missing at the end of an item may be reported where the next begins.
        let mut mended = self.mended.iter();
        inside(&self.told, end + 1)
            || inside(&self.left, end)
            || mended.any(|mended| mended.start < end && start < mended.end)
    }
}

struct Page<'t> {
    printer: Printer<'t>,
    /// The text that is finished.
    text: String,
    /// The lines that can still be aligned.
    lines: Lines,
    /// The position up to which the source is written.
    done: usize,
    /// The number of lines of the item that was written last, if it could be parsed.
    after: Option<usize>,
}

impl Page<'_> {
    fn item(&mut self, item: &Item) {
        let known = self.lines.len();
        self.printer.gap(&mut self.lines);
        if let [.., said, blank] = self.lines.as_slice()
            && blank.is_empty()
            && said.starts_with("///")
            && !said.starts_with("////")
        {
            self.lines.pop();
        }
        let own = self.printer.item(item, WIDTH);
        let stands_alone = |count: usize| count > 1 || own.len() > 1;
        if self.after.is_some_and(stands_alone)
            && self.lines.get(known).is_none_or(|line| !line.is_empty())
        {
            self.lines.insert(known, String::new());
        }
        self.after = Some(own.len());
        self.lines.extend(own);
        self.done = self.printer.taken_end();
    }

    /// Copies the source verbatim up to a place.
    fn verbatim(&mut self, to: usize) {
        self.finish();
        let taken = self.printer.verbatim(self.done, to);
        self.text.push_str(taken);
        self.done = to;
        self.after = None;
    }

    fn finish(&mut self) {
        remark::align(&mut self.lines);
        self.text.push_str(&self.lines.join("\n"));
        self.lines.clear();
    }

    fn end(mut self) -> String {
        let open = self.after.is_some() || self.done < self.printer.source.len();
        if open {
            self.printer.last_gap(&mut self.lines);
        }
        self.finish();
        let written = self.text.trim_start_matches(MARK);
        if open && !written.is_empty() {
            self.text.push('\n');
        }
        self.text
    }
}
