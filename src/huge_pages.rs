//! Large blocks of memory in huge pages, where Linux has them.
//!
//! The tables of a mesh are read in the order of its connectivity, which is not that of memory: with
//! pages of 4 KiB a million triangles need more of them than a processor knows addresses of, and
//! each is zeroed by the system on its first use. Linux gives huge pages to whoever asks for them.
//! The same as the tunable `glibc.malloc.hugetlb=1`, for each allocation of the program.
//!
//! # Safety
//!
//! Every block is that of [`System`], with the layout that was asked for. What is told about it to
//! Linux changes no content and no address, and holds for pages that the program has.

#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};

/// The allocator of the program.
pub(crate) struct HugePages;

/// The fewest bytes for which Linux is asked.
const LEAST: usize = 1 << 20;

// SAFETY: all is done by `System`, whose blocks are given out as they are.
unsafe impl GlobalAlloc for HugePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as of this function.
        advise(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as of this function.
        advise(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as of this function.
        advise(unsafe { System.realloc(block, layout, size) }, size)
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as of this function.
        unsafe { System.dealloc(block, layout) }
    }
}

/// Asks for huge pages for a block, which is given back. Linux may not have them.
#[inline]
fn advise(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LEAST && !block.is_null() {
        advise_large(block, size);
    }
    block
}

#[cold]
fn advise_large(block: *mut u8, size: usize) {
    // SAFETY: asks for a number.
    let page = unsafe { libc::sysconf(libc::_SC_PAGESIZE) } as usize;
    // From the first page on that it has a part of, so that a mapping stays one.
    let before = block.addr() & (page.max(1) - 1);
    // SAFETY: the pages are those of the block, which is there; what they hold stays.
    unsafe {
        libc::madvise(block.wrapping_sub(before).cast(), before + size, libc::MADV_HUGEPAGE);
    }
}
