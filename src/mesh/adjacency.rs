//! The neighbors of all vertices, in lists: for loops that ask for them again and again while the
//! mesh keeps its pointers.
//!
//! To walk around a vertex is to wait for one halfedge after the other; a list is read at once. To
//! make the lists, some vertices are walked around side by side, so that their waits overlap.

use std::ops::Range;

use super::connectivity::Mesh;
use super::id::{HalfedgeId, VertexId};
use super::parallel;

/// For each vertex the vertices where its spokes end, in the order of [`Mesh::spokes`] (compressed
/// sparse rows). An erased or isolated vertex has none.
#[derive(Debug)]
pub(crate) struct Adjacency {
    /// Where the list of each vertex begins, and at last where all end.
    starts: Vec<u32>,
    neighbors: Vec<u32>,
}

/// The number of vertices that are walked around side by side.
const LANES: usize = 8;

/// The number of neighbors up to which that is done.
const FEW: usize = 16;

/// The fewest vertices that are worth a thread.
const LEAST: usize = 10_000;

/// A walk around a vertex.
#[derive(Clone, Copy)]
struct Lane {
    start: HalfedgeId,
    at: HalfedgeId,
    /// The twin of `at`, as the step there tells.
    twin: HalfedgeId,
    count: usize,
    /// The neighbors after the first, and at last the first.
    found: [u32; FEW],
    is_done: bool,
}

impl Adjacency {
    /// The lists of a mesh; `None` if its pointers do not lead around all vertices, or there is no
    /// memory.
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

    /// The most bytes that the lists of a mesh take.
    pub(crate) fn bytes(mesh: &Mesh) -> usize {
        (mesh.vertices.len() + 1 + mesh.halfedges.len()) * size_of::<u32>()
    }

    /// The number of lists.
    pub(crate) fn vertices(&self) -> usize {
        self.starts.len() - 1
    }

    /// Where the lists begin, and the neighbors in them.
    pub(crate) fn tables(&self) -> [*const u32; 2] {
        [self.starts.as_ptr(), self.neighbors.as_ptr()]
    }

    fn of_range(mesh: &Mesh, range: Range<usize>) -> Option<Self> {
        let (mut starts, mut neighbors) = (Vec::new(), Vec::new());
        starts.try_reserve_exact(range.len() + 1).ok()?;
        // Most vertices have six.
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

    /// Appends what it has found.
    fn give(&self, mesh: &Mesh, to: &mut Vec<u32>) -> Option<()> {
        let begin = to.len();
        if self.at == self.start {
            to.try_reserve(self.count).ok()?;
            // The halfedge where it began is known only now.
            if self.count > 0 && mesh.halfedges.get(self.start.index())?.twin != self.twin {
                return None;
            }
            to.extend_from_slice(&self.found[..self.count]);
            to[begin..].rotate_right(usize::from(self.count > 0));
        } else {
            for spoke in mesh.spokes_from(self.start) {
                to.try_reserve(1).ok()?;
                to.push(mesh.get_vertex(mesh.get_twin(spoke)?)?.0);
                // Of a mesh in order there are no more.
                if to.len() > mesh.halfedges.len() {
                    return None;
                }
            }
        }
        to[begin..].iter().all(|&id| mesh.vertex_alive(VertexId(id))).then_some(())
    }
}
