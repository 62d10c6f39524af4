//! Undo and redo: copies of the mesh, as many as fit.

use crate::mesh::Mesh;

/// The most bytes of all copies together.
const MOST: usize = 512 << 20;

/// The meshes before the last changes, and those that were undone.
#[derive(Debug, Default)]
pub(super) struct Past {
    before: Vec<Mesh>,
    undone: Vec<Mesh>,
}

impl Past {
    /// Keeps the mesh as it was before a change.
    pub fn keep(&mut self, mesh: Mesh) {
        self.undone.clear();
        self.before.push(mesh);
        let mut bytes: usize = self.before.iter().map(Mesh::bytes).sum();
        while bytes > MOST && self.before.len() > 1 {
            bytes -= self.before.remove(0).bytes();
        }
    }

    /// The mesh before the last change.
    pub fn last(&self) -> Option<&Mesh> {
        self.before.last()
    }

    /// Undoes a change: takes the current mesh, returns the one before; the same if there is none.
    pub fn undo(&mut self, now: Mesh) -> Mesh {
        match self.before.pop() {
            Some(before) => {
                self.undone.push(now);
                before
            }
            None => now,
        }
    }

    /// Redoes a change; returns the same mesh if nothing was undone.
    pub fn redo(&mut self, now: Mesh) -> Mesh {
        match self.undone.pop() {
            Some(after) => {
                self.before.push(now);
                after
            }
            None => now,
        }
    }

    /// The number of changes that can be undone, and of those that can be redone.
    pub fn depth(&self) -> [usize; 2] {
        [self.before.len(), self.undone.len()]
    }
}
