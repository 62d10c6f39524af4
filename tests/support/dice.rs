//! Numbers that look random and are the same in every run: xorshift, after G. Marsaglia,
//! *Xorshift RNGs*, 2003.

/// A stream of them; it does not begin with 0.
pub struct Dice(pub u64);

impl Dice {
    /// A number below `bound`; 0 if there is none.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound.max(1) as u64) as usize
    }
}
