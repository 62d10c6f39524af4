//! The level that a mesh is known to have.
//!
//! To find it out takes a look at the whole mesh; what operations keep is known of each, so one
//! look is enough for any number of calls.

use crate::mesh::{Level, Mesh};
use crate::run::highest_between;

/// The level that a mesh is known to have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// It surely has this one.
    has: Level,
    /// It surely has not this one.
    lacks: Option<Level>,
}

impl Known {
    /// Nothing is known, but that it is a mesh.
    pub(super) const NOTHING: Self = Self { has: Level::Map, lacks: None };

    /// The level that it surely has.
    pub(super) fn level(&self) -> Level {
        self.has
    }

    /// The level that it surely has, after a look at the mesh if that may be lower than what is
    /// wanted.
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

    /// Something was done that leaves at least this level.
    pub(super) fn leave(&mut self, level: Level) {
        *self = Self { has: level, lacks: None };
    }
}
