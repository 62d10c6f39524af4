//! The guard: what the checker left to test, asked of the result before it is written.
//!
//! The pointers of phase 3 are set on a preview of the mesh, as far as tests look at them; then
//! each test looks at one orbit of the preview; then all is put back. A test that the mesh itself
//! can answer is asked of it before: whether another edge joins two vertices, where no edge leaves
//! them. All of it belongs to phase 1.

use super::collect::Collect;
use super::collected::{Collected, Run};
use super::reassign::Reassign;
use super::registers::Home;
use super::write_target::{Looks, Onto};
use crate::check::guard::{Obligation, Statement};
use crate::diagram::{Kind, NameId};
use crate::rewrite::{Cell, Foreseen, Inst, Phase, Question, Reg};

/// A test, and what it asks.
struct Asked<'g> {
    statement: &'g Statement,
    of: Of,
}

/// What a test asks.
enum Of {
    /// The mesh, before: the register that says whether it holds.
    Mesh(Reg),
    /// The preview, where the halfedges of a buffer start.
    Along(u16),
    /// The preview.
    Preview,
}

impl Collect<'_, '_, '_, '_> {
    /// The tests of the guard; `collected` holds what has been collected so far.
    pub(super) fn guard(&mut self, guard: &[Obligation], collected: &Collected) {
        let mark = self.output.asm.mark();
        let tests = guard.iter().filter(|obligation| obligation.is_test());
        let tests: Vec<Asked> =
            tests.map(|obligation| self.asked(&obligation.statement, collected)).collect();
        let foreseen = || {
            let of = |test: &Asked| !matches!(test.of, Of::Mesh(_));
            tests.iter().filter(move |test| of(test)).map(|test| test.statement)
        };
        let is_ahead = foreseen().next().is_some();
        let fail = self.fail;
        if is_ahead {
            self.fail = self.output.asm.label();
            self.preview(collected, Looks::of_all(foreseen()));
        }
        for test in &tests {
            self.test_statement(test);
        }
        if is_ahead {
            let on = self.output.asm.label();
            self.output.asm.emit(Inst::PreviewUndo);
            self.output.asm.emit(Inst::Jump { to: on });
            self.output.asm.bind(self.fail);
            self.output.asm.emit(Inst::PreviewUndo);
            self.output.asm.emit(Inst::Jump { to: fail });
            self.output.asm.bind(on);
            self.fail = fail;
        }
        self.output.asm.release(mark);
    }

    /// What can be known of a test before the preview: all that the mesh itself is asked.
    fn asked<'g>(&mut self, statement: &'g Statement, collected: &Collected) -> Asked<'g> {
        let of = match statement {
            Statement::OneHoleAlong(path) => {
                let run = collected.runs[path.index()];
                let Run { buffer, .. } = run.unwrap_or_else(|| self.collect_path(*path));
                Of::Along(buffer)
            }
            statement => match self.joined(statement) {
                Some(ends) => {
                    let elements = ends.map(|end| self.element(end));
                    let to = self.output.asm.reg();
                    self.output.asm.emit(Inst::Ask { question: Question::Adjacent, to, elements });
                    Of::Mesh(self.not(to))
                }
                None => Of::Preview,
            },
        };
        Asked { statement, of }
    }

    /// Two vertices that would be joined twice exactly if they are joined now: the test asks for
    /// a second edge between them, no edge that is drawn joins them before, and after it only the
    /// one that is asked about; edges that are not drawn end where they did.
    fn joined(&self, test: &Statement) -> Option<[NameId; 2]> {
        let Statement::SingleEdge { halfedge, .. } = *test else {
            return None;
        };
        let (drawing, rule) = (self.drawing, self.drawing.rule);
        let ends = [drawing.origin_after(halfedge)?, drawing.target_after(halfedge)?];
        let are_drawn = ends.iter().all(|&end| drawing.before.mention(end).is_some());
        let names = || (0..rule.names.len() as u32).map(NameId);
        let is_plain = rule.aliases.is_empty()
            && names().all(|name| rule.kind(name) != Kind::Fan && !rule.is_member(name));
        if ends[0] == ends[1] || !are_drawn || !is_plain {
            return None;
        }
        let joins = |[from, to]: [NameId; 2]| [from, to] == ends || [to, from] == ends;
        for other in rule.names_of(Kind::Halfedge) {
            if drawing.before.mention(other).is_some() {
                let before = [drawing.origin_before(other)?, drawing.target_before(other)?];
                if joins(before) {
                    return None;
                }
            }
            if drawing.after.mention(other).is_some() {
                let after = [drawing.origin_after(other)?, drawing.target_after(other)?];
                let is_asked = other == halfedge || drawing.after.twin(other) == Some(halfedge);
                if joins(after) && !is_asked {
                    return None;
                }
            }
        }
        Some(ends)
    }

    fn preview(&mut self, collected: &Collected, looks: Looks) {
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
            onto: Onto::Preview(looks),
            rows: &mut rows,
        }
        .emit();
    }

    fn test_statement(&mut self, test: &Asked) {
        let (rule, statement) = (self.drawing.rule, test.statement);
        // The paths of a family lie in one buffer.
        let repeated = statement.is_repeated(rule) && !matches!(test.of, Of::Along(_));
        let indices = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
        let holds = match test.of {
            Of::Mesh(holds) => holds,
            Of::Along(buffer) => {
                let (condition, to) = (Foreseen::OneHole, self.output.asm.reg());
                self.output.asm.emit(Inst::ForeseeAlong { condition, to, buffer });
                to
            }
            Of::Preview => {
                let (condition, element, at) = self.question(statement);
                let to = self.output.asm.reg();
                self.output.asm.emit(Inst::Foresee { condition, to, element, at });
                to
            }
        };
        let reason = statement.refusal(rule);
        let refusal = self.output.refusal(reason.clone(), Phase::Guard);
        self.output.asm.emit(Inst::Expect { condition: holds, refusal, otherwise: self.fail });
        if let Some(indices) = indices {
            self.registers.end_turns(&mut self.output.asm, indices);
        }
        let claim = format!("after it, {}", statement.claim(rule));
        self.row(Cell::Test { claim, reason });
    }

    /// The questions, each with its elements.
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
