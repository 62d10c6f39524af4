//! Arrangements: the ways in which the arcs of a vertex can join its chains.
//!
//! The mesh before is valid, so the arcs at a vertex with `k` chains join them into one
//! cycle: at most `(k-1)!` ways. A vertex statement leaves those that agree with it, and says
//! which arc, and which first spoke of a path, lies in which fan.

use std::borrow::Cow;

use super::chain::Corner;
use super::port::Port;
use crate::diagram::{Drawing, Kind, NameId, Rule, Spoke, Star};

/// The content of an arc; or for the first spoke of a path, where it belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ArcContent {
    /// Spokes of a named fan.
    Fan(NameId),
    /// Spokes of no named fan: they stay with their vertex.
    Rest,
    /// This outer halfedge, which the statement lists: the first spoke of a path.
    Spoke(NameId),
    /// No spoke, as is known.
    Empty,
}

/// The spokes outside the drawing between two chains of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Arc {
    /// The exit it leaves from.
    pub from: Port,
    /// The entry it leads to, clockwise.
    pub to: Port,
    /// The vertex it lies at before.
    pub vertex: NameId,
    /// What it holds.
    pub content: ArcContent,
}

/// One way in which the arcs of a vertex can run.
///
/// An arc from `Out(P)` to `In(P)` of a path that may be empty also stands for the empty path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Arrangement {
    pub arcs: Vec<Arc>,
    /// For each path that starts at the vertex, where its first spoke belongs.
    pub first_spokes: Vec<(NameId, ArcContent)>,
    /// The paths that the statement leaves no room for a halfedge, so that they are empty.
    pub empty_paths: Vec<NameId>,
    /// True if it stands for others too, in which settled chains lie elsewhere.
    pub stands_for_others: bool,
}

/// The greatest number of arrangements of one vertex that are examined; a vertex with more is given
/// up.
const MOST: usize = 40_320;

/// The arrangements of a vertex that agree with its statement, or `None` if there are too many to
/// examine.
///
/// The chains in `settled` pass through the rewrite unchanged. Whether an arc goes around them or
/// leads through them makes no difference to the orbits of `after`, so they are placed behind the
/// first of the others, and only the order of those others matters.
pub(super) fn arrangements(
    drawing: &Drawing,
    corner: &Corner,
    settled: &[usize],
) -> Option<Vec<Arrangement>> {
    let count = corner.chains.len();
    if corner.chains.iter().any(|chain| chain.closed) {
        let order: Vec<_> = (0..count).collect();
        let alone = count == 1;
        return Some(alone.then(|| read(drawing, corner, &order)).flatten().into_iter().collect());
    }
    let mut orders = Orders::new(drawing, corner, settled);
    let behind = orders.order.len().min(1);
    orders.order.splice(behind..behind, settled.iter().copied());
    orders.extend(behind + settled.len());
    (orders.tried <= MOST).then_some(orders.found)
}

/// The orders of the chains of a vertex, one after the other.
struct Orders<'a> {
    drawing: &'a Drawing<'a>,
    corner: &'a Corner,
    /// For each chain, the listed spokes on it, by their places in the vertex statement, read
    /// clockwise.
    listed: Vec<Vec<usize>>,
    /// The number of spokes that the vertex statement lists.
    stated: usize,
    order: Vec<usize>,
    stands_for_others: bool,
    tried: usize,
    found: Vec<Arrangement>,
}

impl<'a> Orders<'a> {
    fn new(drawing: &'a Drawing<'a>, corner: &'a Corner, settled: &[usize]) -> Self {
        let star = drawing.before.star(corner.vertex);
        let stated: Vec<NameId> = star.map_or_else(Vec::new, |star| {
            star.spokes.iter().rev().filter_map(Spoke::halfedge).collect()
        });
        let places = |ports: &[Port]| -> Vec<usize> {
            let items = ports.iter().filter_map(|port| port.leaving());
            items.filter_map(|item| stated.iter().position(|half| *half == item)).collect()
        };
        let listed: Vec<_> = corner.chains.iter().map(|chain| places(&chain.ports)).collect();
        let mut order: Vec<_> = (0..listed.len()).filter(|at| !settled.contains(at)).collect();
        // A chain with a listed spoke determines where the others have to be.
        if let Some(first) = order.iter().position(|&at| !listed[at].is_empty()) {
            order.swap(0, first);
        }
        Self {
            drawing,
            corner,
            listed,
            stated: stated.len(),
            order,
            stands_for_others: !settled.is_empty(),
            tried: 0,
            found: Vec::new(),
        }
    }

