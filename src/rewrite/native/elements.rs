//! Instructions that read the mesh.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I64};
use cranelift_codegen::ir::{InstBuilder, Value};
use std::mem::offset_of;

use super::access::{first, pointer};
use super::stubs;
use super::translate::{Region, Translator};
use crate::mesh::tables::{FaceState, Tables};
use crate::mesh::{AttributeType, ElementKind};
use crate::rewrite::{ElementField, Elements, HalfedgeField, Inst, Label, Question, Reg, Walk};

impl Translator<'_, '_> {
    /// Translates an instruction that reads the mesh; false if it is another one, or is left to the
    /// machine.
    pub(super) fn access(&mut self, inst: &Inst) -> bool {
        match *inst {
            Inst::Load { field, to, halfedge } => {
                let record = self.living(ElementKind::Halfedge, halfedge);
                let (offset, region, _) = pointer(field);
                let value = self.number(region, record, offset);
                self.set_whole(to, value);
            }
            Inst::LoadHalfedge { of, to, element } => {
                let record = self.living(of.kind(), element);
                let (region, offset) = first(of);
                let value = self.number(region, record, offset);
                self.set_whole(to, value);
            }
            Inst::LoadHole { to, face } => {
                self.living(ElementKind::Face, face);
                let id = self.id(face);
                let is_hole = self.is_in_state(id, FaceState::Hole);
                let is_hole = self.b.ins().uextend(I64, is_hole);
                self.set_whole(to, is_hole);
            }
            Inst::LoadPosition { to, vertex } => {
                self.living(ElementKind::Vertex, vertex);
                let place = self.position(vertex);
                let values = [0, 8, 16].map(|at| self.load(F64, Region::Position, place, at));
                self.set_vector(to, values);
            }
            Inst::NextLiving { of, element, otherwise } => self.next_living(of, element, otherwise),
            Inst::JumpUnlessLiving { of, element, to } => {
                let id = self.id(element);
                let to = self.block(to);
                let (look, on) = (self.b.create_block(), self.b.create_block());
                let is_in_range = self.is_in_range(of.kind(), id);
                self.b.ins().brif(is_in_range, look, &[], to, &[]);
                self.b.switch_to_block(look);
                let lives = self.lives(of, id);
                self.b.ins().brif(lives, on, &[], to, &[]);
                self.go_on(on);
            }
            Inst::WalkBegin { walk: _, from, at, turns, otherwise } => {
                let first = self.id(from);
                let is_none = self.b.ins().icmp_imm_u(IntCC::Equal, first, i64::from(u32::MAX));
                self.jump_if(is_none, otherwise);
                let zero = self.b.ins().iconst(I64, 0);
                self.set_whole(at, first);
                self.set_whole(turns, zero);
            }
            Inst::WalkNext { walk, from, at, turns, again } => {
                let record = self.living(ElementKind::Halfedge, at);
                let next = self.step_of_walk(walk, record);
                let first = self.id(from);
                let (back, on) = (self.b.create_block(), self.b.create_block());
                let is_back = self.b.ins().icmp(IntCC::Equal, next, first);
                self.b.ins().brif(is_back, back, &[], on, &[]);
                self.go_on(on);
                let turn = self.whole(turns);
                let turn = self.b.ins().iadd_imm_s(turn, 1);
                let count = self.table_field(offset_of!(Tables, halfedge_count));
                let goes_on = self.b.ins().icmp(IntCC::SignedLessThan, turn, count);
                self.or_fault(goes_on);
                self.set_whole(at, next);
                self.set_whole(turns, turn);
                let again = self.block(again);
                self.b.ins().jump(again, &[]);
                self.b.switch_to_block(back);
            }
            Inst::LoadAttribute { attribute, to, element } => {
                let Some(ty) = self.unit.environment.type_of(attribute) else { return false };
                let Some(place) = self.value_place(attribute, ty, element) else { return false };
                let flags = self.flags(Region::Values);
                let first = i32::from(to.0);
                match ty {
                    AttributeType::Bool => {
                        let value = self.byte(flags, place, 0);
                        self.set_whole(to, value);
                    }
                    AttributeType::Int => {
                        let value = self.b.ins().load(I64, flags, place, 0);
                        self.set_whole(to, value);
                    }
                    _ => {
                        let parts = 0..ty.width() as i32;
                        for part in parts {
                            let value = self.b.ins().load(F64, flags, place, part * 8);
                            self.set_real(Reg((first + part) as u16), value);
                        }
                    }
                }
            }
            Inst::Count { kind, to } => {
                let kind = self.b.ins().iconst(I64, kind as i64);
                let count = self.call_stub(stubs::count as *const () as usize, &[kind]);
                self.set_whole(to, count);
            }
            Inst::CountHoles { to } => {
                let count = self.hole_count();
                self.set_whole(to, count);
            }
            Inst::Ask { question: Question::LengthEdge, to, elements: [edge, _] } => {
                let length = self.length(edge);
                self.set_real(to, length);
            }
            Inst::Ask { question, to, elements } if question.reals() == 0 => {
                self.ask_whole(question, to, elements);
            }
            Inst::Ask { .. } => {
                self.spill_operands(inst);
                let number = self.b.ins().iconst(I64, self.at as i64);
                let done = self.call_stub(stubs::answer as *const () as usize, &[number]);
                self.or_fault_if_negative(done);
                self.reload_written(inst);
            }
            _ => return false,
        }
        true
    }

