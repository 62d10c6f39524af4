//! Phase 3, reassign: every pointer of every named element.

use super::collect::Collected;
use super::operation::Output;
use super::registers::Registers;
use super::run::Run;
use super::write_target::Onto;
use crate::check::matching::Bound;
use crate::diagram::{Drawing, Edge, Kind, Loop, LoopItem, LoopKind, NameId};
use crate::rewrite::{Cell, ElementField, HalfedgeField, Inst, Reg, Row, Span};

/// Writes phase 3.
pub(super) struct Reassign<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    pub collected: &'d Collected,
    /// The place where the pointers are set.
    pub onto: Onto,
    pub rows: &'r mut Vec<Row>,
}

impl Reassign<'_, '_, '_, '_> {
    /// The code of the whole phase. All that is stored has been loaded before the first
    /// store: the selects in between read registers only.
    pub fn emit(mut self) {
        let rule = self.drawing.rule;
        let first = |orbit: &&Loop| rule.is_first(orbit.face.name);
        for orbit in rule.after.loops.iter().filter(first) {
            match orbit.each {
                true => self.orbit_around(orbit),
                false => self.for_each(orbit.face.name, |this| this.orbit(orbit)),
            }
        }
        let first = |edge: &&Edge| rule.is_first(edge.edge.name);
        for edge in rule.after.edges.iter().filter(first) {
            self.for_each(edge.edge.name, |this| this.edge(edge));
        }
        self.outer_origins();
        self.fans();
        self.vertices();
        self.assignments();
    }

    pub(super) fn word(&self, name: NameId) -> &str {
        &self.drawing.rule.name(name).text
    }

    pub(super) fn element(&mut self, name: NameId) -> Reg {
        self.registers.element(&mut self.output.asm, name)
    }

    /// Does something about a name: of a family, for each index.
    pub(super) fn for_each(&mut self, name: NameId, what: impl FnOnce(&mut Self)) {
        let repeated = self.drawing.rule.is_member(name);
        let indices = repeated.then(|| self.registers.begin_turns(&mut self.output.asm));
        what(self);
        if let Some(indices) = indices {
            self.registers.end_turns(&mut self.output.asm, indices);
        }
    }

    pub(super) fn is_path(&self, item: NameId) -> bool {
        self.drawing.rule.kind(item) == Kind::Path
    }

    pub(super) fn set(&mut self, target: String, value: String, inst: Option<Inst>) {
        self.rows.push(Row::set(target, value, inst.is_some()));
        if let Some(inst) = inst.and_then(|inst| self.onto.aim(inst)) {
            self.output.asm.emit(inst);
        }
    }

    /// The `halfedge` of a vertex, an edge or a face. One that is kept is as it was: that need
    /// not be the halfedge that would be set.
    pub(super) fn anchor(&mut self, element: NameId, value: String, store: Inst, keeps: bool) {
        let target = format!("{}.halfedge", self.word(element));
        match keeps {
            true => self.set(target, Cell::AS_IT_WAS.into(), None),
            false => self.set(target, value, Some(store)),
        }
    }

    /// A row `x.pointer = value`; executed unless nothing changes.
    fn pointer(&mut self, field: HalfedgeField, halfedge: NameId, value: NameId, changed: bool) {
        let pointer = match field {
            HalfedgeField::Next => "next",
            HalfedgeField::Prev => "prev",
            HalfedgeField::Twin => "twin",
            HalfedgeField::Vertex => "vertex",
            HalfedgeField::Edge => "edge",
            HalfedgeField::Face => "face",
        };
        let target = format!("{}.{pointer}", self.word(halfedge));
        let text = self.word(value).to_string();
        let (halfedge, value) = (self.element(halfedge), self.element(value));
        self.set(target, text, changed.then_some(Inst::Store { field, halfedge, value }));
    }

