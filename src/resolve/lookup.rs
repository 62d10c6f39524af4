//! What a name in an expression means.

use std::f64::consts::PI;

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Kind, NameId, Type};
use crate::source::Span;
use crate::syntax::tree;

use super::names::Names;
use super::report::not_yet;
use super::sequence::WHOLE_MESH;
use super::suggestion::suggest;
use super::typing::{Place, Typing, typed};

/// The constants of the language.
const CONSTANTS: [(&str, f64); 2] = [("pi", PI), ("infinity", f64::INFINITY)];

/// The type of the element that a name stands for.
pub(super) fn element_type(kind: Kind) -> Option<Type> {
    match kind {
        Kind::Vertex => Some(Type::Vertex),
        Kind::Halfedge => Some(Type::Halfedge),
        Kind::Edge => Some(Type::Edge),
        Kind::Face => Some(Type::Face),
        Kind::Path | Kind::Fan => None,
    }
}

impl Typing<'_> {
    /// A name: a variable, a drawn element, a parameter, a constant; the innermost first.
    pub(super) fn name(&mut self, name: &tree::Name) -> Option<Expr> {
        if name.index.is_some() {
            self.report.add(not_yet(
                "families are not supported yet, and a subscript draws one",
                name.span,
            ));
            return None;
        }
        let (word, span) = (name.ident.text.as_str(), name.span);
        let local = self.scopes.find(word).map(|(number, l)| (number, l.ty));
        if let Place::Rule(names) = self.place
            && let Some(id) = names.find(word)
            && local.is_none_or(|(number, _)| (number as usize) < names.params())
        {
            return self.drawn(names, id, span);
        }
        if let Some((number, ty)) = local {
            let Some(ty) = ty else {
                self.report.fail();
                return None;
            };
            return Some(typed(ty, ExprKind::Local(number), span));
        }
        if let Some((_, value)) = CONSTANTS.iter().find(|(known, _)| *known == word) {
            return Some(typed(Type::Real, ExprKind::Real(*value), span));
        }
        self.unknown_name(word, span);
        None
    }

    /// An element of the rule, as it was before the rewrite.
    fn drawn(&mut self, names: &Names, id: NameId, span: Span) -> Option<Expr> {
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
        } else if let Some(ty) = element_type(name.kind) {
            return Some(typed(ty, ExprKind::Element(id), span));
        } else {
            let message = format!(
                "`{word}` is {}; an expression can name vertices, halfedges, edges and faces",
                name.kind.a_word()
            );
            Diagnostic::error("not-an-element", message, span).label(name.span, "it is drawn here")
        };
        self.report.add(error);
        None
    }

    fn unknown_name(&mut self, word: &str, span: Span) {
        if WHOLE_MESH.iter().any(|(known, _)| *known == word) {
            let message =
                format!("`{word}` is a sequence; it can stand after `in` or in `count({word})`");
            self.report
                .add(Diagnostic::error("not-a-value", message, span));
            return;
        }
        if self.declared.is_called(word) {
            let message = format!("`{word}` is no value; it is called: `{word}(…)`");
            self.report
                .add(Diagnostic::error("not-a-value", message, span));
            return;
        }
        let error = Diagnostic::error("unknown-name", format!("`{word}` is not known here"), span);
        let drawn = match self.place {
            Place::Rule(names) => names.words().collect(),
            Place::Default | Place::Script => Vec::new(),
        };
        let candidates = self
            .scopes
            .names()
            .chain(drawn)
            .chain(CONSTANTS.map(|(known, _)| known));
        let error = suggest(error, word, span, candidates);
        self.report.add(error);
    }
}
