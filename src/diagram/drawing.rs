//! The places of the names of a rule, on each side.
//!
//! A [`View`] is the index of one side: the loop and position of each halfedge and path, the edge
//! of each halfedge, the statement of each element. If a name occurs twice, the first place counts;
//! the checker reports the second.

use super::{Edge, Kind, Loop, LoopItem, NameId, Ref, Rule, Side, Spoke, Star};
use crate::source::Span;

/// A rule with an index of its two sides.
#[derive(Clone, Debug)]
pub struct Drawing<'a> {
    pub rule: &'a Rule,
    /// The side before.
    pub before: View<'a>,
    /// The side after.
    pub after: View<'a>,
    created: Vec<Option<Span>>,
    erased: Vec<Option<Span>>,
}

impl<'a> Drawing<'a> {
    /// Indexes a rule.
    pub fn new(rule: &'a Rule) -> Self {
        let count = rule.names.len();
        let spans = |refs: &[Ref]| {
            let mut spans = vec![None; count];
            for mention in refs {
                spans[mention.name.index()].get_or_insert(mention.span);
            }
            spans
        };
        Self {
            rule,
            before: View::new(&rule.before, count),
            after: View::new(&rule.after, count),
            created: spans(&rule.created),
            erased: spans(&rule.erased),
        }
    }

    /// The place where `new` lists a name.
    pub fn created(&self, name: NameId) -> Option<Span> {
        self.created[name.index()]
    }

    /// The place where `erase` lists a name.
    pub fn erased(&self, name: NameId) -> Option<Span> {
        self.erased[name.index()]
    }

    /// True if a name is drawn before and is not erased.
    pub fn survives(&self, name: NameId) -> bool {
        self.before.mention(name).is_some() && self.erased(name).is_none()
    }

    /// True if a halfedge is drawn before only as the twin of one in a loop.
    pub fn is_outer(&self, halfedge: NameId) -> bool {
        self.rule.kind(halfedge) == Kind::Halfedge
            && self.before.mention(halfedge).is_some()
            && self.before.item_before(halfedge).is_none()
    }

    /// The vertex a halfedge or path starts at before.
    ///
    /// An outer halfedge starts where its drawn twin ends, or where a vertex statement
    /// lists it.
    pub fn origin_before(&self, item: NameId) -> Option<NameId> {
        let view = &self.before;
        view.loop_origin(item)
            .or_else(|| view.loop_target(view.twin(item)?))
            .or_else(|| view.star_of_spoke(item))
    }

    /// The vertex a halfedge or path ends at before.
    pub fn target_before(&self, item: NameId) -> Option<NameId> {
        let view = &self.before;
        view.loop_target(item).or_else(|| self.origin_before(view.twin(item)?))
    }

    /// The vertex a halfedge or path starts at after.
    ///
    /// An outer halfedge starts where its vertex statement says, else where its drawn twin ends,
    /// else where it starts before.
    pub fn origin_after(&self, item: NameId) -> Option<NameId> {
        let view = &self.after;
        view.loop_origin(item)
            .or_else(|| view.star_of_spoke(item))
            .or_else(|| view.loop_target(view.twin(item)?))
            .or_else(|| self.origin_before(item))
    }

    /// The vertex a halfedge or path ends at after.
    pub fn target_after(&self, item: NameId) -> Option<NameId> {
        let view = &self.after;
        view.loop_target(item).or_else(|| self.origin_after(view.twin(item)?))
    }

    /// Paths whose loop changes, so that `face` is rewritten along them.
    pub fn moved_paths(&self) -> impl Iterator<Item = NameId> {
        let paths = self.rule.names_of(Kind::Path);
        paths.filter(|&path| self.before.face(path) != self.after.face(path))
    }

    /// Fans whose vertex changes, so that `vertex` is rewritten around it.
    pub fn moved_fans(&self) -> impl Iterator<Item = NameId> {
        let fans = self.rule.names_of(Kind::Fan);
        fans.filter(|&fan| self.before.star_of_spoke(fan) != self.after.star_of_spoke(fan))
    }