    /// The register of the first halfedge from the item at `at` on: its own, or if it is
    /// an empty path, that of what follows.
    pub(super) fn head(&mut self, items: &[NameId], at: usize) -> Reg {
        self.end_of(items, at, 1, Bound::First)
    }

    /// The register of the last halfedge up to the item at `at`.
    pub(super) fn tail(&mut self, items: &[NameId], at: usize) -> Reg {
        self.end_of(items, at, items.len() - 1, Bound::Last)
    }

    fn end_of(
        &mut self,
        items: &[NameId],
        at: usize,
        step: usize,
        end: impl Fn(NameId) -> Bound,
    ) -> Reg {
        let count = items.len();
        let places = (0..count).map(|turn| items[(at + turn * step) % count]);
        let mut ends: Vec<(Reg, Option<Reg>)> = Vec::new();
        for item in places {
            let bound = match self.is_path(item) {
                true => end(item),
                false => Bound::Element(item),
            };
            let asm = &mut self.output.asm;
            let empty = self.registers.is_empty(asm, item);
            ends.push((self.registers.bound(asm, bound), empty));
            if empty.is_none() {
                break;
            }
        }
        let (mut reg, _) = ends.pop().expect("a loop has items");
        while let Some((then, empty)) = ends.pop() {
            let condition = empty.expect("only paths that may be empty lead on");
            let to = self.output.asm.reg();
            self.output.asm.emit(Inst::Select { to, condition, then: reg, otherwise: then });
            reg = to;
        }
        reg
    }

    fn orbit(&mut self, orbit: &Loop) {
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        let count = items.len();
        let ends: Vec<_> =
            (0..count).map(|at| (self.head(&items, at), self.tail(&items, at))).collect();
        for at in 0..count {
            self.item(orbit, at, ends[at].1, ends[(at + 1) % count].0);
        }
        self.face_halfedge(orbit, ends[0].0);
        self.face_kind(orbit);
    }

    /// The pointers of one item, given its end and the beginning of the next.
    pub(super) fn item(&mut self, orbit: &Loop, at: usize, tail: Reg, head: Reg) {
        let drawing = self.drawing;
        let face = orbit.face.name;
        let count = orbit.items.len();
        let item = &orbit.items[at % count];
        let (name, next) = (item.item.name, orbit.items[(at + 1) % count].item.name);
        let same = drawing.before.item_after(name) == Some(next);
        self.link(name, next, tail, head, !same);
        self.lies_in(item, face);
    }

    /// The origin and the face of one item.
    pub(super) fn lies_in(&mut self, item: &LoopItem, face: NameId) {
        let drawing = self.drawing;
        let name = item.item.name;
        if self.is_path(name) {
            self.path_face(name, face);
            return;
        }
        let origin = item.from.name;
        self.pointer(
            HalfedgeField::Vertex,
            name,
            origin,
            drawing.before.loop_origin(name) != Some(origin),
        );
        self.pointer(HalfedgeField::Face, name, face, drawing.before.face(name) != Some(face));
    }

    /// `next` of what ends one item, `prev` of what begins the next.
    pub(super) fn link(&mut self, item: NameId, next: NameId, tail: Reg, head: Reg, changed: bool) {
        let last = if self.is_path(item) {
            format!("last({})", self.word(item))
        } else {
            self.word(item).into()
        };
        let first = if self.is_path(next) {
            format!("first({})", self.word(next))
        } else {
            self.word(next).into()
        };
        let (field, other) = (HalfedgeField::Next, HalfedgeField::Prev);
        let store = changed.then_some(Inst::Store { field, halfedge: tail, value: head });
        self.set(format!("{last}.next"), first.clone(), store);
        let store = changed.then_some(Inst::Store { field: other, halfedge: head, value: tail });
        self.set(format!("{first}.prev"), last, store);
    }

    fn path_face(&mut self, path: NameId, face: NameId) {
        let target = format!("face along {}", self.word(path));
        let store = self.store_run(HalfedgeField::Face, path, face);
        self.set(target, self.word(face).into(), store);
    }

