//! The twins after, and the loop that is missing, as far as the ends of halfedges determine them.

use super::alias::is_rotated;
use super::problem::Repair;
use crate::diagram::{Drawing, Edge, Kind, Loop, LoopItem, NameId, Spoke};

/// Two halfedges that become twins.
type Pair = [NameId; 2];

/// The edge that a pair belongs to.
type EdgeOf<'a> = &'a dyn Fn(&Pair) -> Option<NameId>;

/// The ends of halfedges after.
pub(super) struct Ends<'a> {
    drawing: &'a Drawing<'a>,
    /// The vertices that `after` forgets or erases, with those that take their spokes.
    moved: Vec<(NameId, NameId)>,
}

impl<'a> Ends<'a> {
    /// The ends in a drawing; the spokes of some vertices are taken by others.
    pub fn new(drawing: &'a Drawing<'a>, mut moved: Vec<(NameId, NameId)>) -> Self {
        for star in &drawing.rule.after.stars {
            for spoke in &star.spokes {
                let (Spoke::Halfedge(spoke) | Spoke::Fan(spoke)) = spoke else { continue };
                let Some(from) = drawing.origin_before(spoke.name) else { continue };
                if from != star.vertex.name && drawing.after.mention(from).is_none() {
                    moved.push((from, star.vertex.name));
                }
            }
        }
        Self { drawing, moved }
    }

    /// The ends of a halfedge after: by its loop, by that of its twin, or, if it is an outer one, or
    /// its twin is drawn nowhere, those before.
    pub fn of(&self, half: NameId) -> Option<(NameId, NameId)> {
        self.drawn(half).or_else(|| {
            let (from, to) = self.drawn(self.drawing.after.twin(half)?)?;
            Some((to, from))
        })
    }

    fn drawn(&self, half: NameId) -> Option<(NameId, NameId)> {
        let Drawing { before, after, .. } = self.drawing;
        if let Some([from, to]) = after.loop_ends(half) {
            return Some((from, to));
        }
        let is_alone = before.mention(half).is_some()
            && before.pairing(half).is_none()
            && after.pairing(half).is_none();
        if !is_alone && !self.drawing.is_outer(half) {
            return None;
        }
        let from = after.star_of_spoke(half);
        let from = from.or_else(|| Some(self.place(self.drawing.origin_before(half)?)));
        Some((from?, self.place(self.drawing.target_before(half)?)))
    }

    /// The vertex that is where one was before.
    fn place(&self, vertex: NameId) -> NameId {
        self.moved.iter().find(|(from, _)| *from == vertex).map_or(vertex, |(_, to)| *to)
    }
}

/// The halfedges that have a twin before, or are new, and have none after.
pub(super) fn unpaired(drawing: &Drawing) -> Vec<NameId> {
    let halves = drawing.rule.names_of(Kind::Halfedge);
    halves
        .filter(|&half| drawing.after.pairing(half).is_none() && drawing.erased(half).is_none())
        .filter(|&half| drawing.created(half).is_some() || drawing.before.pairing(half).is_some())
        .collect()
}

/// The repair that pairs anew all halfedges of `after` that have no twin, or one with other ends, if
/// each fits exactly one other: in edges that are free, or else in new ones.
pub(super) fn pairing(drawing: &Drawing) -> Option<Repair> {
    pairing_with(drawing, Vec::new())
}

/// The same, for each way in which one vertex may take the spokes of one that is erased, if these
/// spokes go nowhere yet.
pub(super) fn pairings(drawing: &Drawing) -> Vec<Repair> {
    let rule = drawing.rule;
    let vertices = || rule.names_of(Kind::Vertex);
    let erased = vertices().filter(|&vertex| drawing.erased(vertex).is_some());
    let moves = erased.flat_map(|from| {
        vertices().filter(|&vertex| drawing.survives(vertex)).map(move |to| vec![(from, to)])
    });
    let mut found: Vec<Repair> = Vec::new();
    for moved in [Vec::new()].into_iter().chain(moves.filter(|_| rule.cycle.is_none())) {
        let repair = pairing_with(drawing, moved);
        found.extend(repair.filter(|repair| !found.contains(repair)));
    }
    found
}

