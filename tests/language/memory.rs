//! What is parsed and dropped leaves no memory behind: servers parse at every keystroke.

#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use hedgerow::syntax::parse;

/// The allocator of the system, which counts the bytes that a thread holds.
struct Counted;

thread_local! {
    static HELD: Cell<usize> = const { Cell::new(0) };
}

fn count(taken: usize, given_back: usize) {
    HELD.set(HELD.get().wrapping_add(taken).wrapping_sub(given_back));
}

// SAFETY: all calls go to the allocator of the system unchanged.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        // SAFETY: the caller meets the contract.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        count(0, layout.size());
        // SAFETY: the caller meets the contract.
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counted = Counted;

#[test]
fn what_is_parsed_leaves_nothing_behind() {
    let text = include_str!("../../src/library/std/triangle.hedge");
    let held_after = |text: &str| {
        drop(parse(Default::default(), text));
        HELD.get()
    };
    for text in [text, "", "script go() { if true { print 1 } else {"] {
        // What is set up once stays.
        let first = held_after(text);
        assert_eq!(held_after(text), first, "{text:.20}");
    }
}
