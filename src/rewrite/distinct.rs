//! Tests of whether numbers are all distinct, in linear time.

/// The initial number of slots of the table.
const FEW: usize = 64;

/// A hash set of numbers that is cleared in constant time: slots of earlier rounds count as free.
#[derive(Debug, Default)]
pub struct Seen {
    round: u32,
    count: usize,
    /// A number and its round.
    slots: Vec<(u32, u32)>,
}

impl Seen {
    /// Begins a round: the set is empty.
    pub(super) fn clear(&mut self) {
        self.count = 0;
        self.round = self.round.wrapping_add(1);
        if self.round == 0 || self.slots.is_empty() {
            self.slots.clear();
            self.slots.resize(FEW, (0, 0));
            self.round = 1;
        }
    }

    /// Adds a number. True if it is new in this round.
    #[inline]
    pub(super) fn is_new(&mut self, number: u32) -> bool {
        if 2 * self.count >= self.slots.len() {
            self.grow();
        }
        let last = self.slots.len() - 1;
        let mut at = (number.wrapping_mul(0x9E37_79B9) >> 8) as usize & last;
        while self.slots[at].1 == self.round {
            if self.slots[at].0 == number {
                return false;
            }
            at = (at + 1) & last;
        }
        self.slots[at] = (number, self.round);
        self.count += 1;
        true
    }

    #[cold]
    fn grow(&mut self) {
        let twice = vec![(0, 0); (2 * self.slots.len()).max(FEW)];
        let before = std::mem::replace(&mut self.slots, twice);
        let round = std::mem::replace(&mut self.round, 1);
        self.count = 0;
        for (number, _) in before.into_iter().filter(|slot| slot.1 == round && round > 0) {
            self.is_new(number);
        }
    }

    /// Whether no two numbers are equal.
    #[inline]
    pub fn are_distinct(&mut self, numbers: &[u32]) -> bool {
        if numbers.len() <= FEW / 2 {
            return few_are_distinct(numbers);
        }
        self.clear();
        numbers.iter().all(|&number| self.is_new(number))
    }
}

/// Whether no two of a few numbers are equal: a number is compared with those before it only if its
/// hash may be among theirs.
#[inline]
fn few_are_distinct(numbers: &[u32]) -> bool {
    let mut hashes = [0_u64; 8];
    numbers.iter().enumerate().all(|(at, number)| {
        let hash = number.wrapping_mul(0x9E37_79B9) >> 23;
        let (word, bit) = (&mut hashes[hash as usize / 64], 1 << (hash % 64));
        let is_new = *word & bit == 0 || !numbers[..at].contains(number);
        *word |= bit;
        is_new
    })
}
