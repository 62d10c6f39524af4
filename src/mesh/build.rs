//! Making a mesh from a list of polygons.
//!
//! Corner `i` of the list becomes halfedge `i`, polygon `i` becomes face `i`, vertex `i`
//! stays vertex `i`. Twins are found by sorting the halfedges into one bucket per
//! vertex, the smaller of their ends, and each small bucket by the larger end; there is
//! no map of edges. What is left without a twin runs along a boundary: it gets a new
//! one, and these close to holes, whose ids come after those of the polygons.
//!
//! The list is either a mesh, or refused with the first place where it is none:
//! nothing is repaired here.

use glam::DVec3;

use super::build_error::BuildError;
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, ID_SPACE, VertexId};
use super::level::is_surface_of_single_edges;
use super::polygon_sides::Sides;
use super::polygons::Polygons;
use super::records::{FaceRecord, HalfedgeRecord};

impl Mesh {
    pub fn from_polygons(positions: &[DVec3], polygons: &Polygons) -> Result<Self, BuildError> {
        Self::from_owned_polygons(positions.to_vec(), polygons)
    }

    /// As [`Mesh::from_polygons`], taking the positions over instead of copying them.
    pub fn from_owned_polygons(
        positions: Vec<DVec3>,
        polygons: &Polygons,
    ) -> Result<Self, BuildError> {
        Self::build(positions, polygons).map_err(|(error, _)| error)
    }

    /// As [`Mesh::from_owned_polygons`], giving the positions back if there is no mesh.
    pub(super) fn build(
        positions: Vec<DVec3>,
        polygons: &Polygons,
    ) -> Result<Self, (BuildError, Vec<DVec3>)> {
        let checked = check_sizes(&positions, polygons);
        if let Err(error) = checked.and_then(|()| check_polygons(&positions, polygons)) {
            return Err((error, positions));
        }
        let mut builder = Builder::new(positions, polygons);
        match builder.build() {
            Ok(()) => Ok(builder.mesh),
            Err(error) => Err((error, builder.mesh.positions)),
        }
    }

    /// True if the mesh is what the list of its polygons says, so that files of polygons can hold
    /// it. A surface whose edges differ in their ends is; of other meshes the list is read again.
    pub fn is_polygons(&self) -> bool {
        if is_surface_of_single_edges(self) {
            return true;
        }
        let (positions, polygons) = self.to_polygons();
        // The list has an edge for each pair of corners in a row. Where the mesh has no more,
        // each of its edges is one of these, and all else follows.
        let rebuilt = Self::from_owned_polygons(positions, &polygons);
        rebuilt.is_ok_and(|rebuilt| rebuilt.edge_count() == self.edge_count())
    }
}

fn check_sizes(positions: &[DVec3], polygons: &Polygons) -> Result<(), BuildError> {
    // Each halfedge may need a twin, and each polygon a hole around it.
    let sizes = [
        (ElementKind::Vertex, positions.len()),
        (ElementKind::Halfedge, polygons.corners().len().saturating_mul(2)),
        (ElementKind::Face, polygons.len().saturating_mul(2)),
    ];
    match sizes.into_iter().find(|&(_, size)| size >= ID_SPACE) {
        Some((kind, _)) => Err(BuildError::TooLarge { kind }),
        None => Ok(()),
    }
}

fn check_polygons(positions: &[DVec3], polygons: &Polygons) -> Result<(), BuildError> {
    if let Some(i) = positions.iter().position(|p| !p.is_finite()) {
        return Err(BuildError::NotFinite { vertex: i as u32, position: positions[i] });
    }
    let vertices = positions.len();
    let mut sorted = Vec::new();
    for (polygon, corners) in polygons.iter().enumerate() {
        if let Some(error) = BuildError::of_polygon(polygon, corners, vertices, &mut sorted) {
            return Err(error);
        }
    }
    Ok(())
}

