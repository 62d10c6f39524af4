//! Construction of a mesh from a list of polygons.
//!
//! Corner `i` of the list becomes halfedge `i`, polygon `i` becomes face `i`, vertex `i` stays
//! vertex `i`. Twins are found by sorting the halfedges into one bucket per vertex, the smaller of
//! their ends, and each small bucket by the larger end; there is no map of edges. A halfedge left
//! without a twin runs along a boundary: it gets a new one, and these new ones form holes, whose
//! ids come after those of the polygons.
//!
//! A list that is not a mesh is rejected with the first fault found; nothing is repaired here.

use std::ops::Range;
use std::sync::atomic::AtomicU32;
use std::sync::atomic::Ordering::Relaxed;

use glam::DVec3;

use super::build_error::BuildError;
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, ID_SPACE, VertexId};
use super::level::is_surface_of_single_edges;
use super::loops::Loops;
use super::parallel;
use super::polygon_sides::Sides;
use super::polygons::Polygons;
use super::records::{FaceState, HalfedgeRecord};

impl Mesh {
    /// The mesh of a list of polygons, which are counterclockwise seen from outside.
    ///
    /// # Errors
    /// The list is not a mesh: an index is out of range, a polygon repeats a corner or has fewer
    /// than three, an edge has more than two polygons or two of opposite orientation, or the polygons
    /// around a vertex form more than one fan.
    pub fn from_polygons(positions: &[DVec3], polygons: &Polygons) -> Result<Self, BuildError> {
        Self::from_owned_polygons(positions.to_vec(), polygons)
    }

    /// As [`Mesh::from_polygons`], but takes the positions instead of copying them.
    ///
    /// # Errors
    /// As for [`Mesh::from_polygons`].
    pub fn from_owned_polygons(
        positions: Vec<DVec3>,
        polygons: &Polygons,
    ) -> Result<Self, BuildError> {
        Self::build(positions, polygons).map_err(|(error, _)| error)
    }

    /// As [`Mesh::from_owned_polygons`], but returns the positions if there is no mesh.
    pub(super) fn build(
        positions: Vec<DVec3>,
        polygons: &Polygons,
    ) -> Result<Self, (BuildError, Vec<DVec3>)> {
        let checked = check_sizes(&positions, polygons);
        if let Err(error) = checked.and_then(|()| check_polygons(&positions, polygons)) {
            return Err((error, positions));
        }
        let mut builder = Builder::new(positions.len(), polygons);
        match builder.build() {
            Ok(()) => Ok(builder.finish(positions)),
            Err(error) => Err((error, positions)),
        }
    }

    /// True if the list of its polygons determines the mesh, so that files of polygons can hold it.
    /// This is so for a surface in which no two edges have the same ends; other meshes are rebuilt
    /// from their list and compared.
    pub fn is_polygons(&self) -> bool {
        if is_surface_of_single_edges(self) {
            return true;
        }
        let (positions, polygons) = self.to_polygons();
        // The list gives an edge for each pair of consecutive corners. If the mesh has no more,
        // each of its edges is one of these, and the rest follows.
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
    let vertices = positions.len();
    let odd = parallel::map(parallel::parts(vertices, LEAST), |mut part| {
        part.find(|&vertex| !positions[vertex].is_finite())
    });
    if let Some(vertex) = odd.into_iter().flatten().next() {
        return Err(BuildError::NotFinite { vertex: vertex as u32, position: positions[vertex] });
    }
    let checked = parallel::map(parallel::parts(polygons.len(), LEAST), |part| {
        let mut sorted = Vec::new();
        let mut all = (part.start..).zip(polygons.range(part));
        let fault = all.find_map(|(polygon, corners)| {
            BuildError::of_polygon(polygon, corners, vertices, &mut sorted)
        });
        fault.map_or(Ok(()), Err)
    });
    checked.into_iter().collect()
}

/// The fewest elements that are worth a thread.
const LEAST: usize = 4096;

/// A mesh under construction. Halfedges are numbers here: first the inner ones, one for each
/// corner, then the outer ones along the boundary. Their records are made last, when all is known.
struct Builder<'p> {
    loops: Loops<'p>,
    /// The twins of the inner halfedges; [`NONE`] along the boundary until outer ones are made.
    twins: Vec<AtomicU32>,
    /// The twins of the outer halfedges.
    boundary: Vec<u32>,
    /// A halfedge that starts at each vertex: the outer one, or the first.
    vertices: Vec<HalfedgeId>,
    holes: Holes,
}

