//! Reproducible pseudorandom numbers: xorshift, after G. Marsaglia, *Xorshift RNGs*, 2003.

/// A stream of numbers; the seed must not be 0.
pub struct Dice(pub u64);

impl Dice {
    /// A number below `bound`; 0 if `bound` is 0.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound.max(1) as u64) as usize
    }
}
