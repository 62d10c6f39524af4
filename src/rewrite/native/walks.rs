//! Questions that a walk around a vertex or a face answers.
//!
//! If a pointer leads to no record, or a walk is longer than the number of halfedges, a stub
//! answers, as the machine does.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{Block, InstBuilder, Value};

use super::access::{first, pointer, table};
use super::stubs;
use super::translate::Translator;
use crate::mesh::ElementKind;
use crate::mesh::tables::FaceState;
use crate::rewrite::{ElementField, HalfedgeField, Question, Reg};

/// The number of steps, each way, after which a stub takes over the test whether two vertices are
/// adjacent: it starts at the vertices' own halfedges, near which recent writes are found sooner.
const FEW_STEPS: i64 = 8;

/// The address and length of a table, and the bytes of a record.
#[derive(Clone, Copy)]
struct Rows {
    start: Value,
    count: Value,
    size: usize,
}

/// The halfedges that are walked, and the block to jump to if the walk does not find the answer.
#[derive(Clone, Copy)]
struct Walk {
    halfedges: Rows,
    slow: Block,
}

impl Translator<'_, '_> {
    /// Translates a question whose answer is an int or a bool.
    pub(super) fn ask_whole(&mut self, question: Question, to: Reg, elements: [Reg; 2]) {
        let numbers = elements.map(|reg| self.whole(reg));
        let [slow, on] = [(); 2].map(|()| self.b.create_block());
        if let Some(answer) = self.walked(question, elements, slow) {
            self.b.set_cold_block(slow);
            self.set_whole(to, answer);
            self.b.ins().jump(on, &[]);
        } else {
            self.b.ins().jump(slow, &[]);
        }
        self.b.switch_to_block(slow);
        let number = self.b.ins().iconst(I64, question as i64);
        let stub = stubs::ask_whole as *const () as usize;
        let answer = self.call_stub(stub, &[number, numbers[0], numbers[1]]);
        self.or_fault_if_negative(answer);
        self.set_whole(to, answer);
        self.join(on);
    }

    /// The answer, if a walk can find it.
    fn walked(&mut self, question: Question, elements: [Reg; 2], slow: Block) -> Option<Value> {
        let [one, other] = elements;
        match question {
            Question::LinkCondition | Question::StarShaped => return None,
            Question::Adjacent => {
                self.living(ElementKind::Vertex, other);
            }
            _ => {}
        }
        self.living(question.kind(), one);
        let walk = Walk { halfedges: self.rows(ElementKind::Halfedge), slow };
        match question {
            Question::Degree => Some(self.around(walk, ElementField::Vertex, one)),
            Question::FaceSize => Some(self.around(walk, ElementField::Face, one)),
            Question::BoundaryVertex => {
                Some(self.where_holes_are(|this| this.boundary_vertex(walk, one)))
            }
            Question::BoundaryEdge => {
                Some(self.where_holes_are(|this| this.boundary_edge(walk, one)))
            }
            Question::Adjacent => Some(self.adjacent(walk, elements)),
            _ => None,
        }
    }

    fn rows(&mut self, kind: ElementKind) -> Rows {
        let (start, count, size) = table(kind);
        let [start, count] = [start, count].map(|place| self.table_field(place));
        Rows { start, count, size }
    }

    /// The address of a record; jumps to `slow` if there is none.
    fn row(&mut self, rows: Rows, id: Value, slow: Block) -> Value {
        let is_in_range = self.b.ins().icmp(IntCC::UnsignedLessThan, id, rows.count);
        self.or_slow(is_in_range, slow);
        let offset = self.scaled(id, rows.size);
        self.b.ins().iadd(rows.start, offset)
    }

    pub(super) fn or_slow(&mut self, condition: Value, slow: Block) {
        let on = self.b.create_block();
        self.b.ins().brif(condition, on, &[], slow, &[]);
        self.go_on(on);
    }

    /// The element that a pointer of a record leads to.
    pub(super) fn leads(&mut self, record: Value, field: HalfedgeField) -> Value {
        let (offset, region, _) = pointer(field);
        self.number(region, record, offset)
    }