/// The loops of outer halfedges.
#[derive(Default)]
struct Holes {
    /// The next, the previous and the hole of each outer halfedge.
    next: Vec<u32>,
    prev: Vec<u32>,
    hole: Vec<u32>,
    /// An outer halfedge of each hole.
    first: Vec<u32>,
}

const NONE: u32 = u32::MAX;

impl<'p> Builder<'p> {
    fn new(vertices: usize, polygons: &'p Polygons) -> Self {
        Self {
            loops: Loops::new(polygons.corners(), polygons.ends()),
            twins: Vec::new(),
            boundary: Vec::new(),
            vertices: vec![HalfedgeId::NONE; vertices],
            holes: Holes::default(),
        }
    }

    fn build(&mut self) -> Result<(), BuildError> {
        self.find_twins()?;
        self.close_holes()?;
        self.check_fans()
    }

    /// The number of inner halfedges.
    fn inner(&self) -> usize {
        self.loops.corners().len()
    }

    fn twin(&self, h: u32) -> u32 {
        match (h as usize).checked_sub(self.inner()) {
            None => self.twins[h as usize].load(Relaxed),
            Some(outer) => self.boundary[outer],
        }
    }

    /// Pairs the halfedges that run between the same vertices, and finds the first halfedge of each
    /// vertex.
    fn find_twins(&mut self) -> Result<(), BuildError> {
        let inner = self.inner();
        self.twins = parallel::collect(inner, LEAST, |_| AtomicU32::new(NONE));
        let sides = Sides::gather(&self.loops, self.vertices.len());
        let found = parallel::map(parallel::parts(self.vertices.len(), LEAST), |part| {
            sides.edges_of(part).try_for_each(|edge| self.join(edge))
        });
        found.into_iter().collect::<Result<(), _>>()?;
        self.find_first();
        Ok(())
    }

    /// Finds the first halfedge of each vertex.
    fn find_first(&mut self) {
        // Each thread scans all corners for those of its range of vertices.
        let threads = if self.inner() < LEAST { 1 } else { parallel::threads() };
        let parts = parallel::cut(self.vertices.len(), threads);
        let firsts = parallel::split(&mut self.vertices, parts.iter().map(Range::len));
        parallel::map(parts.iter().zip(firsts).collect(), |(part, firsts)| {
            for (h, &v) in self.loops.corners().iter().enumerate().rev() {
                if let Some(first) = firsts.get_mut((v as usize).wrapping_sub(part.start)) {
                    *first = HalfedgeId(h as u32);
                }
            }
        });
    }

    /// Makes twins of two halfedges that run between the same two vertices; a single one stays
    /// without a twin.
    fn join(&self, edge: &[(u32, u32)]) -> Result<(), BuildError> {
        let polygon = |h| self.loops.polygon(h) as usize;
        if let Some(fault) = BuildError::of_edge(edge, |h| self.loops.ends(h), polygon) {
            return Err(fault);
        }
        if let [(_, a), (_, b)] = *edge {
            self.twins[a as usize].store(b, Relaxed);
            self.twins[b as usize].store(a, Relaxed);
        }
        Ok(())
    }

    /// The polygon of a halfedge, or of its twin if it runs along a hole.
    fn polygon(&self, h: u32) -> usize {
        let outer = (h as usize).checked_sub(self.inner());
        self.loops.polygon(outer.map_or(h, |outer| self.boundary[outer])) as usize
    }

