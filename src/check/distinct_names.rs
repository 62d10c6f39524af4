//! Pairs of names of a drawing that only a test keeps apart.
//!
//! Different names are different elements, unless an `alias` lets them be one. Usually the drawing
//! implies it: halfedges that start at different vertices differ, and so do those that lie in
//! different faces. And pointers are one to one: if two halfedges differ, so do their twins, and
//! the halfedges before and after them. So of several pairs that imply each other, one is tested.

use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId};

/// The pairs of names of one kind that could be one element, as far as the drawing and the pairs
/// before them tell: vertices, then halfedges, then faces. Two edges differ because their halfedges
/// do.
pub(super) fn pairs(drawing: &Drawing) -> Vec<[NameId; 2]> {
    let rule = drawing.rule;
    let tested = |pair: &[NameId; 2]| !rule.may_be_one(pair[0], pair[1]);
    let mut found: Vec<_> = pairs_of(drawing, Kind::Vertex).filter(tested).collect();
    let mut known = Apart::new(drawing);
    for [left, right] in pairs_of(drawing, Kind::Halfedge).collect::<Vec<_>>() {
        if differ(drawing, left, right) || lie_in_different_faces(drawing, left, right) {
            known.learn([left, right]);
        }
    }
    for pair in pairs_of(drawing, Kind::Halfedge).filter(tested) {
        if !known.knows(pair) {
            found.push(pair);
            known.learn(pair);
        }
    }
    let faces = pairs_of(drawing, Kind::Face).filter(tested);
    found.extend(faces.filter(|&[left, right]| !faces_differ(drawing, left, right)));
    found
}

/// All pairs of names of one kind that `before` draws.
pub(super) fn pairs_of(drawing: &Drawing, kind: Kind) -> impl Iterator<Item = [NameId; 2]> {
    let drawn = |name: &NameId| drawing.before.mention(*name).is_some();
    let names: Vec<_> = drawing.rule.names_of(kind).filter(drawn).collect();
    (0..names.len()).flat_map(move |at| {
        let left = names[at];
        let others = names[at + 1..].to_vec();
        others.into_iter().map(move |right| [left, right])
    })
}

/// Pairs of halfedges that are known to differ.
struct Apart<'a> {
    drawing: &'a Drawing<'a>,
    count: usize,
    known: Vec<bool>,
}

impl<'a> Apart<'a> {
    fn new(drawing: &'a Drawing) -> Self {
        let count = drawing.rule.names.len();
        Self { drawing, count, known: vec![false; count * count] }
    }

    fn place(&self, [left, right]: [NameId; 2]) -> usize {
        left.min(right).index() * self.count + left.max(right).index()
    }

    fn knows(&self, pair: [NameId; 2]) -> bool {
        self.known[self.place(pair)]
    }

    /// Notes that two halfedges differ, and all that follows from it.
    fn learn(&mut self, pair: [NameId; 2]) {
        let mut open = vec![pair];
        while let Some(pair) = open.pop() {
            let place = self.place(pair);
            if std::mem::replace(&mut self.known[place], true) {
                continue;
            }
            let view = &self.drawing.before;
            let is_halfedge = |item: &NameId| self.drawing.rule.kind(*item) == Kind::Halfedge;
            let images = [
                pair.map(|half| view.twin(half)),
                pair.map(|half| view.item_after(half).filter(is_halfedge)),
                pair.map(|half| view.item_before(half).filter(is_halfedge)),
            ];
            for image in images {
                if let [Some(left), Some(right)] = image
                    && left != right
                {
                    open.push([left, right]);
                }
            }
        }
    }
}

/// True if two halfedges are surely distinct, given that the vertices are.
fn differ(drawing: &Drawing, left: NameId, right: NameId) -> bool {
    let origins = [left, right].map(|half| drawing.origin_before(half));
    let targets = [left, right].map(|half| drawing.target_before(half));
    are_apart(drawing, origins)
        || are_apart(drawing, targets)
        || drawing.before.twin(left) == Some(right)
}

/// True if two halfedges are surely distinct, given that the faces are.
fn lie_in_different_faces(drawing: &Drawing, left: NameId, right: NameId) -> bool {
    let faces = [left, right].map(|half| drawing.before.face(half));
    are_apart(drawing, faces)
}

/// True if both names are there, differ, and may not be one element.
fn are_apart(drawing: &Drawing, pair: [Option<NameId>; 2]) -> bool {
    let [Some(left), Some(right)] = pair else { return false };
    left != right && !drawing.rule.may_be_one(left, right)
}

/// True if two faces are surely distinct: they are of different kinds, or one is drawn in full and
/// a halfedge of the other differs from all of its own.
fn faces_differ(drawing: &Drawing, left: NameId, right: NameId) -> bool {
    let view = &drawing.before;
    let (Some(left), Some(right)) = (view.loop_of_face(left), view.loop_of_face(right)) else {
        return false;
    };
    let halfedge = |item: NameId| drawing.rule.kind(item) == Kind::Halfedge;
    let apart = |full: &Loop, other: &Loop| {
        let in_full: Vec<_> = full.item_names().collect();
        in_full.iter().all(|&item| halfedge(item))
            && other
                .item_names()
                .any(|item| halfedge(item) && in_full.iter().all(|&own| differ(drawing, own, item)))
    };
    let kinds = (left.kind, right.kind);
    matches!(kinds, (LoopKind::Face, LoopKind::Hole) | (LoopKind::Hole, LoopKind::Face))
        || apart(left, right)
        || apart(right, left)
}
