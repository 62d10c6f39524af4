//! Phase 3, reassign: every pointer of every named element, as code and as rows of the table.

use super::collected::{Collected, Run};
use super::expression::{element_field, halfedge_field};
use super::output::Output;
use super::registers::{Home, Registers};
use super::write_target::WriteTarget;
use crate::check::matching::Bound;
use crate::diagram::{Drawing, Kind, NameId, Operand, Pointer, Write};
use crate::lower::Value;
use crate::rewrite::{Cell, HalfedgeField, Inst, Reg, Row, Span};

/// Writes phase 3.
pub(super) struct Reassign<'o, 's, 'd, 'r> {
    pub output: &'o mut Output<'s>,
    pub drawing: &'d Drawing<'d>,
    pub registers: Registers,
    pub collected: &'d Collected,
    pub values: &'d [Value<'d>],
    pub target: WriteTarget,
    pub rows: &'r mut Vec<Row>,
}

impl Reassign<'_, '_, '_, '_> {
    /// The code of the whole phase. All values to store have been loaded before the first store:
    /// the selects in between read only registers.
    pub fn emit(mut self) {
        // For each loop of paths that may be empty, the buffer of the first halfedges of those that
        // are not.
        let mut linked = Vec::new();
        for reassignment in self.drawing.reassignments() {
            self.indexed(reassignment.at_each_index, |this| {
                for write in &reassignment.writes {
                    this.write(write, &mut linked);
                }
            });
        }
        self.assignments();
    }

    pub(super) fn word(&self, name: NameId) -> &str {
        &self.drawing.rule.name(name).text
    }

    pub(super) fn element(&mut self, name: NameId) -> Reg {
        self.registers.element(&mut self.output.asm, name)
    }

    /// Emits code, in a loop over the indices if `at_each_index`.
    pub(super) fn indexed(&mut self, at_each_index: bool, what: impl FnOnce(&mut Self)) {
        let indices = at_each_index.then(|| self.registers.begin_index_loop(&mut self.output.asm));
        what(self);
        if let Some(indices) = indices {
            self.registers.end_index_loop(&mut self.output.asm, indices);
        }
    }

    fn write(&mut self, write: &Write, linked: &mut Vec<(NameId, u16)>) {
        match write {
            Write::Halfedge { pointer, of, value, changes } => {
                let target = format!("{}.{}", self.told(of), pointer.word());
                let text = self.told(value);
                let [halfedge, value] = [of, value].map(|one| self.operand(one, linked));
                let store = Inst::Store { field: halfedge_field(*pointer), halfedge, value };
                self.set(target, text, Some(*pointer), changes.then_some(store));
            }
            Write::AsItWas { pointer, of } => {
                let target = format!("{}.{}", self.word(*of), pointer.word());
                self.set(target, Cell::AS_IT_WAS.into(), None, None);
            }
            Write::Anchor { value: None, .. } => {}
            Write::Anchor { pointer, of, value: Some(value), keeps } => {
                let target = format!("{}.halfedge", self.word(*of));
                if *keeps {
                    self.set(target, Cell::AS_IT_WAS.into(), None, None);
                    return;
                }
                let text = self.told(value);
                let (element, value) = (self.element(*of), self.operand(value, linked));
                let of = element_field(*pointer).expect("it is the halfedge of an element");
                let store = Inst::StoreHalfedge { of, element, value };
                self.set(target, text, Some(*pointer), Some(store));
            }
            Write::FaceAlong { path, face, .. } => {
                let target = format!("face along {}", self.word(*path));
                let store = self.store_run(HalfedgeField::Face, *path, *face);
                self.set(target, self.word(*face).into(), Some(Pointer::Face), store);
            }
            Write::VertexAround { fan, vertex, .. } => {
                let target = format!("vertex around {}", self.word(*fan));
                let store = self.store_run(HalfedgeField::Vertex, *fan, *vertex);
                self.set(target, self.word(*vertex).into(), Some(Pointer::Vertex), store);
            }
            Write::Hole { face, is_hole, changes } => {
                // On the preview it is set for new faces, too.
                let is_set = *changes || self.target != WriteTarget::Mesh;
                let store = Inst::StoreHole { face: self.element(*face), hole: *is_hole };
                let target = format!("{}.hole", self.word(*face));
                self.set(target, is_hole.to_string(), None, is_set.then_some(store));
            }
            Write::LinkPaths { face, period } => {
                let heads = self.link_paths(period);
                linked.push((*face, heads));
            }
        }
    }

    /// Sets a pointer, or whether a face is a hole, if there is an instruction for it.
    fn set(&mut self, target: String, value: String, pointer: Option<Pointer>, inst: Option<Inst>) {
        self.rows.push(Row::set(target, value, inst.is_some()));
        if let Some(inst) = inst.and_then(|inst| self.target.aim(pointer, inst)) {
            self.output.asm.emit(inst);
        }
    }