    /// Makes twins for the halfedges along the boundary, and links these into holes.
    fn close_holes(&mut self) -> Result<(), BuildError> {
        let inner = self.inner();
        let boundary = parallel::map(parallel::parts(inner, LEAST), |part| {
            (part.start as u32..part.end as u32).filter(|h| self.twin(*h) == NONE).collect()
        });
        self.boundary = parallel::joined(boundary);
        for (outer, &h) in (inner as u32..).zip(&self.boundary) {
            *self.twins[h as usize].get_mut() = outer;
            // Each vertex has at most one outer halfedge.
            let [_, v] = self.loops.ends(h);
            let other = std::mem::replace(&mut self.vertices[v as usize], HalfedgeId(outer)).0;
            if other as usize >= inner {
                let polygons = [self.polygon(other), self.polygon(h)];
                return Err(BuildError::BowTie { vertex: v, polygons });
            }
        }
        let count = self.boundary.len();
        let Holes { next, prev, hole, first } = &mut self.holes;
        let target = |&h: &u32| self.vertices[self.loops.corners()[h as usize] as usize].0;
        *next = self.boundary.iter().map(target).collect();
        (*prev, *hole) = (vec![NONE; count], vec![NONE; count]);
        for (outer, &next) in (inner as u32..).zip(&*next) {
            prev[next as usize - inner] = outer;
        }
        for outer in 0..count {
            let mut at = outer;
            while hole[at] == NONE {
                hole[at] = first.len() as u32;
                at = next[at] as usize - inner;
            }
            if at == outer && hole[outer] as usize == first.len() {
                first.push((inner + outer) as u32);
            }
        }
        Ok(())
    }

    /// Checks that the halfedge of each vertex reaches all others that start there.
    fn check_fans(&self) -> Result<(), BuildError> {
        // A walk stays at its vertex, so either the walks together reach all halfedges or some are
        // missed.
        let reached = parallel::map(parallel::parts(self.vertices.len(), LEAST), |part| {
            let mut reached = 0;
            self.vertices[part].iter().for_each(|&first| self.walk(first, |_| reached += 1));
            reached
        });
        match reached.into_iter().sum::<usize>() == self.inner() {
            true => Ok(()),
            false => Err(self.bow_tie()),
        }
    }

    /// Visits the inner halfedges around a vertex that are reached from its own, clockwise.
    #[inline]
    fn walk(&self, first: HalfedgeId, mut visit: impl FnMut(u32)) {
        if first.is_none() {
            return;
        }
        let inner = self.inner() as u32;
        let start = if first.0 < inner { first.0 } else { self.loops.next(self.twin(first.0)) };
        let mut at = start;
        loop {
            visit(at);
            let twin = self.twin(at);
            if twin >= inner {
                return;
            }
            at = self.loops.next(twin);
            if at == start {
                return;
            }
        }
    }

    #[cold]
    fn bow_tie(&self) -> BuildError {
        let mut seen = vec![false; self.inner()];
        for &first in &self.vertices {
            self.walk(first, |h| seen[h as usize] = true);
        }
        let missed = seen.iter().position(|seen| !seen);
        let h = missed.expect("the walks missed a halfedge") as u32;
        let vertex = self.loops.corners()[h as usize];
        let polygons = [self.polygon(self.vertices[vertex as usize].0), self.polygon(h)];
        BuildError::BowTie { vertex, polygons }
    }

    fn finish(self, positions: Vec<DVec3>) -> Mesh {
        let inner = self.inner();
        let edges = EdgeNumbers::new(inner, |h| h < self.twin(h));
        let halfedges = match self.loops.alike() {
            Some(3) => self.records_of_alike::<3>(&edges),
            Some(4) => self.records_of_alike::<4>(&edges),
            _ => parallel::collect(inner + self.boundary.len(), LEAST, |h| match h < inner {
                true => self.record(&edges, h as u32),
                false => self.outer_record(&edges, h as u32),
            }),
        };
        let polygons = self.loops.len();
        let faces = parallel::collect(polygons + self.holes.first.len(), LEAST, |face| {
            let hole = face.checked_sub(polygons);
            HalfedgeId(hole.map_or_else(|| self.loops.first(face), |hole| self.holes.first[hole]))
        });
        let mut face_states = Vec::with_capacity(faces.len());
        face_states.resize(polygons, FaceState::Face);
        face_states.resize(faces.len(), FaceState::Hole);
        Mesh {
            positions,
            halfedges,
            faces,
            face_states,
            edges: edges.first(),
            vertices: self.vertices,
            holes: self.holes.first.len(),
            ..Mesh::default()
        }
    }
}

