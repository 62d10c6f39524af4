//! Places of the nodes of a figure.
//!
//! The outside becomes a convex polygon, and each inner node goes to the centroid of its neighbors
//! (W. T. Tutte, "How to draw a graph", 1963), with a node in every loop to hold it open: then no
//! two strands cross. The edge an operation is called with is horizontal, from left to right.
//! Lengths are in units of the polygon's radius. Where `after` differs is in
//! [`after_layout`](super::after_layout).

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::after_layout::places_after;
use super::components::{blocks, parts};
use super::curve::{bounds, direction, mean};
use super::example::flat;
use super::family_sector::sector;
use super::figure::{Dart, Figure, Node, Side};
use super::hanging::{SPUR, hang};
use super::outer::outside;
use crate::diagram::{Drawing, Kind, NameId, Spoke};

/// The number of relaxation sweeps.
const SWEEPS: usize = 600;
/// The length of a path, as a multiple of an edge's.
const PATH_WEIGHT: f64 = 2.0;
/// The greatest ratio of the parts of the outside on the two sides of an edge that divides it in
/// halves.
const EVEN: f64 = 1.5;
/// How many times more strongly the loops beside parallel edges pull at their bends.
const LENS: usize = 4;
/// Nodes nearer to each other than this look like one.
pub(super) const NEAR: f64 = 0.12;

/// The place of every node on both sides.
pub(super) fn places(figure: &Figure) -> [Vec<DVec2>; 2] {
    let mut before = flat(figure).unwrap_or_else(|| parts_in_a_row(figure));
    turn_sector(figure, &mut before);
    let after = places_after(figure, &before);
    let before = before.into_iter().zip(&after).map(|(before, after)| before.or(*after));
    [before.collect(), after].map(|places: Vec<Option<DVec2>>| {
        places.into_iter().map(Option::unwrap_or_default).collect()
    })
}

/// The places of `before`: connected components stand side by side.
pub(super) fn parts_in_a_row(figure: &Figure) -> Vec<Option<DVec2>> {
    let mut places = vec![None; figure.nodes.len()];
    let parts = parts(figure, &figure.before);
    let mut x = 0.0;
    for (at, part) in parts.iter().enumerate() {
        place_blocks(figure, part, &mut places);
        face_others(figure, &parts, at, &mut places);
        let (low, high) = bounds(part.iter().filter_map(|&node| places[node]));
        for &node in part {
            places[node] = places[node].map(|at| at + DVec2::X * (x - low.x));
        }
        x += (high - low).x.max(0.0) + 0.9;
    }
    level_main(figure, &mut places);
    places
}

/// Turns a connected component so that the nodes that `after` joins to other components face those:
/// earlier ones are to the left, later ones to the right.
fn face_others(figure: &Figure, parts: &[Vec<usize>], at: usize, places: &mut [Option<DVec2>]) {
    let part_of = |node: usize| parts.iter().position(|part| part.contains(&node));
    let mut way = DVec2::ZERO;
    let mut joined = Vec::new();
    for strand in &figure.after.strands {
        let [from, to] = strand.ends();
        for (here, there) in [(from, to), (to, from)] {
            if let (Some(part), Some(other)) = (part_of(here), part_of(there))
                && part == at
                && other != at
                && let Some(place) = places[here]
            {
                way += DVec2::X * if other > at { 1.0 } else { -1.0 };
                joined.push(place);
            }
        }
    }
    let placed: Vec<_> = parts[at].iter().filter_map(|&node| places[node]).collect();
    let there = mean(&joined) - mean(&placed);
    if !joined.is_empty() && way != DVec2::ZERO && there.length() > NEAR {
        let turn = DVec2::from_angle(there.angle_to(way));
        for &node in &parts[at] {
            places[node] = places[node].map(|place| turn.rotate(place));
        }
    }
}

