//! The completions for each context of a cursor.

use std::collections::HashSet;

use super::choice::{Choice, Completion};
use super::drawing::{can_be_one, indices, of_side, results};
use super::path::paths;
use super::value::{meshes, of_chain, of_file, values};
use super::words::{PARTS, TOP, keywords, kinds, types, value_types};
use crate::analysis::cursor_context::{CursorContext, is_called, place};
use crate::analysis::files::Reader;
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Property;

/// The completions at a byte. The reader knows the files that a `use` may name.
pub fn completions(snapshot: &Snapshot, offset: usize, reader: &mut dyn Reader) -> Vec<Completion> {
    let mut found = fitting(snapshot, offset, place(snapshot, offset), reader);
    if is_called(snapshot, offset) {
        for completion in &mut found {
            let call = format!("{}(", completion.word);
            completion.snippet.take_if(|snippet| snippet.starts_with(&call));
        }
    }
    found.sort_by(|left, right| (left.rank, &left.word).cmp(&(right.rank, &right.word)));
    let mut words = HashSet::new();
    found.retain(|completion| words.insert(completion.word.clone()));
    found
}

/// The completions that fit a context, in no order.
fn fitting(
    snapshot: &Snapshot,
    offset: usize,
    context: CursorContext,
    reader: &mut dyn Reader,
) -> Vec<Completion> {
    let plain = |words: &[&str], choice, rank| -> Vec<Completion> {
        words.iter().map(|word| Completion::new(*word, choice, rank)).collect()
    };
    match context {
        CursorContext::Top => keywords(TOP),
        CursorContext::Nowhere => Vec::new(),
        CursorContext::Path(written) => paths(snapshot, offset, written, reader),
        CursorContext::Type => types(),
        CursorContext::Kind => kinds(),
        CursorContext::ValueType => value_types(),
        CursorContext::Property => plain(&Property::ALL.map(Property::word), Choice::Property, 0),
        CursorContext::Level => plain(&["surface", "simple"], Choice::Property, 0),
        CursorContext::Alias => can_be_one(snapshot, offset),
        CursorContext::Result => results(snapshot, offset),
        CursorContext::Mesh => meshes(snapshot, offset),
        CursorContext::Words(words) => plain(words, Choice::Keyword, 0),
        CursorContext::GoesOn(words, next) => {
            let mut found = fitting(snapshot, offset, *next, reader);
            found.extend(plain(words, Choice::Keyword, 6));
            found
        }
        CursorContext::OpBody => keywords(PARTS),
        CursorContext::Index(letter) => indices(&letter),
        CursorContext::Side(side, wanted) => of_side(snapshot, offset, side, wanted),
        CursorContext::Value(start) => values(snapshot, offset, start),
        CursorContext::File(file) => of_file(snapshot, &file),
        CursorContext::Field(chain) => of_chain(snapshot, offset, &chain),
    }
}
