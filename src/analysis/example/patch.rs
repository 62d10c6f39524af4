//! The part of a mesh that an example shows: the faces at the place, and what has changed.
//!
//! A loop is drawn if it touches an element that the op was called with, or if something in it has
//! changed. Outside of the drawn loops nothing has changed, so both sides have the same outline. If
//! one of them is a hole, all of a small mesh is drawn; of the hole of a larger mesh, only the part
//! along drawn faces is drawn, and the rest is a path.

use std::cmp::{Ordering, Reverse};
use std::collections::BTreeSet;

use glam::DVec3;

use super::trial::Trial;
use crate::mesh::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// The most halfedges of a drawing that is still readable.
const MOST: usize = 128;
/// The greatest number of faces and holes of a small mesh.
const SMALL: usize = 9;

/// A part of a mesh that is drawn.
pub(super) struct Patch {
    /// The faces and holes on each side, those at the place first.
    pub(super) loops: [Vec<FaceId>; 2],
    /// The halfedges of partly drawn holes that are not drawn.
    pub(super) hidden: BTreeSet<HalfedgeId>,
    holes: usize,
    /// True if the place is neither a hole nor a halfedge of one.
    is_of_face: bool,
    /// True if a hole lies beside the place, not only at a corner of it.
    is_beside_hole: bool,
    /// True if the outline is a single loop that passes no vertex twice.
    is_plain: bool,
    /// True if no two vertices coincide.
    pub(super) is_spread: bool,
    /// The number of faces and holes that lie at the place.
    at_place: usize,
    /// The number of faces and holes of the mesh.
    all: usize,
}

/// The worth of a patch as an example; the greatest is best.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Worth {
    is_plain: bool,
    is_whole: bool,
    is_spread: bool,
    is_of_face: bool,
    is_beside_hole: bool,
    at_place: usize,
    few: Reverse<usize>,
}

impl Patch {
    /// The patch of a trial; `None` if it is too large to be drawn.
    pub(super) fn of(trial: &Trial) -> Option<Self> {
        let (before, after) = (&trial.before, &trial.after);
        let place: Vec<Element> = trial.place.iter().flatten().copied().collect();
        let corners = vertices(before, &place);
        let own: Vec<FaceId> = place.iter().flat_map(|of| faces(before, *of)).collect();
        let mut loops: Vec<FaceId> = Vec::new();
        let around = corners.iter().flat_map(|&v| before.spokes(v));
        for face in own.iter().copied().chain(around.map(|h| before.face(h))) {
            if !loops.contains(&face) {
                loops.push(face);
            }
        }
        let at_place = loops.len();
        let moved = before.vertices().filter(|&v| {
            let lives = after.vertex_alive(v);
            lives && before.position(v) != after.position(v)
        });
        let beside = moved.flat_map(|v| before.spokes(v)).map(|h| before.face(h));
        let changed = before.halfedges().filter(|&h| {
            let is_new = trial.created.contains(&h.into());
            is_new || !after.halfedge_alive(h) || before.halfedge(h) != after.halfedge(h)
        });
        for face in changed.map(|h| before.face(h)).chain(beside) {
            if !loops.contains(&face) {
                loops.push(face);
            }
        }
        let all: Vec<_> = before.faces().collect();
        if all.len() <= SMALL && loops.iter().any(|&f| before.is_hole(f)) {
            let others = all.iter().filter(|f| !loops.contains(f));
            loops.extend(others.copied().collect::<Vec<_>>());
        }
        let was_there = |h: HalfedgeId| {
            let is_old = before.halfedge_alive(h) && !trial.created.contains(&h.into());
            is_old.then(|| before.face(h))
        };
        let is_drawn_after = |h: HalfedgeId| was_there(h).is_none_or(|f| loops.contains(&f));
        let kept = loops.iter().copied().filter(|&f| after.face_alive(f));
        let others = after.faces();
        let mut loops_after: Vec<FaceId> = Vec::new();
        for face in kept.chain(others) {
            let first = after.face_halfedge(face);
            if is_drawn_after(first) && !loops_after.contains(&face) {
                loops_after.push(face);
            }
        }
        let mut patch = Self {
            hidden: BTreeSet::new(),
            holes: loops.iter().filter(|&&f| before.is_hole(f)).count(),
            is_of_face: !place.iter().any(|of| is_of_hole(before, *of)),
            is_beside_hole: own.iter().any(|&f| before.is_hole(f)),
            is_plain: false,
            is_spread: is_spread(after),
            at_place,
            all: all.len(),
            loops: [loops, loops_after],
        };
        patch.hide(trial);
        patch.is_plain = patch.has_plain_outline(before);
        (patch.size(0, before).max(patch.size(1, after)) <= MOST).then_some(patch)
    }

    /// True if a hole is drawn.
    pub(super) fn has_hole(&self) -> bool {
        self.holes > 0
    }

    /// True if no interior example can be better.
    pub(super) fn is_perfect(&self) -> bool {
        self.is_plain && self.is_spread && !self.has_hole()
    }

