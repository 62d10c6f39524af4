//! Places of the nodes of `after`.
//!
//! A vertex keeps its place unless the operation moves it to one that the drawing determines, such
//! as the midpoint of a collapsed edge. Nodes that are only in `after` are placed among the
//! existing ones: at the position that an assignment gives, on an edge that they cut, or beside a
//! vertex that they split. Where strands cross, vertices coincide or loops are flat because
//! vertices move or keep their places, the next best of these is taken: they keep them, or the side
//! is laid out anew.

use std::iter::once_with;

use glam::DVec2;

use super::assigned::assigned;
use super::components::parts;
use super::curve::{Curve, area, crossings, mean};
use super::example::moved_on_mesh;
use super::figure::{Figure, Node, Strand};
use super::layout::{NEAR, arrange, parts_in_a_row, pulls};
use super::opened::{open_vertices, opened};
use super::routing::{bend_beside, bend_paths};

/// Twice the area of a loop that looks flat.
const FLAT: f64 = 0.15;

/// The height of a triangle on an edge, as a multiple of the edge's length.
const EAR: f64 = 0.5;

/// The least factor by which a side that is laid out anew is scaled.
const LEAST_SCALE: f64 = 0.5;

/// The places of the nodes on the side `after`; nodes that it does not show keep theirs.
pub(super) fn places_after(figure: &Figure, before: &[Option<DVec2>]) -> Vec<Option<DVec2>> {
    let all_stay = || placed(figure, before, before.to_vec());
    // What is broken is seen best where it was whole.
    if figure.drawing.rule.broken.is_some() {
        return all_stay();
    }
    if let Some(moved) = moved_on_mesh(figure, before) {
        return placed(figure, before, moved);
    }
    let moved = moved(figure, before).map(|moved| placed(figure, before, moved));
    let anew = || placed(figure, before, laid_out_anew(figure, before));
    let candidates = moved.into_iter().chain(once_with(all_stay)).chain(once_with(anew));
    let (mut least, mut best) = (usize::MAX, Vec::new());
    for places in candidates {
        let count = faults(figure, &places);
        if count < least {
            (least, best) = (count, places);
        }
        if least == 0 {
            break;
        }
    }
    best
}

/// The places of a layout that does not depend on `before`, but is turned towards it.
fn laid_out_anew(figure: &Figure, before: &[Option<DVec2>]) -> Vec<Option<DVec2>> {
    let mut swapped = figure.clone();
    std::mem::swap(&mut swapped.before, &mut swapped.after);
    let mut places = parts_in_a_row(&swapped);
    let pairs: Vec<_> =
        before.iter().zip(&places).filter_map(|(a, b)| Some([(*a)?, (*b)?])).collect();
    let [old, new] = [0, 1].map(|at| mean(&pairs.iter().map(|pair| pair[at]).collect::<Vec<_>>()));
    // The turn with the least sum of squared distances.
    let turn: DVec2 =
        pairs.iter().map(|[a, b]| (*a - old).rotate((*b - new) * DVec2::new(1.0, -1.0))).sum();
    // It shrinks, by half at most, such that edges on both sides are on average as long as before.
    let length = |strand: &Strand, places: &[Option<DVec2>]| {
        let [from, to] = strand.ends().map(|end| places[end]);
        Some(from?.distance(to?))
    };
    let (mut earlier, mut later) = (0.0, 0.0);
    for strand in figure.after.strands.iter().filter(|strand| !strand.is_path) {
        let is_same = |old: &&Strand| {
            !old.is_path
                && old.items.iter().any(|item| item.is_some() && strand.items.contains(item))
        };
        if let Some(old) = figure.before.strands.iter().find(is_same)
            && let (Some(before), Some(after)) = (length(old, before), length(strand, &places))
        {
            (earlier, later) = (earlier + before, later + after);
        }
    }
    let is_known = earlier.min(later) > NEAR;
    let scale = if is_known { (earlier / later).clamp(LEAST_SCALE, 1.0) } else { 1.0 };
    let turn = turn.normalize_or(DVec2::X) * scale;
    for place in places.iter_mut().flatten() {
        *place = old + turn.rotate(*place - new);
    }
    // Paths bend as they did.
    for strand in figure.after.strands.iter().filter(|strand| strand.is_path) {
        strand.nodes[1..strand.nodes.len() - 1].iter().for_each(|&bend| places[bend] = None);
    }
    places
}

/// The places after the operation's moves; `None` if it moves nothing. Paths that begin or end at a
/// moved node lose the places of their bends.
fn moved(figure: &Figure, before: &[Option<DVec2>]) -> Option<Vec<Option<DVec2>>> {
    // Parts are laid out side by side arbitrarily: a point between them has no meaning.
    if parts(figure, &figure.before).len() > 1 {
        return None;
    }
    let mut places = before.to_vec();
    for (name, to) in assigned(figure, before) {
        let nodes: Vec<_> = figure.nodes_of(name).collect();
        // A vertex that is drawn several times has no single place.
        if let [node] = nodes[..]
            && before[node].is_some_and(|from| (from - to).length() > NEAR)
        {
            places[node] = Some(to);
        }
    }
    let way = |node: usize| Some(places[node]? - before[node]?);
    let mut bends = Vec::new();
    for strand in &figure.after.strands {
        let ways = strand.ends().map(|end| way(end).unwrap_or_default());
        if ways != [DVec2::ZERO; 2] {
            let inner = &strand.nodes[1..strand.nodes.len() - 1];
            let by = (ways[0] + ways[1]) / 2.0;
            bends.extend(inner.iter().map(|&bend| (bend, by, strand.is_path)));
        }
    }
    for (bend, by, is_path) in bends {
        places[bend] = places[bend].filter(|_| !is_path).map(|at| at + by);
    }
    (places != before).then_some(places)
}

