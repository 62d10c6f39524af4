//! The register code.
//!
//! Registers are slots of 64 bits in one window per call. An int is an `i64`, a real an
//! `f64`, a bool 0 or 1, an element its id (`u32::MAX`: none); a vector takes three
//! consecutive slots, a matrix its columns one after the other. Each instruction fixes the
//! types of its registers, so the code is typed though the slots are not. Jumps name
//! instructions by index.

use std::sync::Arc;

use super::{Function, Inst, Native, Part};

/// A register: a slot of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Reg(pub u16);

impl Reg {
    /// The register `offset` slots further, for the parts of a vector.
    pub fn part(self, offset: u16) -> Reg {
        Reg(self.0 + offset)
    }
}

/// The place of an instruction, as the target of a jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Label(pub u32);

/// A flat sequence of instructions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Code {
    /// The instructions; running past the last one returns.
    pub insts: Vec<Inst>,
    /// The number of instructions at the start that load constants into registers that no other
    /// instruction writes.
    pub constants: usize,
    /// The number of slots of its window.
    pub registers: u16,
    /// The number of buffers it uses.
    pub buffers: u16,
    /// The places in the source of the instructions that can trap: see [`Traps`].
    pub traps: Traps,
    /// The constant texts, by number; no two are equal.
    pub texts: Vec<String>,
    /// The functions that it may call, by number.
    pub functions: Arc<[Function]>,
    /// The loops that can be run by several threads, by number.
    pub parts: Vec<Option<Part>>,
    /// The native code, once the code has run often enough.
    pub native: Native,
}

impl Code {
    /// Whether a drain may run in this code.
    pub fn drains(&self) -> bool {
        self.functions.iter().map(|function| &function.code).chain([self]).any(Self::opens_drain)
    }

    /// Whether this code itself begins a drain.
    pub(super) fn opens_drain(&self) -> bool {
        self.insts.iter().any(|inst| matches!(inst, Inst::DrainOpen { .. }))
    }

    /// The code itself, and those of the functions that it calls, directly or indirectly.
    pub fn with_called(&self) -> Vec<&Code> {
        self.with_called_of(&self.functions)
    }

    /// [`with_called`](Self::with_called) with the given functions, by number; the code of a
    /// function has no list of its own.
    pub(super) fn with_called_of<'c>(&'c self, functions: &'c [Function]) -> Vec<&'c Code> {
        let mut found = vec![self];
        let mut seen = vec![false; functions.len()];
        let mut looked_at = 0;
        while let Some(code) = found.get(looked_at).copied() {
            looked_at += 1;
            for inst in &code.insts {
                if let Inst::Call { function, .. } = inst
                    && let Some(seen) = seen.get_mut(usize::from(*function))
                    && !std::mem::replace(seen, true)
                {
                    found.push(&functions[usize::from(*function)].code);
                }
            }
        }
        found
    }

    /// Whether this code may itself change the mesh.
    pub fn changes(&self) -> bool {
        let changes = |inst: &Inst| {
            inst.writes() || matches!(inst, Inst::Apply { .. } | Inst::WriteDeferred { .. })
        };
        self.insts.iter().any(changes)
    }

    /// The number of the place in the source of an instruction that can trap.
    pub fn place(&self, inst: usize) -> Option<u32> {
        let at = u32::try_from(inst).ok()?;
        self.traps.binary_search_by_key(&at, |&(inst, _)| inst).ok().map(|trap| self.traps[trap].1)
    }
}

/// The number of the place in the source of each instruction that can trap: an index into the spans
/// that the compiler of the code keeps. Sorted by instruction.
pub type Traps = Vec<(u32, u32)>;
