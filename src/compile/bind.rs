//! Phase 1, bind: from the parameters to every name, pointer by pointer.

use super::collect::Collect;
use super::reason;
use super::registers::Home;
use super::symmetric::is_symmetric;
use crate::check::matching::{Bound, Source, Step};
use crate::diagram::{Kind, NameId};
use crate::rewrite::{Cell, ElementField, HalfedgeField, Inst, Phase, Reg};

impl Collect<'_, '_, '_, '_> {
    /// Binds a name, or begins an attempt.
    pub(super) fn bind(&mut self, step: &Step) {
        match step {
            Step::Parameter { name, .. } => {
                let text = &self.drawing.rule.name(*name).text;
                self.row(Cell::Note(format!("{text} is given")));
            }
            Step::Attempt { element, halfedge, tries } => self.attempt(*element, *halfedge, *tries),
            Step::Walk { orbit, halfedges } => self.walk(*orbit, halfedges),
            Step::Bind { name, source } => {
                match self.registers.home_of(*name) {
                    Home::Reg(to) => self.load(*source, to),
                    home => self.for_each_index(home, |this| {
                        let to = this.output.asm.reg();
                        this.load(*source, to);
                        to
                    }),
                }
                let target = reason::bound(self.drawing, *name);
                self.row(Cell::Set { target, value: reason::source(self.drawing, *source) });
            }
            Step::Test(_) => {}
        }
    }

    fn load_field(&mut self, field: HalfedgeField, to: Reg, halfedge: Reg) {
        self.output.asm.emit(Inst::Load { field, to, halfedge });
    }

    /// Follows a pointer.
    pub(super) fn load(&mut self, source: Source, to: Reg) {
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
                let element = self.element(face);
                let of = ElementField::Face;
                return self.output.asm.emit(Inst::LoadHalfedge { of, to, element });
            }
        };
        let mut from = self.registers.bound(&mut self.output.asm, from);
        for &field in fields {
            self.load_field(field, to, from);
            from = to;
        }
    }

    /// Begins at one halfedge of an element; a test that fails from here on comes back to
    /// try the next one.
    fn attempt(&mut self, element: NameId, halfedge: NameId, tries: Option<u16>) {
        use HalfedgeField::{Next, Prev, Twin};
        let text = self.drawing.rule.name(element).text.clone();
        let (of, around, each): (_, &[HalfedgeField], _) = match self.drawing.rule.kind(element) {
            Kind::Edge => (ElementField::Edge, &[Twin], format!("{text}.halfedge, or its twin")),
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
        let to = match self.registers.home(halfedge) {
            Home::Reg(to) => to,
            Home::Member { .. } => self.registers.begin(&mut self.output.asm, halfedge),
        };
        let start = self.output.asm.reg();
        let element = self.element(element);
        let (begin, again) = (self.output.asm.label(), self.output.asm.label());
        self.output.asm.emit(Inst::LoadHalfedge { of, to: start, element });
        if of == ElementField::Vertex {
            let reason = format!("`{text}` is isolated: no halfedge starts there");
            let refusal = self.output.refusal(reason, Phase::Match);
            let right = self.output.asm.none();
            let otherwise = self.fail;
            self.output.asm.emit(Inst::ExpectDistinct { left: start, right, refusal, otherwise });
        }
        self.output.asm.emit(Inst::Copy { to, from: start });
        // One try needs no counting: where it fails, all have failed.
        let is_alike = of == ElementField::Edge && is_symmetric(self.drawing, halfedge);
        if tries == Some(1) || is_alike {
            self.output.asm.bind(begin);
            self.output.asm.bind(again);
            let target = self.begin_word(halfedge);
            let value = match is_alike {
                true => each,
                false => each.split(',').next().unwrap_or_default().to_owned(),
            };
            self.row(Cell::Set { target, value });
            return;
        }
        let tried = tries.map(|_| self.output.asm.reg());
        if let Some(to) = tried {
            self.output.asm.emit(Inst::Const { to, bits: 1 });
        }
        self.output.asm.emit(Inst::Jump { to: begin });
        self.output.asm.bind(again);
        if let (Some(tries), Some(tried)) = (tries, tried) {
            let all = self.output.asm.constant_int(i64::from(tries));
            self.output.asm.emit(Inst::JumpEqual { left: tried, right: all, to: self.fail });
            let one = self.output.asm.constant_int(1);
            self.output.asm.emit(Inst::AddInt { to: tried, left: tried, right: one });
        }
        for &field in around {
            self.load_field(field, to, to);
        }
        self.output.asm.emit(Inst::JumpEqual { left: to, right: start, to: self.fail });
        self.output.asm.bind(begin);
        self.fail = again;
        let target = self.begin_word(halfedge);
        self.row(Cell::Set { target, value: each });
    }

    /// The beginning of an attempt, in words: a halfedge, or the first of a path.
    fn begin_word(&self, halfedge: NameId) -> String {
        let bound = match self.drawing.rule.kind(halfedge) {
            Kind::Path => Bound::First(halfedge),
            _ => Bound::Element(halfedge),
        };
        reason::bound(self.drawing, bound)
    }

    /// Whether a path is empty: then what follows it is what it begins with.
    pub(super) fn is_empty(&mut self, path: NameId, home: Home) {
        let next = self.drawing.before.item_after(path).expect("a path of `before` lies in a loop");
        let compare = |this: &mut Self, to: Reg| {
            let [left, right] = [path, next].map(|name| this.element(name));
            this.output.asm.emit(Inst::Equal { to, left, right });
        };
        match home {
            Home::Reg(to) => compare(self, to),
            home => self.for_each_index(home, |this| {
                let to = this.output.asm.reg();
                compare(this, to);
                to
            }),
        }
    }
}
