//! Lowering of the loop `drain`.
//!
//! ```text
//! open          all elements are stale, until several threads have computed their keys
//! again:        for each stale element: its key
//!               the element with the least key, or to the end
//!               the condition, or to the end
//!               the body; to again
//! end: close
//! ```

use std::collections::BTreeSet;

use super::live::{Exits, calls};
use super::lower::{Loop, Lowering};
use super::visit::kind;
use crate::compile::{Scope, width};
use crate::diagram::{Expr, ExprKind, Unary};
use crate::lower::Variables;
use crate::resolve::{Statement, StatementKind};
use crate::rewrite::{Elements, Inst, Reg, Task};
use crate::source::Span;

impl Lowering<'_> {
    /// `drain x in xs by key while c { … }`
    pub(super) fn drain(&mut self, statement: &Statement, exits: Option<&Exits>) {
        let StatementKind::Drain { variable, collection, key, condition, body } = &statement.kind
        else {
            return;
        };
        let span = statement.span;
        let of = kind(collection);
        let members = collection.all().is_none().then(|| self.asm.buffer());
        if let Some(buffer) = members {
            self.list(collection, buffer, span);
        }
        let (again, end) = (self.asm.label(), self.asm.label());
        let (stale, first) = (self.asm.label(), self.asm.label());
        let [zero, one, unknown] = [0, 1, -1].map(|n| self.asm.constant_int(n));
        let done = self.asm.reg();
        self.asm.emit(Inst::Copy { to: done, from: zero });
        let element = self.names.local(*variable);
        let changing = self.changing(key, body);
        self.copy_slots(&changing);
        self.trap_at(span, Inst::DrainOpen { of, members });
        if members.is_none() {
            self.spread_keys((of, element), key, span);
        }

        let asked: Vec<&Expr> = condition.iter().chain([key]).collect();
        let exits = self.exits_of_body(&asked, body, exits).map(|mut exits| {
            // The variable is set before anything at the head reads it.
            exits.next.remove(variable);
            exits.continued.remove(variable);
            exits
        });
        self.asm.bind(again);
        if exits.as_ref().is_some_and(|exits| exits.next.is_empty()) && body.iter().any(calls) {
            self.asm.emit(Inst::Recycle);
        }
        self.all_stale_if_changed(&changing);
        self.asm.bind(stale);
        self.asm.emit(Inst::DrainStale { to: element, otherwise: first });
        self.trap_at(span, Inst::Tick);
        let mark = self.asm.mark();
        let value = self.key(key);
        self.trap_at(key.span, Inst::DrainKey { key: value });
        self.asm.release(mark);
        self.asm.emit(Inst::Jump { to: stale });

        self.asm.bind(first);
        self.asm.emit(Inst::DrainLeast { to: element, otherwise: end });
        if let Some(condition) = condition {
            let mark = self.asm.mark();
            let condition = self.value(condition);
            self.asm.emit(Inst::JumpUnless { condition, to: end });
            self.asm.release(mark);
        }
        self.asm.emit(Inst::DrainTake);
        self.iteration(span, done, unknown);
        self.asm.emit(Inst::AddInt { to: done, left: done, right: one });
        self.drains += 1;
        self.iterations(Loop { again, end }, body, exits.as_ref());
        self.drains -= 1;
        self.asm.emit(Inst::Jump { to: again });
        self.asm.bind(end);
        self.asm.emit(Inst::DrainClose);
    }

    /// Lets several threads compute the keys of all elements.
    fn spread_keys(&mut self, (of, element): (Elements, Reg), key: &Expr, span: Span) {
        let mark = self.asm.mark();
        if let Some(iterations) = self.asm.spread_values(of, element, Task::Keys) {
            self.trap_at(span, Inst::Jump { to: iterations.end });
            self.asm.begin_values(iterations);
            let value = self.key(key);
            for from in [element, value] {
                self.asm.emit(Inst::Keep { from });
            }
            self.asm.end_values(iterations);
        }
        self.asm.release(mark);
    }

    /// The value of a key, a real.
    fn key(&mut self, key: &Expr) -> Reg {
        let ExprKind::Unary(Unary::ToReal, int) = &key.kind else { return self.value(key) };
        let (from, to) = (self.value(int), self.asm.reg());
        self.trap_at(key.span, Inst::IntToKey { to, from });
        to
    }

    /// Closes all open drains, where the routine is left.
    pub(super) fn close_drains(&mut self) {
        for _ in 0..self.drains {
            self.asm.emit(Inst::DrainClose);
        }
    }

    /// The slots of the variables that the key reads and the body sets, each with a slot for its
    /// previous value.
    fn changing(&mut self, key: &Expr, body: &[Statement]) -> Vec<(Reg, Reg)> {
        let set = Variables::of(body);
        let mut read = BTreeSet::new();
        key.each(&mut |part| {
            if let ExprKind::Local(variable) = part.kind {
                read.insert((variable, width(part.ty)));
            }
        });
        read.retain(|&(variable, _)| set.sets(variable) > 0);
        let mut slots = Vec::new();
        for (variable, width) in read {
            let now = self.names.local(variable);
            let before = self.asm.block(width);
            slots.extend((0..width).map(|part| (now.part(part), before.part(part))));
        }
        slots
    }

    fn copy_slots(&mut self, slots: &[(Reg, Reg)]) {
        for &(from, to) in slots {
            self.asm.emit(Inst::Copy { to, from });
        }
    }

    fn all_stale_if_changed(&mut self, slots: &[(Reg, Reg)]) {
        if slots.is_empty() {
            return;
        }
        let (changed, same) = (self.asm.label(), self.asm.label());
        for &(left, right) in slots {
            let to = changed;
            self.asm.emit(Inst::JumpUnequal { left, right, to });
        }
        self.asm.emit(Inst::Jump { to: same });
        self.asm.bind(changed);
        self.copy_slots(slots);
        self.asm.emit(Inst::DrainAllStale);
        self.asm.bind(same);
    }
}
