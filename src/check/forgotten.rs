//! Names that are drawn before, and nowhere after.

use super::names_are_accounted_for::after_keyword;
use super::problem::{Problem, Repair, enumerate, is_or_are};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, Loop, LoopItem, LoopKind, NameId, Ref, Rule};

/// The advice for a face that is erased, if nothing of its loop is drawn elsewhere.
pub(super) fn as_a_hole(drawing: &Drawing, orbit: &Loop) -> Option<String> {
    let face = orbit.face.name;
    let is_elsewhere = |item: &LoopItem| drawing.after.loop_of_item(item.item.name).is_some();
    let is_alone = drawing.erased(face).is_some() && !orbit.items.iter().any(is_elsewhere);
    (is_alone && orbit.kind == LoopKind::Face).then(|| {
        let face = &drawing.rule.name(face).text;
        format!("to delete a face alone, draw its loop as a hole in `after`: `hole {face}: …`")
    })
}

/// The same advice for an op that draws a face and does nothing but erase, and no vertex.
pub(super) fn only_a_hole(drawing: &Drawing) -> Option<String> {
    let Rule { before, after, created, erased, .. } = drawing.rule;
    let is_vertex = |name: &Ref| drawing.rule.kind(name.name) == Kind::Vertex;
    let only_erases = after.loops.is_empty() && after.edges.is_empty() && created.is_empty();
    let only_erases = only_erases && !erased.iter().any(is_vertex);
    match before.loops.as_slice() {
        [orbit] if only_erases => as_a_hole(drawing, orbit),
        _ => None,
    }
}

/// Whether a face or edge that is drawn before may stay as it was: its halfedges are neither erased
/// nor drawn at another one. Of a vertex that is not known.
fn may_be_kept(drawing: &Drawing, name: NameId) -> bool {
    let Drawing { before, after, .. } = drawing;
    let survives = |item: NameId| drawing.erased(item).is_none();
    match drawing.rule.kind(name) {
        Kind::Face => before.loop_of_face(name).is_none_or(|face| {
            face.item_names().all(|item| survives(item) && after.loop_of_item(item).is_none())
        }),
        Kind::Edge => before.edge_statement(name).is_none_or(|edge| {
            let mut halves = edge.halfedge_names().into_iter();
            halves.all(|half| survives(half) && after.pairing(half).is_none())
        }),
        _ => true,
    }
}

/// The problem that names of one kind are drawn before, and nowhere after.
pub(super) fn is_forgotten(drawing: &Drawing, kind: Kind, names: &[NameId]) -> Problem {
    let rule = drawing.rule;
    let list = enumerate(rule, names);
    let be = is_or_are(names.len());
    let message = match kind {
        Kind::Fan => format!("the fan {list} is drawn before, and lies nowhere after"),
        _ => format!("{list} {be} drawn before, but neither drawn after nor erased"),
    };
    let mut spans = names
        .iter()
        .map(|&name| drawing.before.mention(name).expect("a surviving name is drawn before"));
    let first = spans.next().unwrap_or(rule.before.span);
    let mut diagnostic = Diagnostic::error("unaccounted-name", message, first)
        .saying(format!("{} that `after` forgets", kind.a_word()));
    for span in spans {
        diagnostic = diagnostic.label(span, "");
    }
    let stand = if names.len() == 1 { "stands" } else { "stand" };
    diagnostic = diagnostic.label(after_keyword(drawing), format!("{list} {stand} nowhere here"));
    let words: Vec<_> = names.iter().map(|&name| &*rule.name(name).text).collect();
    let words = words.join(" ");
    let may_be_kept = names.iter().all(|&name| may_be_kept(drawing, name));
    diagnostic = match kind {
        Kind::Fan => {
            diagnostic.note("list it in the vertex statement of the vertex that takes its spokes")
        }
        Kind::Vertex | Kind::Edge | Kind::Face => diagnostic.note(match may_be_kept {
            true => format!("draw {list} in `after`, or write `keep {words}` or `erase {words}`"),
            false => format!("draw {list} in `after`, or write `erase {words}`"),
        }),
        Kind::Halfedge | Kind::Path => diagnostic,
    };
    let repairs = match kind {
        Kind::Vertex | Kind::Edge | Kind::Face => {
            let keep = may_be_kept.then(|| Repair::Keep(names.to_vec()));
            keep.into_iter().chain([Repair::Erase(names.to_vec())]).collect()
        }
        Kind::Fan => {
            let vertex = drawing.before.star_of_spoke(names[0]);
            let erased = vertex.filter(|&vertex| drawing.erased(vertex).is_some());
            erased.map(Repair::Take).into_iter().collect()
        }
        Kind::Halfedge | Kind::Path => Vec::new(),
    };
    Problem { diagnostic, repairs }
}
