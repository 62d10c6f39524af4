//! Fields: the pointers and attributes of an element, the components of a vector.

use crate::diagnostic::{Diagnostic, Edit, Fix, quoted};
use crate::diagram::{Expr, ExprKind, Type, Wanted, overloads};
use crate::source::Span;
use crate::syntax::tree::{self, Ident};

use super::condition::declaration;
use super::declared::private;
use super::fields::{Field, fields_of, is_taken};
use super::foreign_words::{self, Here};
use super::neighbor::near;
use super::sequence_names::sequences_of;
use super::suggestion::closest;
use super::typed::typed;
use super::typing::Typing;
use super::words::short;

/// The function of elements of type `ty` that a word names, in this language or another.
fn function_of(ty: Type, word: &str) -> Option<&str> {
    let takes =
        |function: &str| overloads(function).iter().any(|way| way.wanted == [Wanted::Is(ty)]);
    match foreign_words::function(word) {
        _ if takes(word) => Some(word),
        _ if foreign_words::is_degree(ty, word) => Some("degree"),
        Some(Here::Written(ours)) if takes(ours) => Some(ours),
        _ => None,
    }
}

/// Adds the fix that writes `x.length` as `length(x)`.
fn written_as_call(
    error: Diagnostic,
    function: &str,
    written: &tree::Expr,
    field: Span,
) -> Diagnostic {
    let value = written.span;
    let title = match short(written, 3) {
        Some(text) => format!("write `{function}({text})`"),
        None => format!("write `{function}(…)`"),
    };
    let edit = |span: Span, text: String| Edit { span, text };
    let before = Span { end: value.start, ..value };
    let edits =
        vec![edit(before, format!("{function}(")), edit(value.after().to(field), ")".to_owned())];
    let mut error = error.note(format!("`{function}` is a function"));
    error.fixes.push(Fix { title, edits });
    error
}

impl Typing<'_> {
    /// `x.field`; `of_sequences` is true where a sequence is expected.
    pub(super) fn field(
        &mut self,
        (written, base): (&tree::Expr, Expr),
        field: &Ident,
        span: Span,
        of_sequences: bool,
    ) -> Option<Expr> {
        let word = field.text.as_str();
        self.declared.meet(base.ty, field);
        let found = fields_of(base.ty).iter().find(|(known, _)| *known == word);
        let found = match self.declared.attribute(base.ty, word) {
            Some((access, ty)) => Some(Field::Attribute(access, ty)),
            None => found.map(|(_, found)| *found),
        };
        let Some(found) = found else {
            if sequences_of(base.ty).contains(&word) {
                let message = format!(
                    "`{word}` of {} is a sequence; it can stand after `in` or in `count(…)`",
                    base.ty.a_word()
                );
                self.report.add(Diagnostic::error("not-a-value", message, span));
            } else {
                self.unknown_field(written, base.ty, field, of_sequences);
            }
            return None;
        };
        let base = Box::new(base);
        Some(match found {
            Field::Pointer(pointer, ty) => typed(ty, ExprKind::Follow(pointer, base), span),
            Field::Attribute(access, ty) => typed(ty, ExprKind::Read(access, base), span),
            Field::Part(from, ty) => typed(ty, ExprKind::Component(from, base), span),
        })
    }

    /// Reports an unknown field, with the fields that exist; `of_sequences` is true where a
    /// sequence is expected.
    pub(super) fn unknown_field(
        &mut self,
        written: &tree::Expr,
        ty: Type,
        field: &Ident,
        of_sequences: bool,
    ) {
        if self.declared.has_attribute(&field.text) {
            // The declaration has been rejected already.
            self.report.fail();
            return;
        }
        if let Some(declared) = self.declared.hidden_attribute(ty, &field.text) {
            self.report.add(private("unknown-attribute", field, declared));
            return;
        }
        let known: Vec<&str> = fields_of(ty)
            .iter()
            .map(|(known, _)| *known)
            .chain(self.declared.attributes_of(ty))
            .chain(sequences_of(ty).iter().copied())
            .collect();
        let message = format!("{} has no field `{}`", ty.a_word(), field.text);
        let error = Diagnostic::error("unknown-field", message, field.span);
        let this = format!("this is {}", ty.a_word());
        if !of_sequences && let Some(function) = function_of(ty, &field.text) {
            let error = error.label(written.span, this);
            self.report.add(written_as_call(error, function, written, field.span));
            return;
        }
        let here = foreign_words::field(ty, &field.text);
        let word = (field.text.as_str(), field.span);
        // A suggestion of the other sort would be an error again.
        let fits = |known: &&str| sequences_of(ty).contains(known) == of_sequences;
        let ours = here.filter(|here| match here {
            Here::Written(ours) => fits(ours),
            Here::Said(_) => true,
        });
        let error = match (here, ours) {
            (Some(Here::Written(ours)), None) => error.note(format!("it is written `{ours}`")),
            _ => error,
        };
        let error = foreign_words::tell(error, word, ours, known.iter().copied().filter(fits));
        let error = error.label(written.span, this);
        let of_halfedge = ty.is_element() && is_taken(Type::Halfedge, &field.text);
        let belongs = match field.text == "position" {
            true => near(written, ty, Type::Vec3),
            false => self.declared.belongs(Some(written), ty, &field.text),
        };
        let is_meant = here.is_some() || closest(&field.text, known.iter().copied()).is_some();
        self.report.add(match known.as_slice() {
            [] => error,
            _ if let Some(note) = belongs.filter(|_| ty.is_element()) => error.note(note),
            _ if of_halfedge && here.is_none() => {
                error.note(format!("a halfedge has it: read `.halfedge.{0}`", field.text))
            }
            known => {
                let error = error.note(format!("{} has {}", ty.a_word(), quoted(known)));
                error.when(ty.is_element() && !is_meant, |error| {
                    error.note(declaration(
                        &field.text,
                        ty,
                        self.wanted(written.span.to(field.span)),
                    ))
                })
            }
        });
    }
}
