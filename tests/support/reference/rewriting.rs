//! The rewrite of a match, pointer by pointer as the language reference says, without any checks.
//!
//! In a loop of `after`, `x.next` is the following item, `x.vertex` the preceding name, `x.face`
//! the loop; along a path `face` is written, and at its ends the links to its neighbors. The
//! spokes of a fan get the vertex that lists it; the first halfedge of a path, which has no name,
//! gets its vertex in no other way. An edge statement sets `twin` and `edge`. An outer halfedge
//! starts where its vertex statement says, otherwise where its drawn twin ends, otherwise where it
//! did before. Finally, every named element that remains points to some halfedge that points to it,
//! if there is one. Positions are read before anything is written; the only expressions supported
//! are sums and halves of positions.

use glam::DVec3;
use hedgerow::diagram::{
    Access, Binary, Expr, ExprKind, Kind, LoopKind, NameId, Rule, Spoke, Unary,
};
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};

use super::matching::Match;

/// A mesh after a rewrite, and what the names of `after` are bound to in it.
pub struct Rewritten {
    /// The mesh.
    pub mesh: Mesh,
    /// The match, with the new elements.
    pub at: Match,
    /// Whether all assigned positions are supported.
    pub placed: bool,
}

/// The rewrite of a match; `None` if `after` uses a name that nothing binds.
pub fn rewrite(rule: &Rule, mesh: &Mesh, at: &Match) -> Option<Rewritten> {
    let mut rewrite = Rewrite { rule, mesh: mesh.clone(), at: at.clone() };
    let positions = rewrite.positions();
    let placed = positions.len() == rule.assignments.len();
    rewrite.allocate();
    rewrite.reassign()?;
    rewrite.place(&positions)?;
    rewrite.erase();
    rewrite.point_at_halfedges();
    Some(Rewritten { mesh: rewrite.mesh, at: rewrite.at, placed })
}

struct Rewrite<'a> {
    rule: &'a Rule,
    mesh: Mesh,
    at: Match,
}

