//! The readers of places, and whether numbers are distinct.

use hedgerow::rewrite::distinct::Seen;
use hedgerow::rewrite::readers::{Place, Readers};

#[test]
fn readers_are_found_once_each_and_their_entries_used_again() {
    let mut readers = Readers::default();
    for round in 0..500 {
        for reader in 0..20 {
            readers.note(Place::Edge(3), (reader * 7 + round) % 20);
            readers.note(Place::Whole, reader);
        }
    }
    // Two lists of twenty readers, and not one of twenty thousand.
    assert!(readers.bytes() < 8 << 10, "{}", readers.bytes());
    for place in [Place::Edge(3), Place::Whole] {
        let mut found = Vec::new();
        readers.take(place, |reader| found.push(reader));
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, (0..20).collect::<Vec<_>>());
        readers.take(place, |_| panic!("they are taken off"));
    }
    let before = readers.bytes();
    for reader in 0..40 {
        readers.note(Place::Vertex(reader), reader);
    }
    // Only the lists of the vertices are new.
    assert!(readers.bytes() <= before + (1 << 10), "{} after {before}", readers.bytes());
    readers.take(Place::Face(9), |_| panic!("nobody has read it"));
}

#[test]
fn twins_are_found_anywhere() {
    // One table for all, with what earlier rounds have left in it.
    let mut seen = Seen::default();
    for length in [0, 1, 2, 9, 47, 48, 49, 300] {
        let mut numbers: Vec<u32> = (0..length).map(|n| n * 77 + 5).collect();
        assert!(seen.are_distinct(&numbers), "{length}");
        for (from, to) in [(0, 1), (3, 8), (46, 2), (48, 0), (299, 298)] {
            if from < numbers.len() && to < numbers.len() {
                let kept = std::mem::replace(&mut numbers[to], from as u32 * 77 + 5);
                assert!(!seen.are_distinct(&numbers), "{length}: {from}, {to}");
                numbers[to] = kept;
            }
        }
    }
}
