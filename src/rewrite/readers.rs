//! Readers: for each place of the mesh, the elements whose keys depend on it.
//!
//! A place is a vertex, an edge, a halfedge or a face with its fields; but the `halfedge` of a
//! vertex or a face is a place of its own, since operations often change that of their neighbors
//! and few keys read it, and so are the attributes of a vertex, an edge or a face, which many
//! operations write and few keys read. The whole mesh is a place too. When a place is written, its
//! readers are removed and their keys recomputed, which notes them again wherever they still read.
//! A note may outlive its reason: then a key is recomputed in vain.

use crate::mesh::ElementKind;

/// A place that a reader can depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Vertex(u32),
    VertexHalfedge(u32),
    VertexAttributes(u32),
    Halfedge(u32),
    Edge(u32),
    EdgeAttributes(u32),
    Face(u32),
    FaceHalfedge(u32),
    FaceAttributes(u32),
    /// The number of elements, and which ones exist.
    Whole,
}

impl Place {
    /// The place of an element.
    #[inline]
    pub(super) fn of(kind: ElementKind, id: u32) -> Self {
        match kind {
            ElementKind::Vertex => Place::Vertex(id),
            ElementKind::Halfedge => Place::Halfedge(id),
            ElementKind::Edge => Place::Edge(id),
            ElementKind::Face => Place::Face(id),
        }
    }

    /// The place of the `halfedge` of an element.
    #[inline]
    pub(super) fn first_of(kind: ElementKind, id: u32) -> Self {
        match kind {
            ElementKind::Vertex => Place::VertexHalfedge(id),
            ElementKind::Face => Place::FaceHalfedge(id),
            ElementKind::Halfedge | ElementKind::Edge => Place::of(kind, id),
        }
    }

    /// The place of the attributes of an element.
    #[inline]
    pub(super) fn attributes_of(kind: ElementKind, id: u32) -> Self {
        match kind {
            ElementKind::Vertex => Place::VertexAttributes(id),
            ElementKind::Halfedge => Place::Halfedge(id),
            ElementKind::Edge => Place::EdgeAttributes(id),
            ElementKind::Face => Place::FaceAttributes(id),
        }
    }

    fn split(self) -> (usize, usize) {
        match self {
            Place::Vertex(id) => (0, id as usize),
            Place::VertexHalfedge(id) => (1, id as usize),
            Place::VertexAttributes(id) => (2, id as usize),
            Place::Halfedge(id) => (3, id as usize),
            Place::Edge(id) => (4, id as usize),
            Place::EdgeAttributes(id) => (5, id as usize),
            Place::Face(id) => (6, id as usize),
            Place::FaceHalfedge(id) => (7, id as usize),
            Place::FaceAttributes(id) => (8, id as usize),
            Place::Whole => (9, 0),
        }
    }
}

const NOTHING: u32 = u32::MAX;

/// The readers of one place, as a list in the pool.
#[derive(Clone, Copy, Debug)]
struct List {
    first: u32,
    length: u32,
    /// At this length duplicates are removed.
    limit: u32,
}

const EMPTY: List = List { first: NOTHING, length: 0, limit: 32 };

#[derive(Clone, Copy, Debug)]
struct Entry {
    reader: u32,
    next: u32,
}

/// The readers of all places.
#[derive(Debug)]
pub struct Readers {
    lists: [Vec<List>; 10],
    pool: Vec<Entry>,
    /// The first of the pool's free entries.
    free: u32,
    /// By reader, the number of the deduplication that has seen it last.
    seen: Vec<u32>,
    sorted: u32,
}

impl Default for Readers {
    fn default() -> Self {
        Self {
            lists: Default::default(),
            pool: Vec::new(),
            free: NOTHING,
            seen: Vec::new(),
            sorted: 0,
        }
    }
}

impl Readers {
    /// The memory that the readers take, in bytes.
    pub fn bytes(&self) -> usize {
        self.lists.iter().map(|lists| lists.capacity() * size_of::<List>()).sum::<usize>()
            + self.pool.capacity() * size_of::<Entry>()
            + self.seen.capacity() * size_of::<u32>()
    }

    /// Notes that a reader depends on a place.
    pub fn note(&mut self, place: Place, reader: u32) {
        let (kind, at) = place.split();
        let lists = &mut self.lists[kind];
        if lists.len() <= at {
            lists.resize(at + 1, EMPTY);
        }
        let list = &mut lists[at];
        // A key that reads a place several times mostly does so in a row.
        if list.first != NOTHING && self.pool[list.first as usize].reader == reader {
            return;
        }
        let entry = Entry { reader, next: list.first };
        list.first = match self.free {
            NOTHING => {
                self.pool.push(entry);
                self.pool.len() as u32 - 1
            }
            free => {
                let slot = &mut self.pool[free as usize];
                self.free = slot.next;
                *slot = entry;
                free
            }
        };
        list.length += 1;
        if list.length >= list.limit {
            self.dedup(kind, at);
        }
    }

    /// Removes duplicate readers from a list.
    fn dedup(&mut self, kind: usize, at: usize) {
        self.sorted = self.sorted.wrapping_add(1);
        let list = &mut self.lists[kind][at];
        let (mut before, mut entry) = (NOTHING, list.first);
        while entry != NOTHING {
            let Entry { reader, next } = self.pool[entry as usize];
            let reader = reader as usize;
            if self.seen.len() <= reader {
                self.seen.resize(reader + 1, 0);
            }
            if std::mem::replace(&mut self.seen[reader], self.sorted) == self.sorted {
                // The first entry is always new, so there is an entry before this one.
                self.pool[before as usize].next = next;
                self.pool[entry as usize].next = self.free;
                self.free = entry;
                list.length -= 1;
            } else {
                before = entry;
            }
            entry = next;
        }
        list.limit = EMPTY.limit.max(2 * list.length);
    }

    /// Removes all readers of a place, and passes them to `each`.
    pub fn take(&mut self, place: Place, mut each: impl FnMut(u32)) {
        let (kind, at) = place.split();
        let Some(list) = self.lists[kind].get_mut(at) else { return };
        let mut entry = std::mem::replace(list, EMPTY).first;
        while entry != NOTHING {
            let Entry { reader, next } = self.pool[entry as usize];
            each(reader);
            self.pool[entry as usize].next = self.free;
            self.free = entry;
            entry = next;
        }
    }
}
