//! A finished mesh with the place where a drawing lies in it.

use super::super::alias::Quotient;
use super::layout::lay_out;
use super::sketch::{HalfedgeRole, Sketch, VertexRole};
use crate::diagram::{Drawing, Kind, LoopItem, LoopKind, NameId, Rule, Spoke};
use crate::mesh::{EdgeId, FaceId, HalfedgeId, Level, Mesh, VertexId, validate, validate_level};

/// The greatest number of loops for which every choice of faces and holes is examined.
const MOST_FLAGS: usize = 6;

/// A valid mesh, and where the drawing of `before` lies in it.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub mesh: Mesh,
    /// For each name, its element, if it has one.
    pub elements: Vec<Option<u32>>,
    /// For each name, the halfedges of the path, or the spokes of the fan.
    pub runs: Vec<Vec<HalfedgeId>>,
    /// The roles of the halfedges, by their ids.
    pub halfedges: Vec<HalfedgeRole>,
    /// The roles of the vertices, by their ids.
    pub vertices: Vec<VertexRole>,
    /// The loops outside the drawing.
    pub outside: Vec<FaceId>,
    /// The loops that the drawing calls `loop`: either faces or holes.
    pub either: Vec<FaceId>,
}

impl Place {
    /// The mesh of a sketch whose outside is closed; `None` if it is not valid, or does not agree
    /// with the vertex statements, or the match would be refused.
    pub fn of(drawing: &Drawing, sketch: Sketch) -> Option<Self> {
        let count = drawing.rule.names.len();
        let halfedge = |half: usize| HalfedgeId(half as u32);
        let ids = |run: &Vec<usize>| run.iter().map(|&half| halfedge(half)).collect();
        let mut place = Self {
            mesh: Mesh::default(),
            elements: vec![None; count],
            runs: sketch.runs.iter().map(ids).collect(),
            halfedges: sketch.halves.iter().map(|half| half.role).collect(),
            vertices: sketch.vertices.clone(),
            outside: Vec::new(),
            either: Vec::new(),
        };
        for name in 0..count {
            let element = sketch.half_of[name].or(sketch.vertex_of[name]);
            place.elements[name] = element.map(|element| element as u32);
        }
        place.tables(&sketch)?;
        place.edges(drawing);
        place.faces(drawing, &sketch);
        validate(&place.mesh).ok()?;
        place.fans(drawing, sketch.late)?;
        if place.is_refused(drawing) {
            return None;
        }
        Some(place)
    }

    /// The same place for the rule in which the names that are one here are separate.
    pub fn with_each_name(self, rule: &Rule, quotient: &Quotient) -> Self {
        let names = || rule.ids();
        let pieces = |run: &[LoopItem]| -> Vec<HalfedgeId> {
            let items = run.iter().map(|item| item.item.name);
            let halfedges = items.flat_map(|item| match self.halfedge(item) {
                Some(half) => vec![half],
                None => self.runs[item.index()].clone(),
            });
            halfedges.collect()
        };
        let run = |name: NameId| match quotient.run(name) {
            Some(run) => pieces(run),
            None => self.runs[quotient.stands_for(name).index()].clone(),
        };
        let halfedges = self.halfedges.iter().map(|role| match *role {
            HalfedgeRole::OnPath(piece) => HalfedgeRole::OnPath(quotient.path_of(piece)),
            role => role,
        });
        let vertices = self.vertices.iter().map(|role| match *role {
            VertexRole::Along(piece) => VertexRole::Along(quotient.path_of(piece)),
            role => role,
        });
        let element = |name: NameId| self.elements[quotient.stands_for(name).index()];
        Self {
            elements: names().map(element).collect(),
            runs: names().map(run).collect(),
            halfedges: halfedges.collect(),
            vertices: vertices.collect(),
            ..self.clone()
        }
    }

    /// Prepares the mesh for display: its faces, holes and positions. Its pointers stay the same.
    pub fn finish(&mut self) {
        self.outside_may_be_faces();
        lay_out(self);
    }

    fn tables(&mut self, sketch: &Sketch) -> Option<()> {
        let mesh = &mut self.mesh;
        for _ in &sketch.vertices {
            mesh.add_vertex();
        }
        for _ in &sketch.halves {
            mesh.add_halfedge();
        }
        let id = |half: usize| HalfedgeId(half as u32);
        for (number, half) in sketch.halves.iter().enumerate() {
            let vertex = VertexId(half.origin as u32);
            mesh.set_next(id(number), id(half.next?));
            mesh.set_prev(id(number), id(half.prev?));
            mesh.set_twin(id(number), id(half.twin?));
            mesh.set_vertex(id(number), vertex);
            if mesh.vertex_halfedge(vertex).is_none() {
                mesh.set_vertex_halfedge(vertex, id(number));
            }
        }
        Some(())
    }

    fn halfedge(&self, name: NameId) -> Option<HalfedgeId> {
        self.elements[name.index()].map(HalfedgeId)
    }

    fn edges(&mut self, drawing: &Drawing) {
        for statement in &drawing.rule.before.edges {
            if let Some(half) = self.halfedge(statement.halfedges[0].name) {
                let edge = self.edge_of(half);
                self.elements[statement.edge.name.index()] = Some(edge.0);
            }
        }
        for half in 0..self.halfedges.len() as u32 {
            if self.mesh.edge(HalfedgeId(half)).is_none() {
                self.edge_of(HalfedgeId(half));
            }
        }
    }