    /// Enumerates the orders of the chains from `fixed` on. Orders that contradict that of the
    /// listed spokes are left out early.
    fn extend(&mut self, fixed: usize) {
        if self.tried > MOST || !self.agrees_so_far(fixed) {
            return;
        }
        if fixed >= self.order.len() {
            self.tried += 1;
            let way = read(self.drawing, self.corner, &self.order);
            self.found.extend(
                way.map(|way| Arrangement { stands_for_others: self.stands_for_others, ..way }),
            );
            return;
        }
        for pick in fixed..self.order.len() {
            self.order.swap(fixed, pick);
            self.extend(fixed + 1);
            self.order.swap(fixed, pick);
        }
    }

    /// True if the listed spokes of the first chains follow each other as stated.
    fn agrees_so_far(&self, fixed: usize) -> bool {
        let mut spokes = self.order.iter().take(fixed).flat_map(|&chain| &self.listed[chain]);
        let Some(&first) = spokes.next() else { return true };
        let mut at = first;
        spokes.all(|&spoke| {
            at = (at + 1) % self.stated.max(1);
            spoke == at
        })
    }
}

/// A piece of an orbit, clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece {
    Spoke(NameId),
    /// The first spoke of a path, by its index among the first spokes, and whether the path is
    /// empty in this order.
    First(usize, bool),
    /// An arc, by its index.
    Arc(usize),
}

/// The arrangement in which the chains follow each other in `order`, unless it contradicts
/// the vertex statement.
fn read(drawing: &Drawing, corner: &Corner, order: &[usize]) -> Option<Arrangement> {
    let mut way = Arrangement {
        arcs: Vec::new(),
        first_spokes: Vec::new(),
        empty_paths: Vec::new(),
        stands_for_others: false,
    };
    let mut pieces = Vec::new();
    for (at, &index) in order.iter().enumerate() {
        let chain = &corner.chains[index];
        let next = &corner.chains[order[(at + 1) % order.len()]];
        for &port in &chain.ports {
            let Port::Out(item) = port else { continue };
            if drawing.rule.kind(item) == Kind::Path {
                let exits = !chain.closed && port == chain.exit();
                let empty = exits && next.entry() == Port::In(item) && drawing.may_be_empty(item);
                way.first_spokes
                    .push((item, if empty { ArcContent::Empty } else { ArcContent::Rest }));
                pieces.push(Piece::First(way.first_spokes.len() - 1, empty));
            } else {
                pieces.push(Piece::Spoke(item));
            }
        }
        if !chain.closed {
            let arc = Arc {
                from: chain.exit(),
                to: next.entry(),
                vertex: corner.vertex,
                content: ArcContent::Rest,
            };
            way.arcs.push(arc);
            pieces.push(Piece::Arc(way.arcs.len() - 1));
        }
    }
    if let Some(star) = drawing.before.star(corner.vertex) {
        agree(drawing, star, &pieces, &mut way)?;
    }
    Some(way)
}