/// Turns a figure so that the edge an operation is called with is horizontal, unless the outside
/// determines its direction.
fn level_main(figure: &Figure, places: &mut [Option<DVec2>]) {
    let side = &figure.before;
    let Some(main) = main_dart(figure).filter(|_| figure.drawing.rule.size().is_none()) else {
        return;
    };
    let among = |_: usize| true;
    let ring = side.around(&outside(figure, side, &among));
    let nodes = side.nodes(main);
    let ends = [nodes[0], nodes[nodes.len() - 1]];
    let [Some(from), Some(to)] = ends.map(|end| places[end]) else { return };
    let is_inside = !ends.iter().any(|end| ring.contains(end));
    let times = |end: &usize| ring.iter().filter(|node| *node == end).count();
    // An edge with the outside on both sides may have any direction.
    let is_between = ends.iter().all(|end| times(end) > 1);
    if (is_inside || is_between) && (to - from).length() > NEAR {
        let turn = DVec2::from_angle((to - from).angle_to(DVec2::X));
        for place in places.iter_mut().flatten() {
            *place = turn.rotate(*place);
        }
    }
}

/// Turns a figure with families so that the sector that stands out is at the bottom.
fn turn_sector(figure: &Figure, places: &mut [Option<DVec2>]) {
    let rule = figure.drawing.rule;
    if rule.size().is_none() {
        return;
    }
    let strong = sector(rule);
    let middle = |is_meant: &dyn Fn(NameId) -> bool| {
        let (mut sum, mut count) = (DVec2::ZERO, 0.0);
        for (node, place) in figure.nodes.iter().zip(&*places) {
            if let (Node::Vertex(name), Some(place)) = (node, place)
                && rule.is_member(*name)
                && is_meant(*name)
            {
                sum += *place;
                count += 1.0;
            }
        }
        (count > 0.0).then(|| sum / count)
    };
    let [Some(center), Some(there)] =
        [middle(&|_| true), middle(&|name: NameId| strong[name.index()])]
    else {
        return;
    };
    let way = there - center;
    if way.length() > NEAR {
        let turn = DVec2::from_angle(way.angle_to(DVec2::Y));
        for place in places.iter_mut().flatten() {
            *place = center + turn.rotate(*place - center);
        }
    }
}

/// The dart that is drawn horizontally: that of the first parameter that has one, or else the first
/// dart of the first loop.
fn main_dart(figure: &Figure) -> Option<Dart> {
    given_dart(figure).or_else(|| figure.before.loops.first()?.darts.first().copied())
}

/// The dart of the first parameter that has one.
fn given_dart(figure: &Figure) -> Option<Dart> {
    let Drawing { rule, before, .. } = &figure.drawing;
    rule.params.iter().flatten().find_map(|&name| {
        let item = match rule.kind(name) {
            Kind::Edge => before.edge_statement(name)?.halfedges[0].name,
            _ => name,
        };
        figure.before.darts[item.index()]
    })
}

/// Places a connected component: its blocks one after the other, each on the far side of the vertex
/// that it shares with those before.
fn place_blocks(figure: &Figure, part: &[usize], places: &mut [Option<DVec2>]) {
    let among = |node: usize| part.contains(&node);
    let all = blocks(&figure.before, part);
    let Some((first, nodes)) = all.first() else {
        return place_part(figure, &figure.before, part, &[], places);
    };
    let nodes = if all.len() == 1 { part } else { nodes };
    place_part(figure, first, nodes, &outside(figure, first, &among), places);
    for (at, (side, nodes)) in all.iter().enumerate().skip(1) {
        let mut here = vec![None; places.len()];
        place_part(figure, side, nodes, &outside(figure, side, &among), &mut here);
        let joint = nodes.iter().find(|&&node| places[node].is_some());
        let Some((joint, root, from)) =
            joint.and_then(|&joint| Some((joint, places[joint]?, here[joint]?)))
        else {
            continue;
        };
        let away = bearing(figure, &all, at, joint, places);
        let turn = DVec2::from_angle((-from).normalize_or(DVec2::X).angle_to(away));
        for &node in nodes.iter().filter(|&&node| node != joint) {
            let place = here[node].map(|place| root + turn.rotate(place - from));
            places[node] = places[node].or(place);
        }
    }
}

