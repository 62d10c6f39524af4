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
        match self {
            Self::ThreeSides(face) => format!("{} has 3 sides or more", word(*face)),
            Self::MeetsOnce(face) => format!("{} meets no vertex twice", word(*face)),
            Self::CornerOnce { face, vertex } => {
                format!("{} meets {} once", word(*face), word(*vertex))
            }
            Self::FacesDiffer { vertex, .. } => {
                format!("no face lies around {} twice", word(*vertex))
            }
            Self::TwoSpokes(vertex) => format!("{} has 2 spokes or more", word(*vertex)),
            Self::OneHole { vertex, .. } => format!("{} lies on at most one hole", word(*vertex)),
            Self::OneHoleAlong(path) => {
                format!("each vertex along {} lies on one hole", word(*path))
            }
            Self::NeighborsDiffer { vertex, .. } => {
                format!("the neighbors of {} are distinct", word(*vertex))
            }
            Self::SingleEdge { ends: [v, w], .. } => {
                let (v, w) = (v.min(w), v.max(w));
                format!("one edge joins {} and {}", word(*v), word(*w))
            }
            Self::CornersDiffer(vertex) => {
                format!("the faces around {} differ in corners", word(*vertex))
            }
            Self::CornersOwn { face, .. } => {
                format!("no other face has the corners of {}", word(*face))
            }
        }
    }

    /// The reason why an operation refuses where it would not hold.
    pub fn refusal(&self, rule: &Rule) -> String {
        let quoted = |name: NameId| rule.quoted(name);
        // The two vertices whose stars become one, if there are two.
        let merged = |from: &[NameId]| match from {
            [v, w] => Some((quoted(*v), quoted(*w))),
            _ => None,
        };
        match self {
            Self::ThreeSides(face) => format!("{} would have fewer than 3 sides", quoted(*face)),
            Self::MeetsOnce(face) => format!("{} would meet a vertex twice", quoted(*face)),
            Self::CornerOnce { face, vertex } => {
                format!("{} would meet {} twice", quoted(*face), quoted(*vertex))
            }
            Self::FacesDiffer { vertex, from } => match merged(from) {
                Some((v, w)) => {
                    format!("a face around both {v} and {w} would meet {} twice", quoted(*vertex))
                }
                None => format!("a face would meet {} twice", quoted(*vertex)),
            },
            Self::TwoSpokes(vertex) => format!("{} would keep a single edge", quoted(*vertex)),
            Self::OneHole { vertex, from } => match merged(from) {
                Some((v, w)) => format!(
                    "both {v} and {w} lie on the boundary: the surface would be pinched at {}",
                    quoted(*vertex)
                ),
                None => format!("the surface would be pinched at {}", quoted(*vertex)),
            },
            Self::OneHoleAlong(path) => {
                format!("the surface would be pinched at a vertex of {}", quoted(*path))
            }
            Self::NeighborsDiffer { vertex, from } => match merged(from) {
                Some((v, w)) => format!(
                    "{v} and {w} have a neighbor in common: two edges would join it to {}",
                    quoted(*vertex)
                ),
                None => format!("two edges would join {} to one neighbor", quoted(*vertex)),
            },
            Self::SingleEdge { ends: [v, w], .. } => {
                let (v, w) = (v.min(w), v.max(w));
                format!("two edges would join {} and {}", quoted(*v), quoted(*w))
            }
            Self::CornersDiffer(vertex) => {
                format!("two faces around {} would have the same corners", quoted(*vertex))
            }
            Self::CornersOwn { face, .. } => {
                format!("another face has the corners that {} would have", quoted(*face))
            }
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
