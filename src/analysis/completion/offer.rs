//! Which completions belong to which place.

use super::choice::{Choice, Completion};
use super::drawing::{drawn, of_side};
use super::value::{of_chain, values};
use super::words::{PARTS, TOP, keywords, types};
use crate::analysis::place::{Place, place};
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Property;
use crate::library;

/// What may come next at a byte.
pub fn completions(snapshot: &Snapshot, offset: usize) -> Vec<Completion> {
    let mut found = match place(snapshot, offset) {
        Place::Top => keywords(TOP),
        Place::Nowhere => Vec::new(),
        Place::Path => {
            library::files().map(|file| Completion::new(file.name, Choice::File, 0)).collect()
        }
        Place::Type => types(),
        Place::Property => Property::ALL
            .map(|property| Completion::new(property.word(), Choice::Property, 0))
            .to_vec(),
        Place::Level => {
            ["surface", "simple"].map(|level| Completion::new(level, Choice::Property, 0)).to_vec()
        }
        Place::Result => drawn(snapshot, offset),
        Place::OpBody => keywords(PARTS),
        Place::Side(side, wanted) => of_side(snapshot, offset, side, wanted),
        Place::Value(start) => values(snapshot, offset, start),
        Place::Field(chain) => of_chain(snapshot, offset, &chain),
    };
    found.sort_by(|left, right| (left.rank, &left.word).cmp(&(right.rank, &right.word)));
    found.dedup_by(|later, first| later.word == first.word);
    found
}
