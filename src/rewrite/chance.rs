//! Numbers by chance, the same for the same seed on every machine.
//!
//! The generator is xoshiro256**, after D. Blackman and S. Vigna, "Scrambled linear pseudorandom
//! number generators", 2021. Its state is filled by SplitMix64, after G. Steele, D. Lea and
//! C. Flood, "Fast splittable pseudorandom number generators", 2014, as its authors advise.

/// A stream of numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Chance([u64; 4]);

impl Chance {
    pub(super) fn new(seed: u64) -> Self {
        let mut state = seed;
        Self(std::array::from_fn(|_| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            mixed ^ (mixed >> 31)
        }))
    }

    fn next(&mut self) -> u64 {
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

    /// A real from 0 up to 1, without 1: a multiple of 2^-53.
    pub(super) fn real(&mut self) -> f64 {
        (self.next() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A number below `bound`, which is not 0, each as likely: D. Lemire, "Fast random integer
    /// generation in an interval", 2019.
    pub(super) fn below(&mut self, bound: u64) -> u64 {
        let reject = bound.wrapping_neg() % bound;
        loop {
            let product = u128::from(self.next()) * u128::from(bound);
            if product as u64 >= reject {
                return (product >> 64) as u64;
            }
        }
    }

    /// Puts things into an order, each as likely: R. Fisher and F. Yates, "Statistical tables",
    /// 1938; in place after R. Durstenfeld, "Algorithm 235", 1964.
    pub(super) fn shuffle<T>(&mut self, things: &mut [T]) {
        for last in (1..things.len()).rev() {
            things.swap(last, self.below(last as u64 + 1) as usize);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_numbers_are_those_of_the_published_generators() {
        // SplitMix64 from 1234567, as its reference implementation gives them.
        let filled = Chance::new(1_234_567).0;
        assert_eq!(filled[0], 6_457_827_717_110_365_317);
        assert_eq!(filled[1], 3_203_168_211_198_807_973);
        // xoshiro256** from the state 1, 2, 3, 4.
        let mut chance = Chance([1, 2, 3, 4]);
        assert_eq!([chance.next(), chance.next(), chance.next()], [11520, 0, 1_509_978_240]);
    }

    #[test]
    fn all_numbers_below_a_bound_are_as_likely() {
        let mut chance = Chance::new(0);
        let mut times = [0; 6];
        (0..6000).for_each(|_| times[chance.below(6) as usize] += 1);
        assert!(times.iter().all(|&n| (900..1100).contains(&n)), "{times:?}");
        let mean = (0..6000).map(|_| chance.real()).sum::<f64>() / 6000.0;
        assert!((mean - 0.5).abs() < 0.02, "{mean}");
    }

    #[test]
    fn all_orders_are_as_likely() {
        let mut chance = Chance::new(7);
        let mut times = std::collections::BTreeMap::new();
        for _ in 0..2400 {
            let mut things = [0, 1, 2, 3];
            chance.shuffle(&mut things);
            *times.entry(things).or_insert(0) += 1;
        }
        assert_eq!(times.len(), 24);
        assert!(times.values().all(|n| (60..140).contains(n)), "{times:?}");
    }
}
