//! The journal of writes, to undo them.
//!
//! While a journal is open, each writer first notes the record that it writes to. Rolling back puts
//! the notes back, the last first, and costs what was written, however large the mesh is. Nothing
//! is noted while none is open.
//!
//! ```text
//! open_journal ──> write … ──> roll_back      as if nothing had been
//!                         └──> keep           as if there had been no journal
//! ```
//!
//! Journals nest: the last opened ends first. No slot is freed while one is open, so that an id
//! means one element throughout. A [history](super::history) makes the same notes, but slots are
//! freed as they are without it.

use std::mem::swap;

use super::attribute::{Column, ColumnId};
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::level_near::Footprint;
use super::notes::{Bookmark, Journal, Note, Written};
use super::records::{FaceState, Slots};

impl Mesh {
    /// Opens a journal: writes are noted until its bookmark is given back.
    pub fn open_journal(&mut self) -> Bookmark {
        self.journal.open += 1;
        Bookmark(self.journal.notes.len())
    }

    /// Gives the journals that are opened from now on a name, which copies of the mesh share.
    pub(crate) fn sign_journal(&mut self, name: u64) {
        self.journal.name = name;
    }

    /// Whether a journal is open, and has this name: not on a mesh that has taken the place of it.
    pub(crate) fn is_journal_of(&self, name: u64) -> bool {
        self.journal.may_roll_back() && self.journal.name == name
    }

    /// Whether writes are noted.
    #[inline]
    pub(crate) fn keeps_journal(&self) -> bool {
        self.journal.is_open()
    }

    /// Ends the journal and keeps what was written since.
    pub fn keep(&mut self, _mark: Bookmark) {
        self.journal.open = self.journal.open.saturating_sub(1);
        // A journal around this one may still be rolled back, and this one with it.
        if !self.journal.is_open() {
            self.journal.notes.clear();
        }
    }

    /// Ends the journal and restores the mesh, bit for bit, as it was when the journal was opened.
    pub fn roll_back(&mut self, mark: Bookmark) {
        let Bookmark(start) = mark;
        while self.journal.notes.len() > start {
            if let Some(mut note) = self.journal.notes.pop() {
                self.put_back(&mut note);
            }
        }
        self.journal.open = self.journal.open.saturating_sub(1);
    }

    /// Ends all journals and the recording of a history; what was written stays.
    pub(crate) fn keep_all(&mut self) {
        self.journal = Journal::default();
    }

    /// The changes in all open journals, as far as levels depend on them.
    pub fn written(&self) -> Footprint {
        self.written_since(&Bookmark(0))
    }

    /// The changes since the journal was opened, as far as levels depend on them.
    pub fn written_since(&self, mark: &Bookmark) -> Footprint {
        let mut changes = Footprint::default();
        for note in self.journal.notes.get(mark.0..).unwrap_or_default() {
            match note {
                Note::Halfedge(h, was) if *was != self.halfedges[h.index()] => {
                    changes.halfedges.push(*h);
                }
                Note::Face(f, _, was) if *was != self.face_states[f.index()] => {
                    changes.faces.push(*f);
                }
                _ => {}
            }
        }
        changes
    }

    /// Calls `tell` with what has been written since the journal was opened and has changed, with
    /// some of it several times.
    pub fn each_written(&self, mark: &Bookmark, mut tell: impl FnMut(Written)) {
        for note in self.journal.notes.get(mark.0..).unwrap_or_default() {
            match note {
                &Note::Vertex(v, was) => {
                    let now = self.vertices[v.index()];
                    self.tell_pointer((ElementKind::Vertex, v.0), [was, now], &mut tell);
                }
                &Note::Edge(e, was) => {
                    let now = self.edges[e.index()];
                    self.tell_pointer((ElementKind::Edge, e.0), [was, now], &mut tell);
                }
                &Note::Face(f, was, state) => {
                    let now = self.faces[f.index()];
                    self.tell_pointer((ElementKind::Face, f.0), [was, now], &mut tell);
                    let is_hole = |state: FaceState| state == FaceState::Hole;
                    if is_hole(state) != is_hole(self.face_states[f.index()]) {
                        tell(Written::Value(ElementKind::Face, f.0));
                    }
                }
                Note::Halfedge(h, was) => {
                    let now = &self.halfedges[h.index()];
                    if was != now {
                        tell(Written::Pointers(*h, was));
                    }
                    if was.lives() != now.lives() {
                        tell(Written::Life(ElementKind::Halfedge, h.0));
                    }
                }
                Note::Position(v, was) => {
                    if self.positions[v.index()] != *was {
                        tell(Written::Value(ElementKind::Vertex, v.0));
                    }
                }
                Note::Bool(..) | Note::Int(..) | Note::Real(..) | Note::Wide(..) => {
                    let Some((column, index, was)) = note.as_value() else { continue };
                    let now = self.value_at(column, index);
                    if !now.is_some_and(|now| now.is_identical(was)) {
                        tell(Written::Attribute(column, index, was));
                    }
                }
                Note::Values(..) | Note::Default(..) | Note::Added(_) | Note::Removed(..) => {
                    tell(Written::Column);
                }
                Note::Grown(kind) => tell(Written::Grown(*kind)),
                // Taken and erased slots have notes of their records as well; the others do not
                // occur while a journal is open.
                Note::Taken(..)
                | Note::Erased(..)
                | Note::Shrunk(_)
                | Note::Freed(..)
                | Note::Revived(..)
                | Note::Recycled(..)
                | Note::Held(..) => {}
            }
        }
    }

