//! Obligations of a level for each orbit of `after`, and the reasons why they hold.

use crate::diagram::{NameId, Rule};
use crate::mesh::OrbitCondition as Orbit;

/// A condition of an orbit of `after`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    pub condition: Condition,
    /// The loop, vertex, halfedge or path that it is about.
    pub of: NameId,
    /// One corner of the loop that it is about.
    pub at: Option<NameId>,
    /// What only the reader is told: the vertices whose stars a vertex takes over, or the two ends
    /// of an edge.
    pub others: Vec<NameId>,
}

/// A condition of a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// Of one orbit.
    Orbit(Orbit),
    /// At most one corner of every vertex along a path lies in a hole: the path goes from a face to
    /// a hole.
    OneHoleAlong,
}

impl From<Orbit> for Condition {
    fn from(condition: Orbit) -> Self {
        Self::Orbit(condition)
    }
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
    pub(in crate::check) fn new(condition: impl Into<Condition>, of: NameId) -> Self {
        Self { condition: condition.into(), of, at: None, others: Vec::new() }
    }

    /// The statement about one corner of the loop.
    pub(in crate::check) fn at(self, corner: NameId) -> Self {
        Self { at: Some(corner), ..self }
    }

    /// The statement with what only the reader is told.
    pub(in crate::check) fn telling(self, others: Vec<NameId>) -> Self {
        Self { others, ..self }
    }

    /// True if it is tested at every index, though its names are members at one index.
    pub fn is_repeated(&self, rule: &Rule) -> bool {
        let corner = self.at.filter(|_| self.condition == Orbit::CornerOnce.into());
        rule.is_member(self.of) || corner.is_some_and(|corner| rule.is_member(corner))
    }

    /// The condition as a table prints it, without backticks.
    pub fn claim(&self, rule: &Rule) -> String {
        let word = |name: NameId| rule.name(name).text.as_str();
        let it = word(self.of);
        let Condition::Orbit(condition) = self.condition else {
            return format!("each vertex along {it} lies on one hole");
        };
        match condition {
            Orbit::ThreeSides => format!("{it} has 3 sides or more"),
            Orbit::MeetsOnce => format!("{it} meets no vertex twice"),
            Orbit::CornerOnce => format!("{it} meets {} once", self.at.map_or("", word)),
            Orbit::FacesDiffer => format!("no face lies around {it} twice"),
            Orbit::TwoSpokes => format!("{it} has 2 spokes or more"),
            Orbit::OneHole => format!("{it} lies on at most one hole"),
            Orbit::NeighborsDiffer => format!("the neighbors of {it} are distinct"),
            Orbit::SingleEdge => format!("one edge joins {}", self.both(|name| word(name).into())),
            Orbit::CornersDiffer => format!("the faces around {it} differ in corners"),
            Orbit::CornersOwn => format!("no other face has the corners of {it}"),
        }
    }

    /// "v0 and v1", the two that the reader is told.
    fn both(&self, word: impl Fn(NameId) -> String) -> String {
        let mut others = self.others.clone();
        others.sort_unstable();
        others.into_iter().map(word).collect::<Vec<_>>().join(" and ")
    }

    /// The reason why an operation refuses where it would not hold.
    pub fn refusal(&self, rule: &Rule) -> String {
        let quoted = |name: NameId| rule.quoted(name);
        let it = quoted(self.of);
        let Condition::Orbit(condition) = self.condition else {
            return format!("the surface would be pinched at a vertex of {it}");
        };
        // The two vertices whose stars become one, if there are two.
        let merged = match self.others.as_slice() {
            [v, w] => Some((quoted(*v), quoted(*w))),
            _ => None,
        };
        match (condition, merged) {
            (Orbit::ThreeSides, _) => format!("{it} would have fewer than 3 sides"),
            (Orbit::MeetsOnce, _) => format!("{it} would meet a vertex twice"),
            (Orbit::CornerOnce, _) => {
                format!("{it} would meet {} twice", self.at.map(quoted).unwrap_or_default())
            }
            (Orbit::FacesDiffer, Some((v, w))) => {
                format!("a face around both {v} and {w} would meet {it} twice")
            }
            (Orbit::FacesDiffer, None) => format!("a face would meet {it} twice"),
            (Orbit::TwoSpokes, _) => format!("{it} would keep a single edge"),
            (Orbit::OneHole, Some((v, w))) => format!(
                "both {v} and {w} lie on the boundary: the surface would be pinched at {it}"
            ),
            (Orbit::OneHole, None) => format!("the surface would be pinched at {it}"),
            (Orbit::NeighborsDiffer, Some((v, w))) => {
                format!("{v} and {w} have a neighbor in common: two edges would join it to {it}")
            }
            (Orbit::NeighborsDiffer, None) => format!("two edges would join {it} to one neighbor"),
            (Orbit::SingleEdge, _) => format!("two edges would join {}", self.both(quoted)),
            (Orbit::CornersDiffer, _) => {
                format!("two faces around {it} would have the same corners")
            }
            (Orbit::CornersOwn, _) => format!("another face has the corners that {it} would have"),
        }
    }

    /// The quantities that the time of the test grows with; `None` if it is constant.
    pub fn grows_with(&self, rule: &Rule) -> Option<String> {
        let it = rule.quoted(self.of);
        let corner = rule.quoted(self.at.unwrap_or(self.of));
        let Condition::Orbit(condition) = self.condition else {
            return Some(format!("the degrees along {it}"));
        };
        match condition {
            // Both look at no more than three steps.
            Orbit::ThreeSides | Orbit::TwoSpokes => None,
            Orbit::MeetsOnce => Some(format!("the size of {it}")),
            Orbit::CornerOnce | Orbit::FacesDiffer | Orbit::OneHole | Orbit::NeighborsDiffer => {
                Some(format!("the degree of {corner}"))
            }
            Orbit::SingleEdge => {
                self.others.first().map(|end| format!("the degree of {}", rule.quoted(*end)))
            }
            Orbit::CornersDiffer | Orbit::CornersOwn => {
                Some(format!("the sizes of the faces around {corner}"))
            }
        }
    }
}
