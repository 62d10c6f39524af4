//! Allocation and erasure of elements.
//!
//! An erased element leaves its slot *pending*: nothing reuses it until [`Mesh::recycle`]
//! says that no one still holds the id. After that the slot is free, and the next
//! element of its kind takes it, the last freed first.
//!
//! ```text
//! add ──> living ──erase──> pending ──recycle──> free ──add──> living
//! ```

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, ID_SPACE, VertexId};
use super::records::{FaceState, HalfedgeRecord};

impl Mesh {
    /// A new vertex: isolated, at the origin of space, columns at their defaults.
    pub fn add_vertex(&mut self) -> VertexId {
        let id = VertexId(self.take_slot(ElementKind::Vertex));
        put(&mut self.vertices, id.index(), HalfedgeId::NONE);
        put(&mut self.positions, id.index(), DVec3::ZERO);
        id
    }

    /// A new halfedge with every pointer `NONE`.
    pub fn add_halfedge(&mut self) -> HalfedgeId {
        let id = HalfedgeId(self.take_slot(ElementKind::Halfedge));
        put(&mut self.halfedges, id.index(), HalfedgeRecord::UNSET);
        id
    }

    /// A new edge without a halfedge.
    pub fn add_edge(&mut self) -> EdgeId {
        let id = EdgeId(self.take_slot(ElementKind::Edge));
        put(&mut self.edges, id.index(), HalfedgeId::NONE);
        id
    }

    /// A new face without a halfedge; it is not a hole.
    pub fn add_face(&mut self) -> FaceId {
        let id = FaceId(self.take_slot(ElementKind::Face));
        put(&mut self.faces, id.index(), HalfedgeId::NONE);
        put(&mut self.face_states, id.index(), FaceState::Face);
        id
    }

    /// Marks the vertex dead. Erasing it again has no effect.
    pub fn erase_vertex(&mut self, v: VertexId) {
        if self.retire(ElementKind::Vertex, v.0) {
            self.vertices[v.index()] = HalfedgeId::DEAD;
        }
    }

    /// Marks the halfedge dead; its other pointers can no longer be read.
    pub fn erase_halfedge(&mut self, h: HalfedgeId) {
        if self.retire(ElementKind::Halfedge, h.0) {
            self.halfedges[h.index()].next = HalfedgeId::DEAD;
        }
    }

    pub fn erase_edge(&mut self, e: EdgeId) {
        if self.retire(ElementKind::Edge, e.0) {
            self.edges[e.index()] = HalfedgeId::DEAD;
        }
    }

    pub fn erase_face(&mut self, f: FaceId) {
        if self.retire(ElementKind::Face, f.0) {
            self.set_face_state(f, FaceState::Dead);
            self.faces[f.index()] = HalfedgeId::DEAD;
        }
    }

    /// Notes that an element is erased, and leaves its slot pending; false if it is not alive.
    #[inline]
    fn retire(&mut self, kind: ElementKind, id: u32) -> bool {
        let lives = self.is_alive(kind, id);
        if lives {
            if self.journal.is_open() {
                self.note_erased(kind, id);
            }
            self.slots[kind as usize].pending.push(id);
        }
        lives
    }

    /// Frees the slots of everything erased so far. The caller must know that no one still holds an
    /// id of those. An open journal may, so while one is open, nothing is freed.
    pub fn recycle(&mut self) {
        if self.journal.may_roll_back() {
            return;
        }
        if self.journal.is_open() {
            ElementKind::ALL.into_iter().for_each(|kind| self.note_recycled(kind));
        }
        for slots in &mut self.slots {
            slots.free.append(&mut slots.pending);
        }
    }

    /// The elements that have been erased and not recycled, in the order of erasure.
    pub fn erased(&self, kind: ElementKind) -> &[u32] {
        &self.slots[kind as usize].pending
    }

    /// True if that many elements can still be added before ids run out.
    pub fn can_add(&self, vertices: usize, halfedges: usize, edges: usize, faces: usize) -> bool {
        ElementKind::ALL.into_iter().zip([vertices, halfedges, edges, faces]).all(
            |(kind, wanted)| {
                let free = self.slots[kind as usize].free.len();
                wanted <= free + (ID_SPACE - self.capacity(kind))
            },
        )
    }

    /// True if the given numbers of new elements, by kind, can be appended to the tables: no slot
    /// is free, and no journal or history notes writes.
    #[inline]
    pub(crate) fn can_append(&self, counts: [usize; 4]) -> bool {
        !self.journal.is_open()
            && ElementKind::ALL.into_iter().zip(counts).all(|(kind, count)| {
                count == 0
                    || self.slots[kind as usize].free.is_empty()
                        && count <= ID_SPACE - self.capacity(kind)
            })
    }

    /// Appends `count` new elements to a table, as that many calls of its `add_` function would,
    /// and returns the number of the first. Requires [`Mesh::can_append`].
    #[inline]
    pub(crate) fn append(&mut self, kind: ElementKind, count: usize) -> u32 {
        let first = self.capacity(kind);
        let end = first + count;
        match kind {
            ElementKind::Vertex => {
                self.vertices.resize(end, HalfedgeId::NONE);
                self.positions.resize(end, DVec3::ZERO);
            }
            ElementKind::Halfedge => self.halfedges.resize(end, HalfedgeRecord::UNSET),
            ElementKind::Edge => self.edges.resize(end, HalfedgeId::NONE),
            ElementKind::Face => {
                self.faces.resize(end, HalfedgeId::NONE);
                self.face_states.resize(end, FaceState::Face);
            }
        }
        self.columns[kind as usize].grow(end);
        first as u32
    }

    /// Removes `count` slots at the end of a table, none of which is a hole.
    pub(crate) fn shorten(&mut self, kind: ElementKind, count: usize) {
        let end = self.capacity(kind).saturating_sub(count);
        match kind {
            ElementKind::Vertex => {
                self.vertices.truncate(end);
                self.positions.truncate(end);
            }
            ElementKind::Halfedge => self.halfedges.truncate(end),
            ElementKind::Edge => self.edges.truncate(end),
            ElementKind::Face => {
                self.faces.truncate(end);
                self.face_states.truncate(end);
            }
        }
        self.columns[kind as usize].shrink(end);
    }

    /// A free slot, or the one after the last. The caller has checked `can_add` where the id space
    /// could run out.
    #[inline]
    fn take_slot(&mut self, kind: ElementKind) -> u32 {
        let new = self.capacity(kind);
        let slot = self.slots[kind as usize].free.pop();
        if self.journal.is_open() {
            match slot {
                Some(slot) => self.note_taken(kind, slot),
                None => self.note_grown(kind),
            }
        }
        let columns = &mut self.columns[kind as usize];
        match slot {
            Some(slot) => {
                columns.reset(slot as usize);
                slot
            }
            None => {
                assert!(new < ID_SPACE, "`can_add` was asked before adding a {kind}");
                columns.grow(new + 1);
                new as u32
            }
        }
    }
}

/// Writes a record to its slot, which is in the table or one past its end.
#[inline]
fn put<T>(table: &mut Vec<T>, index: usize, record: T) {
    match table.get_mut(index) {
        Some(slot) => *slot = record,
        None => table.push(record),
    }
}
