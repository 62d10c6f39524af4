//! Check that a rewritten mesh agrees with `after`.
//!
//! A mesh can be valid and still not be the one that is drawn: a path drawn from another vertex
//! than the one at which it starts, spokes in a different order.

use hedgerow::diagram::{Kind, LoopKind, NameId, Rule, Spoke, Star};
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, VertexId};

use super::rewriting::Rewritten;

/// A description of the first statement of `after` that does not hold, if there is one.
pub fn untrue(rule: &Rule, result: &Rewritten) -> Option<String> {
    let truth = Truth { rule, result };
    truth.loops().or_else(|| truth.edges()).or_else(|| truth.stars())
}

struct Truth<'a> {
    rule: &'a Rule,
    result: &'a Rewritten,
}

impl Truth<'_> {
    fn element(&self, name: NameId) -> u32 {
        self.result.at.elements[name.index()].unwrap_or(u32::MAX)
    }

    fn run(&self, name: NameId) -> Vec<HalfedgeId> {
        let run = self.result.at.runs[name.index()].iter().flatten();
        run.map(|&half| HalfedgeId(half)).collect()
    }

    fn word(&self, name: NameId) -> &str {
        &self.rule.name(name).text
    }

    fn loops(&self) -> Option<String> {
        let mesh = &self.result.mesh;
        for orbit in &self.rule.after.loops {
            let word = self.word(orbit.face.name);
            let face = FaceId(self.element(orbit.face.name));
            let hole = mesh.get_is_hole(face);
            let kind = match orbit.kind {
                LoopKind::Face => hole == Some(false),
                LoopKind::Hole => hole == Some(true),
                LoopKind::Any => hole.is_some(),
            };
            if !kind {
                return Some(format!("{word} is not of its kind"));
            }
            let mut cycle = Vec::new();
            let mut starts = Vec::new();
            for item in &orbit.items {
                starts.push((cycle.len(), VertexId(self.element(item.from.name))));
                match self.rule.kind(item.item.name) {
                    Kind::Halfedge => cycle.push(HalfedgeId(self.element(item.item.name))),
                    _ => cycle.extend(self.run(item.item.name)),
                }
            }
            let alive = cycle.iter().all(|&half| mesh.halfedge_alive(half));
            if !alive || !mesh.loop_from(cycle[0]).eq(cycle.iter().copied()) {
                return Some(format!("the loop of {word} is another"));
            }
            if cycle.iter().any(|&half| mesh.face(half) != face) {
                return Some(format!("the loop of {word} is that of another face"));
            }
            for (at, from) in starts {
                if mesh.vertex(cycle[at % cycle.len()]) != from {
                    return Some(format!("an item of {word} starts at another vertex"));
                }
            }
        }
        None
    }

    fn edges(&self) -> Option<String> {
        let mesh = &self.result.mesh;
        for statement in &self.rule.after.edges {
            let edge = EdgeId(self.element(statement.edge.name));
            let [left, right] = statement.halfedges.map(|half| HalfedgeId(self.element(half.name)));
            let paired = mesh.get_twin(left) == Some(right) && mesh.get_twin(right) == Some(left);
            let both = mesh.get_edge(left) == Some(edge) && mesh.get_edge(right) == Some(edge);
            if !paired || !both {
                return Some(format!("the edge {} is another", self.word(statement.edge.name)));
            }
        }
        None
    }

    fn stars(&self) -> Option<String> {
        let mesh = &self.result.mesh;
        for star in &self.rule.after.stars {
            let vertex = VertexId(self.element(star.vertex.name));
            if !mesh.vertex_alive(vertex) {
                return Some(format!("{} does not live", self.word(star.vertex.name)));
            }
            let ring: Vec<_> = mesh.spokes(vertex).collect();
            let turns = 0..ring.len().max(1);
            let mut turned = turns.map(|turn| {
                let (back, front) = ring.split_at(turn.min(ring.len()));
                [front, back].concat()
            });
            if !turned.any(|ring| self.lies(star, 0, &ring)) {
                let word = self.word(star.vertex.name);
                return Some(format!("the spokes of {word} are others, or in another order"));
            }
        }
        None
    }

    fn is_named(&self, half: HalfedgeId) -> bool {
        let mut names = self.rule.names_of(Kind::Halfedge);
        names.any(|name| self.element(name) == half.0)
    }

    /// Whether another statement of the same vertex, under a second name, lists a spoke.
    fn is_listed_elsewhere(&self, star: &Star, half: HalfedgeId) -> bool {
        let vertex = self.element(star.vertex.name);
        let stars = self.rule.after.stars.iter();
        let mut others = stars.filter(|other| {
            other.vertex.name != star.vertex.name && self.element(other.vertex.name) == vertex
        });
        others.any(|other| {
            let lists = |spoke: &Spoke| matches!(spoke, Spoke::Halfedge(name) if self.element(name.name) == half.0);
            other.spokes.iter().any(lists)
        })
    }

    /// Whether the spokes of a star from the `at`th on form the ring. The spokes of a fan stay
    /// together, but two pieces of a fan may be exchanged.
    fn lies(&self, star: &Star, at: usize, ring: &[HalfedgeId]) -> bool {
        let Some(spoke) = star.spokes.get(at) else {
            return ring.is_empty();
        };
        match *spoke {
            Spoke::Halfedge(half) => match ring {
                [first, ring @ ..] => {
                    first.0 == self.element(half.name) && self.lies(star, at + 1, ring)
                }
                [] => false,
            },
            Spoke::Fan(fan) => {
                let run = self.run(fan.name);
                let fits = ring.len() >= run.len();
                fits && {
                    let (here, ring) = ring.split_at(run.len());
                    here.iter().all(|half| run.contains(half)) && self.lies(star, at + 1, ring)
                }
            }
            Spoke::Rest(_) => {
                let unnamed = ring
                    .iter()
                    .take_while(|&&half| {
                        !self.is_named(half) || self.is_listed_elsewhere(star, half)
                    })
                    .count();
                (0..=unnamed).any(|length| self.lies(star, at + 1, &ring[length..]))
            }
        }
    }
}
