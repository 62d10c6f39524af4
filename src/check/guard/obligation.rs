//! Obligations of a level for each orbit of `after`, and the reasons why they hold.

use crate::diagram::{NameId, Rule};

/// The condition of an orbit of `after`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    /// A loop has three sides or more.
    ThreeSides(NameId),
    /// A loop meets no vertex twice.
    MeetsOnce(NameId),
    /// A loop has no more than one corner at a vertex.
    CornerOnce {
        /// The loop.
        face: NameId,
        vertex: NameId,
    },
    /// No loop lies around a vertex twice, though the pieces of its star come from several.
    FacesDiffer {
        vertex: NameId,
        /// The vertices whose stars it takes over.
        from: Vec<NameId>,
    },
    /// A vertex has two spokes or more.
    TwoSpokes(NameId),
    /// At most one corner of a vertex lies in a hole.
    OneHole {
        vertex: NameId,
        /// The vertices whose stars it takes over.
        from: Vec<NameId>,
    },
    /// The same at every vertex along a path that goes from a face to a hole.
    OneHoleAlong(NameId),
    /// No two edges join a vertex to one neighbor, though the pieces of its star come from
    /// several.
    NeighborsDiffer {
        vertex: NameId,
        /// The vertices whose stars it takes over.
        from: Vec<NameId>,
    },
    /// No other edge has the ends of the edge of a halfedge.
    SingleEdge { halfedge: NameId, ends: [NameId; 2] },
    /// No two faces around a vertex have the same set of corners.
    CornersDiffer(NameId),
    /// No other face has the set of corners of a face.
    CornersOwn {
        face: NameId,
        /// One of its corners: such a face would lie around it.
        vertex: NameId,
    },
}

/// A statement and, if it is proved, why it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Obligation {
    pub statement: Statement,
    /// The reason why it holds; `None` if it is left to test.
    pub because: Option<&'static str>,
    /// True if it never holds, so that a guard refuses every place.
    pub is_never: bool,
}

impl Obligation {
    pub(super) fn new(statement: Statement, because: Option<&'static str>) -> Self {
        Self { statement, because, is_never: false }
    }

    /// The obligation, which never holds if that is so.
    pub(super) fn or_never(self, is_never: bool) -> Self {
        Self { is_never, ..self }
    }

    /// True if it is left to test.
    pub fn is_test(&self) -> bool {
        self.because.is_none()
    }
}

impl Statement {
    /// The element it is about.
    pub fn subject(&self) -> NameId {
        match *self {
            Self::ThreeSides(name)
            | Self::MeetsOnce(name)
            | Self::CornerOnce { face: name, .. }
            | Self::FacesDiffer { vertex: name, .. }
            | Self::TwoSpokes(name)
            | Self::OneHole { vertex: name, .. }
            | Self::OneHoleAlong(name)
            | Self::NeighborsDiffer { vertex: name, .. }
            | Self::SingleEdge { halfedge: name, .. }
            | Self::CornersDiffer(name)
            | Self::CornersOwn { face: name, .. } => name,
        }
    }

    /// The same without what is only for the reader: the vertices whose stars a vertex takes over,
    /// and the ends of a single edge.
    pub(in crate::check) fn without_origin(&self) -> Self {
        let mut statement = self.clone();
        if let Self::FacesDiffer { from, .. }
        | Self::OneHole { from, .. }
        | Self::NeighborsDiffer { from, .. } = &mut statement
        {
            from.clear();
        }
        if let Self::SingleEdge { ends, halfedge } = &mut statement {
            *ends = [*halfedge; 2];
        }
        statement
    }

    /// True if it is tested at every index, though its names are members at one index.
    pub fn is_repeated(&self, rule: &Rule) -> bool {
        match self {
            Self::CornerOnce { face, vertex } => rule.is_member(*face) || rule.is_member(*vertex),
            statement => rule.is_member(statement.subject()),
        }
    }

