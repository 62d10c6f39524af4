//! Assignments to variables, attributes of elements, and their components.

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::diagram::{Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::Part;
use crate::syntax::tree::{self, Ident};

use super::fields::{Field, fields_of};
use super::program::StatementKind;
use super::scopes::{Binding, Local};
use super::script::Scripting;
use super::suggestion::suggest;
use super::typed::typed;
use super::typing::converted;
use super::words::short;

impl Scripting<'_> {
    /// `x = …`, `v.position = …`
    pub(super) fn assignment(
        &mut self,
        target: &tree::Expr,
        value: &tree::Expr,
        span: Span,
    ) -> Option<StatementKind> {
        if let Some(name) = target.plain_name() {
            return self.set(name, value);
        }
        match &target.kind {
            tree::ExprKind::Field(base, field) => self.write(base, field, value),
            _ if is_broken(target) => self.typing.report.fail_silently(),
            _ => {
                let message = "only a variable or an attribute of an element can be assigned";
                let error = Diagnostic::error("not-assignable", message, target.span);
                let error = match attribute_called(target) {
                    Some((attribute, of))
                        if self.typing.declared.element_with(attribute).is_some() =>
                    {
                        error.note(format!("an attribute stands behind a dot: `{of}.{attribute}`"))
                    }
                    _ => error,
                };
                self.typing.report.reject(error.label(span, ""))
            }
        }
    }

    fn set(&mut self, name: &Ident, value: &tree::Expr) -> Option<StatementKind> {
        let word = &name.text;
        let found = self.typing.scopes.find(word);
        let Some((variable, local)) = found.map(|(number, local)| (number, local.clone())) else {
            if word == "mesh" {
                let message = "a script has the mesh it is run on, which has no name";
                let error = Diagnostic::error("test-mesh", message, name.span)
                    .note("a test begins with `mesh = cube()`, or `mesh = load(\"cube.obj\")`");
                self.typing.report.add(error);
                self.typing.report.suppress(word);
                return None;
            }
            let message = format!("there is no variable `{word}`");
            let error = Diagnostic::error("unknown-name", message, name.span);
            let error = suggest(error, word, name.span, self.typing.scopes.names())
                .note("a variable begins with `let` or `var`");
            // In a loop or a branch, it may be meant for what follows them, too.
            let is_outermost = self.typing.scopes.is_outermost();
            let is_new = error.fixes.is_empty() && is_outermost && !reads(value, word);
            let error = error.when(is_new, |error| {
                error.fix(format!("write `var {word} = …`"), name.span.before(), "var ")
            });
            self.typing.report.add(error);
            self.typing.report.suppress(word);
            let ty = self.typing.expression(value).map(|value| value.ty);
            self.assumed(name, ty);
            return None;
        };
        if let Some(error) = fixed(name, &local) {
            self.typing.report.add(error);
        }
        if let Some(applied) = self.applied_value(value) {
            let applied = applied?;
            let fits = self.result_fits(&applied, local.ty, name, value.span);
            return fits.then(|| applied.into_variable(variable, Vec::new()));
        }
        self.typing.may_change = !self.typing.updating;
        let value = match local.ty {
            Some(ty) => {
                let typed = self.typing.expression(value)?;
                let is_wider = (ty, typed.ty) == (Type::Int, Type::Real);
                match converted(value, typed, ty, &format!("`{word}`")) {
                    Ok(value) => value,
                    Err(error) => {
                        let error =
                            error.label(local.span, format!("`{word}` is {} here", ty.a_word()));
                        return self.typing.report.reject(match local.binding {
                            Binding::Var { typed: false } if is_wider => error.fix(
                                format!("declare `{word}: real`"),
                                local.span.after(),
                                ": real",
                            ),
                            Binding::Var { typed: true } if is_wider => {
                                error.note(format!("`var {word}: real = …` makes it a real"))
                            }
                            _ => error,
                        });
                    }
                }
            }
            None => self.typing.expression(value)?,
        };
        Some(StatementKind::Set { variable, value })
    }

    fn write(
        &mut self,
        base: &tree::Expr,
        field: &Ident,
        value: &tree::Expr,
    ) -> Option<StatementKind> {
        let target = self.typing.expression(base);
        let Some(target) = target else {
            self.typing.expression(value);
            return None;
        };
        if !target.ty.is_element() {
            return self.write_component(target, base, field, value);
        }
        let typed = self.typing.expression(value);
        let of = typed.as_ref().map(|value| value.ty);
        let (attribute, ty) = self.typing.attribute_of(target.ty, field, of)?;
        let whose = format!("`{}`", field.text);
        let value = self.typing.convert(value, typed?, ty, &whose)?;
        Some(StatementKind::Write { target, attribute, value })
    }

    /// `v.position.x = …`, `m.x.y = …`: assigns the whole vector or matrix.
    fn write_component(
        &mut self,
        whole: Expr,
        base: &tree::Expr,
        field: &Ident,
        value: &tree::Expr,
    ) -> Option<StatementKind> {
        let (ty, span) = (whole.ty, base.span.to(field.span));
        if !(ty.is_vector() || ty.is_matrix()) {
            let message = format!("{} has no attributes", ty.a_word());
            return self.typing.report.reject(Diagnostic::error("not-assignable", message, span));
        }
        let component = self.typing.field((base, whole.clone()), field, span, false);
        let Some(Expr { kind: ExprKind::Component(from, _), ty, .. }) = component else {
            self.typing.expression(value);
            return None;
        };
        if self.typing.updating && !is_variable(&whole) {
            return self.typing.report.reject(self.whole_vector(base, whole.ty, field, value));
        }
        let part = self.typing.expression_as(value, ty, &format!("`{}`", field.text))?;
        self.replace(whole, from, part, base)
    }

    /// Assigns a vector or matrix in which the part that begins at a number is another one.
    fn replace(
        &mut self,
        whole: Expr,
        from: u8,
        part: Expr,
        written: &tree::Expr,
    ) -> Option<StatementKind> {
        let mut part = Some(part);
        let old = |at, ty| typed(ty, ExprKind::Component(at, Box::new(whole.clone())), whole.span);
        let parts = fields_of(whole.ty).iter().filter_map(|(_, field)| match *field {
            Field::Part(at, _) if at == from => part.take(),
            Field::Part(at, ty) => Some(old(at, ty)),
            _ => None,
        });
        let value = typed(whole.ty, ExprKind::Vector(parts.collect()), whole.span);
        match (whole.kind, &written.kind) {
            (ExprKind::Component(from, outer), tree::ExprKind::Field(written, _)) => {
                self.replace(*outer, from, value, written)
            }
            (ExprKind::Read(attribute, target), _) if is_path(written) => {
                Some(StatementKind::Write { target: *target, attribute, value })
            }
            (ExprKind::Local(variable), _) => {
                let name = written.plain_name()?;
                let (_, local) = self.typing.scopes.find(&name.text)?;
                if let Some(error) = fixed(name, local) {
                    self.typing.report.add(error);
                }
                Some(StatementKind::Set { variable, value })
            }
            _ => {
                let message = "only what has a name has components that can be assigned";
                let error = Diagnostic::error("not-assignable", message, written.span);
                self.typing.report.reject(error.note("a name is given with `let` or `var`"))
            }
        }
    }

    /// The error of a component that is assigned in an `update`, where the next assignment would
    /// replace it by its value from before; its fix assigns the whole vector.
    fn whole_vector(
        &self,
        base: &tree::Expr,
        ty: Type,
        field: &Ident,
        value: &tree::Expr,
    ) -> Diagnostic {
        let message = format!("in an `update`, {} is assigned whole", ty.a_word());
        let mut error = Diagnostic::error("not-assignable", message, base.span.to(field.span))
            .note("all that an `update` reads is as it was before");
        // Of several assignments the last would count.
        let is_set_often = fields(base).any(|word| self.set_often.contains(word));
        let Some(text) = short(base, 3).filter(|_| ty.is_vector() && !is_set_often) else {
            let all: Vec<_> = fields_of(ty).iter().map(|(word, _)| *word).collect();
            return error.note(format!(
                "all at once: `{} = {}({})`",
                short(base, 3).unwrap_or("…".into()),
                ty.word(),
                all.join(", ")
            ));
        };
        let (mut before, mut behind) = (format!("{text} = {}(", ty.word()), String::new());
        let mut is_before = true;
        for (at, (part, _)) in fields_of(ty).iter().enumerate() {
            let comma = if at > 0 { ", " } else { "" };
            match *part == field.text {
                true => {
                    before += comma;
                    is_before = false;
                }
                false if is_before => before += &format!("{comma}{text}.{part}"),
                false => behind += &format!("{comma}{text}.{part}"),
            }
        }
        behind += ")";
        let title = format!("write `{before}…{behind}`");
        let edits = vec![
            Edit { span: Span { end: value.span.start, ..base.span }, text: before },
            Edit { span: value.span.after(), text: behind },
        ];
        error.fixes.push(Fix { title, edits });
        error
    }
}

