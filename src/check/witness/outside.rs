//! The outside of a sketch: how the halfedges outside follow each other.
//!
//! At each vertex the sketch leaves chains of spokes, as in law 7; here each chain begins
//! with a halfedge outside that leaves, and ends with one that arrives. An arc is then just
//! the `next` of the one that arrives, or a few further spokes in between:
//!
//! ```text
//!   arrives ──next──> s ──next──> s.twin ──next──> leaves       (s ends at a fresh vertex)
//! ```

use super::super::arrangement::Arc;
use super::super::port::Port;
use super::sketch::{HalfedgeRole, Sketch, VertexRole};
use crate::diagram::NameId;

/// An arc from a halfedge that arrives to one that leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Join {
    /// The halfedge that arrives.
    pub arrives: usize,
    /// The one that leaves.
    pub leaves: usize,
}

/// The number of further spokes in the arcs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Further {
    /// None.
    Nowhere,
    /// Some in the arc with this number.
    In(usize, usize),
    /// One in each.
    Everywhere,
}

/// The ways in which the arcs of a vertex can run, without further spokes.
pub(super) type Ways = Vec<Vec<Join>>;

/// The greatest number of ways of one vertex that are examined.
const MOST_WAYS: usize = 24;

/// For each vertex with arcs, the ways in which they can run; `None` if the spokes of a vertex
/// cannot form one cycle.
pub(super) fn ways(sketch: &Sketch) -> Option<Vec<Ways>> {
    let mut all = Vec::new();
    for vertex in 0..sketch.vertices.len() {
        let spokes = (0..sketch.halves.len()).filter(|&half| sketch.halves[half].origin == vertex);
        let spokes: Vec<_> = spokes.collect();
        let entries: Vec<_> =
            spokes.iter().copied().filter(|&half| sketch.halves[half].prev.is_none()).collect();
        let mut seen = 0;
        let mut exits = Vec::new();
        for &entry in entries.iter().chain(spokes.first().filter(|_| entries.is_empty())) {
            let mut at = entry;
            loop {
                seen += 1;
                let arriving = sketch.halves[at].twin?;
                match sketch.halves[arriving].next {
                    Some(next) if next == entry => break,
                    Some(next) => at = next,
                    None => {
                        exits.push(arriving);
                        break;
                    }
                }
            }
        }
        if seen != spokes.len() || exits.len() != entries.len() {
            return None;
        }
        if !entries.is_empty() {
            all.push(cycles(&entries, &exits));
        }
    }
    Some(all)
}

/// The ways to join chains, given by their entries and exits, into one cycle.
fn cycles(entries: &[usize], exits: &[usize]) -> Ways {
    let mut ways = Vec::new();
    let mut order: Vec<_> = (0..entries.len()).collect();
    loop {
        let joins = (0..order.len()).map(|at| Join {
            arrives: exits[order[at]],
            leaves: entries[order[(at + 1) % order.len()]],
        });
        ways.push(joins.collect());
        if ways.len() == MOST_WAYS || !next_order(&mut order[1..]) {
            return ways;
        }
    }
}

/// The next order of some numbers; false after the last.
fn next_order(order: &mut [usize]) -> bool {
    let Some(drop) = (1..order.len()).rev().find(|&at| order[at - 1] < order[at]) else {
        return false;
    };
    let pivot = order[drop - 1];
    let above = (drop..order.len()).rev().find(|&at| order[at] > pivot);
    let above = above.expect("what follows the pivot rises first");
    order.swap(drop - 1, above);
    order[drop..].reverse();
    true
}

/// The arcs of a case of law 7 in a sketch, and the arcs inside its paths.
pub(super) fn joins_of(sketch: &Sketch, arcs: &[Arc]) -> Option<Vec<Join>> {
    let run = |name: NameId| &sketch.runs[name.index()];
    let twin = |half: usize| sketch.halves[half].twin;
    let mut joins = Vec::new();
    for arc in arcs {
        let exit = match arc.from {
            Port::Out(item) => match sketch.half_of[item.index()] {
                Some(half) => twin(half)?,
                None => match run(item).first() {
                    Some(&first) => twin(first)?,
                    // An empty path is an arc from its start to its end, and nothing else.
                    None if arc.to == Port::In(item) => continue,
                    None => return None,
                },
            },
            Port::In(item) => sketch.half_of[item.index()]?,
        };
        let entry = match arc.to {
            Port::In(item) => match sketch.half_of[item.index()] {
                Some(half) => twin(half)?,
                None => twin(*run(item).last()?)?,
            },
            Port::Out(item) => sketch.half_of[item.index()]?,
        };
        // An arc of length zero is none.
        let inner = |half: usize| sketch.halves[half].face.is_some();
        if !inner(exit) && !inner(entry) {
            joins.push(Join { arrives: exit, leaves: entry });
        }
    }
    for vertex in ways(sketch)? {
        let Join { arrives, .. } = *vertex.first()?.first()?;
        if vertex.len() == 1 && joins.iter().all(|join| join.arrives != arrives) {
            joins.extend(&vertex[0]);
        }
    }
    Some(joins)
}

impl Sketch {
    /// Closes the outside.
    pub fn close(&mut self, joins: &[Join], further: Further) {
        for (at, join) in joins.iter().enumerate() {
            let vertex = self.halves[join.leaves].origin;
            let named = matches!(self.vertices[vertex], VertexRole::Named(_));
            let count = match further {
                Further::In(place, count) if place == at => count,
                Further::Everywhere => 1,
                Further::Nowhere | Further::In(..) => 0,
            };
            let mut arrives = join.arrives;
            for _ in 0..if named { count } else { 0 } {
                let spoke = self.add(HalfedgeRole::Further(vertex), vertex);
                let back = self.fresh_twin(spoke);
                self.link(arrives, spoke);
                self.link(spoke, back);
                arrives = back;
            }
            self.link(arrives, join.leaves);
        }
    }
}
