//! Translation of instructions that write to the mesh, count iterations of loops, and maintain the
//! keys of drains.
//!
//! Journals and drains are notified before a write: a stub is called if a journal is open, or a
//! drain is open whose keys depend on the field.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I8, I32, I64};
use cranelift_codegen::ir::{Block, InstBuilder, Value};

use super::Variant;
use super::access::{TABLES, first, pointer, table};
use super::context::Context;
use super::stubs;
use super::translate::{Region, Translator};
use crate::mesh::tables::{FaceState, Tables};
use crate::mesh::{AttributeType, ElementKind};
use crate::rewrite::paths::Fields;
use crate::rewrite::watch::{DEPTHS, ITERATIONS_PER_POLL, Loop, Progress};
use crate::rewrite::{Inst, Label, Reg, Room};

impl Translator<'_, '_> {
    /// Translates an instruction that writes; returns false if it is another one, or one for the
    /// machine.
    pub(super) fn write(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::Store { field, halfedge, value } => {
                let (offset, region, leads_to) = pointer(field);
                let record = self.living(ElementKind::Halfedge, halfedge);
                let value = self.target(leads_to, value);
                let args = |this: &mut Self| {
                    let number = this.b.ins().iconst(I64, field as i64);
                    [number, this.id(halfedge), this.b.ins().uextend(I64, value)]
                };
                let stub = stubs::pointer_set as *const () as usize;
                self.tell(ElementKind::Halfedge, Fields::pointer(field), stub, args);
                self.store(region, value, record, offset);
            }
            Inst::StoreHalfedge { of, element, value } => {
                let record = self.living(of.kind(), element);
                let value = self.target(ElementKind::Halfedge, value);
                let args = |this: &mut Self| {
                    let number = this.b.ins().iconst(I64, of as i64);
                    [number, this.id(element), this.b.ins().uextend(I64, value)]
                };
                let stub = stubs::first_set as *const () as usize;
                self.tell(of.kind(), Fields::FIRST, stub, args);
                let (region, offset) = first(of);
                self.store(region, value, record, offset);
            }
            // The machine does it, and notifies of the write.
            Inst::StoreHole { .. } if self.variant == Variant::Careful => return false,
            Inst::StoreHole { face, hole } => {
                self.living(ElementKind::Face, face);
                let id = self.id(face);
                let count = self.holes_with(id, hole);
                let place = self.state_place(id);
                let now = self.b.ins().iconst(I8, FaceState::of_living(hole) as i64);
                self.store(Region::FaceStates, now, place, 0);
                let holes = self.table_field(offset_of!(Tables, holes));
                self.store(Region::Holes, count, holes, 0);
            }
            Inst::StorePosition { vertex, value } => {
                self.living(ElementKind::Vertex, vertex);
                let finite = self.is_finite(value);
                self.or_fault(finite);
                let stub = stubs::position_set as *const () as usize;
                self.tell(ElementKind::Vertex, Fields::POSITION, stub, |this| [this.id(vertex)]);
                let place = self.position(vertex);
                for (at, part) in (0..).zip(self.vector(value)) {
                    self.store(Region::Position, part, place, at * 8);
                }
            }
            Inst::StoreAttribute { attribute, element, value } => {
                let Some((kind, ty)) = self.unit.environment.column(attribute) else {
                    return false;
                };
                let Some(place) = self.value_place(attribute, ty, element) else { return false };
                let args = |this: &mut Self| {
                    let number = this.b.ins().iconst(I64, i64::from(attribute));
                    [number, this.id(element)]
                };
                let stub = stubs::value_set as *const () as usize;
                self.tell(kind, Fields::attribute(attribute), stub, args);
                if ty == AttributeType::Bool {
                    let is_true = self.truth(value);
                    self.store(Region::Values, is_true, place, 0);
                    return true;
                }
                for part in 0..ty.width() as u16 {
                    let bits = self.whole(Reg(value.0.wrapping_add(part)));
                    self.store(Region::Values, bits, place, usize::from(part) * 8);
                }
            }
            Inst::New { .. } => self.add(),
            Inst::Erase { .. } => {
                // All that are erased together by one call.
                let (first, code) = (self.at, self.unit.code);
                let end = self.end_of_run(|inst| matches!(inst, Inst::Erase { .. }));
                code.insts[first..end].iter().for_each(|inst| self.spill_operands(inst));
                let span = self.b.ins().iconst(I64, (first | end << 32) as i64);
                let done = self.call_stub(stubs::erase as *const () as usize, &[span]);
                self.or_fault_if_negative(done);
                self.skip = end - first - 1;
            }
            Inst::ExpectRoom { room, .. } => {
                let Room { vertices, halfedges, edges, faces } = room;
                let counts = ElementKind::ALL.into_iter().zip([vertices, halfedges, edges, faces]);
                let wanted = counts.filter(|(_, count)| *count > 0);
                let wanted: Vec<(ElementKind, Value)> = wanted
                    .map(|(kind, count)| (kind, self.b.ins().iconst(I64, i64::from(count))))
                    .collect();
                self.expect_room(inst, &wanted);
            }
            Inst::ExpectRoomFor { kind, count, .. } => {
                let count = self.whole(count);
                self.expect_room(inst, &[(kind, count)]);
            }
            Inst::Tick => self.iteration(stubs::tick as *const () as usize),
            Inst::Iteration { depth, done, total } => {
                if usize::from(depth) < DEPTHS {
                    let progress = self.field(offset_of!(Context, progress));
                    let place =
                        offset_of!(Progress, loops) + usize::from(depth) * size_of::<Loop>();
                    for (reg, offset) in
                        [(done, offset_of!(Loop, done)), (total, offset_of!(Loop, total))]
                    {
                        let value = self.whole(reg);
                        self.store(Region::Progress, value, progress, place + offset);
                    }
                }
                self.iteration(stubs::iteration as *const () as usize);
            }
            Inst::DrainStale { to, otherwise } => {
                self.spill_for_drain();
                let found = self.call_stub(stubs::next_stale as *const () as usize, &[]);
                self.element_or(found, to, otherwise);
            }
            Inst::DrainKey { key } => {
                let (number, key) = (self.b.ins().iconst(I64, self.at as i64), self.real(key));
                let signature = self.signature(&[I64, I64, F64], &[I64]);
                let stub = stubs::set_key as *const () as usize;
                let done = self.call(stub, signature, &[self.context, number, key])[0];
                self.leave_if_negative(done);
            }
            Inst::DrainLeast { to, otherwise } => {
                let found = self.call_stub(stubs::least as *const () as usize, &[]);
                self.element_or(found, to, otherwise);
            }
            Inst::DrainTake => {
                let done = self.call_stub(stubs::take_least as *const () as usize, &[]);
                self.leave_if_negative(done);
            }
            _ => return false,
        }
        true
    }

    /// The number of holes if a face, by its number, is a hole or not.
    pub(super) fn holes_with(&mut self, face: Value, hole: bool) -> Value {
        let before = self.is_in_state(face, FaceState::Hole);
        let before = self.b.ins().uextend(I64, before);
        let count = self.hole_count();
        let others = self.b.ins().isub(count, before);
        self.b.ins().iadd_imm_s(others, i64::from(hole))
    }

    /// Continues if there is room for new elements; else the machine executes the instruction.
    fn expect_room(&mut self, inst: &Inst, wanted: &[(ElementKind, Value)]) {
        let [full, on] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(full);
        for &(kind, count) in wanted {
            let room = offset_of!(Tables, room) + kind as usize * size_of::<usize>();
            let (room, next) = (self.table_field(room), self.b.create_block());
            let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, count, room);
            self.b.ins().brif(fits, next, &[], full, &[]);
            self.b.switch_to_block(next);
        }
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(full);
        self.step(inst);
        self.join(on);
    }

    /// Sets a register to the element that a stub has returned; jumps if there is none.
    fn element_or(&mut self, found: Value, to: Reg, otherwise: Label) {
        let is_none = self.b.ins().icmp_imm_s(IntCC::Equal, found, stubs::NONE);
        self.jump_if(is_none, otherwise);
        self.leave_if_negative(found);
        self.set_whole(to, found);
    }

    /// Counts an iteration; once in [`ITERATIONS_PER_POLL`] iterations a stub calls the watcher.
    fn iteration(&mut self, stub: usize) {
        let progress = self.field(offset_of!(Context, progress));
        let iterations = offset_of!(Progress, iterations);
        let before = self.load(I32, Region::Progress, progress, iterations);
        let now = self.b.ins().iadd_imm_s(before, 1);
        let rest = self.b.ins().band_imm_u(now, i64::from(ITERATIONS_PER_POLL - 1));
        let [look, pass, on] = [(); 3].map(|()| self.b.create_block());
        self.b.set_cold_block(look);
        self.b.ins().brif(rest, pass, &[], look, &[]);
        self.b.switch_to_block(look);
        self.call_here(stub);
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(pass);
        self.store(Region::Progress, now, progress, iterations);
        self.join(on);
    }

    /// Calls a stub if writes to these fields of elements of this kind are to be notified.
    fn tell<const N: usize>(
        &mut self,
        kind: ElementKind,
        fields: Fields,
        stub: usize,
        args: impl Fn(&mut Self) -> [Value; N],
    ) {
        if self.variant != Variant::Careful {
            return;
        }
        let place = offset_of!(Context, listens) + kind as usize * size_of::<u32>();
        let listens = self.load(I32, Region::Context, self.context, place);
        let is_told = self.b.ins().band_imm_u(listens, i64::from(fields.bits()));
        let (tell, on) = (self.b.create_block(), self.b.create_block());
        self.b.ins().brif(is_told, tell, &[], on, &[]);
        self.b.switch_to_block(tell);
        let args = args(self);
        let done = self.call_stub(stub, &args);
        self.leave_if_negative(done);
        self.join(on);
    }

    /// Translates this instruction and those of its sort that follow it as one.
    fn add(&mut self) {
        let (first, code) = (self.at, self.unit.code);
        let end = self.end_of_run(|inst| added(inst).is_some());
        let all = &code.insts[first..end];
        let on = self.b.create_block();
        let new: Vec<(ElementKind, Reg)> = all.iter().filter_map(added).collect();
        self.append(&new, on);
        let span = self.b.ins().iconst(I64, (first | end << 32) as i64);
        let done = self.call_stub(stubs::add as *const () as usize, &[span]);
        self.leave_if_negative(done);
        all.iter().for_each(|inst| self.reload_written(inst));
        self.join(on);
        self.skip = end - first - 1;
    }

    /// Appends new elements to the tables and jumps to `on`; continues here if nothing was done.
    fn append(&mut self, new: &[(ElementKind, Reg)], on: Block) {
        let counts = ElementKind::ALL.map(|kind| new.iter().filter(|one| one.0 == kind).count());
        if counts.iter().any(|&count| count > 0xffff) {
            return;
        }
        // Where writes are reported, so are new elements, and none is spare.
        if self.variant == Variant::Plain {
            let short = self.b.create_block();
            self.b.set_cold_block(short);
            let wanted = ElementKind::ALL.into_iter().zip(counts).filter(|(_, count)| *count > 0);
            let wanted: Vec<(ElementKind, Value)> = wanted
                .map(|(kind, count)| (kind, self.b.ins().iconst(I64, count as i64)))
                .collect();
            let taken = self.take_spare(&wanted, short);
            let mut firsts = [None; 4];
            for ((kind, _), first) in wanted.into_iter().zip(taken) {
                firsts[kind as usize] = Some(first);
            }
            self.number_new(new, firsts);
            self.b.ins().jump(on, &[]);
            self.b.switch_to_block(short);
        }
        let packed = counts.iter().rev().fold(0, |packed, &count| packed << 16 | count as i64);
        let packed = self.b.ins().iconst(I64, packed);
        let done = self.call_stub(stubs::append as *const () as usize, &[packed]);
        let [fast, slow] = [(); 2].map(|()| self.b.create_block());
        self.b.set_cold_block(slow);
        self.b.ins().brif(done, slow, &[], fast, &[]);
        self.b.switch_to_block(fast);
        let firsts = ElementKind::ALL.map(|kind| {
            let place = offset_of!(Context, appended) + kind as usize * size_of::<u32>();
            (counts[kind as usize] > 0).then(|| {
                let first = self.load(I32, Region::Context, self.context, place);
                self.b.ins().uextend(I64, first)
            })
        });
        self.number_new(new, firsts);
        self.b.ins().jump(on, &[]);
        self.b.switch_to_block(slow);
    }

    /// Takes spare slots for new elements of some kinds, and returns the first of each; jumps to
    /// `short` if there are not enough.
    pub(super) fn take_spare(
        &mut self,
        wanted: &[(ElementKind, Value)],
        short: Block,
    ) -> Vec<Value> {
        let place =
            |kind: ElementKind| offset_of!(Context, spare) + kind as usize * size_of::<u64>();
        let left = wanted.iter().map(|&(kind, count)| {
            let (spare, next) = (self.field(place(kind)), self.b.create_block());
            let fits = self.b.ins().icmp(IntCC::UnsignedLessThanOrEqual, count, spare);
            self.b.ins().brif(fits, next, &[], short, &[]);
            self.b.switch_to_block(next);
            self.b.ins().isub(spare, count)
        });
        let left: Vec<Value> = left.collect();
        let all = wanted.iter().zip(left).map(|(&(kind, count), left)| {
            self.set_field(place(kind), left);
            let room = TABLES + offset_of!(Tables, room) + kind as usize * size_of::<usize>();
            let before = self.field(room);
            let now = self.b.ins().isub(before, count);
            self.set_field(room, now);
            let (_, end, _) = table(kind);
            let first = self.field(TABLES + end);
            let now = self.b.ins().iadd(first, count);
            self.set_field(TABLES + end, now);
            first
        });
        all.collect()
    }

    /// Sets the registers of new elements, of which the first of each kind is given.
    fn number_new(&mut self, new: &[(ElementKind, Reg)], mut firsts: [Option<Value>; 4]) {
        for &(kind, to) in new {
            if let Some(next) = &mut firsts[kind as usize] {
                let id = *next;
                *next = self.b.ins().iadd_imm_s(id, 1);
                self.set_whole(to, id);
            }
        }
    }
}

/// The kind of the element that an instruction adds, and the register of its number.
fn added(inst: &Inst) -> Option<(ElementKind, Reg)> {
    match *inst {
        Inst::New { kind, to } => Some((kind, to)),
        _ => None,
    }
}
