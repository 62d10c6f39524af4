//! Operations that are asked at all elements again and again, between which the mesh is written.
//!
//! The places that an operation reads to answer are noted, by the same means as what the key of a
//! `drain` reads. What is written afterwards makes stale who has read it, and only the stale ones
//! are asked again. Nothing depends on how they are found, but the time.

use super::drain::Drains;
use super::readers::Place;
use super::{Call, Elements, Machine, Outcome, Plan, Trap, Watch};
use crate::mesh::{ElementKind, Mesh, Written};

/// The elements at which an operation is asked, and what each answer depends on.
#[derive(Debug)]
pub struct Asked {
    drains: Drains,
    kind: ElementKind,
    /// The number of slots that have been asked, or are stale.
    slots: usize,
}

impl Asked {
    /// Elements of a kind, none of which has been asked.
    pub fn new(kind: ElementKind) -> Self {
        let of = match kind {
            ElementKind::Vertex => Elements::Vertices,
            ElementKind::Halfedge => Elements::Halfedges,
            ElementKind::Edge => Elements::Edges,
            ElementKind::Face => Elements::Faces,
        };
        Self { drains: Drains::alone(of), kind, slots: 0 }
    }

    /// Forgets all answers.
    pub fn forget(&mut self) {
        *self = Self::new(self.kind);
    }

    /// Something has been written; or it is about to be what it was before.
    pub fn note(&mut self, written: Written) {
        let drains = &mut self.drains;
        match written {
            Written::Pointers(halfedge) => drains.touch(Place::Halfedge(halfedge.0)),
            Written::Halfedge(kind, id) => drains.touch(match kind {
                ElementKind::Vertex => Place::VertexHalfedge(id),
                ElementKind::Edge | ElementKind::Halfedge => Place::Edge(id),
                ElementKind::Face => Place::FaceHalfedge(id),
            }),
            Written::Value(kind, id) => drains.touch(place(kind, id)),
            Written::Attribute(kind, id) => drains.touch(match kind {
                ElementKind::Vertex => Place::VertexAttributes(id),
                ElementKind::Halfedge => Place::Halfedge(id),
                ElementKind::Edge => Place::EdgeAttributes(id),
                ElementKind::Face => Place::FaceAttributes(id),
            }),
            Written::Life(kind, id) => {
                drains.touch(place(kind, id));
                if kind == self.kind && (id as usize) < self.slots {
                    drains.make_stale(id);
                }
            }
            Written::Grown(_) => drains.touch(Place::Whole),
            Written::Column => self.forget(),
        }
    }

    /// The next slot of which the answer is not known. Who does not get one asks again.
    pub fn next_stale(&mut self, mesh: &Mesh) -> Option<u32> {
        let capacity = mesh.capacity(self.kind);
        for slot in self.slots.min(capacity)..capacity {
            self.drains.make_stale(slot as u32);
        }
        self.slots = capacity;
        loop {
            let slot = self.drains.pop_stale()?;
            if (slot as usize) < capacity {
                return Some(slot);
            }
        }
    }

    /// The answer of a slot is not known.
    pub fn make_stale(&mut self, slot: u32) {
        self.drains.make_stale(slot);
    }
}

fn place(kind: ElementKind, id: u32) -> Place {
    match kind {
        ElementKind::Vertex => Place::Vertex(id),
        ElementKind::Halfedge => Place::Halfedge(id),
        ElementKind::Edge => Place::Edge(id),
        ElementKind::Face => Place::Face(id),
    }
}

impl Machine {
    /// As [`Machine::ask`], of the element in a slot of those that are asked: what the answer
    /// depends on is noted.
    pub fn ask_noting(
        &mut self,
        mesh: &mut Mesh,
        (plan, args): (&Plan, &[u64]),
        (asked, slot): (&mut Asked, u32),
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        self.start(mesh, args);
        asked.drains.read_for_element(Some(slot));
        std::mem::swap(&mut self.drains, &mut asked.drains);
        let plans = super::Plans::clone(&self.plans);
        let outcome = self.consider(mesh, plan, Call::of(plan, &plans), watch);
        std::mem::swap(&mut self.drains, &mut asked.drains);
        asked.drains.read_for_element(None);
        outcome
    }
}
