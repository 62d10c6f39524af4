//! Elements with something that has to be recomputed.

use crate::mesh::prefetch;

/// A stack of numbers without duplicates.
#[derive(Debug, Default)]
pub(super) struct Stale {
    all: Vec<u32>,
    is_in: Vec<bool>,
}

impl Stale {
    pub(super) fn push(&mut self, id: u32) {
        let index = id as usize;
        if self.is_in.len() <= index {
            self.is_in.resize(index + 1, false);
        }
        if !std::mem::replace(&mut self.is_in[index], true) {
            self.all.push(id);
        }
    }

    pub(super) fn pop(&mut self) -> Option<u32> {
        let id = self.all.pop()?;
        self.is_in[id as usize] = false;
        Some(id)
    }

    /// The elements that are popped next but one, and after that.
    #[inline]
    pub(super) fn soon(&self) -> impl Iterator<Item = u32> {
        self.all.iter().rev().skip(1).take(2).copied()
    }

    /// Requests the memory of the entry of an element.
    #[inline]
    pub(super) fn prefetch(&self, id: u32) {
        prefetch(&self.is_in, id as usize);
    }

    /// The memory that it takes, in bytes.
    pub(super) fn bytes(&self) -> usize {
        self.all.capacity() * size_of::<u32>() + self.is_in.capacity()
    }
}
