//! Loops in the code of a script.

use super::live::Exits;
use super::lower::{Loop, Lowering};
use crate::compile::{Scope, each, elements};
use crate::diagram::{Collection, Expr, Type};
use crate::resolve::{Statement, StatementKind};
use crate::rewrite::{Assembler, Elements, Inst, Label, Reg, Turns};
use crate::source::Span;

impl Lowering<'_> {
    /// `repeat`: no turn if the count is negative.
    pub(super) fn repeat(
        &mut self,
        count: &Expr,
        body: &[Statement],
        span: Span,
        exits: Option<&Exits>,
    ) {
        let (total, done, more) = (self.asm.reg(), self.asm.reg(), self.asm.reg());
        let (zero, one) = (self.asm.constant_int(0), self.asm.constant_int(1));
        let (head, again, end) = (self.asm.label(), self.asm.label(), self.asm.label());
        self.value_into(count, total);
        self.asm.emit(Inst::Copy { to: done, from: zero });
        self.asm.bind(head);
        self.asm.emit(Inst::LessInt { to: more, left: done, right: total });
        self.asm.emit(Inst::JumpUnless { condition: more, to: end });
        self.turn(span, done, total);
        let exits = self.exits_of_body(&[], body, exits);
        self.turns(Loop { again, end }, body, exits.as_ref());
        self.asm.bind(again);
        self.asm.emit(Inst::AddInt { to: done, left: done, right: one });
        self.asm.emit(Inst::Jump { to: head });
        self.asm.bind(end);
    }

    /// `while`
    pub(super) fn repeat_while(
        &mut self,
        condition: &Expr,
        body: &[Statement],
        span: Span,
        exits: Option<&Exits>,
    ) {
        let (again, end) = (self.asm.label(), self.asm.label());
        let [zero, one, unknown] = [0, 1, -1].map(|n| self.asm.constant_int(n));
        let done = self.asm.reg();
        self.asm.emit(Inst::Copy { to: done, from: zero });
        self.asm.bind(again);
        let mark = self.asm.mark();
        let test = self.value(condition);
        self.asm.emit(Inst::JumpUnless { condition: test, to: end });
        self.asm.release(mark);
        self.turn(span, done, unknown);
        self.asm.emit(Inst::AddInt { to: done, left: done, right: one });
        let exits = self.exits_of_body(&[condition], body, exits);
        self.turns(Loop { again, end }, body, exits.as_ref());
        self.asm.emit(Inst::Jump { to: again });
        self.asm.bind(end);
    }

    /// `for x in xs where c { … }`
    pub(super) fn visit(&mut self, statement: &Statement) {
        self.visit_all(statement, false);
    }

    /// The same; if it `spreads`, its turns only read, and keep back what they write.
    fn visit_all(&mut self, statement: &Statement, spreads: bool) {
        let (StatementKind::For { variable, collection, filter, body, .. }
        | StatementKind::Update { variable, collection, filter, body }) = &statement.kind
        else {
            return;
        };
        let span = statement.span;
        let buffer = self.asm.buffer();
        let (again, end) = (self.asm.label(), self.asm.label());
        let (index, total) = (self.asm.reg(), self.asm.reg());
        if let (true, Some(of), Some(held)) = (spreads, elements(collection), self.held)
            && self.sets_its_own(body)
        {
            let one = self.asm.constant_int(1);
            let (element, depth) = (self.names.local(*variable), self.loops.len() as u16);
            self.asm.spread(Turns { of, depth, element, index, total, one, held, again, end });
        }
        self.list(collection, buffer, span);
        if let StatementKind::For { shuffled: true, .. } = statement.kind {
            self.asm.emit(Inst::BufferShuffle { buffer });
        }
        let zero = self.asm.constant_int(0);
        let element = self.names.local(*variable);
        self.asm.emit(Inst::BufferLength { buffer, to: total });
        self.asm.emit(Inst::Copy { to: index, from: zero });
        self.asm.bind(again);
        self.asm.emit(Inst::BufferNext { buffer, index, to: element, otherwise: end });
        self.turn(span, index, total);
        self.asm.emit(Inst::JumpUnlessLiving { of: kind(collection), element, to: again });
        if let Some(filter) = filter {
            let mark = self.asm.mark();
            let condition = self.value(filter);
            self.asm.emit(Inst::JumpUnless { condition, to: again });
            self.asm.release(mark);
        }
        self.turns(Loop { again, end }, body, None);
        self.asm.emit(Inst::Jump { to: again });
        self.asm.bind(end);
    }

    /// `update`: a loop whose writes are kept back. One inside of another keeps them back
    /// to the end of the outer one.
    pub(super) fn update(&mut self, statement: &Statement) {
        if self.held.is_some() {
            return self.visit(statement);
        }
        let buffer = self.asm.buffer();
        self.asm.emit(Inst::BufferClear { buffer });
        self.held = Some(buffer);
        self.visit_all(statement, true);
        self.held = None;
        self.asm.emit(Inst::ReleaseHeld { buffer });
    }

    /// True if the body of a loop sets no variable but its own.
    fn sets_its_own(&self, body: &[Statement]) -> bool {
        let mut sets = vec![0; self.sets.len()];
        count_sets(body, &mut sets);
        let all = sets.iter().zip(&self.sets);
        all.enumerate().all(|(at, (here, all))| *here == 0 || (at >= self.params && here == all))
    }

    /// Puts the elements that a loop visits into a buffer.
    pub(super) fn list(&mut self, collection: &Collection, buffer: u16, span: Span) {
        self.asm.emit(Inst::BufferClear { buffer });
        if let Some(of) = elements(collection) {
            return self.asm.emit(Inst::BufferLiving { of, buffer });
        }
        if let Some(base) = collection.base() {
            self.note_functions(base);
        }
        let mark = self.asm.mark();
        let push = &mut |asm: &mut Assembler, _: &mut dyn Scope, from: Reg, _: Label| {
            asm.emit(Inst::BufferPush { buffer, from });
        };
        each(&mut self.asm, &mut self.names, collection, span, push);
        self.asm.release(mark);
    }

    pub(super) fn turn(&mut self, span: Span, done: Reg, total: Reg) {
        let depth = u16::try_from(self.loops.len()).unwrap_or(u16::MAX);
        self.trap_at(span, Inst::Turn { depth, done, total });
    }

    pub(super) fn turns(&mut self, around: Loop, body: &[Statement], exits: Option<&Exits>) {
        self.loops.push(around);
        self.block(body, exits);
        self.loops.pop();
    }
}

