//! Requests to the processor to bring memory into its cache.
//!
//! # Safety
//!
//! A request accesses nothing, in Rust's sense, and its address is that of an element of a slice.

#![allow(unsafe_code)]

/// Requests the memory of an element of a table, if there is one at that index.
#[inline]
pub(super) fn prefetch<T>(table: &[T], index: usize) {
    if let Some(element) = table.get(index) {
        request(element);
    }
}

#[cfg(target_arch = "x86_64")]
#[inline]
fn request<T>(element: &T) {
    use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
    // SAFETY: see the module.
    unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(element).cast()) };
}

#[cfg(target_arch = "aarch64")]
#[inline]
fn request<T>(element: &T) {
    let place = std::ptr::from_ref(element);
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
fn request<T>(_: &T) {}