    fn edge_of(&mut self, half: HalfedgeId) -> EdgeId {
        let edge = self.mesh.add_edge();
        self.mesh.set_edge_halfedge(edge, half);
        self.mesh.set_edge(half, edge);
        self.mesh.set_edge(self.mesh.twin(half), edge);
        edge
    }

    /// Adds the faces; loops outside the drawing are holes.
    fn faces(&mut self, drawing: &Drawing, sketch: &Sketch) {
        for orbit in &drawing.rule.before.loops {
            let face = orbit.face.name;
            let own = sketch.halves.iter().position(|half| half.face == Some(face));
            if let Some(half) = own {
                let id = self.face_of(HalfedgeId(half as u32));
                self.mesh.set_hole(id, orbit.kind == LoopKind::Hole);
                if orbit.kind == LoopKind::Any {
                    self.either.push(id);
                }
                self.elements[face.index()] = Some(id.0);
            }
        }
        for half in (0..self.halfedges.len() as u32).map(HalfedgeId) {
            if self.mesh.face(half).is_none() {
                let id = self.face_of(half);
                self.mesh.set_hole(id, true);
                self.outside.push(id);
            }
        }
    }

    fn face_of(&mut self, half: HalfedgeId) -> FaceId {
        let face = self.mesh.add_face();
        self.mesh.set_face_halfedge(face, half);
        let orbit: Vec<_> = self.mesh.loop_from(half).collect();
        for half in orbit {
            self.mesh.set_face(half, face);
        }
        face
    }

    /// The highest level that the mesh has, where its loops may be faces or holes.
    pub fn level(&self) -> Level {
        let levels = [Level::Simple, Level::Surface];
        levels.into_iter().find(|&level| self.can_have(level)).unwrap_or(Level::Map)
    }

    /// True if the mesh has a level, where its loops may be faces or holes.
    pub fn can_have(&self, level: Level) -> bool {
        self.at_level(level).is_some()
    }

    /// The mesh at a level: with as few holes outside the drawing turned into faces, and as few
    /// loops of the drawing into holes, as that needs.
    fn at_level(&self, level: Level) -> Option<Mesh> {
        let loops: Vec<_> = self.outside.iter().chain(&self.either).collect();
        let mut ways: Vec<u64> = match loops.len() {
            0..=MOST_FLAGS => (0..1 << loops.len()).collect(),
            // Only as they are, or with all outside loops faces, which a surface allows most
            // easily.
            _ => vec![0, (1 << self.outside.len().min(63)) - 1],
        };
        ways.sort_by_key(|way| way.count_ones());
        ways.into_iter().find_map(|way| {
            let mut mesh = self.mesh.clone();
            for (at, &&face) in loops.iter().enumerate() {
                let is_outside = at < self.outside.len();
                let turned = at < 63 && way >> at & 1 == 1;
                mesh.set_hole(face, is_outside != turned);
            }
            validate_level(&mesh, level).is_ok().then_some(mesh)
        })
    }

    /// Holes outside the drawing may as well be faces: they become faces if only then the mesh is a
    /// surface.
    fn outside_may_be_faces(&mut self) {
        let levels = [Level::Simple, Level::Surface];
        if let Some(mesh) = levels.into_iter().find_map(|level| self.at_level(level)) {
            self.mesh = mesh;
        }
    }

    /// Binds the fans; `None` if a vertex statement does not agree with the mesh.
    fn fans(&mut self, drawing: &Drawing, late: bool) -> Option<()> {
        for star in &drawing.rule.before.stars {
            let vertex = self.elements[star.vertex.name.index()].map(VertexId)?;
            let listed = |spoke: &Spoke| spoke.halfedge().and_then(|half| self.halfedge(half));
            let begin = star.spokes.iter().position(|spoke| listed(spoke).is_some());
            let first = begin.and_then(|at| listed(&star.spokes[at]));
            let ring: Vec<_> = match first {
                Some(first) => self.mesh.spokes_from(first).collect(),
                None => self.mesh.spokes(vertex).collect(),
            };
            let count = star.spokes.len();
            let turned = (0..count).map(|at| star.spokes[(begin.unwrap_or(0) + at) % count]);
            let turned: Vec<_> = turned.collect();
            let mut at = 0;
            let mut bound = Vec::new();
            for (place, spoke) in turned.iter().enumerate() {
                if let Some(half) = listed(spoke) {
                    if ring.get(at) != Some(&half) {
                        return None;
                    }
                    at += 1;
                    continue;
                }
                let stop = turned[place + 1..].iter().find_map(listed);
                let from = at;
                let next = turned.get(place + 1);
                let leaves = late && next.is_some_and(|next| listed(next).is_none());
                while !leaves && at < ring.len() && Some(ring[at]) != stop {
                    at += 1;
                }
                if let Spoke::Fan(fan) = spoke {
                    bound.push((fan.name, ring[from..at].to_vec()));
                }
            }
            if at != ring.len() {
                return None;
            }
            for (fan, run) in bound {
                self.runs[fan.index()] = run;
            }
        }
        Some(())
    }

    /// True if only empty paths would be left in a loop, which the matcher refuses.
    fn is_refused(&self, drawing: &Drawing) -> bool {
        let rule = drawing.rule;
        let empty = |name: NameId| {
            rule.kind(name) == Kind::Path
                && drawing.before.mention(name).is_some()
                && self.runs[name.index()].is_empty()
        };
        rule.after.loops.iter().any(|orbit| orbit.items.iter().all(|item| empty(item.item.name)))
    }
}
