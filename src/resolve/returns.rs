//! The result of a function: `return`, and the value at its end.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Action, ActionKind};

use super::foreign_words::is_foreign;
use super::program::{Block, Statement, StatementKind};
use super::scopes::{Binding, Local};
use super::script::Scripting;
use super::signature::Value;
use super::typed::to_real;

impl Scripting<'_> {
    /// The body of a function: a value at its end is its result.
    pub(super) fn body(&mut self, block: &tree::Block) -> Block {
        self.typing.scopes.enter();
        let mut statements = Block::new();
        if let Some((last, others)) = block.statements.split_last() {
            self.actions(others, &mut statements);
            self.last(last, &mut statements);
        }
        self.typing.scopes.leave();
        statements
    }

    /// The statement at the end of a function.
    fn last(&mut self, action: &Action, statements: &mut Block) {
        let span = action.span;
        let kind = match &action.kind {
            ActionKind::Expr(value) if self.is_value(value) => self.exit(Some(value), span),
            ActionKind::If { binding: None, condition, then, otherwise: Some(otherwise) }
                if !self.is_op_call(condition) =>
            {
                self.typing.may_change = true;
                let condition = self.typing.expression_as(condition, Type::Bool, "`if`");
                let then = self.body(then);
                let otherwise = self.body(otherwise);
                condition.map(|condition| StatementKind::If { condition, then, otherwise })
            }
            ActionKind::If { binding, condition, then, otherwise: Some(otherwise) } => {
                let blocks = (then, Some(otherwise));
                self.if_applied(binding.as_ref(), condition, blocks, Self::body)
            }
            ActionKind::If { then, otherwise: None, .. } if self.lacks_else(then) => None,
            ActionKind::Block(block) => return statements.extend(self.body(block)),
            _ => return self.actions(std::slice::from_ref(action), statements),
        };
        statements.extend(kind.map(|kind| Statement { kind, span }));
    }

    /// Reports a branch at the end of a function that gives a value while there is no other.
    fn lacks_else(&mut self, then: &tree::Block) -> bool {
        let Some(Action { kind: ActionKind::Expr(value), .. }) = then.statements.last() else {
            return false;
        };
        let returns = matches!(self.returns.value, Value::Of(_)) && self.is_value(value);
        if returns {
            let message = "an `if` without `else` gives no value";
            self.typing.report.add(Diagnostic::error("unused-value", message, value.span).note(
                "both branches give one, `if c { x } else { y }`, or `return` gives this one",
            ));
        }
        returns
    }

    /// True if an expression at the end of a function is its value, not a statement.
    fn is_value(&self, value: &tree::Expr) -> bool {
        match &value.kind {
            tree::ExprKind::Call { function, .. } if function.text == "print" => false,
            tree::ExprKind::Call { function, .. } => {
                match self.typing.declared.function(&function.text) {
                    Some(called) => {
                        matches!(called.result, Value::Of(_))
                            && self.returns.value != Value::Nothing
                    }
                    None if self.is_op_call(value) => false,
                    None => {
                        self.typing.declared.is_called(&function.text)
                            || self.steps_of.is_none() && self.wants_value(&function.text)
                    }
                }
            }
            tree::ExprKind::Must(_) => matches!(self.returns.value, Value::Of(_)),
            _ => true,
        }
    }

    /// True if an unknown function at the end of a function is meant to give its value.
    fn wants_value(&self, function: &str) -> bool {
        match self.returns.value {
            Value::Of(_) => true,
            Value::Open => is_foreign(function),
            Value::Nothing | Value::Unknown => false,
        }
    }

    /// `return`, `return x`
    pub(super) fn exit(&mut self, value: Option<&tree::Expr>, span: Span) -> Option<StatementKind> {
        let Some(name) = self.returns.function.clone() else {
            return match value {
                None => Some(StatementKind::Return(None)),
                Some(value) => {
                    let message = "a script returns nothing";
                    let error = Diagnostic::error("script-returns", message, value.span)
                        .note("`return` alone ends it; a value is printed, or given by a `fn`");
                    self.typing.report.reject(error)
                }
            };
        };
        let Some(value) = value else { return self.exit_without(&name, span) };
        if let Some(applied) = self.applied_value(value) {
            let applied = applied?;
            let result = applied.result;
            let variable = self.typing.scopes.declare(Local {
                name: "the result".to_owned(),
                span: value.span,
                ty: Some(result),
                binding: Binding::Head,
            });
            let local = Expr { ty: result, kind: ExprKind::Local(variable), span: value.span };
            let local = self.fitting(value, local, &name)?;
            let returned = Statement { kind: StatementKind::Return(Some(local)), span };
            return Some(applied.into_variable(variable, vec![returned]));
        }
        self.typing.may_change = !self.typing.updating;
        let typed = self.typing.expression(value)?;
        let typed = self.fitting(value, typed, &name)?;
        Some(StatementKind::Return(Some(typed)))
    }

    fn exit_without(&mut self, name: &str, span: Span) -> Option<StatementKind> {
        match self.returns.value {
            Value::Of(ty) => {
                let message = format!("`{name}` gives {}, so `return` wants a value", ty.a_word());
                let error = Diagnostic::error("missing-return", message, span);
                self.typing.report.reject(error.with(self.returns.first, |error, first| {
                    error.label(first, "it gives a value here")
                }))
            }
            _ => {
                self.returns.value = Value::Nothing;
                self.returns.first.get_or_insert(span);
                Some(StatementKind::Return(None))
            }
        }
    }

    /// A returned value, converted to the result type.
    fn fitting(&mut self, written: &tree::Expr, value: Expr, name: &str) -> Option<Expr> {
        let first = *self.returns.first.get_or_insert(written.span);
        match self.returns.value {
            Value::Of(Type::Real) if value.ty == Type::Int => Some(to_real(value)),
            Value::Of(ty) if ty == value.ty => Some(value),
            Value::Of(ty) => {
                let message =
                    format!("`{name}` gives {}, but this is {}", ty.a_word(), value.ty.a_word());
                let error = Diagnostic::error("type-mismatch", message, written.span);
                let error = match (ty, value.ty, self.returns.head) {
                    (Type::Int, Type::Real, Some(head)) => error
                        .note(format!(
                            "where real is written, an int stands for one: `fn {name}(…) -> real`"
                        ))
                        .fix("write `-> real` behind the parameters", head, "-> real "),
                    (Type::Int, Type::Real, None) => error
                        .note(format!("`round(x)` makes an int; or write `fn {name}(…) -> real`")),
                    _ => error,
                };
                self.typing.report.reject(error.when(first != written.span, |error| {
                    error.label(first, format!("this is {}", ty.a_word()))
                }))
            }
            Value::Open => {
                self.returns.value = Value::Of(value.ty);
                Some(value)
            }
            Value::Nothing if self.returns.cycles => {
                // One value tells the type of all.
                self.returns.value = Value::Unknown;
                let message = format!("`{name}` calls itself, so the type of its value is written");
                let (ty, place) = (value.ty, self.returns.declared);
                let error = Diagnostic::error("needs-result-type", message, place)
                    .saying("behind its parameters")
                    .label(written.span, format!("it gives {} here", ty.a_word()));
                let result = format!("-> {} ", ty.word());
                self.typing.report.reject(error.with(self.returns.head, |error, head| {
                    error.fix(format!("write `{}`", result.trim()), head, result)
                }))
            }
            Value::Nothing => {
                let message =
                    format!("`{name}` gives {} here, but elsewhere nothing", value.ty.a_word());
                let error = Diagnostic::error("needs-result-type", message, written.span)
                    .label(first, "it gives nothing here")
                    .note(format!(
                        "every way through a function gives a value, `fn {name}(…) -> {}`, or none does",
                        value.ty.word()
                    ));
                self.typing.report.reject(error)
            }
            Value::Unknown => self.typing.report.fail_silently(),
        }
    }
}

/// True if control never reaches the end of a block.
pub(super) fn ends(block: &[Statement]) -> bool {
    block.last().is_some_and(|last| match &last.kind {
        StatementKind::Return(_) => true,
        StatementKind::Refused { .. } => true,
        StatementKind::Assert { condition, .. } | StatementKind::Require { condition, .. } => {
            condition.kind == ExprKind::Bool(false)
        }
        StatementKind::While { condition, body } => {
            condition.kind == ExprKind::Bool(true) && !breaks(body)
        }
        StatementKind::If { then, otherwise, .. }
        | StatementKind::Apply { then, otherwise, .. } => ends(then) && ends(otherwise),
        _ => false,
    })
}

/// True if a block breaks out of the loop around it.
fn breaks(block: &[Statement]) -> bool {
    block.iter().any(|statement| match &statement.kind {
        StatementKind::Break => true,
        StatementKind::If { then, otherwise, .. }
        | StatementKind::Apply { then, otherwise, .. } => breaks(then) || breaks(otherwise),
        _ => false,
    })
}
