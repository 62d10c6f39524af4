//! The tables of a drain: which elements belong to it, their keys, and whose keys are to be computed.

use super::Elements;
use super::access::lives;
use super::queue::Queue;
use super::stale::Stale;
use crate::mesh::Mesh;

/// The elements of a drain, and the tables of these by number.
#[derive(Debug, Default)]
pub(super) struct Tables {
    /// The elements that belong to the drain, in order; `None` if all do, including those created
    /// in the loop.
    pub(super) members: Option<Vec<u32>>,
    /// By number, whether an element is a member.
    is_member: Vec<bool>,
    pub(super) queue: Queue,
    pub(super) stale: Stale,
}

impl Tables {
    /// The memory that they take, in bytes.
    pub(super) fn bytes(&self) -> usize {
        let members = self.members.as_ref().map_or(0, Vec::capacity) * size_of::<u32>();
        members + self.is_member.capacity() + self.stale.bytes() + self.queue.bytes()
    }

    /// Makes these elements the members.
    pub(super) fn take(&mut self, some: &[u64], capacity: usize) {
        let ids = some.iter().filter_map(|&id| u32::try_from(id).ok());
        let mut members: Vec<_> = ids.filter(|&id| (id as usize) < capacity).collect();
        members.sort_unstable();
        members.dedup();
        self.is_member.resize(capacity.max(self.is_member.len()), false);
        members.iter().for_each(|&id| self.is_member[id as usize] = true);
        self.members = Some(members);
    }

    /// Empties the tables of some elements.
    pub(super) fn clear(&mut self) {
        for id in self.members.take().unwrap_or_default() {
            self.is_member[id as usize] = false;
            self.queue.forget(id);
        }
        while self.stale.pop().is_some() {}
    }

    /// Whether an element, if it lives, belongs to the drain.
    #[inline]
    pub(super) fn has(&self, id: u32) -> bool {
        self.members.is_none() || self.is_member.get(id as usize) == Some(&true)
    }

    /// Makes all elements stale, so that the first is taken first: they are taken from the end.
    pub(super) fn make_all_stale(&mut self, mesh: &Mesh, of: Elements) {
        let Self { members, is_member, stale, .. } = self;
        match members {
            None => {
                let ids = (0..mesh.capacity(of.kind()) as u32).rev();
                ids.filter(|&id| lives(mesh, of, id)).for_each(|id| stale.push(id));
            }
            Some(members) => {
                let ids = members.iter().copied().rev();
                let ids = ids.filter(|&id| is_member[id as usize] && lives(mesh, of, id));
                ids.for_each(|id| stale.push(id));
            }
        }
    }

    /// Notes a new element: it has no key, whatever element had its number before.
    pub(super) fn created(&mut self, id: u32) {
        self.queue.forget(id);
        match self.is_member.get_mut(id as usize) {
            _ if self.members.is_none() => self.stale.push(id),
            Some(member) => *member = false,
            None => {}
        }
    }
}