impl Builder<'_> {
    /// The record of an inner halfedge.
    fn record(&self, edges: &EdgeNumbers, h: u32) -> HalfedgeRecord {
        let twin = self.twin(h);
        HalfedgeRecord {
            next: HalfedgeId(self.loops.next(h)),
            prev: HalfedgeId(self.loops.prev(h)),
            twin: HalfedgeId(twin),
            vertex: VertexId(self.loops.corners()[h as usize]),
            edge: EdgeId(edges.number(h.min(twin))),
            face: FaceId(self.loops.polygon(h)),
        }
    }

    fn outer_record(&self, edges: &EdgeNumbers, h: u32) -> HalfedgeRecord {
        let twin = self.twin(h);
        let outer = h as usize - self.inner();
        HalfedgeRecord {
            next: HalfedgeId(self.holes.next[outer]),
            prev: HalfedgeId(self.holes.prev[outer]),
            twin: HalfedgeId(twin),
            vertex: VertexId(self.loops.ends(twin)[1]),
            edge: EdgeId(edges.number(twin)),
            face: FaceId(self.holes.hole[outer] + self.loops.len() as u32),
        }
    }

    /// All records, for polygons with `N` corners each: as [`Self::record`], polygon by polygon.
    fn records_of_alike<const N: usize>(&self, edges: &EdgeNumbers) -> Vec<HalfedgeRecord> {
        let (corners, _) = self.loops.corners().as_chunks::<N>();
        let (twins, _) = self.twins.as_chunks::<N>();
        let room = corners.len() + self.boundary.len().div_ceil(N);
        let all: Vec<[_; N]> = parallel::collect_with_room(room, corners.len(), LEAST, |polygon| {
            let first = polygon as u32 * N as u32;
            let mut edge = edges.number(first);
            let (corners, twins) = (&corners[polygon], &twins[polygon]);
            std::array::from_fn(|i| {
                let h = first + i as u32;
                let twin = twins[i].load(Relaxed);
                let number = if h < twin { edge } else { edges.number(twin) };
                edge += u32::from(h < twin);
                HalfedgeRecord {
                    next: HalfedgeId(if i + 1 == N { first } else { h + 1 }),
                    prev: HalfedgeId(if i == 0 { h + N as u32 - 1 } else { h - 1 }),
                    twin: HalfedgeId(twin),
                    vertex: VertexId(corners[i]),
                    edge: EdgeId(number),
                    face: FaceId(polygon as u32),
                }
            })
        });
        let mut all = all.into_flattened();
        let outer = self.inner() as u32..(self.inner() + self.boundary.len()) as u32;
        all.extend(outer.map(|h| self.outer_record(edges, h)));
        all
    }
}

/// The numbers of the edges, in the order of their first halfedges.
struct EdgeNumbers {
    /// A bit for each halfedge that is the first of its edge.
    bits: Vec<u64>,
    /// The number of bits before each word, and that of all.
    before: Vec<u32>,
}

impl EdgeNumbers {
    fn new(halfedges: usize, is_first: impl Fn(u32) -> bool + Sync + Send) -> Self {
        let bits = parallel::collect(halfedges.div_ceil(64), LEAST / 64, |word| {
            let all = word * 64..halfedges.min(word * 64 + 64);
            all.rev().fold(0, |bits, h| bits << 1 | u64::from(is_first(h as u32)))
        });
        let mut before = Vec::with_capacity(bits.len() + 1);
        before.push(0);
        before.extend(bits.iter().scan(0, |all, bits| {
            *all += bits.count_ones();
            Some(*all)
        }));
        Self { bits, before }
    }

    /// The number of the edge whose first halfedge is `h`.
    #[inline]
    fn number(&self, h: u32) -> u32 {
        let (word, bit) = (h as usize / 64, h % 64);
        self.before[word] + (self.bits[word] & ((1 << bit) - 1)).count_ones()
    }

    /// The first halfedges of all edges.
    fn first(&self) -> Vec<HalfedgeId> {
        let count = self.before[self.bits.len()] as usize;
        let mut all = parallel::collect(count, LEAST, |_| HalfedgeId::NONE);
        let parts = parallel::parts(self.bits.len(), LEAST / 64);
        let count = |part: &Range<usize>| self.before[part.end] - self.before[part.start];
        let firsts = parallel::split(&mut all, parts.iter().map(|part| count(part) as usize));
        parallel::map(parts.iter().cloned().zip(firsts).collect(), |(part, first)| {
            let mut first = first.iter_mut();
            for word in part {
                let mut bits = self.bits[word];
                while bits != 0
                    && let Some(first) = first.next()
                {
                    *first = HalfedgeId(word as u32 * 64 + bits.trailing_zeros());
                    bits &= bits - 1;
                }
            }
        });
        all
    }
}
