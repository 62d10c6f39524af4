//! Phase 1, collect: bind, test, ask, evaluate. Nothing is written.

use super::collected::{Around, Collected};
use super::output::Output;
use super::registers::{Home, Registers};
use super::{Scope, copy, lower, reason, width};
use crate::check::matching::{Claim, Step};
use crate::diagram::{
    Access, Assignment, Builtin, Drawing, Expr, ExprKind, Kind, LoopKind, NameId, Require,
};
use crate::lower::Guard;
use crate::rewrite::{Cell, Inst, Label, Phase, Reg, Room, Row, Walk};

/// Writes phase 1.
pub(super) struct Collect<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    /// The label to jump to when a test fails: the next attempt, or the next alternative.
    pub fail: Label,
    pub rows: &'r mut Vec<Row>,
}

impl Collect<'_, '_, '_, '_> {
    /// The code of the whole phase.
    pub fn emit(mut self, matching: &[Step], guard: &Guard) -> Collected {
        let drawing = self.drawing;
        let count = drawing.rule.names.len();
        let mut tests = Vec::new();
        for step in matching {
            match step {
                Step::Test(claim) => tests.push(claim),
                step => self.bind(step),
            }
        }
        for path in drawing
            .rule
            .names_of(Kind::Path)
            .filter(|&path| drawing.before.mention(path).is_some())
            .filter(|&path| drawing.rule.is_first(path))
        {
            if let Some(home) = self.registers.home_of_empty(path) {
                self.is_empty(path, home);
            }
        }
        for claim in tests {
            self.test(claim);
        }
        self.requires();
        let mut collected = Collected {
            registers: self.registers.clone(),
            runs: vec![None; count],
            values: Vec::new(),
        };
        let is_guarded = !guard.tests.is_empty();
        if is_guarded {
            collected.runs = self.runs();
            self.guard(guard, &collected);
        }
        collected.values = self.values();
        self.room();
        if !is_guarded {
            collected.runs = self.runs();
        }
        collected
    }

    pub(super) fn row(&mut self, cell: Cell) {
        self.rows.push(Row { cell, executed: true });
    }

    /// The register of an element.
    pub(super) fn element(&mut self, name: NameId) -> Reg {
        self.registers.element(&mut self.output.asm, name)
    }

    /// Appends to a buffer what is computed for each index.
    pub(super) fn for_each_index(&mut self, home: Home, compute: impl FnOnce(&mut Self) -> Reg) {
        let Home::Member { buffer, .. } = home else {
            return;
        };
        self.output.asm.emit(Inst::BufferClear { buffer });
        let indices = self.registers.begin_turns(&mut self.output.asm);
        let from = compute(self);
        self.output.asm.emit(Inst::BufferPush { buffer, from });
        self.registers.end_turns(&mut self.output.asm, indices);
    }

