//! Statements of a script other than loops: variables, attributes, choices, output.

use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::diagram::{Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Action, ActionKind, Digits, Ident, Piece, Shown};

use super::declared::duplicate;
use super::fields::{Field, fields_of};
use super::foreign_words;
use super::lookup::not_called;
use super::op_call::Asked;
use super::program::{Print, Statement, StatementKind};
use super::scopes::{Binding, Local};
use super::script::Scripting;
use super::type_name::type_named;
use super::typing::Typing;
use super::vocabulary::is_function;
use super::words::{short, subject};

/// The maximum number of statements after one on its line that are taken for foreign syntax.
const MOST_BESIDE: usize = 100;

impl Scripting<'_> {
    /// `let x = …`, `var x = …`
    pub(super) fn declaration(&mut self, action: &Action) -> Option<StatementKind> {
        let ActionKind::Let { mutable, name, ty, value } = &action.kind else { return None };
        if let Some(first) = self.typing.scopes.find_here(&name.text) {
            self.typing.report.add(duplicate("a variable", name, first.span));
        }
        let annotated = ty.as_ref().map(|ty| type_named(ty, self.typing.report));
        let wanted = annotated.flatten();
        let applied = self.applied_value(value);
        let (ty, value) = match applied {
            Some(applied) => {
                let applied = applied.and_then(|applied| {
                    self.result_fits(&applied, wanted, name, value.span).then_some(applied)
                });
                (applied.as_ref().map(|a| a.result), Err(applied))
            }
            None => {
                self.typing.may_change = !self.typing.updating;
                let whose = format!("`{}`", name.text);
                let value = self.typing.expression_for(value, wanted, &whose);
                (value.as_ref().map(|value| value.ty), Ok(value))
            }
        };
        let keyword =
            Span { end: action.span.start.saturating_add(3).min(name.span.start), ..action.span };
        let variable = self.typing.scopes.declare(Local {
            name: name.text.clone(),
            span: name.span,
            ty: wanted.or(ty),
            binding: match mutable {
                true => Binding::Var { typed: annotated.is_some() },
                false => Binding::Let(keyword),
            },
        });
        match value {
            Ok(value) => value.map(|value| StatementKind::Set { variable, value }),
            Err(applied) => applied.map(|applied| applied.into_variable(variable, Vec::new())),
        }
    }

    /// True if a variable is declared as in other languages, `int x = 3`, which parses as two
    /// statements: the name of a type and an assignment. Reports it once.
    pub(super) fn declared_elsewhere(&mut self, action: &Action, next: Option<&Action>) -> bool {
        let (ActionKind::Expr(word), Some(next)) = (&action.kind, next) else { return false };
        let ActionKind::Assign { target, value } = &next.kind else { return false };
        let (Some(word), Some(name)) = (word.plain_name(), target.plain_name()) else {
            return false;
        };
        let scopes = &self.typing.scopes;
        if !foreign_words::declares(&word.text)
            || scopes.find(&word.text).is_some()
            || scopes.find(&name.text).is_some()
        {
            return false;
        }
        let written = word.span.to(name.span);
        let message = format!("a variable is not declared with `{}`", word.text);
        // What kind of element a variable is, follows from its value.
        let ty = foreign_words::declared_type(&word.text).filter(|_| !reads_pointer(value));
        let ty = ty.map_or(String::new(), |ty| format!(": {ty}"));
        let ours = format!("let {}{ty}", name.text);
        let error = Diagnostic::error("unknown-name", message, written)
            .note("a variable begins with `let`, or with `var` if it changes")
            .fix(format!("write `{ours}`"), written, ours);
        self.typing.report.add(error);
        self.assumed(name, None);
        true
    }

    /// Foreign syntax that parses as several statements, one after the other on a line:
    /// `throw "no"`, `-- a comment`. Reports the first, and returns how many of the `rest` belong
    /// to it.
    pub(super) fn foreign_words(&mut self, action: &Action, rest: &[Action]) -> Option<usize> {
        if !matches!(action.kind, ActionKind::Print(_) | ActionKind::Expr(_)) {
            return None;
        }
        let mut end = action.span.end;
        let beside = rest.iter().take(MOST_BESIDE).take_while(|next| {
            let touches = next.span.start <= end + 1;
            end = next.span.end;
            touches
        });
        let beside = beside.count();
        if let ActionKind::Print(_) = &action.kind {
            return self.values_without_commas(action, &rest[..beside]);
        }
        let ActionKind::Expr(first) = &action.kind else { return None };
        if let tree::ExprKind::Unary(tree::UnaryOp::Negate, inner) = &first.kind
            && let tree::ExprKind::Unary(tree::UnaryOp::Negate, counted) = &inner.kind
            && inner.span.start == first.span.start + 1
        {
            let may_change = |text: &String| {
                let (root, field) = text.split_once('.').unwrap_or((text, ""));
                let local = self.typing.scopes.find(root);
                beside == 0
                    && counted.span.start == first.span.start + 2
                    && local.is_some_and(|(_, local)| {
                        !field.is_empty() || matches!(local.binding, Binding::Var { .. })
                    })
            };
            if let Some(counted) = short(counted, 5).filter(may_change) {
                let change = format!("{counted} = {counted} - 1");
                let message = format!("a change is written out: `{change}`");
                let error = Diagnostic::error("unused-value", message, first.span);
                let fix = format!("write `{change}`");
                self.typing.report.add(error.fix(fix, first.span, change));
                return Some(beside);
            }
            let signs = Span { end: first.span.start + 2, ..first.span };
            let error = Diagnostic::error("unused-value", "a comment begins with `//`", first.span);
            self.typing.report.add(error.fix("write `//`", signs, "//"));
            return Some(beside);
        }
        let word = first.plain_name()?;
        let is_known = self.typing.scopes.find(&word.text).is_some();
        if beside == 0 || is_known || foreign_words::declares(&word.text) {
            return None;
        }
        self.typing.unknown_name(&word.text, word.span);
        Some(beside)
    }

    /// `print n " of " m`
    fn values_without_commas(&mut self, print: &Action, beside: &[Action]) -> Option<usize> {
        let ActionKind::Expr(next) = &beside.first()?.kind else { return None };
        // A call may be a separate statement.
        if matches!(next.kind, tree::ExprKind::Call { .. } | tree::ExprKind::Must(_)) {
            return None;
        }
        let values = beside.iter().take_while(|one| matches!(one.kind, ActionKind::Expr(_)));
        let count = values.count();
        let last = match &print.kind {
            ActionKind::Print(values) => values.last(),
            _ => None,
        };
        let last = last.and_then(|shown| match shown {
            Shown::Value(value) => Some(value),
            Shown::Text(..) => None,
        });
        let others = beside[..count].iter().filter_map(|one| match &one.kind {
            ActionKind::Expr(value) => Some(value),
            _ => None,
        });
        let values: Vec<&tree::Expr> = last.into_iter().chain(others).collect();
        let called = values.windows(2).find_map(|pair| {
            let function = pair[0].plain_name().filter(|name| self.is_function(&name.text))?;
            self.has_value(pair[1]).then_some((function, pair[1].span))
        });
        if let Some((function, value)) = called {
            let mut error = not_called(&function.text, function.span);
            let gap = Span { start: function.span.end, end: value.start, ..value };
            let edits = [(gap, "("), (value.after(), ")")];
            let edits = edits.map(|(span, text)| Edit { span, text: text.into() }).into();
            error.fixes.push(Fix { title: format!("write `{}(…)`", function.text), edits });
            self.typing.report.add(error);
            return Some(count);
        }
        let are_values = values.iter().all(|value| self.has_value(value));
        let message = "commas stand between values that are printed";
        let mut error = Diagnostic::error("unused-value", message, next.span);
        if are_values {
            let before = std::iter::once(print).chain(&beside[..count - 1]);
            let edits = before.map(|one| Edit { span: one.span.after(), text: ",".into() });
            error.fixes.push(Fix { title: "write `,`".into(), edits: edits.collect() });
        } else {
            error = error.note("words that are printed stand in quotes");
        }
        self.typing.report.add(error);
        self.action(print);
        Some(count)
    }

    /// True if the name is that of a function, and of no variable.
    fn is_function(&self, name: &str) -> bool {
        let Typing { scopes, declared, .. } = &self.typing;
        scopes.find(name).is_none() && (is_function(name) || declared.function(name).is_some())
    }

    /// True if an expression has a value here; reports nothing.
    fn has_value(&mut self, value: &tree::Expr) -> bool {
        self.typing.quietly(|typing| typing.expression(value)).is_some()
    }

    /// Declares what was taken for a variable, so that it is reported as unknown only once.
    pub(super) fn assumed(&mut self, name: &Ident, ty: Option<Type>) {
        self.typing.scopes.declare(Local {
            name: name.text.clone(),
            span: name.span,
            ty,
            // No type is to be written here.
            binding: Binding::Var { typed: true },
        });
    }

    /// `if c { … } else { … }`, where `c` may be the call of an op.
    pub(super) fn choice(
        &mut self,
        binding: Option<&Ident>,
        condition: &tree::Expr,
        then: &tree::Block,
        otherwise: Option<&tree::Block>,
    ) -> Option<StatementKind> {
        if binding.is_some() || self.is_op_call(condition) {
            return self.if_applied(binding, condition, (then, otherwise), Self::block);
        }
        self.typing.may_change = !self.typing.updating;
        let condition = self.typing.expression_as(condition, Type::Bool, "`if`");
        let then = self.block(then);
        let otherwise = otherwise.map(|block| self.block(block)).unwrap_or_default();
        Some(StatementKind::If { condition: condition?, then, otherwise })
    }

    /// `print a, "b {c:.3}"`
    pub(super) fn print(&mut self, values: &[Shown]) -> Option<StatementKind> {
        let mut pieces = Vec::new();
        for (at, shown) in values.iter().enumerate() {
            if at > 0 {
                pieces.push(Some(Print::Text(" ".to_owned())));
            }
            match shown {
                Shown::Value(value) => pieces.push(self.printed(value, Digits::Few)),
                Shown::Text(inside, _) => pieces.extend(inside.iter().map(|piece| match piece {
                    Piece::Text(text) => Some(Print::Text(text.clone())),
                    Piece::Value(value, digits) => self.printed(value, *digits),
                })),
            }
        }
        let pieces = pieces.into_iter().collect::<Option<_>>()?;
        Some(StatementKind::Print(pieces))
    }

    fn printed(&mut self, written: &tree::Expr, digits: Digits) -> Option<Print> {
        let value = self.typing.expression(written)?;
        let of_numbers = matches!(value.ty, Type::Int | Type::Real)
            || value.ty.is_vector()
            || value.ty.is_matrix();
        match value.kind {
            ExprKind::Text(text) if digits == Digits::Few => Some(Print::Text(text)),
            _ if of_numbers || digits == Digits::Few => Some(Print::Value(value, digits)),
            _ => {
                let message = format!(
                    "digits are of numbers, vectors and matrices, but {} is {}",
                    subject(written),
                    value.ty.a_word()
                );
                self.typing.report.reject(Diagnostic::error("type-mismatch", message, written.span))
            }
        }
    }

    /// `break`, `continue`
    pub(super) fn of_a_loop(
        &mut self,
        word: &str,
        kind: StatementKind,
        span: Span,
    ) -> Option<StatementKind> {
        if self.loops == 0 {
            let message = format!("`{word}` stands inside of a loop");
            return self.typing.report.reject(Diagnostic::error("outside-loop", message, span));
        }
        Some(kind)
    }

    /// An expression as a statement: the call of an op or a function, or a mistake.
    pub(super) fn alone(&mut self, expr: &tree::Expr) -> Option<StatementKind> {
        match &expr.kind {
            tree::ExprKind::Call { function, args }
                if self.typing.declared.function(&function.text).is_some() =>
            {
                self.called_alone(function, args, expr.span)
            }
            tree::ExprKind::Call { function, args }
                if !self.typing.declared.is_called(&function.text)
                    || self.typing.declared.op(&function.text).is_some() =>
            {
                let asked = self.typing.application(function, args, expr.span)?;
                Some(Asked::from(asked).choosing([Vec::new(), Vec::new()]))
            }
            tree::ExprKind::Must(inner) => {
                let tree::ExprKind::Call { function, args } = &inner.kind else {
                    return self.typing.misplaced_must(inner, expr.span);
                };
                let asked = self.typing.application(function, args, inner.span)?;
                let refused = StatementKind::Refused { op: asked.0 };
                let otherwise = vec![Statement { kind: refused, span: expr.span }];
                Some(Asked::from(asked).choosing([Vec::new(), otherwise]))
            }
            _ => {
                let value: Expr = self.typing.expression(expr)?;
                self.unused(value.ty, expr.span)
            }
        }
    }

    /// True if a statement is allowed in `update`, which leaves the connectivity unchanged;
    /// otherwise reports an error.
    pub(super) fn may_update(&mut self, action: &Action) -> bool {
        let span = match &action.kind {
            ActionKind::Let { value, .. } | ActionKind::Assign { value, .. } => match &value.kind {
                tree::ExprKind::Must(_) => value.span,
                _ => return true,
            },
            ActionKind::If { binding, condition, .. } => {
                if binding.is_none() && !self.is_op_call(condition) {
                    return true;
                }
                condition.span
            }
            ActionKind::Block(_) | ActionKind::Broken => return true,
            _ => action.span,
        };
        let message = "`update` only computes and writes attributes";
        let way = match &action.kind {
            ActionKind::For { .. } => {
                "a value that needs a loop is computed by a function: `v.position = mean_around(v)`"
            }
            _ => "inside of `update` there may be `let`, `var`, assignments and `if`",
        };
        self.typing.report.add(Diagnostic::error("not-in-update", message, span).note(way));
        false
    }
}

/// True if a value is what a pointer leads to.
fn reads_pointer(value: &tree::Expr) -> bool {
    let tree::ExprKind::Field(_, field) = &value.kind else { return false };
    let is_pointer =
        |(name, kind): &(&str, Field)| *name == field.text && matches!(kind, Field::Pointer(..));
    [Type::Halfedge, Type::Vertex].into_iter().any(|ty| fields_of(ty).iter().any(is_pointer))
}
