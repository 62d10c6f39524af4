//! Families in phase 1: the walk that binds them, and claims about all of their members at once.

use super::collect::Collect;
use super::collected::Around;
use super::registers::Home;
use crate::check::matching::Claim;
use crate::diagram::{Kind, NameId};
use crate::lower::{Walk as Orbit, WalkTest};
use crate::rewrite::{Cell, Inst, Phase, Reg, Walk};

impl Collect<'_, '_, '_, '_> {
    /// Walks an orbit once around and deals its halfedges out to the families of a period.
    pub(super) fn walk(&mut self, orbit: &Orbit) {
        let rule = self.drawing.rule;
        let (walk, around) = match orbit.around_vertex {
            true => (Walk::Star, "around"),
            false => (Walk::Loop, "along"),
        };
        let text = &rule.name(orbit.orbit).text;
        let words = orbit.families.iter().map(|&(half, _)| rule.name(half).text.as_str());
        let words = words.collect::<Vec<_>>().join(", ");
        self.row(Cell::Note { text: format!("walk once {around} {text}: {words} at each index") });
        let from = self.registers.begin(&mut self.output.asm, orbit.families[0].0);
        let buffer = self.buffer();
        self.output.asm.emit(Inst::Collect { walk, buffer, from, until: from, whole: true });
        let period = u16::try_from(orbit.families.len()).unwrap_or(u16::MAX);
        if let Some(test) = &orbit.is_whole {
            let mark = self.output.asm.mark();
            let left = self.length(buffer);
            let right = self.output.asm.constant_int(i64::from(period));
            let to = self.output.asm.reg();
            self.output.asm.emit(Inst::ModInt { to, left, right });
            let zero = self.output.asm.constant_int(0);
            self.expect_equal([to, zero], test);
            self.output.asm.release(mark);
        }
        for (place, &(half, turn)) in (0..).zip(&orbit.families) {
            let Home::Member { buffer: to, .. } = self.registers.home(half) else { continue };
            self.output.asm.emit(Inst::BufferClear { buffer: to });
            let turn = i16::try_from(turn).unwrap_or(0);
            self.output.asm.emit(Inst::BufferStride { from: buffer, to, place, period, turn });
            let cycle = *self.registers.cycle.get_or_insert(to);
            if let (0, Some(test)) = (place, &orbit.fits) {
                let mark = self.output.asm.mark();
                let lengths = [cycle, to].map(|buffer| self.length(buffer));
                self.expect_equal(lengths, test);
                self.output.asm.release(mark);
            }
        }
    }

    fn length(&mut self, buffer: u16) -> Reg {
        let to = self.output.asm.reg();
        self.output.asm.emit(Inst::BufferLength { buffer, to });
        to
    }

    fn expect_equal(&mut self, [left, right]: [Reg; 2], test: &WalkTest) {
        let WalkTest { claim, refusal } = test.clone();
        self.row(Cell::Test { claim, reason: refusal.clone() });
        let refusal = self.output.refusal(refusal, Phase::Match);
        let otherwise = self.fail;
        self.output.asm.emit(Inst::ExpectEqual { left, right, refusal, otherwise });
    }

    /// The code for a claim about families as a whole.
    pub(super) fn around(&mut self, claim: &Claim) -> Around {
        match claim {
            Claim::Begins(name) => {
                let right = self.registers.begin(&mut self.output.asm, *name);
                let left = self.element(*name);
                let to = self.output.asm.reg();
                self.output.asm.emit(Inst::Equal { to, left, right });
                Around::Holds(to)
            }
            Claim::AllDistinct(names) => Around::Distinct(self.all_of(names)),
            Claim::AroundInOrder { along_loop, halfedges } => {
                let buffer = self.buffer();
                let indices = self.registers.begin_index_loop(&mut self.output.asm);
                for &half in halfedges {
                    let from = self.element(half);
                    self.output.asm.emit(Inst::BufferPush { buffer, from });
                }
                self.registers.end_index_loop(&mut self.output.asm, indices);
                let walk = if *along_loop { Walk::Loop } else { Walk::Star };
                let to = self.output.asm.reg();
                self.output.asm.emit(Inst::MeetsAll { walk, to, buffer });
                Around::Holds(to)
            }
            Claim::NotAllEmptyAround(paths) => {
                let all = self.output.asm.reg();
                self.output.asm.emit(Inst::Const { to: all, bits: 1 });
                let indices = self.registers.begin_index_loop(&mut self.output.asm);
                let here = self.are_empty(paths);
                self.output.asm.emit(Inst::And { to: all, left: all, right: here });
                self.registers.end_index_loop(&mut self.output.asm, indices);
                Around::Holds(self.not(all))
            }
            // The other claims are about one index.
            _ => Around::Holds(self.output.asm.constant_bool(true)),
        }
    }

    /// A buffer with all these elements, and for a family with all of its members.
    fn all_of(&mut self, names: &[NameId]) -> u16 {
        let to = self.buffer();
        for &name in names {
            match self.registers.home(name) {
                Home::Reg(from) => self.output.asm.emit(Inst::BufferPush { buffer: to, from }),
                Home::Member { buffer: from, .. } => {
                    self.output.asm.emit(Inst::BufferAppend { from, to });
                }
            }
        }
        to
    }

    /// Tests for room for new elements of a kind: `once`, and `each` for every index.
    pub(super) fn room_around(&mut self, kind: Kind, [once, each]: [u16; 2], refusal: u16) {
        let (Some(kind), Some(cycle)) = (kind.element_kind(), self.registers.cycle) else { return };
        if once == 0 && each == 0 {
            return;
        }
        let asm = &mut self.output.asm;
        let mark = asm.mark();
        let count = asm.reg();
        asm.emit(Inst::BufferLength { buffer: cycle, to: count });
        let right = asm.constant_int(i64::from(each));
        asm.emit(Inst::MulInt { to: count, left: count, right });
        let right = asm.constant_int(i64::from(once));
        asm.emit(Inst::AddInt { to: count, left: count, right });
        asm.emit(Inst::ExpectRoomFor { kind, count, refusal, otherwise: self.fail });
        asm.release(mark);
    }
}
