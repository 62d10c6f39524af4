//! Phase 1, collect: bind, test, ask, evaluate. Nothing is written.

use super::operation::Output;
use super::registers::Registers;
use super::{copy, lower, reason, width};
use crate::check::guard::Obligation;
use crate::check::matching::{Bound, Claim, Source, Step};
use crate::check::{moved_fans, moved_paths};
use crate::diagram::{Access, Drawing, Kind, LoopKind, NameId, Spoke};
use crate::rewrite::{Cell, ElementField, HalfedgeField, Inst, Label, Phase, Reg, Row, Walk};

/// Writes phase 1.
pub(super) struct Collect<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    /// Where to go when a test fails: the next attempt, or the next alternative.
    pub fail: Label,
    pub rows: &'r mut Vec<Row>,
}

/// What phase 1 leaves to the others.
pub(super) struct Collected {
    pub registers: Registers,
    /// For each path that may be empty a bool.
    pub empty: Vec<Option<Reg>>,
    /// For each path and fan that moves, its halfedges.
    pub runs: Vec<Option<u16>>,
    /// The values of the assignments, in order.
    pub values: Vec<Reg>,
}

impl Collect<'_, '_, '_, '_> {
    /// The code of the whole phase.
    pub fn emit(mut self, matching: &[Step], guard: &[Obligation]) -> Collected {
        let drawing = self.drawing;
        let count = drawing.rule.names.len();
        let mut empty = vec![None; count];
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
        {
            if drawing.may_be_empty(path) {
                empty[path.index()] = Some(self.is_empty(path));
            }
        }
        for claim in tests {
            self.test(claim, &empty);
        }
        self.requires();
        let mut collected = Collected {
            registers: self.registers.clone(),
            empty,
            runs: vec![None; count],
            values: Vec::new(),
        };
        let is_guarded = guard.iter().any(Obligation::is_test);
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
        self.rows.push(Row {
            cell,
            executed: true,
        });
    }

    fn bind(&mut self, step: &Step) {
        match step {
            Step::Parameter { name, .. } => {
                let text = &self.drawing.rule.name(*name).text;
                self.row(Cell::Note(format!("{text} is given")));
            }
            Step::Attempt { element, halfedge } => self.attempt(*element, *halfedge),
            Step::Bind { name, source } => {
                let to = self.registers.bound(*name);
                self.load(*source, to);
                let target = reason::bound(self.drawing, *name);
                self.row(Cell::Set {
                    target,
                    value: reason::source(self.drawing, *source),
                });
            }
            Step::Test(_) => {}
        }
    }

    fn load_field(&mut self, field: HalfedgeField, to: Reg, halfedge: Reg) {
        self.output.asm.emit(Inst::Load {
            field,
            to,
            halfedge,
        });
    }

    /// Follows a pointer.
    fn load(&mut self, source: Source, to: Reg) {
        use HalfedgeField::{Edge, Face, Next, Prev, Twin, Vertex};
        let (from, fields): (Bound, &[HalfedgeField]) = match source {
            Source::Next(from) => (from, &[Next]),
            Source::Prev(from) => (from, &[Prev]),
            Source::Twin(from) => (from, &[Twin]),
            Source::Origin(from) => (from, &[Vertex]),
            Source::Target(from) => (from, &[Next, Vertex]),
            Source::Edge(from) => (from, &[Edge]),
            Source::Face(from) => (from, &[Face]),
            Source::Counterclockwise(from) => (from, &[Prev, Twin]),
            Source::Clockwise(from) => (from, &[Twin, Next]),
            Source::FaceHalfedge(face) => {
                let element = self.registers.element(face);
                let of = ElementField::Face;
                return self.output.asm.emit(Inst::LoadHalfedge { of, to, element });
            }
        };
        let mut from = self.registers.bound(from);
        for &field in fields {
            self.load_field(field, to, from);
            from = to;
        }
    }

