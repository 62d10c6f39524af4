//! Calls of ops in scripts and functions.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Ident};

use super::foreign_words::constant_called;
use super::overloads::takes;
use super::program::{Block, Statement, StatementKind};
use super::script::Scripting;
use super::sequence::is_sequence;
use super::signature::Value;
use super::typing::Typing;

/// `must split(e)` as a value.
pub(super) struct Applied {
    op: usize,
    args: Vec<Expr>,
    /// The name of the op.
    name: String,
    pub(super) result: Type,
    span: Span,
}

impl Applied {
    /// The statement that stores the result and continues with `then`, or stops the script if the
    /// op refuses.
    pub(super) fn into_variable(self, variable: u32, then: Block) -> StatementKind {
        let refused = Statement { kind: StatementKind::Refused { op: self.op }, span: self.span };
        let asked = Asked { op: self.op, args: self.args, variable: Some(variable) };
        asked.choosing([then, vec![refused]])
    }
}

/// `split(e)`, or `let m = split(e)` after `if`.
pub(super) struct Asked {
    op: usize,
    args: Vec<Expr>,
    variable: Option<u32>,
}

impl From<(usize, Vec<Expr>)> for Asked {
    fn from((op, args): (usize, Vec<Expr>)) -> Self {
        Self { op, args, variable: None }
    }
}

impl Asked {
    pub(super) fn choosing(self, [then, otherwise]: [Block; 2]) -> StatementKind {
        StatementKind::Apply {
            op: self.op,
            args: self.args,
            variable: self.variable,
            then,
            otherwise,
        }
    }
}

impl Scripting<'_> {
    /// True if an expression is a call of an op.
    pub(super) fn is_op_call(&self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            tree::ExprKind::Call { function, .. } => {
                self.typing.declared.op(&function.text).is_some()
            }
            _ => false,
        }
    }

    /// The result of an op, if `expr` calls one: `must split(e)`. An inner `None` means that an
    /// error has been reported.
    pub(super) fn applied_value(&mut self, expr: &tree::Expr) -> Option<Option<Applied>> {
        match &expr.kind {
            tree::ExprKind::Must(inner) => match &inner.kind {
                tree::ExprKind::Call { function, args } => {
                    Some(self.applied(function, args, inner.span))
                }
                _ => None,
            },
            tree::ExprKind::Call { function, .. } if self.is_op_call(expr) => {
                let word = &function.text;
                let message = format!("`{word}` may be refused, and then there is no value");
                let error = Diagnostic::error("needs-must", message, expr.span);
                let refused = match self.steps_of {
                    Some(op) => format!("refuses `{op}`"),
                    None => "stops the script".to_owned(),
                };
                let called = self.typing.declared.op(word).and_then(|op| self.typing.ops.get(op));
                let gives = called.filter(|op| op.result != Value::Nothing);
                self.typing.report.add(match gives {
                    Some(_) => error.note(format!(
                        "`if let x = {word}(…) {{ … }}` asks, `let x = must {word}(…)` {refused} there"
                    )),
                    None => error.note(format!(
                        "`{word}` returns nothing; whether it applied is asked by `if {word}(…) {{ … }}`"
                    )),
                });
                Some(None)
            }
            _ => None,
        }
    }

    fn applied(&mut self, function: &Ident, args: &[tree::Expr], span: Span) -> Option<Applied> {
        let (op, args) = self.typing.application(function, args, span)?;
        let result = self.result(op, span)?;
        Some(Applied { op, args, name: function.text.clone(), result, span })
    }

    /// The result type of an op where a value is required.
    fn result(&mut self, op: usize, span: Span) -> Option<Type> {
        let signature = &self.typing.ops[op];
        match signature.result {
            Value::Of(ty) => Some(ty),
            Value::Open | Value::Unknown => self.typing.report.fail_silently(),
            Value::Nothing => {
                let message = format!("`{}` returns nothing", signature.name);
                self.typing.report.reject(Diagnostic::error("returns-nothing", message, span).note(
                    "an op returns an element that is there afterwards where its head names it, as \
                     in `op split(e: edge) -> m`",
                ))
            }
        }
    }

    /// True if the result of an op has the type of the variable that stores it.
    pub(super) fn result_fits(
        &mut self,
        applied: &Applied,
        wanted: Option<Type>,
        variable: &Ident,
        span: Span,
    ) -> bool {
        let Some(wanted) = wanted.filter(|wanted| *wanted != applied.result) else { return true };
        let message = format!(
            "`{}` wants {}, but `{}` returns {}",
            variable.text,
            wanted.a_word(),
            applied.name,
            applied.result.a_word()
        );
        self.typing.report.add(Diagnostic::error("type-mismatch", message, span));
        false
    }

    /// `if let m = split(e) { … } else { … }`, `if split(e) { … }`; its blocks are resolved by
    /// `block`.
    pub(super) fn if_applied(
        &mut self,
        binding: Option<&Ident>,
        condition: &tree::Expr,
        (then, otherwise): (&tree::Block, Option<&tree::Block>),
        block: fn(&mut Self, &tree::Block) -> Block,
    ) -> Option<StatementKind> {
        let asked = self.asked(binding, condition);
        let then = block(self, then);
        self.typing.scopes.leave();
        let otherwise = otherwise.map(|otherwise| block(self, otherwise)).unwrap_or_default();
        Some(asked?.choosing([then, otherwise]))
    }

    /// The call of an op after `if`, with its variable in a scope that stays open.
    fn asked(&mut self, binding: Option<&Ident>, condition: &tree::Expr) -> Option<Asked> {
        let applied = match &condition.kind {
            tree::ExprKind::Call { function, args } => {
                self.typing.application(function, args, condition.span)
            }
            tree::ExprKind::Must(_) => {
                let message = "`if let` asks whether the op is refused, so `must` has no place";
                let error = Diagnostic::error("misplaced-must", message, condition.span);
                self.typing.report.reject(error)
            }
            tree::ExprKind::Broken => self.typing.report.fail_silently(),
            _ => {
                let message = "`if let` wants the call of an op";
                let error = Diagnostic::error("not-an-op", message, condition.span);
                let note = "`argmin` and `argmax` want an element: whether there is one is asked \
                            before, `if any(… for e in edges) { … }`";
                self.typing.report.reject(match &condition.kind {
                    tree::ExprKind::Aggregate { function, .. }
                        if matches!(function.text.as_str(), "argmin" | "argmax") =>
                    {
                        error.note(note)
                    }
                    _ => error,
                })
            }
        };
        self.typing.scopes.enter();
        let variable = binding.map(|binding| {
            let op = applied.as_ref().map(|(op, _)| *op);
            let ty = op.and_then(|op| self.result(op, condition.span));
            self.typing.scopes.declare_in_head(binding, ty)
        });
        let (op, args) = applied?;
        Some(Asked { op, args, variable })
    }
}

