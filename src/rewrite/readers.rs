//! Who has read what: for each place of the mesh the elements whose keys depend on it.
//!
//! A place is a vertex or a face with what is stored there but its `halfedge`; that; an edge with
//! its two halfedges; or all of the mesh. An operation often gives its neighbours another
//! `halfedge`, which few keys read: that is why it is a place of its own. When something is written at a place, its readers are taken off
//! and their keys computed anew, by which they are noted again wherever they still read. A
//! note may outlive its reason: then a key is computed once for nothing.

/// What a reader can depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Vertex(u32),
    VertexHalfedge(u32),
    Edge(u32),
    Face(u32),
    FaceHalfedge(u32),
    /// How many elements there are, and which.
    Whole,
}

impl Place {
    fn split(self) -> (usize, usize) {
        match self {
            Place::Vertex(id) => (0, id as usize),
            Place::VertexHalfedge(id) => (1, id as usize),
            Place::Edge(id) => (2, id as usize),
            Place::Face(id) => (3, id as usize),
            Place::FaceHalfedge(id) => (4, id as usize),
            Place::Whole => (5, 0),
        }
    }
}

const NOTHING: u32 = u32::MAX;

/// The readers of one place, as a list in the pool.
#[derive(Clone, Copy, Debug)]
struct List {
    first: u32,
    length: u32,
    /// At this length a reader may stand in it several times: they are sorted out then.
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
pub(super) struct Readers {
    lists: [Vec<List>; 6],
    pool: Vec<Entry>,
    /// The first of the pool's free entries.
    free: u32,
    /// By reader the last list it was seen in while that was sorted out.
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
    /// Notes that a reader depends on a place.
    pub(super) fn note(&mut self, place: Place, reader: u32) {
        let (kind, at) = place.split();
        let lists = &mut self.lists[kind];
        if lists.len() <= at {
            lists.resize(at + 1, EMPTY);
        }
        let list = &mut lists[at];
        // What a key reads several times, it mostly reads at once.
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
            self.sort_out(kind, at);
        }
    }

    /// Leaves each reader once in a list.
    fn sort_out(&mut self, kind: usize, at: usize) {
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
                // The first entry is always new, so there is one before.
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

    /// Takes all readers off a place.
    pub(super) fn take(&mut self, place: Place, mut each: impl FnMut(u32)) {
        let (kind, at) = place.split();
        let Some(list) = self.lists[kind].get_mut(at) else {
            return;
        };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_are_found_once_each_and_their_entries_used_again() {
        let mut readers = Readers::default();
        for round in 0..500 {
            for reader in 0..20 {
                readers.note(Place::Edge(3), (reader * 7 + round) % 20);
                readers.note(Place::Whole, reader);
            }
        }
        assert!(readers.pool.len() < 200, "{}", readers.pool.len());
        for place in [Place::Edge(3), Place::Whole] {
            let mut found = Vec::new();
            readers.take(place, |reader| found.push(reader));
            found.sort_unstable();
            found.dedup();
            assert_eq!(found, (0..20).collect::<Vec<_>>());
            readers.take(place, |_| panic!("they are taken off"));
        }
        let before = readers.pool.len();
        for reader in 0..40 {
            readers.note(Place::Vertex(reader), reader);
        }
        assert_eq!(readers.pool.len(), before);
        readers.take(Place::Face(9), |_| panic!("nobody has read it"));
    }
}
