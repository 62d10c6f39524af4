//! Instructions that read and write the mesh.
//!
//! An address is computed from a number only where that is below the number of records: tested
//! here, or known to have been. So native code touches nothing but the tables, on any mesh.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{F64, I8, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::context::{Context, Values};
use super::stubs;
use super::translate::{Region, Translator};
use crate::mesh::tables::{DEAD, FACE_HALFEDGE, FACE_HOLE, FACE_SIZE, Tables};
use crate::mesh::{AttributeType, ElementKind, HalfedgeRecord, glam};
use crate::rewrite::watch::TURNS_PER_LOOK;
use crate::rewrite::{ElementField, Elements, HalfedgeField, Inst, Label, Reg, Room};

const TABLES: usize = offset_of!(Context, tables);

/// Where a pointer of a halfedge lies, and where it leads.
fn pointer(field: HalfedgeField) -> (usize, Region, ElementKind) {
    use ElementKind::{Edge, Face, Halfedge, Vertex};
    match field {
        HalfedgeField::Next => (offset_of!(HalfedgeRecord, next), Region::Next, Halfedge),
        HalfedgeField::Prev => (offset_of!(HalfedgeRecord, prev), Region::Prev, Halfedge),
        HalfedgeField::Twin => (offset_of!(HalfedgeRecord, twin), Region::Twin, Halfedge),
        HalfedgeField::Vertex => (offset_of!(HalfedgeRecord, vertex), Region::Vertex, Vertex),
        HalfedgeField::Edge => (offset_of!(HalfedgeRecord, edge), Region::Edge, Edge),
        HalfedgeField::Face => (offset_of!(HalfedgeRecord, face), Region::Face, Face),
    }
}

fn kind(of: ElementField) -> ElementKind {
    match of {
        ElementField::Vertex => ElementKind::Vertex,
        ElementField::Edge => ElementKind::Edge,
        ElementField::Face => ElementKind::Face,
    }
}

