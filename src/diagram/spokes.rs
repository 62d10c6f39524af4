//! Which halfedges start at a vertex: what its `halfedge` may be.

use super::{Drawing, Kind, NameId, Ref, Spoke};

impl Drawing<'_> {
    /// Whether all that started at a vertex before still does after, so that its `halfedge`
    /// stays right, whichever it is.
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
        let listed = self.after.star(vertex).and_then(|star| {
            star.spokes.iter().find_map(|spoke| match spoke {
                Spoke::Halfedge(Ref { name, .. }) => Some(*name),
                Spoke::Fan(_) | Spoke::Rest(_) => None,
            })
        });
        let mut halfedges = self.rule.names_of(Kind::Halfedge);
        listed.or_else(|| halfedges.find(|&half| self.starts_after(half, vertex)))
    }

    /// The paths that start at a vertex after, those that cannot be empty first, then
    /// those that start there where names are one.
    pub fn paths_after(&self, vertex: NameId) -> Vec<NameId> {
        let paths = self.rule.names_of(Kind::Path);
        let mut paths: Vec<_> = paths.filter(|&path| self.starts_after(path, vertex)).collect();
        paths.sort_by_key(|&path| self.is_empty_somewhere(path));
        if !paths.is_empty() {
            paths.extend(self.paths_where_one(vertex));
        }
        paths
    }

    fn starts_after(&self, item: NameId, vertex: NameId) -> bool {
        let drawn = self.after.loop_of_item(item).is_some() || self.after.pairing(item).is_some();
        drawn && self.origin_after(item) == Some(vertex)
    }
}
