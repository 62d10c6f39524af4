//! All matches of a drawing, by exhaustive search.
//!
//! A loop statement is placed on a whole cycle of `next`, a vertex statement on a whole cycle of
//! spokes, item by item, with paths and fans of every length; an edge statement on every pair of
//! twins. Existing bindings only shorten the search.

use hedgerow::diagram::{Kind, Loop, LoopKind, NameId, Rule, Spoke, Star};
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};

/// The bindings of the names of a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Match {
    /// By name: the element.
    pub elements: Vec<Option<u32>>,
    /// By name: the halfedges of a path, or the spokes of a fan.
    pub runs: Vec<Option<Vec<u32>>>,
}

/// At most `most` matches of a rule, with some of its names bound already.
pub fn matches(rule: &Rule, mesh: &Mesh, bound: &[(NameId, u32)], most: usize) -> Vec<Match> {
    matches_where(rule, mesh, bound, most, &|_, _| false)
}

/// The same, where some names may be bound to one element. Edges always may: two edges are one only
/// if their halfedges are.
pub fn matches_where(
    rule: &Rule,
    mesh: &Mesh,
    bound: &[(NameId, u32)],
    most: usize,
    may_be_one: &dyn Fn(NameId, NameId) -> bool,
) -> Vec<Match> {
    let before = &rule.before;
    let mut search = Search {
        rule,
        mesh,
        state: Match { elements: vec![None; rule.names.len()], runs: vec![None; rule.names.len()] },
        loops: vec![false; before.loops.len()],
        edges: vec![false; before.edges.len()],
        stars: vec![false; before.stars.len()],
        found: Vec::new(),
        most,
        may_be_one,
    };
    let all = bound.iter().all(|&(name, element)| search.bind(name, element).is_some());
    if all {
        search.statement();
    }
    search.found
}

/// The name and the given element of each parameter that the rule draws.
pub fn bound_by(rule: &Rule, arguments: &[u32]) -> Vec<(NameId, u32)> {
    let params = rule.params.iter().zip(arguments);
    params.filter_map(|(name, &element)| Some(((*name)?, element))).collect()
}

#[derive(Clone, Copy)]
enum Statement {
    Loop(usize),
    Edge(usize),
    Star(usize),
}

struct Search<'a> {
    rule: &'a Rule,
    mesh: &'a Mesh,
    state: Match,
    loops: Vec<bool>,
    edges: Vec<bool>,
    stars: Vec<bool>,
    found: Vec<Match>,
    most: usize,
    may_be_one: &'a dyn Fn(NameId, NameId) -> bool,
}

/// The name bound by one step, to be undone.
type Undo = Option<NameId>;

impl<'a> Search<'a> {
    fn element(&self, name: NameId) -> Option<u32> {
        self.state.elements[name.index()]
    }

    /// Binds a name; `None` if it is bound to another element, or another name of its kind is bound
    /// to this one.
    fn bind(&mut self, name: NameId, element: u32) -> Option<Undo> {
        match self.element(name) {
            Some(known) => (known == element).then_some(None),
            None => {
                let kind = self.rule.kind(name);
                let taken = self.state.elements.iter().enumerate().any(|(other, bound)| {
                    let other = NameId(other as u32);
                    *bound == Some(element)
                        && self.rule.kind(other) == kind
                        && kind != Kind::Edge
                        && !(self.may_be_one)(other, name)
                });
                if taken {
                    return None;
                }
                self.state.elements[name.index()] = Some(element);
                Some(Some(name))
            }
        }
    }

    /// Binds a run; a run that occurs twice in the drawing never matches.
    fn bind_run(&mut self, name: NameId, run: &[HalfedgeId]) -> Option<Undo> {
        let known = &mut self.state.runs[name.index()];
        if known.is_some() {
            return None;
        }
        *known = Some(run.iter().map(|h| h.0).collect());
        Some(Some(name))
    }

    fn undo(&mut self, undo: Undo) {
        if let Some(name) = undo {
            self.state.elements[name.index()] = None;
            self.state.runs[name.index()] = None;
        }
    }

    /// Binds a name, continues, and undoes the binding.
    fn with(&mut self, name: NameId, element: u32, then: impl FnOnce(&mut Self)) {
        if let Some(undo) = self.bind(name, element) {
            then(self);
            self.undo(undo);
        }
    }

