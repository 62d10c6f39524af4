//! Guards: instructions that look ahead.
//!
//! In a [`Guard`], native code itself sets the values, keeps the old ones and restores them, and
//! stubs answer the questions in between. In other code stubs do all of this.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::access::{first, pointer};
use super::compile::entries;
use super::facts::jumps;
use super::stubs;
use super::translate::{Region, Translator};
use crate::mesh::tables::{DEAD, FaceState, Tables};
use crate::mesh::{ElementKind, OrbitCondition};
use crate::rewrite::{Code, ElementField, HalfedgeField, Inst, Label, Reg};

/// A part of code that looks ahead: it is entered only at its start, all values are set before any
/// question, and it is left with everything restored, or by a trap.
#[derive(Clone, Copy, Debug)]
pub(super) struct Guard {
    start: usize,
    /// The last instruction.
    last: usize,
}

/// A value that has been set, and has to be restored.
#[derive(Clone, Copy, Debug)]
pub(super) enum Set {
    /// One with this address.
    Here { before: Value, place: Value, offset: usize, region: Region },
    /// A pointer of each halfedge in a buffer; all had the same value.
    Along { before: Value, slots: (Value, Value), field: HalfedgeField },
}

/// A condition that is asked, and the refusal if it does not hold.
struct GuardCall {
    condition: OrbitCondition,
    to: Reg,
    refusal: u16,
    otherwise: Label,
}

/// Whether a condition is about the spokes of a vertex and nothing else.
fn is_about_star(condition: OrbitCondition) -> bool {
    matches!(
        condition,
        OrbitCondition::OneHole
            | OrbitCondition::FacesDiffer
            | OrbitCondition::NeighborsDiffer
            | OrbitCondition::CornersDiffer
    )
}

impl Guard {
    pub(super) fn all(code: &Code) -> Vec<Self> {
        let clears = |(at, inst): (usize, &Inst)| matches!(inst, Inst::PreviewClear).then_some(at);
        let starts = code.insts.iter().enumerate().filter_map(clears);
        starts.filter_map(|start| Self::at(code, start)).collect()
    }

    fn at(code: &Code, start: usize) -> Option<Self> {
        let behind = code.insts.get(start + 1..)?;
        let is_set_here = |inst: &&Inst| match inst {
            Inst::PreviewStoreAll { buffer, .. } => *buffer < code.buffers,
            _ => is_store(inst),
        };
        let stores = behind.iter().take_while(is_set_here).count();
        let asks = behind[stores..].iter().take_while(|inst| is_asked_within(inst));
        let undone = asks.enumerate().filter(|(_, inst)| matches!(inst, Inst::PreviewUndo));
        let (undone, _) = undone.last()?;
        let (first, last) = (start + 1 + stores, start + 1 + stores + undone);
        let is_outside = |at: usize| !(first..=last).contains(&at);
        let comes_in = |(from, to): (usize, usize)| {
            (start + 1..=last).contains(&to) && (to < first || is_outside(from))
        };
        let begins = |entry: &u32| (start..=last).contains(&(*entry as usize));
        let is_entered = jumps(code).any(comes_in) || entries(code).iter().any(begins);
        (!is_entered).then_some(Self { start, last })
    }

    pub(super) fn contains(&self, at: usize) -> bool {
        (self.start..=self.last).contains(&at)
    }
}

fn is_store(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::PreviewStore { .. }
            | Inst::PreviewStoreHalfedge { .. }
            | Inst::PreviewStoreHole { .. }
            | Inst::PreviewStoreAll { .. }
    )
}

/// Whether native code executes an instruction between the stores and the end of a guard itself, or
/// leaves by a fault that restores the values.
fn is_asked_within(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::Foresee { .. } | Inst::Expect { .. } | Inst::Jump { .. } | Inst::PreviewUndo
    )
}

/// Whether an instruction sets or restores values of a preview.
fn sets(inst: &Inst) -> bool {
    is_store(inst)
        || matches!(inst, Inst::PreviewClear | Inst::PreviewNew { .. } | Inst::PreviewUndo)
}

