//! Ports, and the links between them that a side states.
//!
//! Every drawn halfedge or path `X` has two ports: `Out(X)`, where it leaves its origin, and
//! `In(X)`, where it arrives at its target. Clockwise around a vertex ports alternate:
//!
//! ```text
//!   Out(x) --twin--> In(x') --next--> Out(y) --twin--> In(y') …
//! ```
//!
//! An edge `x | y` states `Out(x) -> In(y)` and `Out(y) -> In(x)`; loop items `X Y` in a row
//! state `In(X) -> Out(Y)`.

use crate::diagram::{Kind, NameId, Rule, Side};

/// A port: where an item leaves its origin, or arrives at its target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Port {
    /// The end at which it leaves its origin.
    Out(NameId),
    /// The end at which it arrives at its target.
    In(NameId),
}

impl Port {
    /// A number, unique among the ports of a rule.
    pub fn index(self) -> usize {
        match self {
            Port::Out(item) => 2 * item.index(),
            Port::In(item) => 2 * item.index() + 1,
        }
    }

    /// The halfedge or path, if it leaves its origin here.
    pub fn leaving(self) -> Option<NameId> {
        match self {
            Port::Out(item) => Some(item),
            Port::In(_) => None,
        }
    }

    /// The halfedge or path.
    pub fn item(self) -> NameId {
        match self {
            Port::Out(item) | Port::In(item) => item,
        }
    }
}

/// The links that one side states.
#[derive(Clone, Debug)]
pub(super) struct Links {
    /// All ports of the items that the side draws.
    pub ports: Vec<Port>,
    next: Vec<Option<Port>>,
    linked: Vec<bool>,
}

impl Links {
    /// Reads the links of a side.
    pub fn of(rule: &Rule, side: &Side) -> Self {
        let count = 2 * rule.names.len();
        let mut links =
            Self { ports: Vec::new(), next: vec![None; count], linked: vec![false; count] };
        let mut seen = vec![false; rule.names.len()];
        let in_loops = side.loops.iter().flat_map(|orbit| &orbit.items).map(|item| item.item.name);
        let in_edges = side.edges.iter().flat_map(|edge| edge.halfedges).map(|half| half.name);
        for item in in_loops.chain(in_edges) {
            debug_assert!(matches!(rule.kind(item), Kind::Halfedge | Kind::Path));
            if !std::mem::replace(&mut seen[item.index()], true) {
                links.ports.extend([Port::Out(item), Port::In(item)]);
            }
        }
        for edge in &side.edges {
            let [left, right] = edge.halfedge_names();
            links.link(Port::Out(left), Port::In(right));
            links.link(Port::Out(right), Port::In(left));
        }
        for orbit in &side.loops {
            for (at, item) in orbit.items.iter().enumerate() {
                let next = orbit.items[(at + 1) % orbit.items.len()].item.name;
                links.link(Port::In(item.item.name), Port::Out(next));
            }
        }
        links
    }

    fn link(&mut self, from: Port, to: Port) {
        self.next[from.index()] = Some(to);
        self.linked[to.index()] = true;
    }

    /// The port that a stated link leads to.
    pub fn next(&self, port: Port) -> Option<Port> {
        self.next[port.index()]
    }

    /// True if a stated link leads to the port.
    pub fn is_reached(&self, port: Port) -> bool {
        self.linked[port.index()]
    }
}
