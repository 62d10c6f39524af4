//! The guard: tests of the result before it is written. All of it belongs to phase 1.
//!
//! Questions that the mesh itself can answer are asked first. Then the pointers of phase 3 are set
//! on a preview, the other tests are made on it, and the preview is undone.

use super::collect::Collect;
use super::collected::{Collected, Run};
use super::reassign::Reassign;
use super::registers::Home;
use super::write_target::WriteTarget;
use crate::diagram::NameId;
use crate::lower::{GuardTest, Operation, PreviewReads, Question};
use crate::mesh::OrbitCondition;
use crate::rewrite::{Cell, Inst, Phase, Question as Query, Reg};

/// The state of a test before the preview.
enum Known {
    /// The register of whether it holds.
    Answer(Reg),
    /// The buffer of the halfedges along which the preview is asked.
    Along(u16),
    /// Nothing yet: the preview is asked for this condition.
    Preview { condition: OrbitCondition, of: NameId, at: Option<NameId> },
}

impl Collect<'_, '_, '_, '_> {
    /// The tests of the guard; `collected` holds what has been collected so far.
    pub(super) fn guard(&mut self, operation: &Operation, collected: &Collected) {
        let mark = self.output.asm.mark();
        let tests = &operation.guard.tests;
        let known: Vec<Known> = tests.iter().map(|test| self.known(test, collected)).collect();
        let fail = self.fail;
        if let Some(reads) = operation.guard.reads {
            self.fail = self.output.asm.label();
            self.preview(operation, collected, reads);
        }
        for (test, known) in tests.iter().zip(known) {
            self.test_result(test, known);
        }
        if operation.guard.reads.is_some() {
            let asm = &mut self.output.asm;
            let on = asm.label();
            asm.emit(Inst::PreviewUndo);
            asm.emit(Inst::Jump { to: on });
            asm.bind(self.fail);
            asm.emit(Inst::PreviewUndo);
            asm.emit(Inst::Jump { to: fail });
            asm.bind(on);
            self.fail = fail;
        }
        self.output.asm.release(mark);
    }

    /// Reads from the mesh what a test needs before the preview.
    fn known(&mut self, test: &GuardTest, collected: &Collected) -> Known {
        match test.question {
            Question::NotAdjacent(ends) => {
                let elements = ends.map(|end| self.element(end));
                let to = self.output.asm.reg();
                self.output.asm.emit(Inst::Ask { question: Query::Adjacent, to, elements });
                Known::Answer(self.not(to))
            }
            Question::OneHoleAlong(path) => {
                let run = collected.runs[path.index()];
                let Run { buffer, .. } = run.unwrap_or_else(|| self.collect_path(path));
                Known::Along(buffer)
            }
            Question::Holds { condition, of, at } => Known::Preview { condition, of, at },
        }
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
        // The rows are shown where the writes are executed.
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

    fn test_result(&mut self, test: &GuardTest, known: Known) {
        let indices =
            test.at_each_index.then(|| self.registers.begin_index_loop(&mut self.output.asm));
        let condition = match known {
            Known::Answer(holds) => holds,
            Known::Along(buffer) => {
                let (condition, to) = (OrbitCondition::OneHole, self.output.asm.reg());
                self.output.asm.emit(Inst::ForeseeAlong { condition, to, buffer });
                to
            }
            Known::Preview { condition, of, at } => {
                let [element, at] = [of, at.unwrap_or(of)].map(|name| self.element(name));
                let to = self.output.asm.reg();
                self.output.asm.emit(Inst::Foresee { condition, to, element, at });
                to
            }
        };
        let refusal = self.output.refusal(test.refusal.clone(), Phase::Guard);
        self.output.asm.emit(Inst::Expect { condition, refusal, otherwise: self.fail });
        if let Some(indices) = indices {
            self.registers.end_index_loop(&mut self.output.asm, indices);
        }
        let claim = format!("after it, {}", test.claim);
        self.row(Cell::Test { claim, reason: test.refusal.clone() });
    }
}
