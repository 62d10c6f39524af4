//! The halfedges of paths and fans that move, collected while the mesh is unchanged.

use super::collect::Collect;
use super::collected::Run;
use crate::check::matching::{Bound, Way};
use crate::diagram::{NameId, Spoke};
use crate::rewrite::{Cell, ElementField, Inst, Walk};

impl Collect<'_, '_, '_, '_> {
    /// Collects the halfedges of the paths and fans that move.
    pub(super) fn runs(&mut self) -> Vec<Option<Run>> {
        let drawing = self.drawing;
        let rule = drawing.rule;
        let mut runs = vec![None; rule.names.len()];
        let first = |run: &NameId| rule.is_first(*run);
        for path in drawing.moved_paths().filter(first) {
            runs[path.index()] = Some(self.collect_path(path));
        }
        for fan in drawing.moved_fans().filter(first) {
            runs[fan.index()] = Some(self.collect_run(fan, Self::collect_fan));
            let text = &rule.name(fan).text;
            self.row(Cell::Note { text: format!("collect the spokes of {text}") });
        }
        runs
    }

    /// Collects the halfedges of a path.
    pub(super) fn collect_path(&mut self, path: NameId) -> Run {
        let text = &self.drawing.rule.name(path).text;
        self.row(Cell::Note { text: format!("collect the halfedges of {text}") });
        self.collect_run(path, Self::collect_one_path)
    }

    /// Collects a run, or each of a family of runs.
    fn collect_run(&mut self, run: NameId, one: impl FnOnce(&mut Self, NameId, u16)) -> Run {
        let buffer = self.buffer();
        if !self.drawing.rule.is_member(run) {
            one(self, run, buffer);
            return Run { buffer, ends: None };
        }
        let ends = self.buffer();
        let indices = self.registers.begin_index_loop(&mut self.output.asm);
        one(self, run, buffer);
        let to = self.output.asm.reg();
        self.output.asm.emit(Inst::BufferLength { buffer, to });
        self.output.asm.emit(Inst::BufferPush { buffer: ends, from: to });
        self.registers.end_index_loop(&mut self.output.asm, indices);
        Run { buffer, ends: Some(ends) }
    }

    fn collect_one_path(&mut self, path: NameId, buffer: u16) {
        let from = self.element(path);
        let next = self.drawing.before.item_after(path).expect("a path of `before` lies in a loop");
        let until = self.element(next);
        let whole = next == path;
        self.output.asm.emit(Inst::Collect { walk: Walk::Loop, buffer, from, until, whole });
    }

    fn collect_fan(&mut self, fan: NameId, buffer: u16) {
        let vertex =
            self.drawing.before.star_of_spoke(fan).expect("a fan of `before` lies in a star");
        let star = self.drawing.before.star(vertex).expect("its vertex has a statement");
        let count = star.spokes.len();
        let is_fan = |spoke: &Spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan);
        let at = star.spokes.iter().position(is_fan).expect("the statement lists the fan");
        let from = self.output.asm.reg();
        let before = star.spokes[(at + count - 1) % count].halfedge();
        let after = star.spokes[(at + 1) % count].halfedge();
        let walk = Walk::Star;
        let inst = match (before, after) {
            (Some(before), Some(after)) => {
                self.load(Way::Counterclockwise.of(Bound::Element(before)), from);
                Inst::Collect { walk, buffer, from, until: self.element(after), whole: false }
            }
            // The fan is the whole star.
            _ => {
                let element = self.element(vertex);
                self.output.asm.emit(Inst::LoadHalfedge {
                    of: ElementField::Vertex,
                    to: from,
                    element,
                });
                Inst::Collect { walk, buffer, from, until: from, whole: true }
            }
        };
        self.output.asm.emit(inst);
    }
}
