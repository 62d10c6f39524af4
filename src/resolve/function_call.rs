//! Calls of functions and scripts declared in the program.

use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Ident};

use super::declared::What;
use super::program::StatementKind;
use super::script::Scripting;
use super::signature::{Effects, FunctionSignature, Parameter, Value};
use super::typed::typed;
use super::typing::{Place, Typing, converted};
use super::words::{are_given, arguments};

/// A call of a function.
struct Invocation {
    number: u32,
    signature: Rc<FunctionSignature>,
    args: Vec<Expr>,
}

impl Typing<'_> {
    /// The value of a call, if the name means a function or script of the program.
    pub(super) fn invoked(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Option<Expr>> {
        self.declared.function(&function.text)?;
        Some(self.invoked_value(function, args, span))
    }

    fn invoked_value(&mut self, function: &Ident, args: &[tree::Expr], span: Span) -> Option<Expr> {
        let invocation = self.invocation(function, args, span)?;
        let name = &invocation.signature.name;
        match invocation.signature.result {
            Value::Of(ty) => {
                let kind = ExprKind::Invoke(invocation.number, invocation.args);
                Some(typed(ty, kind, span))
            }
            Value::Nothing => {
                let message = format!("`{name}` gives no value");
                let error = Diagnostic::error("returns-nothing", message, span)
                    .label(invocation.signature.span, "it is declared here");
                let Effects { changes, prints, .. } = invocation.signature.effects;
                self.report.reject(match changes.or(prints) {
                    Some(_) => error,
                    None => error.note(
                        "functions that call each other in a circle say what they give, behind \
                         the parameters",
                    ),
                })
            }
            Value::Open | Value::Unknown => self.report.fail_silently(),
        }
    }

    fn invocation(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Invocation> {
        let may_change = std::mem::take(&mut self.may_change);
        self.declared.expect_one(function, self.report)?;
        let named = self.declared.called(&function.text)?;
        let signature = Rc::clone(self.declared.function(&function.text)?);
        let allowed = self.expect_allowed(&signature, may_change, function.span);
        let given = args.len();
        let args = self.arguments(&signature.name, &signature.params, args, span);
        allowed?;
        let mut args = args?;
        if named.what == What::Script {
            let flag = |at| typed(Type::Bool, ExprKind::Bool(at < given), span);
            args.extend((0..signature.params.len()).map(flag));
        }
        Some(Invocation { number: named.number as u32, signature, args })
    }

    /// The arguments of a call, with defaults for those left out.
    pub(super) fn arguments(
        &mut self,
        name: &str,
        params: &[Parameter],
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Vec<Expr>> {
        let mut values: Vec<Option<Expr>> = Vec::new();
        for (place, arg) in args.iter().enumerate() {
            values.push(match params.get(place) {
                Some(Parameter { name: param, ty: Some(ty), .. }) => {
                    let whose = format!("`{param}` of `{name}`");
                    self.expression(arg).and_then(|value| {
                        let value = converted(arg, value, *ty, &whose);
                        value.map_err(|error| self.report.add(with_head(error, name, params))).ok()
                    })
                }
                // Of unknown type, or one argument too many.
                _ => self.expression(arg),
            });
        }
        self.right_argument_count(name, params, args.len(), span)?;
        for param in &params[args.len()..] {
            if param.default.is_none() {
                self.report.fail();
            }
            values.push(param.default.clone());
        }
        values.into_iter().collect()
    }

    /// Reports a wrong number of arguments.
    fn right_argument_count(
        &mut self,
        name: &str,
        params: &[Parameter],
        given: usize,
        span: Span,
    ) -> Option<()> {
        let most = params.len();
        // A parameter before a required one cannot be left out either.
        let least = params.iter().rposition(|param| !param.optional).map_or(0, |place| place + 1);
        if (least..=most).contains(&given) {
            return Some(());
        }
        let wanted = match least {
            least if least == most => arguments(most),
            least => format!("{least} to {}", arguments(most)),
        };
        let message = format!("`{name}` takes {wanted}, but {}", are_given(given));
        let error = Diagnostic::error("wrong-count", message, span);
        self.report.reject(with_head(error, name, params))
    }

    /// Reports a function whose effects are not allowed in this place.
    fn expect_allowed(
        &mut self,
        signature: &FunctionSignature,
        may_change: bool,
        span: Span,
    ) -> Option<()> {
        let (name, effects) = (&signature.name, &signature.effects);
        let error = |code, what: &str| {
            let message = format!("`{name}` {what}, so it cannot be called here");
            Diagnostic::error(code, message, span)
        };
        let error = match self.place {
            Place::Script => {
                let Some(place) = effects.changes.filter(|_| !may_change) else { return Some(()) };
                let (code, note) = match self.updating {
                    true => ("not-in-update", "`update` only computes and writes attributes"),
                    false => (
                        "changes-mesh",
                        "such a call stands as a statement, or is the whole value of a variable, \
                         of `if`, `while` or `return`",
                    ),
                };
                error(code, "changes the mesh").label(place, "it is changed here").note(note)
            }
            Place::Rule(_) | Place::Default(_) => {
                if let Some(place) = effects.changes {
                    error("changes-mesh", "changes the mesh").label(place, "it is changed here")
                } else if let Some(place) = effects.prints {
                    error("changes-mesh", "prints").label(place, "here")
                } else if let Some(place) = effects.looks {
                    error("whole-mesh", "looks at the whole mesh").label(place, "here")
                } else if let Some(place) = effects.asks {
                    error("misplaced-can", "asks an op").label(place, "here")
                } else if let Some(place) = effects.draws {
                    error("misplaced-random", "takes a random number").label(place, "here")
                } else {
                    return Some(());
                }
            }
        };
        self.report.reject(error)
    }
}

impl Scripting<'_> {
    /// A call of a function as a statement.
    pub(super) fn called_alone(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<StatementKind> {
        self.typing.may_change = true;
        let invocation = self.typing.invocation(function, args, span)?;
        let Invocation { number, signature, args } = invocation;
        let result = match signature.result {
            Value::Of(ty) => Some(ty),
            Value::Nothing => None,
            Value::Open | Value::Unknown => return self.typing.report.fail_silently(),
        };
        let effects = signature.effects;
        if let Some(ty) = result.filter(|_| effects.changes.or(effects.prints).is_none()) {
            return self.unused(ty, span);
        }
        Some(StatementKind::Call { function: number, args, result })
    }

    /// Reports a value that is not used.
    pub(super) fn unused<T>(&mut self, ty: Type, span: Span) -> Option<T> {
        let message = "this value is not used";
        let error = Diagnostic::error("unused-value", message, span)
            .saying(format!("this is {}", ty.a_word()));
        self.typing.report.reject(error)
    }
}

/// An error about the arguments of a call, which shows the head of the callee where nothing else
/// says how to go on.
fn with_head(error: Diagnostic, name: &str, params: &[Parameter]) -> Diagnostic {
    if !error.notes.is_empty() || !error.fixes.is_empty() {
        return error;
    }
    let written = |param: &Parameter| {
        let ty = param.ty.map(|ty| format!(": {}", ty.word())).unwrap_or_default();
        format!("{}{ty}{}", param.name, if param.optional { " = …" } else { "" })
    };
    let params: Vec<_> = params.iter().map(written).collect();
    error.note(format!("it is declared as `{name}({})`", params.join(", ")))
}
