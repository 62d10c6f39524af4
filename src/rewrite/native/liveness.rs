//! Liveness: the registers that are read before they are written, from each instruction on.

use super::facts::{ends, targets};
use super::operands::{Environment, Use};
use crate::rewrite::{Code, Inst, Reg};

/// A set of registers.
#[derive(Clone, Debug, PartialEq)]
struct Set(Vec<u64>);

impl Set {
    fn add(&mut self, reg: Reg) {
        if let Some(word) = self.0.get_mut(usize::from(reg.0 / 64)) {
            *word |= 1 << (reg.0 % 64);
        }
    }

    fn remove(&mut self, reg: Reg) {
        if let Some(word) = self.0.get_mut(usize::from(reg.0 / 64)) {
            *word &= !(1 << (reg.0 % 64));
        }
    }

    fn unite(&mut self, other: &Self) {
        for (word, other) in self.0.iter_mut().zip(&other.0) {
            *word |= other;
        }
    }

    fn registers(&self) -> Vec<Reg> {
        let all = (0..self.0.len() * 64).map(|at| at as u16);
        all.filter(|at| self.0[usize::from(at / 64)] >> (at % 64) & 1 == 1).map(Reg).collect()
    }
}

/// The registers that are live at the start of the code and at the targets of jumps.
pub(super) struct Liveness<'a> {
    insts: &'a [Inst],
    constants: usize,
    registers: u16,
    environment: &'a Environment<'a>,
    nothing: Set,
    /// By instruction, if it is the first or the target of a jump.
    live: Vec<Option<Set>>,
}

impl<'a> Liveness<'a> {
    pub(super) fn of(code: &'a Code, registers: usize, environment: &'a Environment<'a>) -> Self {
        let insts = code.insts.as_slice();
        let nothing = Set(vec![0; registers.div_ceil(64)]);
        let mut live: Vec<Option<Set>> = vec![None; insts.len() + 1];
        for (at, is_target) in targets(code).into_iter().enumerate() {
            if is_target || at == 0 {
                live[at] = Some(nothing.clone());
            }
        }
        let &Code { constants, registers, .. } = code;
        let mut found = Self { insts, constants, registers, environment, nothing, live };
        // The live sets only grow, so this ends.
        while found.go_back(0, |_, _| {}) {}
        found
    }

    /// Visits the instructions from the last to `first`, and calls `see` with the registers that
    /// are live after each; returns whether a live set has grown.
    fn go_back(&mut self, first: usize, mut see: impl FnMut(usize, &Set)) -> bool {
        let mut changed = false;
        let mut now = self.nothing.clone();
        for at in (first..self.insts.len()).rev() {
            let inst = &self.insts[at];
            if ends(inst) {
                now = self.nothing.clone();
            } else if let Some(known) = &self.live[at + 1] {
                now.unite(known);
            }
            if let Some(to) = inst.target()
                && let Some(known) = &self.live[to.min(self.insts.len())]
            {
                now.unite(known);
            }
            see(at, &now);
            let environment = self.environment;
            environment.each_operand(inst, &mut |operand| {
                if operand.used == Use::Write {
                    operand.registers().for_each(|reg| now.remove(reg));
                }
            });
            environment.each_operand(inst, &mut |operand| {
                if operand.used != Use::Write {
                    operand.registers().for_each(|reg| now.add(reg));
                }
            });
            if let Some(known) = &mut self.live[at]
                && *known != now
            {
                known.unite(&now);
                changed = true;
            }
        }
        changed
    }

    /// The registers that are live before an instruction, the first or the target of a jump,
    /// without constants.
    pub(super) fn at(&self, inst: usize) -> Vec<Reg> {
        self.without_constants(self.live[inst].as_ref().map_or_else(Vec::new, Set::registers))
    }

    /// All registers except constants.
    pub(super) fn all(&self) -> Vec<Reg> {
        self.without_constants((0..self.registers).map(Reg).collect())
    }

    fn without_constants(&self, all: Vec<Reg>) -> Vec<Reg> {
        let is_constant = |reg: &Reg| {
            let mut constants = self.insts.iter().take(self.constants);
            constants.any(|inst| matches!(inst, Inst::Const { to, .. } if to == reg))
        };
        all.into_iter().filter(|reg| !is_constant(reg)).collect()
    }

    /// The registers that are live after an instruction.
    pub(super) fn behind(&mut self, inst: usize) -> Vec<Reg> {
        let mut found = Vec::new();
        self.go_back(inst, |at, live| {
            if at == inst {
                found = live.registers();
            }
        });
        found
    }
}
