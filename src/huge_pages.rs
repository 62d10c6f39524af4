//! Large memory blocks in huge pages, where Linux supports them.
//!
//! The tables of a mesh are read in the order of its connectivity, which is not memory order: with
//! pages of 4 KiB, a million triangles need more pages than the TLB of a processor holds, and each
//! page is zeroed by the kernel on first use. Linux gives huge pages on request. This has the
//! effect of the tunable `glibc.malloc.hugetlb=1` for all allocations of the program.
//!
//! # Safety
//!
//! Every block comes from [`System`], with the layout that was requested. The advice given to Linux
//! changes neither contents nor addresses, and concerns only pages that the program owns.

#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};

/// The allocator of the program.
pub(crate) struct HugePages;

/// The smallest block, in bytes, for which huge pages are requested.
const LEAST: usize = 1 << 20;

// SAFETY: `System` does all the work, and its blocks are returned unchanged.
unsafe impl GlobalAlloc for HugePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller meets the contract of this function.
        advise(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller meets the contract of this function.
        advise(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller meets the contract of this function.
        advise(unsafe { System.realloc(block, layout, size) }, size)
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller meets the contract of this function.
        unsafe { System.dealloc(block, layout) }
    }
}

/// Requests huge pages for a block, which is returned. Linux may have none.
#[inline]
fn advise(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LEAST && !block.is_null() {
        advise_large(block, size);
    }
    block
}

#[cold]
fn advise_large(block: *mut u8, size: usize) {
    // SAFETY: only queries a number.
    let page = unsafe { libc::sysconf(libc::_SC_PAGESIZE) } as usize;
    // The address must be that of a page: from the first page that the block overlaps, so that a
    // mapping is not split.
    let before = block.addr() & (page.max(1) - 1);
    // SAFETY: the pages are those of the block, which is allocated; their contents do not change.
    unsafe {
        libc::madvise(block.wrapping_sub(before).cast(), before + size, libc::MADV_HUGEPAGE);
    }
}
