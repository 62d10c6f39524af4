//! Sequences of elements, and the aggregates over them.

use crate::diagnostic::{Diagnostic, Edit, Fix, quoted};
use crate::diagram::{Around, Collection, Elements, Expr, ExprKind, Fold, FoldFunction, Type};
use crate::source::Span;
use crate::syntax::Part;
use crate::syntax::tree::{self, Ident};

use super::foreign_words;
use super::range::TAKES_INTS;
use super::scopes::{Binding, Local};
use super::sequence_names::{FOLDS, WHOLE_MESH, fold_names, sequences_of};
use super::typed::{to_real, typed};
use super::typing::{Place, Typing, with_field};
use super::vocabulary::{fields, is_function};
use super::words::{short, subject};

const COUNTED: &str = "`count(edges)` counts them all, `count(boundary(e) for e in edges)` those \
                       for which a condition holds";

/// True if an aggregate takes each element as it is, or one for each.
fn counts_each(body: &tree::Expr, variable: &Ident) -> bool {
    match &body.kind {
        tree::ExprKind::Name(name) => name.index.is_none() && name.ident.text == variable.text,
        tree::ExprKind::Int(1) => true,
        _ => false,
    }
}

/// The sequence of this name around an element.
fn around(base: Expr, word: &str) -> Result<Collection, Expr> {
    let around = match (base.ty, word) {
        (Type::Vertex, "halfedges") => Around::VertexHalfedges,
        (Type::Vertex, "edges") => Around::VertexEdges,
        (Type::Vertex, "faces") => Around::VertexFaces,
        (Type::Vertex, "neighbors") => Around::VertexNeighbors,
        (Type::Face, "halfedges") => Around::FaceHalfedges,
        (Type::Face, "vertices") => Around::FaceVertices,
        (Type::Face, "edges") => Around::FaceEdges,
        (Type::Face, "ears") => Around::FaceEars,
        (Type::Face, "patch") => Around::FacePatch,
        (Type::Edge, "vertices") => Around::EdgeVertices,
        (Type::Edge, "faces") => Around::EdgeFaces,
        _ => return Err(base),
    };
    Ok(Collection::Around(around, base))
}

/// True if an expression names a sequence of the whole mesh or around an element.
pub(super) fn is_sequence(expr: &tree::Expr) -> bool {
    let around = [Type::Vertex, Type::Edge, Type::Face];
    match &expr.kind {
        tree::ExprKind::Name(name) => WHOLE_MESH.iter().any(|(known, _)| *known == name.ident.text),
        tree::ExprKind::Field(_, field) => {
            let word = field.text.as_str();
            around.iter().any(|ty| sequences_of(*ty).contains(&word))
        }
        _ => false,
    }
}

