//! Questions about the result of an operation.

use super::{Preview, is_in_triangle};
use crate::mesh::{ElementKind, FaceId, HalfedgeRecord, Mesh, OrbitCondition, VertexId};
use crate::rewrite::access::gone;
use crate::rewrite::distinct::Remainders;
use crate::rewrite::{ElementField, Fault};

/// What a walk around a vertex tells of the conditions about its star.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fan {
    /// All hold: it is a fan of three or more triangles, and at most one hole, and its neighbors
    /// differ.
    Simple,
    /// Such a fan, but two edges lead to the same neighbor: no loop lies around the vertex twice.
    Meeting,
    Other,
}

impl Preview {
    /// Whether a condition would hold for an element; `at` is the second element of a condition
    /// about two.
    pub fn foresees(
        &mut self,
        mesh: &Mesh,
        condition: OrbitCondition,
        element: u32,
        at: u32,
    ) -> Result<bool, Fault> {
        match condition {
            OrbitCondition::ThreeSides => self.three_sides(mesh, element),
            OrbitCondition::MeetsOnce => self.meets_once(mesh, element),
            OrbitCondition::CornerOnce => self.corner_once(mesh, element, at),
            OrbitCondition::TwoSpokes => self.two_spokes(mesh, element),
            OrbitCondition::OneHole => self.one_hole(mesh, element),
            OrbitCondition::FacesDiffer => self.faces_differ(mesh, element),
            OrbitCondition::NeighborsDiffer => self.neighbors_differ(mesh, element),
            OrbitCondition::SingleEdge => self.single_edge(mesh, element),
            OrbitCondition::CornersDiffer => self.corners_differ(mesh, element),
            OrbitCondition::CornersOwn => self.corners_own(mesh, element, at),
        }
    }