    /// A halfedge of a living element; of a vertex, one that is in a register, if there is one.
    fn first_of(&mut self, of: ElementField, element: Reg) -> Value {
        if let Some(spoke) = self.fact(element).spoke() {
            return self.id(spoke);
        }
        let id = self.id(element);
        let record = self.place(of.kind(), id);
        let (region, offset) = first(of);
        self.number(region, record, offset)
    }

    /// Whether the face of a halfedge is a hole, as an int.
    fn is_in_hole(&mut self, halfedge: Value, slow: Block) -> Value {
        let face = self.leads(halfedge, HalfedgeField::Face);
        let is_in_range = self.is_in_range(ElementKind::Face, face);
        self.or_slow(is_in_range, slow);
        let is_hole = self.is_in_state(face, FaceState::Hole);
        self.b.ins().uextend(I64, is_hole)
    }

    /// The number of halfedges around an element.
    fn around(&mut self, walk: Walk, of: ElementField, element: Reg) -> Value {
        let Walk { halfedges, slow } = walk;
        let start = self.first_of(of, element);
        let (at, count) = (self.b.declare_var(I64), self.b.declare_var(I64));
        let zero = self.b.ins().iconst(I64, 0);
        self.b.def_var(at, start);
        self.b.def_var(count, zero);
        let [head, done] = [(); 2].map(|()| self.b.create_block());
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(head);
        let here = self.b.use_var(at);
        let next = match of {
            ElementField::Vertex => self.turn_on(walk, here).1,
            _ => {
                let record = self.row(halfedges, here, slow);
                self.leads(record, HalfedgeField::Next)
            }
        };
        self.b.def_var(at, next);
        let walked = self.b.use_var(count);
        let walked = self.b.ins().iadd_imm_s(walked, 1);
        self.b.def_var(count, walked);
        let is_back = self.b.ins().icmp(IntCC::Equal, next, start);
        let on = self.b.create_block();
        self.b.ins().brif(is_back, done, &[], on, &[]);
        self.go_on(on);
        let goes_on = self.b.ins().icmp(IntCC::UnsignedLessThan, walked, halfedges.count);
        self.b.ins().brif(goes_on, head, &[], slow, &[]);
        self.b.switch_to_block(done);
        walked
    }

    /// An answer that is false if the mesh has no holes.
    fn where_holes_are(&mut self, ask: impl FnOnce(&mut Self) -> Value) -> Value {
        let answer = self.b.declare_var(I64);
        let holes = self.hole_count();
        let is_any = self.b.ins().icmp_imm_u(IntCC::NotEqual, holes, 0);
        let is_any = self.b.ins().uextend(I64, is_any);
        self.b.def_var(answer, is_any);
        let [open, done] = [(); 2].map(|()| self.b.create_block());
        self.b.ins().brif(is_any, open, &[], done, &[]);
        self.b.switch_to_block(open);
        let asked = ask(self);
        self.b.def_var(answer, asked);
        self.b.ins().jump(done, &[]);
        self.b.switch_to_block(done);
        self.b.use_var(answer)
    }

    fn boundary_edge(&mut self, walk: Walk, edge: Reg) -> Value {
        let Walk { halfedges, slow } = walk;
        let half = self.first_of(ElementField::Edge, edge);
        let here = self.row(halfedges, half, slow);
        let twin = self.leads(here, HalfedgeField::Twin);
        let there = self.row(halfedges, twin, slow);
        let [here, there] = [here, there].map(|half| self.is_in_hole(half, slow));
        self.b.ins().bor(here, there)
    }

    fn boundary_vertex(&mut self, walk: Walk, vertex: Reg) -> Value {
        let Walk { halfedges, slow } = walk;
        let start = self.first_of(ElementField::Vertex, vertex);
        let (at, count) = (self.b.declare_var(I64), self.b.declare_var(I64));
        let zero = self.b.ins().iconst(I64, 0);
        self.b.def_var(at, start);
        self.b.def_var(count, zero);
        let [head, step, next, done] = [(); 4].map(|()| self.b.create_block());
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(head);
        let here = self.b.use_var(at);
        let record = self.row(halfedges, here, slow);
        let hole = self.is_in_hole(record, slow);
        self.b.ins().brif(hole, done, &[], step, &[]);
        self.b.switch_to_block(step);
        let (_, spoke) = self.turn_on(walk, here);
        self.b.def_var(at, spoke);
        let is_back = self.b.ins().icmp(IntCC::Equal, spoke, start);
        self.b.ins().brif(is_back, done, &[], next, &[]);
        self.b.switch_to_block(next);
        let walked = self.b.use_var(count);
        let walked = self.b.ins().iadd_imm_s(walked, 1);
        self.b.def_var(count, walked);
        let goes_on = self.b.ins().icmp(IntCC::UnsignedLessThan, walked, halfedges.count);
        self.b.ins().brif(goes_on, head, &[], slow, &[]);
        self.b.switch_to_block(done);
        hole
    }

