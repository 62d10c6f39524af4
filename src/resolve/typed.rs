//! Construction of typed expressions.

use crate::diagram::{Expr, ExprKind, Type, Unary};
use crate::source::Span;

pub(super) fn typed(ty: Type, kind: ExprKind, span: Span) -> Expr {
    Expr { ty, kind, span }
}

/// An int as a real; anything else as it is.
pub(super) fn to_real(expr: Expr) -> Expr {
    if expr.ty != Type::Int {
        return expr;
    }
    let span = expr.span;
    let kind = ExprKind::Unary(Unary::ToReal, Box::new(expr));
    typed(Type::Real, kind, span)
}
