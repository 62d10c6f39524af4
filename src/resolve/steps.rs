//! An op in steps: it calls other ops instead of drawing, as one transaction (all or nothing).
//!
//! Its signature is resolved with those of the other ops; its body later, when everything that it
//! may call is resolved.

use std::rc::Rc;

use crate::diagnostic::Diagnostic;
use crate::diagram::Level;
use crate::syntax::tree;

use super::condition::guard;
use super::declared::Declared;
use super::program;
use super::property::properties;
use super::report::Report;
use super::routine::resolve_body;
use super::signature::{Effects, FunctionSignature, Parameter, Signature, Value};
use super::type_name::type_among;

/// The signature of an op in steps, for its calls, and the op without its steps.
pub(super) fn steps_signature(
    op: &tree::Op,
    params: Vec<Parameter>,
    report: &mut Report,
) -> (Signature, program::Op) {
    let result = match &op.result {
        None => Value::Nothing,
        Some(word)
            if let Some(param) = op.params.iter().find(|one| one.name.ident.text == word.text) =>
        {
            let kind = param.ty.text.as_str();
            let message = "an op in steps says of what kind it returns an element";
            let error = Diagnostic::error("unknown-type", message, word.span)
                .note(format!("which one it is says `return {}`", word.text));
            report.add(error.fix(format!("write `{kind}`"), word.span, kind));
            Value::Unknown
        }
        Some(word) => match type_among(word, |ty| ty.is_element(), report) {
            Some(ty) if ty.is_element() => Value::Of(ty),
            Some(ty) => {
                let message = format!(
                    "`{}` is {}; an op returns a vertex, a halfedge, an edge or a face",
                    word.text,
                    ty.a_word()
                );
                report.add(Diagnostic::error("not-an-element", message, word.span));
                Value::Unknown
            }
            None => Value::Unknown,
        },
    };
    let signature = Signature { name: op.name.text.clone(), params, result };
    let resolved = signature.op(op.name.span, None);
    (signature, resolved)
}

/// Resolves the steps of an op; `None` if an error has been reported.
pub(super) fn resolve_steps(
    op: &tree::Op,
    steps: &tree::Steps,
    signature: &Signature,
    ops: &[Signature],
    declared: &Declared,
    report: &mut Report,
) -> Option<program::Steps> {
    let level =
        guard(&steps.conditions, &signature.params, report).map_or(Level::Map, |(level, _)| level);
    for condition in &steps.conditions {
        if let tree::Condition::Alias { span, .. } = condition {
            let message = "an op in steps draws nothing that could be one";
            report.add(Diagnostic::error("cannot-alias", message, *span));
        }
    }
    let keeps = properties(&op.keeps, report);
    let as_function = Rc::new(FunctionSignature {
        name: signature.name.clone(),
        span: op.name.span,
        params: signature.params.clone(),
        result: signature.result,
        effects: Effects::default(),
    });
    let written = (Some(&steps.conditions[..]), &steps.body);
    let (_, requires, body) = resolve_body(written, &as_function, ops, false, declared, report);
    let steps = program::Steps { docs: op.docs.clone(), requires, level, keeps, body: body? };
    (!report.failed()).then_some(steps)
}
