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
    /// Something is done to the mesh, which was this one before.
    pub fn keep(&mut self, mesh: Mesh) {
        self.undone.clear();
        self.before.push(mesh);
        let mut bytes: usize = self.before.iter().map(Mesh::bytes).sum();
        while bytes > MOST && self.before.len() > 1 {
            bytes -= self.before.remove(0).bytes();
        }
    }

    /// The mesh before what was done last.
    pub fn last(&self) -> Option<&Mesh> {
        self.before.last()
    }

    /// One thing back: takes the mesh as it is, gives what it was; the same if there is nothing.
    pub fn undo(&mut self, now: Mesh) -> Mesh {
        match self.before.pop() {
            Some(before) => {
                self.undone.push(now);
                before
            }
            None => now,
        }
    }

    /// One thing forward again; the same mesh if nothing was undone.
    pub fn redo(&mut self, now: Mesh) -> Mesh {
        match self.undone.pop() {
            Some(after) => {
                self.before.push(now);
                after
            }
            None => now,
        }
    }

    /// The number of changes that can be undone, and of those that can be done again.
    pub fn depth(&self) -> [usize; 2] {
        [self.before.len(), self.undone.len()]
    }
}
