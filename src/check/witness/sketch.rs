//! The drawing of `before` laid down as halfedges, its outside still open.
//!
//! Every drawn halfedge stands for itself, every path for as many as the [`Shape`] says, and
//! every halfedge without a drawn twin gets a fresh one outside. What remains open is the
//! `next` of the halfedges outside.
//!
//! A shape may also identify what the drawing leaves separate: two halfedges without a drawn twin
//! are twins of each other, or an outer halfedge lies on a path.

use crate::diagram::{Drawing, Kind, NameId, Spoke, Star};

/// The choices that a drawing leaves open about its own halfedges.
#[derive(Clone, Debug, Default)]
pub(super) struct Shape {
    /// For each name, the number of halfedges, if it is a path.
    pub lengths: Vec<usize>,
    /// Halfedges without a drawn twin, by number, that are twins.
    pub glued: Vec<[usize; 2]>,
    /// Outer halfedges that lie on a path, at a place.
    pub on_path: Vec<(NameId, NameId, usize)>,
    /// For two fans side by side, with nothing between them, whether the second has all the spokes.
    pub late: bool,
}

/// The role of a halfedge in the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HalfedgeRole {
    /// It has a name.
    Named(NameId),
    /// It lies on a path.
    OnPath(NameId),
    /// It is the undrawn twin of another.
    TwinOf(usize),
    /// It was added in an arc at a vertex.
    Further(usize),
}

/// The role of a vertex in the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum VertexRole {
    /// It has a name.
    Named(NameId),
    /// It lies inside a path.
    Along(NameId),
    /// It has no name and lies on no path.
    Loose,
}

/// A halfedge of a sketch.
#[derive(Clone, Debug)]
pub(super) struct Half {
    pub role: HalfedgeRole,
    /// The number of the vertex it starts at.
    pub origin: usize,
    pub next: Option<usize>,
    /// The halfedge before.
    pub prev: Option<usize>,
    pub twin: Option<usize>,
    /// The face whose loop is drawn around it.
    pub face: Option<NameId>,
}

/// A drawing laid down.
#[derive(Clone, Debug)]
pub(super) struct Sketch {
    pub halves: Vec<Half>,
    pub vertices: Vec<VertexRole>,
    /// For each name the number of its halfedge.
    pub half_of: Vec<Option<usize>>,
    /// For each name the number of its vertex.
    pub vertex_of: Vec<Option<usize>>,
    /// For each name the halfedges of the path, or the spokes of the fan.
    pub runs: Vec<Vec<usize>>,
    /// For two fans side by side, whether the second has all the spokes.
    pub late: bool,
}

impl Sketch {
    /// Builds the sketch of a drawing; `None` if it contradicts itself in this shape.
    pub fn build(drawing: &Drawing, shape: &Shape) -> Option<Self> {
        let mut sketch = Self::open(drawing, shape)?;
        for &[left, right] in &shape.glued {
            sketch.pair(left, right)?;
        }
        for half in 0..sketch.halves.len() {
            if sketch.halves[half].twin.is_none() {
                sketch.fresh_twin(half);
            }
        }
        sketch.compact();
        Some(sketch)
    }

    /// Builds that of a drawing without adding the twins that are not drawn.
    pub fn open(drawing: &Drawing, shape: &Shape) -> Option<Self> {
        let count = drawing.rule.names.len();
        let mut sketch = Self {
            halves: Vec::new(),
            vertices: Vec::new(),
            half_of: vec![None; count],
            vertex_of: vec![None; count],
            runs: vec![Vec::new(); count],
            late: shape.late,
        };
        sketch.loops(drawing, shape)?;
        let implied = implied_on_paths(drawing, shape);
        for &(outer, path, place) in shape.on_path.iter().chain(&implied) {
            let half = *sketch.runs[path.index()].get(place)?;
            sketch.half_of[outer.index()] = Some(half);
            sketch.halves[half].role = HalfedgeRole::Named(outer);
        }
        sketch.edges(drawing)?;
        sketch.spokes(drawing)?;
        Some(sketch)
    }

    fn vertex(&mut self, name: NameId) -> usize {
        match self.vertex_of[name.index()] {
            Some(vertex) => vertex,
            None => {
                let vertex = self.add_vertex(VertexRole::Named(name));
                self.vertex_of[name.index()] = Some(vertex);
                vertex
            }
        }
    }