    /// Whether a condition would hold for the origin of every halfedge in a buffer.
    pub fn foresees_along(
        &mut self,
        mesh: &Mesh,
        condition: OrbitCondition,
        halfedges: &[u64],
    ) -> Result<bool, Fault> {
        for &halfedge in halfedges {
            let vertex = self.record(mesh, halfedge as u32)?.vertex.0;
            if !self.foresees(mesh, condition, vertex, vertex)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What a single walk around a vertex tells. `next` must have its new value, as where
    /// [`OrbitCondition::CornersDiffer`] is asked.
    pub fn fan(&mut self, mesh: &Mesh, vertex: u32) -> Fan {
        let mut targets = std::mem::take(&mut self.corners);
        let fan = self.walk_fan(mesh, vertex, &mut targets);
        self.corners = targets;
        fan.unwrap_or(Fan::Other)
    }

    /// [`fan`](Self::fan), if it is one of triangles and at most one hole, and the vertex is not its
    /// own neighbor; the ends of its spokes replace `targets`.
    ///
    /// Walks in both directions until they meet: so two reads at a time wait for memory.
    fn walk_fan(&mut self, mesh: &Mesh, vertex: u32, targets: &mut Vec<u32>) -> Option<Fan> {
        if !self.is_plain() {
            return None;
        }
        let is_closed = mesh.hole_count() == 0;
        let start = mesh.get_vertex_halfedge(VertexId(vertex))?;
        let (mut holes, mut remainders) = (0, Remainders::default());
        targets.clear();
        // The sector between a spoke and the next one, which ends where `before` starts.
        let mut sector = |spoke: &HalfedgeRecord, before: &HalfedgeRecord| {
            let target = before.vertex.0;
            targets.push(target);
            remainders.add(target);
            let is_hole = !is_closed && mesh.get_is_hole(spoke.face)?;
            holes += u32::from(is_hole);
            let fits = is_hole || is_in_triangle(spoke, before);
            (fits && target != vertex && holes <= 1).then_some(())
        };
        let (mut ahead, mut behind) = (start, mesh.get_halfedge(start)?);
        let mut last = start;
        for _ in 0..self.longest(mesh) {
            let spoke = mesh.get_halfedge(ahead)?;
            let before = mesh.get_halfedge(spoke.prev)?;
            sector(spoke, before)?;
            ahead = before.twin;
            if ahead == last {
                break;
            }
            let before = mesh.get_halfedge(behind.twin)?;
            last = before.next;
            behind = mesh.get_halfedge(last)?;
            sector(behind, before)?;
            if ahead == last {
                break;
            }
        }
        if ahead != last {
            return None;
        }
        let differ = remainders.differ || self.seen.are_all_new(targets);
        match (differ, targets.len()) {
            (true, 0..3) => None,
            (true, _) => Some(Fan::Simple),
            (false, _) => Some(Fan::Meeting),
        }
    }

    fn three_sides(&mut self, mesh: &Mesh, face: u32) -> Result<bool, Fault> {
        self.corners.clear();
        Ok(self.walk_loop(mesh, face, 3)? == 3)
    }

    fn meets_once(&mut self, mesh: &Mesh, face: u32) -> Result<bool, Fault> {
        self.corners.clear();
        self.walk_loop(mesh, face, usize::MAX)?;
        Ok(self.seen.are_distinct(&self.corners))
    }

    fn two_spokes(&self, mesh: &Mesh, vertex: u32) -> Result<bool, Fault> {
        let start = self.halfedge(mesh, ElementField::Vertex, vertex)?;
        if start == u32::MAX {
            return Ok(true);
        }
        let before = self.record(mesh, start)?.prev.0;
        Ok(self.record(mesh, before)?.twin.0 != start)
    }

    fn corner_once(&mut self, mesh: &Mesh, face: u32, vertex: u32) -> Result<bool, Fault> {
        Ok(self.walk_star(mesh, vertex)?.faces.iter().filter(|&&other| other == face).count() <= 1)
    }

    fn faces_differ(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Fault> {
        self.walk_star(mesh, vertex)?;
        Ok(self.seen.are_distinct(&self.star.faces))
    }

    fn neighbors_differ(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Fault> {
        self.walk_star(mesh, vertex)?;
        let Self { star, seen, .. } = self;
        Ok(*star.targets_differ.get_or_insert_with(|| seen.are_distinct(&star.targets)))
    }

    fn one_hole(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Fault> {
        self.walk_star(mesh, vertex)?;
        let (is_plain, mut holes) = (self.is_plain(), 0);
        for &face in &self.star.faces {
            let is_hole = match is_plain {
                true => mesh.get_is_hole(FaceId(face)),
                false => Some(self.is_hole(mesh, face)?),
            };
            holes += u32::from(is_hole.ok_or_else(|| gone(ElementKind::Face, face))?);
        }
        Ok(holes <= 1)
    }

    fn single_edge(&mut self, mesh: &Mesh, halfedge: u32) -> Result<bool, Fault> {
        let ends = (self.record(mesh, halfedge)?.vertex.0, self.target(mesh, halfedge)?);
        let star = self.walk_star(mesh, ends.0)?;
        Ok(star.targets.iter().filter(|&&target| target == ends.1).count() <= 1)
    }

    /// Whether no two faces around a vertex have the same set of corners.
    fn corners_differ(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Fault> {
        // If all faces are triangles, and the neighbors of the vertex are at least three and
        // distinct, then each triangle has its own pair of consecutive neighbors.
        let star = self.walk_star(mesh, vertex)?;
        let are_triangles = star.has_triangles && star.faces.len() >= 3;
        if are_triangles && self.neighbors_differ(mesh, vertex)? {
            return Ok(true);
        }
        self.corners.clear();
        self.runs.clear();
        for at in 0..self.star.faces.len() {
            let face = self.star.faces[at];
            if self.is_hole(mesh, face)? {
                continue;
            }
            let start = self.corners.len();
            self.walk_loop(mesh, face, usize::MAX)?;
            let end = self.corners.len();
            self.corners[start..].sort_unstable();
            self.runs.push((start as u32, end as u32));
        }
        let corners = &self.corners;
        let run = |&(start, end): &(u32, u32)| &corners[start as usize..end as usize];
        self.runs.sort_unstable_by(|a, b| run(a).cmp(run(b)));
        Ok(self.runs.windows(2).all(|two| run(&two[0]) != run(&two[1])))
    }

    /// Whether no other face around a vertex of a face has the same set of corners.
    fn corners_own(&mut self, mesh: &Mesh, face: u32, vertex: u32) -> Result<bool, Fault> {
        if self.is_hole(mesh, face)? {
            return Ok(true);
        }
        self.walk_star(mesh, vertex)?;
        self.corners.clear();
        let size = self.walk_loop(mesh, face, usize::MAX)?;
        self.corners.sort_unstable();
        for at in 0..self.star.faces.len() {
            let other = self.star.faces[at];
            if other == face || self.is_hole(mesh, other)? {
                continue;
            }
            self.corners.truncate(size);
            if self.walk_loop(mesh, other, size + 1)? != size {
                continue;
            }
            self.corners[size..].sort_unstable();
            let (own, others) = self.corners.split_at(size);
            if own == others {
                return Ok(false);
            }
        }
        Ok(true)
    }
}
