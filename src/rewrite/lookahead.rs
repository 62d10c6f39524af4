//! The look ahead of a drain, around the elements whose turn comes soon.

use super::Elements;
use super::paths::{Fields, Paths};
use super::queue::Queue;
use super::stale::Stale;
use crate::mesh::{ColumnId, Mesh};

/// The number of elements of which it is known that they have been looked at.
const LOOKED_AT: usize = 256;

/// What a drain looks at, and has looked at.
#[derive(Debug)]
pub(super) struct Lookahead {
    /// The attributes that the keys read.
    columns: Vec<ColumnId>,
    /// By the end of their numbers the elements that have been looked at.
    looked_at: Box<[u32; LOOKED_AT]>,
}

impl Lookahead {
    /// That of a drain whose keys have these paths, in a program with these attributes.
    pub(super) fn new(paths: Option<&Paths>, columns: &[Option<ColumnId>]) -> Self {
        let read = (0..).zip(columns).filter_map(|(number, &column)| {
            let (paths, column) = (paths?, column?);
            paths.concern(column.kind, Fields::attribute(number)).then_some(column)
        });
        Self { columns: read.collect(), looked_at: Box::new([u32::MAX; LOOKED_AT]) }
    }

    /// Looks around the element with the least key and those that are likely to follow, once.
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
                queue.touch(id);
                stale.touch(id);
            }
        });
    }
}
