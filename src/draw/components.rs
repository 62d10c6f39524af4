//! Connected components: of nodes along strands, and of strands and loops along each other.

use super::figure::{Figure, Node, Side};

/// Merges the groups of `a` and `b`; a group has the number of its least member.
pub(super) fn join(group: &mut [usize], a: usize, b: usize) {
    let (a, b) = (group[a], group[b]);
    for of in group {
        if *of == a.max(b) {
            *of = a.min(b);
        }
    }
}

/// The nodes of each connected component of a side, along strands; only nodes that are shown.
pub(super) fn parts(figure: &Figure, side: &Side) -> Vec<Vec<usize>> {
    let mut part: Vec<usize> = (0..figure.nodes.len()).collect();
    for strand in &side.strands {
        for pair in strand.nodes.windows(2) {
            join(&mut part, pair[0], pair[1]);
        }
    }
    let shown = |node: usize| match figure.nodes[node] {
        Node::Vertex(name) => side.shown.contains(&name),
        _ => side.strands.iter().any(|strand| strand.nodes.contains(&node)),
    };
    let roots = (0..part.len()).filter(|&node| part[node] == node);
    let nodes = |root: usize| {
        let nodes = (0..part.len()).filter(|&node| part[node] == root);
        nodes.filter(|&node| shown(node)).collect::<Vec<_>>()
    };
    roots.map(nodes).filter(|nodes| !nodes.is_empty()).collect()
}

/// The block of each strand: loops that share strands are in one block.
pub(super) fn strand_blocks(side: &Side) -> Vec<usize> {
    let mut block: Vec<usize> = (0..side.strands.len()).collect();
    for orbit in &side.loops {
        for pair in orbit.darts.windows(2) {
            join(&mut block, pair[0].strand, pair[1].strand);
        }
    }
    block
}

/// The blocks of loops in a part: for each, the side with only its loops, and the nodes around
/// them.
pub(super) fn blocks(side: &Side, part: &[usize]) -> Vec<(Side, Vec<usize>)> {
    let block = strand_blocks(side);
    let mut blocks: Vec<(usize, Side, Vec<usize>)> = Vec::new();
    for orbit in &side.loops {
        let first = orbit.darts.first();
        let Some(&first) = first.filter(|&&dart| part.contains(&side.nodes(dart)[0])) else {
            continue;
        };
        let of = block[first.strand];
        let at = blocks.iter().position(|(other, ..)| *other == of).unwrap_or_else(|| {
            let loops = Vec::new();
            blocks.push((of, Side { loops, ..side.clone() }, Vec::new()));
            blocks.len() - 1
        });
        let (_, here, nodes) = &mut blocks[at];
        here.loops.push(orbit.clone());
        nodes.extend(side.around(&orbit.darts));
    }
    let sorted = |(_, side, mut nodes): (usize, Side, Vec<usize>)| {
        nodes.sort_unstable();
        nodes.dedup();
        (side, nodes)
    };
    blocks.into_iter().map(sorted).collect()
}
