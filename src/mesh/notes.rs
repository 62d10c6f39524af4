//! The notes of a journal.

use std::collections::HashSet;

use glam::DVec3;

use super::attribute::{Column, ColumnData, ColumnId, Value};
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::records::{FaceState, HalfedgeRecord};

/// The beginning of a journal among the notes.
#[derive(Debug)]
#[must_use = "a journal that is open ends by `roll_back` or `keep`"]
pub struct Bookmark(pub(super) usize);

/// Something that has changed since a journal was opened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Written<'j> {
    /// The pointers of a halfedge; they were these.
    Pointers(HalfedgeId, &'j HalfedgeRecord),
    /// The `halfedge` of a vertex, an edge or a face.
    Halfedge(ElementKind, u32),
    /// A position, or whether a face is a hole.
    Value(ElementKind, u32),
    /// The value of an attribute; it was this.
    Attribute(ColumnId, u32, Value),
    /// Whether a slot has a living element.
    Life(ElementKind, u32),
    /// The number of slots of a kind.
    Grown(ElementKind),
    /// An attribute as a whole.
    Column,
}

/// The previous value of a record. Putting it back exchanges it with the current one.
#[derive(Clone, Debug)]
pub(super) enum Note {
    Vertex(VertexId, HalfedgeId),
    Halfedge(HalfedgeId, HalfedgeRecord),
    Edge(EdgeId, HalfedgeId),
    Face(FaceId, HalfedgeId, FaceState),
    Position(VertexId, DVec3),
    Bool(ColumnId, u32, bool),
    Int(ColumnId, u32, i64),
    Real(ColumnId, u32, f64),
    /// A wider value, boxed to keep notes small: they are many.
    Wide(ColumnId, u32, Box<Value>),
    /// All values of a column.
    Values(ColumnId, Box<ColumnData>),
    /// The default of a column.
    Default(ColumnId, Box<Value>),
    /// A column has been added.
    Added(ColumnId),
    /// A column has been removed.
    Removed(ColumnId, Box<Column>),
    /// A slot has been added at the end of its table, or removed there.
    Grown(ElementKind),
    Shrunk(ElementKind),
    /// A free slot has been taken, or freed; its record has a note of its own.
    Taken(ElementKind, u32),
    Freed(ElementKind, u32),
    /// An element has been erased, or brought back; its record has a note of its own.
    Erased(ElementKind, u32),
    Revived(ElementKind, u32),
    /// This number of pending slots has been freed, or made pending again.
    Recycled(ElementKind, u32),
    Held(ElementKind, u32),
}

impl Note {
    pub(super) fn value(column: ColumnId, index: u32, value: Value) -> Self {
        match value {
            Value::Bool(value) => Self::Bool(column, index, value),
            Value::Int(value) => Self::Int(column, index, value),
            Value::Real(value) => Self::Real(column, index, value),
            wide => Self::Wide(column, index, Box::new(wide)),
        }
    }

    /// The attribute, the index and the value, if the note is of the value of an attribute.
    pub(super) fn as_value(&self) -> Option<(ColumnId, u32, Value)> {
        Some(match self {
            &Self::Bool(column, index, value) => (column, index, Value::Bool(value)),
            &Self::Int(column, index, value) => (column, index, Value::Int(value)),
            &Self::Real(column, index, value) => (column, index, Value::Real(value)),
            Self::Wide(column, index, value) => (*column, *index, **value),
            _ => return None,
        })
    }

    /// True if column ids may refer to other columns afterwards.
    pub(super) fn is_of_columns(&self) -> bool {
        matches!(self, Self::Added(_) | Self::Removed(..))
    }

    /// The record that the note is of, if it is one that is written in place.
    pub(super) fn place(&self) -> Option<(u8, u32, Option<ColumnId>)> {
        Some(match self {
            Self::Vertex(v, _) => (0, v.0, None),
            Self::Halfedge(h, _) => (1, h.0, None),
            Self::Edge(e, _) => (2, e.0, None),
            Self::Face(f, ..) => (3, f.0, None),
            Self::Position(v, _) => (4, v.0, None),
            _ => {
                let (column, index, _) = self.as_value()?;
                (5, index, Some(column))
            }
        })
    }
}

/// The notes of all open journals.
#[derive(Clone, Debug, Default)]
pub(super) struct Journal {
    pub(super) notes: Vec<Note>,
    pub(super) open: usize,
    /// Given by who opened them.
    pub(super) name: u64,
    pub(super) recorder: Option<Box<Recorder>>,
}

/// The state of the recording of a history.
#[derive(Clone, Debug, Default)]
pub(super) struct Recorder {
    /// The end of the notes of each step.
    pub(super) ends: Vec<usize>,
    /// The number of steps before the oldest state.
    pub(super) first: u64,
    /// The limit of the notes, in bytes.
    pub(super) most: usize,
    /// The records that the step has written.
    pub(super) seen: HashSet<(u8, u32, Option<ColumnId>)>,
}

impl Journal {
    /// The memory that the notes take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.notes.capacity() * size_of::<Note>()
    }

    /// True if writes are noted.
    #[inline]
    pub(super) fn is_open(&self) -> bool {
        self.open > 0 || self.recorder.is_some()
    }

    /// True if writes may still be rolled back.
    #[inline]
    pub(super) fn may_roll_back(&self) -> bool {
        self.open > 0
    }
}
