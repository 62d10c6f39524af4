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

/// A flat program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Code {
    /// The instructions; running past the last one returns.
    pub insts: Vec<Inst>,
    /// How many of them, the first, load constants into registers that nobody else writes to.
    pub constants: usize,
    /// The number of slots of its window.
    pub registers: u16,
    /// The number of buffers it uses.
    pub buffers: u16,
    /// The reason why each trapping instruction could fail, by its index: see [`Traps`].
    pub traps: Traps,
    /// The constant texts, by number; no two are equal.
    pub texts: Vec<String>,
    /// The functions that it may call, by number.
    pub functions: Arc<[Function]>,
    /// The loops that several threads can take, by number.
    pub parts: Vec<Option<Part>>,
    /// The same as native code, from when it has run often.
    pub native: Native,
}

impl Code {
    /// True if a drain may run in it.
    pub fn drains(&self) -> bool {
        let functions = self.functions.iter().map(|function| &function.code);
        functions.chain([self]).any(Self::opens_drain)
    }

    /// True if it begins a drain itself.
    pub(super) fn opens_drain(&self) -> bool {
        self.insts.iter().any(|inst| matches!(inst, Inst::DrainOpen { .. }))
    }

    /// The code itself, and that of the functions that it calls, directly or through others.
    pub fn with_called(&self) -> Vec<&Code> {
        self.with_called_of(&self.functions)
    }

    /// The same where it calls these functions, by their numbers, which a function's code itself does
    /// not know.
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

    /// True if it may change the mesh itself.
    pub fn changes(&self) -> bool {
        let changes = |inst: &Inst| {
            inst.writes() || matches!(inst, Inst::Apply { .. } | Inst::ReleaseHeld { .. })
        };
        self.insts.iter().any(changes)
    }

    /// The number of the place in the source of an instruction that can trap.
    pub fn place(&self, inst: usize) -> Option<u32> {
        let at = u32::try_from(inst).ok()?;
        let found = self.traps.binary_search_by_key(&at, |&(inst, _)| inst);
        found.ok().map(|trap| self.traps[trap].1)
    }
}

/// For each instruction that can fail at run time the number of its place in the source:
/// an index into the spans that whoever made the code keeps. Sorted by instruction.
pub type Traps = Vec<(u32, u32)>;