    /// The condition as a table prints it, without backticks.
    pub fn claim(&self, rule: &Rule) -> String {
        let word = |name: NameId| &rule.name(name).text;
        let it = word(self.subject());
        match self {
            Self::ThreeSides(_) => format!("{it} has 3 sides or more"),
            Self::MeetsOnce(_) => format!("{it} meets no vertex twice"),
            Self::CornerOnce { vertex, .. } => format!("{it} meets {} once", word(*vertex)),
            Self::FacesDiffer { .. } => format!("no face lies around {it} twice"),
            Self::TwoSpokes(_) => format!("{it} has 2 spokes or more"),
            Self::OneHole { .. } => format!("{it} lies on at most one hole"),
            Self::OneHoleAlong(_) => format!("each vertex along {it} lies on one hole"),
            Self::NeighborsDiffer { .. } => format!("the neighbors of {it} are distinct"),
            Self::SingleEdge { ends: [v, w], .. } => {
                let (v, w) = (v.min(w), v.max(w));
                format!("one edge joins {} and {}", word(*v), word(*w))
            }
            Self::CornersDiffer(_) => format!("the faces around {it} differ in corners"),
            Self::CornersOwn { .. } => format!("no other face has the corners of {it}"),
        }
    }

    /// The reason why an operation refuses where it would not hold.
    pub fn refusal(&self, rule: &Rule) -> String {
        let quoted = |name: NameId| rule.quoted(name);
        let it = quoted(self.subject());
        // The two vertices whose stars become one, if there are two.
        let merged = |from: &[NameId]| match from {
            [v, w] => Some((quoted(*v), quoted(*w))),
            _ => None,
        };
        match self {
            Self::ThreeSides(_) => format!("{it} would have fewer than 3 sides"),
            Self::MeetsOnce(_) => format!("{it} would meet a vertex twice"),
            Self::CornerOnce { vertex, .. } => format!("{it} would meet {} twice", quoted(*vertex)),
            Self::FacesDiffer { from, .. } => match merged(from) {
                Some((v, w)) => format!("a face around both {v} and {w} would meet {it} twice"),
                None => format!("a face would meet {it} twice"),
            },
            Self::TwoSpokes(_) => format!("{it} would keep a single edge"),
            Self::OneHole { from, .. } => match merged(from) {
                Some((v, w)) => format!(
                    "both {v} and {w} lie on the boundary: the surface would be pinched at {it}"
                ),
                None => format!("the surface would be pinched at {it}"),
            },
            Self::OneHoleAlong(_) => {
                format!("the surface would be pinched at a vertex of {it}")
            }
            Self::NeighborsDiffer { from, .. } => match merged(from) {
                Some((v, w)) => {
                    format!(
                        "{v} and {w} have a neighbor in common: two edges would join it to {it}"
                    )
                }
                None => format!("two edges would join {it} to one neighbor"),
            },
            Self::SingleEdge { ends: [v, w], .. } => {
                let (v, w) = (v.min(w), v.max(w));
                format!("two edges would join {} and {}", quoted(*v), quoted(*w))
            }
            Self::CornersDiffer(_) => format!("two faces around {it} would have the same corners"),
            Self::CornersOwn { .. } => format!("another face has the corners that {it} would have"),
        }
    }

    /// The quantities that the time of the test grows with; `None` if it is constant.
    pub fn grows_with(&self, rule: &Rule) -> Option<String> {
        let degree = |vertex: &NameId| Some(format!("the degree of {}", rule.quoted(*vertex)));
        match self {
            // Both look at no more than three steps.
            Self::ThreeSides(_) | Self::TwoSpokes(_) => None,
            Self::MeetsOnce(face) => Some(format!("the size of {}", rule.quoted(*face))),
            Self::CornerOnce { vertex, .. }
            | Self::FacesDiffer { vertex, .. }
            | Self::OneHole { vertex, .. }
            | Self::NeighborsDiffer { vertex, .. }
            | Self::SingleEdge { ends: [vertex, _], .. } => degree(vertex),
            Self::OneHoleAlong(path) => Some(format!("the degrees along {}", rule.quoted(*path))),
            Self::CornersDiffer(vertex) | Self::CornersOwn { vertex, .. } => {
                Some(format!("the sizes of the faces around {}", rule.quoted(*vertex)))
            }
        }
    }
}