/// The elements that they must still be when their turn comes.
pub(super) fn kind(collection: &Collection) -> Elements {
    match (collection, collection.element()) {
        (Collection::Holes, _) => Elements::Holes,
        (_, Type::Vertex) => Elements::Vertices,
        (_, Type::Halfedge) => Elements::Halfedges,
        (_, Type::Edge) => Elements::Edges,
        (_, _) => Elements::Faces,
    }
}

/// Counts for each variable the statements that set it.
pub(super) fn count_sets(block: &[Statement], sets: &mut [u32]) {
    let mut count = |variable: u32| {
        if let Some(sets) = sets.get_mut(variable as usize) {
            *sets += 1;
        }
    };
    for statement in block {
        match &statement.kind {
            StatementKind::Set { variable, .. }
            | StatementKind::For { variable, .. }
            | StatementKind::Update { variable, .. }
            | StatementKind::Drain { variable, .. }
            | StatementKind::IfApply { variable: Some(variable), .. } => count(*variable),
            _ => {}
        }
    }
    for statement in block {
        match &statement.kind {
            StatementKind::Repeat { body, .. }
            | StatementKind::While { body, .. }
            | StatementKind::For { body, .. }
            | StatementKind::Update { body, .. }
            | StatementKind::Drain { body, .. } => count_sets(body, sets),
            StatementKind::If { then, otherwise, .. }
            | StatementKind::IfApply { then, otherwise, .. } => {
                count_sets(then, sets);
                count_sets(otherwise, sets);
            }
            _ => {}
        }
    }
}
