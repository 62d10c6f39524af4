//! An allocator that puts large blocks into huge pages.
//!
//! The tables of a mesh are read in the order of its connectivity, which is not memory order: with
//! pages of 4 KiB, a million triangles need more pages than the TLB of a processor holds, and the
//! kernel zeroes each page on first use. Linux gives huge pages on request, but only whole ones: a
//! large block has a mapping of its own, which begins at a huge page, and it keeps them when it grows.
//! Loading takes a tenth less time with it than with the advice alone, subdivision a fifth.
//!
//! # Safety
//!
//! Whether a block belongs to [`System`] or has a mapping, and how long that is, follows from the size
//! in its layout (`mapped`), which callers repeat at every call.

#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::ptr;

/// The allocator: [`System`] for blocks below 1 MiB, and mappings in huge pages for larger ones.
#[derive(Debug)]
pub struct HugePages;

/// The size of a huge page, in bytes.
const HUGE: usize = 2 << 20;

/// The smallest block, in bytes, with huge pages, and the smallest rest of a block that gets one.
const LEAST: usize = 1 << 20;

/// A multiple of the size of all ordinary pages, in bytes.
const ORDINARY: usize = 64 << 10;

// SAFETY: a block of `System` is only given back to it, and a mapping is as long as its block.
unsafe impl GlobalAlloc for HugePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        match mapped(layout.size(), layout.align()) {
            Some(length) => map(length),
            // SAFETY: the caller meets the contract of this function.
            None => unsafe { System.alloc(layout) },
        }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        match mapped(layout.size(), layout.align()) {
            // New pages are zero.
            Some(length) => map(length),
            // SAFETY: the caller meets the contract of this function.
            None => unsafe { System.alloc_zeroed(layout) },
        }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let before = mapped(layout.size(), layout.align());
        match (before, mapped(size, layout.align())) {
            // SAFETY: the caller meets the contract of this function.
            (None, None) => unsafe { System.realloc(block, layout, size) },
            // SAFETY: the block is a mapping of that length.
            (Some(before), Some(after)) => unsafe { resize(block, before, after) },
            // SAFETY: the caller meets the contract of this function; the new block is another.
            _ => unsafe {
                let new = self.alloc(Layout::from_size_align_unchecked(size, layout.align()));
                if !new.is_null() {
                    ptr::copy_nonoverlapping(block, new, size.min(layout.size()));
                    self.dealloc(block, layout);
                }
                new
            },
        }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        match mapped(layout.size(), layout.align()) {
            // SAFETY: the block is a mapping of that length.
            Some(length) => unsafe { unmap(block, length) },
            // SAFETY: the caller meets the contract of this function.
            None => unsafe { System.dealloc(block, layout) },
        }
    }
}

/// The length of the mapping of a block that has one: whole huge pages, and ordinary ones for a small
/// rest.
#[inline]
fn mapped(size: usize, align: usize) -> Option<usize> {
    let page = if size % HUGE < LEAST { ORDINARY } else { HUGE };
    (size >= LEAST && align <= HUGE).then(|| size.next_multiple_of(page))
}

/// A new mapping in huge pages, or null.
#[cold]
fn map(length: usize) -> *mut u8 {
    let block = reserve(length);
    if !block.is_null() {
        // SAFETY: the pages are those of the new mapping; Linux may have no huge ones for it.
        unsafe { libc::madvise(block.cast(), length, libc::MADV_HUGEPAGE) };
    }
    block
}

/// A mapping that begins at a huge page, or null.
fn reserve(length: usize) -> *mut u8 {
    // Newer systems begin at a huge page by themselves.
    let block = anonymous(length);
    let off = block.addr() & (HUGE - 1);
    if block.is_null() || off == 0 {
        return block;
    }
    // SAFETY: the mapping was made here, and nobody has it.
    unsafe { unmap(block, length) };
    let block = anonymous(length.saturating_add(HUGE));
    if block.is_null() {
        return block;
    }
    let before = block.addr().next_multiple_of(HUGE) - block.addr();
    let start = block.wrapping_add(before);
    // SAFETY: what stands before and behind belongs to the mapping, and nobody has it.
    unsafe {
        unmap(block, before);
        unmap(start.wrapping_add(length), HUGE - before);
    }
    start
}

/// New pages, or null.
fn anonymous(length: usize) -> *mut u8 {
    let access = libc::PROT_READ | libc::PROT_WRITE;
    let kind = libc::MAP_PRIVATE | libc::MAP_ANONYMOUS;
    // SAFETY: the pages overlap no others.
    let block = unsafe { libc::mmap(ptr::null_mut(), length, access, kind, -1, 0) };
    if block == libc::MAP_FAILED { ptr::null_mut() } else { block.cast() }
}

/// Makes a mapping longer or shorter; its huge pages stay whole. Null if it stays as it was.
///
/// # Safety
///
/// The block must be a mapping of the length `before`.
#[cold]
unsafe fn resize(block: *mut u8, before: usize, after: usize) -> *mut u8 {
    if before == after {
        return block;
    }
    // SAFETY: the caller has the mapping; without a flag it stays where it is.
    let same = unsafe { libc::mremap(block.cast(), before, after, 0) };
    if same != libc::MAP_FAILED {
        return block;
    }
    let place = reserve(after);
    if place.is_null() {
        return place;
    }
    let flags = libc::MREMAP_MAYMOVE | libc::MREMAP_FIXED;
    // SAFETY: the new place was made here, and nobody has it: the pages of the block replace its own.
    let moved = unsafe { libc::mremap(block.cast(), before, after, flags, place) };
    if moved != libc::MAP_FAILED {
        return place;
    }
    // Whether the place is still mapped is not known, so it is not used again.
    let copy = map(after);
    if !copy.is_null() {
        // SAFETY: both are mappings, of which nobody has the new one.
        unsafe {
            ptr::copy_nonoverlapping(block, copy, before.min(after));
            unmap(block, before);
        }
    }
    copy
}

/// Gives pages back.
///
/// # Safety
///
/// They must be those of mappings, and nobody may use them any more.
unsafe fn unmap(start: *mut u8, length: usize) {
    if length > 0 {
        // SAFETY: the contract of this function.
        unsafe { libc::munmap(start.cast(), length) };
    }
}
