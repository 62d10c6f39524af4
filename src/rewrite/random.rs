//! Random numbers, the same for the same seed on every machine.
//!
//! The generator is xoshiro256**, after D. Blackman and S. Vigna, "Scrambled linear pseudorandom
//! number generators", 2021. Its state is filled by SplitMix64, after G. Steele, D. Lea and
//! C. Flood, "Fast splittable pseudorandom number generators", 2014, as its authors advise.

/// A stream of random numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RandomNumbers(pub [u64; 4]);

impl RandomNumbers {
    pub fn new(seed: u64) -> Self {
        let mut state = seed;
        Self(std::array::from_fn(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            mixed ^ (mixed >> 31)
        }))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        let s = &mut self.0;
        let result = s[1].wrapping_mul(5).rotate_left(7).wrapping_mul(9);
        let shifted = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= shifted;
        s[3] = s[3].rotate_left(45);
        result
    }

    /// A real from 0 up to, but without, 1: a multiple of 2^-53.
    pub fn real(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A uniform number below `bound`, which is not 0: D. Lemire, "Fast random integer generation
    /// in an interval", 2019.
    pub fn below(&mut self, bound: u64) -> u64 {
        let reject = bound.wrapping_neg() % bound;
        loop {
            let product = u128::from(self.bits()) * u128::from(bound);
            if product as u64 >= reject {
                return (product >> 64) as u64;
            }
        }
    }

    /// Shuffles a slice, each order being equally likely: R. Fisher and F. Yates, "Statistical
    /// tables", 1938; in place after R. Durstenfeld, "Algorithm 235", 1964.
    pub fn shuffle<T>(&mut self, things: &mut [T]) {
        for last in (1..things.len()).rev() {
            things.swap(last, self.below(last as u64 + 1) as usize);
        }
    }
}
