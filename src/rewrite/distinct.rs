//! Whether numbers are all different, in time that grows as they do.

/// Up to so many are told apart by comparing them.
const FEW: usize = 48;

/// The number of bits by which they are told apart at first.
const BITS: usize = 256;

/// Numbers that have been seen, by one bit each: where no two have the same, none are the same. That
/// settles it for most stars.
#[derive(Default)]
pub(super) struct Seen {
    bits: [u64; BITS / 64],
    alike: bool,
}

impl Seen {
    #[inline]
    pub(super) fn see(&mut self, number: u32) {
        let bit = number.wrapping_mul(0x9E37_79B9) as usize >> 24;
        let (word, bit) = (&mut self.bits[bit / 64], 1 << (bit % 64));
        self.alike |= *word & bit != 0;
        *word |= bit;
    }

    /// Whether no two of the numbers, which have all been seen, are the same.
    #[inline]
    pub(super) fn differ<I>(&self, numbers: impl Fn() -> I) -> bool
    where
        I: Iterator<Item = u32> + Clone,
    {
        !self.alike || differ(numbers())
    }
}

/// The same for any numbers.
#[cold]
fn differ(numbers: impl Iterator<Item = u32> + Clone) -> bool {
    let mut left = numbers.clone();
    if numbers.clone().take(FEW + 1).count() <= FEW {
        while let Some(number) = left.next() {
            if left.clone().any(|other| other == number) {
                return false;
            }
        }
        return true;
    }
    let mut sorted: Vec<u32> = numbers.collect();
    sorted.sort_unstable();
    sorted.windows(2).all(|two| two[0] != two[1])
}

/// Whether no two numbers are the same.
pub fn are_distinct(numbers: &[u32]) -> bool {
    let mut seen = Seen::default();
    numbers.iter().for_each(|&number| seen.see(number));
    seen.differ(|| numbers.iter().copied())
}