    fn tell_pointer(
        &self,
        (kind, id): (ElementKind, u32),
        [was, now]: [HalfedgeId; 2],
        tell: &mut impl FnMut(Written),
    ) {
        if was != now {
            tell(Written::Halfedge(kind, id));
            if (was == HalfedgeId::DEAD) != (now == HalfedgeId::DEAD) {
                tell(Written::Life(kind, id));
            }
        }
    }

    /// Puts a note back. The note then holds what it replaced, so putting it back again undoes
    /// that.
    pub(super) fn put_back(&mut self, note: &mut Note) {
        match note {
            Note::Vertex(v, record) => swap(&mut self.vertices[v.index()], record),
            Note::Halfedge(h, record) => swap(&mut self.halfedges[h.index()], record),
            Note::Edge(e, record) => swap(&mut self.edges[e.index()], record),
            Note::Face(f, record, state) => {
                swap(&mut self.faces[f.index()], record);
                let now = self.face_states[f.index()];
                self.set_face_state(*f, *state);
                *state = now;
            }
            Note::Position(v, position) => swap(&mut self.positions[v.index()], position),
            Note::Bool(..) | Note::Int(..) | Note::Real(..) | Note::Wide(..) => {
                if let Some((column, index, value)) = note.as_value()
                    && let Some(now) = self.value_at(column, index)
                {
                    self.put_value(column, index, value);
                    *note = Note::value(column, index, now);
                }
            }
            Note::Values(column, values) => self.swap_values(*column, values),
            Note::Default(column, value) => self.swap_default(*column, value),
            Note::Added(id) => {
                let id = *id;
                if let Some(column) = self.take_column(id) {
                    *note = Note::Removed(id, Box::new(column));
                }
            }
            &mut Note::Removed(id, _) => {
                if let Note::Removed(id, column) = std::mem::replace(note, Note::Added(id)) {
                    self.put_column(id, *column);
                }
            }
            &mut Note::Grown(kind) => {
                self.drop_last(kind);
                *note = Note::Shrunk(kind);
            }
            &mut Note::Shrunk(kind) => {
                self.append(kind, 1);
                *note = Note::Grown(kind);
            }
            &mut Note::Taken(kind, slot) => {
                self.slots[kind as usize].free.push(slot);
                *note = Note::Freed(kind, slot);
            }
            &mut Note::Freed(kind, slot) => {
                self.slots[kind as usize].free.pop();
                *note = Note::Taken(kind, slot);
            }
            &mut Note::Erased(kind, slot) => {
                self.slots[kind as usize].pending.pop();
                *note = Note::Revived(kind, slot);
            }
            &mut Note::Revived(kind, slot) => {
                self.slots[kind as usize].pending.push(slot);
                *note = Note::Erased(kind, slot);
            }
            &mut Note::Recycled(kind, count) => {
                let Slots { free, pending } = &mut self.slots[kind as usize];
                pending.extend(free.drain(free.len().saturating_sub(count as usize)..));
                *note = Note::Held(kind, count);
            }
            &mut Note::Held(kind, count) => {
                let Slots { free, pending } = &mut self.slots[kind as usize];
                free.append(pending);
                *note = Note::Recycled(kind, count);
            }
        }
    }

    /// Removes the slot at the end of a table.
    fn drop_last(&mut self, kind: ElementKind) {
        if kind == ElementKind::Face && self.face_states.last() == Some(&FaceState::Hole) {
            self.holes -= 1;
        }
        self.shorten(kind, 1);
    }
}

