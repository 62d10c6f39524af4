//! The addresses of elements and their values.
//!
//! An address is computed from a number only if it is below the number of records: this is tested
//! here, or known. So native code accesses nothing but the tables, on any mesh.

use std::mem::offset_of;

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::{I8, I32, I64};
use cranelift_codegen::ir::{InstBuilder, Value};

use super::context::{Context, Slice};
use super::translate::{Region, Translator};
use crate::mesh::tables::{DEAD, FaceState, Tables};
use crate::mesh::{AttributeType, ElementKind, HalfedgeRecord, glam};
use crate::rewrite::{ElementField, Elements, HalfedgeField, Reg};

pub(super) const TABLES: usize = offset_of!(Context, tables);

/// The offset of a pointer in the record of a halfedge, its region, and the kind of element that it
/// leads to.
pub(super) fn pointer(field: HalfedgeField) -> (usize, Region, ElementKind) {
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

impl Translator<'_, '_> {
    pub(super) fn is_in_range(&mut self, kind: ElementKind, id: Value) -> Value {
        let (_, count, _) = table(kind);
        let count = self.table_field(count);
        self.b.ins().icmp(IntCC::UnsignedLessThan, id, count)
    }

    /// Whether an element in range lives and, if `of` is faces or holes, is one of these.
    pub(super) fn lives(&mut self, of: Elements, id: Value) -> Value {
        match of {
            Elements::Faces => return self.is_in_state(id, FaceState::Face),
            Elements::Holes => return self.is_in_state(id, FaceState::Hole),
            Elements::Vertices | Elements::Halfedges | Elements::Edges => {}
        }
        let record = self.place(of.kind(), id);
        self.is_not_dead(of.kind(), record)
    }

    /// Whether a face in range is in a state.
    pub(super) fn is_in_state(&mut self, id: Value, state: FaceState) -> Value {
        let place = self.state_place(id);
        let now = self.load(I8, Region::FaceStates, place, 0);
        self.b.ins().icmp_imm_u(IntCC::Equal, now, state as i64)
    }

    /// The address of the state of a face in range.
    pub(super) fn state_place(&mut self, id: Value) -> Value {
        let states = self.table_field(offset_of!(Tables, face_states));
        self.b.ins().iadd(states, id)
    }

    pub(super) fn is_not_dead(&mut self, kind: ElementKind, record: Value) -> Value {
        let (region, offset) = match kind {
            ElementKind::Halfedge => (Region::Next, offset_of!(HalfedgeRecord, next)),
            ElementKind::Vertex => first(ElementField::Vertex),
            ElementKind::Edge => first(ElementField::Edge),
            ElementKind::Face => first(ElementField::Face),
        };
        let mark = self.load(I32, region, record, offset);
        self.b.ins().icmp_imm_u(IntCC::NotEqual, mark, i64::from(DEAD))
    }

    /// The address of the value of a living element in a column; `None` if the kind of the column
    /// is not known.
    pub(super) fn value_place(
        &mut self,
        attribute: u16,
        ty: AttributeType,
        element: Reg,
    ) -> Option<Value> {
        self.living(self.unit.environment.kind_of(attribute)?, element);
        let id = self.id(element);
        let columns = self.field(offset_of!(Context, columns));
        let place = usize::from(attribute) * size_of::<Slice>();
        let count = self.load(I64, Region::Columns, columns, place + offset_of!(Slice, count));
        let is_in_range = self.b.ins().icmp(IntCC::UnsignedLessThan, id, count);
        self.or_fault(is_in_range);
        let start = self.load(I64, Region::Columns, columns, place + offset_of!(Slice, start));
        let offset = self.scaled(id, ty.size());
        Some(self.b.ins().iadd(start, offset))
    }

    /// The address of the record of a living element.
    pub(super) fn living(&mut self, kind: ElementKind, reg: Reg) -> Value {
        let fact = self.fact(reg);
        let id = self.id(reg);
        let record = match fact.is_in_range(kind) {
            true => self.place(kind, id),
            false => self.record(kind, id),
        };
        if !fact.lives(kind) {
            let lives = self.is_not_dead(kind, record);
            self.or_fault(lives);
        }
        record
    }

    /// The number of an element that a pointer may lead to: of one that has a record, or of no
    /// element.
    pub(super) fn target(&mut self, kind: ElementKind, reg: Reg) -> Value {
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

    pub(super) fn number(&mut self, region: Region, record: Value, offset: usize) -> Value {
        let value = self.load(I32, region, record, offset);
        self.b.ins().uextend(I64, value)
    }

    /// The address of the position of a vertex in range.
    pub(super) fn position(&mut self, vertex: Reg) -> Value {
        let id = self.id(vertex);
        self.position_of(id)
    }

    /// The offset of a record of this number of bytes. Adding the number to twice itself is faster
    /// than multiplying by 3.
    pub(super) fn scaled(&mut self, id: Value, size: usize) -> Value {
        if !size.is_multiple_of(3) {
            return self.b.ins().imul_imm_s(id, size as i64);
        }
        let twice = self.b.ins().ishl_imm_u(id, 1);
        let thrice = self.b.ins().iadd(id, twice);
        self.b.ins().imul_imm_s(thrice, (size / 3) as i64)
    }

    /// The address of the record of an element that a pointer of a living one leads to.
    pub(super) fn record(&mut self, kind: ElementKind, id: Value) -> Value {
        let is_in_range = self.is_in_range(kind, id);
        self.or_fault(is_in_range);
        self.place(kind, id)
    }

    /// The address of the record of an element in range.
    pub(super) fn place(&mut self, kind: ElementKind, id: Value) -> Value {
        let (table, _, size) = table(kind);
        let table = self.table_field(table);
        let offset = self.scaled(id, size);
        self.b.ins().iadd(table, offset)
    }

    /// The address of the position of a vertex in range.
    pub(super) fn position_of(&mut self, id: Value) -> Value {
        let table = self.table_field(offset_of!(Tables, positions));
        let offset = self.scaled(id, size_of::<glam::DVec3>());
        self.b.ins().iadd(table, offset)
    }
}

/// The region and offset of the halfedge of an element.
pub(super) fn first(of: ElementField) -> (Region, usize) {
    match of {
        ElementField::Vertex => (Region::OfVertex, 0),
        ElementField::Edge => (Region::OfEdge, 0),
        ElementField::Face => (Region::OfFace, 0),
    }
}

/// The offsets in [`Tables`] of a table's address and length, and the bytes of a record.
pub(super) fn table(kind: ElementKind) -> (usize, usize, usize) {
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
        ElementKind::Face => {
            (offset_of!(Tables, faces), offset_of!(Tables, face_count), size_of::<u32>())
        }
    }
}
