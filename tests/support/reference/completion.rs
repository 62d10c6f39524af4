//! Random finished meshes around the drawing before.
//!
//! A map is given by its halfedges, their twins, and at each vertex the cyclic order of its spokes.
//! The drawing fixes some twins, and for some spokes the next one: if `x` is followed by `y` in a
//! loop, the spoke after `y` is the twin of `x`. Everything else is random: the lengths of paths
//! and the vertices on them, the pairing of undrawn twins, which outer halfedges lie on paths,
//! additional edges, and the order of the remaining spokes. So every mesh with a match is a
//! completion, including degenerate ones with faces of one side and edges whose ends coincide.

use hedgerow::diagram::{Kind, LoopKind, NameId, Rule, Spoke};
use hedgerow::mesh::{FaceId, HalfedgeId, Mesh, validate};

use super::maps::{mesh_of, shuffle_pointers};
use super::random::Random;

/// A mesh, and the match of the drawing in it.
pub struct Completion {
    /// The mesh.
    pub mesh: Mesh,
    /// By name: the element; `None` for paths, fans and names that `before` does not draw.
    pub elements: Vec<Option<u32>>,
}

/// A completion; `None` if the drawing or a random choice leads to a contradiction.
pub fn complete(rule: &Rule, random: &mut Random) -> Option<Completion> {
    let mut sketch = Sketch::new(rule);
    sketch.loops(random)?;
    sketch.edges(random)?;
    sketch.stars(random)?;
    sketch.twins(random);
    sketch.more_edges(random);
    let spokes = sketch.arrange(random)?;
    sketch.finish(&spokes, random)
}

#[derive(Clone, Copy, Debug)]
struct Half {
    origin: usize,
    target: usize,
    twin: Option<usize>,
    next: Option<usize>,
    hole: Option<bool>,
}

struct Sketch<'a> {
    rule: &'a Rule,
    halves: Vec<Half>,
    /// By name: the number of the halfedge.
    named: Vec<Option<usize>>,
    /// The halfedges of paths that have no name yet.
    on_paths: Vec<usize>,
    /// The vertices that may have further spokes; numbers after those of the names are unnamed
    /// vertices.
    open: Vec<usize>,
    labels: usize,
}

impl<'a> Sketch<'a> {
    fn new(rule: &'a Rule) -> Self {
        let unnamed = 3;
        let closed = |vertex: usize| {
            let star = rule.before.stars.iter().find(|star| star.vertex.name.index() == vertex);
            star.is_some_and(|star| {
                star.spokes.iter().all(|spoke| matches!(spoke, Spoke::Halfedge(_)))
            })
        };
        let mut drawn: Vec<usize> = Vec::new();
        for orbit in &rule.before.loops {
            drawn.extend(orbit.items.iter().map(|item| item.from.name.index()));
        }
        drawn.extend(rule.before.stars.iter().map(|star| star.vertex.name.index()));
        drawn.sort();
        drawn.dedup();
        drawn.retain(|&vertex| !closed(vertex));
        let labels = rule.names.len() + unnamed;
        drawn.extend(rule.names.len()..labels);
        Self {
            rule,
            halves: Vec::new(),
            named: vec![None; rule.names.len()],
            on_paths: Vec::new(),
            open: drawn,
            labels,
        }
    }

    fn add(&mut self, origin: usize, target: usize) -> usize {
        self.halves.push(Half { origin, target, twin: None, next: None, hole: None });
        self.halves.len() - 1
    }

    fn name(&mut self, name: NameId, half: usize) -> Option<()> {
        let free = self.named[name.index()].is_none();
        self.named[name.index()] = Some(half);
        free.then_some(())
    }

    fn some_vertex(&mut self, random: &mut Random) -> usize {
        let unnamed = self.labels - 1 - random.below(3);
        if random.once_in(2) { *random.pick(&self.open).unwrap_or(&unnamed) } else { unnamed }
    }