    /// The number of holes.
    pub(super) fn hole_count(&mut self) -> Value {
        let holes = self.table_field(offset_of!(Tables, holes));
        self.load(I64, Region::Holes, holes, 0)
    }

    /// The halfedge of a walk that follows the one with this record.
    pub(super) fn step_of_walk(&mut self, walk: Walk, record: Value) -> Value {
        match walk {
            Walk::Loop => self.leads(record, HalfedgeField::Next),
            Walk::Star => {
                let before = self.leads(record, HalfedgeField::Prev);
                let before = self.record(ElementKind::Halfedge, before);
                self.leads(before, HalfedgeField::Twin)
            }
        }
    }

    /// Advances to the first living element.
    fn next_living(&mut self, of: Elements, element: Reg, otherwise: Label) {
        let id = self.b.declare_var(I64);
        let first = self.whole(element);
        self.b.def_var(id, first);
        let none = self.block(otherwise);
        let [head, look, next, found] = [(); 4].map(|()| self.b.create_block());
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(head);
        let at = self.b.use_var(id);
        let is_in_range = self.is_in_range(of.kind(), at);
        self.b.ins().brif(is_in_range, look, &[], none, &[]);
        self.b.switch_to_block(look);
        let lives = self.lives(of, at);
        self.b.ins().brif(lives, found, &[], next, &[]);
        self.b.switch_to_block(next);
        let following = self.b.ins().iadd_imm_s(at, 1);
        self.b.def_var(id, following);
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(found);
        self.set_whole(element, at);
    }

    /// The length of an edge, as [`Mesh::length`](crate::mesh::Mesh::length) computes it.
    fn length(&mut self, edge: Reg) -> Value {
        let record = self.living(ElementKind::Edge, edge);
        let (region, offset) = first(ElementField::Edge);
        let half = self.number(region, record, offset);
        let half = self.record(ElementKind::Halfedge, half);
        let (vertex, vertices, _) = pointer(HalfedgeField::Vertex);
        let (twin, twins, _) = pointer(HalfedgeField::Twin);
        let from = self.number(vertices, half, vertex);
        let twin = self.number(twins, half, twin);
        let twin = self.record(ElementKind::Halfedge, twin);
        let to = self.number(vertices, twin, vertex);
        let [from, to] = [from, to].map(|id| {
            self.record(ElementKind::Vertex, id);
            let place = self.position_of(id);
            [0, 8, 16].map(|at| self.load(F64, Region::Position, place, at))
        });
        let way = [0, 1, 2].map(|part| self.b.ins().fsub(to[part], from[part]));
        let square = self.dot(way, way);
        self.b.ins().sqrt(square)
    }
}
