//! A priority queue of elements by their keys: a heap that knows the place of each element
//! (Williams, Algorithm 232: Heapsort, 1964), so that an element in the middle can be moved or
//! removed. Each element has eight children (Johnson, Priority queues with update and finding
//! minimum spanning trees, 1975), which fill one line of the processor's cache (LaMarca and Ladner,
//! The influence of caches on the performance of heaps, 1996): the heap stores the first 31 bits of
//! each key, which determine most whole numbers, and compares the full keys only where these bits
//! are equal.
//!
//! Of equal keys the lower element number comes first, so that the order does not depend on the
//! history of the queue.

use crate::mesh::prefetch;

/// The place of an element that is not in the queue.
const NOWHERE: u32 = u32::MAX;

/// The number of children of an element.
const CHILDREN: usize = 8;

/// The place of the first element: the last in a block of its own, so that siblings share a block.
const ROOT: usize = CHILDREN - 1;

/// A number with the order of the keys: the top 31 bits of the key, then a bit that tells whether
/// the rest of the key is not zero (set if so for positive keys, cleared if so for negative ones),
/// then the element.
#[derive(Clone, Copy, Debug)]
struct Entry(u64);

impl Entry {
    /// In the unused places of a block.
    const NONE: Self = Self(u64::MAX);
    const POSITIVE: u64 = 1 << 63;
    /// The sticky bit: a dropped bit is set.
    const STICKY: u64 = 1 << 32;

    fn new(id: u32, key: f64) -> Self {
        // This makes -0 and 0 equal.
        let bits = (key + 0.0).to_bits();
        let is_negative = key < 0.0;
        let ordered = if is_negative { !bits } else { bits | Self::POSITIVE };
        let begins = ordered & !(2 * Self::STICKY - 1);
        let ends = bits & (2 * Self::STICKY - 1) == 0;
        let sticky = if ends == is_negative { Self::STICKY } else { 0 };
        Self(begins | sticky | u64::from(id))
    }

    #[inline]
    fn id(self) -> u32 {
        self.0 as u32
    }

    /// Whether another key has the same top bits, and the rest of neither is zero: then the full
    /// keys have to be compared.
    #[inline]
    fn same_prefix(self, other: Self) -> bool {
        let sticky = (self.0 & Self::STICKY == 0) == (self.0 & Self::POSITIVE == 0);
        self.0 >> 32 == other.0 >> 32 && sticky
    }
}

/// The children of an element.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Siblings([Entry; CHILDREN]);

/// A queue of elements by number, and the keys of all elements, queued or not.
#[derive(Debug, Default)]
pub struct Queue {
    /// The block of the root, then the children of each element, by its place.
    heap: Vec<Siblings>,
    len: usize,
    /// By element, its place in the heap.
    places: Vec<u32>,
    /// By element; NaN if it has no key.
    keys: Vec<f64>,
}

impl Queue {
    /// The memory that it takes, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.heap.capacity() * size_of::<Siblings>()
            + self.places.capacity() * size_of::<u32>()
            + self.keys.capacity() * size_of::<f64>()
    }

    /// The element with the least key.
    pub fn least(&self) -> Option<u32> {
        (self.len > 0).then(|| self.entry(ROOT).id())
    }

    /// The children of the least element, one of which comes next, and most of which come soon.
    pub(super) fn below_least(&self) -> impl Iterator<Item = u32> {
        self.heap.get(1).into_iter().flat_map(|Siblings(all)| all.iter().map(|entry| entry.id()))
    }

    /// Sets a key. An element whose key changes is put into the queue, whether it was in it before
    /// or not; an infinite key keeps it out.
    pub fn set(&mut self, id: u32, key: f64) {
        let index = id as usize;
        if self.keys.len() <= index {
            self.keys.resize(index + 1, f64::NAN);
            self.places.resize(index + 1, NOWHERE);
        }
        if self.keys[index] == key {
            return;
        }
        self.keys[index] = key;
        if key == f64::INFINITY {
            return self.remove(id);
        }
        let mut at = self.places[index] as usize;
        if self.places[index] == NOWHERE {
            at = ROOT + self.len;
            self.len += 1;
            if at / CHILDREN == self.heap.len() {
                self.heap.push(Siblings([Entry::NONE; CHILDREN]));
            }
        }
        self.sift(at, Entry::new(id, key));
    }

    /// Removes an element, if it is queued. It comes back when its key changes.
    pub fn remove(&mut self, id: u32) {
        let Some(place) = self.places.get_mut(id as usize) else { return };
        let at = std::mem::replace(place, NOWHERE);
        if at == NOWHERE {
            return;
        }
        self.len -= 1;
        let end = ROOT + self.len;
        let last = self.entry(end);
        self.heap[end / CHILDREN].0[end % CHILDREN] = Entry::NONE;
        if at as usize != end {
            self.sift(at as usize, last);
        }
    }

    /// Removes an element and forgets its key, since it has been erased; another element may get
    /// its number later.
    pub(super) fn forget(&mut self, id: u32) {
        self.remove(id);
        if let Some(key) = self.keys.get_mut(id as usize) {
            *key = f64::NAN;
        }
    }

    /// Requests the memory of the entries of an element.
    #[inline]
    pub(super) fn prefetch(&self, id: u32) {
        prefetch(&self.keys, id as usize);
        prefetch(&self.places, id as usize);
    }

    /// Requests the memory near the place of an element in the heap.
    #[inline]
    pub(super) fn prefetch_around(&self, id: u32) {
        let Some(&place) = self.places.get(id as usize).filter(|&&place| place != NOWHERE) else {
            return;
        };
        let place = place as usize;
        prefetch(&self.heap, place / CHILDREN);
        prefetch(&self.heap, place - ROOT + 1);
    }

    /// Puts an entry at the place `from`, whose own entry is dropped, and moves it to its place in
    /// the order.
    fn sift(&mut self, from: usize, entry: Entry) {
        let mut at = from;
        while at > ROOT {
            let parent = at / CHILDREN + ROOT - 1;
            if !self.is_before(entry, self.entry(parent)) {
                break;
            }
            self.set_entry(at, self.entry(parent));
            at = parent;
        }
        // An entry that has moved up comes before everything below its old place.
        while at >= from {
            let block = at - ROOT + 1;
            let Some(Siblings(all)) = self.heap.get(block) else { break };
            let (mut child, mut least) = (0, all[0]);
            for (place, &other) in all.iter().enumerate().skip(1) {
                if self.is_before(other, least) {
                    (child, least) = (place, other);
                }
            }
            if !self.is_before(least, entry) {
                break;
            }
            self.set_entry(at, least);
            at = CHILDREN * block + child;
        }
        self.set_entry(at, entry);
    }

    #[inline]
    fn is_before(&self, one: Entry, other: Entry) -> bool {
        match one.same_prefix(other) {
            true => self.is_before_in_full(one.id(), other.id()),
            false => one.0 < other.0,
        }
    }

    #[cold]
    fn is_before_in_full(&self, one: u32, other: u32) -> bool {
        let [x, y] = [one, other].map(|id| self.keys.get(id as usize));
        x < y || (x == y && one < other)
    }

    #[inline]
    fn entry(&self, at: usize) -> Entry {
        self.heap[at / CHILDREN].0[at % CHILDREN]
    }

    #[inline]
    fn set_entry(&mut self, at: usize, entry: Entry) {
        self.heap[at / CHILDREN].0[at % CHILDREN] = entry;
        self.places[entry.id() as usize] = at as u32;
    }
}