/// The error for a variable that cannot be assigned, if it is one.
fn fixed(name: &Ident, local: &Local) -> Option<Diagnostic> {
    let word = &name.text;
    let what = match local.binding {
        Binding::Var { .. } => return None,
        Binding::Let(keyword) => {
            let message = format!("`{word}` is declared with `let`, so it cannot change");
            let error = Diagnostic::error("assign-to-let", message, name.span)
                .label(local.span, "it is declared here")
                .fix("write `var`", keyword, "var");
            return Some(error);
        }
        Binding::Parameter => "a parameter",
        Binding::Head => "bound by the statement around it",
    };
    let message = format!("`{word}` is {what}, so it cannot change");
    let error = Diagnostic::error("assign-to-let", message, name.span)
        .label(local.span, "it is declared here")
        .note(format!("a variable that begins with its value can: `var other = {word}`"));
    Some(error)
}

/// The fields that assignments in a block name more than once.
pub(super) fn set_often(block: &tree::Block) -> BTreeSet<String> {
    let (mut once, mut often) = (BTreeSet::new(), BTreeSet::new());
    Part::Block(block).each_within(|part| {
        let Part::Block(block) = part else { return };
        for action in &block.statements {
            if let tree::ActionKind::Assign { target, .. } = &action.kind {
                let again = fields(target).filter(|word| !once.insert((*word).to_owned()));
                often.extend(again.map(str::to_owned));
            }
        }
    });
    often
}

