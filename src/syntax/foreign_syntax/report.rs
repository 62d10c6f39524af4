//! Reports of findings: the same form once, with all its places in one fix, and all findings on one
//! line in one error.

use super::finding::Found;
use crate::diagnostic::{Diagnostic, Edit, Fix, applied};
use crate::source::Span;
use std::ops::Range;

/// The maximum length of a line in a title.
const LONGEST: usize = 72;

/// Reports the findings in a text, in the order of the text.
pub(in crate::syntax) fn tell(text: &str, mut found: Vec<Found>) -> Vec<Diagnostic> {
    found.sort_by_key(|found| found.span.start);
    let mut groups: Vec<Group> = Vec::new();
    for one in found {
        match groups.iter_mut().find(|group| group.is_same(&one)) {
            Some(group) => group.again(one),
            None => groups.push(Group::new(one)),
        }
    }
    let mut lines: Vec<Group> = Vec::new();
    for group in groups {
        let line = line_of(text, group.span.start);
        match lines.last_mut().filter(|last| line.contains(&(last.span.start as usize))) {
            Some(last) => last.join(group),
            None => lines.push(group),
        }
    }
    lines.into_iter().map(|group| group.told(text)).collect()
}

/// The findings of one error.
struct Group {
    what: usize,
    span: Span,
    says: Vec<String>,
    edits: Option<Vec<Edit>>,
    more: usize,
    code: &'static str,
}

impl Group {
    fn new(found: Found) -> Self {
        let Found { what, span, says, edits, code, .. } = found;
        Self { what, span, says: vec![says], edits, more: 0, code }
    }

    /// True if a finding belongs to this error: the same form or the same message, and a fix as
    /// certain.
    fn is_same(&self, found: &Found) -> bool {
        let is_alike = self.what == found.what || self.says.contains(&found.says);
        is_alike && self.edits.is_some() == found.edits.is_some()
    }

    /// Adds the same form in another place.
    fn again(&mut self, found: Found) {
        self.more += 1;
        self.add(found.edits);
    }

    /// Adds another finding on the same line.
    fn join(&mut self, other: Self) {
        self.says.extend(other.says);
        self.more = self.more.max(other.more);
        self.add(other.edits);
    }

    /// Adds edits that do not overlap the others; if one finding has no fix, the error has none.
    fn add(&mut self, more: Option<Vec<Edit>>) {
        let (Some(edits), Some(more)) = (&mut self.edits, more) else {
            self.edits = None;
            return;
        };
        for edit in more {
            let apart = |other: &Edit| {
                edit.span.end < other.span.start
                    || other.span.end < edit.span.start
                    || (edit.span.end == other.span.start || other.span.end == edit.span.start)
                        && edit.span.start != edit.span.end
                        && other.span.start != other.span.end
            };
            if edits.iter().all(apart) {
                edits.push(edit);
            }
        }
    }

    fn told(self, text: &str) -> Diagnostic {
        let Self { span, says, edits, more, code, .. } = self;
        let (first, others) =
            says.split_first().map_or(("", &[][..]), |(first, others)| (first.as_str(), others));
        let told = Diagnostic::error(code, first, span);
        let told = others.iter().fold(told, |told, also| told.note(also.clone()));
        let places = if more == 1 { "place" } else { "places" };
        let again = format!("and so in {more} more {places}");
        let mut told = match more {
            0 => told,
            _ if edits.is_none() => told.note(again.clone()),
            _ => told,
        };
        if let Some(edits) = edits {
            let edits = merged(text, edits).into_iter().map(|edit| whole_line(text, edit));
            let edits = merged(text, edits.collect());
            let title = title(text, span, &edits);
            let title = if more > 0 { format!("{title}, {again}") } else { title };
            told.fixes.push(Fix { title, edits });
        }
        told
    }
}

/// Merges edits that overlap, and deletions with only blanks between them.
fn merged(text: &str, mut edits: Vec<Edit>) -> Vec<Edit> {
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits.dedup_by(|next, last| {
        let between = text.get(last.span.end as usize..next.span.start as usize);
        let is_one = between.is_none_or(|between| {
            let is_blank = between.trim_matches([' ', '\t']).is_empty();
            is_blank && last.text.is_empty() && next.text.is_empty()
        });
        if is_one {
            last.span.end = last.span.end.max(next.span.end);
            last.text.push_str(&next.text);
        }
        is_one
    });
    edits
}

