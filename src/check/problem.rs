//! A broken law: the diagnostic, and what a repair has to know about it.

use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{Loop, NameId, Rule, Side};
use crate::source::Span;

/// A broken law.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    /// The message.
    pub diagnostic: Diagnostic,
    /// The repairs that might mend it, to be tried in [`mend`](super::mend).
    pub repairs: Vec<Repair>,
}

/// A candidate fix of a problem, or of all problems of a rule.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Repair {
    /// `erase` these names; of a family, all members.
    Erase(Vec<NameId>),
    /// `keep` these edges, faces or vertices.
    Keep(Vec<NameId>),
    /// List these names in `new`.
    Create(Vec<NameId>),
    /// State the ring of the vertex that [takes](super::fan_repair) the spokes of this one, which
    /// is erased.
    Take(NameId),
    /// A halfedge or path of `before` in a loop of `after` that has forgotten it: behind `at` of
    /// its items, with the vertex where it starts.
    Insert { face: NameId, at: usize, from: NameId, item: NameId },
    /// A name of `before` that stands nowhere else, written as the other.
    Rename { old: NameId, new: NameId },
    /// These edges in `after`, each with these halfedges, also instead of those it has there.
    Pair(Vec<(NameId, [NameId; 2])>),
    /// An edge with a new name for each of these pairs, listed in `new`.
    PairAll(Vec<[NameId; 2]>),
    /// The loop with this statement, drawn the other way round.
    Turn(Span),
    /// The missing loop of a face: each item behind the vertex where it starts.
    Draw { face: NameId, items: Vec<(NameId, NameId)> },
    /// Other names at the same places of the loops of `after`, and what that means.
    Redraw { loops: Vec<Loop>, how: String },
    /// The edges of these halfedges in `before`, each with an outer twin.
    DrawTwins(Vec<NameId>),
    /// One after the other.
    All(Vec<Repair>),
}

impl From<Diagnostic> for Problem {
    fn from(diagnostic: Diagnostic) -> Self {
        Self { diagnostic, repairs: Vec::new() }
    }
}

/// Names in backticks as an enumeration: "`a`, `b` and `c`".
pub(super) fn enumerate(rule: &Rule, names: &[NameId]) -> String {
    all_of(names.iter().map(|&name| rule.quoted(name)))
}

/// The keyword with which a side begins.
pub(super) fn keyword(side: &Side, word: &str) -> Span {
    Span { end: (side.span.start + word.len() as u32).min(side.span.end), ..side.span }
}

/// "is" or "are".
pub(super) fn is_or_are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}