    /// Begins at one halfedge of an element; a test that fails from here on comes back to
    /// try the next one.
    fn attempt(&mut self, element: NameId, halfedge: NameId) {
        use HalfedgeField::{Next, Prev, Twin};
        let text = self.drawing.rule.name(element).text.clone();
        let (of, around, each): (_, &[HalfedgeField], _) = match self.drawing.rule.kind(element) {
            Kind::Edge => (
                ElementField::Edge,
                &[Twin],
                format!("{text}.halfedge, or its twin"),
            ),
            Kind::Vertex => (
                ElementField::Vertex,
                &[Prev, Twin],
                format!("{text}.halfedge, or another spoke of {text}"),
            ),
            _ => (
                ElementField::Face,
                &[Next],
                format!("{text}.halfedge, or another halfedge of {text}"),
            ),
        };
        let to = self.registers.element(halfedge);
        let start = self.output.asm.reg();
        let element = self.registers.element(element);
        let (begin, again) = (self.output.asm.label(), self.output.asm.label());
        self.output.asm.emit(Inst::LoadHalfedge {
            of,
            to: start,
            element,
        });
        if of == ElementField::Vertex {
            let reason = format!("`{text}` is isolated: no halfedge starts there");
            let refusal = self.output.refusal(reason, Phase::Match);
            let right = self.output.asm.none();
            let otherwise = self.fail;
            self.output.asm.emit(Inst::ExpectDistinct {
                left: start,
                right,
                refusal,
                otherwise,
            });
        }
        self.output.asm.emit(Inst::Copy { to, from: start });
        self.output.asm.emit(Inst::Jump { to: begin });
        self.output.asm.bind(again);
        for &field in around {
            self.load_field(field, to, to);
        }
        self.output.asm.emit(Inst::JumpEqual {
            left: to,
            right: start,
            to: self.fail,
        });
        self.output.asm.bind(begin);
        self.fail = again;
        let target = self.drawing.rule.name(halfedge).text.clone();
        self.row(Cell::Set {
            target,
            value: each,
        });
    }

    fn is_empty(&mut self, path: NameId) -> Reg {
        let to = self.output.asm.reg();
        let next = self
            .drawing
            .before
            .item_after(path)
            .expect("a path of `before` lies in a loop");
        let (left, right) = (self.registers.first(path), self.registers.element(next));
        self.output.asm.emit(Inst::Equal { to, left, right });
        to
    }

    fn test(&mut self, claim: &Claim, empty: &[Option<Reg>]) {
        let reason = reason::refusal(self.drawing, claim);
        let refusal = self.output.refusal(reason.clone(), Phase::Match);
        let otherwise = self.fail;
        self.row(Cell::Test {
            claim: reason::claim(self.drawing, claim),
            reason,
        });
        let mark = self.output.asm.mark();
        let inst = match claim {
            Claim::Leads(source, to) => {
                let left = self.output.asm.reg();
                self.load(*source, left);
                Inst::ExpectEqual {
                    left,
                    right: self.registers.bound(*to),
                    refusal,
                    otherwise,
                }
            }
            Claim::Distinct(left, right) => {
                let [left, right] = [*left, *right].map(|name| self.registers.element(name));
                Inst::ExpectDistinct {
                    left,
                    right,
                    refusal,
                    otherwise,
                }
            }
            Claim::Kind(face, kind) => {
                let hole = self.output.asm.reg();
                let face = self.registers.element(*face);
                self.output.asm.emit(Inst::LoadHole { to: hole, face });
                let condition = match kind {
                    LoopKind::Hole => hole,
                    LoopKind::Face | LoopKind::Any => self.not(hole),
                };
                Inst::Expect {
                    condition,
                    refusal,
                    otherwise,
                }
            }
            Claim::InOrder {
                along_loop,
                halfedges,
            } => {
                let condition = self.output.asm.reg();
                let [from, goal, stop] = halfedges.map(|name| self.registers.element(name));
                let walk = if *along_loop { Walk::Loop } else { Walk::Star };
                self.output.asm.emit(Inst::Meets {
                    walk,
                    to: condition,
                    from,
                    goal,
                    stop,
                });
                Inst::Expect {
                    condition,
                    refusal,
                    otherwise,
                }
            }
            Claim::NotAllEmpty(paths) => {
                let all = self.output.asm.constant_bool(true);
                let all_empty =
                    paths
                        .iter()
                        .filter_map(|path| empty[path.index()])
                        .fold(all, |left, right| {
                            let to = self.output.asm.reg();
                            self.output.asm.emit(Inst::And { to, left, right });
                            to
                        });
                Inst::Expect {
                    condition: self.not(all_empty),
                    refusal,
                    otherwise,
                }
            }
        };
        self.output.asm.emit(inst);
        self.output.asm.release(mark);
    }

    fn not(&mut self, from: Reg) -> Reg {
        let to = self.output.asm.reg();
        self.output.asm.emit(Inst::Not { to, from });
        to
    }

    /// Lowers an expression; its places in the source go to the plan.
    fn expression(&mut self, expr: &crate::diagram::Expr) -> Reg {
        let first = self.output.place(expr.span);
        self.registers.number_places_from(first + 1);
        let reg = lower(&mut self.output.asm, &mut self.registers, expr);
        for span in self.registers.take_places() {
            self.output.place(span);
        }
        reg
    }

    fn requires(&mut self) {
        for require in &self.drawing.rule.requires {
            let mark = self.output.asm.mark();
            let condition = self.expression(&require.condition);
            let refusal = self.output.refusal(require.reason.clone(), Phase::Require);
            let otherwise = self.fail;
            self.output.asm.emit(Inst::Expect {
                condition,
                refusal,
                otherwise,
            });
            self.output.asm.release(mark);
            let claim = self.output.words(require.condition.span);
            self.row(Cell::Test {
                claim,
                reason: require.reason.clone(),
            });
        }
    }

