//! Values that are finite by their form, so that nothing has to be tested.

use crate::diagram::{Access, Binary, Builtin, Expr, ExprKind, Unary};

/// The size of the positions of a mesh: code without a test takes them to be no larger.
pub const ORDINARY: f64 = 1e50;

/// True if a value is finite by its form, for positions of at most the given size.
pub fn is_surely_finite(expr: &Expr, positions: f64) -> bool {
    // Far from the greatest number, so that what is in between is finite, too.
    greatest(expr, positions).is_some_and(|size| size <= 1e300)
}

/// The greatest size of a value or of its components, for sums, differences, products, means and
/// mixtures of positions and literals, and quotients by a literal.
fn greatest(expr: &Expr, positions: f64) -> Option<f64> {
    let of = |expr: &Expr| greatest(expr, positions);
    let sides = |left, right| Some([of(left)?, of(right)?]);
    match &expr.kind {
        ExprKind::Int(_) | ExprKind::Real(_) => literal(expr),
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
