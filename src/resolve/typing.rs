//! Expressions: from the tree to typed expressions.
//!
//! This module walks the tree; the meaning of names, operators, fields, functions and sequences is
//! in the modules next to it. `None` always means that an error has been reported.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Type, Unary};
use crate::source::Span;
use crate::syntax::tree::{self, BinaryOp, UnaryOp};

use super::declared::Declared;
use super::depth::{left_side, shallow_expr};
use super::names::Names;
use super::neighbor::near;
use super::parameter::local;
use super::report::Report;
use super::scopes::{Binding, Local, Scopes};
use super::signature::{Parameter, Signature};
use super::type_name::type_named;
use super::typed::{to_real, typed};
use super::words::subject;

/// The place of an expression, which determines what it may refer to.
#[derive(Clone, Copy)]
pub(super) enum Place<'a> {
    /// The default of what is said: constants and, of a parameter, earlier ones.
    Default(&'static str),
    /// A rule: its drawn names as they were before the rewrite, and the op's parameters.
    Rule(&'a Names),
    /// A script: its variables and the whole mesh.
    Script,
}

/// The state while expressions in one place are typed.
pub(super) struct Typing<'a> {
    pub(super) place: Place<'a>,
    pub(super) declared: &'a Declared,
    /// The variables; in a rule, the op's parameters first.
    pub(super) scopes: Scopes,
    pub(super) report: &'a mut Report,
    /// The ops of the program, by number, as far as they can be asked here.
    pub(super) ops: &'a [Signature],
    /// True if the next function call may change the mesh, because it is a whole value.
    pub(super) may_change: bool,
    /// True inside an `update`.
    pub(super) updating: bool,
    /// The type that an expression is to have, if that is known.
    pub(super) wanted: Option<(Span, Type)>,
}

impl<'a> Typing<'a> {
    /// The initial state, with the parameters declared, where no op can be asked.
    pub(super) fn new(
        place: Place<'a>,
        declared: &'a Declared,
        params: &[Parameter],
        report: &'a mut Report,
    ) -> Self {
        let mut scopes = Scopes::default();
        scopes.enter();
        for param in params {
            scopes.declare(local(param));
        }
        Self {
            place,
            declared,
            scopes,
            report,
            ops: &[],
            may_change: false,
            updating: false,
            wanted: None,
        }
    }
}

