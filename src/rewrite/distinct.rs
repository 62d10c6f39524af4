//! Whether numbers are all different, in time that grows as they do.

/// Up to so many are told apart by comparing them.
const FEW: usize = 48;

/// The number of bits by which they are told apart at first.
const BITS: usize = 256;

/// Whether no two numbers are the same.
pub fn are_distinct(numbers: &[u32]) -> bool {
    // Where no two have the same bit, none are the same; that settles it for most stars.
    let mut seen = [0_u64; BITS / 64];
    let mut alike = false;
    for &number in numbers {
        let bit = number.wrapping_mul(0x9E37_79B9) as usize >> 24;
        alike |= seen[bit / 64] >> (bit % 64) & 1 == 1;
        seen[bit / 64] |= 1 << (bit % 64);
    }
    if !alike {
        return true;
    }
    if numbers.len() <= FEW {
        let behind = |at: usize| &numbers[at + 1..];
        return numbers.iter().enumerate().all(|(at, number)| !behind(at).contains(number));
    }
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).all(|two| two[0] != two[1])
}