fn pairing_with(drawing: &Drawing, moved: Vec<(NameId, NameId)>) -> Option<Repair> {
    let ends = Ends::new(drawing, moved);
    let is_wrong = |edge: &&Edge| {
        let [one, other] = edge.halfedges.map(|half| ends.drawn(half.name));
        one.zip(other).is_some_and(|((from, to), back)| back != (to, from))
    };
    let wrong: Vec<_> = drawing.rule.after.edges.iter().filter(is_wrong).collect();
    // What is neither an outer halfedge nor in a loop is forgotten altogether.
    let mut open = unpaired(drawing);
    open.retain(|&half| drawing.after.loop_of_item(half).is_some() || drawing.is_outer(half));
    open.extend(wrong.iter().flat_map(|edge| edge.halfedges).map(|half| half.name));
    open.sort();
    let mut pairs: Vec<Pair> = Vec::new();
    for &half in &open {
        let (from, to) = ends.drawn(half)?;
        let back = |other: &&NameId| **other != half && ends.drawn(**other) == Some((to, from));
        let mut others = open.iter().filter(back);
        let (Some(&other), None) = (others.next(), others.next()) else { return None };
        if pairs.iter().all(|pair| !pair.contains(&half)) {
            // The inner one comes first.
            let is_turned = drawing.is_outer(half) && !drawing.is_outer(other);
            pairs.push(if is_turned { [other, half] } else { [half, other] });
        }
    }
    let wrong: Vec<_> = wrong.iter().map(|edge| edge.edge.name).collect();
    let all = in_edges(drawing, &wrong, pairs);
    match all.as_slice() {
        [] => None,
        [only] => Some(only.clone()),
        _ => Some(Repair::All(all)),
    }
}

/// Distributes pairs over the edges that are free, or have wrong halfedges: each to one that an
/// outer halfedge of it belongs to, or else any of its halfedges, or else to those that are left
/// over. Pairs that no edge is left for get new ones.
fn in_edges(drawing: &Drawing, wrong: &[NameId], mut pairs: Vec<Pair>) -> Vec<Repair> {
    let rule = drawing.rule;
    let mut free: Vec<_> = free_edges(drawing).chain(wrong.iter().copied()).collect();
    let mut named = Vec::new();
    let own = |half: NameId| drawing.before.edge(half).or_else(|| drawing.after.edge(half));
    let outer = |pair: &Pair| {
        pair.iter().filter(|&&half| drawing.is_outer(half)).find_map(|&half| own(half))
    };
    let both = |pair: &Pair| {
        let [one, other] = pair.map(|half| drawing.before.edge(half));
        one.filter(|_| one == other)
    };
    let [first, second] = [0, 1].map(|at| move |pair: &Pair| own(pair[at]));
    let any = |pair: &Pair| first(pair).or_else(|| second(pair));
    let choices: [EdgeOf; 4] = [&both, &outer, &any, &second];
    for own in choices {
        pairs.retain(|&pair| {
            let edge = own(&pair).filter(|edge| free.contains(edge));
            free.retain(|&one| Some(one) != edge);
            named.extend(edge.map(|edge| (edge, pair)));
            edge.is_none()
        });
    }
    if rule.cycle.is_none() {
        let count = free.len().min(pairs.len());
        named.extend(free.into_iter().zip(pairs.drain(..count)));
    }
    // In the order of the text.
    named.sort_by_key(|(edge, _)| *edge);
    let others = (!pairs.is_empty()).then_some(Repair::PairAll(pairs));
    let named = (!named.is_empty()).then_some(Repair::Pair(named));
    others.into_iter().chain(named).collect()
}

/// The edges of `before`, and the new ones, that stand nowhere in `after`.
pub(super) fn free_edges(drawing: &Drawing) -> impl Iterator<Item = NameId> {
    drawing
        .rule
        .names_of(Kind::Edge)
        .filter(|&edge| drawing.after.mention(edge).is_none() && drawing.erased(edge).is_none())
}

/// The loops of `before` whose faces survive and have no loop in `after`.
pub(super) fn lost_loops<'d>(drawing: &'d Drawing) -> impl Iterator<Item = &'d Loop> {
    let is_lost = |orbit: &&Loop| {
        let face = orbit.face.name;
        drawing.survives(face) && drawing.after.loop_of_face(face).is_none()
    };
    drawing.rule.before.loops.iter().filter(is_lost)
}

