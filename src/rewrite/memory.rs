//! The memory limit of a run: for the mesh, the lists and the keys of drains.

use super::access::counts_of;
use super::drain::Drains;
use super::{List, Machine, Message};
use crate::mesh::{ElementKind, Mesh};

/// The greatest number of slots of a write that is kept back.
pub(super) const HELD: usize = 18;

/// The number of slots of a position that is kept back.
pub(super) const HELD_USUALLY: usize = 5;

/// The memory of a run besides the mesh, and its limit.
pub(super) struct Budget<'r> {
    pub(super) buffers: &'r [List],
    pub(super) drains: &'r Drains,
    pub(super) limit: usize,
}

impl Budget<'_> {
    /// The memory used by lists and by the keys of drains, in bytes.
    pub(super) fn taken(&self) -> usize {
        let lists = self.buffers.iter().map(|buffer| buffer.capacity() * size_of::<u64>());
        lists.sum::<usize>().saturating_add(self.drains.bytes())
    }

    /// Whether the limit is exceeded.
    pub(super) fn is_passed(&self, mesh: &Mesh) -> bool {
        mesh.bytes().saturating_add(self.taken()) > self.limit
    }
}

/// Makes room for new elements.
#[inline]
pub(super) fn for_elements(
    mesh: &mut Mesh,
    more: [usize; 4],
    budget: &Budget,
) -> Result<(), Message> {
    match mesh.make_room(more, || budget.limit.saturating_sub(budget.taken())) {
        true => Ok(()),
        false => Err(Message::NoMemory(budget.limit)),
    }
}

/// Makes room for new elements of one kind.
pub(super) fn for_kind(
    mesh: &mut Mesh,
    (kind, count): (ElementKind, usize),
    budget: &Budget,
) -> Result<(), Message> {
    for_elements(mesh, counts_of(kind, count), budget)
}

/// Makes room for more slots in a list.
#[inline]
pub(super) fn for_list(
    buffers: &mut [List],
    at: usize,
    more: usize,
    (mesh, drains, limit): (&Mesh, &Drains, usize),
) -> Result<(), Message> {
    match buffers.get(at) {
        Some(list) if more <= list.capacity() - list.len() => Ok(()),
        Some(_) => grow(buffers, at, more, (mesh, drains, limit)),
        None => Err(Message::Malformed),
    }
}

#[cold]
fn grow(
    buffers: &mut [List],
    at: usize,
    more: usize,
    (mesh, drains, limit): (&Mesh, &Drains, usize),
) -> Result<(), Message> {
    let taken = Budget { buffers, drains, limit }.taken().saturating_add(mesh.bytes());
    let left = limit.saturating_sub(taken) / size_of::<u64>();
    let list = &mut buffers[at];
    let wanted = list.len().max(more).max(16).min((left / 2).max(more));
    match more <= left && list.grow().try_reserve_exact(wanted).is_ok() {
        true => Ok(()),
        false => Err(Message::NoMemory(limit)),
    }
}

impl Machine {
    /// Limits the memory, in bytes, for the mesh, lists and the keys of drains: exceeding it traps.
    /// There is no limit at first.
    pub fn limit_memory(&mut self, bytes: usize) {
        self.memory = bytes;
    }
}