    pub fn add_vertex(&mut self, role: VertexRole) -> usize {
        self.vertices.push(role);
        self.vertices.len() - 1
    }

    /// Adds a halfedge that nothing leads to yet.
    pub fn add(&mut self, role: HalfedgeRole, origin: usize) -> usize {
        self.halves.push(Half { role, origin, next: None, prev: None, twin: None, face: None });
        self.halves.len() - 1
    }

    /// Makes one halfedge follow another.
    pub fn link(&mut self, half: usize, next: usize) {
        self.halves[half].next = Some(next);
        self.halves[next].prev = Some(half);
    }

    /// The end of a halfedge, if that is known.
    fn target(&self, half: usize) -> Option<usize> {
        let half = &self.halves[half];
        let behind = half.next.or(half.twin)?;
        Some(self.halves[behind].origin)
    }

    fn loops(&mut self, drawing: &Drawing, shape: &Shape) -> Option<()> {
        let rule = drawing.rule;
        for (at, orbit) in rule.before.loops.iter().enumerate() {
            let face = orbit.face.name;
            let earlier = &rule.before.loops[..at];
            let closes = orbit.items.first()?.from.name == orbit.end.name;
            if !closes || earlier.iter().any(|other| other.face.name == face) {
                return None;
            }
            let mut cycle = Vec::new();
            for (place, item) in orbit.items.iter().enumerate() {
                let name = item.item.name;
                let to = orbit.items.get(place + 1).map_or(orbit.end, |next| next.from);
                let origin = self.vertex(item.from.name);
                if rule.kind(name) == Kind::Halfedge {
                    let half = self.add(HalfedgeRole::Named(name), origin);
                    if self.half_of[name.index()].replace(half).is_some() {
                        return None;
                    }
                    cycle.push(half);
                    continue;
                }
                let length = shape.lengths[name.index()];
                let ends_differ = item.from.name != to.name;
                if !self.runs[name.index()].is_empty() || (length == 0 && ends_differ) {
                    return None;
                }
                for place in 0..length {
                    let origin = match place {
                        0 => origin,
                        _ => self.add_vertex(VertexRole::Along(name)),
                    };
                    let half = self.add(HalfedgeRole::OnPath(name), origin);
                    self.runs[name.index()].push(half);
                    cycle.push(half);
                }
            }
            cycle.first()?;
            for (place, &half) in cycle.iter().enumerate() {
                self.link(half, cycle[(place + 1) % cycle.len()]);
                self.halves[half].face = Some(face);
            }
        }
        Some(())
    }

    fn edges(&mut self, drawing: &Drawing) -> Option<()> {
        let edges = &drawing.rule.before.edges;
        for (at, edge) in edges.iter().enumerate() {
            if edges[..at].iter().any(|other| other.edge.name == edge.edge.name) {
                return None;
            }
            let [left, right] = edge.halfedge_names();
            let left = self.drawn_or_outer(drawing, left, right);
            let right = self.drawn_or_outer(drawing, right, edge.halfedges[0].name);
            self.pair(left, right)?;
        }
        Some(())
    }

    /// The halfedge of a name; one that is in no loop starts where its twin ends.
    fn drawn_or_outer(&mut self, drawing: &Drawing, name: NameId, twin: NameId) -> usize {
        if let Some(half) = self.half_of[name.index()] {
            return half;
        }
        let twin = self.half_of[twin.index()];
        let listed = drawing.before.star_of_spoke(name);
        let origin = match (twin.and_then(|twin| self.target(twin)), listed) {
            (Some(origin), _) => origin,
            (None, Some(vertex)) => self.vertex(vertex),
            (None, None) => self.add_vertex(VertexRole::Loose),
        };
        let half = self.add(HalfedgeRole::Named(name), origin);
        self.half_of[name.index()] = Some(half);
        half
    }

    /// Makes twins of two halfedges, unless they have other twins or other ends.
    pub fn pair(&mut self, left: usize, right: usize) -> Option<()> {
        let free = |half: usize| self.halves[half].twin.is_none();
        if left == right || !free(left) || !free(right) {
            return None;
        }
        for (half, other) in [(left, right), (right, left)] {
            if let Some(end) = self.target(half) {
                self.unify(end, self.halves[other].origin)?;
            }
        }
        self.make_twins(left, right);
        Some(())
    }

    /// Makes twins of two halfedges.
    fn make_twins(&mut self, left: usize, right: usize) {
        self.halves[left].twin = Some(right);
        self.halves[right].twin = Some(left);
    }

