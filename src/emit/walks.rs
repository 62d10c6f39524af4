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

/// The walk along a path, from its first halfedge up to the item after it in `before`.
pub(super) fn along_path(
    drawing: &Drawing,
    names: &Names,
    path: NameId,
    halfedge: String,
) -> Option<HalfedgeWalk> {
    let next = drawing.before.item_after(path)?;
    Some(HalfedgeWalk {
        halfedge,
        step: Step::Next,
        from: names.term(path),
        until: names.term(next),
        around: next == path,
    })
}

/// The walk along a path that sets its face.
pub(super) fn path_walk(drawing: &Drawing, names: &mut Names, path: NameId) -> Option<Statement> {
    let face = drawing.after.face(path)?;
    let walk = |names: &Names, halfedge| along_path(drawing, names, path, halfedge);
    setting(names, Pointer::Face, face, walk)
}

/// The walk over a fan that sets its vertex.
pub(super) fn fan_walk(drawing: &Drawing, names: &mut Names, fan: NameId) -> Option<Statement> {
    let vertex = drawing.after.star_of_spoke(fan)?;
    let walk = |names: &Names, halfedge| along_fan(drawing, names, fan, halfedge);
    setting(names, Pointer::Vertex, vertex, walk)
}

fn setting(
    names: &mut Names,
    pointer: Pointer,
    value: NameId,
    walk: impl Fn(&Names, String) -> Option<HalfedgeWalk>,
) -> Option<Statement> {
    let halfedge = names.fresh("h");
    names.release(&halfedge);
    let walk = walk(names, halfedge.clone())?;
    let set = Statement::Set { pointer, of: Term::name(halfedge), value: names.term(value) };
    Some(Statement::Walk { walk, body: vec![set] })
}

/// The walk over the spokes of a fan, clockwise: from after the spoke that follows it up to the
/// spoke that precedes it.
pub(super) fn along_fan(
    drawing: &Drawing,
    names: &Names,
    fan: NameId,
    halfedge: String,
) -> Option<HalfedgeWalk> {
    let vertex = drawing.before.star_of_spoke(fan)?;
    let spokes = &drawing.before.star(vertex)?.spokes;
    let at =
        spokes.iter().position(|spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan))?;
    Some(along_spokes(drawing, names, vertex, (spokes, at), halfedge))
}

/// The walk over the run of spokes at a place of a vertex statement.
pub(super) fn along_spokes(
    drawing: &Drawing,
    names: &Names,
    vertex: NameId,
    (spokes, at): (&[Spoke], usize),
    halfedge: String,
) -> HalfedgeWalk {
    let count = spokes.len();
    let half = |spoke: &Spoke| match spoke {
        Spoke::Halfedge(half) => Some(half.name),
        Spoke::Fan(_) | Spoke::Rest(_) => None,
    };
    let (before, after) =
        (half(&spokes[(at + count - 1) % count]), half(&spokes[(at + 1) % count]));
    let step = Step::Clockwise;
    match (before, after) {
        (Some(before), Some(after)) => HalfedgeWalk {
            halfedge,
            step,
            from: match drawing.before.twin(after) {
                Some(twin) => names.term(twin).follow(Pointer::Next),
                None => names.term(after).follow(Pointer::Twin).follow(Pointer::Next),
            },
            until: names.term(before),
            around: false,
        },
        // The fan is the whole star.
        _ => {
            let first = names.term(vertex).follow(Pointer::VertexHalfedge);
            HalfedgeWalk { halfedge, step, from: first.clone(), until: first, around: true }
        }
    }
}
