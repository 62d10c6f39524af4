//! The mesh as an operation would leave it, before anything is written.
//!
//! A guard asks about the result. So the pointers that the operation would set are noted
//! on a sheet that lies over the mesh: where the sheet says something it counts, where it
//! says nothing the mesh does. Whoever walks the preview sees the finished result, and a
//! question about one face or vertex of it costs what a walk around it costs.
//!
//! New elements have no ids yet. They get numbers from the top of the range, where no
//! element of the mesh is as long as there is room for them.

use std::cell::{Cell, RefCell};

use super::access::{self, gone};
use super::notes::Notes;
use super::{ElementField, Foreseen, HalfedgeField, Message};
use crate::mesh::{EdgeId, ElementKind, FaceId, HalfedgeId, HalfedgeRecord, Mesh, VertexId};

/// The number of the first new element; that of the next one is one less.
const FIRST_NEW: u32 = u32::MAX - 1;

/// The sheet, and what is needed to look at it.
#[derive(Debug, Default)]
pub(super) struct Preview {
    /// Which preview this is: notes of earlier ones do not count.
    stamp: u32,
    /// For each halfedge of the mesh the preview that noted it last, and its record there.
    noted: Vec<(u32, u32)>,
    records: Vec<HalfedgeRecord>,
    /// For each new element a record, which is used if it is a halfedge.
    new: Vec<HalfedgeRecord>,
    /// The halfedges of vertices, edges and faces.
    halfedges: Notes<(ElementField, u32), u32>,
    holes: Notes<u32, bool>,
    /// Whether what is read of the mesh is wanted, and that.
    listens: Cell<bool>,
    looked: RefCell<Vec<Looked>>,
    walked: Vec<u32>,
    seen: Vec<u32>,
    corners: Vec<u32>,
    runs: Vec<(u32, u32)>,
}

/// What a question has read of the mesh under the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) enum Looked {
    Halfedge(u32),
    HalfedgeOf(ElementField, u32),
    Hole(u32),
}

const NOTHING: HalfedgeRecord = HalfedgeRecord {
    next: HalfedgeId::NONE,
    prev: HalfedgeId::NONE,
    twin: HalfedgeId::NONE,
    vertex: VertexId::NONE,
    edge: EdgeId::NONE,
    face: FaceId::NONE,
};

/// What would be set.
impl Preview {
    /// An empty sheet over the mesh.
    pub fn clear(&mut self, mesh: &Mesh) {
        self.stamp = self.stamp.wrapping_add(1);
        let capacity = mesh.capacity(ElementKind::Halfedge);
        if self.stamp == 0 {
            self.stamp = 1;
            self.noted.clear();
        }
        // What is there stays: only what a mesh has grown by costs something.
        if self.noted.len() < capacity {
            self.noted.resize(capacity, (0, 0));
        }
        self.records.clear();
        self.new.clear();
        self.halfedges.clear();
        self.holes.clear();
    }

    /// A new element.
    pub fn add(&mut self) -> u32 {
        self.new.push(NOTHING);
        FIRST_NEW - (self.new.len() as u32 - 1)
    }

    /// Sets a pointer of a halfedge.
    pub fn store(
        &mut self,
        mesh: &Mesh,
        field: HalfedgeField,
        id: u32,
        value: u32,
    ) -> Result<(), Message> {
        let record = self.record_mut(mesh, id)?;
        match field {
            HalfedgeField::Next => record.next = HalfedgeId(value),
            HalfedgeField::Prev => record.prev = HalfedgeId(value),
            HalfedgeField::Twin => record.twin = HalfedgeId(value),
            HalfedgeField::Vertex => record.vertex = VertexId(value),
            HalfedgeField::Edge => record.edge = EdgeId(value),
            HalfedgeField::Face => record.face = FaceId(value),
        }
        Ok(())
    }

