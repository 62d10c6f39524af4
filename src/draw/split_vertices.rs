//! Vertices that are drawn twice, like those of a pillow that is cut open.
//!
//! The outside passes a vertex twice if loops that are connected along edges meet again there, and
//! what lies between them is not drawn. With one dot for it the loops would have to be bent around
//! each other; textbooks draw two dots of the same name. The same holds for loops that meet at
//! several vertices without an edge between them. A vertex whose spokes are listed has one dot,
//! since their order is drawn around it.

use std::collections::BTreeMap;

use super::components::{join, strand_blocks};
use super::figure::{Figure, Node, Side};
use crate::diagram::NameId;

/// The node at the start (`true`) and at the end (`false`) of each item at such a vertex.
pub(super) type Copies = BTreeMap<(NameId, bool), usize>;

/// Gives the vertices of `before` that are drawn several times more nodes, and moves strands to
/// them.
pub(super) fn split(figure: &mut Figure, side: &mut Side) -> Copies {
    let (sector, block) = (sectors(side), strand_blocks(side));
    let rule = figure.drawing.rule;
    let stars = rule.before.stars.iter().chain(&rule.after.stars);
    let listed: Vec<_> = stars.map(|star| star.vertex.name).collect();
    let mut copies = Copies::new();
    let in_loops: Vec<_> = side.loop_of().chunks(2).map(|of| of != [None, None]).collect();
    // The blocks that vertices with one dot hold together.
    let mut held: Vec<usize> = (0..side.strands.len()).collect();
    for &name in &listed {
        let ends: Vec<_> = figure.vertex(name).map_or(Vec::new(), |node| ends_at(side, node));
        for pair in ends.windows(2) {
            join(&mut held, block[pair[0] / 2], block[pair[1] / 2]);
        }
    }
    for node in 0..figure.nodes.len() {
        let Node::Vertex(name) = figure.nodes[node] else { continue };
        let ends = ends_at(side, node);
        if listed.contains(&name) {
            continue;
        }
        // The node of each sector; the first sector of each block keeps the vertex's own, unless
        // the block is held elsewhere.
        let mut nodes: BTreeMap<usize, usize> = BTreeMap::new();
        let mut seen = Vec::new();
        for &end in &ends {
            let of = block[end / 2];
            nodes.entry(sector[end]).or_insert_with(|| {
                let is_held = |&other: &usize| held[other] == held[of];
                let is_elsewhere = in_loops[end / 2] && seen.iter().any(is_held);
                if seen.contains(&of) || is_elsewhere {
                    figure.nodes.push(Node::Vertex(name));
                    return figure.nodes.len() - 1;
                }
                seen.push(of);
                node
            });
        }
        for pair in seen.windows(2) {
            join(&mut held, pair[0], pair[1]);
        }
        if nodes.values().all(|&other| other == node) {
            continue;
        }
        for end in ends {
            let at = nodes[&sector[end]];
            put(side, end, at);
            copies.extend(items(side, end).map(|key| (key, at)));
        }
    }
    copies
}

/// Moves the strands of `after` to the nodes that they have in `before`.
pub(super) fn follow(figure: &Figure, side: &mut Side, copies: &Copies) {
    let sector = sectors(side);
    for node in 0..figure.nodes.len() {
        let ends = ends_at(side, node);
        for &end in &ends {
            let beside = ends.iter().filter(|&&other| sector[other] == sector[end]);
            let keys: Vec<_> = beside.flat_map(|&other| items(side, other)).collect();
            let known = keys.iter().find_map(|key| copies.get(key).copied());
            if let Some(at) = known.filter(|&at| figure.nodes[at] == figure.nodes[node]) {
                put(side, end, at);
            }
        }
    }
}

/// The ends of strands at a node: strand `n` has the ends `2n` and `2n + 1`.
fn ends_at(side: &Side, node: usize) -> Vec<usize> {
    let ends = side.strands.iter().enumerate().flat_map(|(at, strand)| {
        let [from, to] = strand.ends();
        [(2 * at, from), (2 * at + 1, to)]
    });
    ends.filter(|&(_, at)| at == node).map(|(end, _)| end).collect()
}

fn put(side: &mut Side, end: usize, node: usize) {
    let nodes = &mut side.strands[end / 2].nodes;
    match end % 2 {
        0 => nodes[0] = node,
        _ => *nodes.last_mut().expect("a strand has ends") = node,
    }
}

/// The items that start (`true`) or end there.
fn items(side: &Side, end: usize) -> impl Iterator<Item = (NameId, bool)> {
    let [along, back] = side.strands[end / 2].items;
    let is_start = end.is_multiple_of(2);
    [along.map(|item| (item, is_start)), back.map(|item| (item, !is_start))].into_iter().flatten()
}

/// The sector of each end of a strand: ends with a drawn corner between them are in the same
/// sector.
fn sectors(side: &Side) -> Vec<usize> {
    let mut sector: Vec<usize> = (0..2 * side.strands.len()).collect();
    for orbit in &side.loops {
        let next = orbit.darts.iter().cycle().skip(1);
        for (&dart, &next) in orbit.darts.iter().zip(next) {
            // The other end of a strand has the number that differs in the last bit.
            join(&mut sector, dart.index() ^ 1, next.index());
        }
    }
    sector
}
