//! The limit of memory that a run keeps to: of the mesh and of lists.

use super::{Machine, Message};
use crate::mesh::{ElementKind, Mesh};

/// What lists take, in bytes.
pub(super) fn bytes(buffers: &[Vec<u64>]) -> usize {
    buffers.iter().map(|buffer| buffer.capacity() * size_of::<u64>()).sum()
}

/// Makes room for new elements.
#[inline]
pub(super) fn for_elements(
    mesh: &mut Mesh,
    more: [usize; 4],
    buffers: &[Vec<u64>],
    limit: usize,
) -> Result<(), Message> {
    match mesh.make_room(more, || limit.saturating_sub(bytes(buffers))) {
        true => Ok(()),
        false => Err(Message::NoMemory(limit)),
    }
}

/// Makes room for new elements of one kind.
pub(super) fn for_kind(
    mesh: &mut Mesh,
    (kind, count): (ElementKind, usize),
    buffers: &[Vec<u64>],
    limit: usize,
) -> Result<(), Message> {
    let more = ElementKind::ALL.map(|this| if kind == this { count } else { 0 });
    for_elements(mesh, more, buffers, limit)
}

/// Makes room for more slots in a list.
#[inline]
pub(super) fn for_list(
    buffers: &mut [Vec<u64>],
    at: usize,
    more: usize,
    (mesh, limit): (&Mesh, usize),
) -> Result<(), Message> {
    match buffers.get(at) {
        Some(list) if more <= list.capacity() - list.len() => Ok(()),
        Some(_) => grow(buffers, at, more, (mesh, limit)),
        None => Err(Message::Malformed),
    }
}

#[cold]
fn grow(
    buffers: &mut [Vec<u64>],
    at: usize,
    more: usize,
    (mesh, limit): (&Mesh, usize),
) -> Result<(), Message> {
    let left = limit.saturating_sub(bytes(buffers)).saturating_sub(mesh.bytes()) / size_of::<u64>();
    let list = &mut buffers[at];
    let wanted = list.len().max(more).max(16).min((left / 2).max(more));
    match more <= left && list.try_reserve_exact(wanted).is_ok() {
        true => Ok(()),
        false => Err(Message::NoMemory(limit)),
    }
}

impl Machine {
    /// Keeps to a limit of memory, in bytes, for the mesh and for lists: what would need more
    /// traps. There is none at first.
    pub fn limit_memory(&mut self, bytes: usize) {
        self.memory = bytes;
    }
}
