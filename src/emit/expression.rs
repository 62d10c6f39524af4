//! Translation of typed expressions to terms.

use super::NotEmitted;
use super::matrix::{is_wide, negated, operated, type_of_call};
use super::names::Names;
use super::routine::Statement;
use super::term::{Around, Fold, Function, Operation, Parameter, Term};
use crate::diagram::{
    Access, Binary, Builtin, Collection, Expr, ExprKind, Param, Rule, Type, Unary,
};
use crate::lower::{Hoisted, hoist};

/// The parameters of an operation, with their defaults.
pub(super) fn parameters(
    params: &[Param],
    names: &mut Names,
) -> Result<Vec<Parameter>, NotEmitted> {
    let words = names.params().to_vec();
    let parameter = |(param, name): (&Param, String)| {
        let default = param.default.as_ref();
        let default = default.map(|value| Expressions { names }.term(value));
        Ok(Parameter { default: default.transpose()?, ..Parameter::new(name, param.ty) })
    };
    params.iter().zip(words).map(parameter).collect()
}

/// Translates expressions.
pub(super) struct Expressions<'n> {
    pub names: &'n mut Names,
}

impl Expressions<'_> {
    /// The term of an expression.
    pub fn term(&mut self, expr: &Expr) -> Result<Term, NotEmitted> {
        Ok(match &expr.kind {
            ExprKind::Bool(value) => Term::Bool(*value),
            ExprKind::Int(value) => Term::Int(*value),
            ExprKind::Real(value) => Term::Real(*value),
            ExprKind::Text(_) => return Err(NotEmitted::new("a text", expr.span)),
            ExprKind::Invoke(number, args) => {
                let what = "a function that does more than compute a value";
                let name = self.names.call(*number);
                let name = name.ok_or_else(|| NotEmitted::new(what, expr.span))?;
                let args = args.iter().map(|arg| self.term(arg));
                Term::Invoke(name, args.collect::<Result<_, _>>()?)
            }
            ExprKind::Try(..) => {
                return Err(NotEmitted::new("an op that is only asked", expr.span));
            }
            ExprKind::Let(..) => {
                return Err(NotEmitted::new("a block within a value", expr.span));
            }
            ExprKind::Member(..) => {
                return Err(NotEmitted::new("a name with an index", expr.span));
            }
            ExprKind::Read(Access::Declared(number), base) => {
                let what = "an attribute in a function";
                let attribute = self.names.attribute(*number);
                let attribute = attribute.ok_or_else(|| NotEmitted::new(what, expr.span))?;
                Term::Attribute(attribute, Box::new(self.term(base)?))
            }
            ExprKind::Element(name) => self.names.term(*name),
            ExprKind::Local(number) => Term::name(self.names.local(*number)),
            ExprKind::Follow(pointer, base) => self.term(base)?.follow(*pointer),
            ExprKind::Read(Access::Position, base) => Term::Position(Box::new(self.term(base)?)),
            ExprKind::Component(part, whole) => self.component(*part, whole, expr.ty)?,
            ExprKind::Vector(parts) => self.made(expr.ty, parts)?,
            ExprKind::Unary(Unary::NegateVector, operand) if is_wide(expr.ty) => {
                negated(expr.ty, self.term(operand)?)
            }
            ExprKind::Unary(Unary::ToReal, operand) => match &operand.kind {
                // Exact: an integer literal that is used as a real.
                ExprKind::Int(value) => Term::Real(*value as f64),
                ExprKind::Unary(Unary::NegateInt, inner) => match inner.kind {
                    ExprKind::Int(value) => Term::Real(-(value as f64)),
                    _ => Term::Unary(Unary::ToReal, Box::new(self.term(operand)?)),
                },
                _ => Term::Unary(Unary::ToReal, Box::new(self.term(operand)?)),
            },
            ExprKind::Unary(operator, operand) => {
                Term::Unary(*operator, Box::new(self.term(operand)?))
            }
            ExprKind::Binary(operator, left, right) => {
                let sides = [self.term(left)?, self.term(right)?];
                match is_wide(left.ty) {
                    true => operated(*operator, left.ty, sides),
                    false => {
                        let [left, right] = sides.map(Box::new);
                        Term::Binary(*operator, left, right)
                    }
                }
            }
            ExprKind::Call(Builtin::IsFinite, args)
                if args.len() == 1 && args[0].ty == Type::Vec3 =>
            {
                Term::Call(Function::IsFinite, vec![self.term(&args[0])?])
            }
            ExprKind::Call(builtin, _) if builtin.is_random() => {
                return Err(NotEmitted::new("a random number", expr.span));
            }
            ExprKind::Call(builtin, args) => {
                let function = match type_of_call(*builtin, args, expr.ty) {
                    Some(ty) => Function::Of(Operation::Builtin(*builtin), ty),
                    None => Function::Builtin(*builtin),
                };
                let args = args.iter().map(|arg| self.term(arg));
                Term::Call(function, args.collect::<Result<_, _>>()?)
            }
            ExprKind::If(condition, then, otherwise) => {
                let condition = self.term(condition)?;
                condition.then(self.term(then)?, self.term(otherwise)?)
            }
            ExprKind::Fold(fold) => {
                let (around, element) = around(&fold.collection).ok_or_else(|| {
                    NotEmitted::new(collection_words(&fold.collection), expr.span)
                })?;
                let element = self.term(element)?;
                let ty = fold.collection.element();
                let name = self.names.declare(fold.variable, ty);
                let filter = fold.filter.as_ref().map(|filter| self.term(filter));
                Term::Fold(Box::new(Fold {
                    function: fold.function,
                    ty: expr.ty,
                    variable: Parameter::new(name, ty),
                    around,
                    element,
                    filter: filter.transpose()?,
                    body: self.term(&fold.body)?,
                    body_type: fold.body.ty,
                }))
            }
        })
    }

    /// The expression with names for the parts that have the same value each time; `body` computes
    /// these values.
    pub fn once(
        &mut self,
        expr: &Expr,
        repeated: bool,
        rule: Option<&Rule>,
        body: &mut Vec<Statement>,
    ) -> Result<Expr, NotEmitted> {
        let Hoisted { parts, rest } = hoist(expr, repeated, rule, false);
        for (number, part) in &parts {
            let value = self.term(part)?;
            let name = self.names.bind(*number, wanted(part));
            body.push(Statement::Bind { ty: part.ty, name, value, is_list: false });
        }
        Ok(rest)
    }
}

