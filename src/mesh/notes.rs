//! The notes of a journal.

use glam::DVec3;

use super::attribute::{Column, ColumnData, ColumnId, Value};
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::records::{FaceRecord, HalfedgeRecord};

/// The beginning of a journal among the notes.
#[derive(Debug)]
#[must_use = "a journal that is open ends by `roll_back` or `keep`"]
pub struct Bookmark(pub(super) usize);

/// Something that is not what it was when a journal was opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Written<'j> {
    /// The pointers of a halfedge, which were these.
    Pointers(HalfedgeId, &'j HalfedgeRecord),
    /// The `halfedge` of a vertex, an edge or a face.
    Halfedge(ElementKind, u32),
    /// A position, or whether a face is a hole.
    Value(ElementKind, u32),
    /// The value of an attribute, which was this.
    Attribute(ColumnId, u32, Value),
    /// The life of a slot: if it has a living element, or which.
    Life(ElementKind, u32),
    /// There are more slots of a kind.
    Grown(ElementKind),
    /// An attribute as a whole.
    Column,
}

/// A record as it was.
#[derive(Clone, Debug)]
pub(super) enum Note {
    Vertex(VertexId, HalfedgeId),
    Halfedge(HalfedgeId, HalfedgeRecord),
    Edge(EdgeId, HalfedgeId),
    Face(FaceId, FaceRecord),
    Position(VertexId, DVec3),
    Value(ColumnId, u32, Value),
    /// All values of a column.
    Values(ColumnId, Box<ColumnData>),
    /// The value of new elements in a column.
    Default(ColumnId, Value),
    /// A column has been added, behind all others of its kind.
    Added(ElementKind),
    /// A column has been taken away.
    Removed(ColumnId, Box<Column>),
    /// A slot has been added at the end of its table.
    Grown(ElementKind),
    /// A free slot has been taken; its record has been noted before.
    Taken(ElementKind, u32),
    /// An element has been erased; its record has been noted before.
    Erased(ElementKind),
}

/// The notes of all journals that are open.
#[derive(Clone, Debug, Default)]
pub(super) struct Journal {
    pub(super) notes: Vec<Note>,
    pub(super) open: usize,
}

impl Journal {
    /// The memory that the notes take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.notes.capacity() * size_of::<Note>()
    }

    #[inline]
    pub(super) fn is_open(&self) -> bool {
        self.open > 0
    }
}
