//! A broken law: the diagnostic, and what a repair has to know about it.

use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{NameId, Rule};
use crate::source::Span;

/// A broken law.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    /// The message.
    pub diagnostic: Diagnostic,
    /// The remedies that might mend it, to be tried in [`mend`](super::mend).
    pub remedies: Vec<Remedy>,
}

/// Something that might mend a problem.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Remedy {
    /// `erase` these names.
    Erase(Vec<NameId>),
    /// `keep` these edges, faces or vertices.
    Keep(Vec<NameId>),
    /// List these names in `new`.
    Create(Vec<NameId>),
    /// The same, and an edge with a new name for each of these pairs.
    CreateAndPair { created: Vec<NameId>, pairs: Vec<[NameId; 2]> },
    /// State the ring of the vertex that [takes](super::fan_repair) the spokes of this one, which
    /// is erased.
    Take(NameId),
    /// The same, and `keep` these vertices, but for the one that takes them.
    KeepAndTake { kept: Vec<NameId>, erased: NameId },
    /// A halfedge or path of `before` in a loop of `after` that has forgotten it: behind `at` of
    /// its items, with the vertex where it starts.
    Insert { face: NameId, at: usize, from: NameId, item: NameId },
    /// `edge e: x | y`
    Pair { edge: NameId, halfedges: [NameId; 2] },
    /// The loop with this statement, drawn the other way round.
    Turn(Span),
    /// These edges of `after`, each with these halfedges instead of its own.
    PairAnew(Vec<(NameId, [NameId; 2])>),
    /// An edge with a new name for each of these pairs, listed in `new`.
    PairAll(Vec<[NameId; 2]>),
    /// The missing loop of a face: each item behind the vertex where it starts.
    Draw { face: NameId, items: Vec<(NameId, NameId)> },
}

impl From<Diagnostic> for Problem {
    fn from(diagnostic: Diagnostic) -> Self {
        Self { diagnostic, remedies: Vec::new() }
    }
}

/// Names in backticks as an enumeration: "`a`, `b` and `c`".
pub(super) fn enumerate(rule: &Rule, names: &[NameId]) -> String {
    all_of(names.iter().map(|&name| rule.quoted(name)))
}

/// "is" or "are".
pub(super) fn is_or_are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}