    /// Sets a pointer of every halfedge in a buffer.
    pub fn store_all(
        &mut self,
        mesh: &Mesh,
        field: HalfedgeField,
        halfedges: &[u64],
        value: u32,
    ) -> Result<(), Message> {
        halfedges.iter().try_for_each(|&id| self.store(mesh, field, id as u32, value))
    }

    /// Sets the halfedge of an element.
    pub fn store_halfedge(&mut self, of: ElementField, id: u32, value: u32) {
        self.halfedges.set((of, id), value);
    }

    /// Makes a face a hole, or a hole a face.
    pub fn store_hole(&mut self, face: u32, hole: bool) {
        self.holes.set(face, hole);
    }

    fn record_mut(&mut self, mesh: &Mesh, id: u32) -> Result<&mut HalfedgeRecord, Message> {
        let new = (FIRST_NEW.wrapping_sub(id)) as usize;
        if new < self.new.len() {
            return Ok(&mut self.new[new]);
        }
        let gone = || gone(ElementKind::Halfedge, id);
        let record = mesh.get_halfedge(HalfedgeId(id)).ok_or_else(gone)?;
        let noted = self.noted.get_mut(id as usize).ok_or_else(gone)?;
        if noted.0 != self.stamp {
            *noted = (self.stamp, self.records.len() as u32);
            self.records.push(record.clone());
        }
        self.records.get_mut(noted.1 as usize).ok_or_else(gone)
    }
}

/// What there would be.
impl Preview {
    /// From now on tells what is read of the mesh, or no longer.
    pub fn listen(&mut self, listens: bool) {
        self.listens.set(listens);
    }

    /// What has been read of the mesh since.
    pub fn looked(&mut self) -> Vec<Looked> {
        std::mem::take(self.looked.get_mut())
    }

    #[inline]
    fn look(&self, at: Looked) {
        if self.listens.get() {
            self.looked.borrow_mut().push(at);
        }
    }

    fn record<'a>(&'a self, mesh: &'a Mesh, id: u32) -> Result<&'a HalfedgeRecord, Message> {
        let new = (FIRST_NEW.wrapping_sub(id)) as usize;
        if let Some(record) = self.new.get(new) {
            return Ok(record);
        }
        let noted = self.noted.get(id as usize).copied().unwrap_or_default();
        let record = match noted.0 == self.stamp {
            true => self.records.get(noted.1 as usize),
            false => {
                self.look(Looked::Halfedge(id));
                mesh.get_halfedge(HalfedgeId(id))
            }
        };
        record.ok_or_else(|| gone(ElementKind::Halfedge, id))
    }

    fn halfedge(&self, mesh: &Mesh, of: ElementField, id: u32) -> Result<u32, Message> {
        match self.halfedges.get((of, id)) {
            Some(halfedge) => Ok(halfedge),
            None => {
                self.look(Looked::HalfedgeOf(of, id));
                access::load_halfedge(mesh, of, id)
            }
        }
    }

    fn is_hole(&self, mesh: &Mesh, face: u32) -> Result<bool, Message> {
        match self.holes.get(face) {
            Some(hole) => Ok(hole),
            None => {
                self.look(Looked::Hole(face));
                mesh.get_is_hole(FaceId(face)).ok_or_else(|| gone(ElementKind::Face, face))
            }
        }
    }

    /// No walk that ends is longer.
    fn longest(&self, mesh: &Mesh) -> usize {
        mesh.capacity(ElementKind::Halfedge) + self.new.len()
    }

    /// Notes the spokes of a vertex in `walked`.
    fn walk_star(&mut self, mesh: &Mesh, vertex: u32) -> Result<(), Message> {
        self.walked.clear();
        let start = self.halfedge(mesh, ElementField::Vertex, vertex)?;
        if start == u32::MAX {
            return Ok(());
        }
        let mut at = start;
        for _ in 0..self.longest(mesh) {
            self.walked.push(at);
            let prev = self.record(mesh, at)?.prev.0;
            at = self.record(mesh, prev)?.twin.0;
            if at == start {
                return Ok(());
            }
        }
        Err(Message::Endless)
    }

