//! Requests to the processor to bring memory into its cache.
//!
//! # Safety
//!
//! A request accesses nothing, in Rust's sense, and its address lies in an element of a slice.

#![allow(unsafe_code)]

/// The bytes of a line of the cache.
const LINE: usize = 64;

/// Requests the memory of an element of a table, if there is one at that index.
#[inline]
pub(crate) fn prefetch<T>(table: &[T], index: usize) {
    if let Some(element) = table.get(index) {
        let start = std::ptr::from_ref(element).cast::<u8>();
        for offset in (0..size_of::<T>()).step_by(LINE) {
            request(start.wrapping_add(offset));
        }
        if size_of::<T>() > LINE {
            request(start.wrapping_add(size_of::<T>() - 1));
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn request(place: *const u8) {
    use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
    // SAFETY: see the module.
    unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast()) };
}

#[cfg(target_arch = "aarch64")]
#[inline]
fn request(place: *const u8) {
    // SAFETY: see the module; the instruction changes neither registers, flags nor memory.
    unsafe {
        std::arch::asm!(
            "prfm pldl1keep, [{place}]",
            place = in(reg) place,
            options(nostack, preserves_flags, readonly)
        );
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
#[inline]
fn request(_: *const u8) {}
