//! Places of the vertices of an example: an operation applied to an actual mesh, not drawn by a
//! person.
//!
//! On a flat mesh the vertices have their positions there. On any other mesh they are laid out as
//! in any drawing, and a vertex that the op moves to a place that the drawing does not determine
//! goes to the centroid of its neighbors.

use glam::DVec2;

use super::assigned::assigned;
use super::figure::{Figure, Node};
use crate::diagram::{Access, NameId};

/// The places on a flat mesh, in units of half its larger extent.
pub(super) fn flat(figure: &Figure) -> Option<Vec<Option<DVec2>>> {
    let places = on_mesh(figure, 0)?;
    let is_flat = |node: &Node| match *node {
        Node::Vertex(name) => !figure.before.shown.contains(&name) || places(name).is_some(),
        Node::Bend | Node::Loose => true,
    };
    let place = |node: &Node| match *node {
        Node::Vertex(name) => places(name),
        Node::Bend | Node::Loose => None,
    };
    let all: Vec<_> = figure.nodes.iter().map(place).collect();
    let is_known = all.iter().any(Option::is_some);
    (is_known && figure.nodes.iter().all(is_flat)).then_some(all)
}

/// The place of each vertex on one side, if the mesh is flat.
fn on_mesh<'f>(figure: &'f Figure, side: usize) -> Option<impl Fn(NameId) -> Option<DVec2> + 'f> {
    let places = &figure.drawing.rule.example.as_ref()?.places;
    let known = places[0].iter().flatten().map(|&at| DVec2::from(at));
    let low = known.clone().reduce(DVec2::min)?;
    let high = known.reduce(DVec2::max)?;
    let (center, size) = ((low + high) / 2.0, (high - low).max_element().max(1e-9));
    Some(move |name: NameId| {
        let at = DVec2::from((*places[side].get(name.index())?)?);
        let at = (at - center) * (2.0 / size);
        Some(DVec2::new(at.x, -at.y))
    })
}

/// The places after the operation's moves, if it was applied to a mesh.
pub(super) fn moved_on_mesh(
    figure: &Figure,
    before: &[Option<DVec2>],
) -> Option<Vec<Option<DVec2>>> {
    let rule = figure.drawing.rule;
    rule.example.as_ref()?;
    let side = &figure.before;
    let loops = side.loop_of();
    let is_outside = |node: usize| {
        side.strands.iter().enumerate().any(|(at, strand)| {
            let sides = [loops[2 * at], loops[2 * at + 1]];
            strand.nodes.contains(&node) && sides.contains(&None)
        })
    };
    let on_mesh = on_mesh(figure, 1);
    let told = assigned(figure, before);
    let is_set = |name: NameId| {
        let mut set = rule.assignments.iter();
        set.any(|set| set.target.name == name && set.attribute == Access::Position)
    };
    let place = |(node, &at): (usize, &Option<DVec2>)| match (figure.nodes[node], &on_mesh) {
        (Node::Vertex(name), Some(on_mesh)) => on_mesh(name).or(at),
        (Node::Vertex(name), None) if is_set(name) && !is_outside(node) => {
            let told = told.iter().find(|(of, _)| *of == name);
            // New vertices must not coincide with others: they are placed later.
            told.map(|(_, at)| *at).filter(|_| at.is_some())
        }
        _ => at,
    };
    Some(before.iter().enumerate().map(place).collect())
}
