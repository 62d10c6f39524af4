//! Instructions that read and fill buffers.
//!
//! Native code reads a buffer itself, at indices below its length; stubs write to it.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};

use super::access::size_of_value;
use super::context::{Context, Slice};
use super::stubs::lists;
use super::translate::{Region, Translator};
use crate::mesh::{ElementKind, Mesh};
use crate::rewrite::{Inst, Reg, Walk, attribute};

impl Translator<'_, '_> {
    /// Translates an instruction about buffers; false if it is another one, or is left to the
    /// machine.
    pub(super) fn list(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::BufferClear { buffer }
            | Inst::BufferPush { buffer, .. }
            | Inst::BufferLength { buffer, .. }
            | Inst::BufferGet { buffer, .. }
            | Inst::BufferNext { buffer, .. }
            | Inst::Prefetch { buffer, .. }
            | Inst::NextIndex { buffer, .. }
            | Inst::Member { buffer, .. }
            | Inst::Collect { buffer, .. }
            | Inst::HoldPosition { buffer, .. }
            | Inst::HoldAttribute { buffer, .. }
                if buffer >= self.text.code.buffers =>
            {
                return false;
            }
            Inst::BufferClear { buffer } => {
                let number = self.b.ins().iconst(I64, i64::from(buffer));
                let done = self.call_stub(lists::clear as *const () as usize, &[number]);
                self.leave_if_negative(done);
            }
            Inst::BufferPush { buffer, from } => {
                let (number, bits) =
                    (self.b.ins().iconst(I64, i64::from(buffer)), self.whole(from));
                let done = self.call_stub(lists::push as *const () as usize, &[number, bits]);
                self.or_fault_if_negative(done);
            }
            Inst::Keep { from } => {
                let [count, room] =
                    [offset_of!(Context, kept_count), offset_of!(Context, kept_room)]
                        .map(|offset| self.field(offset));
                let has_room = self.b.ins().icmp(IntCC::UnsignedLessThan, count, room);
                self.or_fault(has_room);
                let place = self.kept_slot(count);
                let (flags, bits) = (self.flags(Region::Slots), self.whole(from));
                self.b.ins().store(flags, bits, place, 0);
                let count = self.b.ins().iadd_imm_s(count, 1);
                self.set_field(offset_of!(Context, kept_count), count);
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
                self.call_stub(lists::prefetch as *const () as usize, &[which, place]);
                self.b.ins().jump(on, &[]);
                self.b.switch_to_block(on);
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
                let star = i64::from(walk == Walk::Star);
                let which = self.b.ins().iconst(I64, i64::from(buffer) | star << 16);
                let stub = lists::collect as *const () as usize;
                let done = self.call_stub(stub, &[which, from, until]);
                self.or_fault_if_negative(done);
                self.b.ins().jump(on, &[]);
                self.b.switch_to_block(on);
            }
            Inst::HoldPosition { buffer, vertex, value } => {
                self.living(ElementKind::Vertex, vertex);
                let finite = self.is_finite(value);
                self.or_fault(finite);
                self.hold_back(inst, (buffer, attribute::POSITION), vertex, (value, 3));
            }
            Inst::HoldAttribute { buffer, attribute, element, value } => {
                let Some((kind, ty)) = self.text.surroundings.column(attribute) else {
                    return false;
                };
                self.living(kind, element);
                let width = (size_of_value(ty) / 8).max(1) as u16;
                self.hold_back(inst, (buffer, attribute.into()), element, (value, width));
            }
            _ => return false,
        }
        true
    }

    /// The index plus a shift, modulo the length of a buffer; traps if that is 0.
    fn in_cycle(&mut self, index: Value, shift: i16, count: Value) -> Value {
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
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(on);
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
        let [count, room] = [offset_of!(Context, kept_count), offset_of!(Context, kept_room)]
            .map(|offset| self.field(offset));
        let behind = self.b.ins().iadd_imm_s(count, i64::from(width) + 2);
        let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, behind, room);
        self.b.ins().brif(fits, here, &[], full, &[]);

        self.b.switch_to_block(here);
        let place = self.kept_slot(count);
        let slots = (0..width).map(|part| self.whole(Reg(value.0.wrapping_add(part))));
        let slots: Vec<Value> = [header, element].into_iter().chain(slots).collect();
        let flags = self.flags(Region::Slots);
        for (at, slot) in (0..).zip(slots) {
            self.b.ins().store(flags, slot, place, at * size_of::<u64>() as i32);
        }
        self.set_field(offset_of!(Context, kept_count), behind);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(full);
        self.spill_operands(inst);
        let which = i64::from(buffer) | i64::from(value.0) << 16 | i64::from(width) << 32;
        let which = self.b.ins().iconst(I64, which);
        let stub = lists::hold as *const () as usize;
        let done = self.call_stub(stub, &[which, header, element]);
        self.or_fault_if_negative(done);
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(on);
    }

    /// The address of a slot that is kept.
    fn kept_slot(&mut self, at: Value) -> Value {
        let start = self.field(offset_of!(Context, kept));
        let offset = self.b.ins().ishl_imm_u(at, 3);
        self.b.ins().iadd(start, offset)
    }

    /// The address and number of the slots of a buffer.
    fn slots(&mut self, buffer: u16) -> (Value, Value) {
        let lists = self.field(offset_of!(Context, lists));
        let flags = self.flags(Region::Lists);
        let place = usize::from(buffer) * size_of::<Slice>();
        let start = (place + offset_of!(Slice, start)) as i32;
        let count = (place + offset_of!(Slice, count)) as i32;
        let start = self.b.ins().load(I64, flags, lists, start);
        (start, self.b.ins().load(I64, flags, lists, count))
    }

    fn slot(&mut self, start: Value, index: Value) -> Value {
        let offset = self.b.ins().ishl_imm_u(index, 3);
        let place = self.b.ins().iadd(start, offset);
        let flags = self.flags(Region::Slots);
        self.b.ins().load(I64, flags, place, 0)
    }
}
