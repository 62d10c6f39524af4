//! Walks along paths and over fans, and what they set: the face along a path that changes its
//! loop, the vertex around a fan that changes its vertex.

use super::names::Names;
use super::routine::Statement;
use super::term::Term;
use crate::diagram::{Drawing, NameId, Pointer, Spoke};

/// A walk over halfedges. While it runs, nothing that it follows is written; only the `face` or
/// `vertex` of the halfedges themselves may be.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HalfedgeWalk {
    /// The name of the halfedge.
    pub halfedge: String,
    /// The step from one to the next.
    pub step: Step,
    /// The first halfedge.
    pub from: Term,
    /// The halfedge after the last; if it is the first, the walk is empty.
    pub until: Term,
    /// True if a walk that ends where it starts goes all the way around instead.
    pub around: bool,
}

/// The step of a walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// `h.next`, along a loop.
    Next,
    /// `h.twin.next`, clockwise around a vertex, which needs no `prev`.
    Clockwise,
}

/// The walk along a path, from its first halfedge up to the item after it in `before`, that sets
/// its face.
pub(super) fn path_walk(drawing: &Drawing, names: &mut Names, path: NameId) -> Option<Statement> {
    let face = drawing.after.face(path)?;
    let next = drawing.before.item_after(path)?;
    let ends = [path, next].map(|name| names.term(name));
    Some(setting(names, (Pointer::Face, face), Step::Next, ends, next == path))
}

/// The walk over the spokes of a fan, clockwise, from after the spoke that follows it up to the
/// spoke that precedes it, that sets their vertex.
pub(super) fn fan_walk(drawing: &Drawing, names: &mut Names, fan: NameId) -> Option<Statement> {
    let after = drawing.after.star_of_spoke(fan)?;
    let vertex = drawing.before.star_of_spoke(fan)?;
    let spokes = &drawing.before.star(vertex)?.spokes;
    let is_fan = |spoke: &Spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan);
    let at = spokes.iter().position(is_fan)?;
    let half = |at: usize| match &spokes[at % spokes.len()] {
        Spoke::Halfedge(half) => Some(half.name),
        Spoke::Fan(_) | Spoke::Rest(_) => None,
    };
    let (ends, around) = match (half(at + spokes.len() - 1), half(at + 1)) {
        (Some(previous), Some(following)) => {
            let twin = match drawing.before.twin(following) {
                Some(twin) => names.term(twin),
                None => names.term(following).follow(Pointer::Twin),
            };
            ([twin.follow(Pointer::Next), names.term(previous)], false)
        }
        // The fan is the whole star.
        _ => {
            let first = names.term(vertex).follow(Pointer::VertexHalfedge);
            ([first.clone(), first], true)
        }
    };
    Some(setting(names, (Pointer::Vertex, after), Step::Clockwise, ends, around))
}

/// A walk that sets a pointer of its halfedges.
fn setting(
    names: &mut Names,
    (pointer, value): (Pointer, NameId),
    step: Step,
    [from, until]: [Term; 2],
    around: bool,
) -> Statement {
    let halfedge = names.fresh("h");
    names.taken.remove(&halfedge);
    let body = vec![Statement::set(pointer, Term::name(&halfedge), names.term(value))];
    Statement::Walk { walk: HalfedgeWalk { halfedge, step, from, until, around }, body }
}
