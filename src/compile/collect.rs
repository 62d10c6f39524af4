//! Phase 1, collect: bind, test, ask, evaluate. Nothing is written.

use super::collected::{Around, Collected};
use super::output::Output;
use super::registers::{Home, Registers};
use super::{Scope, copy, lower, width};
use crate::check::matching::Claim;
use crate::diagram::{Drawing, Expr, Kind, LoopKind, NameId};
use crate::lower::{Condition, Element, Hoisted, Matching, Operation, Test, Value, hoist};
use crate::rewrite::{Cell, Inst, Label, Phase, Reg, Room, Row, Walk};

/// Writes phase 1.
pub(super) struct Collect<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    /// The label to jump to when a test fails: the next attempt, or the next alternative.
    pub fail: Label,
    /// The same for a new value, if it is another one.
    pub fail_of_values: Option<Label>,
    pub rows: &'r mut Vec<Row>,
}

impl Collect<'_, '_, '_, '_> {
    /// The code of the whole phase.
    pub fn emit(mut self, operation: &Operation) -> Collected {
        let Matching { steps, empty_paths, tests } = &operation.matching;
        steps.iter().for_each(|step| self.bind(step));
        empty_paths.iter().for_each(|path| self.is_empty(*path));
        tests.iter().for_each(|test| self.test(test));
        self.requires(&operation.requires);
        let mut collected = Collected {
            registers: self.registers.clone(),
            runs: vec![None; self.drawing.rule.names.len()],
            values: Vec::new(),
        };
        let is_guarded = !operation.guard.tests.is_empty();
        if is_guarded {
            collected.runs = self.runs();
            self.guard(operation, &collected);
        }
        self.fail = self.fail_of_values.unwrap_or(self.fail);
        collected.values = self.values(&operation.values);
        self.room(&operation.created);
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
        let Home::Member { buffer, .. } = home else { return };
        self.output.asm.emit(Inst::BufferClear { buffer });
        let indices = self.registers.begin_index_loop(&mut self.output.asm);
        let from = compute(self);
        self.output.asm.emit(Inst::BufferPush { buffer, from });
        self.registers.end_index_loop(&mut self.output.asm, indices);
    }

    fn test(&mut self, test: &Test) {
        let refusal = self.output.refusal(test.refusal.clone(), Phase::Match);
        let otherwise = self.fail;
        self.row(Cell::Test { claim: test.claim.clone(), reason: test.refusal.clone() });
        let mark = self.output.asm.mark();
        let indices =
            test.at_each_index.then(|| self.registers.begin_index_loop(&mut self.output.asm));
        let inst = match &test.condition {
            Claim::Leads(source, to) => {
                let left = self.output.asm.reg();
                self.load(*source, left);
                let right = self.registers.bound(&mut self.output.asm, *to);
                Inst::ExpectEqual { left, right, refusal, otherwise }
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
            claim => match self.around(claim) {
                Around::Distinct(buffer) => Inst::ExpectAllDistinct { buffer, refusal, otherwise },
                Around::Holds(condition) => Inst::Expect { condition, refusal, otherwise },
            },
        };
        self.output.asm.emit(inst);
        if let Some(indices) = indices {
            self.registers.end_index_loop(&mut self.output.asm, indices);
        }
        self.output.asm.release(mark);
    }

    /// The register of whether all of these paths, each of which may be empty, are empty.
    pub(super) fn are_empty(&mut self, paths: &[NameId]) -> Reg {
        let all = self.output.asm.constant_bool(true);
        paths.iter().fold(all, |left, &path| {
            let asm = &mut self.output.asm;
            let Some(right) = self.registers.is_empty(asm, path) else { return left };
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

    fn requires(&mut self, requires: &[Condition]) {
        for Condition { condition, at_each_index, refusal } in requires {
            let mark = self.output.asm.mark();
            let hoisted = self.hoisted(condition, *at_each_index);
            let indices =
                at_each_index.then(|| self.registers.begin_index_loop(&mut self.output.asm));
            let holds = self.expression(&hoisted);
            let reason = (*refusal).to_owned();
            let refusal = self.output.refusal(reason.clone(), Phase::Require);
            let otherwise = self.fail;
            self.output.asm.emit(Inst::Expect { condition: holds, refusal, otherwise });
            if let Some(indices) = indices {
                self.registers.end_index_loop(&mut self.output.asm, indices);
            }
            self.output.asm.release(mark);
            let claim = self.output.words(condition.span);
            self.row(Cell::Test { claim, reason });
        }
    }

    fn values(&mut self, values: &[Value]) -> Vec<Home> {
        let values = values.iter().map(|value| {
            let width = width(value.value.ty);
            if !value.at_each_index {
                let to = self.output.asm.block(width);
                let mark = self.output.asm.mark();
                self.value(value, value.value, to);
                self.output.asm.release(mark);
                return Home::Reg(to);
            }
            let buffer = self.buffer();
            let hoisted = self.hoisted(value.value, true);
            let indices = self.registers.begin_index_loop(&mut self.output.asm);
            let to = self.output.asm.block(width);
            self.value(value, &hoisted, to);
            for part in 0..width {
                let from = to.part(part);
                self.output.asm.emit(Inst::BufferPush { buffer, from });
            }
            self.registers.end_index_loop(&mut self.output.asm, indices);
            Home::Member { buffer, shift: 0 }
        });
        values.collect()
    }

    /// Computes the parts of an expression that are the same at every index; the expression in
    /// terms of them.
    fn hoisted(&mut self, expr: &Expr, at_each_index: bool) -> Expr {
        if !at_each_index {
            return expr.clone();
        }
        let Hoisted { parts, rest } = hoist(expr, true, Some(self.drawing.rule), true);
        for (number, part) in &parts {
            let to = self.output.asm.block(width(part.ty));
            let mark = self.output.asm.mark();
            let from = self.expression(part);
            copy(&mut self.output.asm, part.ty, to, from);
            self.output.asm.release(mark);
            self.registers.declare(*number, to);
        }
        rest
    }

    fn value(&mut self, value: &Value, expr: &Expr, to: Reg) {
        let from = self.expression(expr);
        copy(&mut self.output.asm, expr.ty, to, from);
        if let Some(reason) = &value.infinite {
            let refusal = self.output.refusal(reason.clone(), Phase::Evaluate);
            let otherwise = self.fail;
            self.output.asm.emit(Inst::ExpectFinite { vector: to, refusal, otherwise });
        }
    }

    fn room(&mut self, created: &[Element]) {
        if created.is_empty() {
            return;
        }
        let refusal =
            self.output.refusal("the mesh has no room for more elements".into(), Phase::Evaluate);
        let count = |kind: Kind, at_each_index: bool| {
            let of_kind = created
                .iter()
                .filter(|element| element.kind == kind && element.at_each_index == at_each_index);
            u16::try_from(of_kind.count()).unwrap_or(u16::MAX)
        };
        if created.iter().any(|element| element.at_each_index) {
            for kind in [Kind::Vertex, Kind::Halfedge, Kind::Edge, Kind::Face] {
                self.room_around(kind, [count(kind, false), count(kind, true)], refusal);
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

    /// A buffer, cleared here: a failed attempt may have filled it.
    pub(super) fn buffer(&mut self) -> u16 {
        let buffer = self.output.asm.buffer();
        self.output.asm.emit(Inst::BufferClear { buffer });
        buffer
    }
}
