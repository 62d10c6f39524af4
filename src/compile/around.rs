//! Families in phase 3: loops that are drawn with `each`.

use super::reassign::Reassign;
use super::registers::Home;
use crate::check::matching::Bound;
use crate::diagram::{Loop, NameId};
use crate::rewrite::{Inst, Reg};

impl Reassign<'_, '_, '_, '_> {
    /// A loop with `each`: the items of a period, for each index.
    pub(super) fn orbit_around(&mut self, orbit: &Loop) {
        let size = self.drawing.rule.size().unwrap_or(1) as usize;
        let period = orbit.items.len() / size.max(1);
        let items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        let may_be_empty = |&item: &NameId| self.registers.home_of_empty(item).is_some();
        if items.iter().all(may_be_empty) {
            self.orbit_of_runs(orbit, period);
            return;
        }
        let indices = self.registers.begin_turns(&mut self.output.asm);
        let ends: Vec<_> =
            (0..=period).map(|at| (self.head(&items, at), self.tail(&items, at))).collect();
        for at in 0..period {
            self.item(orbit, at, ends[at].1, ends[at + 1].0);
        }
        self.registers.end_turns(&mut self.output.asm, indices);
        let head = self.head(&items, 0);
        self.face_halfedge(orbit, head);
        self.face_kind(orbit);
    }

    /// A loop of runs each of which may be empty: those that are not are linked in their
    /// order. There is one: that was tested.
    fn orbit_of_runs(&mut self, orbit: &Loop, period: usize) {
        let asm = &mut self.output.asm;
        let [heads, tails] = [asm.buffer(), asm.buffer()];
        for buffer in [heads, tails] {
            asm.emit(Inst::BufferClear { buffer });
        }
        let indices = self.registers.begin_turns(&mut self.output.asm);
        for item in &orbit.items[..period] {
            let path = item.item.name;
            let asm = &mut self.output.asm;
            let skip = asm.label();
            if let Some(condition) = self.registers.is_empty(asm, path) {
                asm.emit(Inst::JumpIf { condition, to: skip });
            }
            for (buffer, bound) in [(heads, Bound::First(path)), (tails, Bound::Last(path))] {
                let from = self.registers.bound(asm, bound);
                asm.emit(Inst::BufferPush { buffer, from });
            }
            asm.bind(skip);
        }
        self.registers.end_turns(&mut self.output.asm, indices);
        // From here on an index counts the runs that are there.
        let cycle = self.registers.cycle.replace(heads);
        let indices = self.registers.begin_turns(&mut self.output.asm);
        let [tail, head] = [(tails, 0), (heads, 1)].map(|end| self.end(end));
        for at in 0..period {
            let count = orbit.items.len();
            let [item, next] = [at, (at + 1) % count].map(|at| orbit.items[at].item.name);
            match at {
                0 => self.link(item, next, tail, head, true),
                // All are linked by now; these are lines of the table.
                _ => self.link(item, next, tail, head, false),
            }
        }
        self.registers.end_turns(&mut self.output.asm, indices);
        self.registers.cycle = cycle;
        let indices = self.registers.begin_turns(&mut self.output.asm);
        for item in &orbit.items[..period] {
            self.lies_in(item, orbit.face.name);
        }
        self.registers.end_turns(&mut self.output.asm, indices);
        let head = self.end((heads, 0));
        self.face_halfedge(orbit, head);
        self.face_kind(orbit);
    }

    fn end(&mut self, (buffer, shift): (u16, i16)) -> Reg {
        let home = Home::Member { buffer, shift };
        self.registers.read(&mut self.output.asm, home)
    }

    /// The first halfedge of some path of a family that is not empty.
    pub(super) fn first_around(&mut self, path: NameId) -> Reg {
        let to = self.output.asm.reg();
        let indices = self.registers.begin_turns(&mut self.output.asm);
        let asm = &mut self.output.asm;
        let from = self.registers.bound(asm, Bound::First(path));
        let skip = asm.label();
        if let Some(condition) = self.registers.is_empty(asm, path) {
            asm.emit(Inst::JumpIf { condition, to: skip });
        }
        asm.emit(Inst::Copy { to, from });
        asm.bind(skip);
        self.registers.end_turns(&mut self.output.asm, indices);
        to
    }
}
