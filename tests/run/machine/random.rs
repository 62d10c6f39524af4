//! Random numbers.

use hedgerow::rewrite::random::RandomNumbers;

#[test]
fn the_numbers_are_those_of_the_published_generators() {
    // SplitMix64 from 1234567, as its reference implementation gives them.
    let filled = RandomNumbers::new(1_234_567).0;
    assert_eq!(filled[0], 6_457_827_717_110_365_317);
    assert_eq!(filled[1], 3_203_168_211_198_807_973);
    // xoshiro256** from the state 1, 2, 3, 4.
    let mut random = RandomNumbers([1, 2, 3, 4]);
    assert_eq!([random.bits(), random.bits(), random.bits()], [11520, 0, 1_509_978_240]);
}

#[test]
fn all_numbers_below_a_bound_are_as_likely() {
    let mut random = RandomNumbers::new(0);
    let mut times = [0; 6];
    (0..6000).for_each(|_| times[random.below(6) as usize] += 1);
    assert!(times.iter().all(|&n| (900..1100).contains(&n)), "{times:?}");
    let mean = (0..6000).map(|_| random.real()).sum::<f64>() / 6000.0;
    assert!((mean - 0.5).abs() < 0.02, "{mean}");
}

#[test]
fn all_orders_are_as_likely() {
    let mut random = RandomNumbers::new(7);
    let mut times = std::collections::BTreeMap::new();
    for _ in 0..2400 {
        let mut things = [0, 1, 2, 3];
        random.shuffle(&mut things);
        *times.entry(things).or_insert(0) += 1;
    }
    assert_eq!(times.len(), 24);
    assert!(times.values().all(|n| (60..140).contains(n)), "{times:?}");
}
