//! The halfedges that start at a vertex, one of which is its `halfedge`.

use super::{Drawing, Kind, Loop, NameId, Spoke};

impl Drawing<'_> {
    /// True if everything that started at a vertex before still does after, so that its `halfedge`
    /// stays valid, whichever it is.
    pub fn keeps_its_spokes(&self, vertex: NameId) -> bool {
        let rule = self.rule;
        let stays =
            |item: NameId| self.erased(item).is_none() && self.origin_after(item) == Some(vertex);
        let mut items =
            rule.names_of(Kind::Halfedge).chain(rule.names_of(Kind::Path)).filter(|&item| {
                self.before.mention(item).is_some() && self.origin_before(item) == Some(vertex)
            });
        let mut fans =
            rule.names_of(Kind::Fan).filter(|&fan| self.before.star_of_spoke(fan) == Some(vertex));
        self.survives(vertex)
            && items.all(stays)
            && fans.all(|fan| self.after.star_of_spoke(fan) == Some(vertex))
    }

    /// A halfedge that starts at a vertex after: the first of its statement, else the first
    /// that is drawn.
    pub fn spoke_after(&self, vertex: NameId) -> Option<NameId> {
        let listed =
            self.after.star(vertex).and_then(|star| star.spokes.iter().find_map(Spoke::halfedge));
        let mut halfedges = self.rule.names_of(Kind::Halfedge);
        listed.or_else(|| halfedges.find(|&half| self.starts_after(half, vertex)))
    }

    /// A path that starts at a vertex after; one that cannot be empty, if there is one.
    pub fn path_after(&self, vertex: NameId) -> Option<NameId> {
        let paths = self.rule.names_of(Kind::Path).filter(|&path| self.starts_after(path, vertex));
        paths.min_by_key(|&path| self.is_empty_somewhere(path))
    }

    /// The possible starts of a path in `after`: the path itself, and while all so far may be
    /// empty, the items that follow it in its loop. The two ends of an empty path are one vertex,
    /// so the first of these that is not empty starts at its vertex, under whichever name.
    pub fn heads_after(&self, path: NameId) -> Vec<NameId> {
        let size = self.rule.size().unwrap_or(1) as usize;
        let period = |orbit: &Loop| orbit.items.len() / if orbit.each { size } else { 1 };
        let most = self.after.loop_of_item(path).map_or(1, period);
        let mut heads = vec![path];
        let mut last = path;
        while heads.len() < most
            && self.rule.kind(last) == Kind::Path
            && self.is_empty_somewhere(last)
            && let Some(next) = self.after.item_after(last)
        {
            heads.push(next);
            last = next;
        }
        heads
    }

    fn starts_after(&self, item: NameId, vertex: NameId) -> bool {
        let drawn = self.after.loop_of_item(item).is_some() || self.after.pairing(item).is_some();
        drawn && self.origin_after(item) == Some(vertex)
    }
}
