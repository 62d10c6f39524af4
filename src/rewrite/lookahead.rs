//! The lookahead of drains and loops: memory near the elements that come next is requested in
//! advance, so that it is in the processor's cache.

use super::Elements;
use super::paths::{Fields, Paths};
use super::queue::Queue;
use super::stale::Stale;
use crate::mesh::{ColumnId, ElementKind, Mesh};

/// Requests the memory around the elements of a list that follow an index, if that is due.
pub(super) fn prefetch(mesh: &Mesh, kind: ElementKind, list: &[u64], index: u64) {
    if index.is_multiple_of(Mesh::TOGETHER as u64) && mesh.is_large() {
        mesh.prefetch_list(kind, list, index as usize);
    }
}

/// The number of recently visited elements that are remembered.
const LOOKED_AT: usize = 256;

/// The attributes that a drain's lookahead reads, and the elements that it has visited.
#[derive(Debug)]
pub(super) struct Lookahead {
    /// The attributes that the keys read.
    columns: Vec<ColumnId>,
    /// The elements visited last, indexed by the low bits of their numbers.
    looked_at: Box<[u32; LOOKED_AT]>,
}

impl Lookahead {
    /// The lookahead of a drain whose keys have these paths, in a program with these attributes.
    pub(super) fn new(paths: Option<&Paths>, columns: &[Option<ColumnId>]) -> Self {
        let read = (0..).zip(columns).filter_map(|(number, &column)| {
            let (paths, column) = (paths?, column?);
            paths.concern(column.kind, Fields::attribute(number)).then_some(column)
        });
        Self { columns: read.collect(), looked_at: Box::new([u32::MAX; LOOKED_AT]) }
    }

    /// Requests the memory around the element with the least key and those that are likely to
    /// follow it, unless they have been visited.
    pub(super) fn look(&mut self, mesh: &Mesh, of: Elements, queue: &Queue, stale: &Stale) {
        if !mesh.is_large() {
            return;
        }
        let looked_at = &mut self.looked_at;
        let mut is_new =
            |id: &u32| std::mem::replace(&mut looked_at[*id as usize % LOOKED_AT], *id) != *id;
        let mut soon = [u32::MAX; Mesh::TOGETHER];
        match queue.least() {
            Some(least) if is_new(&least) => soon[0] = least,
            _ => return,
        }
        for (slot, id) in soon[1..].iter_mut().zip(queue.below_least().filter(is_new)) {
            *slot = id;
        }
        mesh.look_around(of.kind(), &soon, &self.columns, |kind, id| {
            if kind == of.kind() {
                queue.prefetch(id);
                stale.prefetch(id);
            }
        });
    }
}
