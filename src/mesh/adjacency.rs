//! Adjacency lists of all vertices, for loops that read them repeatedly while the pointers of the
//! mesh stay the same.
//!
//! A walk around a vertex waits for memory at each halfedge; a list is contiguous. To make the
//! lists, several vertices are walked around in step, so that their waits overlap.

use std::ops::Range;

use super::connectivity::Mesh;
use super::id::{HalfedgeId, VertexId};
use super::parallel;

/// For each vertex the targets of its spokes, in the order of [`Mesh::spokes`] (compressed sparse
/// rows). An erased or isolated vertex has none.
#[derive(Debug)]
pub(crate) struct Adjacency {
    /// The start of the list of each vertex, and at last the end of all lists.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
}

/// The number of vertices that are walked around in step.
const LANES: usize = 8;

/// The greatest degree up to which that is done.
const FEW: usize = 16;

/// The fewest vertices that are worth a thread.
const LEAST: usize = 10_000;

/// A walk around a vertex.
#[derive(Clone, Copy)]
struct Lane {
    start: HalfedgeId,
    at: HalfedgeId,
    /// The twin that `at` should have, according to the step that led to it.
    twin: HalfedgeId,
    count: usize,
    /// The neighbors from the second on, and at last the first.
    found: [u32; FEW],
    is_done: bool,
}

impl Adjacency {
    /// The lists of a mesh; `None` if its pointers do not lead around all vertices, or memory runs
    /// out.
    pub(crate) fn of(mesh: &Mesh) -> Option<Self> {
        let parts = parallel::parts(mesh.vertices.len(), LEAST);
        let lists = parallel::map(parts, |range| Self::of_range(mesh, range));
        let mut lists = lists.into_iter().collect::<Option<Vec<_>>>()?.into_iter();
        let mut all = lists.next()?;
        for part in lists {
            let before = *all.starts.last()?;
            all.starts.try_reserve(part.starts.len()).ok()?;
            for start in &part.starts[1..] {
                all.starts.push(before.checked_add(*start)?);
            }
            all.neighbors.try_reserve(part.neighbors.len()).ok()?;
            all.neighbors.extend(part.neighbors);
        }
        Some(all)
    }

    /// An upper bound on the bytes that the lists of a mesh take.
    pub(crate) fn bytes(mesh: &Mesh) -> usize {
        (mesh.vertices.len() + 1 + mesh.halfedges.len()) * size_of::<u32>()
    }

    /// The number of lists.
    pub(crate) fn vertices(&self) -> usize {
        self.starts.len() - 1
    }

    /// The start and the end of the list of a vertex.
    #[inline]
    pub(crate) fn bounds(&self, vertex: u32) -> [u32; 2] {
        [0, 1].map(|side| self.starts.get(vertex as usize + side).copied().unwrap_or(0))
    }

    /// The neighbor at an index in all lists.
    #[inline]
    pub(crate) fn neighbor(&self, at: u32) -> Option<u32> {
        self.neighbors.get(at as usize).copied()
    }

    /// Pointers to the starts of the lists and to the neighbors.
    #[cfg(feature = "native")]
    pub(crate) fn tables(&self) -> [*const u32; 2] {
        [self.starts.as_ptr(), self.neighbors.as_ptr()]
    }

    fn of_range(mesh: &Mesh, range: Range<usize>) -> Option<Self> {
        let (mut starts, mut neighbors) = (Vec::new(), Vec::new());
        starts.try_reserve_exact(range.len() + 1).ok()?;
        // Most vertices have six neighbors.
        neighbors.try_reserve(6 * range.len()).ok()?;
        starts.push(0);
        for some in mesh.vertices[range].chunks(LANES) {
            let mut lanes = [Lane::at(HalfedgeId::NONE); LANES];
            for (lane, first) in lanes.iter_mut().zip(some) {
                *lane = Lane::at(*first);
            }
            while lanes.iter().any(|lane| !lane.is_done) {
                for lane in lanes.iter_mut().filter(|lane| !lane.is_done) {
                    lane.step(mesh)?;
                }
            }
            for lane in &lanes[..some.len()] {
                lane.give(mesh, &mut neighbors)?;
                starts.push(u32::try_from(neighbors.len()).ok()?);
            }
        }
        Some(Self { starts, neighbors })
    }
}

impl Lane {
    fn at(start: HalfedgeId) -> Self {
        let is_done = start == HalfedgeId::NONE || start == HalfedgeId::DEAD;
        let none = HalfedgeId::NONE;
        Self { start, at: start, twin: none, count: 0, found: [0; FEW], is_done }
    }

    /// Goes on to the next spoke.
    #[inline]
    fn step(&mut self, mesh: &Mesh) -> Option<()> {
        let spoke = mesh.halfedges.get(self.at.index())?;
        if self.twin != HalfedgeId::NONE && spoke.twin != self.twin {
            return None;
        }
        let before = mesh.halfedges.get(spoke.prev.index())?;
        self.found[self.count] = before.vertex.0;
        self.count += 1;
        (self.at, self.twin) = (before.twin, spoke.prev);
        self.is_done = self.at == self.start || self.count == FEW;
        Some(())
    }

    /// Appends the neighbors that were found.
    fn give(&self, mesh: &Mesh, to: &mut Vec<u32>) -> Option<()> {
        let begin = to.len();
        if self.at == self.start {
            to.try_reserve(self.count).ok()?;
            // The twin that the first halfedge should have is known only now.
            if self.count > 0 && mesh.halfedges.get(self.start.index())?.twin != self.twin {
                return None;
            }
            to.extend_from_slice(&self.found[..self.count]);
            to[begin..].rotate_right(usize::from(self.count > 0));
        } else {
            for spoke in mesh.spokes_from(self.start) {
                to.try_reserve(1).ok()?;
                to.push(mesh.get_vertex(mesh.get_twin(spoke)?)?.0);
                // A valid mesh has no more.
                if to.len() > mesh.halfedges.len() {
                    return None;
                }
            }
        }
        to[begin..].iter().all(|&id| mesh.vertex_alive(VertexId(id))).then_some(())
    }
}
