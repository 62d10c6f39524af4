//! Where the vertices of an example go: one that was done to a mesh, not drawn by a person.
//!
//! On a flat mesh they lie where they do there. On another one they are placed as those of any
//! drawing, but for what the op moves: that goes to the middle of its neighbours.

use glam::DVec2;

use super::assigned::assigned;
use super::figure::{Figure, Node};
use super::place::{pulls, settle};
use crate::diagram::{Access, NameId};

/// The places of a flat mesh, in units of half its height or width.
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

/// The places of `after`.
pub(super) fn moved(figure: &Figure, places: &[DVec2]) -> Vec<DVec2> {
    let rule = figure.drawing.rule;
    if rule.example.is_none() {
        return places.to_vec();
    }
    if let Some(on_mesh) = on_mesh(figure, 1) {
        let place = |(node, &at): (&Node, &DVec2)| match *node {
            Node::Vertex(name) => on_mesh(name).unwrap_or(at),
            Node::Bend | Node::Loose => at,
        };
        return figure.nodes.iter().zip(places).map(place).collect();
    }
    let before = &figure.before;
    let loops = before.loop_of();
    let is_outside = |node: usize| {
        let mut strands = before.strands.iter().enumerate();
        strands.any(|(at, strand)| {
            let sides = [loops[2 * at], loops[2 * at + 1]];
            strand.nodes.contains(&node) && sides.contains(&None)
        })
    };
    let known: Vec<_> = places.iter().copied().map(Some).collect();
    let told = assigned(figure, &known);
    let is_set = |name: NameId| {
        let mut set = rule.assignments.iter();
        set.any(|set| set.target.name == name && set.attribute == Access::Position)
    };
    let mut all = known;
    for (node, at) in all.iter_mut().enumerate() {
        let Node::Vertex(name) = figure.nodes[node] else {
            continue;
        };
        if before.shown.contains(&name) && is_set(name) && !is_outside(node) {
            let told = told.iter().find(|(of, _)| *of == name);
            *at = told.map(|(_, at)| *at);
        }
    }
    settle(&figure.after, &mut all, &pulls(&figure.after));
    let all = all.into_iter().zip(places);
    all.map(|(to, at)| to.unwrap_or(*at)).collect()
}
