//! Values that a mesh class may have no type for: vectors of two and four components, and matrices.
//!
//! Vectors of three components always have a type, and are spelled with operators. An operation on
//! the others carries the type of its operands, so that each language can spell it.

use super::NotEmitted;
use super::expression::Expressions;
use super::term::{Function, Operation, Term};
use crate::diagram::{Binary, Builtin, Expr, Type};

/// True if values of the type are such vectors or matrices.
pub(super) fn is_wide(ty: Type) -> bool {
    ty != Type::Vec3 && (ty.is_vector() || ty.is_matrix())
}

/// The condition that all components of a position are finite.
pub(super) fn finite(position: Term) -> Term {
    of(Operation::Builtin(Builtin::IsFinite), Type::Vec3, vec![position])
}

/// An operation on values of a type.
fn of(operation: Operation, ty: Type, args: Vec<Term>) -> Term {
    Term::Call(Function::Of(operation, ty), args)
}

/// `-x` of such values.
pub(super) fn negated(ty: Type, operand: Term) -> Term {
    of(Operation::Negate, ty, vec![operand])
}

/// An operator whose left side is such a value.
pub(super) fn operated(operator: Binary, ty: Type, sides: [Term; 2]) -> Term {
    of(Operation::Operator(operator), ty, sides.into())
}

/// The type that determines the spelling of a builtin, if it is one of such values.
pub(super) fn type_of_call(builtin: Builtin, args: &[Expr], result: Type) -> Option<Type> {
    let first = args.first()?.ty;
    match builtin {
        Builtin::Diagonal | Builtin::UpperLeft => Some(result),
        Builtin::Outer | Builtin::CrossPlane | Builtin::Solve => Some(first),
        Builtin::IsNan | Builtin::IsFinite if first == Type::Vec3 => Some(first),
        _ => is_wide(first).then_some(first),
    }
}

impl Expressions<'_> {
    /// A part of a vector or matrix.
    pub(super) fn component(
        &mut self,
        part: u8,
        whole: &Expr,
        result: Type,
    ) -> Result<Term, NotEmitted> {
        let term = self.term(whole)?;
        Ok(match (whole.ty, result) {
            (ty, Type::Real) => of(Operation::Part(part), ty, vec![term]),
            (ty, _) if ty.is_matrix() => of(Operation::Column(part / ty.size()), ty, vec![term]),
            (ty, result) => of(Operation::First(result), ty, vec![term]),
        })
    }

    /// A vector by its parts, or a matrix by its columns.
    pub(super) fn made(&mut self, ty: Type, parts: &[Expr]) -> Result<Term, NotEmitted> {
        let mut terms = Vec::new();
        for part in parts {
            let term = self.term(part)?;
            if let ([_, last], true) = (parts, terms.is_empty() && part.ty.is_vector())
                && last.ty == Type::Real
            {
                return Ok(of(Operation::Extend, ty, vec![term, self.term(last)?]));
            }
            if ty.is_matrix() || part.ty == Type::Real {
                terms.push(term);
                continue;
            }
            // A computed term is repeated for each of its parts.
            for at in 0..part.ty.size() {
                terms.push(of(Operation::Part(at), part.ty, vec![term.clone()]));
            }
        }
        Ok(of(Operation::Make, ty, terms))
    }
}