impl Typing<'_> {
    /// An op and its arguments, with defaults for those left out.
    pub(super) fn application(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<(usize, Vec<Expr>)> {
        self.declared.expect_one(function, self.report)?;
        let number = self.declared.op(&function.text);
        let ops = self.ops;
        let found = number.and_then(|number| Some((number, ops.get(number)?)));
        let Some((number, op)) = found else {
            let is_meant = self.unknown_op(function, args, span);
            for arg in args.iter().filter(|arg| is_meant && !is_sequence(arg)) {
                self.expression(arg);
            }
            return None;
        };
        let values = self.arguments(&op.name, &op.params, args, span)?;
        Some((number, values))
    }

    /// Reports that there is no such op; true if it is known what was meant.
    fn unknown_op(&mut self, function: &Ident, args: &[tree::Expr], span: Span) -> bool {
        let declared = self.declared;
        let word = function.text.as_str();
        if declared.lacks_files() || declared.is_taken(word) {
            // The missing file, or the name, has been reported already.
            self.report.fail();
            return false;
        }
        if declared.is_called(word) {
            let message = match declared.is_script(word) {
                true => format!("`{word}` is a script, not an op"),
                false => format!("`{word}` is a function, not an op"),
            };
            self.report.add(Diagnostic::error("not-an-op", message, function.span));
            return false;
        }
        let message = format!("there is no op `{word}`");
        let error = Diagnostic::error("unknown-op", message, function.span);
        let (ops, types) = (self.ops, self.simple_types(args));
        let fits = |meant: &str| {
            let op = declared.op(meant).and_then(|number| ops.get(number));
            op.is_some_and(|op| takes(&op.params, &types))
        };
        let error = constant_called(error, function, args, span).unwrap_or_else(|error| {
            declared.tell_what_is_meant(error, function, declared.op_names(), fits)
        });
        let is_meant = !error.fixes.is_empty();
        self.report.add(error);
        is_meant
    }
}
