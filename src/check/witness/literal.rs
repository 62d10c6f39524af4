//! The rewrite, carried out literally: the four phases by the pointer rules, and nothing more.
//!
//! In a loop of `after`, `x.next` is what follows, `x.vertex` the name before it, `x.face` the face
//! of the loop; along a path, `face` is set. In an edge, `twin` and `edge` are set. An outer
//! halfedge starts where its vertex statement says, else where its drawn twin ends; the spokes of a
//! fan start where it is listed. The `halfedge` of a drawn element is one that points to it, if
//! there is one. Pointers that nothing reassigns keep their old values, and `erase` erases.

use super::place::Place;
use crate::diagram::{Drawing, Kind, LoopKind, NameId, Ref, Spoke};
use crate::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};

/// The result of a rewrite.
#[derive(Clone, Debug)]
pub(super) struct Carried {
    /// The mesh after.
    pub mesh: Mesh,
    /// For each name, its element, new ones included.
    pub elements: Vec<Option<u32>>,
}

/// Carries the rewrite out; `None` if `after` uses a name that nothing binds.
pub(super) fn carry_out(drawing: &Drawing, place: &Place) -> Option<Carried> {
    let mut rewrite =
        Rewrite { drawing, place, mesh: place.mesh.clone(), elements: place.elements.clone() };
    rewrite.allocate();
    rewrite.loops()?;
    rewrite.edges()?;
    rewrite.origins()?;
    rewrite.fans()?;
    let erased = rewrite.erase();
    rewrite.own_halfedges(&erased);
    rewrite.positions();
    Some(Carried { mesh: rewrite.mesh, elements: rewrite.elements })
}

struct Rewrite<'a> {
    drawing: &'a Drawing<'a>,
    place: &'a Place,
    mesh: Mesh,
    elements: Vec<Option<u32>>,
}