/// The direction of a block from a node that it shares with earlier ones: the blocks around the
/// node divide the full turn, in the order of its spokes if that is drawn.
fn bearing(
    figure: &Figure,
    blocks: &[(Side, Vec<usize>)],
    at: usize,
    joint: usize,
    places: &[Option<DVec2>],
) -> DVec2 {
    let mut stars = figure.drawing.rule.before.stars.iter();
    let star = stars.find(|star| figure.nodes[joint] == Node::Vertex(star.vertex.name));
    let spoke = |side: &Side| {
        let darts = side.loops.iter().flat_map(|orbit| &orbit.darts);
        let starts = darts.filter(|&&dart| side.nodes(dart)[0] == joint);
        let item = |dart: &Dart| side.strands[dart.strand].items[usize::from(!dart.forward)];
        let items: Vec<_> = starts.filter_map(item).collect();
        let is_here = |spoke: &Spoke| spoke.halfedge().is_some_and(|half| items.contains(&half));
        star.and_then(|star| star.spokes.iter().position(is_here))
    };
    let is_here = |(_, (_, nodes)): &(usize, &(Side, Vec<usize>))| nodes.contains(&joint);
    let around = blocks.iter().enumerate().filter(is_here);
    let mut around: Vec<_> = around.map(|(at, (side, _))| (spoke(side), at)).collect();
    let first = around.first().map_or(at, |&(_, first)| first);
    around.sort_unstable();
    let rank = |block: usize| around.iter().position(|&(_, at)| at == block).unwrap_or(0);
    let steps = rank(at) as f64 - rank(first) as f64;
    let placed: Vec<_> = blocks[first].1.iter().filter_map(|&node| places[node]).collect();
    let way = (mean(&placed) - places[joint].unwrap_or_default()).normalize_or(-DVec2::X);
    // Counterclockwise, which is towards negative angles in a picture.
    way.rotate(DVec2::from_angle(-TAU * steps / around.len().max(1) as f64))
}

fn place_part(
    figure: &Figure,
    side: &Side,
    part: &[usize],
    walk: &[Dart],
    places: &mut [Option<DVec2>],
) {
    // Counterclockwise.
    let back = |dart: &Dart| Dart { strand: dart.strand, forward: !dart.forward };
    let outside: Vec<Dart> = walk.iter().rev().map(back).collect();
    let ring = side.around(&outside);
    let mut pulls = pulls(side);
    let mut all: Vec<Option<DVec2>> = places.to_vec();
    if ring.is_empty() {
        if let Some(center) = center_of_star(side, part) {
            let around = part.iter().filter(|&&node| node != center);
            let step = TAU / (part.len() - 1) as f64;
            places[center] = Some(DVec2::ZERO);
            for (at, &node) in around.enumerate() {
                places[node] = Some(direction(step * at as f64));
            }
            return;
        }
        let angle = |at: usize| PI - TAU * at as f64 / part.len() as f64;
        for (at, &node) in part.iter().enumerate() {
            places[node] = Some(direction(angle(at)));
        }
        return;
    }
    let angles = angles(figure, side, &outside, &ring);
    let mut once = ring.clone();
    once.sort_unstable();
    once.dedup();
    let simple = once.len() == ring.len() && ring.len() >= 3;
    for (&node, &angle) in ring.iter().zip(&angles) {
        if simple {
            all[node] = Some(direction(angle));
        } else {
            // A node that is passed twice cannot be in two places: a ring around the figure holds
            // it open instead.
            pulls.push((node, all.len()));
            all.push(Some(direction(angle) * 1.5));
        }
    }
    arrange(side, &mut all, &pulls);
    for &node in part {
        places[node] = all[node];
    }
}

