//! Results of phase 1 for the later phases.

use super::registers::{Home, Registers};
use crate::rewrite::Reg;

/// The results of phase 1 for the later phases.
pub(super) struct Collected {
    pub registers: Registers,
    /// For each path and fan that moves, its halfedges.
    pub runs: Vec<Option<Run>>,
    /// The values of the assignments, in order.
    pub values: Vec<Home>,
}

/// The buffers with the halfedges of a path or fan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    /// All halfedges; for a family, those of every index, one after the other.
    pub buffer: u16,
    /// For a family, a buffer with the end of the halfedges of each index.
    pub ends: Option<u16>,
}

/// The kind of test for a claim about families.
pub(super) enum Around {
    /// The register of whether it holds.
    Holds(Reg),
    /// All slots of a buffer must differ.
    Distinct(u16),
}
