//! Instructions about the members of families and fans as a whole: they fill buffers with them,
//! compare them, and store to them.
//!
//! Native code fills a buffer while it has room and, for new members, slots are spare; stubs do the
//! rest.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, InstBuilder, Value};

use super::Variant;
use super::access::pointer;
use super::stubs;
use super::translate::Translator;
use crate::mesh::ElementKind;
use crate::rewrite::{Inst, List};

/// The greatest number of members that are compared pair by pair.
const FEW: i64 = 12;

impl Translator<'_, '_> {
    /// Translates an instruction about members of families; false if it is another one, or is left
    /// to the machine.
    pub(super) fn family(&mut self, inst: &Inst) -> bool {
        let buffers = self.unit.code.buffers;
        let on = self.b.create_block();
        match *inst {
            Inst::BufferClear { buffer } if buffer < buffers => {
                self.clear(buffer);
                self.b.ins().jump(on, &[]);
            }
            Inst::BufferNew { kind, cycle, buffer }
                if cycle.max(buffer) < buffers && cycle != buffer =>
            {
                let slow = self.slow_block();
                if self.variant == Variant::Plain {
                    let (_, count) = self.slots(cycle);
                    let list = self.list_of(buffer);
                    let room = self.in_list(list, List::ROOM);
                    let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, count, room);
                    self.or_slow(fits, slow);
                    let first = self.take_spare(&[(kind, count)], slow)[0];
                    let start = self.in_list(list, List::START);
                    self.each_below(count, |this, at| {
                        let id = this.b.ins().iadd(first, at);
                        this.set_slot(start, at, id);
                    });
                    self.set_count(list, count);
                    self.b.ins().jump(on, &[]);
                } else {
                    self.b.ins().jump(slow, &[]);
                }
                self.fill_by_stub(slow, on);
            }
            Inst::BufferAppend { from, to } if from.max(to) < buffers && from != to => {
                self.deal([from, to], [0, 1], 0, on);
            }
            Inst::BufferStride { from, to, place, period, turn }
                if from.max(to) < buffers && from != to =>
            {
                self.deal([from, to], [place, period.max(1)], turn, on);
            }
            Inst::StoreAll { field, buffer, value }
                if buffer < buffers && self.variant == Variant::Plain =>
            {
                let (offset, region, leads_to) = pointer(field);
                let value = self.target(leads_to, value);
                let (start, count) = self.slots(buffer);
                self.each_below(count, |this, at| {
                    let id = this.slot(start, at);
                    let id = this.b.ins().band_imm_u(id, i64::from(u32::MAX));
                    let record = this.record(ElementKind::Halfedge, id);
                    let lives = this.is_not_dead(ElementKind::Halfedge, record);
                    this.or_fault(lives);
                    this.store(region, value, record, offset);
                });
                self.b.ins().jump(on, &[]);
            }
            Inst::ExpectAllDistinct { buffer, refusal, otherwise } if buffer < buffers => {
                let are_distinct = self.are_distinct(buffer);
                self.expect(are_distinct, refusal, otherwise);
                self.b.ins().jump(on, &[]);
            }
            _ => {
                self.join(on);
                return false;
            }
        }
        self.go_on(on);
        true
    }

    /// Appends every `period`-th slot of a buffer from `first` on to another one, as
    /// [`deal`](crate::rewrite::families::deal) does.
    fn deal(&mut self, [from, to]: [u16; 2], [first, period]: [u16; 2], turn: i16, on: Block) {
        let slow = self.slow_block();
        let (source, all) = self.slots(from);
        let first = self.b.ins().iconst(I64, i64::from(first));
        let rest = self.b.ins().isub(all, first);
        let count = match period {
            1 => rest,
            _ => {
                let up = self.b.ins().iadd_imm_s(rest, i64::from(period) - 1);
                self.b.ins().sdiv_imm_s(up, i64::from(period))
            }
        };
        let none = self.b.ins().iconst(I64, 0);
        let count = self.b.ins().smax(count, none);
        let list = self.list_of(to);
        let [start, before, room] =
            [List::START, List::COUNT, List::ROOM].map(|offset| self.in_list(list, offset));
        let end = self.b.ins().iadd(before, count);
        let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, end, room);
        self.or_slow(fits, slow);
        self.each_below(count, |this, at| {
            let place = this.b.ins().imul_imm_s(at, i64::from(period));
            let place = this.b.ins().iadd(first, place);
            let value = this.slot(source, place);
            let at = if turn == 0 { at } else { this.in_cycle(at, turn, count) };
            let at = this.b.ins().iadd(before, at);
            this.set_slot(start, at, value);
        });
        self.set_count(list, end);
        self.b.ins().jump(on, &[]);
        self.fill_by_stub(slow, on);
    }

    /// Whether no two slots of a buffer are equal. A stub sorts them if they are many.
    fn are_distinct(&mut self, buffer: u16) -> Value {
        let result = self.b.declare_var(I64);
        let [few, many, equal, distinct, on] = [(); 5].map(|()| self.b.create_block());
        self.b.set_cold_block(many);
        let (start, count) = self.slots(buffer);
        let are_few = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThanOrEqual, count, FEW);
        self.b.ins().brif(are_few, few, &[], many, &[]);

        self.b.switch_to_block(few);
        self.each_below(count, |this, left| {
            let value = this.slot(start, left);
            this.each_below(left, |this, right| {
                let other = this.slot(start, right);
                let next = this.b.create_block();
                let is_equal = this.b.ins().icmp(IntCC::Equal, value, other);
                this.b.ins().brif(is_equal, equal, &[], next, &[]);
                this.b.switch_to_block(next);
            });
        });
        self.b.ins().jump(distinct, &[]);
        for (block, answer) in [(equal, 0), (distinct, 1)] {
            self.b.switch_to_block(block);
            let answer = self.b.ins().iconst(I64, answer);
            self.b.def_var(result, answer);
            self.b.ins().jump(on, &[]);
        }

        self.b.switch_to_block(many);
        let number = self.b.ins().iconst(I64, i64::from(buffer));
        let answer = self.call_stub(stubs::are_distinct as *const () as usize, &[number]);
        self.or_fault_if_negative(answer);
        self.b.def_var(result, answer);
        self.join(on);
        self.b.use_var(result)
    }

    fn slow_block(&mut self) -> Block {
        let slow = self.b.create_block();
        self.b.set_cold_block(slow);
        slow
    }

    /// Lets a stub execute the current instruction in the block `slow`, and jumps to `on`.
    fn fill_by_stub(&mut self, slow: Block, on: Block) {
        self.b.switch_to_block(slow);
        self.call_here(stubs::fill as *const () as usize);
        self.b.ins().jump(on, &[]);
    }

    /// Runs code for each number below `count`.
    pub(super) fn each_below(&mut self, count: Value, each: impl FnOnce(&mut Self, Value)) {
        let at = self.b.declare_var(I64);
        let [head, body, end] = [(); 3].map(|()| self.b.create_block());
        let zero = self.b.ins().iconst(I64, 0);
        self.b.def_var(at, zero);
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(head);
        let now = self.b.use_var(at);
        let is_below = self.b.ins().icmp(IntCC::UnsignedLessThan, now, count);
        self.b.ins().brif(is_below, body, &[], end, &[]);
        self.b.switch_to_block(body);
        each(self, now);
        let next = self.b.ins().iadd_imm_s(now, 1);
        self.b.def_var(at, next);
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(end);
    }
}
