//! SmallMap about elements, and the readers of places.

use hedgerow::rewrite::distinct::are_distinct;
use hedgerow::rewrite::epoch_map::EpochMap;
use hedgerow::rewrite::readers::{Place, Readers};
use hedgerow::rewrite::small_map::SmallMap;

#[test]
fn the_last_note_counts() {
    let mut notes = SmallMap::default();
    for round in 0..3 {
        for key in 0..20 {
            notes.set(key, 100 * round + key);
        }
    }
    assert_eq!(notes.get(3), Some(203));
    assert_eq!(notes.get(19), Some(219));
    assert_eq!(notes.get(20), None);
    notes.clear();
    assert_eq!(notes.get(3), None);
}

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
fn what_was_added_is_found_until_it_is_forgotten() {
    let mut noted = EpochMap::default();
    for round in 0..5 {
        let ids = || (0..1000_u32).map(|n| n.wrapping_mul(2_654_435_769) ^ round);
        for (place, id) in (0..).zip(ids()) {
            assert_eq!(noted.get(id), None);
            noted.add(id, place);
        }
        for (place, id) in (0..).zip(ids()) {
            assert_eq!(noted.get(id), Some(place));
        }
        noted.clear();
    }
    assert_eq!(noted.get(7), None);
}

#[test]
fn twins_are_found_anywhere() {
    for length in [0, 1, 2, 9, 47, 48, 49, 300] {
        let mut numbers: Vec<u32> = (0..length).map(|n| n * 77 + 5).collect();
        assert!(are_distinct(&numbers), "{length}");
        for (from, to) in [(0, 1), (3, 8), (46, 2), (48, 0), (299, 298)] {
            if from < numbers.len() && to < numbers.len() {
                let kept = std::mem::replace(&mut numbers[to], from as u32 * 77 + 5);
                assert!(!are_distinct(&numbers), "{length}: {from}, {to}");
                numbers[to] = kept;
            }
        }
    }
}