impl Translator<'_, '_> {
    /// Spells an instruction that reads or writes the mesh; false if it is none, or one for the
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
                let record = self.living(kind(of), element);
                let (region, offset) = first(of);
                let value = self.number(region, record, offset);
                self.set_whole(to, value);
            }
            Inst::LoadHole { to, face } => {
                let record = self.living(ElementKind::Face, face);
                let flags = self.flags(Region::Hole);
                let value = self.byte(flags, record, FACE_HOLE);
                self.set_whole(to, value);
            }
            Inst::LoadPosition { to, vertex } => {
                self.living(ElementKind::Vertex, vertex);
                let place = self.position(vertex);
                let flags = self.flags(Region::Position);
                let values = [0, 8, 16].map(|at| self.b.ins().load(F64, flags, place, at));
                self.set_vector(to, values);
            }
            Inst::Store { field, halfedge, value } => {
                let (offset, region, leads_to) = pointer(field);
                let record = self.living(ElementKind::Halfedge, halfedge);
                let value = self.target(leads_to, value);
                let flags = self.flags(region);
                self.b.ins().store(flags, value, record, offset as i32);
            }
            Inst::StoreHalfedge { of, element, value } => {
                let record = self.living(kind(of), element);
                let value = self.target(ElementKind::Halfedge, value);
                let (region, offset) = first(of);
                let flags = self.flags(region);
                self.b.ins().store(flags, value, record, offset as i32);
            }
            Inst::StoreHole { face, hole } => {
                let record = self.living(ElementKind::Face, face);
                let flags = self.flags(Region::Hole);
                let before = self.byte(flags, record, FACE_HOLE);
                let now = self.b.ins().iconst(I8, i64::from(hole));
                self.b.ins().store(flags, now, record, FACE_HOLE as i32);
                let holes = self.field(TABLES + offset_of!(Tables, holes));
                let flags = self.flags(Region::Holes);
                let count = self.b.ins().load(I64, flags, holes, 0);
                let others = self.b.ins().isub(count, before);
                let count = self.b.ins().iadd_imm_s(others, i64::from(hole));
                self.b.ins().store(flags, count, holes, 0);
            }
            Inst::StorePosition { vertex, value } => {
                self.living(ElementKind::Vertex, vertex);
                let finite = self.is_finite(value);
                self.or_fault(finite);
                let (place, flags) = (self.position(vertex), self.flags(Region::Position));
                for (at, part) in (0..).zip(self.vector(value)) {
                    self.b.ins().store(flags, part, place, at * 8);
                }
            }
            Inst::NewVertex { .. }
            | Inst::NewHalfedge { .. }
            | Inst::NewEdge { .. }
            | Inst::NewFace { .. }
            | Inst::Erase { .. } => self.add_and_erase(),
            Inst::ExpectRoom { room, .. } => {
                let Room { vertices, halfedges, edges, faces } = room;
                let counts = [vertices, halfedges, edges, faces].map(u64::from);
                let room = counts[0] | counts[1] << 16 | counts[2] << 32 | counts[3] << 48;
                let room = self.b.ins().iconst(I64, room as i64);
                let fits = self.call_stub(stubs::has_room as *const () as usize, &[room]);
                let (on, full) = (self.b.create_block(), self.b.create_block());
                self.b.set_cold_block(full);
                self.b.ins().brif(fits, on, &[], full, &[]);
                self.b.switch_to_block(full);
                self.step(inst);
                self.b.ins().jump(on, &[]);
                self.b.switch_to_block(on);
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
                self.b.switch_to_block(on);
            }
            Inst::LoadAttribute { attribute, to, element } => {
                let Some(ty) = self.text.surroundings.type_of(attribute) else {
                    return false;
                };
                let Some(place) = self.value_place(attribute, ty, element) else {
                    return false;
                };
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
                        let parts = 0..(size_of_value(ty) / 8) as i32;
                        for part in parts {
                            let value = self.b.ins().load(F64, flags, place, part * 8);
                            self.set_real(Reg((first + part) as u16), value);
                        }
                    }
                }
            }
            Inst::StoreAttribute { attribute, element, value } => {
                let ty = self.text.surroundings.type_of(attribute);
                let Some(ty) = ty.filter(|ty| *ty != AttributeType::Bool) else {
                    return false;
                };
                let Some(place) = self.value_place(attribute, ty, element) else {
                    return false;
                };
                let flags = self.flags(Region::Values);
                for part in 0..(size_of_value(ty) / 8) as u16 {
                    let bits = self.whole(Reg(value.0.wrapping_add(part)));
                    self.b.ins().store(flags, bits, place, i32::from(part) * 8);
                }
            }
            Inst::Tick => {
                let turns = self.field(offset_of!(Context, turns));
                let flags = self.flags(Region::Turns);
                let before = self.b.ins().load(I32, flags, turns, 0);
                let now = self.b.ins().iadd_imm_s(before, 1);
                let rest = self.b.ins().urem_imm_u(now, i64::from(TURNS_PER_LOOK));
                let [look, pass, on] = [(); 3].map(|()| self.b.create_block());
                self.b.set_cold_block(look);
                self.b.ins().brif(rest, pass, &[], look, &[]);
                self.b.switch_to_block(look);
                let number = self.b.ins().iconst(I64, self.at as i64);
                let done = self.call_stub(stubs::tick as *const () as usize, &[number]);
                let stopped = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, done, 0);
                self.leave_if(stopped);
                self.b.ins().jump(on, &[]);
                self.b.switch_to_block(pass);
                self.b.ins().store(flags, now, turns, 0);
                self.b.ins().jump(on, &[]);
                self.b.switch_to_block(on);
            }
            Inst::Ask { .. } => {
                self.spill_operands(inst);
                let number = self.b.ins().iconst(I64, self.at as i64);
                let done = self.call_stub(stubs::answer as *const () as usize, &[number]);
                let has = self.b.ins().icmp_imm_s(IntCC::SignedGreaterThanOrEqual, done, 0);
                self.or_fault(has);
                self.reload_written(inst);
            }
            _ => return false,
        }
        true
    }

    /// Moves on to the first living element.
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

    fn is_in_range(&mut self, kind: ElementKind, id: Value) -> Value {
        let (_, count, _) = table(kind);
        let count = self.field(TABLES + count);
        self.b.ins().icmp(IntCC::UnsignedLessThan, id, count)
    }

    /// Whether an element in range lives and, if it is a face, is of that sort.
    fn lives(&mut self, of: Elements, id: Value) -> Value {
        let (start, _, size) = table(of.kind());
        let start = self.field(TABLES + start);
        let offset = self.b.ins().imul_imm_s(id, size as i64);
        let record = self.b.ins().iadd(start, offset);
        let lives = self.is_not_dead(of.kind(), record);
        let hole = match of {
            Elements::Faces => 0,
            Elements::Holes => 1,
            _ => return lives,
        };
        let flags = self.flags(Region::Hole);
        let is_hole = self.byte(flags, record, FACE_HOLE);
        let is_of_sort = self.b.ins().icmp_imm_u(IntCC::Equal, is_hole, hole);
        self.b.ins().band(lives, is_of_sort)
    }

    fn is_not_dead(&mut self, kind: ElementKind, record: Value) -> Value {
        let (region, offset) = match kind {
            ElementKind::Halfedge => (Region::Next, offset_of!(HalfedgeRecord, next)),
            ElementKind::Vertex => first(ElementField::Vertex),
            ElementKind::Edge => first(ElementField::Edge),
            ElementKind::Face => first(ElementField::Face),
        };
        let flags = self.flags(region);
        let mark = self.b.ins().load(I32, flags, record, offset as i32);
        self.b.ins().icmp_imm_u(IntCC::NotEqual, mark, i64::from(DEAD))
    }

    /// The address of the value of a living element in a column; none if the kind of the column
    /// is not known.
    fn value_place(&mut self, attribute: u16, ty: AttributeType, element: Reg) -> Option<Value> {
        let kind = self.text.surroundings.kind_of(attribute)?;
        self.living(kind, element);
        let id = self.id(element);
        let columns = self.field(offset_of!(Context, columns));
        let flags = self.flags(Region::Columns);
        let place = i32::from(attribute) * size_of::<Values>() as i32;
        let count = place + offset_of!(Values, count) as i32;
        let count = self.b.ins().load(I64, flags, columns, count);
        let is_in_range = self.b.ins().icmp(IntCC::UnsignedLessThan, id, count);
        self.or_fault(is_in_range);
        let start = place + offset_of!(Values, start) as i32;
        let start = self.b.ins().load(I64, flags, columns, start);
        let offset = self.b.ins().imul_imm_s(id, size_of_value(ty) as i64);
        Some(self.b.ins().iadd(start, offset))
    }

    /// The address of the record of a living element.
    fn living(&mut self, kind: ElementKind, reg: Reg) -> Value {
        let fact = self.fact(reg);
        let id = self.id(reg);
        let (table, count, size) = table(kind);
        if !fact.is_in_range(kind) {
            let count = self.field(TABLES + count);
            let is_in_range = self.b.ins().icmp(IntCC::UnsignedLessThan, id, count);
            self.or_fault(is_in_range);
        }
        let table = self.field(TABLES + table);
        let offset = self.b.ins().imul_imm_s(id, size as i64);
        let record = self.b.ins().iadd(table, offset);
        if !fact.lives(kind) {
            let lives = self.is_not_dead(kind, record);
            self.or_fault(lives);
        }
        record
    }

    /// The number of an element that a pointer may lead to: one that has a record, or none.
    fn target(&mut self, kind: ElementKind, reg: Reg) -> Value {
        let id = self.id(reg);
        if !self.fact(reg).is_in_range(kind) {
            let is_in_range = self.is_in_range(kind, id);
            let none = i64::from(u32::MAX);
            let is_none = self.b.ins().icmp_imm_u(IntCC::Equal, id, none);
            let leads = self.b.ins().bor(is_in_range, is_none);
            self.or_fault(leads);
        }
        self.b.ins().ireduce(I32, id)
    }

    fn number(&mut self, region: Region, record: Value, offset: usize) -> Value {
        let flags = self.flags(region);
        let value = self.b.ins().load(I32, flags, record, offset as i32);
        self.b.ins().uextend(I64, value)
    }

    /// Where the position of a vertex lies that is in range.
    fn position(&mut self, vertex: Reg) -> Value {
        let table = self.field(TABLES + offset_of!(Tables, positions));
        let id = self.id(vertex);
        let offset = self.b.ins().imul_imm_s(id, size_of::<glam::DVec3>() as i64);
        self.b.ins().iadd(table, offset)
    }

    /// Takes this instruction and those of its sort that follow it at once.
    fn add_and_erase(&mut self) {
        let (first, code) = (self.at, self.text.code);
        let end = self.end_of_run(is_added_or_erased);
        let all = &code.insts[first..end];
        all.iter().for_each(|inst| self.spill_operands(inst));
        let span = self.b.ins().iconst(I64, (first | end << 32) as i64);
        let done = self.call_stub(stubs::add_and_erase as *const () as usize, &[span]);
        let failed = self.b.ins().icmp_imm_s(IntCC::SignedLessThan, done, 0);
        self.leave_if(failed);
        all.iter().for_each(|inst| self.reload_written(inst));
        self.skip = end - first - 1;
    }
}

