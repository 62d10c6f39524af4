//! Places of the new vertices that split a vertex.
//!
//! Such a vertex takes over some of the strands of an old one, to which an edge joins it. It goes
//! towards these strands and away from those that stay, so that the edge between the two vertices
//! opens in the direction in which the strands part.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;

use super::curve::mean;
use super::figure::{Figure, Node, Side};
use crate::diagram::NameId;

/// The maximum length of the edge that opens.
const OPEN: f64 = 0.7;

/// A vertex that is split: the strands that change over to the new vertex, and those that stay. A
/// strand is given by the node that comes next on it, and whether the strand ends there.
pub(super) struct Opened {
    from: usize,
    taken: BTreeSet<(usize, bool)>,
    left: BTreeSet<(usize, bool)>,
}

/// The vertex that a new node splits, if there is one and at least two strands change over.
pub(super) fn opened(figure: &Figure, new: usize) -> Option<Opened> {
    let (old, now) = (ends(&figure.before), ends(&figure.after));
    let here = now.iter().filter(|(_, (at, _))| *at == new);
    let moved: Vec<_> = here.filter_map(|(end, _)| old.get(end).copied()).collect();
    let &(from, _) = moved.first()?;
    let is_joined = now.values().any(|&end| end == (new, (from, true)));
    let is_one = moved.iter().all(|&(at, _)| at == from);
    let taken: BTreeSet<_> = moved.iter().map(|&(_, next)| next).collect();
    let left = old.values().filter(|(at, next)| *at == from && !taken.contains(next));
    let left = left.map(|&(_, next)| next).collect();
    (is_joined && is_one && taken.len() > 1).then_some(Opened { from, taken, left })
}

/// The node at each end of each item, its start (`true`) or its end; and the node that comes next,
/// with whether it is the other end.
fn ends(side: &Side) -> BTreeMap<(NameId, bool), (usize, (usize, bool))> {
    let mut ends = BTreeMap::new();
    for strand in &side.strands {
        let nodes = &strand.nodes;
        let (last, is_short) = (nodes.len() - 1, nodes.len() == 2);
        for (item, forward) in strand.items.iter().zip([true, false]) {
            if let Some(item) = *item {
                ends.insert((item, forward), (nodes[0], (nodes[1], is_short)));
                ends.insert((item, !forward), (nodes[last], (nodes[last - 1], is_short)));
            }
        }
    }
    ends
}

/// Places the new vertices that split a vertex beside it.
pub(super) fn open_vertices(
    figure: &Figure,
    before: &[Option<DVec2>],
    places: &mut [Option<DVec2>],
) {
    for new in 0..places.len() {
        if places[new].is_some() || !matches!(figure.nodes[new], Node::Vertex(_)) {
            continue;
        }
        let Some(Opened { from, taken, left }) = opened(figure, new) else { continue };
        let (Some(root), Some(at)) = (before[from], places[from]) else { continue };
        let way = |&(node, _): &(usize, bool)| before[node].map(|next| next - root);
        let towards = |nodes: &BTreeSet<_>| {
            mean(&nodes.iter().filter_map(way).map(DVec2::normalize_or_zero).collect::<Vec<_>>())
        };
        let away = (towards(&taken) - towards(&left)).normalize_or_zero();
        // The edges that change over keep half of their length.
        let edges = taken.iter().filter(|(_, is_end)| *is_end).filter_map(way);
        let length = edges.map(|way| way.length() / 2.0).fold(OPEN, f64::min);
        places[new] = (away != DVec2::ZERO).then(|| at + away * length);
    }
}
