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
    pub fn are_distinct(&mut self, numbers: &[u32]) -> bool {
        let mut remainders = Remainders::default();
        numbers.iter().for_each(|&number| remainders.add(number));
        remainders.differ || self.are_all_new(numbers)
    }

    /// Whether no two numbers are equal, where some remainders are.
    pub(super) fn are_all_new(&mut self, numbers: &[u32]) -> bool {
        self.clear();
        numbers.iter().all(|&number| self.is_new(number))
    }
}

/// The remainders of numbers modulo [`Remainders::COUNT`]: if they differ, so do the numbers, which
/// are mostly close to each other.
#[derive(Debug)]
pub(super) struct Remainders {
    seen: [u64; Self::COUNT / 64],
    /// Whether no two remainders are equal.
    pub(super) differ: bool,
}

impl Remainders {
    const COUNT: usize = 256;

    #[inline]
    pub(super) fn add(&mut self, number: u32) {
        let (word, bit) = (&mut self.seen[number as usize % Self::COUNT / 64], 1 << (number % 64));
        self.differ &= *word & bit == 0;
        *word |= bit;
    }
}

impl Default for Remainders {
    fn default() -> Self {
        Self { seen: [0; Self::COUNT / 64], differ: true }
    }
}
