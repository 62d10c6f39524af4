//! The level that a mesh is known to have.
//!
//! Finding it requires a pass over the whole mesh; the levels that each operation preserves are
//! known, so one pass suffices for any number of calls.

use crate::mesh::{Level, Mesh};
use crate::run::highest_between;

/// The level that a mesh is known to have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// The mesh certainly has this level.
    has: Level,
    /// The mesh certainly lacks this level.
    lacks: Option<Level>,
}

impl Known {
    /// Nothing is known except that it is a mesh.
    pub(super) const NOTHING: Self = Self { has: Level::Map, lacks: None };

    /// The level that it certainly has.
    pub(super) fn level(&self) -> Level {
        self.has
    }

    /// The level that it certainly has, after a check of the mesh if the known level is below
    /// `wanted`.
    pub(super) fn seek(&mut self, wanted: Level, mesh: &Mesh) -> Level {
        let open = |level: &Level| {
            self.has < *level && *level <= wanted && self.lacks.is_none_or(|lacks| *level < lacks)
        };
        if let Some(highest) = Level::ALL.into_iter().rev().find(open) {
            self.has = highest_between(mesh, self.has, highest);
            if self.has < highest {
                self.lacks = Level::ALL.into_iter().find(|&level| self.has < level);
            }
        }
        self.has
    }

    /// Records a change after which the mesh has at least this level.
    pub(super) fn leave(&mut self, level: Level) {
        *self = Self { has: level, lacks: None };
    }
}