    /// Sets a pointer of every halfedge of a run, if it was collected.
    pub(super) fn store_run(
        &mut self,
        field: HalfedgeField,
        run: NameId,
        value: NameId,
    ) -> Option<Inst> {
        let rule = self.drawing.rule;
        let Run { buffer, ends } = self.collected.runs[rule.first_member(run).index()]?;
        let value = self.element(value);
        Some(match (ends, self.registers.index()) {
            (Some(ends), Some(index)) => Inst::StoreSpan {
                field,
                span: Span { buffer, ends, shift: i16::try_from(rule.offset(run)).unwrap_or(0) },
                index,
                value,
            },
            _ => Inst::StoreAll { field, buffer, value },
        })
    }

    /// A face keeps its halfedge as long as nothing has left its loop.
    pub(super) fn face_halfedge(&mut self, orbit: &Loop, head: Reg) {
        let drawing = self.drawing;
        let face = orbit.face.name;
        let keeps = drawing.before.loop_of_face(face).is_some_and(|before| {
            before.items.iter().all(|item| drawing.after.face(item.item.name) == Some(face))
        });
        let first = orbit.items[0].item.name;
        let value = if self.is_path(first) {
            format!("first({})", self.word(first))
        } else {
            self.word(first).into()
        };
        let store = Inst::StoreHalfedge {
            of: ElementField::Face,
            element: self.element(face),
            value: head,
        };
        self.anchor(face, value, store, keeps);
    }

    pub(super) fn face_kind(&mut self, orbit: &Loop) {
        let face = orbit.face.name;
        let before = self.drawing.before.loop_of_face(face).map(|before| before.kind);
        if orbit.kind == LoopKind::Any || before == Some(orbit.kind) {
            return;
        }
        let hole = orbit.kind == LoopKind::Hole;
        let store = Inst::StoreHole { face: self.element(face), hole };
        self.set(format!("{}.hole", self.word(face)), hole.to_string(), Some(store));
    }

    fn edge(&mut self, statement: &Edge) {
        let drawing = self.drawing;
        let edge = statement.edge.name;
        let [left, right] = statement.halfedges.map(|half| half.name);
        for (half, twin) in [(left, right), (right, left)] {
            self.pointer(HalfedgeField::Twin, half, twin, drawing.before.twin(half) != Some(twin));
            self.pointer(HalfedgeField::Edge, half, edge, drawing.before.edge(half) != Some(edge));
        }
        let keeps = drawing.before.edge_statement(edge).is_some_and(|before| {
            before.halfedges.iter().all(|half| half.name == left || half.name == right)
        });
        let (element, value) = (self.element(edge), self.element(left));
        let store = Inst::StoreHalfedge { of: ElementField::Edge, element, value };
        self.anchor(edge, self.word(left).into(), store, keeps);
    }

    /// Outer halfedges start where their vertex statement, or their drawn twin, says.
    fn outer_origins(&mut self) {
        let drawing = self.drawing;
        for half in drawing.rule.names_of(Kind::Halfedge) {
            let here = drawing.rule.is_first(half) && drawing.after.mention(half).is_some();
            if !drawing.is_outer(half) || !here {
                continue;
            }
            let origin = drawing.origin_after(half).expect("a halfedge has an origin");
            let changed = drawing.origin_before(half) != Some(origin);
            self.for_each(half, |this| {
                this.pointer(HalfedgeField::Vertex, half, origin, changed);
                // A path may end with it, or hold it.
                let paths = this.drawing.rule.names_of(Kind::Path).next().is_some();
                let kept = ["next", "prev", "face"].into_iter().filter(|_| !paths);
                for pointer in kept {
                    let target = format!("{}.{pointer}", this.word(half));
                    this.set(target, Cell::AS_IT_WAS.into(), None);
                }
            });
        }
    }
}