impl BuildError {
    /// The fault of a polygon by itself. `sorted` is room to work in.
    pub(super) fn of_polygon(
        polygon: usize,
        corners: &[u32],
        vertices: usize,
        sorted: &mut Vec<u32>,
    ) -> Option<Self> {
        if corners.len() < 3 {
            return Some(Self::TooFewCorners { polygon, corners: corners.len() });
        }
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Some(Self::NoSuchVertex { polygon, vertex, vertices });
        }
        let vertex = repeated(corners, sorted)?;
        Some(Self::RepeatedCorner { polygon, vertex })
    }
}

/// A corner that comes twice. `sorted` is room to work in.
fn repeated(corners: &[u32], sorted: &mut Vec<u32>) -> Option<u32> {
    if corners.len() <= 8 {
        let earlier = |(i, v): (usize, &u32)| corners[..i].contains(v).then_some(*v);
        return corners.iter().enumerate().find_map(earlier);
    }
    sorted.clear();
    sorted.extend_from_slice(corners);
    sorted.sort_unstable();
    sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])
}

struct Builder<'p> {
    mesh: Mesh,
    polygons: &'p Polygons,
}

impl<'p> Builder<'p> {
    fn new(positions: Vec<DVec3>, polygons: &'p Polygons) -> Self {
        let mesh = Mesh {
            vertices: vec![HalfedgeId::NONE; positions.len()],
            halfedges: Vec::with_capacity(polygons.corners().len()),
            faces: Vec::with_capacity(polygons.len()),
            positions,
            ..Mesh::default()
        };
        Self { mesh, polygons }
    }

    fn build(&mut self) -> Result<(), BuildError> {
        self.lay_loops();
        self.find_twins()?;
        self.close_holes()?;
        self.number_edges();
        self.check_fans()
    }

    /// One loop of halfedges per polygon: everything but twins and edges.
    fn lay_loops(&mut self) {
        let mut first = 0;
        for (polygon, corners) in self.polygons.iter().enumerate() {
            let last = first + corners.len() as u32 - 1;
            self.mesh.faces.push(FaceRecord { halfedge: HalfedgeId(first), hole: false });
            for (h, &v) in (first..).zip(corners) {
                self.mesh.halfedges.push(HalfedgeRecord {
                    next: HalfedgeId(if h == last { first } else { h + 1 }),
                    prev: HalfedgeId(if h == first { last } else { h - 1 }),
                    vertex: VertexId(v),
                    face: FaceId(polygon as u32),
                    ..HalfedgeRecord::UNSET
                });
            }
            first = last + 1;
        }
    }

    fn ends(&self, h: HalfedgeId) -> [u32; 2] {
        [self.mesh.vertex(h).0, self.mesh.vertex(self.mesh.next(h)).0]
    }

    /// Pairs the halfedges that run between the same vertices.
    fn find_twins(&mut self) -> Result<(), BuildError> {
        let count = self.mesh.halfedges.len() as u32;
        let vertices = self.mesh.vertices.len();
        let sides = Sides::gather(count, vertices, |side| self.ends(HalfedgeId(side)));
        sides.edges().try_for_each(|edge| self.join(edge))
    }

    /// Makes twins of the halfedges that run between the same two vertices, if they are
    /// two; one alone stays without.
    fn join(&mut self, edge: &[(u32, u32)]) -> Result<(), BuildError> {
        match *edge {
            [] | [_] => Ok(()),
            [(_, a), (_, b)] => {
                let [a, b] = [a, b].map(HalfedgeId);
                let [from, to] = self.ends(a);
                if self.mesh.vertex(b).0 == from {
                    let polygons = [self.polygon(a), self.polygon(b)];
                    return Err(BuildError::SameDirection { from, to, polygons });
                }
                self.mesh.set_twin(a, b);
                self.mesh.set_twin(b, a);
                Ok(())
            }
            [(_, a), (_, b), (_, c), ..] => Err(BuildError::EdgeUsedThrice {
                ends: self.ends(HalfedgeId(a)),
                polygons: [a, b, c].map(|h| self.polygon(HalfedgeId(h))),
            }),
        }
    }

    /// The polygon of a halfedge, or of its twin if it runs along a hole.
    fn polygon(&self, h: HalfedgeId) -> usize {
        let face = self.mesh.face(h).index();
        match face < self.polygons.len() {
            true => face,
            false => self.mesh.face(self.mesh.twin(h)).index(),
        }
    }

