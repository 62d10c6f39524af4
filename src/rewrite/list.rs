//! Growing lists of slots that native code reads, fills and empties in place.
//!
//! # Safety
//!
//! The parts of a list are at any time those of a `Vec` that nothing else owns. Whoever writes to
//! them in place keeps that so: slots below the count are set, and the count is at most the room.

#![allow(unsafe_code)]

use std::mem::{self, ManuallyDrop};
use std::ops::{Deref, DerefMut};
use std::ptr::NonNull;
use std::slice;

/// A `Vec` of slots, in a layout that native code knows.
#[derive(Debug)]
#[repr(C)]
pub struct List {
    start: NonNull<u64>,
    count: usize,
    room: usize,
}

/// A list as a `Vec`, to grow it. The list is empty until this is dropped.
#[derive(Debug)]
pub struct Growing<'l> {
    list: &'l mut List,
    slots: Vec<u64>,
}

// SAFETY: a list owns its slots, which are numbers, and changes only through `&mut`.
unsafe impl Send for List {}
// SAFETY: as above.
unsafe impl Sync for List {}

impl List {
    /// The offset of the address of the slots.
    #[cfg(feature = "native")]
    pub(super) const START: usize = mem::offset_of!(Self, start);
    /// The offset of the number of slots.
    #[cfg(feature = "native")]
    pub(super) const COUNT: usize = mem::offset_of!(Self, count);
    /// The offset of the number of slots for which there is memory.
    #[cfg(feature = "native")]
    pub(super) const ROOM: usize = mem::offset_of!(Self, room);

    /// The number of slots for which there is memory.
    #[inline]
    pub fn capacity(&self) -> usize {
        self.room
    }

    /// Empties the list, and keeps its memory.
    #[inline]
    pub fn clear(&mut self) {
        self.count = 0;
    }

    /// The list as a `Vec`, to grow it.
    #[inline]
    pub fn grow(&mut self) -> Growing<'_> {
        let slots = mem::take(self).into();
        Growing { list: self, slots }
    }
}

impl Deref for List {
    type Target = [u64];

    #[inline]
    fn deref(&self) -> &[u64] {
        // SAFETY: the parts are those of a `Vec`, which has this many slots.
        unsafe { slice::from_raw_parts(self.start.as_ptr(), self.count) }
    }
}

impl DerefMut for List {
    #[inline]
    fn deref_mut(&mut self) -> &mut [u64] {
        // SAFETY: as for `deref`, and the list is borrowed alone.
        unsafe { slice::from_raw_parts_mut(self.start.as_ptr(), self.count) }
    }
}

impl Default for List {
    #[inline]
    fn default() -> Self {
        Self { start: NonNull::dangling(), count: 0, room: 0 }
    }
}

impl From<Vec<u64>> for List {
    #[inline]
    fn from(slots: Vec<u64>) -> Self {
        let mut slots = ManuallyDrop::new(slots);
        let (count, room) = (slots.len(), slots.capacity());
        // The address of a `Vec` is never null.
        let start = NonNull::new(slots.as_mut_ptr()).unwrap_or(NonNull::dangling());
        Self { start, count, room }
    }
}

impl From<List> for Vec<u64> {
    #[inline]
    fn from(list: List) -> Self {
        let List { start, count, room } = *ManuallyDrop::new(list);
        // SAFETY: these are the parts of a `Vec` that nothing else owns, since the list is not
        // dropped.
        unsafe { Vec::from_raw_parts(start.as_ptr(), count, room) }
    }
}

impl Drop for List {
    fn drop(&mut self) {
        if self.room > 0 {
            // SAFETY: as above; the list is not used again.
            drop(unsafe { Vec::from_raw_parts(self.start.as_ptr(), self.count, self.room) });
        }
    }
}

impl Deref for Growing<'_> {
    type Target = Vec<u64>;

    #[inline]
    fn deref(&self) -> &Vec<u64> {
        &self.slots
    }
}

impl DerefMut for Growing<'_> {
    #[inline]
    fn deref_mut(&mut self) -> &mut Vec<u64> {
        &mut self.slots
    }
}

impl Drop for Growing<'_> {
    #[inline]
    fn drop(&mut self) {
        // The list that is replaced is empty.
        *self.list = mem::take(&mut self.slots).into();
    }
}
