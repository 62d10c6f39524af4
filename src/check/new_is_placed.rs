//! Law 8: what is new is placed.
//!
//! A new element receives every attribute that has no default: a new vertex its
//! `position`, and each element the attributes that the program declares without one.

use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Access, Attribute, Drawing, Kind, Ref, Rule};

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let mut problems = Vec::new();
    for created in &rule.created {
        for access in without_default(rule, rule.kind(created.name)) {
            let given = rule.assignments.iter().any(|assignment| {
                assignment.target.name == created.name && assignment.attribute == access
            });
            if !given {
                problems.push(missing(rule, created, access).into());
            }
        }
    }
    problems
}

/// The attributes of a kind of element that have no default.
fn without_default(rule: &Rule, kind: Kind) -> Vec<Access> {
    let position = (kind == Kind::Vertex).then_some(Access::Position);
    let Some(element) = kind.element_type() else { return Vec::new() };
    let declared = (0..).zip(rule.attributes.iter());
    let declared = declared
        .filter(|(_, attribute)| attribute.element == element && attribute.default.is_none())
        .map(|(number, _)| Access::Declared(number));
    position.into_iter().chain(declared).collect()
}

fn missing(rule: &Rule, created: &Ref, access: Access) -> Diagnostic {
    let (name, attribute) = (rule.name(created.name), rule.attribute(access));
    let (word, kind) = (&name.text, name.kind.word());
    if let Access::Declared(number) = access
        && let Some(declared) = rule.attributes.get(number as usize)
        && declared.span.file < created.span.file
    {
        return missing_elsewhere(created, name.kind, declared);
    }
    let message = match access {
        Access::Position => format!("the new vertex `{word}` has no position"),
        Access::Declared(_) => {
            format!("the new {kind} `{word}` has no `{attribute}`, which has no default")
        }
    };
    let problem = Diagnostic::error("missing-attribute", message, created.span)
        .saying("created here")
        .note(format!("set it in `after`: `{word}.{attribute} = …`"));
    match access {
        Access::Position => problem,
        Access::Declared(number) => {
            let declared = rule.attributes.get(number as usize);
            let span = declared.map_or(created.span, |declared| declared.span);
            problem
                .label(span, "declared here")
                .note("or give the attribute a default where it is declared")
        }
    }
}

/// The message about an op in a used file, which does not know the attribute: the declaration has
/// to change. It is the same for every such op.
fn missing_elsewhere(created: &Ref, kind: Kind, declared: &Attribute) -> Diagnostic {
    let Attribute { name, ty, .. } = declared;
    let made = kind.a_word();
    let message = format!("`{name}` has no default, and a used file creates {made} without it");
    let default = format!(" = {}", ty.zero().unwrap_or_default());
    let declaration = format!("attr {name}: {} {}{default}", kind.word(), ty.word());
    Diagnostic::error("missing-attribute", message, declared.span)
        .label(created.span, "created here")
        .fix(format!("write `{declaration}`"), declared.behind, default)
}