    /// Notes the origins of the halfedges of a face in `corners`, behind what is there; no
    /// more than `most`. The number of them.
    fn walk_loop(&mut self, mesh: &Mesh, face: u32, most: usize) -> Result<usize, Message> {
        let start = self.halfedge(mesh, ElementField::Face, face)?;
        let mut at = start;
        for walked in 0..self.longest(mesh).min(most) {
            let record = self.record(mesh, at)?;
            let (vertex, next) = (record.vertex.0, record.next.0);
            self.corners.push(vertex);
            at = next;
            if at == start {
                return Ok(walked + 1);
            }
        }
        match most < self.longest(mesh) {
            true => Ok(most),
            false => Err(Message::Endless),
        }
    }

    fn face(&self, mesh: &Mesh, halfedge: u32) -> Result<u32, Message> {
        Ok(self.record(mesh, halfedge)?.face.0)
    }

    fn target(&self, mesh: &Mesh, halfedge: u32) -> Result<u32, Message> {
        let twin = self.record(mesh, halfedge)?.twin.0;
        Ok(self.record(mesh, twin)?.vertex.0)
    }
}

/// Questions.
impl Preview {
    /// Whether a condition would hold for an element; `at` is a second one, where the
    /// condition speaks of two.
    pub fn foresees(
        &mut self,
        mesh: &Mesh,
        condition: Foreseen,
        element: u32,
        at: u32,
    ) -> Result<bool, Message> {
        match condition {
            Foreseen::ThreeSides => self.three_sides(mesh, element),
            Foreseen::MeetsOnce => self.meets_once(mesh, element),
            Foreseen::CornerOnce => self.corner_once(mesh, element, at),
            Foreseen::TwoSpokes => {
                self.walk_star(mesh, element)?;
                Ok(self.walked.len() != 1)
            }
            Foreseen::OneHole => self.one_hole(mesh, element),
            Foreseen::FacesDiffer => self.differ(mesh, element, Self::face),
            Foreseen::NeighborsDiffer => self.differ(mesh, element, Self::target),
            Foreseen::SingleEdge => self.single_edge(mesh, element),
            Foreseen::CornersDiffer => self.corners_differ(mesh, element),
            Foreseen::CornersOwn => self.corners_own(mesh, element, at),
        }
    }