    /// Places the statement that is most constrained by the bindings, or ends the search.
    fn statement(&mut self) {
        if self.found.len() >= self.most {
            return;
        }
        let mut best: Option<(usize, Statement)> = None;
        let mut offer = |score: usize, statement: Statement| {
            if best.is_none_or(|(known, _)| score > known) {
                best = Some((score, statement));
            }
        };
        let before = &self.rule.before;
        let is_bound = |name: NameId| usize::from(self.element(name).is_some());
        for (at, edge) in before.edges.iter().enumerate().filter(|&(at, _)| !self.edges[at]) {
            let [left, right] = edge.halfedges.map(|half| is_bound(half.name));
            offer(4 * (left | right) + 2 * is_bound(edge.edge.name), Statement::Edge(at));
        }
        for (at, orbit) in before.loops.iter().enumerate().filter(|&(at, _)| !self.loops[at]) {
            let item = orbit.items.iter().any(|item| is_bound(item.item.name) == 1);
            let score = 3 * usize::from(item) + is_bound(orbit.face.name);
            offer(score, Statement::Loop(at));
        }
        for (at, star) in before.stars.iter().enumerate().filter(|&(at, _)| !self.stars[at]) {
            let spoke = star.spokes.iter().any(|spoke| match spoke {
                Spoke::Halfedge(half) => is_bound(half.name) == 1,
                Spoke::Fan(_) | Spoke::Rest(_) => false,
            });
            let score = 3 * usize::from(spoke) + is_bound(star.vertex.name);
            offer(score, Statement::Star(at));
        }
        match best {
            None => self.end(),
            Some((_, Statement::Edge(at))) => {
                self.edges[at] = true;
                self.edge(at);
                self.edges[at] = false;
            }
            Some((_, Statement::Loop(at))) => {
                self.loops[at] = true;
                self.orbit(&self.rule.before.loops[at]);
                self.loops[at] = false;
            }
            Some((_, Statement::Star(at))) => {
                self.stars[at] = true;
                self.star(&self.rule.before.stars[at]);
                self.stars[at] = false;
            }
        }
    }

    fn edge(&mut self, at: usize) {
        let edge = &self.rule.before.edges[at];
        let mesh = self.mesh;
        let [left, right] = edge.halfedges.map(|half| half.name);
        let candidates = if let Some(half) = self.element(left) {
            vec![HalfedgeId(half)]
        } else if let Some(half) = self.element(right) {
            vec![mesh.twin(HalfedgeId(half))]
        } else if let Some(edge) = self.element(edge.edge.name) {
            let half = mesh.edge_halfedge(EdgeId(edge));
            vec![half, mesh.twin(half)]
        } else {
            mesh.halfedges().collect()
        };
        for half in candidates {
            self.with(left, half.0, |this| {
                this.with(right, mesh.twin(half).0, |this| {
                    this.with(edge.edge.name, mesh.edge(half).0, Self::statement);
                });
            });
        }
    }

    fn orbit(&mut self, orbit: &'a Loop) {
        let mesh = self.mesh;
        let is_halfedge = |name: NameId| self.rule.kind(name) == Kind::Halfedge;
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        let known = items.iter().position(|&item| self.element(item).is_some());
        let first = known.or_else(|| items.iter().position(|&item| is_halfedge(item)));
        let first = first.unwrap_or(0);
        let starts: Vec<_> = if let Some(half) = self.element(items[first]) {
            vec![HalfedgeId(half)]
        } else if let Some(face) = self.element(orbit.face.name) {
            mesh.face_halfedges(FaceId(face)).collect()
        } else {
            mesh.halfedges().collect()
        };
        for start in starts {
            let face = mesh.face(start);
            let hole = mesh.is_hole(face);
            let right_kind = match orbit.kind {
                LoopKind::Face => !hole,
                LoopKind::Hole => hole,
                LoopKind::Any => true,
            };
            if !right_kind {
                continue;
            }
            let cycle: Vec<_> = mesh.loop_from(start).collect();
            self.with(orbit.face.name, face.0, |this| this.item(orbit, &cycle, [first, 0, 0]));
        }
    }

    /// Places the items from the `placed`th on, where `used` halfedges of the cycle are used.
    fn item(&mut self, orbit: &'a Loop, cycle: &[HalfedgeId], [first, placed, used]: [usize; 3]) {
        let count = orbit.items.len();
        if placed == count {
            let start = self.element(orbit.items[0].from.name);
            if used == cycle.len()
                && let Some(start) = start
            {
                self.with(orbit.end.name, start, Self::statement);
            }
            return;
        }
        let item = &orbit.items[(first + placed) % count];
        let here = self.mesh.vertex(cycle[used % cycle.len()]);
        let name = item.item.name;
        self.with(item.from.name, here.0, |this| {
            if this.rule.kind(name) == Kind::Halfedge {
                if used < cycle.len() {
                    this.with(name, cycle[used].0, |this| {
                        this.item(orbit, cycle, [first, placed + 1, used + 1]);
                    });
                }
                return;
            }
            for end in used..=cycle.len() {
                if let Some(undo) = this.bind_run(name, &cycle[used..end]) {
                    this.item(orbit, cycle, [first, placed + 1, end]);
                    this.undo(undo);
                }
            }
        });
    }