impl Typing<'_> {
    /// What is found, without what is reported meanwhile.
    pub(super) fn quietly<T>(&mut self, find: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        let report = std::mem::take(self.report);
        let found = find(self);
        *self.report = report;
        found
    }

    /// A whole expression of any type.
    pub(super) fn whole(&mut self, expr: &tree::Expr) -> Option<Expr> {
        shallow_expr(expr, self.report).then(|| self.expression(expr)).flatten()
    }

    /// A whole expression, converted to the type `wanted` by `whose`.
    pub(super) fn whole_as(
        &mut self,
        expr: &tree::Expr,
        wanted: Type,
        whose: &str,
    ) -> Option<Expr> {
        self.wanted = Some((expr.span, wanted));
        let value = self.whole(expr)?;
        self.convert(expr, value, wanted, whose)
    }

    /// An expression as part of one whose depth has been checked. The left side of a chain is
    /// walked in a loop, since it may be long.
    pub(super) fn expression(&mut self, expr: &tree::Expr) -> Option<Expr> {
        // A call inside a larger value is not a whole value.
        self.may_change &= matches!(expr.kind, tree::ExprKind::Call { .. });
        let mut chain = Vec::new();
        let mut inner = expr;
        while let Some(left) = left_side(inner) {
            if joins_bools(inner) {
                self.wanted = Some((left.span, Type::Bool));
            }
            chain.push((inner, left));
            inner = left;
        }
        let mut value = self.operand(inner);
        while let Some((outer, left)) = chain.pop() {
            value = self.link(outer, left, value);
        }
        value
    }

    /// One step outwards along a chain.
    fn link(&mut self, outer: &tree::Expr, left: &tree::Expr, value: Option<Expr>) -> Option<Expr> {
        match &outer.kind {
            tree::ExprKind::Binary(op, _, right) => {
                if joins_bools(outer) {
                    self.wanted = Some((right.span, Type::Bool));
                }
                let right_value = self.expression(right);
                let operands = [(left, value?), (&**right, right_value?)];
                self.binary(*op, operands, outer.span)
            }
            tree::ExprKind::Field(_, field) => self.field((left, value?), field, outer.span, false),
            _ => value,
        }
    }

    fn operand(&mut self, expr: &tree::Expr) -> Option<Expr> {
        let span = expr.span;
        match &expr.kind {
            tree::ExprKind::Bool(value) => Some(typed(Type::Bool, ExprKind::Bool(*value), span)),
            tree::ExprKind::Int(value) => Some(typed(Type::Int, ExprKind::Int(*value), span)),
            tree::ExprKind::Real(value) => Some(typed(Type::Real, ExprKind::Real(*value), span)),
            tree::ExprKind::Text(value) => {
                Some(typed(Type::Text, ExprKind::Text(value.clone()), span))
            }
            tree::ExprKind::Name(name) => self.name(name),
            // Which of the two is meant, is not known.
            tree::ExprKind::Call { function, args } if self.declared.is_taken(&function.text) => {
                let value = self.quietly(|typing| typing.call(function, args, span));
                value.or_else(|| self.report.fail_silently())
            }
            tree::ExprKind::Call { function, args } => self.call(function, args, span),
            tree::ExprKind::Must(inner) => self.misplaced_must(inner, span),
            tree::ExprKind::Asked(asking, inner) => self.asked(*asking, inner, span),
            tree::ExprKind::Unary(op, inner) => {
                if *op == UnaryOp::Not {
                    self.wanted = Some((inner.span, Type::Bool));
                }
                let value = self.expression(inner)?;
                self.unary(*op, (inner, value), span)
            }
            tree::ExprKind::If { condition, then, otherwise } => {
                self.choice(condition, [then, otherwise], span)
            }
            tree::ExprKind::Aggregate { .. } => self.aggregate(expr),
            tree::ExprKind::Range(..) => self.misplaced_range(span),
            // Chains are handled before; the parser has reported what is broken.
            tree::ExprKind::Binary(..) | tree::ExprKind::Field(..) | tree::ExprKind::Broken => {
                self.report.fail_silently()
            }
        }
    }

    /// The condition of a loop or an aggregate, if it has one; `None` if that cannot be resolved.
    pub(super) fn condition(
        &mut self,
        condition: Option<&tree::Expr>,
        whose: &str,
    ) -> Option<Option<Expr>> {
        match condition {
            Some(condition) => self.expression_as(condition, Type::Bool, whose).map(Some),
            None => Some(None),
        }
    }

    /// An expression, converted to the type `wanted` by `whose`.
    pub(super) fn expression_as(
        &mut self,
        expr: &tree::Expr,
        wanted: Type,
        whose: &str,
    ) -> Option<Expr> {
        self.wanted = Some((expr.span, wanted));
        let value = self.expression(expr)?;
        self.convert(expr, value, wanted, whose)
    }

    /// The type that an expression is to have, if that is known.
    pub(super) fn wanted(&self, span: Span) -> Option<Type> {
        self.wanted.filter(|(wanted, _)| *wanted == span).map(|(_, ty)| ty)
    }

    /// An expression, converted to the type `wanted` by `whose` if that is known.
    pub(super) fn expression_for(
        &mut self,
        expr: &tree::Expr,
        wanted: Option<Type>,
        whose: &str,
    ) -> Option<Expr> {
        match wanted {
            Some(ty) => self.expression_as(expr, ty, whose),
            None => self.expression(expr),
        }
    }

    /// Converts a value to the type `wanted` by `whose`.
    pub(super) fn convert(
        &mut self,
        expr: &tree::Expr,
        value: Expr,
        wanted: Type,
        whose: &str,
    ) -> Option<Expr> {
        converted(expr, value, wanted, whose).map_err(|error| self.report.add(error)).ok()
    }

    /// `if c { x } else { y }`
    fn choice(
        &mut self,
        condition: &tree::Expr,
        sides: [&tree::Block; 2],
        span: Span,
    ) -> Option<Expr> {
        let condition = self.expression_as(condition, Type::Bool, "`if`");
        let [then, otherwise] = sides.map(|side| self.block_value(side));
        let (condition, mut then, mut otherwise) = (condition?, then?, otherwise?);
        if [then.ty, otherwise.ty] == [Type::Int, Type::Real]
            || [then.ty, otherwise.ty] == [Type::Real, Type::Int]
        {
            then = to_real(then);
            otherwise = to_real(otherwise);
        }
        if then.ty != otherwise.ty {
            let message = format!(
                "the two sides of `if` are {} and {}",
                then.ty.a_word(),
                otherwise.ty.a_word()
            );
            let error = Diagnostic::error("type-mismatch", message, span)
                .label(then.span, format!("this is {}", then.ty.a_word()))
                .label(otherwise.span, format!("this is {}", otherwise.ty.a_word()));
            return self.report.reject(error);
        }
        let ty = then.ty;
        let parts = [condition, then, otherwise].map(Box::new);
        let [condition, then, otherwise] = parts;
        Some(typed(ty, ExprKind::If(condition, then, otherwise), span))
    }

    /// The value of a block in an expression.
    fn block_value(&mut self, block: &tree::Block) -> Option<Expr> {
        let Some((last, others)) = block.statements.split_last() else {
            return self.no_value_at(block.span);
        };
        self.scopes.enter();
        let named: Vec<_> = others.iter().map(|action| self.named(action)).collect();
        let value = self.value_of(last);
        self.scopes.leave();
        let named: Vec<(u32, Expr)> = named.into_iter().collect::<Option<_>>()?;
        let around = |body: Expr, (variable, value): (u32, Expr)| {
            let (ty, span) = (body.ty, body.span);
            let kind = ExprKind::Let(variable, Box::new(value), Box::new(body));
            typed(ty, kind, span)
        };
        Some(named.into_iter().rev().fold(value?, around))
    }

    /// The value of a block's last statement.
    fn value_of(&mut self, action: &tree::Action) -> Option<Expr> {
        match &action.kind {
            tree::ActionKind::Expr(value) => self.expression(value),
            // The parser reads a nested `if` with a value as a statement.
            tree::ActionKind::If { binding: None, condition, then, otherwise: Some(otherwise) } => {
                self.choice(condition, [then, otherwise], action.span)
            }
            tree::ActionKind::Broken => self.report.fail_silently(),
            _ => self.no_value_at(action.span),
        }
    }

    /// `let x = …` in a block that is a value.
    fn named(&mut self, action: &tree::Action) -> Option<(u32, Expr)> {
        let tree::ActionKind::Let { mutable: false, name, ty, value } = &action.kind else {
            let message = "before the value of a block there may be `let`, and nothing else";
            let error = Diagnostic::error("not-a-value", message, action.span);
            return self.report.reject(error.note("a function (`fn`) can hold any statements"));
        };
        if matches!(self.place, Place::Default(_)) {
            let message = "in a default, a block holds one value";
            return self.report.reject(Diagnostic::error("not-a-value", message, action.span));
        }
        let wanted = match ty {
            Some(word) => Some(type_named(word, self.report)?),
            None => None,
        };
        let value = self.expression_for(value, wanted, &format!("`{}`", name.text));
        let keyword =
            Span { end: action.span.start.saturating_add(3).min(name.span.start), ..action.span };
        let variable = self.scopes.declare(Local {
            name: name.text.clone(),
            span: name.span,
            ty: wanted.or(value.as_ref().map(|value| value.ty)),
            binding: Binding::Let(keyword),
        });
        Some((variable, value?))
    }

    fn no_value_at(&mut self, span: Span) -> Option<Expr> {
        let message = "this block is a value, so a value stands at its end";
        self.report.reject(Diagnostic::error("not-a-value", message, span))
    }
}