    /// True if a path may have no halfedge: its ends before are one vertex, and it is not the whole
    /// of its loop.
    pub fn may_be_empty(&self, path: NameId) -> bool {
        let alone = self.before.loop_of_item(path).is_some_and(|l| l.items.len() == 1);
        !alone && self.before.loop_origin(path) == self.before.loop_target(path)
    }

    /// True if a path may be empty in some match: also where an `alias` lets its ends be one
    /// vertex, and in an unrolled rule, since the members of a family coincide where the cycle is
    /// short.
    pub fn is_empty_somewhere(&self, path: NameId) -> bool {
        let rule = self.rule;
        let view = &self.before;
        let first = |vertex: NameId| rule.first_member(vertex);
        let size = rule.size().unwrap_or(1) as usize;
        let orbit = view.loop_of_item(path);
        // With `each`, a period of one item is the whole loop where the cycle is shortest.
        let items = orbit.map(|orbit| orbit.items.len() / if orbit.each { size } else { 1 });
        let [from, to] = [view.loop_origin(path), view.loop_target(path)];
        let one = from.zip(to).is_some_and(|(from, to)| rule.may_be_one(from, to));
        items != Some(1) && (one || from.map(first) == to.map(first))
    }
}

/// The index of one side.
#[derive(Clone, Debug)]
pub struct View<'a> {
    side: &'a Side,
    place: Vec<Option<(usize, usize)>>,
    pairing: Vec<Option<(usize, usize)>>,
    statement: Vec<Option<usize>>,
    spoke: Vec<Option<(usize, usize)>>,
    mention: Vec<Option<Span>>,
}

impl<'a> View<'a> {
    fn new(side: &'a Side, count: usize) -> Self {
        let mut view = Self {
            side,
            place: vec![None; count],
            pairing: vec![None; count],
            statement: vec![None; count],
            spoke: vec![None; count],
            mention: vec![None; count],
        };
        for (at, orbit) in side.loops.iter().enumerate() {
            view.state(orbit.face, at);
            for (position, item) in orbit.items.iter().enumerate() {
                view.see(item.from);
                view.see(item.item);
                view.place[item.item.name.index()].get_or_insert((at, position));
            }
            view.see(orbit.end);
        }
        for (at, edge) in side.edges.iter().enumerate() {
            view.state(edge.edge, at);
            for (position, halfedge) in edge.halfedges.iter().enumerate() {
                view.see(*halfedge);
                view.pairing[halfedge.name.index()].get_or_insert((at, position));
            }
        }
        for (at, star) in side.stars.iter().enumerate() {
            view.state(star.vertex, at);
            for (position, spoke) in star.spokes.iter().enumerate() {
                if let Spoke::Halfedge(name) | Spoke::Fan(name) = spoke {
                    view.see(*name);
                    view.spoke[name.name.index()].get_or_insert((at, position));
                }
            }
        }
        for &kept in &side.kept {
            view.see(kept);
        }
        view
    }

    fn see(&mut self, mention: Ref) {
        self.mention[mention.name.index()].get_or_insert(mention.span);
    }

    fn state(&mut self, mention: Ref, statement: usize) {
        self.see(mention);
        self.statement[mention.name.index()].get_or_insert(statement);
    }