impl Translator<'_, '_> {
    /// Translates an instruction that looks ahead; false if it is another one, or is left to the
    /// machine.
    pub(super) fn guard(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::Foresee { condition: OrbitCondition::TwoSpokes, to, element, .. } => {
                self.two_spokes(to, element);
            }
            Inst::Foresee { condition, to, element, at } => {
                let asked = self.asked_about_star(element);
                if asked.len() > 1 {
                    self.foresee_star(element, &asked);
                } else {
                    let holds = self.foresee(condition, [element, at]);
                    self.set_whole(to, holds);
                }
            }
            _ if !sets(inst) => return false,
            _ if self.guards.iter().any(|guard| guard.contains(self.at)) => self.set(inst),
            _ => self.set_by_machine(self.end_of_run(sets)),
        }
        true
    }

    /// Whether a vertex would have no single spoke; a stub answers about a new one.
    fn two_spokes(&mut self, to: Reg, vertex: Reg) {
        let id = self.id(vertex);
        let [here, some, other, on] = [(); 4].map(|()| self.b.create_block());
        self.b.set_cold_block(other);
        let is_in_range = self.is_in_range(ElementKind::Vertex, id);
        self.b.ins().brif(is_in_range, here, &[], other, &[]);

        self.b.switch_to_block(here);
        let holds = self.b.ins().iconst(I64, 1);
        self.set_whole(to, holds);
        let place = self.place(ElementKind::Vertex, id);
        let (region, offset) = first(ElementField::Vertex);
        let start = self.number(region, place, offset);
        let is_none = self.b.ins().icmp_imm_u(IntCC::Equal, start, i64::from(u32::MAX));
        self.b.ins().brif(is_none, on, &[], some, &[]);

        self.b.switch_to_block(some);
        let mut at = start;
        for field in [HalfedgeField::Prev, HalfedgeField::Twin] {
            let next = self.b.create_block();
            let is_in_range = self.is_in_range(ElementKind::Halfedge, at);
            self.b.ins().brif(is_in_range, next, &[], other, &[]);
            self.b.switch_to_block(next);
            let place = self.place(ElementKind::Halfedge, at);
            let (offset, region, _) = pointer(field);
            at = self.number(region, place, offset);
        }
        let differ = self.b.ins().icmp(IntCC::NotEqual, at, start);
        let holds = self.b.ins().uextend(I64, differ);
        self.set_whole(to, holds);
        self.b.ins().jump(on, &[]);

        self.b.switch_to_block(other);
        let holds = self.foresee(OrbitCondition::TwoSpokes, [vertex; 2]);
        self.set_whole(to, holds);
        self.join(on);
    }

    /// The conditions of a vertex, answered by one walk around it, that this and the following
    /// instructions ask one after the other, each with the refusal if it does not hold.
    fn asked_about_star(&self, vertex: Reg) -> Vec<GuardCall> {
        let insts = self.unit.code.insts.get(self.at..).unwrap_or_default();
        let pairs = insts.chunks_exact(2).enumerate().map_while(|(pair, two)| {
            let at = self.at + 2 * pair;
            let is_entered = (at.max(self.at + 1)..at + 2).any(|at| self.blocks[at].is_some());
            match *two {
                [
                    Inst::Foresee { condition, to, element, .. },
                    Inst::Expect { condition: asked, refusal, otherwise },
                ] if is_about_star(condition)
                    && (element, asked) == (vertex, to)
                    && !is_entered =>
                {
                    Some(GuardCall { condition, to, refusal, otherwise })
                }
                _ => None,
            }
        });
        pairs.take(stubs::MOST_ASKED).collect()
    }

    /// Asks all these conditions by one call of a stub.
    fn foresee_star(&mut self, vertex: Reg, all: &[GuardCall]) {
        let packed = all
            .iter()
            .rev()
            .fold(0, |packed, asked| packed << stubs::BITS | (asked.condition as i64 + 1));
        let packed = self.b.ins().iconst(I64, packed);
        let (vertex, at) = (self.id(vertex), self.b.ins().iconst(I64, self.at as i64));
        let stub = stubs::foresee_star as *const () as usize;
        let count = self.call_stub(stub, &[packed, vertex, at]);
        self.leave_restored_if_negative(count);
        for (at, asked) in (0..).zip(all) {
            let holds = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThan, count, at);
            let truth = self.b.ins().uextend(I64, holds);
            self.set_whole(asked.to, truth);
            self.expect(truth, asked.refusal, asked.otherwise);
        }
        self.skip = 2 * all.len() - 1;
    }

    /// The answer of a stub about an element, and the second one of a condition about two.
    fn foresee(&mut self, condition: OrbitCondition, elements: [Reg; 2]) -> Value {
        let number = self.b.ins().iconst(I64, condition as i64);
        let [element, at] = elements.map(|reg| self.id(reg));
        let stub = stubs::foresee as *const () as usize;
        let holds = self.call_stub(stub, &[number, element, at]);
        self.or_fault_if_negative(holds);
        holds
    }

    fn set(&mut self, inst: &Inst) {
        match *inst {
            Inst::PreviewStore { field, halfedge, value } => {
                let place = self.living(ElementKind::Halfedge, halfedge);
                let (offset, region, leads_to) = pointer(field);
                let value = self.set_value(leads_to, value);
                self.set_here(value, place, offset, region);
            }
            Inst::PreviewStoreHalfedge { of, element, value } => {
                let place = self.living(of.kind(), element);
                let (region, offset) = first(of);
                let value = self.set_value(ElementKind::Halfedge, value);
                self.set_here(value, place, offset, region);
            }
            Inst::PreviewStoreHole { face, hole } => {
                self.living(ElementKind::Face, face);
                let id = self.id(face);
                let (place, count) = (self.state_place(id), self.holes_with(id, hole));
                let value = self.b.ins().iconst(I8, FaceState::of_living(hole) as i64);
                self.set_here(value, place, 0, Region::FaceStates);
                let holes = self.table_field(offset_of!(Tables, holes));
                self.set_here(count, holes, 0, Region::Holes);
            }
            Inst::PreviewStoreAll { field, buffer, value } => {
                let value = self.set_value(pointer(field).2, value);
                self.set_along(field, buffer, value);
            }
            Inst::PreviewUndo => self.put_back(&self.set.clone()),
            Inst::PreviewClear => {
                self.set.clear();
                self.call_stub(stubs::clear_preview as *const () as usize, &[]);
            }
            _ => {}
        }
    }

    /// The number that a pointer is set to: any except [`DEAD`], which marks an erased element.
    fn set_value(&mut self, kind: ElementKind, value: Reg) -> Value {
        let id = self.id(value);
        if !self.fact(value).is_in_range(kind) {
            let is_one = self.b.ins().icmp_imm_u(IntCC::NotEqual, id, i64::from(DEAD));
            self.or_fault(is_one);
        }
        self.b.ins().ireduce(I32, id)
    }

    fn set_here(&mut self, value: Value, place: Value, offset: usize, region: Region) {
        let ty = self.b.func.dfg.value_type(value);
        let before = self.load(ty, region, place, offset);
        self.store(region, value, place, offset);
        self.set.push(Set::Here { before, place, offset, region });
    }

    /// Sets a pointer of each halfedge in a buffer, if it leads from all of them to the same
    /// element, as in every valid mesh.
    fn set_along(&mut self, field: HalfedgeField, buffer: u16, value: Value) {
        let (offset, region, _) = pointer(field);
        let slots @ (start, count) = self.slots(buffer);
        let (before, on) = (self.b.declare_var(I32), self.b.create_block());
        self.b.def_var(before, value);
        let some = self.b.create_block();
        self.b.ins().brif(count, some, &[], on, &[]);
        self.b.switch_to_block(some);
        let zero = self.b.ins().iconst(I64, 0);
        let first = self.slot(start, zero);
        let first = self.record(ElementKind::Halfedge, first);
        let shared = self.load(I32, region, first, offset);
        self.b.def_var(before, shared);
        self.each_below(count, |this, at| {
            let id = this.slot(start, at);
            let record = this.record(ElementKind::Halfedge, id);
            let lives = this.is_not_dead(ElementKind::Halfedge, record);
            this.or_fault(lives);
            let own = this.load(I32, region, record, offset);
            let is_shared = this.b.ins().icmp(IntCC::Equal, own, shared);
            this.or_fault(is_shared);
        });
        self.join(on);
        let before = self.b.use_var(before);
        self.store_along(field, slots, value);
        self.set.push(Set::Along { before, slots, field });
    }

    /// Stores a pointer of each halfedge in a buffer, all of which have records.
    fn store_along(&mut self, field: HalfedgeField, (start, count): (Value, Value), value: Value) {
        let (offset, region, _) = pointer(field);
        self.each_below(count, |this, at| {
            let id = this.slot(start, at);
            let place = this.place(ElementKind::Halfedge, id);
            this.store(region, value, place, offset);
        });
    }

    /// Restores the values that have been set, the last first.
    pub(super) fn put_back(&mut self, all: &[Set]) {
        for set in all.iter().rev() {
            match *set {
                Set::Here { before, place, offset, region } => {
                    self.store(region, before, place, offset);
                }
                Set::Along { before, slots, field } => self.store_along(field, slots, before),
            }
        }
    }

    /// Restores the values that have been set and leaves, if the answer of a stub is negative.
    fn leave_restored_if_negative(&mut self, answer: Value) {
        let (failed, on) = (self.b.create_block(), self.b.create_block());
        self.b.set_cold_block(failed);
        let has_failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, answer, 0);
        self.b.ins().brif(has_failed, failed, &[], on, &[]);
        self.b.switch_to_block(failed);
        self.put_back(&self.set.clone());
        self.b.ins().jump(self.leave, &[]);
        self.go_on(on);
    }

    /// Lets a stub execute the instructions up to, but without, `end`.
    fn set_by_machine(&mut self, end: usize) {
        let (first, code) = (self.at, self.unit.code);
        let all = &code.insts[first..end];
        all.iter().for_each(|inst| self.spill_operands(inst));
        let span = self.b.ins().iconst(I64, (first | end << 32) as i64);
        let done = self.call_stub(stubs::set_preview as *const () as usize, &[span]);
        // The stub has restored the values of the preview before the trap.
        self.leave_restored_if_negative(done);
        all.iter().for_each(|inst| self.reload_written(inst));
        self.skip = end - first - 1;
    }
}
