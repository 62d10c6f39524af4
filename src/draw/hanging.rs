//! Places of what hangs at one node: spurs, edges from a vertex to itself, whole blocks.
//!
//! Nothing pulls the nodes of such a piece apart from those of its siblings. So the pieces at a node
//! divide the corner in which they hang, in the order around the loop. A spur is straight, another
//! piece is round, and both end before they reach the other side of their loop.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::curve::{angle, direction, sides, turn};
use super::figure::Side;

/// The length of a spur.
pub(super) const SPUR: f64 = 0.62;
/// The greatest part of a loop's extent that a piece fills.
const REACH: f64 = 0.75;
/// The angle between a piece and an edge of the body, relative to the one that a round piece fills,
/// which is also that between two pieces.
const ASIDE: f64 = 0.5;

/// What hangs at a node between two visits of a loop: the nodes around it, one for a spur, each
/// with what hangs at it in turn.
struct Piece(Vec<(usize, Vec<Piece>)>);

/// A corner: the angle where it begins, counterclockwise, and its width.
#[derive(Clone, Copy)]
struct Corner {
    from: f64,
    width: f64,
}

impl Corner {
    /// The corner at `at` from one neighbor to another.
    fn between(at: DVec2, [from, to]: [DVec2; 2]) -> Self {
        let from = angle(from - at);
        Self { from, width: turn(from, angle(to - at)) }
    }
}

/// Places the nodes around the pieces that hang at a fixed node or at each other; other nodes that
/// hang lose their places.
pub(super) fn hang(
    side: &Side,
    pulls: &[(usize, usize)],
    is_fixed: &dyn Fn(usize) -> bool,
    places: &mut [Option<DVec2>],
) {
    let hangs = hanging(places.len(), pulls, is_fixed);
    for (place, hangs) in places.iter_mut().zip(&hangs) {
        *place = place.filter(|_| !hangs);
    }
    for orbit in &side.loops {
        let visits = visits(side.around(&orbit.darts), &hangs);
        let body: Vec<_> = visits.iter().map(|&(node, _)| node).collect();
        let outline: Vec<_> = body.iter().filter_map(|&node| places[node]).collect();
        for (at, (root, walk)) in visits.iter().enumerate() {
            let pieces = pieces(walk, *root);
            let near = [at + 1, at + body.len() - 1].map(|at| places[body[at % body.len()]]);
            let (Some(place), [Some(ahead), Some(behind)]) = (places[*root], near) else {
                continue;
            };
            let corner = match body.len() {
                // A piece that is all of its loop lies around it.
                1 if pieces.len() < 2 => continue,
                1 => Corner { from: 0.0, width: TAU },
                _ => Corner::between(place, [ahead, behind]),
            };
            let unit = |way: DVec2, size: f64| {
                let hits = sides(&outline).filter_map(|side| hit(place, way, side));
                SPUR.min(REACH * hits.fold(f64::MAX, f64::min) / size)
            };
            divide(&pieces, place, corner, &unit, places);
        }
    }
}

/// Which nodes hang: those that a single node connects to the fixed ones.
fn hanging(count: usize, pulls: &[(usize, usize)], is_fixed: &dyn Fn(usize) -> bool) -> Vec<bool> {
    let mut neighbors = vec![Vec::new(); count];
    for &(a, b) in pulls {
        neighbors[a].push(b);
        neighbors[b].push(a);
    }
    // The nodes that are connected to the fixed ones without another one.
    let held = |without: Option<usize>| {
        let mut open: Vec<_> =
            (0..count).filter(|&node| is_fixed(node) && Some(node) != without).collect();
        let mut held = vec![false; count];
        open.iter().for_each(|&node| held[node] = true);
        while let Some(node) = open.pop() {
            for &next in &neighbors[node] {
                if !held[next] && Some(next) != without {
                    held[next] = true;
                    open.push(next);
                }
            }
        }
        held
    };
    let all = held(None);
    let mut hangs = vec![false; count];
    for root in (0..count).filter(|&node| all[node] && !neighbors[node].is_empty()) {
        let held = held(Some(root));
        for node in (0..count).filter(|&node| node != root) {
            hangs[node] |= all[node] && !held[node];
        }
    }
    hangs
}