/// The node that is an end of all strands of a part, if the part has more than two nodes.
fn center_of_star(side: &Side, part: &[usize]) -> Option<usize> {
    let strands = side.strands.iter();
    let strands: Vec<_> = strands.filter(|strand| part.contains(&strand.nodes[0])).collect();
    let is_center = |node: &&usize| strands.iter().all(|strand| strand.ends().contains(node));
    (part.len() > 2 && !strands.is_empty()).then(|| part.iter().find(is_center).copied()).flatten()
}

/// Lengthens spurs, and edges from a vertex to itself, so that they are readable.
fn stretch(side: &Side, places: &mut [Option<DVec2>], is_fixed: &dyn Fn(usize) -> bool) {
    let degree = |node: usize| {
        side.strands.iter().flat_map(|strand| strand.ends()).filter(|&end| end == node).count()
    };
    let loops = side.loop_of();
    let sides = |dart: usize| loops[dart].map(|at| side.loops[at].darts.len());
    for (at, strand) in side.strands.iter().enumerate() {
        let [from, to] = strand.ends();
        let bends = &strand.nodes[1..strand.nodes.len() - 1];
        let (root, ends, angles): (usize, Vec<usize>, &[f64]) = match bends {
            _ if strand.is_path && from != to => continue,
            [] if degree(to) == 1 => (from, vec![to], &[0.0]),
            [] if degree(from) == 1 => (to, vec![from], &[0.0]),
            [_, _] if from == to => (from, bends.to_vec(), &[0.42, -0.42]),
            [_, _, _] if from == to => (from, bends.to_vec(), &[0.6, 0.0, -0.6]),
            _ => continue,
        };
        let known: Option<Vec<_>> = ends.iter().map(|&end| places[end]).collect();
        let (Some(root), Some(known)) = (places[root], known) else { continue };
        if ends.iter().any(|&end| is_fixed(end)) {
            continue;
        }
        let away = mean(&known) - root;
        if away.length() < SPUR {
            let away = away.normalize_or(DVec2::X) * SPUR;
            // A loop that consists only of this strand lies inside; any other loop is outside of
            // it.
            let sign = match [sides(2 * at), sides(2 * at + 1)] {
                [Some(1), _] | [None, _] => 1.0,
                [Some(_), _] => -1.0,
            };
            for (&end, &angle) in ends.iter().zip(angles) {
                places[end] = Some(root + away.rotate(DVec2::from_angle(sign * angle)));
            }
        }
    }
}

/// The angle of each node of the outside.
fn angles(figure: &Figure, side: &Side, outside: &[Dart], ring: &[usize]) -> Vec<f64> {
    let mut weights = Vec::new();
    for dart in outside {
        let strand = &side.strands[dart.strand];
        let pieces = strand.nodes.len() - 1;
        let weight = if strand.is_path { PATH_WEIGHT } else { 1.0 };
        weights.extend(vec![weight / pieces as f64; pieces]);
    }
    let main = main_dart(figure);
    let ends = main.map(|dart| {
        let nodes = side.nodes(dart);
        [nodes[0], nodes[nodes.len() - 1]]
    });
    let place = |node: usize| ring.iter().position(|&other| other == node);
    let ends = ends.and_then(|[from, to]| Some([place(from)?, place(to)?]));
    let is_outside = |dart: Dart| outside.iter().any(|other| other.strand == dart.strand);
    let count = ring.len();
    let span = |from: usize, steps: usize| -> f64 {
        (0..steps).map(|step| weights[(from + step) % count]).sum()
    };
    // Edges all around have equal lengths rather than halves of unequal numbers; a path has any
    // length.
    let is_even = |below: usize| {
        let (most, least) = (below.max(count - below), below.min(count - below));
        let is_straight = |dart: &Dart| side.strands[dart.strand].nodes.len() == 2;
        !outside.iter().all(is_straight) || most as f64 <= EVEN * least as f64
    };
    let mut angles = vec![0.0; count];
    match (main, ends) {
        (Some(main), Some([from, to]))
            if from != to
                && !is_outside(main)
                && given_dart(figure).is_some()
                && is_even((to + count - from) % count) =>
        {
            // Half a turn below it, half a turn above it.
            for (start, end, angle) in [(from, to, PI), (to, from, TAU)] {
                let steps = (end + count - start) % count;
                let whole = span(start, steps);
                for step in 0..steps {
                    angles[(start + step) % count] = angle + PI * span(start, step) / whole;
                }
            }
        }
        (main, ends) => {
            // The main dart is at the bottom, or else some side.
            let start = ends.map_or(0, |[from, _]| from);
            let lead = match (main, ends) {
                (Some(dart), _) if is_outside(dart) => side.strands[dart.strand].nodes.len() - 1,
                (_, Some([from, to])) if from != to => (to + count - from) % count,
                _ => 1,
            };
            let whole = span(0, count);
            let first = -FRAC_PI_2 - PI * span(start, lead) / whole;
            for step in 0..count {
                angles[(start + step) % count] = first + TAU * span(start, step) / whole;
            }
        }
    }
    angles
}