fn wanted(part: &Expr) -> &'static str {
    match part.kind {
        ExprKind::Call(Builtin::CentroidFace, _) => "centroid",
        ExprKind::Call(Builtin::NormalFace | Builtin::NormalVertex, _) => "normal",
        ExprKind::Call(Builtin::Area, _) => "area",
        ExprKind::Call(Builtin::DegreeVertex | Builtin::DegreeFace, _) => "degree",
        _ => "part",
    }
}

/// The element that a collection lies around, and the kind of walk; `None` for other collections.
pub(super) fn around(collection: &Collection) -> Option<(Around, &Expr)> {
    Some(match collection {
        Collection::VertexHalfedges(v) => (Around::VertexHalfedges, v),
        Collection::VertexEdges(v) => (Around::VertexEdges, v),
        Collection::VertexFaces(v) => (Around::VertexFaces, v),
        Collection::VertexNeighbors(v) => (Around::VertexNeighbors, v),
        Collection::FaceHalfedges(f) => (Around::FaceHalfedges, f),
        Collection::FaceVertices(f) => (Around::FaceVertices, f),
        Collection::FaceEdges(f) => (Around::FaceEdges, f),
        Collection::EdgeVertices(e) => (Around::EdgeVertices, e),
        Collection::EdgeFaces(e) => (Around::EdgeFaces, e),
        Collection::Vertices
        | Collection::Halfedges
        | Collection::Edges
        | Collection::Faces
        | Collection::Holes
        | Collection::FaceEars(_)
        | Collection::FacePatch(_) => return None,
    })
}

/// A collection for which there is no [`Around`], in words.
pub(super) fn collection_words(collection: &Collection) -> &'static str {
    match collection {
        Collection::FaceEars(_) => "`ears` of a face",
        Collection::FacePatch(_) => "the `patch` of a face",
        _ => "a sequence of the whole mesh",
    }
}

/// The greatest size of a number in a value that is finite by its form. The positions of a mesh are
/// taken to be no larger.
const ORDINARY: f64 = 1e50;

/// True if a value is finite for all positions of ordinary size: sums, differences, products, means
/// and mixtures, and quotients by a literal that is not zero.
pub(super) fn is_surely_finite(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Int(_) | ExprKind::Read(Access::Position, _) => true,
        ExprKind::Real(value) => value.abs() <= ORDINARY,
        ExprKind::Component(_, of) | ExprKind::Unary(_, of) => is_surely_finite(of),
        ExprKind::Vector(parts) => parts.iter().all(is_surely_finite),
        ExprKind::Binary(operator, left, right) => match operator {
            Binary::AddReal
            | Binary::SubtractReal
            | Binary::MultiplyReal
            | Binary::AddVector
            | Binary::SubtractVector
            | Binary::MultiplyVector
            | Binary::ScaleVector => is_surely_finite(left) && is_surely_finite(right),
            Binary::DivideReal | Binary::DivideVector => {
                is_surely_finite(left) && is_not_zero(right)
            }
            _ => false,
        },
        ExprKind::Call(builtin, args) => match builtin {
            Builtin::CentroidEdge | Builtin::CentroidFace => true,
            Builtin::MixReal | Builtin::MixVector => args.iter().all(is_surely_finite),
            _ => false,
        },
        ExprKind::If(_, then, otherwise) => is_surely_finite(then) && is_surely_finite(otherwise),
        ExprKind::Bool(_)
        | ExprKind::Text(_)
        | ExprKind::Element(_)
        | ExprKind::Local(_)
        | ExprKind::Member(..)
        | ExprKind::Follow(..)
        | ExprKind::Read(Access::Declared(_), _)
        | ExprKind::Invoke(..)
        | ExprKind::Try(..)
        | ExprKind::Let(..)
        | ExprKind::Fold(_) => false,
    }
}

fn is_not_zero(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Real(value) => (1.0 / ORDINARY..=ORDINARY).contains(&value.abs()),
        ExprKind::Int(value) => *value != 0,
        ExprKind::Unary(Unary::ToReal, of) => is_not_zero(of),
        _ => false,
    }
}

/// True if emitted code has a type for these values.
pub(super) fn is_spelled(ty: Type) -> bool {
    ty != Type::Text
}
