//! Loops over ranges of ints: `for i in 0..n { … }`.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Binary, Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree;

use super::program::{Block, Statement, StatementKind};
use super::script::{Loop, Scripting};
use super::typed::typed;
use super::typing::Typing;

/// A hint at the use of ranges.
pub(super) const TAKES_INTS: &str = "`for i in 0..n { … }` takes the ints from 0 to n - 1";

impl Scripting<'_> {
    /// `for i in first..end where c { … }`, as a `repeat` before whose turns `i` is set. Both bounds
    /// are evaluated once.
    pub(super) fn count(
        &mut self,
        visited: &Loop,
        (first, end): (&tree::Expr, &tree::Expr),
        span: Span,
    ) -> Option<Block> {
        if let Some(parallel) = visited.parallel {
            let message = "a `parallel for` visits elements, not the ints of a range";
            let error = Diagnostic::error("not-a-sequence", message, visited.sequence.span);
            self.typing.report.add(error.fix("drop `parallel`", parallel, "for"));
        }
        if let (Some(from), Some(to)) = (literal(first), literal(end))
            && from >= to
        {
            self.typing.report.add(empty(from, to, visited.sequence.span));
        }
        let [first, end] =
            [first, end].map(|bound| self.typing.expression_as(bound, Type::Int, "a range"));
        self.typing.scopes.enter();
        let variable = self.typing.scopes.declare_in_head(visited.variable, Some(Type::Int));
        let filter = self.typing.condition(visited.filter, "`where`");
        let inside = self.repeated(visited.body);
        self.typing.scopes.leave();

        let here = visited.sequence.span;
        let one = || int(ExprKind::Int(1), here);
        let index = || int(ExprKind::Local(variable), here);
        let with =
            |op, left, right| int(ExprKind::Binary(op, Box::new(left), Box::new(right)), here);
        let set = |value| Statement { kind: StatementKind::Set { variable, value }, span: here };
        let less = |value, by| with(Binary::SubtractInt, value, by);
        let (first, end) = (first?, end?);
        // Where the first int is known, so is the one before it, and the count needs no variable.
        let (before, count) = match first.kind {
            ExprKind::Int(0) => (int(ExprKind::Int(-1), here), end),
            ExprKind::Int(known) => (int(ExprKind::Int(known - 1), here), less(end, first)),
            _ => (less(first, one()), less(less(end, one()), index())),
        };
        let mut body = vec![set(with(Binary::AddInt, index(), one()))];
        match filter? {
            Some(condition) => {
                let otherwise = Block::new();
                let kind = StatementKind::If { condition, then: inside, otherwise };
                body.push(Statement { kind, span });
            }
            None => body.extend(inside),
        }
        let kind = StatementKind::Repeat { count, body };
        Some(vec![set(before), Statement { kind, span }])
    }
}

impl Typing<'_> {
    /// The error for a range where no loop counts through it.
    pub(super) fn misplaced_range(&mut self, span: Span) -> Option<Expr> {
        let message = "a range is not a value: only `for` takes one";
        self.report.reject(Diagnostic::error("not-a-sequence", message, span).note(TAKES_INTS))
    }
}

/// The value of an int that is written as a number.
fn literal(bound: &tree::Expr) -> Option<i64> {
    match &bound.kind {
        tree::ExprKind::Int(value) => Some(*value),
        tree::ExprKind::Unary(tree::UnaryOp::Negate, value) => literal(value)?.checked_neg(),
        _ => None,
    }
}

/// The warning for a range without ints.
fn empty(from: i64, to: i64, span: Span) -> Diagnostic {
    let message = format!("this loop does nothing: `{from}..{to}` has no int");
    let told = Diagnostic::warning("empty-range", message, span);
    match from > to {
        true => told.note(format!(
            "a range counts up; `for k in 0..{} {{ let i = {from} - k … }}` counts down",
            from.saturating_sub(to)
        )),
        false => told,
    }
}

fn int(kind: ExprKind, span: Span) -> Expr {
    typed(Type::Int, kind, span)
}