    pub fn side(&self) -> &'a Side {
        self.side
    }

    /// The place where a name is first mentioned on this side.
    pub fn mention(&self, name: NameId) -> Option<Span> {
        self.mention[name.index()]
    }

    /// The loop statement of a face.
    pub fn loop_of_face(&self, face: NameId) -> Option<&'a Loop> {
        self.side.loops.get(self.statement[face.index()]?)
    }

    pub fn edge_statement(&self, edge: NameId) -> Option<&'a Edge> {
        self.side.edges.get(self.statement[edge.index()]?)
    }

    /// The vertex statement of a vertex.
    pub fn star(&self, vertex: NameId) -> Option<&'a Star> {
        self.side.stars.get(self.statement[vertex.index()]?)
    }

    /// The loop a halfedge or path is in, and what is drawn there.
    pub fn loop_item(&self, item: NameId) -> Option<(&'a Loop, &'a LoopItem)> {
        let (orbit, position) = self.place[item.index()]?;
        let orbit = &self.side.loops[orbit];
        Some((orbit, &orbit.items[position]))
    }

    /// The loop a halfedge or path is in.
    pub fn loop_of_item(&self, item: NameId) -> Option<&'a Loop> {
        Some(self.loop_item(item)?.0)
    }

    /// The face a halfedge or path lies in.
    pub fn face(&self, item: NameId) -> Option<NameId> {
        Some(self.loop_of_item(item)?.face.name)
    }

    fn neighbor(&self, item: NameId, step: impl Fn(usize, usize) -> usize) -> Option<NameId> {
        let (orbit, position) = self.place[item.index()]?;
        let items = &self.side.loops[orbit].items;
        Some(items[step(position, items.len())].item.name)
    }

    /// The next halfedge or path in the loop.
    pub fn item_after(&self, item: NameId) -> Option<NameId> {
        self.neighbor(item, |position, count| (position + 1) % count)
    }

    /// The previous halfedge or path in the loop.
    pub fn item_before(&self, item: NameId) -> Option<NameId> {
        self.neighbor(item, |position, count| (position + count - 1) % count)
    }

    /// The next spoke around its vertex, counterclockwise, if the loops determine it: the twin of
    /// the item that precedes it.
    pub fn spoke_behind(&self, spoke: NameId) -> Option<NameId> {
        self.twin(self.item_before(spoke)?)
    }

    /// The spoke before it around its vertex, counterclockwise, if the loops and edges determine it:
    /// what follows its twin. It may be a path.
    pub fn spoke_ahead(&self, spoke: NameId) -> Option<NameId> {
        self.item_after(self.twin(spoke)?)
    }

    /// The mention of the vertex from which a halfedge or path leaves in its loop.
    pub fn origin_mention(&self, item: NameId) -> Option<Ref> {
        Some(self.loop_item(item)?.1.from)
    }

    /// The mention of the vertex at which a halfedge or path ends in its loop.
    pub fn target_mention(&self, item: NameId) -> Option<Ref> {
        let (orbit, position) = self.place[item.index()]?;
        let orbit = &self.side.loops[orbit];
        Some(orbit.items.get(position + 1).map_or(orbit.end, |next| next.from))
    }

    /// The vertex from which a halfedge or path leaves in its loop.
    pub fn loop_origin(&self, item: NameId) -> Option<NameId> {
        Some(self.origin_mention(item)?.name)
    }

    /// The vertex at which a halfedge or path ends in its loop.
    pub fn loop_target(&self, item: NameId) -> Option<NameId> {
        let (orbit, position) = self.place[item.index()]?;
        let items = &self.side.loops[orbit].items;
        Some(items[(position + 1) % items.len()].from.name)
    }

    /// The vertices from which and to which a halfedge or path runs in its loop.
    pub fn loop_ends(&self, item: NameId) -> Option<[NameId; 2]> {
        Some([self.loop_origin(item)?, self.loop_target(item)?])
    }

    /// The edge statement that lists a halfedge.
    pub fn pairing(&self, halfedge: NameId) -> Option<&'a Edge> {
        Some(&self.side.edges[self.pairing[halfedge.index()]?.0])
    }

    /// The halfedge on the other side of its edge statement.
    pub fn twin(&self, halfedge: NameId) -> Option<NameId> {
        let (edge, position) = self.pairing[halfedge.index()]?;
        Some(self.side.edges[edge].halfedges[1 - position].name)
    }

    /// The edge a halfedge belongs to.
    pub fn edge(&self, halfedge: NameId) -> Option<NameId> {
        Some(self.pairing(halfedge)?.edge.name)
    }

    /// The vertex whose statement lists a halfedge or fan as a spoke.
    pub fn star_of_spoke(&self, spoke: NameId) -> Option<NameId> {
        let (star, _) = self.spoke[spoke.index()]?;
        Some(self.side.stars[star].vertex.name)
    }

    /// The end of the last statement, after which one more can be written.
    pub fn end_of_statements(&self) -> Option<Span> {
        let loops = self.side.loops.iter().map(|orbit| orbit.span);
        let edges = self.side.edges.iter().map(|edge| edge.span);
        let stars = self.side.stars.iter().map(|star| star.span);
        let kept = self.side.kept.iter().map(|kept| kept.span);
        loops.chain(edges).chain(stars).chain(kept).max_by_key(|span| span.end).map(Span::after)
    }
}