    /// Makes two vertices one, unless both have names. The other one is left without spokes.
    pub fn unify(&mut self, left: usize, right: usize) -> Option<()> {
        if left == right {
            return Some(());
        }
        let named = |vertex: usize| matches!(self.vertices[vertex], VertexRole::Named(_));
        let (stays, goes) = match (named(left), named(right)) {
            (true, true) => return None,
            (false, true) => (right, left),
            _ => (left, right),
        };
        for half in self.halves.iter_mut().filter(|half| half.origin == goes) {
            half.origin = stays;
        }
        Some(())
    }

    /// Removes the vertices without a name at which nothing starts.
    pub fn compact(&mut self) {
        let mut numbers = vec![None; self.vertices.len()];
        let mut kept = Vec::new();
        for (old, &role) in self.vertices.iter().enumerate() {
            let named = matches!(role, VertexRole::Named(_));
            if named || self.halves.iter().any(|half| half.origin == old) {
                numbers[old] = Some(kept.len());
                kept.push(role);
            }
        }
        self.vertices = kept;
        for half in &mut self.halves {
            half.origin = numbers[half.origin].expect("a halfedge starts at it");
            if let HalfedgeRole::Further(at) = &mut half.role {
                *at = half.origin;
            }
        }
        for vertex in self.vertex_of.iter_mut().flatten() {
            *vertex = numbers[*vertex].expect("it has a name");
        }
    }

    /// Adds halfedges that only a vertex statement names, and the vertices of these statements.
    fn spokes(&mut self, drawing: &Drawing) -> Option<()> {
        for star in &drawing.rule.before.stars {
            let vertex = self.vertex(star.vertex.name);
            for spoke in &star.spokes {
                let Spoke::Halfedge(spoke) = spoke else { continue };
                let half = match self.half_of[spoke.name.index()] {
                    Some(half) => half,
                    None => {
                        let half = self.add(HalfedgeRole::Named(spoke.name), vertex);
                        self.half_of[spoke.name.index()] = Some(half);
                        half
                    }
                };
                if self.halves[half].origin != vertex {
                    return None;
                }
            }
        }
        drawing.rule.before.stars.iter().try_for_each(|star| self.follow_each_other(star))
    }

    /// Pairs halfedges by the order of spokes: the spoke behind another, counterclockwise, is the
    /// twin of the halfedge before that one.
    fn follow_each_other(&mut self, star: &Star) -> Option<()> {
        for pair in star.neighbors() {
            let [Some(spoke), Some(next)] = pair.map(|half| self.half_of[half.name.index()]) else {
                continue;
            };
            let Some(prev) = self.halves[spoke].prev else { continue };
            let free = |half: usize| self.halves[half].twin.is_none();
            if prev != next && free(prev) && free(next) {
                self.pair(prev, next)?;
            }
        }
        Some(())
    }

    /// Adds the twin of a halfedge.
    pub fn fresh_twin(&mut self, half: usize) -> usize {
        let origin = match self.target(half) {
            Some(origin) => origin,
            None => self.add_vertex(VertexRole::Loose),
        };
        let twin = self.add(HalfedgeRole::TwinOf(half), origin);
        self.make_twins(half, twin);
        twin
    }
}

/// Outer halfedges that are the first or last of a path, because of the order of spokes: the spoke
/// behind another is the twin of the halfedge before that one.
fn implied_on_paths(drawing: &Drawing, shape: &Shape) -> Vec<(NameId, NameId, usize)> {
    let view = &drawing.before;
    let length = |item: NameId| match drawing.rule.kind(item) {
        Kind::Path => shape.lengths[item.index()],
        _ => 0,
    };
    let mut implied: Vec<(NameId, NameId, usize)> = Vec::new();
    for star in &drawing.rule.before.stars {
        for [spoke, next] in star.neighbors() {
            let Some(twin) = view.twin(next.name) else { continue };
            let before = view.item_before(spoke.name).filter(|&path| length(path) > 0);
            let after = view.item_after(twin).filter(|&path| length(path) > 0);
            let last = before.map(|path| (twin, path, length(path) - 1));
            let first = after.map(|path| (spoke.name, path, 0));
            for found in last.into_iter().chain(first) {
                let known = shape.on_path.iter().chain(&implied).any(|other| other.0 == found.0);
                if drawing.is_outer(found.0) && !known {
                    implied.push(found);
                }
            }
        }
    }
    implied
}
