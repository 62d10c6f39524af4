//! Elements in the order of their keys: a heap that knows where each element stands (Williams,
//! Algorithm 232: Heapsort, 1964), so that one in the middle can move or leave. Each element has
//! four children (Johnson, Priority queues with update and finding minimum spanning trees, 1975),
//! which lie side by side with their keys: to compare them costs one look at the memory.
//!
//! Of equal keys the lower number comes first, so that the order does not depend on how the queue
//! came about.

/// The place of what is not queued.
const NOWHERE: u32 = u32::MAX;

/// The number of children of an element.
const CHILDREN: usize = 4;

#[derive(Clone, Copy, Debug)]
struct Entry {
    key: f64,
    id: u32,
}

impl Entry {
    #[inline]
    fn is_before(self, other: Self) -> bool {
        self.key < other.key || (self.key == other.key && self.id < other.id)
    }
}

/// A queue of elements by number.
#[derive(Debug, Default)]
pub struct Queue {
    heap: Vec<Entry>,
    /// By element its place in the heap.
    places: Vec<u32>,
}

impl Queue {
    /// The memory that it takes, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.heap.capacity() * size_of::<Entry>() + self.places.capacity() * size_of::<u32>()
    }

    /// The element with the least key.
    pub fn least(&self) -> Option<u32> {
        self.heap.first().map(|entry| entry.id)
    }

    /// Puts an element where its key belongs, whether it is queued already or not.
    pub fn put(&mut self, id: u32, key: f64) {
        let index = id as usize;
        if self.places.len() <= index {
            self.places.resize(index + 1, NOWHERE);
        }
        let entry = Entry { key, id };
        let mut at = self.places[index] as usize;
        if self.places[index] == NOWHERE {
            at = self.heap.len();
            self.heap.push(entry);
        }
        self.settle(at, entry);
    }

    /// Takes an element out, if it is queued.
    pub fn remove(&mut self, id: u32) {
        let Some(place) = self.places.get_mut(id as usize) else {
            return;
        };
        let at = std::mem::replace(place, NOWHERE) as usize;
        if at >= self.heap.len() {
            return;
        }
        self.heap.swap_remove(at);
        if let Some(&moved) = self.heap.get(at) {
            self.settle(at, moved);
        }
    }

    /// Brings an entry from a place, whose own is to be forgotten, to where it belongs.
    fn settle(&mut self, from: usize, entry: Entry) {
        let mut at = from;
        while at > 0 {
            let parent = (at - 1) / CHILDREN;
            if !entry.is_before(self.heap[parent]) {
                break;
            }
            self.set(at, self.heap[parent]);
            at = parent;
        }
        // What has risen is before all that was below.
        while at >= from {
            let first = CHILDREN * at + 1;
            let end = self.heap.len().min(first + CHILDREN);
            let Some((&least, others)) = self.heap.get(first..end).and_then(<[_]>::split_first)
            else {
                break;
            };
            let (mut child, mut least) = (first, least);
            for (place, &other) in (first + 1..).zip(others) {
                if other.is_before(least) {
                    (child, least) = (place, other);
                }
            }
            if !least.is_before(entry) {
                break;
            }
            self.set(at, least);
            at = child;
        }
        self.set(at, entry);
    }

    #[inline]
    fn set(&mut self, at: usize, entry: Entry) {
        self.heap[at] = entry;
        self.places[entry.id as usize] = at as u32;
    }
}