    fn test(&mut self, claim: &Claim) {
        let reason = reason::refusal(self.drawing, claim);
        let refusal = self.output.refusal(reason.clone(), Phase::Match);
        let otherwise = self.fail;
        self.row(Cell::Test { claim: reason::claim(self.drawing, claim), reason });
        let mark = self.output.asm.mark();
        let repeated = claim.is_repeated(self.drawing.rule);
        let indices = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
        let inst = match claim {
            Claim::Leads(source, to) => {
                let left = self.output.asm.reg();
                self.load(*source, left);
                Inst::ExpectEqual {
                    left,
                    right: self.registers.bound(&mut self.output.asm, *to),
                    refusal,
                    otherwise,
                }
            }
            Claim::Distinct(left, right) => {
                let [left, right] = [*left, *right].map(|name| self.element(name));
                Inst::ExpectDistinct { left, right, refusal, otherwise }
            }
            Claim::Kind(face, kind) => {
                let hole = self.output.asm.reg();
                let face = self.element(*face);
                self.output.asm.emit(Inst::LoadHole { to: hole, face });
                let condition = match kind {
                    LoopKind::Hole => hole,
                    LoopKind::Face | LoopKind::Any => self.not(hole),
                };
                Inst::Expect { condition, refusal, otherwise }
            }
            Claim::InOrder { along_loop, halfedges } => {
                let condition = self.output.asm.reg();
                let [from, goal, stop] = halfedges.map(|name| self.element(name));
                let walk = if *along_loop { Walk::Loop } else { Walk::Star };
                self.output.asm.emit(Inst::Meets { walk, to: condition, from, goal, stop });
                Inst::Expect { condition, refusal, otherwise }
            }
            Claim::NotAllEmpty(paths) => {
                let all_empty = self.are_empty(paths);
                Inst::Expect { condition: self.not(all_empty), refusal, otherwise }
            }
            Claim::Listed { halfedge, vertices: [origin, vertex], spokes } => {
                let mut hidden = self.are_one(*origin, *vertex);
                for &spoke in spokes {
                    let listed = self.are_one(*halfedge, spoke);
                    let (left, right) = (hidden, self.not(listed));
                    hidden = self.output.asm.reg();
                    self.output.asm.emit(Inst::And { to: hidden, left, right });
                }
                Inst::Expect { condition: self.not(hidden), refusal, otherwise }
            }
            claim => {
                let condition = match self.around(claim) {
                    Around::Distinct(buffer) => {
                        self.output.asm.emit(Inst::ExpectAllDistinct {
                            buffer,
                            refusal,
                            otherwise,
                        });
                        self.output.asm.release(mark);
                        return;
                    }
                    Around::Holds(condition) => condition,
                };
                Inst::Expect { condition, refusal, otherwise }
            }
        };
        self.output.asm.emit(inst);
        if let Some(indices) = indices {
            self.registers.end_turns(&mut self.output.asm, indices);
        }
        self.output.asm.release(mark);
    }

    /// The condition that all of these paths, which may be empty, are.
    pub(super) fn are_empty(&mut self, paths: &[NameId]) -> Reg {
        let all = self.output.asm.constant_bool(true);
        paths.iter().fold(all, |left, &path| {
            let asm = &mut self.output.asm;
            let Some(right) = self.registers.is_empty(asm, path) else {
                return left;
            };
            let to = asm.reg();
            asm.emit(Inst::And { to, left, right });
            to
        })
    }

    fn are_one(&mut self, left: NameId, right: NameId) -> Reg {
        let [left, right] = [left, right].map(|name| self.element(name));
        let to = self.output.asm.reg();
        self.output.asm.emit(Inst::Equal { to, left, right });
        to
    }

    pub(super) fn not(&mut self, from: Reg) -> Reg {
        let to = self.output.asm.reg();
        self.output.asm.emit(Inst::Not { to, from });
        to
    }

    /// Lowers an expression; its places in the source go to the plan.
    fn expression(&mut self, expr: &Expr) -> Reg {
        self.registers.load_members(&mut self.output.asm, expr);
        let first = self.output.place(expr.span);
        self.registers.number_places_from(first + 1);
        let reg = lower(&mut self.output.asm, &mut self.registers, expr);
        for span in self.registers.take_places() {
            self.output.place(span);
        }
        reg
    }

    fn requires(&mut self) {
        // What holds at index 0 is asked at every index.
        let asked = |require: &&Require| require.index.is_none_or(|index| index == 0);
        for require in self.drawing.rule.requires.iter().filter(asked) {
            let mark = self.output.asm.mark();
            let repeated = require.index.is_some();
            let indices = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
            let condition = self.expression(&require.condition);
            let refusal = self.output.refusal(require.reason.clone(), Phase::Require);
            let otherwise = self.fail;
            self.output.asm.emit(Inst::Expect { condition, refusal, otherwise });
            if let Some(indices) = indices {
                self.registers.end_turns(&mut self.output.asm, indices);
            }
            self.output.asm.release(mark);
            let claim = self.output.words(require.condition.span);
            self.row(Cell::Test { claim, reason: require.reason.clone() });
        }
    }