/// The fields that follow each other in an expression, the last first.
fn fields(mut expr: &tree::Expr) -> impl Iterator<Item = &str> {
    std::iter::from_fn(move || {
        let tree::ExprKind::Field(base, field) = &expr.kind else { return None };
        expr = base;
        Some(field.text.as_str())
    })
}

/// Whether an expression is a variable or a component of one.
fn is_variable(whole: &Expr) -> bool {
    match &whole.kind {
        ExprKind::Component(_, outer) => is_variable(outer),
        kind => matches!(kind, ExprKind::Local(_)),
    }
}

/// Whether an expression consists of a name and fields alone, so that it has one value however
/// often it is evaluated.
fn is_path(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Name(_) => true,
        tree::ExprKind::Field(base, _) => is_path(base),
        _ => false,
    }
}

/// True if a value reads a name.
fn reads(value: &tree::Expr, word: &str) -> bool {
    let mut found = false;
    Part::Expr(value).each_within(|part| {
        if let Part::Expr(tree::Expr { kind: tree::ExprKind::Name(name), .. }) = part {
            found |= name.ident.text == word;
        }
    });
    found
}

/// True if an operand could not be read, which the parser has reported.
fn is_broken(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Broken => true,
        tree::ExprKind::Binary(_, left, right) => is_broken(left) || is_broken(right),
        tree::ExprKind::Unary(_, operand) => is_broken(operand),
        _ => false,
    }
}

/// The words `q` and `v` of `q(v)` or `q[v]`.
fn attribute_called(expr: &tree::Expr) -> Option<(&str, &str)> {
    match &expr.kind {
        tree::ExprKind::Call { function, args } => match args.as_slice() {
            [of] => Some((&function.text, &of.plain_name()?.text)),
            _ => None,
        },
        tree::ExprKind::Name(name) => {
            let of = name.index.as_ref()?.variable.as_ref()?;
            Some((&name.ident.text, &of.text))
        }
        _ => None,
    }
}
