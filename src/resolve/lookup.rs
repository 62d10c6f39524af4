//! Lookup of names in expressions.

use std::f64::consts::PI;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, NameId, Role, Type};
use crate::source::Span;
use crate::syntax::tree;

use super::family::WIDEST;
use super::foreign_words;
use super::names::Names;
use super::sequence_names::WHOLE_MESH;
use super::typed::typed;
use super::typing::{Place, Typing};

/// The constants of the language.
pub(super) const CONSTANTS: [(&str, f64); 2] = [("pi", PI), ("infinity", f64::INFINITY)];

impl Typing<'_> {
    /// A name: a variable, a drawn element, a parameter or a constant, the innermost first.
    pub(super) fn name(&mut self, name: &tree::Name) -> Option<Expr> {
        if let Some(index) = &name.index {
            return self.member(name, index);
        }
        let (word, span) = (name.ident.text.as_str(), name.span);
        let local = self.scopes.find(word).map(|(number, l)| (number, l.ty));
        if let Place::Rule(names) = self.place
            && let Some(id) = names.find(word)
            && local.is_none_or(|(number, _)| (number as usize) < names.params())
        {
            self.subscript(names, id, name)?;
            return self.drawn(names, id, span, ExprKind::Element(id));
        }
        if let Some((number, ty)) = local {
            let Some(ty) = ty else { return self.report.fail_silently() };
            return Some(typed(ty, ExprKind::Local(number), span));
        }
        if let Some((_, value)) = CONSTANTS.iter().find(|(known, _)| *known == word) {
            return Some(typed(Type::Real, ExprKind::Real(*value), span));
        }
        self.unknown_name(word, span);
        None
    }

    /// `v[i+1]`: an element of a family, as it was before the rewrite.
    fn member(&mut self, name: &tree::Name, index: &tree::Index) -> Option<Expr> {
        let (word, span) = (name.ident.text.as_str(), name.span);
        let Place::Rule(names) = self.place else {
            let message = "subscripts stand in the drawings of an op, and in what it asks and sets";
            return self.report.reject(Diagnostic::error("wrong-subscript", message, index.span).note(
                "a component is `p.x`; an element is found by a loop, or by `argmin(length(e) for e in edges)`",
            ));
        };
        let Some(id) = names.find(word) else {
            self.unknown_name(word, span);
            return None;
        };
        self.subscript(names, id, name)?;
        let shift = i32::try_from(index.offset).unwrap_or(0);
        self.drawn(names, id, span, ExprKind::Member(id, shift))
    }

    /// Checks that a name has the subscript that it should have.
    pub(super) fn subscript(&mut self, names: &Names, id: NameId, name: &tree::Name) -> Option<()> {
        let (word, span) = (&name.ident.text, name.span);
        let drawn = names.get(id);
        let error = match (&name.index, drawn.role == Role::Family) {
            (None, false) => return Some(()),
            (None, true) => {
                let message = format!("`{word}` is a family: it needs a subscript here");
                Diagnostic::error("two-forms", message, span)
                    .label(drawn.span, "a family here")
                    .note(format!("write `{word}[i]`: what is said then holds for all of it"))
                    .note(
                        "one value of all of a family is that of an orbit: \
                         `mean(v.position for v in f.vertices)`",
                    )
            }
            (Some(_), false) => {
                let message = format!("`{word}` has a subscript here, but not where it is drawn");
                Diagnostic::error("two-forms", message, span)
                    .label(drawn.span, "a single name here")
            }
            (Some(index), true) => {
                let variable = index.variable.as_ref();
                let variable = variable.map(|variable| variable.text.as_str());
                if variable.is_some() && variable == names.letter() && index.offset.abs() <= WIDEST
                {
                    return Some(());
                }
                let letter = names.letter().unwrap_or("i");
                let message = format!(
                    "a subscript here is the index `{letter}` plus a constant, {WIDEST} at most"
                );
                Diagnostic::error("wrong-subscript", message, index.span)
            }
        };
        self.report.reject(error)
    }

    /// An element of the rule, as it was before the rewrite.
    fn drawn(&mut self, names: &Names, id: NameId, span: Span, meant: ExprKind) -> Option<Expr> {
        let name = names.get(id);
        let word = &name.text;
        let error = if let Some(listed) = names.created(id) {
            let message =
                format!("`{word}` is new, and here the mesh is read as it was before the rewrite");
            Diagnostic::error("reads-new", message, span).label(listed, "it is created here")
        } else if !names.readable(id) {
            let message = format!(
                "`{word}` does not stand in `before`, and here the mesh is read as it was \
                 before the rewrite"
            );
            Diagnostic::error("reads-new", message, span).label(name.span, "it stands only here")
        } else if let Some(ty) = name.kind.element_type() {
            return Some(typed(ty, meant, span));
        } else {
            let message = format!(
                "`{word}` is {}; an expression can name vertices, halfedges, edges and faces",
                name.kind.a_word()
            );
            Diagnostic::error("not-an-element", message, span).label(name.span, "it is drawn here")
        };
        self.report.reject(error)
    }

    /// Reports an unknown name, and what may have been meant.
    pub(super) fn unknown_name(&mut self, word: &str, span: Span) {
        if WHOLE_MESH.iter().any(|(known, _)| *known == word) {
            let message = format!(
                "`{word}` is a sequence; it can stand after `in`, as in `for x in {word}` and `sum(… for x in {word})`, or in `count({word})`"
            );
            self.report.add(Diagnostic::error("not-a-value", message, span));
            return;
        }
        if self.declared.is_called(word) {
            self.report.add(not_called(word, span));
            return;
        }
        let error = Diagnostic::error("unknown-name", format!("`{word}` is not known here"), span);
        let drawn = match self.place {
            Place::Rule(names) => names.words().collect(),
            Place::Default(_) | Place::Script => Vec::new(),
        };
        let sequences = WHOLE_MESH.iter().map(|(known, _)| *known);
        let constants = CONSTANTS.map(|(known, _)| known);
        let candidates = self.scopes.names().chain(drawn).chain(constants).chain(sequences);
        let here = foreign_words::name(word);
        let error = foreign_words::tell(error, (word, span), here, candidates);
        let is_clear = !error.fixes.is_empty();
        self.report.add(error);
        // An error with a fix is reported at every occurrence, any other only once.
        if !is_clear {
            self.report.suppress(word);
        }
    }
}

/// The error for the name of a function or an op as a value.
pub(super) fn not_called(word: &str, span: Span) -> Diagnostic {
    let message = format!("`{word}` is not a value; it is called: `{word}(…)`");
    Diagnostic::error("not-a-value", message, span)
}