    /// Whether it would hold for the origin of every halfedge in a buffer.
    pub fn foresees_along(
        &mut self,
        mesh: &Mesh,
        condition: Foreseen,
        halfedges: &[u64],
    ) -> Result<bool, Message> {
        for &halfedge in halfedges {
            let vertex = self.record(mesh, halfedge as u32)?.vertex.0;
            if !self.foresees(mesh, condition, vertex, vertex)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn three_sides(&mut self, mesh: &Mesh, face: u32) -> Result<bool, Message> {
        self.corners.clear();
        Ok(self.walk_loop(mesh, face, 3)? == 3)
    }

    fn meets_once(&mut self, mesh: &Mesh, face: u32) -> Result<bool, Message> {
        self.corners.clear();
        self.walk_loop(mesh, face, usize::MAX)?;
        Ok(are_distinct(&mut self.corners))
    }

    fn corner_once(&mut self, mesh: &Mesh, face: u32, vertex: u32) -> Result<bool, Message> {
        self.walk_star(mesh, vertex)?;
        let mut corners = 0;
        for &spoke in &self.walked {
            corners += usize::from(self.face(mesh, spoke)? == face);
        }
        Ok(corners <= 1)
    }

    fn one_hole(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Message> {
        self.walk_star(mesh, vertex)?;
        let mut holes = 0;
        for &spoke in &self.walked {
            holes += usize::from(self.is_hole(mesh, self.face(mesh, spoke)?)?);
        }
        Ok(holes <= 1)
    }

    /// Whether no two spokes have the same of something.
    fn differ(
        &mut self,
        mesh: &Mesh,
        vertex: u32,
        what: impl Fn(&Self, &Mesh, u32) -> Result<u32, Message>,
    ) -> Result<bool, Message> {
        self.walk_star(mesh, vertex)?;
        let mut seen = std::mem::take(&mut self.seen);
        seen.clear();
        for &spoke in &self.walked {
            seen.push(what(self, mesh, spoke)?);
        }
        let distinct = are_distinct(&mut seen);
        self.seen = seen;
        Ok(distinct)
    }

    fn single_edge(&mut self, mesh: &Mesh, halfedge: u32) -> Result<bool, Message> {
        let ends = (self.record(mesh, halfedge)?.vertex.0, self.target(mesh, halfedge)?);
        self.walk_star(mesh, ends.0)?;
        let mut edges = 0;
        for &spoke in &self.walked {
            edges += usize::from(self.target(mesh, spoke)? == ends.1);
        }
        Ok(edges <= 1)
    }

    /// Whether no two faces around a vertex have the same set of corners.
    fn corners_differ(&mut self, mesh: &Mesh, vertex: u32) -> Result<bool, Message> {
        self.walk_star(mesh, vertex)?;
        self.corners.clear();
        self.runs.clear();
        for at in 0..self.walked.len() {
            let face = self.face(mesh, self.walked[at])?;
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
    fn corners_own(&mut self, mesh: &Mesh, face: u32, vertex: u32) -> Result<bool, Message> {
        if self.is_hole(mesh, face)? {
            return Ok(true);
        }
        self.walk_star(mesh, vertex)?;
        self.corners.clear();
        let size = self.walk_loop(mesh, face, usize::MAX)?;
        self.corners.sort_unstable();
        for at in 0..self.walked.len() {
            let other = self.face(mesh, self.walked[at])?;
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

fn are_distinct(numbers: &mut [u32]) -> bool {
    numbers.sort_unstable();
    numbers.windows(2).all(|two| two[0] != two[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shape;

    #[test]
    fn an_empty_sheet_shows_the_mesh() {
        let mesh = shape::pillow(3);
        let mut preview = Preview::default();
        preview.clear(&mesh);
        let mut ask = |condition| preview.foresees(&mesh, condition, 0, 0).unwrap();
        assert!(ask(Foreseen::ThreeSides) && ask(Foreseen::MeetsOnce));
        assert!(ask(Foreseen::NeighborsDiffer) && ask(Foreseen::TwoSpokes));
        assert!(!ask(Foreseen::CornersDiffer) && !ask(Foreseen::CornersOwn));
    }

    #[test]
    fn notes_count_until_the_sheet_is_cleared() {
        let mesh = shape::tetrahedron();
        let mut preview = Preview::default();
        preview.clear(&mesh);
        let spoke = mesh.vertex_halfedge(VertexId(0));
        let twin = mesh.twin(spoke).0;
        let other = mesh.vertex(HalfedgeId(mesh.prev(spoke).0)).0;
        preview.store(&mesh, HalfedgeField::Vertex, twin, other).unwrap();
        let neighbors = |preview: &mut Preview| {
            preview.foresees(&mesh, Foreseen::NeighborsDiffer, 0, 0).unwrap()
        };
        assert!(!neighbors(&mut preview), "two spokes lead to {other}");
        preview.clear(&mesh);
        assert!(neighbors(&mut preview));
    }

    #[test]
    fn new_elements_have_numbers_that_the_mesh_does_not_use() {
        let mesh = shape::tetrahedron();
        let mut preview = Preview::default();
        preview.clear(&mesh);
        let (a, b) = (preview.add(), preview.add());
        assert!(a != b && mesh.get_halfedge(HalfedgeId(b)).is_none());
        preview.store(&mesh, HalfedgeField::Face, b, 3).unwrap();
        assert_eq!(preview.face(&mesh, b), Ok(3));
    }
}
