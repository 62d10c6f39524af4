//! Instructions that read and fill buffers.
//!
//! Native code reads a buffer itself, at indices below its length, and writes to it while it has
//! room; stubs do the rest.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, InstBuilder, Value};
use cranelift_frontend::Variable;

use super::context::Context;
use super::stubs;
use super::translate::{Region, Translator};
use crate::mesh::{ElementKind, Mesh};
use crate::rewrite::{HalfedgeField, Inst, List, Reg, Walk, attribute};

impl Translator<'_, '_> {
    /// Translates an instruction about buffers; false if it is another one, or is left to the
    /// machine.
    pub(super) fn list(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::BufferPush { buffer, .. }
            | Inst::BufferLength { buffer, .. }
            | Inst::BufferGet { buffer, .. }
            | Inst::BufferNext { buffer, .. }
            | Inst::Prefetch { buffer, .. }
            | Inst::NextIndex { buffer, .. }
            | Inst::Member { buffer, .. }
            | Inst::Collect { buffer, .. }
            | Inst::DeferPosition { buffer, .. }
            | Inst::DeferAttribute { buffer, .. }
                if buffer >= self.unit.code.buffers =>
            {
                return false;
            }
            Inst::BufferPush { buffer, from } => {
                let (list, bits) = (self.list_of(buffer), self.whole(from));
                self.push(buffer, list, bits);
            }
            Inst::Keep { from } => {
                let (kept, bits) = (self.field(offset_of!(Context, kept)), self.whole(from));
                let count = self.in_list(kept, List::COUNT);
                let room = self.in_list(kept, List::ROOM);
                let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, count, room);
                self.or_fault(has_room);
                self.append_to(kept, count, &[bits]);
            }
            Inst::BufferLength { buffer, to } => {
                let (_, count) = self.slots(buffer);
                self.set_whole(to, count);
            }
            Inst::BufferGet { buffer, to, index } => {
                let index = self.whole(index);
                let (start, count) = self.slots(buffer);
                let is_in_range = self.b.ins().icmp(IntCC::UnsignedLessThan, index, count);
                self.or_fault(is_in_range);
                let value = self.slot(start, index);
                self.set_whole(to, value);
            }
            Inst::BufferNext { buffer, index, to, otherwise } => {
                let place = self.whole(index);
                let (start, count) = self.slots(buffer);
                let is_over = self.b.ins().icmp(IntCC::UnsignedGreaterThanOrEqual, place, count);
                self.jump_if(is_over, otherwise);
                let value = self.slot(start, place);
                self.set_whole(to, value);
                let next = self.b.ins().iadd_imm_s(place, 1);
                self.set_whole(index, next);
            }
            Inst::Prefetch { of, buffer, index } => {
                let place = self.whole(index);
                let [here, on] = [(); 2].map(|()| self.b.create_block());
                let place_in_group = self.b.ins().band_imm_u(place, Mesh::TOGETHER as i64 - 1);
                self.b.ins().brif(place_in_group, on, &[], here, &[]);
                self.b.switch_to_block(here);
                let which = i64::from(buffer) | (of.kind() as i64) << 16;
                let which = self.b.ins().iconst(I64, which);
                self.call_stub(stubs::prefetch as *const () as usize, &[which, place]);
                self.join(on);
            }
            Inst::NextIndex { buffer, index, otherwise } => {
                let next = self.whole(index);
                let next = self.b.ins().iadd_imm_s(next, 1);
                let (_, count) = self.slots(buffer);
                let is_over = self.b.ins().icmp(IntCC::UnsignedGreaterThanOrEqual, next, count);
                self.jump_if(is_over, otherwise);
                self.set_whole(index, next);
            }
            Inst::Member { buffer, index, shift, to } => {
                let index = self.whole(index);
                let (start, count) = self.slots(buffer);
                let index = self.in_cycle(index, shift, count);
                let value = self.slot(start, index);
                self.set_whole(to, value);
            }
            Inst::Collect { walk, buffer, from, until, whole } => {
                let [from, until] = [from, until].map(|reg| self.id(reg));
                let on = self.b.create_block();
                if !whole {
                    let walks = self.b.create_block();
                    let differ = self.b.ins().icmp(IntCC::NotEqual, from, until);
                    self.b.ins().brif(differ, walks, &[], on, &[]);
                    self.b.switch_to_block(walks);
                }
                match walk {
                    Walk::Star if !whole => self.collect_spokes(buffer, [from, until], on),
                    _ => self.collect((walk, buffer), [from, until], on),
                }
            }
            Inst::DeferPosition { buffer, vertex, value } => {
                self.living(ElementKind::Vertex, vertex);
                let finite = self.is_finite(value);
                self.or_fault(finite);
                self.hold_back(inst, (buffer, attribute::POSITION), vertex, (value, 3));
            }
            Inst::DeferAttribute { buffer, attribute, element, value } => {
                let Some((kind, ty)) = self.unit.environment.column(attribute) else {
                    return false;
                };
                self.living(kind, element);
                let width = ty.width() as u16;
                self.hold_back(inst, (buffer, attribute.into()), element, (value, width));
            }
            _ => return false,
        }
        true
    }

    /// Empties the buffers of the code. A stub adds those that the machine has not yet.
    pub(super) fn begin_lists(&mut self) {
        let buffers = self.unit.code.buffers;
        if buffers == 0 {
            return;
        }
        let [here, few, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(few);
        let [lists, last] = [offset_of!(Context, lists), offset_of!(Context, last_list)]
            .map(|offset| self.field(offset));
        let size = size_of::<List>() as i64;
        let end = self.b.ins().iadd_imm_s(lists, i64::from(buffers) * size);
        let are_there = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, end, last);
        self.b.ins().brif(are_there, here, &[], few, &[]);

        self.b.switch_to_block(here);
        (0..buffers).for_each(|buffer| self.clear(buffer));
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(few);
        let begun = self.call_stub(stubs::begin_lists as *const () as usize, &[]);
        self.leave_if_negative(begun);
        self.join(on);
    }

    /// Empties a buffer.
    pub(super) fn clear(&mut self, buffer: u16) {
        let (list, none) = (self.list_of(buffer), self.b.ins().iconst(I64, 0));
        self.set_count(list, none);
    }

    /// The index plus a shift, modulo the length of a buffer; traps if that is 0.
    pub(super) fn in_cycle(&mut self, index: Value, shift: i16, count: Value) -> Value {
        let place = self.b.declare_var(I64);
        let [far, on] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(far);
        let shifted = self.b.ins().iadd_imm_s(index, i64::from(shift));
        // Once around is enough, except in a short cycle.
        let back = match shift {
            0 => shifted,
            1.. => self.b.ins().isub(shifted, count),
            _ => self.b.ins().iadd(shifted, count),
        };
        let is_within = self.b.ins().icmp(IntCC::UnsignedLessThan, shifted, count);
        let near = self.b.ins().select(is_within, shifted, back);
        self.b.def_var(place, near);
        let is_within = self.b.ins().icmp(IntCC::UnsignedLessThan, near, count);
        self.b.ins().brif(is_within, on, &[], far, &[]);

        self.b.switch_to_block(far);
        let is_some = self.b.ins().icmp_imm_u(IntCC::NotEqual, count, 0);
        self.or_fault(is_some);
        let rest = self.b.ins().srem(shifted, count);
        let positive = self.b.ins().iadd(rest, count);
        let is_negative = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, rest, 0);
        let rest = self.b.ins().select(is_negative, positive, rest);
        self.b.def_var(place, rest);
        self.join(on);
        self.b.use_var(place)
    }

    /// Keeps a write back: in the slots that the part of a loop keeps while there is room, else by
    /// a stub.
    fn hold_back(
        &mut self,
        inst: &Inst,
        (buffer, target): (u16, u32),
        element: Reg,
        (value, width): (Reg, u16),
    ) {
        let header = self.b.ins().iconst(I64, attribute::header(target, width) as i64);
        let element = self.id(element);
        let [here, full, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(full);
        let kept = self.field(offset_of!(Context, kept));
        let [count, room] = [List::COUNT, List::ROOM].map(|offset| self.in_list(kept, offset));
        let behind = self.b.ins().iadd_imm_s(count, i64::from(width) + 2);
        let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, behind, room);
        self.b.ins().brif(fits, here, &[], full, &[]);

        self.b.switch_to_block(here);
        let slots = (0..width).map(|part| self.whole(Reg(value.0.wrapping_add(part))));
        let slots: Vec<Value> = [header, element].into_iter().chain(slots).collect();
        self.append_to(kept, count, &slots);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(full);
        self.spill_operands(inst);
        let which = i64::from(buffer) | i64::from(value.0) << 16 | i64::from(width) << 32;
        let which = self.b.ins().iconst(I64, which);
        let stub = stubs::hold as *const () as usize;
        let done = self.call_stub(stub, &[which, header, element]);
        self.or_fault_if_negative(done);
        self.join(on);
    }

    /// Appends a slot to a buffer, whose list this is.
    fn push(&mut self, buffer: u16, list: Value, bits: Value) {
        let [count, room] = [List::COUNT, List::ROOM].map(|offset| self.in_list(list, offset));
        let [here, full, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(full);
        let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, count, room);
        self.b.ins().brif(has_room, here, &[], full, &[]);
        self.b.switch_to_block(here);
        self.append_to(list, count, &[bits]);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(full);
        let number = self.b.ins().iconst(I64, i64::from(buffer));
        let done = self.call_stub(stubs::push as *const () as usize, &[number, bits]);
        self.or_fault_if_negative(done);
        self.join(on);
    }

    /// Appends the halfedges of a walk to a buffer, and jumps to `on`. A stub walks again if the
    /// buffer becomes full or the walk has no end.
    fn collect(&mut self, (walk, buffer): (Walk, u16), [from, until]: [Value; 2], on: Block) {
        let list = self.list_of(buffer);
        let [start, before, room] =
            [List::START, List::COUNT, List::ROOM].map(|offset| self.in_list(list, offset));
        let [at, count] = [(); 2].map(|()| self.b.declare_var(I64));
        self.b.def_var(at, from);
        self.b.def_var(count, before);
        let [head, here, done, full] = [(); 4].map(|()| self.b.create_block());
        self.b.set_cold_block(full);
        self.b.ins().jump(head, &[]);

        self.b.switch_to_block(head);
        let place = self.b.use_var(count);
        let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, place, room);
        self.b.ins().brif(has_room, here, &[], full, &[]);
        self.b.switch_to_block(here);
        let next = self.gather(walk, start, [at, count]);
        let is_over = self.b.ins().icmp(IntCC::Equal, next, until);
        let goes_on = self.b.create_block();
        self.b.ins().brif(is_over, done, &[], goes_on, &[]);
        self.b.switch_to_block(goes_on);
        // Without end, if it comes back first.
        let is_back = self.b.ins().icmp(IntCC::Equal, next, from);
        self.b.ins().brif(is_back, full, &[], head, &[]);

        self.b.switch_to_block(done);
        let place = self.b.use_var(count);
        self.set_count(list, place);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(full);
        self.collect_by_stub((walk, buffer), [from, until], on);
    }

    /// As [`Self::collect`], for the spokes from one up to another. Walks from both ends until they
    /// meet, so that two reads at a time wait for memory; the later spokes are put at the end of the
    /// buffer's memory at first.
    fn collect_spokes(&mut self, buffer: u16, [from, until]: [Value; 2], on: Block) {
        let list = self.list_of(buffer);
        let [start, before, room] =
            [List::START, List::COUNT, List::ROOM].map(|offset| self.in_list(list, offset));
        let [ahead, behind, count, rest] = [from, until, before, room].map(|value| {
            let variable = self.b.declare_var(I64);
            self.b.def_var(variable, value);
            variable
        });
        let [head, forth, unmet, turn, back, met, full] = [(); 7].map(|()| self.b.create_block());
        self.b.set_cold_block(full);
        self.b.ins().jump(head, &[]);

        self.b.switch_to_block(head);
        let [place, end] = [count, rest].map(|variable| self.b.use_var(variable));
        let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, place, end);
        self.b.ins().brif(has_room, forth, &[], full, &[]);
        self.b.switch_to_block(forth);
        let next = self.gather(Walk::Star, start, [ahead, count]);
        let end_of_rest = self.b.use_var(behind);
        let is_over = self.b.ins().icmp(IntCC::Equal, next, end_of_rest);
        self.b.ins().brif(is_over, met, &[], unmet, &[]);
        self.b.switch_to_block(unmet);
        // Without end, if it comes back first.
        let is_back = self.b.ins().icmp(IntCC::Equal, next, from);
        self.b.ins().brif(is_back, full, &[], turn, &[]);

        self.b.switch_to_block(turn);
        let place = self.b.use_var(count);
        let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, place, end);
        self.b.ins().brif(has_room, back, &[], full, &[]);
        self.b.switch_to_block(back);
        let record = self.record(ElementKind::Halfedge, end_of_rest);
        let twin = self.leads(record, HalfedgeField::Twin);
        let record = self.record(ElementKind::Halfedge, twin);
        let spoke = self.leads(record, HalfedgeField::Next);
        self.b.def_var(behind, spoke);
        let end = self.b.ins().iadd_imm_s(end, -1);
        self.b.def_var(rest, end);
        self.set_slot(start, end, spoke);
        let is_over = self.b.ins().icmp(IntCC::Equal, spoke, next);
        self.b.ins().brif(is_over, met, &[], head, &[]);

        self.b.switch_to_block(met);
        let [goes_on, done] = [(); 2].map(|()| self.b.create_block());
        let [place, end] = [count, rest].map(|variable| self.b.use_var(variable));
        let has_more = self.b.ins().icmp(IntCC::UnsignedLessThan, end, room);
        self.b.ins().brif(has_more, goes_on, &[], done, &[]);
        self.b.switch_to_block(goes_on);
        let spoke = self.slot(start, end);
        self.set_slot(start, place, spoke);
        for (variable, value) in [(count, place), (rest, end)] {
            let value = self.b.ins().iadd_imm_s(value, 1);
            self.b.def_var(variable, value);
        }
        self.b.ins().jump(met, &[]);
        self.b.switch_to_block(done);
        self.set_count(list, place);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(full);
        self.collect_by_stub((Walk::Star, buffer), [from, until], on);
    }

    /// Puts the halfedge `at` into slot `count`, advances both, and returns the next halfedge.
    fn gather(&mut self, walk: Walk, start: Value, [at, count]: [Variable; 2]) -> Value {
        let (halfedge, place) = (self.b.use_var(at), self.b.use_var(count));
        self.set_slot(start, place, halfedge);
        let place = self.b.ins().iadd_imm_s(place, 1);
        self.b.def_var(count, place);
        let record = self.record(ElementKind::Halfedge, halfedge);
        let lives = self.is_not_dead(ElementKind::Halfedge, record);
        self.or_fault(lives);
        let next = self.step_of_walk(walk, record);
        self.b.def_var(at, next);
        next
    }

    /// Lets a stub collect the halfedges of a walk, of which nothing has been appended.
    fn collect_by_stub(
        &mut self,
        (walk, buffer): (Walk, u16),
        [from, until]: [Value; 2],
        on: Block,
    ) {
        let star = i64::from(walk == Walk::Star);
        let which = self.b.ins().iconst(I64, i64::from(buffer) | star << 16);
        let stub = stubs::collect as *const () as usize;
        let walked = self.call_stub(stub, &[which, from, until]);
        self.or_fault_if_negative(walked);
        self.join(on);
    }

    /// The address of the list of a buffer.
    pub(super) fn list_of(&mut self, buffer: u16) -> Value {
        let lists = self.field(offset_of!(Context, lists));
        self.b.ins().iadd_imm_s(lists, i64::from(buffer) * size_of::<List>() as i64)
    }

    /// A part of a list.
    pub(super) fn in_list(&mut self, list: Value, offset: usize) -> Value {
        self.load(I64, Region::Lists, list, offset)
    }

    /// Appends slots to a list that has `count` slots, and room for these.
    fn append_to(&mut self, list: Value, count: Value, slots: &[Value]) {
        let start = self.in_list(list, List::START);
        let place = self.place_of_slot(start, count);
        for (at, slot) in (0..).zip(slots) {
            self.store(Region::Slots, *slot, place, at * size_of::<u64>());
        }
        let count = self.b.ins().iadd_imm_s(count, slots.len() as i64);
        self.set_count(list, count);
    }

    /// The address and number of the slots of a buffer.
    pub(super) fn slots(&mut self, buffer: u16) -> (Value, Value) {
        let list = self.list_of(buffer);
        (self.in_list(list, List::START), self.in_list(list, List::COUNT))
    }

    pub(super) fn slot(&mut self, start: Value, index: Value) -> Value {
        let place = self.place_of_slot(start, index);
        self.load(I64, Region::Slots, place, 0)
    }

    pub(super) fn set_slot(&mut self, start: Value, index: Value, value: Value) {
        let place = self.place_of_slot(start, index);
        self.store(Region::Slots, value, place, 0);
    }

    /// Sets the number of slots of a list.
    pub(super) fn set_count(&mut self, list: Value, count: Value) {
        self.store(Region::Lists, count, list, List::COUNT);
    }

    fn place_of_slot(&mut self, start: Value, index: Value) -> Value {
        let offset = self.b.ins().ishl_imm_u(index, 3);
        self.b.ins().iadd(start, offset)
    }
}
