//! The change of the numbers of elements.

use crate::diagram::{Kind, LoopKind, Ref, Rule, Side};

/// The change of the numbers of elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Change {
    pub vertices: i64,
    pub edges: i64,
    /// Faces that are not holes.
    pub faces: i64,
    pub holes: i64,
    /// Loops of which the drawing does not say whether they are faces or holes.
    pub loops: i64,
}

impl Change {
    pub(super) fn minus(self, other: Self) -> Self {
        Self {
            vertices: self.vertices - other.vertices,
            edges: self.edges - other.edges,
            faces: self.faces - other.faces,
            holes: self.holes - other.holes,
            loops: self.loops - other.loops,
        }
    }

    /// The change of V - E + F, holes counted as faces.
    pub fn euler(self) -> i64 {
        self.vertices - self.edges + self.faces + self.holes + self.loops
    }

    pub(super) fn of(rule: &Rule) -> Self {
        let count = |kind: Kind| {
            let of = |names: &[Ref]| {
                names.iter().filter(|mention| rule.kind(mention.name) == kind).count() as i64
            };
            of(&rule.created) - of(&rule.erased)
        };
        let loops = |kind: LoopKind| {
            let of = |side: &Side| side.loops.iter().filter(|orbit| orbit.kind == kind).count();
            of(&rule.after) as i64 - of(&rule.before) as i64
        };
        Self {
            vertices: count(Kind::Vertex),
            edges: count(Kind::Edge),
            faces: loops(LoopKind::Face),
            holes: loops(LoopKind::Hole),
            loops: loops(LoopKind::Any),
        }
    }
}
