//! The guard: tests of the result before it is written. All of it belongs to phase 1.

use super::collect::Collect;
use super::collected::{Collected, Run};
use super::reassign::Reassign;
use super::registers::Home;
use super::write_target::WriteTarget;
use crate::lower::{GuardCondition, GuardTest, Operation, PreviewReads, Question};
use crate::rewrite::{Cell, Foreseen, Inst, Phase, Question as Query};

impl Collect<'_, '_, '_, '_> {
    /// The tests of the guard; `collected` holds what has been collected so far.
    pub(super) fn guard(&mut self, operation: &Operation, collected: &Collected) {
        let mark = self.output.asm.mark();
        if let Some(reads) = operation.guard.reads {
            self.preview(operation, collected, reads);
        }
        for test in &operation.guard.tests {
            self.test_result(test, collected);
        }
        self.output.asm.release(mark);
    }

    fn preview(&mut self, operation: &Operation, collected: &Collected, reads: PreviewReads) {
        self.output.asm.emit(Inst::PreviewClear);
        for element in &operation.created {
            match self.registers.home(element.name) {
                Home::Reg(to) => self.output.asm.emit(Inst::PreviewNew { to }),
                home => self.for_each_index(home, |this| {
                    let to = this.output.asm.reg();
                    this.output.asm.emit(Inst::PreviewNew { to });
                    to
                }),
            }
        }
        // They are shown where they are executed.
        let mut rows = Vec::new();
        Reassign {
            output: self.output,
            drawing: self.drawing,
            values: &operation.values,
            registers: self.registers.clone(),
            collected,
            target: WriteTarget::Preview(reads),
            rows: &mut rows,
        }
        .emit();
    }

    fn test_result(&mut self, test: &GuardTest, collected: &Collected) {
        let indices =
            test.at_each_index.then(|| self.registers.begin_index_loop(&mut self.output.asm));
        let to = self.output.asm.reg();
        match test.question {
            Question::NotAdjacent(ends) => {
                let elements = ends.map(|end| self.element(end));
                self.output.asm.emit(Inst::Ask { question: Query::Adjacent, to, elements });
                self.output.asm.emit(Inst::Not { to, from: to });
            }
            Question::Holds { condition, of, at } => {
                let [element, at] = [of, at.unwrap_or(of)].map(|name| self.element(name));
                let condition = foreseen(condition);
                self.output.asm.emit(Inst::Foresee { condition, to, element, at });
            }
            Question::OneHoleAlong(path) => {
                let Run { buffer, .. } = match collected.runs[path.index()] {
                    Some(run) => run,
                    None => self.collect_path(path),
                };
                let condition = Foreseen::OneHole;
                self.output.asm.emit(Inst::ForeseeAlong { condition, to, buffer });
            }
        }
        let refusal = self.output.refusal(test.refusal.clone(), Phase::Guard);
        self.output.asm.emit(Inst::Expect { condition: to, refusal, otherwise: self.fail });
        if let Some(indices) = indices {
            self.registers.end_index_loop(&mut self.output.asm, indices);
        }
        let claim = format!("after it, {}", test.claim);
        self.row(Cell::Test { claim, reason: test.refusal.clone() });
    }
}

/// The question of the machine for a condition.
fn foreseen(condition: GuardCondition) -> Foreseen {
    match condition {
        GuardCondition::ThreeSides => Foreseen::ThreeSides,
        GuardCondition::MeetsOnce => Foreseen::MeetsOnce,
        GuardCondition::CornerOnce => Foreseen::CornerOnce,
        GuardCondition::TwoSpokes => Foreseen::TwoSpokes,
        GuardCondition::OneHole => Foreseen::OneHole,
        GuardCondition::FacesDiffer => Foreseen::FacesDiffer,
        GuardCondition::NeighborsDiffer => Foreseen::NeighborsDiffer,
        GuardCondition::SingleEdge => Foreseen::SingleEdge,
        GuardCondition::CornersDiffer => Foreseen::CornersDiffer,
        GuardCondition::CornersOwn => Foreseen::CornersOwn,
    }
}