/// The pairs of nodes that pull at each other along strands.
pub(super) fn pulls(side: &Side) -> Vec<(usize, usize)> {
    let pairs = side.strands.iter().flat_map(|strand| strand.nodes.windows(2));
    pairs.map(|pair| (pair[0], pair[1])).collect()
}

/// Places the nodes without a place: those that hang at one node around it, the others among those
/// that pull at them.
pub(super) fn arrange(side: &Side, places: &mut Vec<Option<DVec2>>, pulls: &[(usize, usize)]) {
    let fixed: Vec<_> = places.iter().map(Option::is_some).collect();
    settle(side, places, pulls);
    places.truncate(fixed.len());
    hang(side, pulls, &|node| fixed[node], places);
    let hung: Vec<_> = places.iter().map(Option::is_some).collect();
    settle(side, places, pulls);
    stretch(side, places, &|node| hung[node]);
}

/// Moves the nodes without a place to the centroid of the nodes that pull at them. Each loop gets a
/// center, appended to `places`.
fn settle(side: &Side, places: &mut Vec<Option<DVec2>>, pulls: &[(usize, usize)]) {
    let mut pulls = pulls.to_vec();
    for orbit in &side.loops {
        let center = places.len();
        places.push(None);
        pulls.extend(side.around(&orbit.darts).into_iter().map(|node| (node, center)));
    }
    let mut neighbors = vec![Vec::new(); places.len()];
    for (a, b) in pulls {
        if a != b {
            neighbors[a].push(b);
            neighbors[b].push(a);
        }
    }
    // Parallel edges leave room for a loop between them.
    let first = places.len() - side.loops.len();
    for (center, orbit) in (first..).zip(&side.loops) {
        let strands = || orbit.darts.iter().map(|dart| &side.strands[dart.strand].nodes);
        let mut bends = strands().flat_map(|nodes| &nodes[1..nodes.len() - 1]);
        if orbit.darts.len() > 2 || bends.any(|&bend| places[bend].is_some()) {
            for nodes in strands().filter(|nodes| nodes.len() == 3) {
                neighbors[nodes[1]].extend([center; LENS]);
            }
        }
    }
    let is_free = |&node: &usize| places[node].is_none() && !neighbors[node].is_empty();
    let free: Vec<_> = (0..places.len()).filter(is_free).collect();
    for _ in 0..SWEEPS {
        for &node in &free {
            let near = neighbors[node].iter().filter_map(|&other| places[other]);
            let (sum, count) =
                near.fold((DVec2::ZERO, 0.0), |(sum, count), at| (sum + at, count + 1.0));
            if count > 0.0 {
                places[node] = Some(sum / count);
            }
        }
    }
}
