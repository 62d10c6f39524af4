//! Attributes that the files of a program declare.

use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Attribute, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Item};

use super::declared::Declared;
use super::field::is_taken;
use super::file::Unit;
use super::parameter::type_named;
use super::report::Report;
use super::scopes::Scopes;
use super::typing::{Place, Typing};
use super::words::a_type;

/// The declaration of an attribute but for its default.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) span: Span,
    /// The type of the elements that have it.
    pub(super) element: Type,
    /// The type of its values.
    pub(super) ty: Type,
    /// True if only its file sees it.
    pub(super) private: bool,
    /// Its number among those of the whole program.
    pub(super) number: u32,
}

impl Head {
    /// True if another attribute of the same elements has the name.
    pub(super) fn is_named_as(&self, other: &Self) -> bool {
        self.element == other.element && self.name == other.name
    }
}

/// Reads a declaration; `None` if a diagnostic says what is wrong.
pub(super) fn head(
    attr: &tree::Attr,
    number: u32,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Head> {
    let mut report = Report::default();
    let (element, ty) = (type_named(&attr.kind, &mut report), type_named(&attr.ty, &mut report));
    if let (Some(element), Some(value)) = (element, ty)
        && !element.is_element()
        && value.is_element()
    {
        let message =
            format!("the kind of element stands first: `{} {}`", value.word(), element.word());
        let both = attr.kind.span.to(attr.ty.span);
        let ours = format!("{} {}", value.word(), element.word());
        let error = Diagnostic::error("attribute-type", message, both);
        diagnostics.push(error.fix(format!("write `{ours}`"), both, ours));
        return None;
    }
    if let Some(element) = element {
        if !element.is_element() {
            let message = format!(
                "an attribute belongs to vertices, halfedges, edges or faces, not to {}",
                a_type(element)
            );
            report.add(Diagnostic::error("attribute-type", message, attr.kind.span));
        } else if is_taken(element, &attr.name.text) {
            let message = format!(
                "{} has a field `{}` already; the attribute needs another name",
                a_type(element),
                attr.name.text
            );
            report.add(Diagnostic::error("duplicate-name", message, attr.name.span));
        }
    }
    if let Some(ty) = ty.filter(|ty| ty.is_element() || *ty == Type::Text) {
        let message = format!(
            "an attribute holds a bool, a number, a vector or a matrix, not {}",
            a_type(ty)
        );
        report.add(Diagnostic::error("attribute-type", message, attr.ty.span));
    }
    let failed = report.failed();
    diagnostics.extend(report.into_diagnostics());
    let (element, ty) = (element?, ty?);
    (!failed).then(|| Head {
        name: attr.name.text.clone(),
        span: attr.name.span,
        element,
        ty,
        private: attr.private,
        number,
    })
}

/// The attributes of all files with their defaults, by number. One that could not be
/// understood keeps its place; nobody names it.
pub(super) fn attributes(
    units: &[Unit],
    declared: &[Declared],
    diagnostics: &mut Vec<Diagnostic>,
) -> Arc<[Attribute]> {
    let mut attributes = Vec::new();
    for (unit, declared) in units.iter().zip(declared) {
        for item in &unit.tree.items {
            if let Item::Attr(attr) = item {
                attributes.push(attribute(attr, declared, diagnostics));
            }
        }
    }
    attributes.into()
}

fn attribute(
    attr: &tree::Attr,
    declared: &Declared,
    diagnostics: &mut Vec<Diagnostic>,
) -> Attribute {
    let head = declared.attribute_at(attr.name.span);
    let ty = head.map(|head| head.ty);
    let mut report = Report::default();
    let default = attr.default.as_ref().and_then(|default| {
        let mut scopes = Scopes::default();
        scopes.enter();
        let mut typing = Typing {
            place: Place::Default,
            declared,
            scopes,
            report: &mut report,
            ops: &[],
            may_change: false,
        };
        match ty {
            Some(ty) => typing.whole_as(default, ty, &format!("`{}`", attr.name.text)),
            None => typing.whole(default),
        }
    });
    diagnostics.extend(report.into_diagnostics());
    Attribute {
        name: attr.name.text.clone(),
        span: attr.name.span,
        docs: attr.docs.clone(),
        element: head.map_or(Type::Vertex, |head| head.element),
        ty: ty.unwrap_or(Type::Real),
        default: default.filter(|_| ty.is_some()),
        private: attr.private,
    }
}