impl Typing<'_> {
    /// The collection that a loop or an aggregate runs over.
    pub(super) fn sequence(&mut self, expr: &tree::Expr) -> Option<Collection> {
        match &expr.kind {
            tree::ExprKind::Name(name) if name.index.is_none() => {
                let word = name.ident.text.as_str();
                let found = WHOLE_MESH.into_iter().find(|(known, _)| *known == word);
                match found {
                    Some((_, of)) => self.whole_mesh(word, of, expr.span),
                    None => self.no_sequence(expr),
                }
            }
            tree::ExprKind::Field(base, field) => {
                let value = self.expression(base)?;
                self.declared.meet(value.ty, field);
                match around(value, &field.text) {
                    Ok(collection) => Some(collection),
                    Err(value) => {
                        let ty = value.ty;
                        let value = self.field((&**base, value), field, expr.span, true)?;
                        self.not_a_sequence(expr, value.ty, ty)
                    }
                }
            }
            tree::ExprKind::Broken => self.report.fail_silently(),
            _ => self.no_sequence(expr),
        }
    }

    /// All elements of one kind; allowed in scripts only.
    fn whole_mesh(&mut self, word: &str, of: Elements, span: Span) -> Option<Collection> {
        let message = match self.place {
            Place::Script => return Some(Collection::All(of)),
            Place::Rule(_) => format!(
                "an op cannot look at all `{word}` of the mesh, only at what is near its \
                 parameters"
            ),
            Place::Default(_) => format!("a default cannot look at the `{word}` of a mesh"),
        };
        self.report.reject(Diagnostic::error("whole-mesh", message, span))
    }

    /// Reports an expression that is not a sequence.
    fn no_sequence(&mut self, expr: &tree::Expr) -> Option<Collection> {
        let value = self.expression(expr)?;
        self.not_a_sequence(expr, value.ty, value.ty)
    }

    /// Reports an expression of type `ty` that is not a sequence, with the sequences of the type
    /// `of`, otherwise those of the mesh.
    fn not_a_sequence(&mut self, expr: &tree::Expr, ty: Type, of: Type) -> Option<Collection> {
        let message = format!("{} is {}, not a sequence", subject(expr), ty.a_word());
        let error = Diagnostic::error("not-a-sequence", message, expr.span);
        self.report.reject(match sequences_of(of) {
            [] if of == Type::Int => error.note(TAKES_INTS),
            [] => {
                let words = WHOLE_MESH.map(|(known, _)| known);
                error.note(format!("the sequences of the mesh are {}", quoted(words)))
            }
            words => error.note(format!("the sequences of {} are {}", of.a_word(), quoted(words))),
        })
    }

    /// `mean(x for e in edges where c)`
    pub(super) fn aggregate(&mut self, expr: &tree::Expr) -> Option<Expr> {
        let tree::ExprKind::Aggregate { function, body, variable, sequence, filter } = &expr.kind
        else {
            return None;
        };
        let fold = self.fold_function(function);
        let collection = self.sequence(sequence);
        self.scopes.enter();
        let element = collection.as_ref().map(Collection::element);
        let number = self.scopes.declare_in_head(variable, element);
        let filter = self.condition(filter.as_deref(), "`where`");
        let value = self.expression(body);
        self.scopes.leave();
        let (filter, fold, value) = (filter?, fold?, value?);
        if fold == FoldFunction::Count && counts_each(body, variable) {
            self.each_counted(expr, value.ty);
            return None;
        }
        let (ty, value) = self.fold_body(fold, function, body, value)?;
        let ty = match (fold, &collection) {
            (FoldFunction::ArgMin | FoldFunction::ArgMax, Some(of)) => of.element(),
            _ => ty,
        };
        let fold =
            Fold { function: fold, variable: number, collection: collection?, filter, body: value };
        Some(typed(ty, ExprKind::Fold(Box::new(fold)), expr.span))
    }

    /// `count(edges)`: the number of elements.
    pub(super) fn count(
        &mut self,
        function: &Ident,
        args: &[tree::Expr],
        span: Span,
    ) -> Option<Expr> {
        self.right_count(function, 1, args.len(), span)?;
        let [arg] = args else { return None };
        if let tree::ExprKind::Field(of, field) = &arg.kind
            && is_sequence(of)
        {
            self.of_each(function, of, field, arg.span);
            return None;
        }
        if function.text != "count"
            && let Some(element) = self.unknown_element(arg)
        {
            let (word, function) = (&element.text, &function.text);
            let all = match word.chars().next() {
                Some('v') => "vertices",
                Some('h') => "halfedges",
                Some('f') => "faces",
                _ => "edges",
            };
            let value = short(arg, 5).unwrap_or_else(|| "…".to_owned());
            let message = format!("`{word}` is not known here");
            let error = Diagnostic::error("unknown-name", message, element.span);
            return self.report.reject(error.note(format!(
                "a value for each element of a sequence is `{function}({value} for {word} in {all})`"
            )));
        }
        let collection = self.sequence(arg)?;
        if function.text != "count" {
            let all = short(arg, 3).unwrap_or_else(|| "…".to_owned());
            let message = format!(
                "`{0}` wants a value for each element: `{0}(… for x in {all})`",
                function.text
            );
            return self.report.reject(Diagnostic::error("type-mismatch", message, span));
        }
        self.scopes.enter();
        let variable = self.scopes.declare(Local {
            name: String::new(),
            span,
            ty: Some(collection.element()),
            binding: Binding::Head,
        });
        self.scopes.leave();
        let fold = Fold {
            function: FoldFunction::Count,
            variable,
            collection,
            filter: None,
            body: typed(Type::Bool, ExprKind::Bool(true), span),
        };
        Some(typed(Type::Int, ExprKind::Fold(Box::new(fold)), span))
    }

    /// The first name in a value that is not known and may be that of an element; none in a value
    /// that has names of its own.
    fn unknown_element<'t>(&self, value: &'t tree::Expr) -> Option<&'t Ident> {
        let is_known = |word: &str| {
            let is_drawn = match self.place {
                Place::Rule(names) => names.find(word).is_some(),
                Place::Default(_) | Place::Script => false,
            };
            is_drawn || self.scopes.find(word).is_some() || self.declared.is_called(word)
        };
        let (mut found, mut names_others) = (None, false);
        Part::Expr(value).each_within(|part| match part {
            Part::Expr(tree::Expr { kind: tree::ExprKind::Name(name), .. }) => {
                let is_letter = name.index.is_none() && name.ident.text.len() == 1;
                if found.is_none() && is_letter && !is_known(&name.ident.text) {
                    found = Some(&name.ident);
                }
            }
            Part::Expr(tree::Expr { kind: tree::ExprKind::Aggregate { .. }, .. })
            | Part::Block(_) => names_others = true,
            Part::Expr(_) => {}
        });
        found.filter(|_| !names_others)
    }

    /// Reports `mean(v.neighbors.position)`: an aggregate names the element.
    fn of_each(&mut self, function: &Ident, of: &tree::Expr, field: &Ident, span: Span) {
        let Some(element) = self.sequence(of).map(|collection| collection.element()) else {
            return;
        };
        let (function, field) = (&function.text, field.text.as_str());
        let message = format!("`{function}` wants a value for each element of a sequence");
        let error = Diagnostic::error("type-mismatch", message, span);
        let is_field = self.declared.attribute(element, field).is_some()
            || fields(element).iter().any(|known| known.name == field && known.ty.is_some());
        let value = match is_function(field) {
            _ if is_field => Some(format!("x.{field}")),
            true => Some(format!("{field}(x)")),
            false => None,
        };
        self.report.add(match (value, short(of, 3)) {
            (Some(value), Some(of)) => {
                let each = format!("{value} for x in {of}");
                error.fix(format!("write `{function}({each})`"), span, each)
            }
            _ => error.note(format!("it is `{function}(… for x in …)`")),
        });
    }

    fn fold_function(&mut self, function: &Ident) -> Option<FoldFunction> {
        let word = function.text.as_str();
        let found = FOLDS.iter().find(|(known, _)| *known == word);
        if let Some((_, fold)) = found {
            return Some(*fold);
        }
        let message = format!("there is no aggregate `{word}`");
        let error = Diagnostic::error("unknown-function", message, function.span);
        let here = foreign_words::function(word);
        let error = foreign_words::tell(error, (word, function.span), here, fold_names())
            .note(format!("the aggregates are {}", quoted(fold_names())));
        self.report.reject(error)
    }

    /// Reports `count(v for v in vertices where boundary(v))`, with the bool in place of the element.
    fn each_counted(&mut self, expr: &tree::Expr, ty: Type) {
        let tree::ExprKind::Aggregate { body, variable, sequence, filter, .. } = &expr.kind else {
            return;
        };
        let message = format!(
            "`count` wants a bool for each element, but {} is {}",
            subject(body),
            ty.a_word()
        );
        let mut error = Diagnostic::error("type-mismatch", message, body.span).note(COUNTED);
        let Some(all) = short(sequence, 3) else {
            self.report.add(error);
            return;
        };
        let edit = |span, text: String| Edit { span, text };
        let Span { start, .. } = body.span;
        let (title, edits) = match filter {
            None => {
                let whole = body.span.to(sequence.span);
                (format!("write `count({all})`"), vec![edit(whole, all)])
            }
            Some(filter) => {
                let over = format!(" for {} in {all}", variable.text);
                let before = Span { start, end: filter.span.start, ..filter.span };
                let edits =
                    vec![edit(before, String::new()), edit(filter.span.after(), over.clone())];
                let moved = "write the condition in place of the element";
                (format!("{moved}: `count(…{over})`"), edits)
            }
        };
        error.fixes.push(Fix { title, edits });
        self.report.add(error);
    }

    /// The type of an aggregate, and its body converted to the type that it aggregates.
    fn fold_body(
        &mut self,
        fold: FoldFunction,
        function: &Ident,
        written: &tree::Expr,
        value: Expr,
    ) -> Option<(Type, Expr)> {
        let whose = format!("`{}`", function.text);
        let wants = match (fold, value.ty) {
            (FoldFunction::Mean, Type::Int | Type::Real) => {
                return Some((Type::Real, to_real(value)));
            }
            (FoldFunction::Mean | FoldFunction::Sum, ty) if ty.is_vector() || ty.is_matrix() => {
                return Some((value.ty, value));
            }
            (FoldFunction::Min | FoldFunction::Max, ty) if ty.is_vector() => {
                return Some((value.ty, value));
            }
            (
                FoldFunction::Sum
                | FoldFunction::Min
                | FoldFunction::Max
                | FoldFunction::ArgMin
                | FoldFunction::ArgMax,
                Type::Int | Type::Real,
            ) => {
                return Some((value.ty, value));
            }
            (FoldFunction::Count, ty) if ty.is_element() => {
                let message = format!(
                    "`count` wants a bool for each element, but {} is {}",
                    subject(written),
                    ty.a_word()
                );
                let error = Diagnostic::error("type-mismatch", message, written.span);
                return self.report.reject(error.note(COUNTED));
            }
            (FoldFunction::Count | FoldFunction::Any | FoldFunction::All, _) => {
                let ty = match fold {
                    FoldFunction::Count => Type::Int,
                    _ => Type::Bool,
                };
                let value = self.convert(written, value, Type::Bool, &whose)?;
                return Some((ty, value));
            }
            (FoldFunction::Mean | FoldFunction::Sum, _) => "numbers, vectors or matrices",
            (FoldFunction::Min | FoldFunction::Max, _) => "numbers or vectors",
            (FoldFunction::ArgMin | FoldFunction::ArgMax, _) => "numbers",
        };
        let message =
            format!("{whose} wants {wants}, but {} is {}", subject(written), value.ty.a_word());
        let error = Diagnostic::error("type-mismatch", message, written.span);
        self.report.reject(match (fold, value.ty) {
            (FoldFunction::Mean | FoldFunction::Sum, Type::Vertex) => {
                with_field(error, written, "position")
            }
            _ => error,
        })
    }
}