impl Rewrite<'_> {
    fn is_path(&self, name: NameId) -> bool {
        self.rule.kind(name) == Kind::Path
    }

    fn element(&self, name: NameId) -> Option<u32> {
        self.at.elements[name.index()]
    }

    fn halfedge(&self, name: NameId) -> Option<HalfedgeId> {
        self.element(name).map(HalfedgeId)
    }

    fn vertex(&self, name: NameId) -> Option<VertexId> {
        self.element(name).map(VertexId)
    }

    fn run(&self, name: NameId) -> Option<Vec<HalfedgeId>> {
        let run = self.at.runs[name.index()].as_ref()?;
        Some(run.iter().map(|&h| HalfedgeId(h)).collect())
    }

    fn allocate(&mut self) {
        for created in &self.rule.created {
            let mesh = &mut self.mesh;
            let element = match self.rule.kind(created.name) {
                Kind::Vertex => mesh.add_vertex().0,
                Kind::Halfedge => mesh.add_halfedge().0,
                Kind::Edge => mesh.add_edge().0,
                Kind::Face => mesh.add_face().0,
                Kind::Path | Kind::Fan => continue,
            };
            if self.rule.kind(created.name) == Kind::Vertex {
                mesh.set_position(VertexId(element), DVec3::ONE);
            }
            self.at.elements[created.name.index()] = Some(element);
        }
    }

    /// The assigned positions that are supported.
    fn positions(&self) -> Vec<(NameId, DVec3)> {
        let assignments = self.rule.assignments.iter();
        assignments.filter_map(|set| Some((set.target.name, self.vector(&set.value)?))).collect()
    }

    fn vector(&self, expr: &Expr) -> Option<DVec3> {
        match &expr.kind {
            ExprKind::Read(Access::Position, of) => match of.kind {
                ExprKind::Element(name) => self.mesh.get_position(self.vertex(name)?),
                _ => None,
            },
            ExprKind::Binary(Binary::AddVector, x, y) => Some(self.vector(x)? + self.vector(y)?),
            ExprKind::Binary(Binary::DivideVector, x, y) => Some(self.vector(x)? / real(y)?),
            _ => None,
        }
    }

    fn place(&mut self, positions: &[(NameId, DVec3)]) -> Option<()> {
        for &(name, position) in positions {
            self.mesh.set_position(self.vertex(name)?, position);
        }
        Some(())
    }

    fn reassign(&mut self) -> Option<()> {
        self.loops()?;
        self.edges()?;
        self.outer_origins()?;
        self.fans()
    }

    fn loops(&mut self) -> Option<()> {
        for orbit in &self.rule.after.loops {
            let face = FaceId(self.element(orbit.face.name)?);
            // Every halfedge of the loop, and whether it is inside a path: then its predecessor
            // does not change.
            let mut cycle: Vec<(HalfedgeId, bool)> = Vec::new();
            for item in &orbit.items {
                let name = item.item.name;
                let from = self.vertex(item.from.name)?;
                if self.is_path(name) {
                    for (place, half) in self.run(name)?.into_iter().enumerate() {
                        self.mesh.set_face(half, face);
                        cycle.push((half, place > 0));
                    }
                } else {
                    let half = self.halfedge(name)?;
                    self.mesh.set_vertex(half, from);
                    self.mesh.set_face(half, face);
                    cycle.push((half, false));
                }
            }
            for (place, &(half, _)) in cycle.iter().enumerate() {
                let (next, inside) = cycle[(place + 1) % cycle.len()];
                if !inside {
                    self.mesh.set_next(half, next);
                    self.mesh.set_prev(next, half);
                }
            }
            match orbit.kind {
                LoopKind::Face => self.mesh.set_hole(face, false),
                LoopKind::Hole => self.mesh.set_hole(face, true),
                LoopKind::Any => {}
            }
        }
        Some(())
    }

    fn edges(&mut self) -> Option<()> {
        for statement in &self.rule.after.edges {
            let edge = EdgeId(self.element(statement.edge.name)?);
            let [left, right] = statement.halfedges;
            let (left, right) = (self.halfedge(left.name)?, self.halfedge(right.name)?);
            self.mesh.set_twin(left, right);
            self.mesh.set_twin(right, left);
            self.mesh.set_edge(left, edge);
            self.mesh.set_edge(right, edge);
        }
        Some(())
    }

    fn outer_origins(&mut self) -> Option<()> {
        let after = &self.rule.after;
        let in_a_loop = |name: NameId| {
            after.loops.iter().flat_map(|orbit| &orbit.items).any(|item| item.item.name == name)
        };
        for outer in self.rule.names_of(Kind::Halfedge).filter(|&name| !in_a_loop(name)) {
            let listed = after.stars.iter().find(|star| {
                let here =
                    |spoke: &Spoke| matches!(spoke, Spoke::Halfedge(half) if half.name == outer);
                star.spokes.iter().any(here)
            });
            let twin = after.edges.iter().find_map(|edge| {
                let [left, right] = edge.halfedges.map(|half| half.name);
                if left == outer { Some(right) } else { (right == outer).then_some(left) }
            });
            let twin_ends = twin.and_then(|twin| {
                after.loops.iter().find_map(|orbit| {
                    let place = orbit.items.iter().position(|item| item.item.name == twin)?;
                    let behind = orbit.items.get(place + 1).map(|item| item.from);
                    Some(behind.unwrap_or(orbit.end).name)
                })
            });
            if let Some(origin) = listed.map(|star| star.vertex.name).or(twin_ends) {
                self.mesh.set_vertex(self.halfedge(outer)?, self.vertex(origin)?);
            }
        }
        Some(())
    }

    fn fans(&mut self) -> Option<()> {
        for star in &self.rule.after.stars {
            let vertex = self.vertex(star.vertex.name)?;
            for spoke in &star.spokes {
                if let Spoke::Fan(fan) = spoke {
                    for half in self.run(fan.name)? {
                        self.mesh.set_vertex(half, vertex);
                    }
                }
            }
        }
        Some(())
    }

    fn erase(&mut self) {
        for erased in &self.rule.erased {
            let name = erased.name;
            let mesh = &mut self.mesh;
            match (self.rule.kind(name), self.at.elements[name.index()]) {
                (Kind::Vertex, Some(v)) => mesh.erase_vertex(VertexId(v)),
                (Kind::Halfedge, Some(h)) => mesh.erase_halfedge(HalfedgeId(h)),
                (Kind::Edge, Some(e)) => mesh.erase_edge(EdgeId(e)),
                (Kind::Face, Some(f)) => mesh.erase_face(FaceId(f)),
                _ => {
                    for half in self.run(name).unwrap_or_default() {
                        self.mesh.erase_halfedge(half);
                    }
                }
            }
        }
    }

    fn point_at_halfedges(&mut self) {
        let mut vertices = Vec::new();
        let mut edges = Vec::new();
        let mut faces = Vec::new();
        for (index, &element) in self.at.elements.iter().enumerate() {
            let Some(element) = element else { continue };
            match self.rule.names[index].kind {
                Kind::Vertex => vertices.push((VertexId(element), HalfedgeId::NONE)),
                Kind::Edge => edges.push((EdgeId(element), HalfedgeId::NONE)),
                Kind::Face => faces.push((FaceId(element), HalfedgeId::NONE)),
                Kind::Halfedge | Kind::Path | Kind::Fan => {}
            }
        }
        // Named halfedges and runs are tried first; other halfedges only if none of these fits.
        let named = (0..self.at.elements.len()).filter_map(|index| {
            let is_halfedge = self.rule.names[index].kind == Kind::Halfedge;
            self.at.elements[index].filter(|_| is_halfedge)
        });
        let near = named.chain(self.at.runs.iter().flatten().flatten().copied());
        let mut near: Vec<_> = near.map(HalfedgeId).collect();
        near.retain(|&half| self.mesh.halfedge_alive(half));
        self.choose(near.into_iter(), &mut vertices, &mut edges, &mut faces);
        let missing = vertices.iter().any(|(_, half)| half.is_none())
            || edges.iter().any(|(_, half)| half.is_none())
            || faces.iter().any(|(_, half)| half.is_none());
        if missing {
            self.choose(self.mesh.halfedges(), &mut vertices, &mut edges, &mut faces);
        }
        for (vertex, half) in vertices {
            if self.mesh.vertex_alive(vertex) {
                self.mesh.set_vertex_halfedge(vertex, half);
            }
        }
        for (edge, half) in edges {
            if self.mesh.edge_alive(edge) {
                self.mesh.set_edge_halfedge(edge, half);
            }
        }
        for (face, half) in faces {
            if self.mesh.face_alive(face) {
                self.mesh.set_face_halfedge(face, half);
            }
        }
    }

    fn choose(
        &self,
        halfedges: impl Iterator<Item = HalfedgeId>,
        vertices: &mut [(VertexId, HalfedgeId)],
        edges: &mut [(EdgeId, HalfedgeId)],
        faces: &mut [(FaceId, HalfedgeId)],
    ) {
        for half in halfedges {
            let record = self.mesh.halfedge(half);
            vertices.iter_mut().filter(|(v, _)| *v == record.vertex).for_each(|(_, h)| *h = half);
            edges.iter_mut().filter(|(e, _)| *e == record.edge).for_each(|(_, h)| *h = half);
            faces.iter_mut().filter(|(f, _)| *f == record.face).for_each(|(_, h)| *h = half);
        }
    }
}

fn real(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Real(value) => Some(*value),
        ExprKind::Int(value) => Some(*value as f64),
        ExprKind::Unary(Unary::ToReal, value) => real(value),
        _ => None,
    }
}
