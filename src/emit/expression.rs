//! Translation of typed expressions to terms.

use super::NotEmitted;
use super::matrix::{is_wide, negated, operated, type_of_call};
use super::names::Names;
use super::routine::Statement;
use super::term::{Fold, Function, Operation, Parameter, Term};
use crate::diagram::{
    Access, Binary, Builtin, Collection, Expr, ExprKind, Param, Rule, Type, Unary,
};
use crate::lower::{Hoisted, hoist};

/// The parameters of an operation or a function, with their defaults.
pub(super) fn parameters(
    params: &[Param],
    names: &mut Names,
) -> Result<Vec<Parameter>, NotEmitted> {
    if let Some(param) = params.iter().find(|param| !is_spelled(param.ty)) {
        let what = format!("a parameter of type `{}`", param.ty.word());
        return Err(NotEmitted::new(what, param.span));
    }
    let words = names.params.clone();
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
        let not_emitted = |what| NotEmitted::new(what, expr.span);
        Ok(match &expr.kind {
            ExprKind::Bool(value) => Term::Bool(*value),
            ExprKind::Int(value) => Term::Int(*value),
            ExprKind::Real(value) => Term::Real(*value),
            ExprKind::Text(_) => return Err(not_emitted("a text")),
            ExprKind::Invoke(number, args) => {
                let what = "a function that does more than compute a value";
                let name = self.names.call(*number);
                let name = name.ok_or_else(|| not_emitted(what))?;
                let args = args.iter().map(|arg| self.term(arg));
                Term::Invoke(name, args.collect::<Result<_, _>>()?)
            }
            ExprKind::Try(..) => return Err(not_emitted("an op that is only asked")),
            ExprKind::Let(..) => return Err(not_emitted("a block within a value")),
            ExprKind::Member(..) => return Err(not_emitted("a name with an index")),
            ExprKind::Read(Access::Declared(number), base) => {
                let what = "an attribute in a function";
                let attribute = self.names.attribute(*number);
                let attribute = attribute.ok_or_else(|| not_emitted(what))?;
                Term::Attribute(attribute, Box::new(self.term(base)?))
            }
            ExprKind::Element(name) => self.names.term(*name),
            ExprKind::Local(number) => Term::name(self.names.local(*number)),
            ExprKind::Follow(pointer, base) => self.term(base)?.follow(*pointer),
            ExprKind::Read(Access::Position, base) => {
                Term::call("Position", vec![self.term(base)?])
            }
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
            ExprKind::Call(builtin, _) if builtin.is_random() => {
                return Err(not_emitted("a random number"));
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
                let (around, element) = around(&fold.collection)
                    .ok_or_else(|| not_emitted(collection_words(&fold.collection)))?;
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

/// The name of the elements around another, and that one; `None` for other collections.
pub(super) fn around(collection: &Collection) -> Option<(&'static str, &Expr)> {
    let name = match collection {
        Collection::VertexHalfedges(_) => "VertexHalfedges",
        Collection::VertexEdges(_) => "VertexEdges",
        Collection::VertexFaces(_) => "VertexFaces",
        Collection::VertexNeighbors(_) => "VertexNeighbors",
        Collection::FaceHalfedges(_) => "FaceHalfedges",
        Collection::FaceVertices(_) => "FaceVertices",
        Collection::FaceEdges(_) => "FaceEdges",
        Collection::EdgeVertices(_) => "EdgeVertices",
        Collection::EdgeFaces(_) => "EdgeFaces",
        _ => return None,
    };
    Some((name, collection.base()?))
}

/// A collection for which there is no name, in words.
pub(super) fn collection_words(collection: &Collection) -> &'static str {
    match collection {
        Collection::FaceEars(_) => "`ears` of a face",
        Collection::FacePatch(_) => "the `patch` of a face",
        _ => "a sequence of the whole mesh",
    }
}

/// The size of the positions of a mesh: emitted code takes them to be no larger.
pub(super) const ORDINARY: f64 = 1e50;

/// True if a value is finite by its form, for positions of at most the given size.
pub(super) fn is_surely_finite(expr: &Expr, positions: f64) -> bool {
    // Far from the greatest number, so that what is in between is finite, too.
    greatest(expr, positions).is_some_and(|size| size <= 1e300)
}

/// The greatest size of a value or of its components, for sums, differences, products, means and
/// mixtures of positions and literals, and quotients by a literal.
fn greatest(expr: &Expr, positions: f64) -> Option<f64> {
    let of = |expr: &Expr| greatest(expr, positions);
    let sides = |left, right| Some([of(left)?, of(right)?]);
    match &expr.kind {
        ExprKind::Int(value) => Some(value.unsigned_abs() as f64),
        ExprKind::Real(value) => Some(value.abs()),
        ExprKind::Read(Access::Position, _) => Some(positions),
        ExprKind::Component(_, whole) => of(whole),
        ExprKind::Unary(_, operand) => of(operand),
        ExprKind::Vector(parts) => {
            parts.iter().try_fold(0.0, |most, part| Some(of(part)?.max(most)))
        }
        ExprKind::Binary(operator, left, right) => match operator {
            Binary::AddReal | Binary::SubtractReal | Binary::AddVector | Binary::SubtractVector => {
                sides(left, right).map(|[left, right]| left + right)
            }
            Binary::MultiplyReal | Binary::MultiplyVector | Binary::ScaleVector => {
                sides(left, right).map(|[left, right]| left * right)
            }
            Binary::DivideReal | Binary::DivideVector => Some(of(left)? / literal(right)?),
            _ => None,
        },
        ExprKind::Call(builtin, args) => match (builtin, args.as_slice()) {
            (Builtin::CentroidEdge | Builtin::CentroidFace, _) => Some(positions),
            (Builtin::MixReal | Builtin::MixVector, [from, to, part]) => {
                let [from, to] = sides(from, to)?;
                Some(from + (from + to) * of(part)?)
            }
            _ => None,
        },
        ExprKind::If(_, then, otherwise) => {
            sides(then, otherwise).map(|[then, otherwise]| then.max(otherwise))
        }
        _ => None,
    }
}

/// The size of a literal number.
fn literal(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Real(value) => Some(value.abs()),
        ExprKind::Int(value) => Some(value.unsigned_abs() as f64),
        ExprKind::Unary(Unary::ToReal, of) => literal(of),
        _ => None,
    }
}

/// True if emitted code has a type for these values.
pub(super) fn is_spelled(ty: Type) -> bool {
    ty != Type::Text
}
