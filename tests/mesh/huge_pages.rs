//! The allocator of these tests: blocks around the sizes at which it changes what it does.

use proptest::prelude::*;

/// Sizes below a mapping of their own, of some huge pages, and around each bound between them.
fn size() -> impl Strategy<Value = usize> {
    let bounds = (1..9usize).prop_map(|half| half << 20);
    prop_oneof![0..1usize << 23, (bounds, 0..3usize).prop_map(|(bound, over)| bound + over - 1)]
}

/// What stands at a place of a block.
fn mark(block: usize, place: usize) -> u64 {
    (block as u64) << 32 | place as u64
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn blocks_keep_what_they_hold(steps in proptest::collection::vec((0..4usize, size()), 1..24)) {
        let mut blocks: [Vec<u64>; 4] = Default::default();
        for (block, size) in steps {
            let held = &mut blocks[block];
            let before = held.len();
            let after = size / 8;
            held.reserve_exact(after.saturating_sub(before));
            held.extend((before..after).map(|place| mark(block, place)));
            held.truncate(after);
            held.shrink_to_fit();
            for (block, held) in blocks.iter().enumerate() {
                prop_assert!(held.iter().enumerate().all(|(at, &seen)| seen == mark(block, at)));
            }
        }
    }

    #[test]
    fn new_blocks_are_zero_where_others_were(size in size()) {
        for _ in 0..2 {
            let mut block = vec![0u8; size];
            prop_assert!(block.iter().all(|&byte| byte == 0));
            block.fill(255);
        }
    }
}

#[test]
fn large_blocks_begin_at_huge_pages() {
    let mut block = vec![1u8; 3 << 20];
    let neighbors: Vec<Vec<u8>> = (0..8).map(|_| vec![2; 3 << 20]).collect();
    for size in [4, 9, 33, 2] {
        block.resize(size << 20, 1);
        block.shrink_to_fit();
        assert_eq!(block.as_ptr().addr() % (2 << 20), 0);
    }
    assert!(block.iter().all(|&byte| byte == 1));
    assert!(neighbors.iter().flatten().all(|&byte| byte == 2));
}

#[test]
fn what_cannot_be_had_is_an_error() {
    let mut block: Vec<u8> = vec![7; 2 << 20];
    assert!(block.try_reserve_exact(1 << 47).is_err());
    assert!(block.try_reserve_exact(isize::MAX as usize / 2).is_err());
    assert!(Vec::<u8>::new().try_reserve_exact(1 << 47).is_err());
    assert!(block.iter().all(|&byte| byte == 7));
}
