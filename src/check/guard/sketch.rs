//! A sketch of the orbits of `after`, given that the mesh is a surface before.
//!
//! Before, a loop then has three sides or more, and meets a vertex at most once; a vertex has two
//! spokes or more, and at most one corner in a hole.

use super::super::chain::{Corner, corners};
use super::super::port::Links;
use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId, Spoke};

/// A drawing, and the corners of its `before`.
pub(super) struct Sketch<'a> {
    pub drawing: &'a Drawing<'a>,
    corners: Vec<Corner>,
}

impl<'a> Sketch<'a> {
    pub fn new(drawing: &'a Drawing<'a>) -> Self {
        let links = Links::of(drawing.rule, &drawing.rule.before);
        Self { drawing, corners: corners(drawing, &links) }
    }

    /// The vertices that exist after.
    pub fn vertices(&self) -> impl Iterator<Item = NameId> + '_ {
        let drawing = self.drawing;
        let vertices = drawing.rule.names_of(Kind::Vertex);
        vertices.filter(|&vertex| drawing.survives(vertex) || self.is_new(vertex))
    }

    pub fn is_new(&self, name: NameId) -> bool {
        self.drawing.created(name).is_some()
    }

    pub fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    /// True if an item surely has a halfedge.
    pub fn is_surely_there(&self, item: NameId) -> bool {
        !self.is_path(item) || !self.drawing.may_be_empty(item)
    }

    /// The halfedges that `after` draws.
    pub fn halfedges(&self) -> impl Iterator<Item = NameId> + '_ {
        let drawing = self.drawing;
        let halfedges = drawing.rule.names_of(Kind::Halfedge);
        halfedges
            .filter(|&half| drawing.after.mention(half).is_some() && drawing.erased(half).is_none())
    }

    /// The loops of `after`.
    pub fn loops(&self) -> &'a [Loop] {
        &self.drawing.rule.after.loops
    }

    /// True if a loop statement draws a corner at the vertex.
    pub fn draws(orbit: &Loop, vertex: NameId) -> bool {
        orbit.items.iter().any(|item| item.from.name == vertex)
    }

    pub fn paths<'l>(&'l self, orbit: &'l Loop) -> impl Iterator<Item = NameId> + 'l {
        orbit.item_names().filter(|&item| self.is_path(item))
    }

    /// The vertices of `before` whose undrawn spokes lie at a vertex of `after`, the vertex
    /// itself first.
    pub fn arcs(&self, vertex: NameId) -> Vec<NameId> {
        let drawing = self.drawing;
        let mut from = Vec::new();
        if drawing.survives(vertex) && self.has_arcs(vertex) && self.keeps_arcs(vertex) {
            from.push(vertex);
        }
        for fan in drawing.rule.names_of(Kind::Fan) {
            if drawing.after.star_of_spoke(fan) == Some(vertex)
                && let Some(source) = drawing.before.star_of_spoke(fan)
                && !from.contains(&source)
            {
                from.push(source);
            }
        }
        from
    }

    /// True if a vertex may have spokes that are not drawn.
    fn has_arcs(&self, vertex: NameId) -> bool {
        let corner = self.corners.iter().find(|corner| corner.vertex == vertex);
        corner.is_none_or(|corner| corner.chains.iter().any(|chain| !chain.closed))
    }

    /// True if some of the undrawn spokes of a vertex may stay with it.
    fn keeps_arcs(&self, vertex: NameId) -> bool {
        let view = &self.drawing.before;
        let stays = |spoke: &Spoke| match spoke {
            Spoke::Halfedge(_) => false,
            Spoke::Rest(_) => true,
            Spoke::Fan(fan) => {
                let after = self.drawing.after.star_of_spoke(fan.name);
                after.is_none_or(|after| after == vertex)
            }
        };
        view.star(vertex).is_none_or(|star| star.spokes.iter().any(stays))
    }

    /// The vertices of `before` that give corners in undrawn faces to a vertex of `after`:
    /// with their undrawn spokes, or with an outer halfedge.
    pub fn outside(&self, vertex: NameId) -> Vec<NameId> {
        let drawing = self.drawing;
        let mut from = self.arcs(vertex);
        for half in self.halfedges() {
            if drawing.is_outer(half)
                && drawing.origin_after(half) == Some(vertex)
                && let Some(source) = drawing.origin_before(half)
                && !from.contains(&source)
            {
                from.push(source);
            }
        }
        from
    }

    /// True if a vertex of `after` may lie on a path, apart from its ends.
    ///
    /// Only an undrawn corner does, and so one that it has from a vertex of `before`; and
    /// not from one that the loop of the path draws, since a loop meets a vertex once.
    pub fn may_lie_on(&self, vertex: NameId, path: NameId) -> bool {
        let orbit = self.drawing.before.loop_of_item(path);
        let drawn = |source: &NameId| orbit.is_some_and(|orbit| Self::draws(orbit, *source));
        !self.outside(vertex).iter().all(drawn)
    }

    /// The loops around a vertex that `after` draws and that may be holes: a loop for each corner.
    pub fn holes_after(&self, vertex: NameId) -> Vec<(NameId, LoopKind)> {
        holes(&self.drawing.rule.after.loops, vertex)
    }

    /// The same for `before`.
    pub fn holes_before(&self, vertex: NameId) -> Vec<(NameId, LoopKind)> {
        holes(&self.drawing.rule.before.loops, vertex)
    }

    /// True if two loops cannot both be holes: an edge of `before` lies between them, and neither
    /// changes its kind.
    pub fn never_both_holes(&self, left: NameId, right: NameId) -> bool {
        let drawing = self.drawing;
        let same_kind = |face: NameId| {
            let kinds = [&drawing.before, &drawing.after].map(|view| {
                let orbit = view.loop_of_face(face);
                orbit.map(|orbit| orbit.kind)
            });
            kinds[0].is_some() && kinds[0] == kinds[1]
        };
        let between = drawing.rule.before.edges.iter().any(|edge| {
            let sides = edge.halfedges.map(|half| drawing.before.face(half.name));
            sides == [Some(left), Some(right)] || sides == [Some(right), Some(left)]
        });
        left != right && between && same_kind(left) && same_kind(right)
    }

    /// The fewest halfedges that a loop of `after` can have.
    pub fn fewest(&self, orbit: &Loop) -> usize {
        let items: Vec<_> = orbit.item_names().collect();
        let drawn = items.iter().filter(|&&item| !self.is_path(item)).count();
        let mut fewest = drawn;
        for before in &self.drawing.rule.before.loops {
            let paths: Vec<_> = self.paths(before).collect();
            let here = paths.iter().filter(|path| items.contains(path));
            let own = here.clone().filter(|&&path| self.is_surely_there(path)).count();
            // All that is not drawn of the loop has come along.
            let rest = match here.count() == paths.len() && !paths.is_empty() {
                true => 3usize.saturating_sub(before.items.len() - paths.len()),
                false => 0,
            };
            fewest += own.max(rest);
        }
        fewest
    }

    /// The number of spokes that a vertex of `after` surely has.
    pub fn spokes_for_sure(&self, vertex: NameId) -> usize {
        let drawing = self.drawing;
        let out: Vec<_> =
            self.halfedges().filter(|&half| drawing.origin_after(half) == Some(vertex)).collect();
        let items = || self.loops().iter().flat_map(|orbit| &orbit.items);
        let firsts = items()
            .filter(|item| item.from.name == vertex && self.is_path(item.item.name))
            .filter(|item| self.is_surely_there(item.item.name))
            .count();
        // The twin of an arriving halfedge is a spoke too: one more if it is not drawn and no drawn
        // spoke leads to where it ends.
        let leads = |from: NameId| {
            out.iter().any(|&half| drawing.target_after(half).is_none_or(|target| target == from))
        };
        let arrives = |half: NameId| {
            !self.is_path(half)
                && drawing.after.pairing(half).is_none()
                && drawing.after.loop_target(half) == Some(vertex)
        };
        let twins = items()
            .filter(|item| firsts == 0 && arrives(item.item.name) && !leads(item.from.name))
            .count();
        out.len() + firsts + twins
    }

    /// True if a vertex may have lost a spoke.
    pub fn loses_a_spoke(&self, vertex: NameId) -> bool {
        let drawing = self.drawing;
        let rule = drawing.rule;
        if self.is_new(vertex) {
            return true;
        }
        let items = rule.names_of(Kind::Halfedge).chain(rule.names_of(Kind::Path));
        let leaves = |item: NameId| {
            drawing.before.mention(item).is_some()
                && drawing.origin_before(item) == Some(vertex)
                && (drawing.erased(item).is_some() || drawing.origin_after(item) != Some(vertex))
        };
        let fan_leaves = |fan: NameId| {
            drawing.before.star_of_spoke(fan) == Some(vertex)
                && drawing.after.star_of_spoke(fan) != Some(vertex)
        };
        let mut fans = rule.names_of(Kind::Fan);
        items.into_iter().any(leaves) || fans.any(fan_leaves)
    }

    /// True if all neighbors of a vertex of `after` are named.
    pub fn neighbors_are_named(&self, vertex: NameId) -> bool {
        let drawing = self.drawing;
        let ends =
            |path: NameId| [drawing.after.loop_origin(path), drawing.after.loop_target(path)];
        let mut paths = self.loops().iter().flat_map(|orbit| self.paths(orbit));
        let mut out = self.halfedges().filter(|&half| drawing.origin_after(half) == Some(vertex));
        self.arcs(vertex).is_empty()
            && !paths.any(|path| ends(path).contains(&Some(vertex)))
            && out.all(|half| drawing.target_after(half).is_some())
    }

    /// True if all faces and holes around a vertex of `after` are drawn: it has no outer halfedge,
    /// which would lie in another one.
    pub fn faces_are_drawn(&self, vertex: NameId) -> bool {
        let drawing = self.drawing;
        let starts_here = |half: NameId| drawing.origin_after(half) == Some(vertex);
        let mut outer = self.halfedges().filter(|&half| drawing.is_outer(half));
        self.neighbors_are_named(vertex) && !outer.any(starts_here)
    }

    /// The number of edges of `after` between two vertices that are drawn, or have a drawn
    /// halfedge.
    pub fn drawn_edges_between(&self, v: NameId, w: NameId) -> usize {
        let drawing = self.drawing;
        let ends = |half: NameId| (drawing.origin_after(half), drawing.target_after(half));
        let drawn = self.halfedges();
        drawn
            .filter(|&half| match drawing.after.pairing(half) {
                // Of two drawn twins one counts.
                Some(_) => ends(half) == (Some(v), Some(w)),
                None => ends(half) == (Some(v), Some(w)) || ends(half) == (Some(w), Some(v)),
            })
            .count()
    }
}

fn holes(loops: &[Loop], vertex: NameId) -> Vec<(NameId, LoopKind)> {
    let mut holes = Vec::new();
    for orbit in loops.iter().filter(|orbit| orbit.kind != LoopKind::Face) {
        let corners = orbit.items.iter().filter(|item| item.from.name == vertex);
        holes.extend(corners.map(|_| (orbit.face.name, orbit.kind)));
    }
    holes
}