    fn values(&mut self) -> Vec<Home> {
        let rule = self.drawing.rule;
        let mut values = Vec::new();
        for assignment in &rule.assignments {
            let target = assignment.target.name;
            // What is set at index 0 is set at every index.
            let value = match (rule.is_member(target), rule.is_first(target)) {
                (_, false) => Home::Reg(Reg(0)),
                (false, true) => {
                    let to = self.output.asm.block(width(assignment.value.ty));
                    let mark = self.output.asm.mark();
                    self.value(assignment, to);
                    self.output.asm.release(mark);
                    Home::Reg(to)
                }
                (true, true) => {
                    let buffer = self.buffer();
                    let once = self.computed_once(assignment);
                    let indices = self.registers.begin_turns(&mut self.output.asm);
                    let width = width(assignment.value.ty);
                    let to = self.output.asm.block(width);
                    self.value(&once, to);
                    for part in 0..width {
                        let from = to.part(part);
                        self.output.asm.emit(Inst::BufferPush { buffer, from });
                    }
                    self.registers.end_turns(&mut self.output.asm, indices);
                    Home::Member { buffer, shift: 0 }
                }
            };
            values.push(value);
        }
        values
    }

    /// The assignment with walks that are the same at every index made here, before the indices:
    /// else `centroid(f)` would go around the face at each of its corners.
    fn computed_once(&mut self, assignment: &Assignment) -> Assignment {
        let mut walks = Vec::new();
        assignment.value.each(&mut |part| {
            if self.is_the_same_walk(part) {
                walks.push(part);
            }
        });
        let mut once = assignment.clone();
        // No parameter and no variable of an aggregate has such a number.
        for (number, walk) in (0..u32::MAX).rev().zip(walks) {
            let to = self.output.asm.block(width(walk.ty));
            let mark = self.output.asm.mark();
            let from = self.expression(walk);
            copy(&mut self.output.asm, walk.ty, to, from);
            self.output.asm.release(mark);
            self.registers.declare(number, to);
            once.value.visit_mut(&mut |kind| {
                if *kind == walk.kind {
                    *kind = ExprKind::Local(number);
                }
            });
        }
        once
    }

    /// True if a part of a value walks around single elements of the drawing.
    fn is_the_same_walk(&self, part: &Expr) -> bool {
        use Builtin::{Area, CentroidFace, DegreeFace, DegreeVertex, NormalFace, NormalVertex};
        let single = |argument: &Expr| match argument.kind {
            ExprKind::Element(name) => matches!(self.registers.home(name), Home::Reg(_)),
            _ => false,
        };
        match &part.kind {
            ExprKind::Call(
                Area | CentroidFace | DegreeFace | DegreeVertex | NormalFace | NormalVertex,
                arguments,
            ) => arguments.iter().all(single),
            _ => false,
        }
    }

    fn value(&mut self, assignment: &Assignment, to: Reg) {
        let from = self.expression(&assignment.value);
        copy(&mut self.output.asm, assignment.value.ty, to, from);
        if assignment.attribute != Access::Position {
            return;
        }
        let text = &self.drawing.rule.name(assignment.target.name).text;
        let reason = format!("the new position of `{text}` is not finite");
        let refusal = self.output.refusal(reason, Phase::Evaluate);
        let otherwise = self.fail;
        self.output.asm.emit(Inst::ExpectFinite { vector: to, refusal, otherwise });
    }

    fn room(&mut self) {
        let rule = self.drawing.rule;
        if rule.created.is_empty() {
            return;
        }
        let refusal =
            self.output.refusal("the mesh has no room for more elements".into(), Phase::Evaluate);
        let count = |kind: Kind, members: bool| {
            let created = rule.created.iter().map(|created| created.name);
            let of_kind = created.filter(|&name| {
                rule.kind(name) == kind && rule.is_member(name) == members && rule.is_first(name)
            });
            u16::try_from(of_kind.count()).unwrap_or(u16::MAX)
        };
        if rule.created.iter().any(|created| rule.is_member(created.name)) {
            for kind in [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face] {
                let counts = [count(kind, false), count(kind, true)];
                self.room_around(kind, counts, refusal);
            }
            return;
        }
        let room = Room {
            vertices: count(Kind::Vertex, false),
            halfedges: count(Kind::Halfedge, false),
            edges: count(Kind::Edge, false),
            faces: count(Kind::Face, false),
        };
        self.output.asm.emit(Inst::ExpectRoom { room, refusal, otherwise: self.fail });
    }

    /// A buffer that is empty here: an attempt that failed may have filled it.
    pub(super) fn buffer(&mut self) -> u16 {
        let buffer = self.output.asm.buffer();
        self.output.asm.emit(Inst::BufferClear { buffer });
        buffer
    }
}