    fn values(&mut self) -> Vec<Reg> {
        let mut values = Vec::new();
        for assignment in &self.drawing.rule.assignments {
            let to = self.output.asm.block(width(assignment.value.ty));
            let mark = self.output.asm.mark();
            let from = self.expression(&assignment.value);
            copy(&mut self.output.asm, assignment.value.ty, to, from);
            if assignment.attribute == Access::Position {
                let text = &self.drawing.rule.name(assignment.target.name).text;
                let reason = format!("the new position of `{text}` is not finite");
                let refusal = self.output.refusal(reason, Phase::Evaluate);
                let otherwise = self.fail;
                self.output.asm.emit(Inst::ExpectFinite {
                    vector: to,
                    refusal,
                    otherwise,
                });
            }
            self.output.asm.release(mark);
            values.push(to);
        }
        values
    }

    fn room(&mut self) {
        let rule = self.drawing.rule;
        if rule.created.is_empty() {
            return;
        }
        let count = |kind: Kind| {
            let of_kind = rule
                .created
                .iter()
                .filter(|created| rule.kind(created.name) == kind)
                .count();
            u16::try_from(of_kind).unwrap_or(u16::MAX)
        };
        let refusal = self.output.refusal(
            "the mesh has no room for more elements".into(),
            Phase::Evaluate,
        );
        self.output.asm.emit(Inst::ExpectRoom {
            vertices: count(Kind::Vertex),
            halfedges: count(Kind::Halfedge),
            edges: count(Kind::Edge),
            faces: count(Kind::Face),
            refusal,
            otherwise: self.fail,
        });
    }

    /// Collects the halfedges of the paths and fans that move, while the mesh is as it was.
    fn runs(&mut self) -> Vec<Option<u16>> {
        let drawing = self.drawing;
        let mut runs = vec![None; drawing.rule.names.len()];
        for path in moved_paths(drawing) {
            runs[path.index()] = Some(self.collect_path(path));
        }
        for fan in moved_fans(drawing) {
            let buffer = self.buffer();
            runs[fan.index()] = Some(buffer);
            self.collect_fan(fan, buffer);
            let text = &drawing.rule.name(fan).text;
            self.row(Cell::Note(format!("collect the spokes of {text}")));
        }
        runs
    }

    /// Collects the halfedges of a path.
    pub(super) fn collect_path(&mut self, path: NameId) -> u16 {
        let buffer = self.buffer();
        let from = self.registers.first(path);
        let next = self
            .drawing
            .before
            .item_after(path)
            .expect("a path of `before` lies in a loop");
        let until = self.registers.element(next);
        let whole = next == path;
        self.output.asm.emit(Inst::Collect {
            walk: Walk::Loop,
            buffer,
            from,
            until,
            whole,
        });
        let text = &self.drawing.rule.name(path).text;
        self.row(Cell::Note(format!("collect the halfedges of {text}")));
        buffer
    }

    /// A buffer that is empty here: an attempt that failed may have filled it.
    fn buffer(&mut self) -> u16 {
        let buffer = self.output.asm.buffer();
        self.output.asm.emit(Inst::BufferClear { buffer });
        buffer
    }

    fn collect_fan(&mut self, fan: NameId, buffer: u16) {
        let vertex = self
            .drawing
            .before
            .star_of_spoke(fan)
            .expect("a fan of `before` lies in a star");
        let star = self
            .drawing
            .before
            .star(vertex)
            .expect("its vertex has a statement");
        let count = star.spokes.len();
        let is_fan = |spoke: &Spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan);
        let at = star
            .spokes
            .iter()
            .position(is_fan)
            .expect("the statement lists the fan");
        let half = |spoke: &Spoke| match spoke {
            Spoke::Halfedge(half) => Some(half.name),
            Spoke::Fan(_) | Spoke::Rest(_) => None,
        };
        let from = self.output.asm.reg();
        let before = half(&star.spokes[(at + count - 1) % count]);
        let after = half(&star.spokes[(at + 1) % count]);
        let walk = Walk::Star;
        let inst = match (before, after) {
            (Some(before), Some(after)) => {
                self.load(Source::Counterclockwise(Bound::Element(before)), from);
                Inst::Collect {
                    walk,
                    buffer,
                    from,
                    until: self.registers.element(after),
                    whole: false,
                }
            }
            // The fan is the whole star.
            _ => {
                let element = self.registers.element(vertex);
                self.output.asm.emit(Inst::LoadHalfedge {
                    of: ElementField::Vertex,
                    to: from,
                    element,
                });
                Inst::Collect {
                    walk,
                    buffer,
                    from,
                    until: from,
                    whole: true,
                }
            }
        };
        self.output.asm.emit(inst);
    }
}
