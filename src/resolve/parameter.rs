//! Parameters of ops, functions and scripts, and their defaults.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, Type};
use crate::syntax::tree::{self, Ident};

use super::declared::{Declared, duplicate};
use super::report::Report;
use super::scopes::{Binding, Local};
use super::signature::Parameter;
use super::type_name::type_named;
use super::typing::{Place, Typing};

/// The maximum number of parameters of an item.
const MOST_PARAMETERS: usize = 255;

/// The kind of item that has the parameters.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// An op: elements and values; a default names nothing.
    Op,
    /// A script: elements and values; a default may name earlier parameters.
    Script,
    /// A function: elements and values; a default names nothing.
    Function,
}

/// The parameters of an item.
pub(super) fn parameters(
    params: &[tree::Param],
    owner: Owner,
    declared: &Declared,
    report: &mut Report,
) -> Vec<Parameter> {
    if let Some(beyond) = params.get(MOST_PARAMETERS) {
        let message =
            format!("this has {} parameters, and there can be {MOST_PARAMETERS}", params.len());
        let error = Diagnostic::error("too-large", message, beyond.span);
        report.add(error.note("numbers that belong together can be one vector or matrix"));
    }
    let mut understood: Vec<Parameter> = Vec::new();
    for param in params.iter().take(MOST_PARAMETERS) {
        let name = &param.name.ident;
        if let Some(first) = understood.iter().find(|p| p.name == name.text) {
            report.add(duplicate("a parameter", name, first.span));
        }
        let ty = type_named(&param.ty, report).filter(|ty| allowed(*ty, owner, param, report));
        let default = param.default.as_ref().and_then(|default| {
            let ty = ty?;
            let earlier = match owner {
                Owner::Op | Owner::Function => &[],
                Owner::Script => understood.as_slice(),
            };
            default_value(default, (name, ty), earlier, declared, report)
        });
        understood.push(Parameter {
            name: name.text.clone(),
            span: name.span,
            ty,
            optional: param.default.is_some(),
            default,
        });
    }
    understood
}

/// True if the owner may have a parameter of this type; otherwise reports an error.
fn allowed(ty: Type, owner: Owner, param: &tree::Param, report: &mut Report) -> bool {
    let (fits, message) = match owner {
        Owner::Function => return true,
        Owner::Op => (
            ty != Type::Text,
            "a parameter of an op is an element, a bool, a number, a vector or a matrix".to_owned(),
        ),
        Owner::Script => (
            matches!(ty, Type::Bool | Type::Int | Type::Real) || ty.is_vector() || ty.is_element(),
            format!(
                "a parameter of a script is an element, a bool, a number or a vector, not {}",
                ty.a_word()
            ),
        ),
    };
    if !fits {
        report.add(Diagnostic::error("parameter-type", message, param.ty.span));
    }
    fits
}

/// The default of a parameter.
fn default_value(
    default: &tree::Expr,
    (name, ty): (&Ident, Type),
    earlier: &[Parameter],
    declared: &Declared,
    report: &mut Report,
) -> Option<Expr> {
    if ty.is_element() {
        let message = format!("`{}` is {}, and an element has no default", name.text, ty.a_word());
        return report.reject(Diagnostic::error("parameter-type", message, default.span));
    }
    let mut typing =
        Typing::new(Place::Default("a parameter of a function"), declared, earlier, report);
    typing.whole_as(default, ty, &format!("`{}`", name.text))
}

/// A parameter as a variable with the same number.
pub(super) fn local(parameter: &Parameter) -> Local {
    Local {
        name: parameter.name.clone(),
        span: parameter.span,
        ty: parameter.ty,
        binding: Binding::Parameter,
    }
}
