//! Claims of a drawing beyond the pointers that bind its names; the matcher tests them.

use super::matching::{Bound, Claim, Step, Way};
use super::reach::Reach;
use crate::diagram::{Kind, Loop, LoopKind, NameId, Spoke, Star};

impl Reach<'_> {
    /// Appends tests for everything that the drawing claims and binding has not used.
    pub fn claims(&mut self) {
        let claims = [
            self.kind_claims(),
            self.pointer_claims(),
            self.element_claims(),
            self.distinct_claims(),
            self.order_claims(),
            self.emptiness_claims(),
            self.spoke_claims(),
        ];
        self.steps.extend(claims.into_iter().flatten().map(Step::Test));
    }

    fn pointer_claims(&self) -> Vec<Claim> {
        let unused = self.pointers.iter().filter(|pointer| !pointer.used);
        unused.map(|pointer| Claim::Leads(pointer.forward(), Bound::Element(pointer.to))).collect()
    }

    /// One claim for each piece of an orbit after the first: pieces of a loop lie in one
    /// face, chains of a vertex at one vertex.
    fn element_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        for orbit in &rule.before.loops {
            let face = orbit.face.name;
            let count = orbit.items.len();
            if !rule.is_first(face) {
                continue;
            }
            let is_path = |at: usize| rule.kind(orbit.items[at % count].item.name) == Kind::Path;
            for (at, item) in orbit.items.iter().enumerate() {
                // A piece begins at a halfedge behind a path, or, without paths, at the first
                // halfedge.
                let begins = !is_path(at)
                    && (is_path(at + count - 1) || (at == 0 && !(0..count).any(is_path)));
                let claim = Claim::Leads(
                    Way::Face.of(Bound::Element(item.item.name)),
                    Bound::Element(face),
                );
                if begins && rule.is_first(item.item.name) && !self.has_step(&claim) {
                    claims.push(claim);
                }
            }
        }
        for corner in self.corners {
            for chain in &corner.chains {
                let Some((_, source)) = self.vertex_source(&chain.ports) else { continue };
                let claim = Claim::Leads(source, Bound::Element(corner.vertex));
                let by = -i64::from(rule.index(claim.names()[0]));
                let claim = Claim::Leads(
                    source.turned(rule, by),
                    Bound::Element(rule.turned(corner.vertex, by)),
                );
                if !claims.contains(&claim) && !self.has_step(&claim) {
                    claims.push(claim);
                }
            }
        }
        claims
    }

    /// True if a step already tests the claim or binds its name by it.
    fn has_step(&self, claim: &Claim) -> bool {
        let rule = self.drawing.rule;
        self.steps.iter().any(|step| match (step, claim) {
            (Step::Test(test), claim) => test == claim,
            // A binding between one member and a single name is no claim about all members.
            (Step::Bind { name, source }, Claim::Leads(from, to)) => {
                name == to
                    && source == from
                    && rule.is_member(name.name()) == rule.is_member(source.from.name())
            }
            _ => false,
        })
    }

    fn kind_claims(&self) -> Vec<Claim> {
        let loops = self.drawing.rule.before.loops.iter();
        loops
            .filter(|orbit| orbit.kind != LoopKind::Any)
            .filter(|orbit| self.drawing.rule.is_first(orbit.face.name))
            .map(|orbit| Claim::Kind(orbit.face.name, orbit.kind))
            .collect()
    }

    /// Pairs of single names are compared one by one; families all at once.
    fn distinct_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        for kind in [Kind::Vertex, Kind::Halfedge, Kind::Face] {
            let mut all = Vec::new();
            for &[left, right] in &self.same {
                if rule.kind(left) != kind {
                    continue;
                }
                if !rule.is_member(left) && !rule.is_member(right) {
                    claims.push(Claim::Distinct(left, right));
                    continue;
                }
                for name in [left, right] {
                    if !all.contains(&name) {
                        all.push(name);
                    }
                }
            }
            if !all.is_empty() {
                claims.push(Claim::AllDistinct(all));
            }
        }
        claims
    }

    /// The order of three or more pieces of a loop, or of a star.
    fn order_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        let size = rule.size().unwrap_or(1) as usize;
        let mut in_order = |along_loop: bool, each: bool, pieces: &[NameId]| {
            if each && !pieces.is_empty() {
                let halfedges = pieces[..pieces.len() / size].to_vec();
                claims.push(Claim::AroundInOrder { along_loop, halfedges });
            }
            if each || pieces.len() < 3 {
                return;
            }
            for at in 1..pieces.len() - 1 {
                let halfedges = [pieces[0], pieces[at], pieces[at + 1]];
                claims.push(Claim::InOrder { along_loop, halfedges });
            }
        };
        let first = |orbit: &&Loop| rule.is_first(orbit.face.name);
        for orbit in rule.before.loops.iter().filter(first) {
            let count = orbit.items.len();
            let is_path = |at: usize| rule.kind(orbit.items[at % count].item.name) == Kind::Path;
            let behind_path = |&at: &usize| is_path(at + count - 1) && !is_path(at);
            let pieces: Vec<_> =
                (0..count).filter(behind_path).map(|at| orbit.items[at].item.name).collect();
            in_order(true, orbit.each, &pieces);
        }
        let first = |star: &&Star| rule.is_first(star.vertex.name);
        for star in rule.before.stars.iter().filter(first) {
            let count = star.spokes.len();
            let pieces: Vec<_> = (0..count)
                .filter(|at| star.spokes[(at + count - 1) % count].halfedge().is_none())
                .filter_map(|at| star.spokes[at].halfedge())
                .collect();
            in_order(false, star.each, &pieces);
        }
        claims
    }

    /// A loop of `after` may not be left without halfedges.
    fn emptiness_claims(&self) -> Vec<Claim> {
        let mut claims = Vec::new();
        let rule = self.drawing.rule;
        let size = rule.size().unwrap_or(1) as usize;
        for orbit in &rule.after.loops {
            let items: Vec<_> = orbit.item_names().collect();
            let may_be_empty = |&item: &NameId| {
                rule.kind(item) == Kind::Path && self.drawing.is_empty_somewhere(item)
            };
            if !rule.is_first(orbit.face.name) || !items.iter().all(may_be_empty) {
                continue;
            }
            claims.push(match orbit.each {
                true => Claim::NotAllEmptyAround(items[..items.len() / size].to_vec()),
                false => Claim::NotAllEmpty(items),
            });
        }
        claims
    }

    /// A named halfedge lies in no fan: where its vertex may be the same as another that has a
    /// statement, it has to be one of the spokes listed there.
    fn spoke_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        for star in &rule.before.stars {
            let spokes: Vec<_> = star.spokes.iter().filter_map(Spoke::halfedge).collect();
            let vertex = star.vertex.name;
            for halfedge in rule.names_of(Kind::Halfedge) {
                let origin = self.drawing.origin_before(halfedge);
                let elsewhere = |of: &NameId| *of != vertex && rule.may_be_one(*of, vertex);
                let drawn = self.drawing.before.mention(halfedge).is_some();
                if let Some(origin) = origin.filter(elsewhere)
                    && drawn
                {
                    let (vertices, spokes) = ([origin, vertex], spokes.clone());
                    claims.push(Claim::Listed { halfedge, vertices, spokes });
                }
            }
        }
        claims
    }
}
