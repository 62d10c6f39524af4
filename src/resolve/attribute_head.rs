//! The declaration of an attribute without its default.

use crate::diagnostic::Diagnostic;
use crate::diagram::Type;
use crate::source::Span;
use crate::syntax::tree;

use super::fields::is_taken;
use super::report::Report;
use super::type_name::type_among;

/// The declaration of an attribute without its default.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) name: String,
    pub(super) span: Span,
    /// The type of the elements that have it.
    pub(super) element: Type,
    /// The type of its values.
    pub(super) ty: Type,
    /// True if it is visible in its own file only.
    pub(super) private: bool,
    /// Its number among those of the whole program.
    pub(super) number: u32,
}

impl Head {
    /// True if `other` has the same name and belongs to the same kind of element.
    pub(super) fn is_named_as(&self, other: &Self) -> bool {
        self.element == other.element && self.name == other.name
    }
}

/// Reads a declaration. `None` means that an error has been reported.
pub(super) fn head(
    attr: &tree::Attr,
    number: u32,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Head> {
    let mut report = Report::default();
    let element = type_among(&attr.kind, |ty| ty.is_element(), &mut report);
    let ty = type_among(&attr.ty, |ty| ty.zero().is_some(), &mut report);
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
                element.a_word()
            );
            report.add(Diagnostic::error("attribute-type", message, attr.kind.span));
        } else if is_taken(element, &attr.name.text) {
            let message = format!(
                "{} has a field `{}` already; the attribute needs another name",
                element.a_word(),
                attr.name.text
            );
            report.add(Diagnostic::error("duplicate-name", message, attr.name.span));
        }
    }
    if let Some(ty) = ty.filter(|ty| ty.zero().is_none()) {
        let message = format!(
            "an attribute holds a bool, a number, a vector or a matrix, not {}",
            ty.a_word()
        );
        let mut error = Diagnostic::error("attribute-type", message, attr.ty.span);
        if ty.is_element() {
            error = error.note(
                "an element can be marked instead, `attr is_parent: halfedge bool = false` at the \
                 halfedge that leads to it, or carry a number of its own, `attr id: vertex int = 0`",
            );
        }
        report.add(error);
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
