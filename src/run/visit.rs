//! Lowering of loops, except `drain`.

use super::live::Exits;
use super::lower::{Loop, Lowering};
use crate::compile::{Orbit, Scope, each, lower};
use crate::diagram::{Collection, Expr};
use crate::lower::Effects;
use crate::resolve::{Statement, StatementKind, Visit};
use crate::rewrite::{Assembler, Elements, Inst, Iterations, Label, Reg, Task};
use crate::source::Span;

impl Lowering<'_> {
    /// `repeat n { … }`; it makes no iteration if the count is negative.
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
        self.iteration(span, done, total);
        let exits = self.exits_of_body(&[], body, exits);
        self.iterations(Loop { again, end }, body, exits.as_ref());
        self.asm.bind(again);
        self.asm.emit(Inst::AddInt { to: done, left: done, right: one });
        self.asm.emit(Inst::Jump { to: head });
        self.asm.bind(end);
    }

    /// `while c { … }`
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
        self.iteration(span, done, unknown);
        self.asm.emit(Inst::AddInt { to: done, left: done, right: one });
        let exits = self.exits_of_body(&[condition], body, exits);
        self.iterations(Loop { again, end }, body, exits.as_ref());
        self.asm.emit(Inst::Jump { to: again });
        self.asm.bind(end);
    }

    /// `for x in xs where c { … }`, `update`; the writes of an `update` are kept back. Elements are
    /// listed before the first iteration, unless they are in one orbit and no operation is called.
    pub(super) fn visit(&mut self, statement: &Statement) {
        let StatementKind::For { variable, collection, filter, body, visit, parallel } =
            &statement.kind
        else {
            return;
        };
        let span = statement.span;
        if *visit == Visit::InOrder
            && !parallel
            && let Collection::Around(around, base) = collection
            && let Some(orbit) = Orbit::of(*around)
            && let effects = Effects::of_block(std::slice::from_ref(statement))
            && !effects.calls_ops(&self.calls_ops)
        {
            let mark = self.asm.mark();
            let (base, place) = (self.value(base), self.names.place(span));
            let (walk, from) = orbit.walk(&mut self.asm, base, place);
            let to = self.names.local(*variable);
            self.asm.emit(Inst::Copy { to, from });
            if !effects.functions.is_empty() || body.iter().any(has_loop) {
                // A walk alone is short.
                self.trap_at(span, Inst::Tick);
            }
            self.unless(filter.as_ref(), walk.next);
            self.iterations(Loop { again: walk.next, end: walk.done }, body, None);
            walk.end(&mut self.asm, place);
            return self.asm.release(mark);
        }
        if *visit == Visit::Update {
            let buffer = self.asm.buffer();
            self.asm.emit(Inst::BufferClear { buffer });
            self.held = Some(buffer);
        }
        let [again, first, end] = [(); 3].map(|()| self.asm.label());
        let (index, total) = (self.asm.reg(), self.asm.reg());
        if let (Some(of), Some(held)) = (collection.all(), self.held)
            && self.variables.stay_within(body, self.params)
        {
            let one = self.asm.constant_int(1);
            let (element, depth) = (self.names.local(*variable), self.loops.len() as u16);
            let task = Task::Update;
            let iterations =
                Iterations { of, depth, element, index, total, one, task, held, again, first, end };
            self.asm.spread(iterations);
        }
        let buffer = match filter {
            Some(filter) if *parallel => {
                self.list_where((*variable, collection, filter), *visit, span)
            }
            _ => self.listed(collection, *visit, span),
        };
        let zero = self.asm.constant_int(0);
        let element = self.names.local(*variable);
        self.asm.emit(Inst::BufferLength { buffer, to: total });
        self.asm.emit(Inst::Copy { to: index, from: zero });
        self.asm.bind(again);
        if *visit == Visit::Shuffled {
            self.asm.emit(Inst::Prefetch { of: kind(collection), buffer, index });
        }
        self.asm.emit(Inst::BufferNext { buffer, index, to: element, otherwise: end });
        self.iteration(span, index, total);
        self.asm.bind(first);
        self.asm.emit(Inst::JumpUnlessLiving { of: kind(collection), element, to: again });
        self.unless(filter.as_ref(), again);
        self.iterations(Loop { again, end }, body, None);
        self.asm.emit(Inst::Jump { to: again });
        self.asm.bind(end);
        if let Some(buffer) = self.held.take() {
            self.asm.emit(Inst::WriteDeferred { buffer });
        }
    }

    /// Jumps if there is a filter that the element does not pass.
    fn unless(&mut self, filter: Option<&Expr>, to: Label) {
        if let Some(filter) = filter {
            let mark = self.asm.mark();
            let condition = self.value(filter);
            self.asm.emit(Inst::JumpUnless { condition, to });
            self.asm.release(mark);
        }
    }

    /// A buffer of the elements that a loop visits, in the order in which it does.
    fn listed(&mut self, collection: &Collection, visit: Visit, span: Span) -> u16 {
        let buffer = self.asm.buffer();
        self.list(collection, buffer, span);
        if visit == Visit::Shuffled {
            self.asm.emit(Inst::BufferShuffle { buffer });
        }
        buffer
    }

    /// A buffer of the elements that a `parallel for` visits: those that pass its filter now.
    /// Several threads test all elements of the mesh, unless their order is random.
    fn list_where(
        &mut self,
        (variable, collection, filter): (u32, &Collection, &Expr),
        visit: Visit,
        span: Span,
    ) -> u16 {
        let element = self.names.local(variable);
        let random = (visit == Visit::Shuffled).then(|| self.listed(collection, visit, span));
        let mark = self.asm.mark();
        let iterations = match (random, collection.all()) {
            (None, Some(of)) => self.asm.spread_values(of, element, Task::Filter),
            _ => None,
        };
        let passed = iterations.map_or_else(|| self.asm.buffer(), |iterations| iterations.held);
        self.asm.emit(Inst::BufferClear { buffer: passed });
        let push = &mut |asm: &mut Assembler, scope: &mut dyn Scope, from: Reg, next: Label| {
            let mark = asm.mark();
            asm.emit(Inst::Copy { to: element, from });
            let condition = lower(asm, scope, filter);
            asm.emit(Inst::JumpUnless { condition, to: next });
            asm.emit(Inst::BufferPush { buffer: passed, from: element });
            asm.release(mark);
        };
        match random {
            Some(buffer) => {
                let (again, end) = (self.asm.label(), self.asm.label());
                let (index, to) = (self.asm.reg(), self.asm.reg());
                let from = self.asm.constant_int(0);
                self.asm.emit(Inst::Copy { to: index, from });
                self.asm.bind(again);
                self.asm.emit(Inst::BufferNext { buffer, index, to, otherwise: end });
                self.trap_at(span, Inst::Tick);
                push(&mut self.asm, &mut self.names, to, again);
                self.asm.emit(Inst::Jump { to: again });
                self.asm.bind(end);
            }
            None => {
                let base = collection.base().map(|base| self.value(base));
                each(&mut self.asm, &mut self.names, (collection, base), span, push);
            }
        }
        if let Some(iterations) = iterations {
            self.trap_at(span, Inst::Jump { to: iterations.end });
            self.asm.begin_values(iterations);
            let condition = self.value(filter);
            self.asm.emit(Inst::JumpUnless { condition, to: iterations.again });
            self.asm.emit(Inst::Keep { from: element });
            self.asm.end_values(iterations);
        }
        self.asm.release(mark);
        passed
    }

    /// Lists the elements of a collection in a buffer.
    pub(super) fn list(&mut self, collection: &Collection, buffer: u16, span: Span) {
        self.asm.emit(Inst::BufferClear { buffer });
        if let Some(of) = collection.all() {
            return self.asm.emit(Inst::BufferLiving { of, buffer });
        }
        let mark = self.asm.mark();
        let push = &mut |asm: &mut Assembler, _: &mut dyn Scope, from: Reg, _: Label| {
            asm.emit(Inst::BufferPush { buffer, from });
        };
        let base = collection.base().map(|base| self.value(base));
        each(&mut self.asm, &mut self.names, (collection, base), span, push);
        self.asm.release(mark);
    }

    pub(super) fn iteration(&mut self, span: Span, done: Reg, total: Reg) {
        let depth = u16::try_from(self.loops.len()).unwrap_or(u16::MAX);
        self.trap_at(span, Inst::Iteration { depth, done, total });
    }

    pub(super) fn iterations(&mut self, around: Loop, body: &[Statement], exits: Option<&Exits>) {
        self.loops.push(around);
        self.block(body, exits);
        self.loops.pop();
    }
}

/// Whether a statement has a loop in it.
fn has_loop(statement: &Statement) -> bool {
    use StatementKind::{Drain, For, Repeat, While};
    let mut found = false;
    statement.each(&mut |inner| {
        found |= matches!(inner.kind, For { .. } | Repeat { .. } | While { .. } | Drain { .. });
    });
    found
}

/// The elements among which those of a collection must still be when their turn comes.
pub(super) fn kind(collection: &Collection) -> Elements {
    let around = || collection.element().element_kind().map_or(Elements::Faces, Elements::of);
    collection.all().unwrap_or_else(around)
}