impl Rewrite<'_> {
    fn halfedge(&self, name: NameId) -> Option<HalfedgeId> {
        self.elements[name.index()].map(HalfedgeId)
    }

    fn vertex(&self, name: NameId) -> Option<VertexId> {
        self.elements[name.index()].map(VertexId)
    }

    /// The halfedges of a path, or spokes of a fan, that `before` draws.
    fn run(&self, name: NameId) -> Option<&[HalfedgeId]> {
        self.drawing.before.mention(name)?;
        Some(&self.place.runs[name.index()])
    }

    fn allocate(&mut self) {
        for created in &self.drawing.rule.created {
            let mesh = &mut self.mesh;
            let element = match self.drawing.rule.kind(created.name) {
                Kind::Vertex => mesh.add_vertex().0,
                Kind::Halfedge => mesh.add_halfedge().0,
                Kind::Edge => mesh.add_edge().0,
                Kind::Face => mesh.add_face().0,
                Kind::Path | Kind::Fan => continue,
            };
            self.elements[created.name.index()] = Some(element);
        }
    }

    fn loops(&mut self) -> Option<()> {
        for orbit in &self.drawing.rule.after.loops {
            let face = self.elements[orbit.face.name.index()].map(FaceId)?;
            // Each halfedge, and whether the one before it is on the same path.
            let mut cycle = Vec::new();
            for item in &orbit.items {
                let name = item.item.name;
                if self.drawing.rule.kind(name) == Kind::Path {
                    for (at, half) in self.run(name)?.to_vec().into_iter().enumerate() {
                        self.mesh.set_face(half, face);
                        cycle.push((half, at > 0));
                    }
                    continue;
                }
                let half = self.halfedge(name)?;
                let vertex = self.vertex(item.from.name)?;
                self.mesh.set_vertex(half, vertex);
                self.mesh.set_face(half, face);
                cycle.push((half, false));
            }
            for (at, &(half, _)) in cycle.iter().enumerate() {
                let (next, inside) = cycle[(at + 1) % cycle.len()];
                if !inside {
                    self.mesh.set_next(half, next);
                    self.mesh.set_prev(next, half);
                }
            }
            match orbit.kind {
                LoopKind::Any => {}
                LoopKind::Face => self.mesh.set_hole(face, false),
                LoopKind::Hole => self.mesh.set_hole(face, true),
            }
        }
        Some(())
    }

    fn edges(&mut self) -> Option<()> {
        for statement in &self.drawing.rule.after.edges {
            let edge = self.elements[statement.edge.name.index()].map(EdgeId)?;
            let [left, right] = statement.halfedge_names();
            let (left, right) = (self.halfedge(left)?, self.halfedge(right)?);
            self.mesh.set_twin(left, right);
            self.mesh.set_twin(right, left);
            self.mesh.set_edge(left, edge);
            self.mesh.set_edge(right, edge);
        }
        Some(())
    }

    fn origins(&mut self) -> Option<()> {
        let (drawing, after) = (self.drawing, &self.drawing.after);
        for half in drawing.rule.names_of(Kind::Halfedge) {
            if after.mention(half).is_none() || after.loop_of_item(half).is_some() {
                continue;
            }
            let twin_ends =
                || drawing.is_outer(half).then(|| after.loop_target(after.twin(half)?))?;
            if let Some(origin) = after.star_of_spoke(half).or_else(twin_ends) {
                let origin = self.vertex(origin)?;
                self.mesh.set_vertex(self.halfedge(half)?, origin);
            }
        }
        Some(())
    }

    fn fans(&mut self) -> Option<()> {
        for star in &self.drawing.rule.after.stars {
            let vertex = self.vertex(star.vertex.name)?;
            for spoke in &star.spokes {
                let Spoke::Fan(fan) = spoke else { continue };
                for half in self.run(fan.name)?.to_vec() {
                    self.mesh.set_vertex(half, vertex);
                }
            }
        }
        Some(())
    }

    fn erase(&mut self) -> Vec<NameId> {
        let erased: Vec<_> = self.drawing.rule.erased.iter().map(|erased| erased.name).collect();
        for &name in &erased {
            let element = self.elements[name.index()];
            let mesh = &mut self.mesh;
            match (self.drawing.rule.kind(name), element) {
                (Kind::Vertex, Some(v)) => mesh.erase_vertex(VertexId(v)),
                (Kind::Halfedge, Some(h)) => mesh.erase_halfedge(HalfedgeId(h)),
                (Kind::Edge, Some(e)) => mesh.erase_edge(EdgeId(e)),
                (Kind::Face, Some(f)) => mesh.erase_face(FaceId(f)),
                _ => {
                    for &half in &self.place.runs[name.index()] {
                        mesh.erase_halfedge(half);
                    }
                }
            }
        }
        erased
    }

    /// Sets the `halfedge` of each vertex, edge and face that `after` draws.
    fn own_halfedges(&mut self, erased: &[NameId]) {
        let rule = self.drawing.rule;
        for index in 0..rule.names.len() {
            let name = NameId(index as u32);
            let Some(element) = self.elements[index] else { continue };
            if erased.contains(&name) || self.drawing.after.mention(name).is_none() {
                continue;
            }
            let mesh = &mut self.mesh;
            let find = |says: &dyn Fn(HalfedgeId) -> u32, old: HalfedgeId| {
                let still = mesh.halfedge_alive(old) && says(old) == element;
                let other = || mesh.halfedges().find(|&half| says(half) == element);
                if still { None } else { other() }
            };
            match rule.kind(name) {
                Kind::Vertex => {
                    let id = VertexId(element);
                    if let Some(half) = find(&|half| mesh.vertex(half).0, mesh.vertex_halfedge(id))
                    {
                        mesh.set_vertex_halfedge(id, half);
                    }
                }
                Kind::Edge => {
                    let id = EdgeId(element);
                    if let Some(half) = find(&|half| mesh.edge(half).0, mesh.edge_halfedge(id)) {
                        mesh.set_edge_halfedge(id, half);
                    }
                }
                Kind::Face => {
                    let id = FaceId(element);
                    if let Some(half) = find(&|half| mesh.face(half).0, mesh.face_halfedge(id)) {
                        mesh.set_face_halfedge(id, half);
                    }
                }
                Kind::Halfedge | Kind::Path | Kind::Fan => {}
            }
        }
    }

    /// Puts new vertices in the middle of their new neighbors; the positions that the op sets do
    /// not matter here.
    fn positions(&mut self) {
        for &Ref { name, .. } in &self.drawing.rule.created {
            let Some(vertex) =
                self.vertex(name).filter(|_| self.drawing.rule.kind(name) == Kind::Vertex)
            else {
                continue;
            };
            let around: Vec<_> = self
                .mesh
                .neighbors(vertex)
                .filter(|&other| other != vertex && self.mesh.vertex_alive(other))
                .map(|other| self.mesh.position(other))
                .collect();
            if !around.is_empty() {
                let sum: glam::DVec3 = around.iter().sum();
                self.mesh.set_position(vertex, sum / around.len() as f64);
            }
        }
    }
}
