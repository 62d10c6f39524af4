//! The completions for each context of a cursor.

use std::collections::HashSet;

use super::choice::{Choice, Completion};
use super::drawing::{can_be_one, indices, of_side, results};
use super::field::fields_of;
use super::path::paths;
use super::value::{meshes, of_file, values};
use super::words::{PARTS, TOP, keywords, kinds, types, value_types};
use crate::analysis::cursor_context::{CursorContext, next_on_line, place};
use crate::analysis::files::Reader;
use crate::analysis::snapshot::Snapshot;
use crate::diagram::Property;
use crate::syntax::TokenKind as T;

/// The completions at a byte. The reader knows the files that a `use` may name.
pub fn completions(snapshot: &Snapshot, offset: usize, reader: &mut dyn Reader) -> Vec<Completion> {
    let mut found = fitting(snapshot, offset, place(snapshot, offset), reader);
    if let Some(next) = next_on_line(snapshot, offset) {
        found.iter_mut().for_each(|completion| leave_out(completion, next));
    }
    found.sort_by(|left, right| (left.rank, &left.word).cmp(&(right.rank, &right.word)));
    let mut words = HashSet::new();
    found.retain(|completion| words.insert(completion.word.clone()));
    found
}

/// Leaves out of a completion what is written behind the cursor already, where a token follows: the
/// arguments of a call, the rest of a statement.
fn leave_out(completion: &mut Completion, next: T) {
    let call = format!("{}(", completion.word);
    let is_written = match completion.snippet.as_ref().is_some_and(|text| text.starts_with(&call)) {
        true => next == T::LeftParen,
        false => !matches!(next, T::RightBrace | T::RightParen),
    };
    completion.snippet.take_if(|_| is_written);
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
        CursorContext::Field(operand) => fields_of(snapshot, offset, &operand, reader),
    }
}
