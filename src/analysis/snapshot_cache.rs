//! What is carried from one snapshot of a document to the next: parse results, proofs, and
//! the last diagram of each op that could be read.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::rc::Rc;

use super::Examined;
use super::parse_cache::ParseCache;
use crate::diagram;
use crate::source::Span;

/// The most proofs of earlier texts that are kept, besides those of the current text.
const MOST_REMEMBERED: usize = 1024;

#[derive(Clone, Debug, Default)]
pub(super) struct SnapshotCache {
    pub(super) parse_cache: ParseCache,
    /// The last diagrams of ops that can no longer be read, by name.
    pub(super) lost: BTreeMap<String, Rc<diagram::Op>>,
    /// The proofs, by the text of the op.
    proofs: HashMap<String, Remembered>,
    /// The number of proofs from which on those of earlier texts are dropped.
    room: usize,
}

#[derive(Clone, Debug)]
struct Remembered {
    meaning: u64,
    at: Span,
    examined: Rc<Examined>,
}

/// The key of an op: its text and place, and a fingerprint of what its words mean outside of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct CacheKey<'t> {
    pub(super) text: &'t str,
    pub(super) span: Span,
    pub(super) meaning: u64,
}

impl SnapshotCache {
    /// The result for an op with this text, wherever it was.
    pub(super) fn get(&self, key: CacheKey) -> Option<Rc<Examined>> {
        let known = self.proofs.get(key.text)?;
        (known.meaning == key.meaning).then(|| moved(&known.examined, known.at, key.span))
    }

    /// Keeps the last diagrams of ops, as long as `text` contains their names.
    pub(super) fn lose(
        &mut self,
        diagrams: impl Iterator<Item = (String, Rc<diagram::Op>)>,
        text: &str,
    ) {
        self.lost.extend(diagrams);
        self.lost.retain(|name, _| text.contains(name.as_str()));
    }

    /// Keeps the result for an op. If there are too many, drops those of ops that are not among the
    /// `written` ones.
    pub(super) fn keep<'t>(
        &mut self,
        key: CacheKey,
        examined: &Rc<Examined>,
        written: impl Iterator<Item = &'t str>,
    ) {
        if self.proofs.len() >= self.room.max(MOST_REMEMBERED) {
            let written: HashSet<&str> = written.collect();
            self.proofs.retain(|known, _| written.contains(known.as_str()));
            self.room = written.len() + MOST_REMEMBERED;
        }
        let remembered =
            Remembered { meaning: key.meaning, at: key.span, examined: Rc::clone(examined) };
        self.proofs.insert(key.text.to_owned(), remembered);
    }
}

/// The same result for an op that has moved.
fn moved(examined: &Rc<Examined>, was: Span, is: Span) -> Rc<Examined> {
    if was == is || examined.diagnostics.is_empty() {
        return Rc::clone(examined);
    }
    let shift = |span: &mut Span| {
        let length = span.end - span.start;
        span.start = (span.start - was.start) + is.start;
        span.end = span.start + length;
        span.file = is.file;
    };
    let mut moved = Examined::clone(examined);
    for diagnostic in &mut moved.diagnostics {
        diagnostic.labels.iter_mut().for_each(|label| shift(&mut label.span));
        for fix in &mut diagnostic.fixes {
            fix.edits.iter_mut().for_each(|edit| shift(&mut edit.span));
        }
    }
    Rc::new(moved)
}
