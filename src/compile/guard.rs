//! The guard: what the checker left to test, asked of the result before it is written.
//!
//! The pointers of phase 3 are set on a sheet over the mesh; then each test looks at one
//! orbit of the preview. All of it belongs to phase 1.

use super::collect::{Collect, Collected};
use super::onto::Onto;
use super::reassign::Reassign;
use super::registers::Home;
use super::run::Run;
use crate::check::guard::{Obligation, Statement};
use crate::diagram::Kind;
use crate::rewrite::{Cell, Foreseen, Inst, Phase, Reg};

impl Collect<'_, '_, '_, '_> {
    /// The tests of the guard; `collected` holds what has been collected so far.
    pub(super) fn guard(&mut self, guard: &[Obligation], collected: &Collected) {
        let mark = self.output.asm.mark();
        self.preview(collected);
        for obligation in guard.iter().filter(|obligation| obligation.is_test()) {
            self.test_statement(&obligation.statement, collected);
        }
        self.output.asm.release(mark);
    }

    fn preview(&mut self, collected: &Collected) {
        let rule = self.drawing.rule;
        self.output.asm.emit(Inst::PreviewClear);
        for name in rule.created.iter().map(|created| created.name) {
            match self.registers.home(name) {
                _ if !rule.is_first(name) => {}
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
            registers: self.registers.clone(),
            collected,
            onto: Onto::Preview,
            rows: &mut rows,
        }
        .emit();
    }

    fn test_statement(&mut self, statement: &Statement, collected: &Collected) {
        let rule = self.drawing.rule;
        // The paths of a family lie in one buffer.
        let repeated =
            statement.is_repeated(rule) && !matches!(statement, Statement::OneHoleAlong(_));
        let turns = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
        let to = self.output.asm.reg();
        let inst = match statement {
            Statement::OneHoleAlong(path) => {
                let condition = Foreseen::OneHole;
                let Run { buffer, .. } = match collected.runs[path.index()] {
                    Some(run) => run,
                    None => self.collect_path(*path),
                };
                Inst::ForeseeAlong { condition, to, buffer }
            }
            statement => {
                let (condition, element, at) = self.question(statement);
                Inst::Foresee { condition, to, element, at }
            }
        };
        self.output.asm.emit(inst);
        let reason = statement.refusal(rule);
        let refusal = self.output.refusal(reason.clone(), Phase::Guard);
        self.output.asm.emit(Inst::Expect { condition: to, refusal, otherwise: self.fail });
        if let Some(turns) = turns {
            self.registers.end_turns(&mut self.output.asm, turns);
        }
        let claim = format!("after it, {}", statement.claim(rule));
        self.row(Cell::Test { claim, reason });
    }

    /// What to ask of which elements.
    fn question(&mut self, statement: &Statement) -> (Foreseen, Reg, Reg) {
        let (condition, element, at) = match statement {
            Statement::ThreeSides(face) => (Foreseen::ThreeSides, face, face),
            Statement::MeetsOnce(face) => (Foreseen::MeetsOnce, face, face),
            Statement::CornerOnce { face, vertex } => (Foreseen::CornerOnce, face, vertex),
            Statement::FacesDiffer { vertex, .. } => (Foreseen::FacesDiffer, vertex, vertex),
            Statement::TwoSpokes(vertex) => (Foreseen::TwoSpokes, vertex, vertex),
            Statement::OneHole { vertex, .. } => (Foreseen::OneHole, vertex, vertex),
            Statement::OneHoleAlong(path) => (Foreseen::OneHole, path, path),
            Statement::NeighborsDiffer { vertex, .. } => {
                (Foreseen::NeighborsDiffer, vertex, vertex)
            }
            Statement::SingleEdge { halfedge, .. } => (Foreseen::SingleEdge, halfedge, halfedge),
            Statement::CornersDiffer(vertex) => (Foreseen::CornersDiffer, vertex, vertex),
            Statement::CornersOwn { face, vertex } => (Foreseen::CornersOwn, face, vertex),
        };
        debug_assert!(self.drawing.rule.kind(*element) != Kind::Fan);
        let [element, at] = [element, at].map(|name| self.element(*name));
        (condition, element, at)
    }
}