/// The number of pairs of strands that cross and of vertices that look like one, plus the number of
/// loops that are flat or turned inside out.
fn faults(figure: &Figure, places: &[Option<DVec2>]) -> usize {
    let side = &figure.after;
    let at = |node: &usize| places[*node].unwrap_or_default();
    let curve = |nodes: &[usize]| Curve::smooth(&nodes.iter().map(at).collect::<Vec<_>>());
    let curves: Vec<_> = side.strands.iter().map(|of| curve(&of.nodes)).collect();
    let loops = side.loops.iter().map(|orbit| side.around(&orbit.darts));
    let outlines = loops.map(|nodes| nodes.iter().map(at).collect::<Vec<_>>());
    let shown = side.shown.iter().flat_map(|&vertex| figure.nodes_of(vertex));
    let shown: Vec<_> = shown.map(|node| at(&node)).collect();
    let near = |nth: usize| {
        shown[..nth].iter().filter(|other| shown[nth].distance(**other) < NEAR).count()
    };
    (0..shown.len()).map(near).sum::<usize>()
        + crossings(&curves)
        + outlines.filter(|outline| area(outline) < FLAT).count()
}

/// Places the nodes that have no place yet.
fn placed(
    figure: &Figure,
    before: &[Option<DVec2>],
    mut places: Vec<Option<DVec2>>,
) -> Vec<Option<DVec2>> {
    for (name, at) in assigned(figure, before) {
        let is_taken = places.iter().flatten().any(|other| (*other - at).length() < NEAR);
        if let Some(node) = figure.vertex(name)
            && places[node].is_none()
            && !is_taken
        {
            places[node] = Some(at);
        }
    }
    cut_edges(figure, &mut places);
    open_vertices(figure, before, &mut places);
    bend_paths(figure, before, &mut places);
    let side = &figure.after;
    let mut all = places.clone();
    arrange(side, &mut all, &pulls(side));
    raise_ears(figure, &places, &mut all);
    for (place, at) in places.iter_mut().zip(&all) {
        *place = place.or(*at);
    }
    // Nodes that are connected to nothing go in a row below.
    let low = places.iter().flatten().map(|at| at.y).fold(0.0, f64::max);
    let mut x = 0.0;
    for (node, place) in places.iter_mut().enumerate() {
        if place.is_none() && figure.nodes[node] != Node::Bend {
            *place = Some(DVec2::new(x, low + 0.7));
            x += 0.7;
        }
    }
    bend_beside(figure, &mut places);
    places
}

/// Raises the tips of triangles on edges that have their places: as far as there is room in the
/// loop on their other side.
fn raise_ears(figure: &Figure, fixed: &[Option<DVec2>], places: &mut [Option<DVec2>]) {
    let side = &figure.after;
    let rings: Vec<_> = side.loops.iter().map(|orbit| side.around(&orbit.darts)).collect();
    for ear in rings.iter().filter(|ring| ring.len() == 3) {
        let mut free = (0..3).filter(|&at| fixed[ear[at]].is_none());
        let (Some(at), None) = (free.next(), free.next()) else { continue };
        let [tip, a, b] = [0, 1, 2].map(|step| ear[(at + step) % 3]);
        let degree = side.strands.iter().filter(|strand| strand.ends().contains(&tip)).count();
        let mut others = rings.iter().filter(|ring| ring.len() > 3 && ring.contains(&tip));
        let (2, Some(other)) = (degree, others.next()) else { continue };
        let ends = [a, b].map(|end| places[end]);
        let around: Vec<_> = other.iter().filter_map(|&node| fixed[node]).collect();
        if let [Some(a), Some(b)] = ends {
            let base = (a + b) / 2.0;
            let up = (a - b).perp().normalize_or_zero();
            let room = up.dot(mean(&around) - base);
            if room > 0.0 {
                places[tip] = Some(base + up * room.min(EAR * a.distance(b)));
            }
        }
    }
}

/// Places the new vertices that split an edge on that edge.
fn cut_edges(figure: &Figure, places: &mut [Option<DVec2>]) {
    for strand in figure.after.strands.iter().filter(|strand| !strand.is_path) {
        let mut earlier = figure.before.strands.iter();
        let old = earlier.find(|old| strand.edge.is_some() && old.edge == strand.edge);
        let Some(old) = old else { continue };
        let [a, b] = old.ends();
        let [from, to] = strand.ends();
        let (cut, far) = match () {
            () if from == a => (to, b),
            () if to == a => (from, b),
            () if from == b => (to, a),
            () if to == b => (from, a),
            () => continue,
        };
        let joins = |from: usize, to: usize| {
            let mut others = figure.after.strands.iter();
            others.any(|other| [[from, to], [to, from]].contains(&other.ends()))
        };
        // Where an edge still joins the ends, a vertex was split instead.
        let is_parted = joins(cut, far) && !joins(a, b);
        let middle = old.nodes.len() / 2;
        if let (Some(a), Some(b)) = (places[old.nodes[middle - 1]], places[old.nodes[middle]])
            && is_parted
            && places[cut].is_none()
            && opened(figure, cut).is_none()
        {
            places[cut] = Some(if old.nodes.len() % 2 == 0 { (a + b) / 2.0 } else { b });
        }
    }
}
