//! Buffers with a slot for each index of a cycle.

use hedgerow::rewrite::Span;
use hedgerow::rewrite::families::{deal, part};

#[test]
fn what_came_first_stands_at_the_turn() {
    let dealt = |turn| {
        let mut to = Vec::new();
        deal(&[1, 10, 2, 20, 3, 30], [1, 2], turn, &mut to);
        to
    };
    assert_eq!(dealt(0), [10, 20, 30]);
    assert_eq!(dealt(1), [30, 10, 20]);
    assert_eq!(dealt(-1), [20, 30, 10]);
    assert_eq!(dealt(4), dealt(1));
}

#[test]
fn a_part_ends_where_the_next_begins() {
    let span = |shift| Span { buffer: 0, ends: 1, shift };
    let part = |index, shift| part(&[7, 8, 9], &[1, 1, 3], index, span(shift)).ok();
    assert_eq!(part(0, 0), Some(&[7][..]));
    assert_eq!(part(1, 0), Some(&[][..]));
    assert_eq!(part(0, -1), Some(&[8, 9][..]));
}
