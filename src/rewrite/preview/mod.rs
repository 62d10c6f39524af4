//! A preview of the mesh as an operation would leave it, before it is applied.
//!
//! A guard asks about the result. So the pointers that the operation would set, as far as the guard
//! asks about them, are set on the mesh itself, without notifying journals or drains; the guard
//! asks the mesh, and the old values are restored. A question about one face or vertex of the
//! result costs as much as a walk around it.
//!
//! New elements have no ids yet. They get numbers from the top of the range, which no element of
//! the mesh has as long as there is room for the new ones, and records of their own.

mod questions;

use std::cell::{Cell, RefCell};

pub use questions::Fan;

use super::access::{self, gone};
use super::distinct::Seen;
use super::{ElementField, Fault, HalfedgeField};
use crate::mesh::{ElementKind, FaceId, HalfedgeId, HalfedgeRecord, Mesh};

/// The number of the first new element; the next one has the number below. The two numbers above
/// stand for no element and for an erased one.
const FIRST_NEW: u32 = u32::MAX - 2;

/// The values that have been set, and buffers for questions about them.
#[derive(Debug, Default)]
pub struct Preview {
    /// The old values of everything that has been set on the mesh, in order.
    before: Vec<Before>,
    new: Vec<New>,
    /// Whether reads of the mesh are recorded, and these reads.
    listens: Cell<bool>,
    looked: RefCell<Vec<Looked>>,
    /// The vertex whose star was walked last, if nothing has been set since.
    star_of: Option<u32>,
    star: Star,
    seen: Seen,
    corners: Vec<u32>,
    runs: Vec<(u32, u32)>,
}

/// The spokes of a vertex: the halfedges that start there, counterclockwise.
#[derive(Debug, Default)]
struct Star {
    /// The faces in which they lie.
    faces: Vec<u32>,
    /// By spoke, the vertex where the next spoke ends.
    targets: Vec<u32>,
    /// Whether all ends differ, if this has been computed.
    targets_differ: Option<bool>,
    /// Whether no spoke ends where it starts, and all lie in triangles. This reads `next`, which
    /// has its new value only where a test walks around loops.
    has_triangles: bool,
}

/// An old value in the mesh.
#[derive(Clone, Copy, Debug)]
enum Before {
    Pointer(HalfedgeField, u32, u32),
    HalfedgeOf(ElementField, u32, u32),
    Hole(u32, bool),
}

/// A new element: the record of a halfedge, or the fields of another element.
#[derive(Debug)]
struct New {
    record: HalfedgeRecord,
    halfedge: u32,
    hole: bool,
}

/// A read of the mesh that a question has made.
#[derive(Clone, Copy, Debug)]
pub enum Looked {
    Halfedge(u32),
    HalfedgeOf(ElementField, u32),
    Hole(u32),
}

/// Whether a halfedge, before which lies `before`, is in a triangle.
#[inline]
fn is_in_triangle(halfedge: &HalfedgeRecord, before: &HalfedgeRecord) -> bool {
    halfedge.next == before.prev
}

/// Setting values.
impl Preview {
    /// Begins a preview in which nothing is set.
    pub fn clear(&mut self) {
        self.star_of = None;
        self.before.clear();
        self.new.clear();
        self.looked.get_mut().clear();
        self.listens.set(false);
    }

    /// Restores everything on the mesh.
    pub fn undo(&mut self, mesh: &mut Mesh) {
        self.star_of = None;
        for before in self.before.drain(..).rev() {
            // The element existed when its value was set, so this succeeds.
            match before {
                Before::Pointer(field, id, value) => {
                    mesh.exchange_pointer(HalfedgeId(id), field as usize, value);
                }
                Before::HalfedgeOf(of, id, value) => {
                    mesh.exchange_halfedge(of.kind(), id, HalfedgeId(value));
                }
                Before::Hole(face, hole) => {
                    mesh.exchange_hole(FaceId(face), hole);
                }
            }
        }
        self.new.clear();
    }

    /// Adds a new element, and returns its number.
    pub fn add(&mut self) -> u32 {
        self.new.push(New { record: HalfedgeRecord::UNSET, halfedge: u32::MAX, hole: false });
        FIRST_NEW - (self.new.len() as u32 - 1)
    }

    /// The index of a new element.
    #[inline]
    fn place(&self, id: u32) -> Option<usize> {
        let place = FIRST_NEW.wrapping_sub(id) as usize;
        (place < self.new.len()).then_some(place)
    }

    /// Sets a pointer of a halfedge.
    #[inline]
    pub fn store(
        &mut self,
        mesh: &mut Mesh,
        field: HalfedgeField,
        id: u32,
        value: u32,
    ) -> Result<(), Fault> {
        self.star_of = None;
        if let Some(new) = self.place(id) {
            *self.new[new].record.pointer_mut(field as usize) = value;
            return Ok(());
        }
        let before = mesh.exchange_pointer(HalfedgeId(id), field as usize, value);
        let before = before.ok_or_else(|| gone(ElementKind::Halfedge, id))?;
        self.before.push(Before::Pointer(field, id, before));
        Ok(())
    }

    /// Sets a pointer of every halfedge in a buffer.
    pub fn store_all(
        &mut self,
        mesh: &mut Mesh,
        field: HalfedgeField,
        halfedges: &[u64],
        value: u32,
    ) -> Result<(), Fault> {
        halfedges.iter().try_for_each(|&id| self.store(mesh, field, id as u32, value))
    }