/// The missing loops of `after`, if there are any and each follows from the ends of its halfedges:
/// those that it had before, if one is missing also others, of which one may have unknown ends.
/// `None` if they are what they were before: [`kept_loops`].
pub(super) fn missing_loops(drawing: &Drawing) -> Option<Vec<Repair>> {
    let rule = drawing.rule;
    let lost: Vec<_> = lost_loops(drawing).collect();
    let is_open = |item: &NameId| {
        let is_known = drawing.survives(*item) || drawing.created(*item).is_some();
        is_known && drawing.after.loop_of_item(*item).is_none()
    };
    let all = rule.before.loops.iter().flat_map(|orbit| &orbit.items);
    let all: Vec<_> = all.map(|item: &LoopItem| item.item.name).filter(is_open).collect();
    let new = rule.created.iter().map(|created| created.name);
    let new: Vec<_> =
        new.filter(|&name| rule.kind(name) == Kind::Halfedge && is_open(&name)).collect();
    // Which of several loops a new halfedge belongs to is not known.
    if lost.is_empty() || rule.cycle.is_some() || lost.len() > 1 && !new.is_empty() {
        return None;
    }
    let ends = Ends::new(drawing, Vec::new());
    let mut draws = Vec::new();
    let mut is_changed = false;
    for orbit in &lost {
        let face = orbit.face.name;
        let own = orbit.item_names().filter(is_open);
        let own: Vec<_> = if lost.len() == 1 { all.clone() } else { own.collect() };
        let items = around(drawing, &ends, &own, &new)?;
        let was: Vec<_> = orbit.corners().zip(orbit.item_names()).collect();
        is_changed |= !is_rotated(&was, &items);
        draws.push(Repair::Draw { face, items });
    }
    is_changed.then_some(draws)
}

/// The repair that keeps the loops of which `after` states nothing.
pub(super) fn kept_loops(drawing: &Drawing) -> Option<Repair> {
    let is_free =
        |name: NameId| drawing.survives(name) && drawing.after.loop_of_item(name).is_none();
    let left = lost_loops(drawing).filter(|orbit| orbit.item_names().all(is_free));
    let left: Vec<_> = left.map(|orbit| orbit.face.name).collect();
    (drawing.rule.cycle.is_none() && !left.is_empty()).then_some(Repair::Keep(left))
}

/// The one way around by which items form a loop, perhaps with some of the others: by their ends
/// after; those of one item may be unknown.
fn around(
    drawing: &Drawing,
    ends: &Ends,
    own: &[NameId],
    others: &[NameId],
) -> Option<Vec<(NameId, NameId)>> {
    let ends = |item: NameId| match drawing.rule.kind(item) {
        Kind::Path => {
            let ends_before = drawing.before.loop_origin(item).zip(drawing.target_before(item));
            ends_before.map(|(from, to)| (ends.place(from), ends.place(to)))
        }
        _ => ends.of(item),
    };
    let (known, unknown): (Vec<_>, Vec<_>) =
        own.iter().copied().partition(|&item| ends(item).is_some());
    let (&first, true) = (known.first()?, unknown.len() < 2) else { return None };
    let (start, _) = ends(first)?;
    let usable: Vec<_> = known.iter().chain(others).copied().collect();
    let follow = |mut at: NameId, until: NameId, used: &mut Vec<(NameId, NameId)>| {
        while at != until {
            let fits = |item: &&NameId| ends(**item).is_some_and(|(from, _)| from == at);
            let mut next = usable.iter().filter(fits);
            let Some(&item) = next.next() else { break };
            if next.next().is_some() || used.iter().any(|(_, known)| *known == item) {
                return None;
            }
            used.push((at, item));
            at = ends(item)?.1;
        }
        Some(at)
    };
    let mut drawn = vec![(start, first)];
    let mut at = follow(ends(first)?.1, start, &mut drawn)?;
    if let (&[item], true) = (unknown.as_slice(), at != start) {
        // The unknown item leads to the piece that nothing leads to.
        let is_open = |item: &&NameId| drawn.iter().all(|(_, known)| known != *item);
        let targets: Vec<_> = known.iter().filter_map(|&item| Some(ends(item)?.1)).collect();
        let mut heads = known.iter().filter(is_open).filter_map(|&item| Some(ends(item)?.0));
        let head = heads.find(|from| !targets.contains(from));
        drawn.push((at, item));
        at = follow(head.unwrap_or(start), start, &mut drawn)?;
    }
    let is_drawn = |item: &NameId| drawn.iter().any(|(_, known)| known == item);
    (at == start && own.iter().all(is_drawn)).then_some(drawn)
}