/// Puts each piece in its fan; `None` if the order contradicts the statement.
fn agree(drawing: &Drawing, star: &Star, pieces: &[Piece], way: &mut Arrangement) -> Option<()> {
    // The statement reads counterclockwise, pieces run clockwise.
    let stated: Vec<_> = star.spokes.iter().rev().collect();
    let count = pieces.len();
    let place = |content: ArcContent, piece: Piece, way: &mut Arrangement| -> Option<()> {
        match piece {
            Piece::Spoke(_) => return None,
            // Without a spoke in the arc, the halfedge would be its own twin.
            Piece::Arc(arc)
                if content == ArcContent::Empty && is_own_twin(drawing, way.arcs[arc]) =>
            {
                return None;
            }
            Piece::Arc(arc) => way.arcs[arc].content = content,
            Piece::First(first, empty) => match content {
                ArcContent::Empty if !empty => return None,
                ArcContent::Empty => {
                    way.first_spokes[first].1 = ArcContent::Empty;
                    way.empty_paths.push(way.first_spokes[first].0);
                }
                _ => way.first_spokes[first].1 = if empty { ArcContent::Empty } else { content },
            },
        }
        Some(())
    };
    let anchor = stated.iter().position(|spoke| matches!(spoke, Spoke::Halfedge(_)));
    let Some(anchor) = anchor else {
        // One fan, and nothing else.
        let content = stated.first().map_or(ArcContent::Empty, |spoke| belongs(spoke));
        return pieces.iter().try_for_each(|&piece| place(content, piece, way));
    };
    let Spoke::Halfedge(first) = stated[anchor] else { return None };
    let start = pieces.iter().position(|&piece| piece == Piece::Spoke(first.name))?;
    let mut at = 0; // how many pieces have been read, from the anchor on
    let mut step = 0;
    while step < stated.len() {
        let Spoke::Halfedge(name) = stated[(anchor + step) % stated.len()] else { return None };
        if at >= count || pieces[(start + at) % count] != Piece::Spoke(name.name) {
            return None;
        }
        at += 1;
        step += 1;
        // What follows up to the next listed spoke is in the fan stated here, or empty.
        let fan = stated[(anchor + step) % stated.len()];
        let content = if step < stated.len() && !matches!(fan, Spoke::Halfedge(_)) {
            step += 1;
            belongs(fan)
        } else {
            ArcContent::Empty
        };
        while at < count && !matches!(pieces[(start + at) % count], Piece::Spoke(_)) {
            let piece = pieces[(start + at) % count];
            let following = [1, 2].map(|on| pieces[(start + at + on) % count]);
            match (piece, following) {
                // Between the two there is no spoke, so they are one: the path begins with
                // an outer halfedge.
                (Piece::First(first, false), [Piece::Arc(arc), Piece::Spoke(outer)])
                    if content == ArcContent::Empty && way.arcs[arc].to == Port::Out(outer) =>
                {
                    way.first_spokes[first].1 = ArcContent::Spoke(outer);
                }
                _ => place(content, piece, way)?,
            }
            at += 1;
        }
    }
    (at == count).then_some(())
}

/// The arrangements picked for all vertices, unless they contradict each other.
///
/// The ends `x` and `y` of an arc without a spoke are twins; so another arc without a spoke must
/// lead from `y` to `x`, at their other end. And where `after` has a loop of nothing but empty
/// paths, the match is refused.
pub(super) fn agreeing<'a>(
    rule: &Rule,
    picked: impl Iterator<Item = &'a Arrangement>,
) -> Option<Vec<Cow<'a, Arrangement>>> {
    let mut ways: Vec<Cow<Arrangement>> = picked.map(Cow::Borrowed).collect();
    let is_empty = |item: NameId| ways.iter().any(|way| way.empty_paths.contains(&item));
    let mut loops = rule.after.loops.iter();
    if loops.any(|orbit| orbit.items.iter().all(|item| is_empty(item.item.name))) {
        return None;
    }
    let empty =
        ways.iter().flat_map(|way| &way.arcs).filter(|arc| arc.content == ArcContent::Empty);
    let twins: Vec<_> = empty
        .filter_map(|arc| match (arc.from, arc.to) {
            (Port::Out(x), Port::In(y)) => Some([x, y]),
            _ => None,
        })
        .filter(|pair| pair.iter().all(|&item| rule.kind(item) == Kind::Halfedge))
        .collect();
    for [x, y] in twins {
        for way in &mut ways {
            let leaves = |arc: &Arc| arc.from == Port::Out(y);
            let Some(found) = way.arcs.iter().position(leaves) else { continue };
            if way.arcs[found].to == Port::In(x) {
                way.to_mut().arcs[found].content = ArcContent::Empty;
            } else if !way.stands_for_others {
                return None;
            }
        }
    }
    Some(ways)
}

/// True if an arc leaves a halfedge and arrives at the same one.
fn is_own_twin(drawing: &Drawing, arc: Arc) -> bool {
    let item = arc.from.item();
    (arc.from, arc.to) == (Port::Out(item), Port::In(item))
        && drawing.rule.kind(item) == Kind::Halfedge
}

fn belongs(spoke: &Spoke) -> ArcContent {
    match spoke {
        Spoke::Fan(fan) => ArcContent::Fan(fan.name),
        Spoke::Halfedge(_) | Spoke::Rest(_) => ArcContent::Rest,
    }
}
