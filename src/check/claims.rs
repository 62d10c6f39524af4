//! What a drawing claims beyond the pointers that bind its names; the matcher tests it.

use super::matching::{Bound, Claim, Source, Step};
use super::reach::Reach;
use crate::diagram::{Kind, Loop, LoopKind, NameId, Spoke};

impl Reach<'_> {
    /// Everything the drawing claims that binding has not used.
    pub fn claims(&mut self) {
        let claims = [
            self.kind_claims(),
            self.pointer_claims(),
            self.element_claims(),
            self.distinct_claims(),
            self.order_claims(),
            self.emptiness_claims(),
        ];
        self.steps
            .extend(claims.into_iter().flatten().map(Step::Test));
    }

    fn pointer_claims(&self) -> Vec<Claim> {
        let unused = self.pointers.iter().filter(|pointer| !pointer.used);
        unused
            .map(|pointer| Claim::Leads(pointer.forward(), Bound::Element(pointer.to)))
            .collect()
    }

    /// One claim for each piece of an orbit after the first: pieces of a loop lie in one
    /// face, chains of a vertex at one vertex.
    fn element_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        for orbit in &rule.before.loops {
            let face = orbit.face.name;
            let count = orbit.items.len();
            let is_path = |at: usize| rule.kind(orbit.items[at % count].item.name) == Kind::Path;
            for (at, item) in orbit.items.iter().enumerate() {
                // A halfedge behind a path begins a piece, or the first one of all does.
                let begins = !is_path(at)
                    && (is_path(at + count - 1) || (at == 0 && !(0..count).any(is_path)));
                let claim = Claim::Leads(
                    Source::Face(Bound::Element(item.item.name)),
                    Bound::Element(face),
                );
                if begins && !self.has_step(&claim) {
                    claims.push(claim);
                }
            }
        }
        for corner in self.corners {
            for chain in &corner.chains {
                let Some((_, source)) = self.vertex_source(&chain.ports) else {
                    continue;
                };
                let claim = Claim::Leads(source, Bound::Element(corner.vertex));
                if !self.has_step(&claim) {
                    claims.push(claim);
                }
            }
        }
        claims
    }

    /// Whether the claim is a step already, as a test or as what binds its name.
    fn has_step(&self, claim: &Claim) -> bool {
        self.steps.iter().any(|step| match (step, claim) {
            (Step::Test(test), claim) => test == claim,
            (Step::Bind { name, source }, Claim::Leads(from, to)) => name == to && source == from,
            _ => false,
        })
    }

    fn kind_claims(&self) -> Vec<Claim> {
        let loops = self.drawing.rule.before.loops.iter();
        loops
            .filter(|orbit| orbit.kind != LoopKind::Any)
            .map(|orbit| Claim::Kind(orbit.face.name, orbit.kind))
            .collect()
    }

    fn drawn(&self, kind: Kind) -> Vec<NameId> {
        let names = self.drawing.rule.names_of(kind);
        names
            .filter(|&name| self.drawing.before.mention(name).is_some())
            .collect()
    }

    fn distinct_claims(&self) -> Vec<Claim> {
        let mut claims = Vec::new();
        let mut pairs = |names: &[NameId], implied: &dyn Fn(NameId, NameId) -> bool| {
            for (at, &left) in names.iter().enumerate() {
                for &right in &names[at + 1..] {
                    if !implied(left, right) {
                        claims.push(Claim::Distinct(left, right));
                    }
                }
            }
        };
        pairs(&self.drawn(Kind::Vertex), &|_, _| false);
        pairs(&self.drawn(Kind::Halfedge), &|left, right| {
            self.differ(left, right)
        });
        pairs(&self.drawn(Kind::Face), &|left, right| {
            self.faces_differ(left, right)
        });
        // Two edges are distinct because their halfedges are.
        claims
    }

    /// Whether two halfedges are surely distinct, given that the vertices are.
    fn differ(&self, left: NameId, right: NameId) -> bool {
        let drawing = self.drawing;
        let origins = drawing.origin_before(left) != drawing.origin_before(right);
        let targets = drawing.target_before(left) != drawing.target_before(right);
        origins || targets || drawing.before.twin(left) == Some(right)
    }

    /// Whether two faces are surely distinct: of different kinds, or one is drawn in full
    /// and a halfedge of the other is none of its own.
    fn faces_differ(&self, left: NameId, right: NameId) -> bool {
        let view = &self.drawing.before;
        let (Some(left), Some(right)) = (view.loop_of_face(left), view.loop_of_face(right)) else {
            return false;
        };
        let halfedge = |item: NameId| self.drawing.rule.kind(item) == Kind::Halfedge;
        let apart =
            |full: &Loop, other: &Loop| {
                let in_full: Vec<_> = full.items.iter().map(|item| item.item.name).collect();
                in_full.iter().all(|&item| halfedge(item))
                    && other.items.iter().map(|item| item.item.name).any(|item| {
                        halfedge(item) && in_full.iter().all(|&own| self.differ(own, item))
                    })
            };
        let kinds = (left.kind, right.kind);
        matches!(
            kinds,
            (LoopKind::Face, LoopKind::Hole) | (LoopKind::Hole, LoopKind::Face)
        ) || apart(left, right)
            || apart(right, left)
    }

    /// The order of three or more pieces of a loop, or of a star.
    fn order_claims(&self) -> Vec<Claim> {
        let rule = self.drawing.rule;
        let mut claims = Vec::new();
        let mut in_order = |along_loop: bool, pieces: &[NameId]| {
            if pieces.len() < 3 {
                return;
            }
            for at in 1..pieces.len() - 1 {
                let halfedges = [pieces[0], pieces[at], pieces[at + 1]];
                claims.push(Claim::InOrder {
                    along_loop,
                    halfedges,
                });
            }
        };
        for orbit in &rule.before.loops {
            let count = orbit.items.len();
            let is_path = |at: usize| rule.kind(orbit.items[at % count].item.name) == Kind::Path;
            let behind_path = |&at: &usize| is_path(at + count - 1) && !is_path(at);
            let pieces: Vec<_> = (0..count)
                .filter(behind_path)
                .map(|at| orbit.items[at].item.name)
                .collect();
            in_order(true, &pieces);
        }
        for star in &rule.before.stars {
            let count = star.spokes.len();
            let pieces: Vec<_> = (0..count)
                .filter_map(
                    |at| match (&star.spokes[(at + count - 1) % count], &star.spokes[at]) {
                        (Spoke::Fan(_) | Spoke::Rest(_), Spoke::Halfedge(half)) => Some(half.name),
                        _ => None,
                    },
                )
                .collect();
            in_order(false, &pieces);
        }
        claims
    }

    /// A loop of `after` may not be left without halfedges.
    fn emptiness_claims(&self) -> Vec<Claim> {
        let mut claims = Vec::new();
        for orbit in &self.drawing.rule.after.loops {
            let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
            let may_be_empty = |&item: &NameId| {
                self.drawing.rule.kind(item) == Kind::Path && self.drawing.may_be_empty(item)
            };
            if items.iter().all(may_be_empty) {
                claims.push(Claim::NotAllEmpty(items));
            }
        }
        claims
    }
}
