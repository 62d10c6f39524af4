//! Law 8: what is new is placed.
//!
//! A new element receives every attribute that has no default: a new vertex its
//! `position`, and each element the attributes that the program declares without one.

use super::problem::{Problem, enumerate};
use crate::diagnostic::Diagnostic;
use crate::diagram::{
    Access, Assignment, Attribute, Drawing, Expr, ExprKind, Kind, NameId, Ref, Rule, Type,
};

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let mut lacking: Vec<(Kind, Access, Vec<Ref>)> = Vec::new();
    // In an unrolled rule, the first member is reported for its family.
    for created in rule.created.iter().filter(|created| rule.is_first(created.name)) {
        let kind = rule.kind(created.name);
        for access in without_default(rule, kind) {
            let given = rule.assignments.iter().any(|assignment| {
                assignment.target.name == created.name && assignment.attribute == access
            });
            if given {
                continue;
            }
            match lacking.iter_mut().find(|(of, known, _)| (*of, *known) == (kind, access)) {
                Some((_, _, names)) => names.push(*created),
                None => lacking.push((kind, access, vec![*created])),
            }
        }
    }
    let told = lacking.iter().filter_map(|(_, access, names)| {
        let (first, others) = names.split_first()?;
        Some(missing(rule, first, others, *access).into())
    });
    told.collect()
}

/// The rule with a value for each attribute that new elements lack, whatever it is.
pub(super) fn placed(rule: &Rule) -> Rule {
    let mut placed = rule.clone();
    for created in &rule.created {
        for attribute in without_default(rule, rule.kind(created.name)) {
            let span = created.span;
            let value = Expr { ty: Type::Real, kind: ExprKind::Real(0.0), span };
            placed.assignments.push(Assignment { target: *created, attribute, value, span });
        }
    }
    placed
}

/// The attributes of a kind of element that have no default.
fn without_default(rule: &Rule, kind: Kind) -> Vec<Access> {
    let position = (kind == Kind::Vertex).then_some(Access::Position);
    let Some(element) = kind.element_type() else { return Vec::new() };
    let declared = (0..).zip(rule.attributes.iter());
    let declared = declared
        .filter(|(_, attribute)| attribute.element == element && attribute.lacks_default)
        .map(|(number, _)| Access::Declared(number));
    position.into_iter().chain(declared).collect()
}

/// The message about new elements of one kind that lack an attribute.
fn missing(rule: &Rule, first: &Ref, others: &[Ref], access: Access) -> Diagnostic {
    let attribute = rule.attribute(access);
    let (word, kind) = (&rule.name(first.name).text, rule.kind(first.name));
    if let Access::Declared(number) = access
        && let Some(declared) = rule.attributes.get(number as usize)
        && declared.span.file < first.span.file
    {
        return missing_elsewhere(first, kind, declared);
    }
    let names = [first].into_iter().chain(others).map(|created| created.name);
    let names: Vec<_> = names.collect();
    let list = enumerate(rule, &names);
    let who = match others {
        [] => format!("the new {} {list} has", kind.word()),
        _ => format!("the new {} {list} have", kind.plural()),
    };
    let message = match access {
        Access::Position => format!("{who} no position"),
        Access::Declared(_) => format!("{who} no `{attribute}`, which has no default"),
    };
    let value = match access {
        Access::Position => place(rule, first.name),
        Access::Declared(_) => "…".to_owned(),
    };
    let mut problem = Diagnostic::error("missing-attribute", message, first.span)
        .saying("created here")
        .note(format!("set it in `after`: `{word}.{attribute} = {value}`"));
    for other in others {
        problem = problem.label(other.span, "");
    }
    match access {
        Access::Position => problem,
        Access::Declared(number) => {
            let declared = rule.attributes.get(number as usize);
            let span = declared.map_or(first.span, |declared| declared.span);
            problem
                .label(span, "declared here")
                .note("or give the attribute a default where it is declared")
        }
    }
}

/// An expression for the place of a single new vertex, from what is drawn before; `…` if nothing
/// suggests one.
fn place(rule: &Rule, vertex: NameId) -> String {
    let drawn = rule.params.iter().flatten().find_map(|&name| {
        let word = &rule.name(name).text;
        match rule.kind(name) {
            Kind::Edge => Some(format!("midpoint({word})")),
            Kind::Face => Some(format!("centroid({word})")),
            Kind::Vertex => Some(format!("{word}.position")),
            _ => None,
        }
    });
    drawn.filter(|_| !rule.is_member(vertex)).unwrap_or_else(|| "…".to_owned())
}

/// The message about an op in a used file, which does not know the attribute: the declaration has
/// to change. It is the same for every such op.
fn missing_elsewhere(created: &Ref, kind: Kind, declared: &Attribute) -> Diagnostic {
    let Attribute { name, ty, .. } = declared;
    let made = kind.a_word();
    let message = format!("`{name}` has no default, and a used file creates {made} without it");
    let zero = ty.zero().unwrap_or_default();
    let error = Diagnostic::error("missing-attribute", message, declared.span)
        .label(created.span, "created here");
    let (default, error) = match kind {
        Kind::Vertex => (format!(" = {zero}"), error),
        _ => (
            format!(" = inherited({zero})"),
            error.note(format!(
                "a new {0} then takes over the value of the {0} that it comes from; with \
                 `= {zero}` it has this value",
                kind.word()
            )),
        ),
    };
    let declaration = format!("attr {name}: {} {}{default}", kind.word(), ty.word());
    error.fix(format!("write `{declaration}`"), declared.behind, default)
}