    /// The words for an operand.
    fn told(&self, operand: &Operand) -> String {
        let end = |end: &str, item: &NameId| match self.drawing.rule.kind(*item) {
            Kind::Path => format!("{end}({})", self.word(*item)),
            _ => self.word(*item).to_owned(),
        };
        let joined = |items: &[NameId], word| {
            items.iter().map(|item| end(word, item)).collect::<Vec<_>>().join(" or ")
        };
        match operand {
            Operand::Named(name) => self.word(*name).to_owned(),
            Operand::First(items) => joined(items, "first"),
            Operand::Last(items) => joined(items, "last"),
            Operand::FirstLinked { path, .. } | Operand::FirstOfSome(path) => end("first", path),
        }
    }

    /// The register of an operand.
    fn operand(&mut self, operand: &Operand, linked: &[(NameId, u16)]) -> Reg {
        match operand {
            Operand::Named(name) => self.element(*name),
            Operand::First(items) => self.there(items, Bound::First),
            Operand::Last(items) => self.there(items, Bound::Last),
            Operand::FirstLinked { face, .. } => {
                let list = linked.iter().find(|(of, _)| of == face);
                self.member(list.expect("its paths have been linked").1, 0)
            }
            Operand::FirstOfSome(path) => self.first_of_some(*path),
        }
    }

    /// The halfedge at an end of the first item that is not empty.
    fn there(&mut self, items: &[NameId], end: impl Fn(NameId) -> Bound) -> Reg {
        let mut ends: Vec<(Reg, Option<Reg>)> = Vec::new();
        for &item in items {
            let bound = match self.drawing.rule.kind(item) {
                Kind::Path => end(item),
                _ => Bound::Element(item),
            };
            let asm = &mut self.output.asm;
            let empty = self.registers.is_empty(asm, item);
            ends.push((self.registers.bound(asm, bound), empty));
        }
        let (mut reg, _) = ends.pop().expect("an operand has items");
        while let Some((then, empty)) = ends.pop() {
            let condition = empty.expect("all but the last may be empty");
            let to = self.output.asm.reg();
            self.output.asm.emit(Inst::Select { to, condition, then: reg, otherwise: then });
            reg = to;
        }
        reg
    }

    /// Links the paths of a loop that are not empty; the buffer of their first halfedges.
    fn link_paths(&mut self, period: &[NameId]) -> u16 {
        let asm = &mut self.output.asm;
        let [heads, tails] = [asm.buffer(), asm.buffer()];
        for buffer in [heads, tails] {
            asm.emit(Inst::BufferClear { buffer });
        }
        self.indexed(true, |this| {
            for &path in period {
                let asm = &mut this.output.asm;
                let skip = asm.label();
                if let Some(condition) = this.registers.is_empty(asm, path) {
                    asm.emit(Inst::JumpIf { condition, to: skip });
                }
                for (buffer, bound) in [(heads, Bound::First(path)), (tails, Bound::Last(path))] {
                    let from = this.registers.bound(asm, bound);
                    asm.emit(Inst::BufferPush { buffer, from });
                }
                asm.bind(skip);
            }
        });
        // From here on the index counts the paths that are not empty.
        let cycle = self.registers.cycle.replace(heads);
        self.indexed(true, |this| {
            let [tail, head] =
                [(tails, 0), (heads, 1)].map(|(buffer, shift)| this.member(buffer, shift));
            for (at, &path) in period.iter().enumerate() {
                let next = period[(at + 1) % period.len()];
                let [last, first] = [("last", path), ("first", next)]
                    .map(|(end, path)| format!("{end}({})", this.word(path)));
                // The stores of the first path run at each index, and link all.
                let store = |field, halfedge, value| {
                    (at == 0).then_some(Inst::Store { field, halfedge, value })
                };
                let next = store(HalfedgeField::Next, tail, head);
                let prev = store(HalfedgeField::Prev, head, tail);
                this.set(format!("{last}.next"), first.clone(), Some(Pointer::Next), next);
                this.set(format!("{first}.prev"), last, Some(Pointer::Prev), prev);
            }
        });
        self.registers.cycle = cycle;
        heads
    }

    fn member(&mut self, buffer: u16, shift: i16) -> Reg {
        self.registers.read(&mut self.output.asm, Home::Member { buffer, shift })
    }

    /// The first halfedge of some path of a family that is not empty.
    fn first_of_some(&mut self, path: NameId) -> Reg {
        let to = self.output.asm.reg();
        self.indexed(true, |this| {
            let asm = &mut this.output.asm;
            let from = this.registers.bound(asm, Bound::First(path));
            let skip = asm.label();
            if let Some(condition) = this.registers.is_empty(asm, path) {
                asm.emit(Inst::JumpIf { condition, to: skip });
            }
            asm.emit(Inst::Copy { to, from });
            asm.bind(skip);
        });
        to
    }

    /// Sets a pointer of every halfedge of a run, if it was collected.
    fn store_run(&mut self, field: HalfedgeField, run: NameId, value: NameId) -> Option<Inst> {
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
}