/// The title of a fix: the line after the edits.
fn title(text: &str, span: Span, edits: &[Edit]) -> String {
    let line = line_of(text, span.start);
    let here: Vec<&Edit> = edits
        .iter()
        .filter(|edit| line.start <= edit.span.start as usize && edit.span.end as usize <= line.end)
        .collect();
    let old = |edit: &Edit| text.get(edit.span.range()).unwrap_or("").trim().to_owned();
    let is_word =
        |text: &str| text.len() > 2 && text.chars().all(|c| c.is_alphanumeric() || c == '_');
    let (mended, _) = applied(text, line.clone(), here.iter().copied()).unwrap_or_default();
    let mended = mended.split_whitespace().collect::<Vec<_>>().join(" ");
    let new = edits.first().map_or("", |edit| edit.text.trim());
    if let [only] = here.as_slice()
        && is_word(only.text.trim())
        && is_word(&old(only))
    {
        return format!("write `{}`", only.text.trim());
    }
    let part = excerpt(text, line, &here);
    let is_moved = here.iter().any(|edit| edit.text.contains('\n'));
    match (here.is_empty() || is_moved, mended.is_empty()) {
        (true, _) | (_, true) if new.is_empty() => {
            format!("leave out `{}`", edits.first().map(old).unwrap_or_default())
        }
        (false, false) if mended.len() <= LONGEST => format!("write `{mended}`"),
        _ if !here.is_empty() && !is_moved && part.len() <= LONGEST => format!("write `{part}`"),
        _ if edits.len() == 1 && !new.is_empty() && new.len() <= LONGEST && !new.contains('\n') => {
            format!("write `{new}`")
        }
        (true, _) => format!("write `{} …`", new.lines().next().unwrap_or("")),
        _ => format!("write `{part}`"),
    }
}

/// The edited part of a line after the edits, extended to whole words.
fn excerpt(text: &str, line: Range<usize>, edits: &[&Edit]) -> String {
    let (Some(first), Some(last)) = (edits.first(), edits.last()) else { return String::new() };
    let before = text.get(line.start..first.span.start as usize).unwrap_or("");
    let behind = text.get(last.span.end as usize..line.end).unwrap_or("");
    let start = before.rfind(char::is_whitespace).map_or(0, |blank| blank + 1);
    let end = behind.find(char::is_whitespace).unwrap_or(behind.len());
    let mut mended = before.get(start..).unwrap_or("").to_owned();
    for (at, edit) in edits.iter().enumerate() {
        mended.push_str(&edit.text);
        let next = edits.get(at + 1).map_or(last.span.end + end as u32, |next| next.span.start);
        mended.push_str(text.get(edit.span.end as usize..next as usize).unwrap_or(""));
    }
    let mended = mended.split_whitespace().collect::<Vec<_>>().join(" ");
    match mended.char_indices().nth(LONGEST) {
        Some((at, _)) => format!("{}…", &mended[..at]),
        None => mended,
    }
}

/// The range of the line that contains a byte.
fn line_of(text: &str, at: u32) -> Range<usize> {
    let at = (at as usize).min(text.len());
    let start = text.get(..at).and_then(|before| before.rfind('\n')).map_or(0, |end| end + 1);
    let end = text.get(at..).and_then(|rest| rest.find('\n')).map_or(text.len(), |end| at + end);
    start..end
}

/// Extends a deletion to the blanks before it, or to the whole line if nothing else is left there.
fn whole_line(text: &str, edit: Edit) -> Edit {
    if !edit.text.is_empty() {
        return edit;
    }
    let Edit { span, text: written } = edit;
    let line = line_of(text, span.start);
    let before = text.get(line.start..span.start as usize).unwrap_or("");
    let behind = text.get(span.end as usize..).unwrap_or("");
    let to_line_end = behind.find('\n').unwrap_or(behind.len());
    let alone = before.trim().is_empty() && behind[..to_line_end].trim().is_empty();
    let blanks = before.len() - before.trim_end().len();
    let after = behind.len() - behind.trim_start_matches([' ', '\t']).len();
    let (start, end) = match alone {
        true => (line.start, span.end as usize + (to_line_end + 1).min(behind.len())),
        false if before.trim().is_empty() => (span.start as usize, span.end as usize + after),
        // The text that follows directly stays separated from the text before.
        false if after == 0 && to_line_end > 0 => (span.start as usize, span.end as usize),
        false => (span.start as usize - blanks, span.end as usize),
    };
    Edit { span: Span::new(span.file, start, end), text: written }
}