/// The nodes around a loop that do not hang, each with the walk around what hangs at it.
fn visits(mut walk: Vec<usize>, hangs: &[bool]) -> Vec<(usize, Vec<usize>)> {
    let before = |at: usize| walk[(at + walk.len() - 1) % walk.len()];
    let held = |&at: &usize| !hangs[walk[at]];
    let first = (0..walk.len()).filter(held).max_by_key(|&at| !hangs[before(at)]);
    walk.rotate_left(first.unwrap_or(0));
    let mut visits: Vec<(usize, Vec<usize>)> = Vec::new();
    for node in walk {
        match visits.last_mut() {
            Some((root, behind)) if hangs[node] || !behind.is_empty() && *root == node => {
                behind.push(node);
            }
            _ if hangs[node] => return visits,
            _ => visits.push((node, Vec::new())),
        }
    }
    visits
}

/// The pieces that a walk from a node back to it goes around.
fn pieces(walk: &[usize], root: usize) -> Vec<Piece> {
    let parts = walk.split(|&node| node == root).filter(|part| !part.is_empty());
    let piece = |mut rest: &[usize]| {
        let mut ring = Vec::new();
        while let Some((&node, behind)) = rest.split_first() {
            let last = behind.iter().rposition(|&other| other == node).map_or(0, |at| at + 1);
            ring.push((node, pieces(&behind[..last], node)));
            rest = &behind[last..];
        }
        Piece(ring)
    };
    parts.map(piece).collect()
}

impl Piece {
    /// The radius of its circle in lengths of an edge, if it is round.
    fn radius(&self) -> Option<f64> {
        (self.0.len() > 1).then(|| 0.5 / (PI / (self.0.len() + 1) as f64).sin())
    }

    /// The angle that it fills, in units of that of a round piece.
    fn weight(&self) -> f64 {
        if self.0.len() > 1 { 1.0 } else { 0.0 }
    }

    /// The greatest distance of its nodes from its root, in lengths of an edge.
    fn size(&self) -> f64 {
        let behind = self.0.iter().flat_map(|(_, pieces)| pieces).map(Self::size);
        self.radius().map_or(1.0, |radius| 2.0 * radius) + behind.fold(0.0, f64::max)
    }

    /// Places it at its root, in a direction, within an angle.
    fn place(&self, root: DVec2, way: f64, within: f64, unit: f64, places: &mut [Option<DVec2>]) {
        let len = self.0.len() + 1;
        let count = len as f64;
        let along = direction(way);
        let spot = |at: usize| match self.radius() {
            _ if at == 0 => root,
            None => root + along * unit,
            Some(radius) => {
                // Clockwise, since the loop is on the left.
                let turned = direction(PI - TAU * at as f64 / count) + DVec2::X;
                let natural = FRAC_PI_2 - PI / count;
                let narrow = ((within / 2.0).min(natural).tan() / natural.tan()).min(1.0);
                root + along.rotate(turned * DVec2::new(1.0, narrow)) * (radius * unit)
            }
        };
        for (at, (node, pieces)) in self.0.iter().enumerate().map(|(at, node)| (at + 1, node)) {
            let place = spot(at);
            places[*node] = Some(place);
            let corner = Corner::between(place, [spot((at + 1) % len), spot(at - 1)]);
            divide(pieces, place, corner, &|_, _| unit, places);
        }
    }
}

/// Places pieces at their root: the first one is the last counterclockwise.
fn divide(
    pieces: &[Piece],
    root: DVec2,
    corner: Corner,
    unit: &dyn Fn(DVec2, f64) -> f64,
    places: &mut [Option<DVec2>],
) {
    let weights: f64 = pieces.iter().map(Piece::weight).sum();
    // Around the end of an edge all angles are alike.
    let aside = if corner.width < TAU { ASIDE } else { 1.0 };
    let part = corner.width / (weights + pieces.len() as f64 - 1.0 + 2.0 * aside);
    let mut to = corner.from + corner.width - aside * part;
    for piece in pieces {
        let within = piece.weight() * part;
        let way = to - within / 2.0;
        to -= within + part;
        let unit = unit(direction(way), piece.size());
        piece.place(root, way, within, unit, places);
    }
}

/// The distance at which a ray meets a segment.
fn hit(from: DVec2, way: DVec2, [a, b]: [DVec2; 2]) -> Option<f64> {
    let along = b - a;
    let across = way.perp_dot(along);
    let (far, part) = ((a - from).perp_dot(along) / across, (a - from).perp_dot(way) / across);
    (across.abs() > 1e-9 && far > 1e-6 && (0.0..=1.0).contains(&part)).then_some(far)
}
