//! Which names of a drawing nothing but a test keeps apart.
//!
//! Different names are different elements. Often the drawing implies it: halfedges that start
//! at different vertices differ.

use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId};

/// The pairs of names of one kind that could be one element, as far as the drawing says:
/// vertices, then halfedges, then faces. Two edges differ because their halfedges do.
pub(super) fn pairs(drawing: &Drawing) -> Vec<[NameId; 2]> {
    let mut found = Vec::new();
    let mut pairs = |kind: Kind, implied: &dyn Fn(NameId, NameId) -> bool| {
        let names = drawing.rule.names_of(kind);
        let names: Vec<_> = names
            .filter(|&name| drawing.before.mention(name).is_some())
            .collect();
        for (at, &left) in names.iter().enumerate() {
            for &right in &names[at + 1..] {
                if !implied(left, right) {
                    found.push([left, right]);
                }
            }
        }
    };
    pairs(Kind::Vertex, &|_, _| false);
    pairs(Kind::Halfedge, &|left, right| differ(drawing, left, right));
    pairs(Kind::Face, &|left, right| {
        faces_differ(drawing, left, right)
    });
    found
}

/// Whether two halfedges are surely distinct, given that the vertices are.
fn differ(drawing: &Drawing, left: NameId, right: NameId) -> bool {
    let origins = drawing.origin_before(left) != drawing.origin_before(right);
    let targets = drawing.target_before(left) != drawing.target_before(right);
    origins || targets || drawing.before.twin(left) == Some(right)
}

/// Whether two faces are surely distinct: of different kinds, or one is drawn in full
/// and a halfedge of the other is none of its own.
fn faces_differ(drawing: &Drawing, left: NameId, right: NameId) -> bool {
    let view = &drawing.before;
    let (Some(left), Some(right)) = (view.loop_of_face(left), view.loop_of_face(right)) else {
        return false;
    };
    let halfedge = |item: NameId| drawing.rule.kind(item) == Kind::Halfedge;
    let apart =
        |full: &Loop, other: &Loop| {
            let in_full: Vec<_> = full.items.iter().map(|item| item.item.name).collect();
            in_full.iter().all(|&item| halfedge(item))
                && other.items.iter().map(|item| item.item.name).any(|item| {
                    halfedge(item) && in_full.iter().all(|&own| differ(drawing, own, item))
                })
        };
    let kinds = (left.kind, right.kind);
    matches!(
        kinds,
        (LoopKind::Face, LoopKind::Hole) | (LoopKind::Hole, LoopKind::Face)
    ) || apart(left, right)
        || apart(right, left)
}