    fn loops(&mut self, random: &mut Random) -> Option<()> {
        let rule = self.rule;
        for orbit in &rule.before.loops {
            let mut cycle = Vec::new();
            let count = orbit.items.len();
            for (at, item) in orbit.items.iter().enumerate() {
                let from = item.from.name.index();
                let behind = orbit.items.get(at + 1).map_or(orbit.end, |item| item.from);
                let to = behind.name.index();
                if rule.kind(item.item.name) == Kind::Halfedge {
                    let half = self.add(from, to);
                    self.name(item.item.name, half)?;
                    cycle.push(half);
                    continue;
                }
                let least = usize::from(from != to || count == 1);
                let length = least + random.below(4).min(random.below(4));
                let mut at = from;
                for place in 0..length {
                    let last = place + 1 == length;
                    let then = if last { to } else { self.some_vertex(random) };
                    let half = self.add(at, then);
                    self.on_paths.push(half);
                    cycle.push(half);
                    at = then;
                }
            }
            if cycle.is_empty() || orbit.end.name != orbit.items[0].from.name {
                return None;
            }
            let hole = match orbit.kind {
                LoopKind::Face => false,
                LoopKind::Hole => true,
                LoopKind::Any => random.once_in(3),
            };
            for (place, &half) in cycle.iter().enumerate() {
                self.halves[half].next = Some(cycle[(place + 1) % cycle.len()]);
                self.halves[half].hole = Some(hole);
            }
        }
        Some(())
    }

    /// The number of an outer halfedge: a new one, or one on a path.
    fn outer(&mut self, name: NameId, ends: [usize; 2], random: &mut Random) -> Option<usize> {
        let half = match random.once_in(2) {
            true => self.on_a_path(ends, random).unwrap_or_else(|| self.add(ends[0], ends[1])),
            false => self.add(ends[0], ends[1]),
        };
        self.name(name, half)?;
        Some(half)
    }

    /// A halfedge on a path that connects two vertices, or can be made to.
    fn on_a_path(&mut self, [origin, target]: [usize; 2], random: &mut Random) -> Option<usize> {
        let on_paths = self.on_paths.clone();
        let is_between = |sketch: &Self, half: usize| {
            let next = sketch.halves[half].next;
            next.filter(|next| on_paths.contains(next) && on_paths.contains(&half))
        };
        // Vertices inside paths may still be exchanged.
        let prev_of = |sketch: &Self, half: usize| {
            on_paths.iter().copied().find(|&other| is_between(sketch, other) == Some(half))
        };
        let mut candidates = on_paths.clone();
        random.shuffle(&mut candidates);
        let half = candidates.into_iter().find(|&half| {
            let drawn = self.halves[half];
            let starts = drawn.origin == origin || prev_of(self, half).is_some();
            let ends = drawn.target == target || is_between(self, half).is_some();
            starts && ends
        })?;
        if self.halves[half].origin != origin {
            let prev = prev_of(self, half)?;
            if self.rule_vertex_border(prev, half) {
                return None;
            }
            self.halves[prev].target = origin;
            self.halves[half].origin = origin;
        }
        if self.halves[half].target != target {
            let next = is_between(self, half)?;
            if self.rule_vertex_border(half, next) {
                return None;
            }
            self.halves[half].target = target;
            self.halves[next].origin = target;
        }
        self.on_paths.retain(|&other| other != half);
        Some(half)
    }

    /// Whether two consecutive halfedges, both on paths, may lie on different paths.
    fn rule_vertex_border(&self, half: usize, next: usize) -> bool {
        // The halfedges of a path are numbered consecutively, so only the last one of a path and
        // the first one of the next (or of the same path, if it is the whole loop) are not
        // consecutive in number.
        let adjacent_paths = self.rule.before.loops.iter().any(|orbit| {
            let count = orbit.items.len();
            (0..count).any(|at| {
                [at, (at + 1) % count]
                    .iter()
                    .all(|&at| self.rule.kind(orbit.items[at].item.name) == Kind::Path)
            })
        });
        adjacent_paths || next != half + 1
    }

