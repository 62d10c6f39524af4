//! Phase 1, bind: from the parameters to every name, pointer by pointer.

use super::collect::Collect;
use super::expression::{element_field, halfedge_field};
use super::registers::Home;
use crate::check::matching::{Bound, Source};
use crate::diagram::{Kind, NameId};
use crate::lower::{Begin, EmptyPath, Step, Tries, bound_word, source_word};
use crate::rewrite::{Cell, HalfedgeField, Inst, Phase, Reg};

impl Collect<'_, '_, '_, '_> {
    /// Binds a name, or begins an attempt.
    pub(super) fn bind(&mut self, step: &Step) {
        match step {
            Step::Given(name) => {
                let text = &self.drawing.rule.name(*name).text;
                self.row(Cell::Note { text: format!("{text} is given") });
            }
            Step::Begin(begin) => self.attempt(begin),
            Step::Walk(walk) => self.walk(walk),
            Step::Bind { bound, source, .. } => {
                match self.registers.home_of(*bound) {
                    Home::Reg(to) => self.load(*source, to),
                    home => self.for_each_index(home, |this| {
                        let to = this.output.asm.reg();
                        this.load(*source, to);
                        to
                    }),
                }
                let target = bound_word(self.drawing, *bound);
                self.row(Cell::Set { target, value: source_word(self.drawing, *source) });
            }
        }
    }

    fn load_field(&mut self, field: HalfedgeField, to: Reg, halfedge: Reg) {
        self.output.asm.emit(Inst::Load { field, to, halfedge });
    }

    /// Follows pointers.
    pub(super) fn load(&mut self, source: Source, to: Reg) {
        let mut from = self.registers.bound(&mut self.output.asm, source.from);
        for &pointer in source.pointers() {
            self.load_field(halfedge_field(pointer), to, from);
            from = to;
        }
    }

    /// Begins at one halfedge of an element; a test that fails from here on jumps back to try the
    /// next one.
    fn attempt(&mut self, begin: &Begin) {
        let of = element_field(begin.first).expect("it is the halfedge of an element");
        let to = match self.registers.home(begin.halfedge) {
            Home::Reg(to) => to,
            Home::Member { .. } => self.registers.begin(&mut self.output.asm, begin.halfedge),
        };
        let start = self.output.asm.reg();
        let element = self.element(begin.element);
        self.output.asm.emit(Inst::LoadHalfedge { of, to: start, element });
        if let Some(reason) = &begin.isolated {
            let refusal = self.output.refusal(reason.clone(), Phase::Match);
            let right = self.output.asm.none();
            let otherwise = self.fail;
            self.output.asm.emit(Inst::ExpectDistinct { left: start, right, refusal, otherwise });
        }
        self.output.asm.emit(Inst::Copy { to, from: start });
        // One try needs no counting: if it fails, all have failed.
        match begin.tries {
            Tries::Some(1) => {}
            Tries::AllForValues => {
                let fail = self.fail;
                self.try_again(begin, to, start);
                self.fail_of_values = Some(std::mem::replace(&mut self.fail, fail));
            }
            Tries::All | Tries::Some(_) => self.try_again(begin, to, start),
        }
        // A halfedge, or the first of a path.
        let bound = match self.drawing.rule.kind(begin.halfedge) {
            Kind::Path => Bound::First(begin.halfedge),
            _ => Bound::Element(begin.halfedge),
        };
        let target = bound_word(self.drawing, bound);
        self.row(Cell::Set { target, value: begin.claim.clone() });
    }

    /// The retry: goes on to the next halfedge, until that is the first one again or all tries are
    /// used.
    fn try_again(&mut self, begin: &Begin, to: Reg, start: Reg) {
        let (first, again) = (self.output.asm.label(), self.output.asm.label());
        let tried = match begin.tries {
            Tries::Some(most) => Some((most, self.output.asm.reg())),
            Tries::All | Tries::AllForValues => None,
        };
        if let Some((_, to)) = tried {
            self.output.asm.emit(Inst::Const { to, bits: 1 });
        }
        self.output.asm.emit(Inst::Jump { to: first });
        self.output.asm.bind(again);
        if let Some((most, tried)) = tried {
            let all = self.output.asm.constant_int(i64::from(most));
            self.output.asm.emit(Inst::JumpEqual { left: tried, right: all, to: self.fail });
            let one = self.output.asm.constant_int(1);
            self.output.asm.emit(Inst::AddInt { to: tried, left: tried, right: one });
        }
        for &pointer in begin.step {
            self.load_field(halfedge_field(pointer), to, to);
        }
        self.output.asm.emit(Inst::JumpEqual { left: to, right: start, to: self.fail });
        self.output.asm.bind(first);
        self.fail = again;
    }

    /// Computes whether a path is empty: it is if its first halfedge is what follows it.
    pub(super) fn is_empty(&mut self, EmptyPath { path, next, .. }: EmptyPath) {
        let Some(home) = self.registers.home_of_empty(path) else { return };
        let compare = |this: &mut Self, to: Reg| {
            let [left, right] = [path, next].map(|name: NameId| this.element(name));
            this.output.asm.emit(Inst::Equal { to, left, right });
        };
        match home {
            Home::Reg(to) => compare(self, to),
            home => self.for_each_index(home, |this| {
                let to = this.output.asm.reg();
                compare(this, to);
                to
            }),
        }
    }
}