    /// Gives the halfedges along the boundary their twins, and closes these to holes.
    fn close_holes(&mut self) -> Result<(), BuildError> {
        let mesh = &mut self.mesh;
        let inner = mesh.halfedges.len();
        for h in 0..inner {
            if !mesh.halfedges[h].twin.is_none() {
                continue;
            }
            let h = HalfedgeId(h as u32);
            let outer = HalfedgeId(mesh.halfedges.len() as u32);
            let v = mesh.vertex(mesh.next(h));
            mesh.halfedges.push(HalfedgeRecord { twin: h, vertex: v, ..HalfedgeRecord::UNSET });
            mesh.set_twin(h, outer);
            // Each vertex has at most one outer halfedge, which it keeps as its own
            // until the loops are closed.
            let other = mesh.vertex_halfedge(v);
            if !other.is_none() {
                let polygons = [mesh.face(mesh.twin(other)).index(), mesh.face(h).index()];
                return Err(BuildError::BowTie { vertex: v.0, polygons });
            }
            mesh.set_vertex_halfedge(v, outer);
        }
        for outer in inner..mesh.halfedges.len() {
            let outer = HalfedgeId(outer as u32);
            let next = mesh.vertex_halfedge(mesh.target(outer));
            mesh.set_next(outer, next);
            mesh.set_prev(next, outer);
        }
        for outer in inner..mesh.halfedges.len() {
            let outer = HalfedgeId(outer as u32);
            if mesh.face(outer).is_none() {
                let hole = FaceId(mesh.faces.len() as u32);
                mesh.faces.push(FaceRecord { halfedge: outer, hole: true });
                mesh.holes += 1;
                let mut at = outer;
                while mesh.face(at).is_none() {
                    mesh.set_face(at, hole);
                    at = mesh.next(at);
                }
            }
        }
        Ok(())
    }

    /// Edges are numbered by the first of their halfedges.
    fn number_edges(&mut self) {
        let mesh = &mut self.mesh;
        mesh.edges.reserve_exact(mesh.halfedges.len() / 2);
        for h in 0..mesh.halfedges.len() {
            let h = HalfedgeId(h as u32);
            if mesh.edge(h).is_none() {
                let edge = EdgeId(mesh.edges.len() as u32);
                mesh.edges.push(h);
                mesh.set_edge(h, edge);
                mesh.set_edge(mesh.twin(h), edge);
            }
        }
    }

    /// Gives every vertex a halfedge, and checks that it reaches all the others.
    fn check_fans(&mut self) -> Result<(), BuildError> {
        let mesh = &mut self.mesh;
        for (h, record) in mesh.halfedges.iter().enumerate() {
            let first = &mut mesh.vertices[record.vertex.index()];
            if first.is_none() {
                *first = HalfedgeId(h as u32);
            }
        }
        // A walk stays at its vertex, so the walks reach all halfedges together or
        // miss some.
        let mut reached = 0;
        for &first in mesh.vertices.iter().filter(|h| !h.is_none()) {
            let mut at = first;
            loop {
                reached += 1;
                at = mesh.twin(mesh.prev(at));
                if at == first {
                    break;
                }
            }
        }
        if reached == mesh.halfedges.len() { Ok(()) } else { Err(self.bow_tie()) }
    }

    #[cold]
    fn bow_tie(&self) -> BuildError {
        let mesh = &self.mesh;
        let mut seen = vec![false; mesh.halfedges.len()];
        for &first in &mesh.vertices {
            mesh.spokes_from(first).for_each(|h| seen[h.index()] = true);
        }
        let missed = seen.iter().position(|seen| !seen);
        let h = HalfedgeId(missed.expect("the walks missed a halfedge") as u32);
        let vertex = mesh.vertex(h);
        let polygons = [self.polygon(mesh.vertex_halfedge(vertex)), self.polygon(h)];
        BuildError::BowTie { vertex: vertex.0, polygons }
    }
}
