//! The pointers that a drawing states between named halfedges.

use super::matching::{Bound, Source, Way};
use crate::diagram::{Drawing, Kind, NameId};

/// A pointer that the drawing states between two named halfedges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pointer {
    pub from: NameId,
    pub to: NameId,
    pub leads: Leads,
    /// True if a name is bound by it.
    pub used: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Leads {
    Next,
    Twin,
    Counterclockwise,
}

impl Pointer {
    /// From the first to the second.
    pub fn forward(self) -> Source {
        let from = Bound::Element(self.from);
        match self.leads {
            Leads::Next => Way::Next.of(from),
            Leads::Twin => Way::Twin.of(from),
            Leads::Counterclockwise => Way::Counterclockwise.of(from),
        }
    }

    /// From the second to the first.
    pub fn backward(self) -> Source {
        let to = Bound::Element(self.to);
        match self.leads {
            Leads::Next => Way::Prev.of(to),
            Leads::Twin => Way::Twin.of(to),
            Leads::Counterclockwise => Way::Clockwise.of(to),
        }
    }
}

/// The pointers of a drawing between halfedges: `next` in loops, `twin` in edges, and the next
/// spoke in vertex statements where the loops and edges do not imply it. For members of families,
/// only those from index 0.
pub(super) fn pointers(drawing: &Drawing) -> Vec<Pointer> {
    let rule = drawing.rule;
    let view = &drawing.before;
    let is_halfedge = |name: NameId| rule.kind(name) == Kind::Halfedge;
    let mut pointers = Vec::new();
    for orbit in &rule.before.loops {
        for (at, item) in orbit.items.iter().enumerate() {
            let (from, to) = (item.item.name, orbit.items[(at + 1) % orbit.items.len()].item.name);
            if is_halfedge(from) && is_halfedge(to) {
                pointers.push(Pointer { from, to, leads: Leads::Next, used: false });
            }
        }
    }
    for edge in &rule.before.edges {
        let [from, to] = edge.halfedge_names();
        pointers.push(Pointer { from, to, leads: Leads::Twin, used: false });
    }
    for star in &rule.before.stars {
        for pair in star.neighbors() {
            let [from, to] = pair.map(|half| half.name);
            let implied = view
                .item_before(from)
                .is_some_and(|prev| is_halfedge(prev) && view.twin(prev) == Some(to));
            if !implied {
                pointers.push(Pointer { from, to, leads: Leads::Counterclockwise, used: false });
            }
        }
    }
    pointers.retain(|pointer| rule.is_first(pointer.from));
    pointers
}