/// The notes that writers make before they write. Those that do not check it themselves may be
/// called only while a journal is open.
impl Mesh {
    /// Notes the record of an element before it is written by code other than the methods of the
    /// mesh. May be called at any time.
    #[inline]
    pub(crate) fn note_element(&mut self, kind: ElementKind, id: u32) {
        if self.journal.is_open() {
            match kind {
                ElementKind::Vertex => self.note_vertex(VertexId(id)),
                ElementKind::Halfedge => self.note_halfedge(HalfedgeId(id)),
                ElementKind::Edge => self.note_edge(EdgeId(id)),
                ElementKind::Face => self.note_face(FaceId(id)),
            }
        }
    }

    /// As `note_element`, for a position.
    #[cfg(feature = "native")]
    #[inline]
    pub(crate) fn note_place(&mut self, v: VertexId) {
        if self.journal.is_open() {
            self.note_position(v);
        }
    }

    #[cold]
    pub(super) fn note_vertex(&mut self, v: VertexId) {
        let record = self.vertices[v.index()];
        self.journal.notes.push(Note::Vertex(v, record));
    }

    #[cold]
    pub(super) fn note_halfedge(&mut self, h: HalfedgeId) {
        let record = self.halfedges[h.index()].clone();
        self.journal.notes.push(Note::Halfedge(h, record));
    }

    #[cold]
    pub(super) fn note_edge(&mut self, e: EdgeId) {
        let record = self.edges[e.index()];
        self.journal.notes.push(Note::Edge(e, record));
    }

    #[cold]
    pub(super) fn note_face(&mut self, f: FaceId) {
        let (record, state) = (self.faces[f.index()], self.face_states[f.index()]);
        self.journal.notes.push(Note::Face(f, record, state));
    }

    #[cold]
    pub(super) fn note_position(&mut self, v: VertexId) {
        let position = self.positions[v.index()];
        self.journal.notes.push(Note::Position(v, position));
    }

    /// Notes a value before it is written. May be called at any time.
    #[inline]
    pub fn note_value(&mut self, column: ColumnId, index: u32) {
        if self.journal.is_open()
            && let Some(value) = self.value_at(column, index)
        {
            self.journal.notes.push(Note::value(column, index, value));
        }
    }

    /// Notes all values of a column before any of them may be written.
    pub(super) fn note_values(&mut self, column: ColumnId) {
        if self.journal.is_open()
            && let Some(data) = self.column(column).map(Column::data)
        {
            let data = Box::new(data.clone());
            self.journal.notes.push(Note::Values(column, data));
        }
    }

    /// Notes the default of a column before it changes.
    pub(super) fn note_default(&mut self, column: ColumnId) {
        if self.journal.is_open()
            && let Some(default) = self.column(column).map(Column::default_value)
        {
            self.journal.notes.push(Note::Default(column, Box::new(default)));
        }
    }

    /// Notes that a column has been added.
    pub(super) fn note_added(&mut self, id: ColumnId) {
        if self.journal.is_open() {
            self.journal.notes.push(Note::Added(id));
        }
    }

    /// Notes that a column has been removed.
    pub(super) fn note_removed(&mut self, id: ColumnId, column: Column) {
        if self.journal.is_open() {
            self.journal.notes.push(Note::Removed(id, Box::new(column)));
        }
    }

    #[cold]
    pub(super) fn note_grown(&mut self, kind: ElementKind) {
        self.journal.notes.push(Note::Grown(kind));
    }

    /// Notes that a free slot is taken, and all that it holds, since all of that will be written.
    #[cold]
    pub(super) fn note_taken(&mut self, kind: ElementKind, slot: u32) {
        self.journal.notes.push(Note::Taken(kind, slot));
        self.note_element(kind, slot);
        if kind == ElementKind::Vertex {
            self.note_position(VertexId(slot));
        }
        let columns: Vec<ColumnId> = self.columns(kind).map(|(id, _)| id).collect();
        for column in columns {
            self.note_value(column, slot);
        }
    }

    /// Notes that an element is erased, and its record.
    #[cold]
    pub(super) fn note_erased(&mut self, kind: ElementKind, slot: u32) {
        self.journal.notes.push(Note::Erased(kind, slot));
        self.note_element(kind, slot);
    }

    /// Notes that all pending slots of a kind are freed.
    pub(super) fn note_recycled(&mut self, kind: ElementKind) {
        let count = self.slots[kind as usize].pending.len() as u32;
        if count > 0 {
            self.journal.notes.push(Note::Recycled(kind, count));
        }
    }
}
