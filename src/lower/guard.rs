//! The tests of a guard: the conditions of its level that the proof left open.
//!
//! Each is tested on the result before that is written: the pointers of phase 3 that a test reads
//! are set on a preview of the mesh, and the test looks at one orbit of the preview. Where the mesh
//! itself has the answer, the mesh is asked.

use crate::check::guard::{Condition, Obligation, Statement};
use crate::diagram::{Drawing, Kind, NameId, Pointer};
use crate::mesh::OrbitCondition;

/// The tests of a guard.
#[derive(Clone, Debug)]
pub struct Guard {
    pub tests: Vec<GuardTest>,
    /// The pointers of the preview that the tests read; `None` if no test looks at the preview.
    pub reads: Option<PreviewReads>,
}

#[derive(Clone, Debug)]
pub struct GuardTest {
    pub question: Question,
    /// True if it is asked at every index, though its names are members at one index.
    pub at_each_index: bool,
    /// The condition, without backticks.
    pub claim: String,
    /// The reason to refuse where it does not hold.
    pub refusal: String,
}

/// A question about the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// No edge of the current mesh joins two vertices.
    NotAdjacent([NameId; 2]),
    /// A condition holds for an element of the preview, or for two.
    Holds { condition: OrbitCondition, of: NameId, at: Option<NameId> },
    /// At each vertex along a path at most one corner lies in a hole of the preview.
    OneHoleAlong(NameId),
}

/// The pointers of a preview that tests read. No test reads edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PreviewReads {
    /// Walks around vertices.
    stars: bool,
    /// Walks around loops.
    loops: bool,
    /// The vertices where halfedges start.
    origins: bool,
    /// The loops in which halfedges lie, and which of these are holes.
    faces: bool,
}

/// The way around a vertex from one spoke to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StarWalk {
    /// `h.prev.twin`; the target of that spoke is the origin of `h.prev`.
    Counterclockwise,
    /// `h.twin.next`
    Clockwise,
}

impl PreviewReads {
    const ALL: Self = Self { stars: true, loops: true, origins: true, faces: true };

    /// The pointers that a condition reads.
    fn of(condition: OrbitCondition) -> Self {
        let none = Self::default();
        match condition {
            OrbitCondition::ThreeSides => Self { loops: true, ..none },
            OrbitCondition::MeetsOnce => Self { loops: true, origins: true, ..none },
            OrbitCondition::TwoSpokes => Self { stars: true, ..none },
            OrbitCondition::CornerOnce | OrbitCondition::FacesDiffer | OrbitCondition::OneHole => {
                Self { stars: true, faces: true, ..none }
            }
            OrbitCondition::NeighborsDiffer | OrbitCondition::SingleEdge => {
                Self { stars: true, origins: true, ..none }
            }
            OrbitCondition::CornersDiffer | OrbitCondition::CornersOwn => Self::ALL,
        }
    }

    fn and(self, other: Self) -> Self {
        Self {
            stars: self.stars | other.stars,
            loops: self.loops | other.loops,
            origins: self.origins | other.origins,
            faces: self.faces | other.faces,
        }
    }

    /// True if tests that walk around vertices in this way read a pointer.
    pub fn reads(self, pointer: Pointer, walk: StarWalk) -> bool {
        let clockwise = walk == StarWalk::Clockwise;
        match pointer {
            Pointer::Next => self.loops || self.stars && clockwise,
            Pointer::Prev => (self.stars || self.loops) && !clockwise,
            Pointer::Twin => self.stars || self.origins,
            Pointer::Vertex => self.origins,
            Pointer::Face => self.faces,
            Pointer::VertexHalfedge => self.stars,
            Pointer::FaceHalfedge => self.loops,
            _ => false,
        }
    }

    /// True if tests read which faces are holes.
    pub fn reads_holes(self) -> bool {
        self.faces
    }
}

impl Guard {
    /// The tests for the obligations that the proof left open.
    pub fn new(drawing: &Drawing, obligations: &[Obligation]) -> Self {
        let rule = drawing.rule;
        let open = obligations.iter().filter(|obligation| obligation.is_test());
        let test = |Obligation { statement, .. }: &Obligation| GuardTest {
            question: question(drawing, statement),
            // The paths of a family are walked together.
            at_each_index: statement.is_repeated(rule)
                && statement.condition != Condition::OneHoleAlong,
            claim: statement.claim(rule),
            refusal: statement.refusal(rule),
        };
        let tests: Vec<_> = open.map(test).collect();
        let reads = tests.iter().filter_map(|test| match test.question {
            Question::NotAdjacent(_) => None,
            Question::Holds { condition, .. } => Some(PreviewReads::of(condition)),
            Question::OneHoleAlong(_) => Some(PreviewReads::ALL),
        });
        Self { reads: reads.reduce(PreviewReads::and), tests }
    }
}

fn question(drawing: &Drawing, statement: &Statement) -> Question {
    let &Statement { condition, of, at, .. } = statement;
    let is_edge = condition == OrbitCondition::SingleEdge.into();
    let ends = is_edge.then(|| ends_without_edge(drawing, of)).flatten();
    match (condition, ends) {
        (Condition::OneHoleAlong, _) => Question::OneHoleAlong(of),
        (Condition::Orbit(_), Some(ends)) => Question::NotAdjacent(ends),
        (Condition::Orbit(condition), None) => Question::Holds { condition, of, at },
    }
}

/// The ends of a halfedge of `after`, if another edge would join them exactly if one joins them
/// now: no drawn edge joins them before, and after only that of the halfedge; edges that are not
/// drawn keep their ends.
fn ends_without_edge(drawing: &Drawing, halfedge: NameId) -> Option<[NameId; 2]> {
    let rule = drawing.rule;
    let ends = [drawing.origin_after(halfedge)?, drawing.target_after(halfedge)?];
    let are_drawn = ends.iter().all(|&end| drawing.before.mention(end).is_some());
    let is_plain = rule.aliases.is_empty()
        && rule.ids().all(|name| rule.kind(name) != Kind::Fan && !rule.is_member(name));
    if ends[0] == ends[1] || !are_drawn || !is_plain {
        return None;
    }
    let joins = |[from, to]: [NameId; 2]| [from, to] == ends || [to, from] == ends;
    for other in rule.names_of(Kind::Halfedge) {
        if drawing.before.mention(other).is_some()
            && joins([drawing.origin_before(other)?, drawing.target_before(other)?])
        {
            return None;
        }
        if drawing.after.mention(other).is_some() {
            let after = [drawing.origin_after(other)?, drawing.target_after(other)?];
            let is_asked = other == halfedge || drawing.after.twin(other) == Some(halfedge);
            if joins(after) && !is_asked {
                return None;
            }
        }
    }
    Some(ends)
}