    fn edges(&mut self, random: &mut Random) -> Option<()> {
        for edge in &self.rule.before.edges {
            let [left, right] = edge.halfedges.map(|half| half.name);
            let known = [left, right].map(|name| self.named[name.index()]);
            let pair = match known {
                [Some(left), Some(right)] => [left, right],
                [Some(x), None] => {
                    let Half { origin, target, .. } = self.halves[x];
                    [x, self.outer(right, [target, origin], random)?]
                }
                [None, Some(y)] => {
                    let Half { origin, target, .. } = self.halves[y];
                    [self.outer(left, [target, origin], random)?, y]
                }
                [None, None] => {
                    let [from, to] = [left, right].map(|name| {
                        let star = self.rule.before.stars.iter().find(|star| {
                            star.spokes.iter().any(
                                |spoke| matches!(spoke, Spoke::Halfedge(half) if half.name == name),
                            )
                        });
                        star.map(|star| star.vertex.name.index())
                    });
                    let from = from.unwrap_or_else(|| self.some_vertex(random));
                    let to = to.unwrap_or_else(|| self.some_vertex(random));
                    let left = self.outer(left, [from, to], random)?;
                    [left, self.outer(right, [to, from], random)?]
                }
            };
            let [x, y] = pair;
            let fits = self.halves[x].origin == self.halves[y].target
                && self.halves[x].target == self.halves[y].origin
                && self.halves[x].twin.is_none()
                && self.halves[y].twin.is_none()
                && x != y;
            if !fits {
                return None;
            }
            self.halves[x].twin = Some(y);
            self.halves[y].twin = Some(x);
        }
        Some(())
    }

    /// Adds the spokes that are in no loop and no edge.
    fn stars(&mut self, random: &mut Random) -> Option<()> {
        for star in &self.rule.before.stars {
            for spoke in &star.spokes {
                let Spoke::Halfedge(name) = spoke else {
                    continue;
                };
                let vertex = star.vertex.name.index();
                match self.named[name.name.index()] {
                    Some(half) if self.halves[half].origin != vertex => return None,
                    Some(_) => {}
                    None => {
                        let to = self.some_vertex(random);
                        self.outer(name.name, [vertex, to], random)?;
                    }
                }
            }
        }
        Some(())
    }

    /// Pairs halfedges without a twin, with each other or with new ones.
    fn twins(&mut self, random: &mut Random) {
        let mut open: Vec<_> =
            (0..self.halves.len()).filter(|&half| self.halves[half].twin.is_none()).collect();
        random.shuffle(&mut open);
        while let Some(half) = open.pop() {
            let Half { origin, target, .. } = self.halves[half];
            let fits = |other: &usize| {
                self.halves[*other].origin == target && self.halves[*other].target == origin
            };
            let partner = open.iter().position(fits);
            let twin = match partner {
                Some(place) if random.once_in(2) => open.remove(place),
                _ => self.add(target, origin),
            };
            self.halves[half].twin = Some(twin);
            self.halves[twin].twin = Some(half);
        }
    }

    fn more_edges(&mut self, random: &mut Random) {
        for _ in 0..random.below(4).min(random.below(4)) {
            let (from, to) = (self.some_vertex(random), self.some_vertex(random));
            let half = self.add(from, to);
            let twin = self.add(to, from);
            self.halves[half].twin = Some(twin);
            self.halves[twin].twin = Some(half);
        }
    }

    /// The next spoke of each halfedge, counterclockwise.
    fn arrange(&self, random: &mut Random) -> Option<Vec<usize>> {
        let count = self.halves.len();
        let mut succeeds: Vec<Option<usize>> = vec![None; count];
        let mut precedes: Vec<Option<usize>> = vec![None; count];
        let mut state = |from: usize, to: usize| {
            let free = [succeeds[from], precedes[to]];
            succeeds[from] = Some(to);
            precedes[to] = Some(from);
            matches!(free, [None, None]) || free == [Some(to), Some(from)]
        };
        for half in 0..count {
            let Some(next) = self.halves[half].next else {
                continue;
            };
            if !state(next, self.halves[half].twin?) {
                return None;
            }
        }
        for star in &self.rule.before.stars {
            for (at, spoke) in star.spokes.iter().enumerate() {
                let next = &star.spokes[(at + 1) % star.spokes.len()];
                if let (Spoke::Halfedge(x), Spoke::Halfedge(y)) = (spoke, next) {
                    let [x, y] = [x, y].map(|name| self.named[name.name.index()]);
                    if !state(x?, y?) {
                        return None;
                    }
                }
            }
        }
        for vertex in 0..self.labels {
            let spokes: Vec<_> =
                (0..count).filter(|&half| self.halves[half].origin == vertex).collect();
            if spokes.is_empty() {
                continue;
            }
            let mut chains: Vec<Vec<usize>> = Vec::new();
            let mut seen = 0;
            for &first in spokes.iter().filter(|&&spoke| precedes[spoke].is_none()) {
                let mut chain = vec![first];
                while let Some(next) = succeeds[chain[chain.len() - 1]] {
                    chain.push(next);
                }
                seen += chain.len();
                chains.push(chain);
            }
            if seen < spokes.len() {
                // A ring that is closed already has to contain all spokes.
                let mut ring = vec![spokes[0]];
                while let Some(next) =
                    succeeds[ring[ring.len() - 1]].filter(|&next| next != ring[0])
                {
                    ring.push(next);
                }
                if seen > 0 || ring.len() < spokes.len() || !self.agrees(vertex, &ring) {
                    return None;
                }
                continue;
            }
            let ring = (0..12).find_map(|_| {
                random.shuffle(&mut chains);
                Some(chains.concat()).filter(|ring| self.agrees(vertex, ring))
            })?;
            for (place, &spoke) in ring.iter().enumerate() {
                succeeds[spoke] = Some(ring[(place + 1) % ring.len()]);
            }
        }
        succeeds.into_iter().collect()
    }

