//! The operations of a program that are emitted.

use crate::check::Proved;
use crate::resolve::{Program, Steps};
use crate::source::Sources;

/// Operations of a program that are emitted together.
#[derive(Clone, Copy, Debug)]
pub struct Selection<'p> {
    /// The program: its functions, attributes, and operations in steps.
    pub program: &'p Program,
    /// The proof of each operation, if it is drawn and has one.
    pub proved: &'p [Option<Proved>],
    /// The operations, by number.
    pub ops: &'p [usize],
    /// The source texts, for the comments in them.
    pub sources: &'p Sources,
    /// True if pointers that do not change are set, too.
    pub exhaustive: bool,
}

impl<'p> Selection<'p> {
    /// The proof of a drawn operation.
    pub(super) fn drawn(&self, op: usize) -> Option<&'p Proved> {
        self.proved.get(op)?.as_ref()
    }

    /// The steps of an operation in steps.
    pub(super) fn steps(&self, op: usize) -> Option<&'p Steps> {
        self.program.ops.get(op)?.steps.as_ref()
    }

    /// The name of an operation.
    pub(super) fn name(&self, op: usize) -> &'p str {
        let resolved = self.program.ops.get(op).map(|op| op.name.as_str());
        let drawn = || self.drawn(op).map(|proved| proved.op().name.as_str());
        drawn().or(resolved).unwrap_or_default()
    }
}
