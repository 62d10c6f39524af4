//! Loops over the neighbors of a vertex, each with lists and with a walk: at each instruction native
//! code looks whether there are lists, which does not change while it runs.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, InstBuilder, Value};

use super::Variant;
use super::access::first;
use super::context::Context;
use super::translate::{Region, Translator};
use crate::mesh::ElementKind;
use crate::mesh::tables::Tables;
use crate::rewrite::neighbors::of_loop;
use crate::rewrite::{ElementField, HalfedgeField, Inst, Label, Reg};

impl Translator<'_, '_> {
    /// Translates an instruction of a loop over neighbors; false if it is another one.
    pub(super) fn neighbors(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::NeighborsBegin { vertex, slots, neighbor, otherwise } => {
                let record = self.living(ElementKind::Vertex, vertex);
                self.with_lists(
                    |this, lists| this.begin_list(lists, [vertex, slots, neighbor], otherwise),
                    |this| this.begin_walk(record, [slots, neighbor], otherwise),
                );
            }
            Inst::NeighborsNext { slots, neighbor, again } => self.with_lists(
                |this, _| this.next_in_list([slots, neighbor], again),
                |this| this.next_of_walk([slots, neighbor], again),
            ),
            _ => return false,
        }
        true
    }

    /// Translates both ways, the first with the address of the starts of the lists. Code that
    /// writes never has lists.
    fn with_lists(
        &mut self,
        listed: impl FnOnce(&mut Self, Value),
        walked: impl FnOnce(&mut Self),
    ) {
        if self.variant != Variant::Plain {
            return walked(self);
        }
        let starts = self.lists_of_neighbors(0);
        let [lists, walks, on] = [(); 3].map(|()| self.b.create_block());
        self.b.ins().brif(starts, lists, &[], walks, &[]);
        self.b.switch_to_block(lists);
        listed(self, starts);
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(walks);
        walked(self);
        self.join(on);
    }

    fn begin_list(&mut self, starts: Value, [vertex, slots, neighbor]: [Reg; 3], none: Label) {
        let [_, at, end] = of_loop(slots);
        let id = self.id(vertex);
        let offset = self.b.ins().ishl_imm_u(id, 2);
        let bounds = self.b.ins().iadd(starts, offset);
        let [start, stop] = [0, 4].map(|offset| self.number(Region::Neighbors, bounds, offset));
        let is_none = self.b.ins().icmp(IntCC::Equal, start, stop);
        self.jump_if(is_none, none);
        self.set_whole(at, start);
        self.set_whole(end, stop);
        self.read_list(start, neighbor);
    }

    fn next_in_list(&mut self, [slots, neighbor]: [Reg; 2], again: Label) {
        let [_, at, end] = of_loop(slots);
        let now = self.whole(at);
        let next = self.b.ins().iadd_imm_s(now, 1);
        let stop = self.whole(end);
        let is_within = self.b.ins().icmp(IntCC::UnsignedLessThan, next, stop);
        let on = self.go_on_if(is_within);
        self.set_whole(at, next);
        self.read_list(next, neighbor);
        let again = self.block(again);
        self.b.ins().jump(again, &[]);
        self.b.switch_to_block(on);
    }

    fn read_list(&mut self, at: Value, neighbor: Reg) {
        let all = self.lists_of_neighbors(1);
        let offset = self.b.ins().ishl_imm_u(at, 2);
        let place = self.b.ins().iadd(all, offset);
        let id = self.number(Region::Neighbors, place, 0);
        self.set_whole(neighbor, id);
    }

    fn begin_walk(&mut self, vertex: Value, [slots, neighbor]: [Reg; 2], none: Label) {
        let [from, at, steps] = of_loop(slots);
        let (region, offset) = first(ElementField::Vertex);
        let spoke = self.number(region, vertex, offset);
        let is_none = self.b.ins().icmp_imm_u(IntCC::Equal, spoke, i64::from(u32::MAX));
        self.jump_if(is_none, none);
        let record = self.record(ElementKind::Halfedge, spoke);
        let twin = self.leads(record, HalfedgeField::Twin);
        let record = self.record(ElementKind::Halfedge, twin);
        let target = self.leads(record, HalfedgeField::Vertex);
        let zero = self.b.ins().iconst(I64, 0);
        self.set_whole(from, spoke);
        self.set_whole(at, spoke);
        self.set_whole(steps, zero);
        self.set_whole(neighbor, target);
    }

    fn next_of_walk(&mut self, [slots, neighbor]: [Reg; 2], again: Label) {
        let [from, at, steps] = of_loop(slots);
        let record = self.living(ElementKind::Halfedge, at);
        let before = self.leads(record, HalfedgeField::Prev);
        let before = self.record(ElementKind::Halfedge, before);
        let next = self.leads(before, HalfedgeField::Twin);
        let target = self.leads(before, HalfedgeField::Vertex);
        let from = self.id(from);
        let is_on = self.b.ins().icmp(IntCC::NotEqual, next, from);
        let on = self.go_on_if(is_on);
        let step = self.whole(steps);
        let step = self.b.ins().iadd_imm_s(step, 1);
        let count = self.table_field(offset_of!(Tables, halfedge_count));
        let is_within = self.b.ins().icmp(IntCC::SignedLessThan, step, count);
        self.or_fault(is_within);
        self.set_whole(at, next);
        self.set_whole(steps, step);
        self.set_whole(neighbor, target);
        let again = self.block(again);
        self.b.ins().jump(again, &[]);
        self.b.switch_to_block(on);
    }

    /// Goes on if a condition holds; returns the block of the other case.
    fn go_on_if(&mut self, condition: Value) -> Block {
        let [on, other] = [(); 2].map(|()| self.b.create_block());
        self.b.ins().brif(condition, on, &[], other, &[]);
        self.go_on(on);
        other
    }

    /// The address of the starts of the lists, or of the neighbors in them; 0 if there are no
    /// lists.
    fn lists_of_neighbors(&mut self, part: usize) -> Value {
        self.constant_field(offset_of!(Context, neighbors) + part * size_of::<*const u32>())
    }
}