    /// Whether the ring of a vertex agrees with its statement.
    fn agrees(&self, vertex: usize, ring: &[usize]) -> bool {
        let star = self.rule.before.stars.iter().find(|star| star.vertex.name.index() == vertex);
        let Some(star) = star else { return true };
        let listed: Vec<_> = star
            .spokes
            .iter()
            .map(|spoke| match spoke {
                Spoke::Halfedge(name) => self.named[name.name.index()],
                Spoke::Fan(_) | Spoke::Rest(_) => None,
            })
            .collect();
        fn lies(listed: &[Option<usize>], ring: &[usize]) -> bool {
            match (listed, ring) {
                ([], ring) => ring.is_empty(),
                ([Some(half), listed @ ..], [spoke, ring @ ..]) => {
                    half == spoke && lies(listed, ring)
                }
                ([Some(_), ..], []) => false,
                ([None, rest @ ..], ring) => {
                    lies(rest, ring) || (!ring.is_empty() && lies(listed, &ring[1..]))
                }
            }
        }
        (0..ring.len()).any(|turn| lies(&listed, &[&ring[turn..], &ring[..turn]].concat()))
    }

    fn finish(&self, spokes: &[usize], random: &mut Random) -> Option<Completion> {
        let count = self.halves.len();
        let twin: Vec<_> = self.halves.iter().map(|half| half.twin).collect::<Option<_>>()?;
        // The next spoke of h is h.prev.twin, so h follows the twin of its next spoke.
        let mut next = vec![0; count];
        for half in 0..count {
            next[twin[spokes[half]]] = half;
        }
        let mut holes = |half: usize| self.halves[half].hole.unwrap_or_else(|| random.once_in(3));
        let mut mesh = mesh_of(&next, &twin, &mut holes);
        // A drawn loop may begin at any of its halfedges, so its flag is set again.
        for (half, drawn) in self.halves.iter().enumerate() {
            if let Some(hole) = drawn.hole {
                let face: FaceId = mesh.face(HalfedgeId(half as u32));
                mesh.set_hole(face, hole);
            }
        }
        shuffle_pointers(&mut mesh, random);
        assert_eq!(validate(&mesh), Ok(()), "a completion is a mesh");
        let mut elements: Vec<Option<u32>> = vec![None; self.rule.names.len()];
        let id = |half: usize| HalfedgeId(half as u32);
        for (name, half) in self.named.iter().enumerate() {
            elements[name] = half.map(|half| half as u32);
        }
        for (half, drawn) in self.halves.iter().enumerate() {
            if let Some(vertex) = elements.get_mut(drawn.origin) {
                *vertex = Some(mesh.vertex(id(half)).0);
            }
        }
        for edge in &self.rule.before.edges {
            let half = self.named[edge.halfedges[0].name.index()]?;
            elements[edge.edge.name.index()] = Some(mesh.edge(id(half)).0);
        }
        // A loop that consists of paths has no named halfedge, so its face stays unknown.
        for orbit in &self.rule.before.loops {
            let half = orbit.items.iter().find_map(|item| self.named[item.item.name.index()]);
            if let Some(half) = half {
                elements[orbit.face.name.index()] = Some(mesh.face(id(half)).0);
            }
        }
        Some(Completion { mesh, elements })
    }
}