    /// The worth of the patch as an example. In the interior the first of several will do; at a
    /// boundary, more of the surroundings of the place is better, and less of the rest.
    pub(super) fn worth(&self) -> Worth {
        Worth {
            is_plain: self.is_plain,
            is_whole: self.hidden.is_empty(),
            is_spread: self.is_spread,
            is_of_face: self.is_of_face,
            is_beside_hole: self.is_beside_hole,
            at_place: if self.has_hole() { self.at_place } else { 0 },
            few: Reverse(if self.has_hole() { self.all } else { 0 }),
        }
    }

    /// The number of halfedges that are shown on a side, of which this is the mesh.
    fn size(&self, side: usize, mesh: &Mesh) -> usize {
        self.loops[side].iter().map(|&f| mesh.face_size(f)).sum::<usize>() - self.hidden.len()
    }

    /// Hides the halfedges of holes that are the same on both sides and lie along no drawn face.
    fn hide(&mut self, trial: &Trial) {
        let (before, after) = (&trial.before, &trial.after);
        let is_drawn = |mesh: &Mesh, side: usize, h: HalfedgeId| {
            self.loops[side].contains(&mesh.face(mesh.twin(h)))
        };
        let holes = self.loops[0].iter().filter(|&&f| before.is_hole(f));
        let along = holes.flat_map(|&f| before.face_halfedges(f));
        let hidden = along.filter(|&h| {
            let stays = after.halfedge_alive(h) && !trial.created.contains(&h.into());
            stays
                && after.is_boundary_halfedge(h)
                && !is_drawn(before, 0, h)
                && !is_drawn(after, 1, h)
        });
        self.hidden = hidden.collect();
    }

    /// True if the edges drawn on one side only form a single loop that passes no vertex twice.
    fn has_plain_outline(&self, mesh: &Mesh) -> bool {
        let is_drawn = |h: HalfedgeId| self.loops[0].contains(&mesh.face(h));
        let halfedges = self.loops[0].iter().flat_map(|&f| mesh.face_halfedges(f));
        let outline: Vec<_> = halfedges.filter(|&h| !is_drawn(mesh.twin(h))).collect();
        let starts: BTreeSet<_> = outline.iter().map(|&h| mesh.vertex(h)).collect();
        let Some(&first) = outline.first() else {
            // Everything is drawn: then one hole is the outside.
            return self.holes == 1;
        };
        let mut length = 0;
        let mut at = first;
        loop {
            length += 1;
            at = mesh.next(at);
            for _ in 0..MOST {
                if !is_drawn(mesh.twin(at)) {
                    break;
                }
                at = mesh.next(mesh.twin(at));
            }
            if at == first || length > outline.len() {
                break;
            }
        }
        length == outline.len() && starts.len() == outline.len()
    }
}

/// True if no two vertices coincide.
fn is_spread(mesh: &Mesh) -> bool {
    let mut places: Vec<_> = mesh.vertices().map(|v| mesh.position(v)).collect();
    let key = |at: &DVec3| at.to_array();
    places.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal));
    places.windows(2).all(|pair| (pair[0] - pair[1]).length() > 1e-9)
}

/// The vertices of some elements.
fn vertices(mesh: &Mesh, of: &[Element]) -> BTreeSet<VertexId> {
    let ends = |h: HalfedgeId| vec![mesh.vertex(h), mesh.target(h)];
    let vertices = of.iter().flat_map(|of| match of.kind {
        ElementKind::Vertex => vec![VertexId(of.index)],
        ElementKind::Halfedge => ends(HalfedgeId(of.index)),
        ElementKind::Edge => ends(mesh.edge_halfedge(EdgeId(of.index))),
        ElementKind::Face => mesh.face_vertices(FaceId(of.index)).collect(),
    });
    vertices.collect()
}

fn is_of_hole(mesh: &Mesh, of: Element) -> bool {
    match of.kind {
        ElementKind::Vertex | ElementKind::Edge => false,
        ElementKind::Halfedge => mesh.is_boundary_halfedge(HalfedgeId(of.index)),
        ElementKind::Face => mesh.is_hole(FaceId(of.index)),
    }
}

/// The faces and holes that an element is part of, and those beside it if it is one.
fn faces(mesh: &Mesh, of: Element) -> Vec<FaceId> {
    let sides = |h: HalfedgeId| vec![mesh.face(h), mesh.face(mesh.twin(h))];
    match of.kind {
        ElementKind::Vertex => mesh.spokes(VertexId(of.index)).map(|h| mesh.face(h)).collect(),
        ElementKind::Halfedge => sides(HalfedgeId(of.index)),
        ElementKind::Edge => sides(mesh.edge_halfedge(EdgeId(of.index))),
        ElementKind::Face => {
            let around = mesh.face_halfedges(FaceId(of.index)).map(|h| mesh.face(mesh.twin(h)));
            [FaceId(of.index)].into_iter().chain(around).collect()
        }
    }
}