    /// Sets the halfedge of an element.
    #[inline]
    pub fn store_halfedge(
        &mut self,
        mesh: &mut Mesh,
        of: ElementField,
        id: u32,
        value: u32,
    ) -> Result<(), Fault> {
        self.star_of = None;
        if let Some(new) = self.place(id) {
            self.new[new].halfedge = value;
            return Ok(());
        }
        let before = mesh.exchange_halfedge(of.kind(), id, HalfedgeId(value));
        let before = before.ok_or_else(|| gone(of.kind(), id))?;
        self.before.push(Before::HalfedgeOf(of, id, before.0));
        Ok(())
    }

    /// Makes a face a hole, or a hole a face.
    pub fn store_hole(&mut self, mesh: &mut Mesh, face: u32, hole: bool) -> Result<(), Fault> {
        if let Some(new) = self.place(face) {
            self.new[new].hole = hole;
            return Ok(());
        }
        let before = mesh.exchange_hole(FaceId(face), hole);
        let before = before.ok_or_else(|| gone(ElementKind::Face, face))?;
        self.before.push(Before::Hole(face, before));
        Ok(())
    }
}

/// Reading the previewed mesh.
impl Preview {
    /// Starts or stops recording the reads of the mesh.
    pub fn listen(&mut self, listens: bool) {
        self.listens.set(listens);
    }

    /// Takes the reads of the mesh that have been recorded.
    pub fn looked(&mut self) -> Vec<Looked> {
        std::mem::take(self.looked.get_mut())
    }

    #[inline]
    fn look(&self, at: Looked) {
        if self.listens.get() {
            self.looked.borrow_mut().push(at);
        }
    }

    #[inline]
    pub fn record<'a>(&'a self, mesh: &'a Mesh, id: u32) -> Result<&'a HalfedgeRecord, Fault> {
        if let Some(new) = self.place(id) {
            return Ok(&self.new[new].record);
        }
        self.look(Looked::Halfedge(id));
        mesh.get_halfedge(HalfedgeId(id)).ok_or_else(|| gone(ElementKind::Halfedge, id))
    }

    fn halfedge(&self, mesh: &Mesh, of: ElementField, id: u32) -> Result<u32, Fault> {
        if let Some(new) = self.place(id) {
            return Ok(self.new[new].halfedge);
        }
        self.look(Looked::HalfedgeOf(of, id));
        access::load_halfedge(mesh, of, id)
    }

    #[inline]
    fn is_hole(&self, mesh: &Mesh, face: u32) -> Result<bool, Fault> {
        if let Some(new) = self.place(face) {
            return Ok(self.new[new].hole);
        }
        self.look(Looked::Hole(face));
        mesh.get_is_hole(FaceId(face)).ok_or_else(|| gone(ElementKind::Face, face))
    }

    /// Whether there is no new element, and reads are not recorded.
    fn is_plain(&self) -> bool {
        self.new.is_empty() && !self.listens.get()
    }

    /// The greatest length of a walk that ends.
    fn longest(&self, mesh: &Mesh) -> usize {
        mesh.capacity(ElementKind::Halfedge) + self.new.len()
    }

    /// Walks the star of a vertex.
    fn walk_star(&mut self, mesh: &Mesh, vertex: u32) -> Result<&Star, Fault> {
        if self.star_of != Some(vertex) {
            let mut star = std::mem::take(&mut self.star);
            let walked = match self.is_plain() {
                true => self.walk_spokes(mesh, vertex, &mut star, |id| {
                    mesh.get_halfedge(HalfedgeId(id)).ok_or_else(|| gone(ElementKind::Halfedge, id))
                }),
                false => self.walk_spokes(mesh, vertex, &mut star, |id| self.record(mesh, id)),
            };
            self.star = star;
            walked?;
            self.star_of = Some(vertex);
        }
        Ok(&self.star)
    }

    /// Fills `star` with the spokes of a vertex; `record` reads a halfedge.
    #[inline]
    fn walk_spokes<'a>(
        &'a self,
        mesh: &'a Mesh,
        vertex: u32,
        star: &mut Star,
        record: impl Fn(u32) -> Result<&'a HalfedgeRecord, Fault>,
    ) -> Result<(), Fault> {
        star.faces.clear();
        star.targets.clear();
        star.targets_differ = None;
        star.has_triangles = true;
        let start = self.halfedge(mesh, ElementField::Vertex, vertex)?;
        if start == u32::MAX {
            return Ok(());
        }
        let mut at = start;
        for _ in 0..self.longest(mesh) {
            let spoke = record(at)?;
            let before = record(spoke.prev.0)?;
            star.faces.push(spoke.face.0);
            star.targets.push(before.vertex.0);
            star.has_triangles &= is_in_triangle(spoke, before) && before.vertex.0 != vertex;
            at = before.twin.0;
            if at == start {
                return Ok(());
            }
        }
        Err(Fault::Endless)
    }

    /// Appends the origins of the halfedges of a face to `corners`, at most `most`; returns their
    /// number.
    fn walk_loop(&mut self, mesh: &Mesh, face: u32, most: usize) -> Result<usize, Fault> {
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
        if most < self.longest(mesh) { Ok(most) } else { Err(Fault::Endless) }
    }

    fn target(&self, mesh: &Mesh, halfedge: u32) -> Result<u32, Fault> {
        let twin = self.record(mesh, halfedge)?.twin.0;
        Ok(self.record(mesh, twin)?.vertex.0)
    }
}
