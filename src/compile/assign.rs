//! Phase 3, positions and attributes: what `after` sets them to.

use super::attribute;
use super::reassign::Reassign;
use super::registers::Home;
use super::width;
use crate::diagram::Access;
use crate::rewrite::{Cell, Inst, Reg, Row};

impl Reassign<'_, '_, '_, '_> {
    pub(super) fn assignments(&mut self) {
        let rule = self.drawing.rule;
        for (assignment, &home) in rule.assignments.iter().zip(&self.collected.values) {
            let target = assignment.target.name;
            if !rule.is_first(target) {
                continue;
            }
            let word = rule.attribute(assignment.attribute);
            let text = self.output.words(assignment.value.span);
            self.rows.push(Row {
                cell: Cell::Set { target: format!("{}.{word}", self.word(target)), value: text },
                executed: true,
            });
            self.indexed(rule.is_member(target), |this| {
                let value = this.value(home, width(assignment.value.ty));
                let element = this.element(target);
                let store = match assignment.attribute {
                    Access::Position => Inst::StorePosition { vertex: element, value },
                    Access::Declared(number) => {
                        Inst::StoreAttribute { attribute: attribute(number), element, value }
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