    fn star(&mut self, star: &'a Star) {
        let mesh = self.mesh;
        let halfedge = |spoke: &Spoke| match spoke {
            Spoke::Halfedge(half) => Some(half.name),
            Spoke::Fan(_) | Spoke::Rest(_) => None,
        };
        let known = star
            .spokes
            .iter()
            .position(|spoke| halfedge(spoke).is_some_and(|half| self.element(half).is_some()));
        let named = || star.spokes.iter().position(|spoke| halfedge(spoke).is_some());
        let first = known.or_else(named).unwrap_or(0);
        let known = halfedge(&star.spokes[first]).and_then(|half| self.element(half));
        let vertex = self.element(star.vertex.name).map(VertexId);
        let mut starts: Vec<_> = match (known, vertex) {
            (Some(half), _) => vec![HalfedgeId(half)],
            (None, Some(vertex)) => mesh.spokes(vertex).collect(),
            (None, None) => mesh.halfedges().collect(),
        };
        if vertex.is_some() && star.spokes.len() == 1 && halfedge(&star.spokes[0]).is_none() {
            starts.truncate(1); // all of the star is one fan, wherever it begins
        }
        for start in starts {
            let ring: Vec<_> = mesh.spokes_from(start).collect();
            self.with(star.vertex.name, mesh.vertex(start).0, |this| {
                this.spoke(star, &ring, [first, 0, 0]);
            });
        }
        let isolated: Vec<_> = mesh
            .vertices()
            .filter(|&v| mesh.vertex_halfedge(v).is_none() && vertex.is_none_or(|known| known == v))
            .collect();
        for vertex in isolated {
            self.with(star.vertex.name, vertex.0, |this| this.spoke(star, &[], [first, 0, 0]));
        }
    }

    fn spoke(&mut self, star: &'a Star, ring: &[HalfedgeId], [first, placed, used]: [usize; 3]) {
        let count = star.spokes.len();
        if placed == count {
            if used == ring.len() {
                self.statement();
            }
            return;
        }
        let on = |end: usize| [first, placed + 1, end];
        match star.spokes[(first + placed) % count] {
            Spoke::Halfedge(half) => {
                if used < ring.len() {
                    self.with(half.name, ring[used].0, |this| this.spoke(star, ring, on(used + 1)));
                }
            }
            Spoke::Fan(fan) => {
                for end in used..=ring.len() {
                    if let Some(undo) = self.bind_run(fan.name, &ring[used..end]) {
                        self.spoke(star, ring, on(end));
                        self.undo(undo);
                    }
                }
            }
            Spoke::Rest(_) => {
                for end in used..=ring.len() {
                    self.spoke(star, ring, on(end));
                }
            }
        }
    }

    /// Records the match if it satisfies the global conditions, once all statements are placed.
    fn end(&mut self) {
        if self.named_spokes_are_listed() && self.no_loop_is_left_empty() {
            self.found.push(self.state.clone());
        }
    }

    /// Whether each halfedge of `before` that starts at a vertex with a statement is one of its
    /// listed spokes.
    fn named_spokes_are_listed(&self) -> bool {
        self.rule.before.stars.iter().all(|star| {
            let vertex = self.element(star.vertex.name);
            self.rule.names_of(Kind::Halfedge).all(|half| {
                let starts_here = self
                    .element(half)
                    .is_some_and(|bound| Some(self.mesh.vertex(HalfedgeId(bound)).0) == vertex);
                let listed = star
                    .spokes
                    .iter()
                    .any(|spoke| matches!(spoke, Spoke::Halfedge(listed) if self.element(listed.name) == self.element(half)));
                !starts_here || listed
            })
        })
    }

    /// Whether no loop of `after` would consist of empty paths only; such a match is refused.
    fn no_loop_is_left_empty(&self) -> bool {
        let empty =
            |name: NameId| matches!(&self.state.runs[name.index()], Some(run) if run.is_empty());
        self.rule.after.loops.iter().all(|orbit| {
            let items = orbit.items.iter().map(|item| item.item.name);
            orbit.items.is_empty() || !items.into_iter().all(empty)
        })
    }
}
