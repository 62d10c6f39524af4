//! A rule with families, unrolled to cycles of several sizes.

use super::fold::{Fold, fold_obligations};
use super::guard::{Obligation, obligations};
use crate::diagram::{Drawing, Kind, Level, Loop, Naming, Rule, Spoke, Unrolled};

/// A rule with families, unrolled to the sizes that are examined.
pub(super) struct Sizes {
    /// So large that no statement reaches around the cycle.
    pub large: Unrolled,
    /// The short cycles, on which members may coincide.
    pub small: Vec<Unrolled>,
}

impl Sizes {
    pub fn new(rule: &Rule) -> Self {
        let span = rule.span_of_subscripts();
        // A name and the vertex it starts at are at most two statements apart, each of which
        // spans twice the widest subscript.
        let reach = 4 * span + 2;
        let unroll = |size| Unrolled::new(rule, size, Naming::Numbers);
        Self {
            large: Unrolled::new(rule, 2 * reach + 1, Naming::Relative),
            small: (1..=reach).map(unroll).collect(),
        }
    }

    /// The obligations of a level that arise on a cycle of some size, for members at index 0.
    pub fn obligations(&self, level: Level) -> Vec<Obligation> {
        let mut found = Vec::new();
        for other in self.all() {
            let drawing = Drawing::new(&other.rule);
            if !is_in_a_surface(&drawing) {
                continue;
            }
            let fold = Fold { large: &self.large, other };
            fold_obligations(&fold, obligations(&drawing, level), &mut found);
        }
        found
    }

    pub fn all(&self) -> impl Iterator<Item = &Unrolled> {
        std::iter::once(&self.large).chain(&self.small)
    }
}

/// True if the drawing can match in a surface: no loop has two sides, no vertex one spoke.
fn is_in_a_surface(drawing: &Drawing) -> bool {
    let rule = drawing.rule;
    let halfedges =
        |orbit: &&Loop| orbit.items.iter().all(|item| rule.kind(item.item.name) == Kind::Halfedge);
    let mut loops = rule.before.loops.iter().filter(halfedges);
    let mut stars = rule.before.stars.iter();
    loops.all(|orbit| orbit.items.len() > 2)
        && !stars.any(|star| matches!(star.spokes.as_slice(), [Spoke::Halfedge(_)]))
}
