//! Places by number: a hash table that is emptied at no cost.
//!
//! Open addressing with linear probing (D. Knuth, The Art of Computer Programming, volume 3, 1973,
//! section 6.4). Most operations note a few dozen halfedges, so the table stays small, and near.

/// The number of slots at first; a power of two.
const FIRST: usize = 128;

#[derive(Clone, Copy, Debug, Default)]
struct Slot {
    /// In which round it was filled: before the table was emptied last, it counts as empty.
    round: u32,
    id: u32,
    place: u32,
}

/// The places of the numbers that were added since the last [`EpochMap::clear`].
#[derive(Debug)]
pub struct EpochMap {
    /// As many as a power of two.
    slots: Vec<Slot>,
    round: u32,
    count: usize,
}

impl Default for EpochMap {
    fn default() -> Self {
        Self { slots: vec![Slot::default(); FIRST], round: 1, count: 0 }
    }
}

impl EpochMap {
    /// Forgets all of them.
    pub fn clear(&mut self) {
        self.count = 0;
        self.round = self.round.wrapping_add(1);
        if self.round == 0 {
            *self = Self::default();
        }
    }

    /// The slot at which the search for a number begins.
    #[inline]
    fn start(&self, id: u32) -> usize {
        // Fibonacci hashing: neighbors lie apart.
        (id.wrapping_mul(0x9E37_79B9) >> 7) as usize
    }

    /// The place of a number.
    #[inline]
    pub fn get(&self, id: u32) -> Option<u32> {
        let mask = self.slots.len() - 1;
        let mut at = self.start(id) & mask;
        loop {
            let slot = self.slots[at];
            if slot.round != self.round {
                return None;
            }
            if slot.id == id {
                return Some(slot.place);
            }
            at = (at + 1) & mask;
        }
    }

    /// Adds a number that is not there.
    pub fn add(&mut self, id: u32, place: u32) {
        if 2 * self.count >= self.slots.len() {
            let larger = vec![Slot::default(); 2 * self.slots.len()];
            let round = self.round;
            for slot in std::mem::replace(&mut self.slots, larger) {
                if slot.round == round {
                    self.put(slot);
                }
            }
        }
        self.count += 1;
        self.put(Slot { round: self.round, id, place });
    }

    fn put(&mut self, slot: Slot) {
        let mask = self.slots.len() - 1;
        let mut at = self.start(slot.id) & mask;
        while self.slots[at].round == self.round {
            at = (at + 1) & mask;
        }
        self.slots[at] = slot;
    }
}