    /// Walks around both vertices in lockstep, each in both directions: so the smaller degree
    /// limits the number of steps, and four walks wait for memory at the same time. If both degrees
    /// are large, a stub takes over.
    fn adjacent(&mut self, walk: Walk, vertices: [Reg; 2]) -> Value {
        let starts = vertices.map(|vertex| self.first_of(ElementField::Vertex, vertex));
        let goals = [vertices[1], vertices[0]].map(|vertex| self.id(vertex));
        let at = starts.map(|start| {
            [(); 2].map(|()| {
                let at = self.b.declare_var(I64);
                self.b.def_var(at, start);
                at
            })
        });
        let (count, answer) = (self.b.declare_var(I64), self.b.declare_var(I64));
        let (zero, one) = (self.b.ins().iconst(I64, 0), self.b.ins().iconst(I64, 1));
        self.b.def_var(count, zero);
        self.b.def_var(answer, one);
        let [head, apart, next, done] = [(); 4].map(|()| self.b.create_block());
        self.b.ins().jump(head, &[]);
        self.b.switch_to_block(head);
        let have_met = [0, 1].map(|side| {
            let [ahead, behind] = at[side].map(|at| self.b.use_var(at));
            let (neighbor, onward) = self.turn_on(walk, ahead);
            let (other, back) = self.turn_back(walk, behind);
            let goal = goals[side];
            let is_goal = [neighbor, other].map(|one| self.b.ins().icmp(IntCC::Equal, one, goal));
            let is_goal = self.b.ins().bor(is_goal[0], is_goal[1]);
            let goes_on = self.b.create_block();
            self.b.ins().brif(is_goal, done, &[], goes_on, &[]);
            self.b.switch_to_block(goes_on);
            self.b.def_var(at[side][0], onward);
            self.b.def_var(at[side][1], back);
            let have_met = [behind, back].map(|one| self.b.ins().icmp(IntCC::Equal, onward, one));
            self.b.ins().bor(have_met[0], have_met[1])
        });
        let either = self.b.ins().bor(have_met[0], have_met[1]);
        self.b.ins().brif(either, apart, &[], next, &[]);
        self.b.switch_to_block(next);
        let walked = self.b.use_var(count);
        let walked = self.b.ins().iadd_imm_s(walked, 1);
        self.b.def_var(count, walked);
        let few = self.b.ins().icmp_imm_u(IntCC::UnsignedLessThan, walked, FEW_STEPS);
        self.b.ins().brif(few, head, &[], walk.slow, &[]);
        self.b.switch_to_block(apart);
        self.b.def_var(answer, zero);
        self.b.ins().jump(done, &[]);
        self.b.switch_to_block(done);
        self.b.use_var(answer)
    }

    /// The vertex where the next spoke ends, and that spoke.
    fn turn_on(&mut self, walk: Walk, spoke: Value) -> (Value, Value) {
        let Walk { halfedges, slow } = walk;
        let record = self.row(halfedges, spoke, slow);
        let before = self.leads(record, HalfedgeField::Prev);
        let before = self.row(halfedges, before, slow);
        let neighbor = self.leads(before, HalfedgeField::Vertex);
        (neighbor, self.leads(before, HalfedgeField::Twin))
    }

    /// The vertex where a spoke ends, and the previous spoke.
    fn turn_back(&mut self, walk: Walk, spoke: Value) -> (Value, Value) {
        let Walk { halfedges, slow } = walk;
        let record = self.row(halfedges, spoke, slow);
        let twin = self.leads(record, HalfedgeField::Twin);
        let twin = self.row(halfedges, twin, slow);
        let neighbor = self.leads(twin, HalfedgeField::Vertex);
        (neighbor, self.leads(twin, HalfedgeField::Next))
    }
}
