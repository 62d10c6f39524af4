//! A function: its signature and its body.

use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Require, Type};
use crate::source::Span;
use crate::syntax::tree;

use super::condition::requires;
use super::declared::Declared;
use super::depth::shallow_block;
use super::parameter::{Owner, parameters};
use super::program::{Body, Function};
use super::report::Report;
use super::return_value::Returns;
use super::returns::ends;
use super::script::Scripting;
use super::signature::{Effects, FunctionSignature, Parameter, Signature, Value};
use super::type_name::type_named;
use super::typed::typed;

/// The signature of a function, as far as it is written.
pub(super) fn written_signature(
    function: &tree::Fn,
    effects: Effects,
    declared: &Declared,
    report: &mut Report,
) -> FunctionSignature {
    if !declared.has_its_name(&function.name) {
        report.fail();
    }
    let params = parameters(&function.params, Owner::Function, declared, report);
    let result = match &function.result {
        Some(word) => type_named(word, report).map_or(Value::Unknown, Value::Of),
        None => Value::Open,
    };
    FunctionSignature {
        name: function.name.text.clone(),
        span: function.name.span,
        params,
        result,
        effects,
    }
}

/// The signature of a script, for its calls. The script evaluates its own defaults, so for a
/// parameter that a call leaves out, any value of the type will do.
pub(super) fn script_signature(script: &tree::Script) -> FunctionSignature {
    let span = script.name.span;
    let params = script.params.iter().map(|param| {
        let name = &param.name.ident;
        let ty = type_named(&param.ty, &mut Report::default());
        let default = param.default.as_ref().zip(ty).map(|(_, ty)| zero(ty, span));
        let (name, span, optional) = (name.text.clone(), name.span, param.default.is_some());
        Parameter { name, span, ty, optional, default }
    });
    FunctionSignature {
        name: script.name.text.clone(),
        span,
        params: params.collect(),
        result: Value::Nothing,
        effects: Effects::all(span),
    }
}

/// Some value of a type that a script parameter can have.
fn zero(ty: Type, span: Span) -> Expr {
    let kind = match ty {
        Type::Bool => ExprKind::Bool(false),
        Type::Real => ExprKind::Real(0.0),
        _ if ty.is_vector() => {
            let part = |_| typed(Type::Real, ExprKind::Real(0.0), span);
            ExprKind::Vector((0..ty.size()).map(part).collect())
        }
        _ => ExprKind::Int(0),
    };
    typed(ty, kind, span)
}

/// Resolves the body of a function, and with it its result type, if that is not written. If
/// `cycles`, the body itself depends on that type; then the function returns nothing.
pub(super) fn resolve_function(
    function: &tree::Fn,
    signature: &Rc<FunctionSignature>,
    ops: &[Signature],
    cycles: bool,
    declared: &Declared,
    report: &mut Report,
) -> (Value, Function) {
    let written = (None, &function.body);
    let (value, _, body) = resolve_body(written, signature, ops, cycles, declared, report);
    let resolved = Function {
        name: signature.name.clone(),
        span: signature.span,
        docs: function.docs.clone(),
        params: signature.params.iter().map(Parameter::param).collect(),
        result: value.ty(),
        body,
    };
    (value, resolved)
}

/// Resolves the statements of a function, or the steps of an op and its conditions.
pub(super) fn resolve_body(
    (asked, written): (Option<&[tree::Condition]>, &tree::Block),
    signature: &FunctionSignature,
    ops: &[Signature],
    cycles: bool,
    declared: &Declared,
    report: &mut Report,
) -> (Value, Vec<Require>, Option<Body>) {
    if !shallow_block(written, report) {
        return (signature.result, Vec::new(), None);
    }
    let mut scripting = Scripting::beginning(&signature.params, ops, declared, report);
    scripting.returns = Returns::of_function(signature, cycles);
    let is_open = cycles || signature.result == Value::Open;
    scripting.returns.head = is_open.then(|| written.span.before());
    scripting.steps_of = asked.map(|_| signature.name.as_str());
    let asked = asked.unwrap_or_default();
    let requires = requires(asked, &signature.name, &mut scripting.typing);
    let block = scripting.body(written);
    let value = scripting.returns.value();
    let scopes = scripting.typing.scopes;
    declared.meet_variables(&scopes);
    if let Value::Of(ty) = value
        && !report.failed()
        && !ends(&block)
    {
        let end = Span { start: written.span.end.saturating_sub(1), ..written.span };
        let message = format!("`{}` may come to its end without a value", signature.name);
        report.add(Diagnostic::error("missing-return", message, end).note(format!(
            "every way through it has to end with `return` and a value of type `{}`, or with \
             the value itself",
            ty.word()
        )));
    }
    if report.failed() {
        // The part that failed may have determined the result.
        let is_open = value == Value::Nothing && signature.result == Value::Open;
        let value = if is_open { Value::Unknown } else { value };
        return (value, requires, None);
    }
    let body = scopes.into_variables().map(|variables| Body { variables, block });
    (value, requires, body)
}
