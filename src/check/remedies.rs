//! Remedies that a drawing itself suggests: where a halfedge was left out of a loop, which
//! halfedges pair by their ends, and which loop is missing.

use super::problem::Remedy;
use crate::diagram::{Drawing, Kind, Loop, NameId};

/// The remedies that insert an item in a loop of `after`, at any place: from a vertex that is
/// forgotten, too, or else from one that is drawn.
pub(super) fn insertions(drawing: &Drawing, item: NameId) -> Vec<Remedy> {
    let rule = drawing.rule;
    if rule.cycle.is_some() {
        return Vec::new();
    }
    let survivors = rule
        .names_of(Kind::Vertex)
        .filter(|&vertex| drawing.survives(vertex) || drawing.created(vertex).is_some());
    let (drawn, forgotten): (Vec<_>, Vec<_>) =
        survivors.partition(|&vertex| drawing.after.mention(vertex).is_some());
    let starts = if forgotten.is_empty() { drawn } else { forgotten };
    let is_kept = |orbit: &Loop| rule.after.kept.iter().any(|kept| kept.name == orbit.face.name);
    let loops = rule.after.loops.iter().filter(|orbit| !is_kept(orbit));
    let places = loops.flat_map(|orbit| (1..=orbit.items.len()).map(|at| (orbit.face.name, at)));
    let remedies = places.flat_map(|(face, at)| {
        starts.iter().map(move |&from| Remedy::Insert { face, at, from, item })
    });
    remedies.collect()
}

/// The halfedges that have a twin before, or are new, and have none after.
pub(super) fn unpaired(drawing: &Drawing, is_new: impl Fn(NameId) -> bool) -> Vec<NameId> {
    let halves = drawing.rule.names_of(Kind::Halfedge);
    halves
        .filter(|&half| drawing.after.pairing(half).is_none() && drawing.erased(half).is_none())
        .filter(|&half| is_new(half) || drawing.before.pairing(half).is_some())
        .collect()
}

/// Pairs of halfedges that run between the same vertices in opposite directions, if each has
/// exactly one such partner.
pub(super) fn by_ends(drawing: &Drawing, open: &[NameId]) -> Option<Vec<[NameId; 2]>> {
    let ends =
        |half: NameId| Some((drawing.after.loop_origin(half)?, drawing.after.loop_target(half)?));
    let mut pairs: Vec<[NameId; 2]> = Vec::new();
    for &half in open {
        let (from, to) = ends(half)?;
        let mut others =
            open.iter().filter(|&&other| ends(other) == Some((to, from)) && other != half);
        let (Some(&other), None) = (others.next(), others.next()) else {
            return None;
        };
        if pairs.iter().all(|pair| !pair.contains(&half)) {
            pairs.push([half, other]);
        }
    }
    Some(pairs)
}

/// The advice to draw the edge statement that `before` lacks for a halfedge: with the halfedge that
/// is drawn between the same vertices in the other direction, if exactly one is and has no twin
/// either; else with one outside of the drawing, under a new name.
pub(super) fn draw_edge_of(drawing: &Drawing, half: NameId) -> String {
    let rule = drawing.rule;
    let ends = |half: NameId| Some((drawing.origin_before(half)?, drawing.target_before(half)?));
    let across = ends(half).map(|(from, to)| (to, from));
    let mut drawn = rule.names_of(Kind::Halfedge).filter(|&other| {
        other != half
            && across.is_some()
            && ends(other) == across
            && drawing.before.pairing(other).is_none()
    });
    // A member of a family is named with its index: `h[i]`.
    let word = &rule.name(half).text;
    let (stem, index) = word.split_at(word.find('[').unwrap_or(word.len()));
    let free = |mut stem: String| {
        while rule.names.iter().any(|name| name.text.split('[').next() == Some(&stem)) {
            stem.push('\'');
        }
        stem + index
    };
    if let (Some(twin), None) = (drawn.next(), drawn.next()) {
        let twin_word = &rule.name(twin).text;
        let edge = match index.is_empty() && twin < half {
            true => free(format!("e{twin_word}")),
            false => free(format!("e{stem}")),
        };
        return format!(
            "{} runs between the same vertices in the other direction: if it is the twin, draw `edge \
             {edge}: {word} | {twin_word}`",
            rule.quoted(twin)
        );
    }
    let (text, edge, twin) =
        (rule.quoted(half), free(format!("e{stem}")), free(format!("{stem}'")));
    format!(
        "the halfedge outside would still say that its twin is {text}: draw it, `edge {edge}: {word} \
         | {twin}`"
    )
}

/// The loop that items form by their ends after, or else by those before, if there is exactly one
/// way around.
pub(super) fn around(drawing: &Drawing, items: &[NameId]) -> Option<Vec<(NameId, NameId)>> {
    let ends = |item: NameId| {
        let twin = drawing.after.pairing(item).and_then(|edge| {
            let mut halves = edge.halfedges.iter().map(|half| half.name);
            halves.find(|&half| half != item)
        });
        let across = twin.and_then(|twin| {
            Some((drawing.after.loop_target(twin)?, drawing.after.loop_origin(twin)?))
        });
        across.or_else(|| Some((drawing.before.loop_origin(item)?, drawing.target_before(item)?)))
    };
    let all: Vec<_> = items.iter().map(|&item| Some((item, ends(item)?))).collect::<Option<_>>()?;
    let (first, (start, mut to)) = *all.first()?;
    let mut around = vec![(start, first)];
    while to != start {
        let mut next = all.iter().filter(|(_, (from, _))| *from == to);
        let (Some(&(item, (from, end))), None) = (next.next(), next.next()) else {
            return None;
        };
        if around.len() >= all.len() {
            return None;
        }
        around.push((from, item));
        to = end;
    }
    (around.len() == all.len()).then_some(around)
}