/// True for `a and b` and `a or b`.
fn joins_bools(expr: &tree::Expr) -> bool {
    matches!(expr.kind, tree::ExprKind::Binary(BinaryOp::And | BinaryOp::Or, ..))
}

/// The value as one of the type `wanted` by `whose`, or the error that it has another type.
pub(super) fn converted(
    expr: &tree::Expr,
    value: Expr,
    wanted: Type,
    whose: &str,
) -> Result<Expr, Diagnostic> {
    let ty = match (wanted, value.ty) {
        (wanted, ty) if wanted == ty => return Ok(value),
        (Type::Real, Type::Int) => return Ok(to_real(value)),
        (_, ty) => ty,
    };
    let (wants, what, is) = (wanted.a_word(), subject(expr), ty.a_word());
    let message = format!("{whose} wants {wants}, but {what} is {is}");
    let error = Diagnostic::error("type-mismatch", message, expr.span);
    let error = error.saying(format!("this is {is}"));
    Err(match (wanted, ty) {
        (Type::Vec3, Type::Vertex) => with_field(error, expr, "position"),
        (Type::Int, Type::Real) => with_div(error, expr, &value),
        (wanted, _) if is_zero(expr) && (wanted.is_vector() || wanted.is_matrix()) => {
            let zero = format!("{}(0)", wanted.word());
            error.fix(format!("write `{zero}`"), expr.span, zero)
        }
        _ => error.with(near(expr, ty, wanted), Diagnostic::note),
    })
}

/// True if an expression is written `0` or `0.0`.
fn is_zero(expr: &tree::Expr) -> bool {
    match expr.kind {
        tree::ExprKind::Int(value) => value == 0,
        tree::ExprKind::Real(value) => value == 0.0,
        _ => false,
    }
}

/// The error with the fix that ints are divided by `div`, if they are divided by `/`, or with the
/// way to an int.
fn with_div(error: Diagnostic, expr: &tree::Expr, value: &Expr) -> Diagnostic {
    let rounds = "`round(x)` is the nearest int, `round(floor(x))` the one below";
    let (
        tree::ExprKind::Binary(tree::BinaryOp::Divide, left, right),
        ExprKind::Binary(_, first, second),
    ) = (&expr.kind, &value.kind)
    else {
        return error.note(rounds);
    };
    let was_int = |operand: &Expr| matches!(operand.kind, ExprKind::Unary(Unary::ToReal, _));
    if !was_int(first) || !was_int(second) {
        return error.note(rounds);
    }
    let error = error.note("`/` gives a real, `div` an int");
    // If more stands between them than a sign and its spaces, it is a comment.
    match right.span.start.checked_sub(left.span.end) {
        Some(1..=3) => {
            let between = Span { start: left.span.end, ..right.span.before() };
            error.fix("write `div`", between, " div ")
        }
        _ => error,
    }
}

/// The error with the fix that a name is followed by a field.
pub(super) fn with_field(error: Diagnostic, expr: &tree::Expr, field: &str) -> Diagnostic {
    match expr.kind {
        tree::ExprKind::Name(_) => {
            let title = format!("write `.{field}` behind it");
            error.fix(title, expr.span.after(), format!(".{field}"))
        }
        _ => error,
    }
}
