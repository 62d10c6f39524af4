//! Repairs that a drawing itself suggests: where a halfedge was left out of a loop, and which edge
//! statement is missing.

use std::collections::BTreeSet;

use super::problem::Repair;
use crate::diagnostic::all_of;
use crate::diagram::{Drawing, Kind, Loop, NameId};

/// The repairs that insert an item in a loop of `after`, at any place: from a vertex that is
/// forgotten, too, or else from one that is drawn.
pub(super) fn insertions(drawing: &Drawing, item: NameId) -> Vec<Repair> {
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
    let repairs = places.flat_map(|(face, at)| {
        starts.iter().map(move |&from| Repair::Insert { face, at, from, item })
    });
    repairs.collect()
}

/// The advice to draw the edge statement that `before` lacks for a halfedge.
pub(super) fn draw_edge_of(drawing: &Drawing, half: NameId) -> String {
    let rule = drawing.rule;
    let statement = missing_edge(drawing, half);
    match across(drawing, half) {
        Some(twin) => format!(
            "{} runs between the same vertices in the other direction: if it is the twin, draw \
             `{statement}`",
            rule.quoted(twin)
        ),
        None => format!(
            "the halfedge outside would still say that its twin is {}: draw it, `{statement}`",
            rule.quoted(half)
        ),
    }
}

/// The same for several halfedges.
pub(super) fn draw_edges_of(drawing: &Drawing, halves: &[NameId]) -> String {
    let mut statements: Vec<_> = halves.iter().map(|&half| missing_edge(drawing, half)).collect();
    let mut told = BTreeSet::new();
    statements.retain(|statement| told.insert(statement.clone()));
    let statements = statements.iter().map(|statement| format!("`{statement}`"));
    format!("the halfedges outside would still name them: draw their edges, {}", all_of(statements))
}

/// The edge statement that `before` lacks for a halfedge: with the one [`across`], or else with one
/// outside of the drawing, under a new name.
pub(super) fn missing_edge(drawing: &Drawing, half: NameId) -> String {
    let rule = drawing.rule;
    // A member of a family is named with its index: `h[i]`.
    let twin = across(drawing, half);
    let (half, twin) = match twin {
        Some(twin) if twin < half => (twin, Some(half)),
        _ => (half, twin),
    };
    let word = &rule.name(half).text;
    let (stem, index) = word.split_at(word.find('[').unwrap_or(word.len()));
    let free = |mut stem: String| {
        while rule.names.iter().any(|name| name.text.split('[').next() == Some(&stem)) {
            stem.push('\'');
        }
        stem + index
    };
    let edge = free(format!("e{stem}"));
    match twin {
        Some(twin) => format!("edge {edge}: {word} | {}", rule.name(twin).text),
        None => format!("edge {edge}: {word} | {}", free(format!("{stem}'"))),
    }
}

/// The only halfedge that is drawn between the same vertices in the other direction, if it has no
/// twin either.
fn across(drawing: &Drawing, half: NameId) -> Option<NameId> {
    let ends = |half: NameId| Some((drawing.origin_before(half)?, drawing.target_before(half)?));
    let (from, to) = ends(half)?;
    let mut drawn = drawing.rule.names_of(Kind::Halfedge).filter(|&other| {
        other != half && ends(other) == Some((to, from)) && drawing.before.pairing(other).is_none()
    });
    drawn.next().filter(|_| drawn.next().is_none())
}