fn is_added_or_erased(inst: &Inst) -> bool {
    matches!(
        inst,
        Inst::NewVertex { .. }
            | Inst::NewHalfedge { .. }
            | Inst::NewEdge { .. }
            | Inst::NewFace { .. }
            | Inst::Erase { .. }
    )
}

/// Where the halfedge of an element lies.
fn first(of: ElementField) -> (Region, usize) {
    match of {
        ElementField::Vertex => (Region::OfVertex, 0),
        ElementField::Edge => (Region::OfEdge, 0),
        ElementField::Face => (Region::OfFace, FACE_HALFEDGE),
    }
}

/// Where in [`Tables`] a table begins and its length stand, and the bytes of a record.
fn table(kind: ElementKind) -> (usize, usize, usize) {
    match kind {
        ElementKind::Halfedge => (
            offset_of!(Tables, halfedges),
            offset_of!(Tables, halfedge_count),
            size_of::<HalfedgeRecord>(),
        ),
        ElementKind::Vertex => {
            (offset_of!(Tables, vertices), offset_of!(Tables, vertex_count), size_of::<u32>())
        }
        ElementKind::Edge => {
            (offset_of!(Tables, edges), offset_of!(Tables, edge_count), size_of::<u32>())
        }
        ElementKind::Face => (offset_of!(Tables, faces), offset_of!(Tables, face_count), FACE_SIZE),
    }
}

/// The bytes of a value in a column.
fn size_of_value(ty: AttributeType) -> usize {
    match ty {
        AttributeType::Bool => size_of::<bool>(),
        AttributeType::Int => size_of::<i64>(),
        AttributeType::Real => size_of::<f64>(),
        AttributeType::Vec2 => size_of::<glam::DVec2>(),
        AttributeType::Vec3 => size_of::<glam::DVec3>(),
        AttributeType::Vec4 => size_of::<glam::DVec4>(),
        AttributeType::Mat3 => size_of::<glam::DMat3>(),
        AttributeType::Mat4 => size_of::<glam::DMat4>(),
    }
}
