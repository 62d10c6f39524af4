//! The attributes that the files of a program declare.

use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Attribute, Type};
use crate::syntax::tree::{self, Item};

use super::declared::Declared;
use super::report::Report;
use super::typing::{Place, Typing};
use super::unit::Unit;

/// The attributes of all files with their defaults, by number. An invalid one, as one whose default
/// has an error, keeps its index, but no name refers to it.
pub(super) fn attributes(
    units: &[Unit],
    declared: &mut [Declared],
    diagnostics: &mut Vec<Diagnostic>,
) -> Arc<[Attribute]> {
    let mut attributes = Vec::new();
    for (number, unit) in units.iter().enumerate() {
        for item in &unit.tree.items {
            let Item::Attr(attr) = item else { continue };
            let resolved = attribute(attr, &declared[number], diagnostics);
            if !resolved.lacks_default && resolved.default.is_none() {
                declared.iter_mut().for_each(|file| file.lose_attribute(&attr.name));
            }
            attributes.push(resolved);
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
    let (default, inherits) = default(attr, head.map(|head| head.element), &mut report);
    let default = default.and_then(|default| {
        let mut typing = Typing::new(Place::Default("an attribute"), declared, &[], &mut report);
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
        behind: attr.ty.span.after(),
        default: default.filter(|_| ty.is_some()),
        lacks_default: attr.default.is_none(),
        inherits,
        private: attr.private,
    }
}

/// The word before a default with which new elements inherit: `= inherited(0)`.
const INHERITED: &str = "inherited";

/// The default of an attribute, and whether new elements rather inherit.
fn default<'a>(
    attr: &'a tree::Attr,
    element: Option<Type>,
    report: &mut Report,
) -> (Option<&'a tree::Expr>, bool) {
    let Some(whole) = &attr.default else { return (None, false) };
    let (function, args) = match &whole.kind {
        tree::ExprKind::Call { function, args } if function.text == INHERITED => (function, args),
        _ => return (Some(whole), false),
    };
    if element == Some(Type::Vertex) {
        let message = "a new vertex comes from no other, so it inherits nothing";
        let error = Diagnostic::error("not-inherited", message, function.span);
        report.add(error.note("write the default alone; operations set other values in `after`"));
    }
    let [default] = args.as_slice() else {
        let message = format!("`{INHERITED}` wants one value, for what inherits nothing");
        report.add(Diagnostic::error("wrong-count", message, whole.span));
        return (None, false);
    };
    (Some(default), true)
}
