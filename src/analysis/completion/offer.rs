//! The completions for each context of a cursor.

use std::collections::HashSet;

use super::choice::{Choice, Completion};
use super::drawing::{of_side, results};
use super::path::paths;
use super::value::{meshes, of_chain, of_file, values};
use super::words::{PARTS, TOP, keywords, types};
use crate::analysis::cursor_context::{CursorContext, place};
use crate::analysis::files::Reader;
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Property;

/// The completions at a byte. The reader knows the files that a `use` may name.
pub fn completions(snapshot: &Snapshot, offset: usize, reader: &mut dyn Reader) -> Vec<Completion> {
    let mut found = match place(snapshot, offset) {
        CursorContext::Top => keywords(TOP),
        CursorContext::Nowhere => Vec::new(),
        CursorContext::Path(written) => paths(snapshot, offset, written, reader),
        CursorContext::Type => types(),
        CursorContext::Property => Property::ALL
            .map(|property| Completion::new(property.word(), Choice::Property, 0))
            .to_vec(),
        CursorContext::Level => {
            ["surface", "simple"].map(|level| Completion::new(level, Choice::Property, 0)).to_vec()
        }
        CursorContext::Result => results(snapshot, offset),
        CursorContext::Mesh => meshes(snapshot, offset),
        CursorContext::Words(words) => {
            words.iter().map(|word| Completion::new(*word, Choice::Keyword, 0)).collect()
        }
        CursorContext::OpBody => keywords(PARTS),
        CursorContext::Side(side, wanted) => of_side(snapshot, offset, side, wanted),
        CursorContext::Value(start) => values(snapshot, offset, start),
        CursorContext::File(file) => of_file(snapshot, &file),
        CursorContext::Field(chain) => of_chain(snapshot, offset, &chain),
    };
    found.sort_by(|left, right| (left.rank, &left.word).cmp(&(right.rank, &right.word)));
    let mut words = HashSet::new();
    found.retain(|completion| words.insert(completion.word.clone()));
    found
}
