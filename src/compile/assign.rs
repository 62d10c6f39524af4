//! Phase 3, positions and attributes: what `after` sets them to.

use super::reassign::Reassign;
use super::registers::Home;
use super::{narrow, width};
use crate::diagram::Access;
use crate::rewrite::{Cell, Inst, Reg, Row};

impl Reassign<'_, '_, '_, '_> {
    pub(super) fn assignments(&mut self) {
        for (set, &home) in self.values.iter().zip(&self.collected.values) {
            let word = self.drawing.rule.attribute(set.attribute);
            let text = self.output.words(set.value.span);
            let target = format!("{}.{word}", self.word(set.element));
            self.rows.push(Row { cell: Cell::Set { target, value: text }, executed: true });
            self.indexed(set.at_each_index, |this| {
                let value = this.value(home, width(set.value.ty));
                let element = this.element(set.element);
                let store = match set.attribute {
                    Access::Position => Inst::StorePosition { vertex: element, value },
                    Access::Declared(number) => {
                        Inst::StoreAttribute { attribute: narrow(number), element, value }
                    }
                };
                this.output.asm.emit(store);
            });
        }
    }

    /// The value of an assignment.
    fn value(&mut self, home: Home, width: u16) -> Reg {
        match (home, self.registers.index()) {
            (Home::Reg(value), _) => value,
            (Home::Member { buffer, .. }, index) => {
                let index = index.unwrap_or_else(|| self.output.asm.constant_int(0));
                let to = self.output.asm.block(width);
                self.output.asm.emit(Inst::BufferGetWide { buffer, index, width, to });
                to
            }
        }
    }
}
