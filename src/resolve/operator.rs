//! Operators: the types they accept, and the widening of ints.

use crate::diagnostic::{Diagnostic, Edit, Fix};
use crate::diagram::{Binary, Expr, ExprKind, Type, Unary};
use crate::source::Span;
use crate::syntax::tree::{self, BinaryOp, UnaryOp};

use super::typed::{to_real, typed};
use super::typing::Typing;
use super::words::{operator, short, subject};

/// An operand as written, and its value.
type Operand<'a> = (&'a tree::Expr, Expr);

impl Typing<'_> {
    /// `-x`, `not x`
    pub(super) fn unary(
        &mut self,
        op: UnaryOp,
        (written, value): Operand,
        span: Span,
    ) -> Option<Expr> {
        let unary = match (op, value.ty) {
            (UnaryOp::Negate, Type::Int) => Unary::NegateInt,
            (UnaryOp::Negate, Type::Real) => Unary::NegateReal,
            (UnaryOp::Negate, ty) if ty.is_vector() || ty.is_matrix() => Unary::NegateVector,
            (UnaryOp::Negate, ty) => {
                let message = format!(
                    "`-` wants a number, a vector or a matrix, but {} is {}",
                    subject(written),
                    ty.a_word()
                );
                let error = Diagnostic::error("type-mismatch", message, written.span);
                return self.report.reject(place_note(error, &[(written, &value)]));
            }
            (UnaryOp::Not, _) => {
                let value = self.convert(written, value, Type::Bool, "`not`")?;
                return Some(not(value, span));
            }
        };
        let ty = value.ty;
        Some(typed(ty, ExprKind::Unary(unary, Box::new(value)), span))
    }

    /// `x + y`
    pub(super) fn binary(
        &mut self,
        op: BinaryOp,
        operands: [Operand; 2],
        span: Span,
    ) -> Option<Expr> {
        let [(left_written, left), (right_written, right)] = operands;
        let types = [left.ty, right.ty];
        let Some(joined) = join(op, types) else {
            let message = format!(
                "`{}` wants {}, not {} and {}",
                operator(op),
                wants(op),
                left.ty.a_word(),
                right.ty.a_word()
            );
            let error = Diagnostic::error("type-mismatch", message, span)
                .label(left_written.span, format!("this is {}", left.ty.a_word()))
                .label(right_written.span, format!("this is {}", right.ty.a_word()));
            let written = [(left_written, &left), (right_written, &right)];
            return self.report.reject(match op {
                BinaryOp::Equal | BinaryOp::NotEqual => error,
                BinaryOp::Add if types.contains(&Type::Text) => error.note(
                    "texts are not joined; what is printed holds values: `print \"{x} of {y}\"`",
                ),
                BinaryOp::And | BinaryOp::Or => compared_again(error, written),
                _ => with_places(place_note(error, &written), op, written),
            });
        };
        let (mut left, mut right) = (left, right);
        if joined.swap {
            (left, right) = (right, left);
        }
        if joined.widen {
            left = to_real(left);
            right = to_real(right);
        }
        let kind = ExprKind::Binary(joined.binary, Box::new(left), Box::new(right));
        let value = typed(joined.ty, kind, span);
        Some(if joined.negate { not(value, span) } else { value })
    }
}

/// `not x`
fn not(value: Expr, span: Span) -> Expr {
    let kind = ExprKind::Unary(Unary::Not, Box::new(value));
    typed(Type::Bool, kind, span)
}

/// An operator applied to two types.
struct Joined {
    binary: Binary,
    ty: Type,
    /// True if ints become reals first.
    widen: bool,
    /// True if the operands are swapped.
    swap: bool,
    /// True if the result is negated.
    negate: bool,
}

impl Joined {
    fn plain(binary: Binary, ty: Type) -> Self {
        Self { binary, ty, widen: false, swap: false, negate: false }
    }

    fn real(binary: Binary, ty: Type) -> Self {
        Self { widen: true, ..Self::plain(binary, ty) }
    }

    fn swapped(self) -> Self {
        Self { swap: true, ..self }
    }
}

/// The operation for two types of operands, if `op` accepts them.
fn join(op: BinaryOp, types: [Type; 2]) -> Option<Joined> {
    use Type::{Bool, Int, Real};
    let number = |ty| matches!(ty, Int | Real);
    let numbers = types.into_iter().all(number);
    let ints = types == [Int, Int];
    let [left, right] = types;
    let vectors = left == right && left.is_vector();
    let matrices = left == right && left.is_matrix();
    let wide = |ty: Type| ty.is_vector() || ty.is_matrix();
    let arithmetic = |int, real, vector| match () {
        () if ints => Some(Joined::plain(int, Int)),
        () if numbers => Some(Joined::real(real, Real)),
        () if vectors || matrices => Some(Joined::plain(vector, left)),
        () => None,
    };
    let order = |int, real| match () {
        () if ints => Some(Joined::plain(int, Bool)),
        () if numbers => Some(Joined::real(real, Bool)),
        () => None,
    };
    match op {
        BinaryOp::Add => arithmetic(Binary::AddInt, Binary::AddReal, Binary::AddVector),
        BinaryOp::Subtract => {
            arithmetic(Binary::SubtractInt, Binary::SubtractReal, Binary::SubtractVector)
        }
        BinaryOp::Multiply => match types {
            _ if matrices => Some(Joined::plain(Binary::MultiplyMatrices, left)),
            _ if left.is_matrix() && right.is_vector() => {
                let fits = left.size() == right.size();
                fits.then(|| Joined::plain(Binary::Transform, right))
            }
            _ if wide(left) && number(right) => Some(Joined::real(Binary::ScaleVector, left)),
            _ if number(left) && wide(right) => {
                Some(Joined::real(Binary::ScaleVector, right).swapped())
            }
            _ => arithmetic(Binary::MultiplyInt, Binary::MultiplyReal, Binary::MultiplyVector),
        },
        BinaryOp::Divide => match types {
            _ if wide(left) && number(right) => Some(Joined::real(Binary::DivideVector, left)),
            _ => numbers.then(|| Joined::real(Binary::DivideReal, Real)),
        },
        BinaryOp::Div => ints.then(|| Joined::plain(Binary::Div, Int)),
        BinaryOp::Mod => ints.then(|| Joined::plain(Binary::Mod, Int)),
        BinaryOp::Equal => equal(types),
        BinaryOp::NotEqual => equal(types).map(|joined| Joined { negate: true, ..joined }),
        BinaryOp::Less => order(Binary::LessInt, Binary::LessReal),
        BinaryOp::LessEqual => order(Binary::LessEqualInt, Binary::LessEqualReal),
        BinaryOp::Greater => order(Binary::LessInt, Binary::LessReal).map(Joined::swapped),
        BinaryOp::GreaterEqual => {
            order(Binary::LessEqualInt, Binary::LessEqualReal).map(Joined::swapped)
        }
        BinaryOp::And => (types == [Bool, Bool]).then(|| Joined::plain(Binary::And, Bool)),
        BinaryOp::Or => (types == [Bool, Bool]).then(|| Joined::plain(Binary::Or, Bool)),
    }
}

/// `x == y`
fn equal([left, right]: [Type; 2]) -> Option<Joined> {
    use Type::{Bool, Edge, Face, Halfedge, Int, Real, Text, Vertex};
    let plain = |binary| Some(Joined::plain(binary, Bool));
    match (left, right) {
        (Int, Int) => plain(Binary::EqualInt),
        (Int | Real, Int | Real) => Some(Joined::real(Binary::EqualReal, Bool)),
        (left, right) if left == right && (left.is_vector() || left.is_matrix()) => {
            plain(Binary::EqualVector)
        }
        (Bool, Bool) => plain(Binary::EqualBool),
        (Text, Text) => plain(Binary::EqualText),
        (Vertex, Vertex) | (Halfedge, Halfedge) | (Edge, Edge) | (Face, Face) => {
            plain(Binary::EqualElement)
        }
        _ => None,
    }
}

/// The operand types that an operator requires, in words.
fn wants(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add | BinaryOp::Subtract => "two numbers, or two vectors or matrices of one type",
        BinaryOp::Multiply => {
            "two numbers, two vectors or matrices of one type, a vector or matrix and a number, \
             or a matrix and a vector of its size"
        }
        BinaryOp::Divide => "two numbers, or a vector or matrix and a number",
        BinaryOp::Div | BinaryOp::Mod => "two ints",
        BinaryOp::Equal | BinaryOp::NotEqual => "two values of one type",
        BinaryOp::Less | BinaryOp::LessEqual | BinaryOp::Greater | BinaryOp::GreaterEqual => {
            "two numbers"
        }
        BinaryOp::And | BinaryOp::Or => "two bools",
    }
}

/// The name and the place of an operand, if it is the name of a vertex.
fn vertex_named<'t>(written: &'t tree::Expr, value: &Expr) -> Option<(&'t str, Span)> {
    match &written.kind {
        tree::ExprKind::Name(name) if value.ty == Type::Vertex && name.index.is_none() => {
            Some((name.ident.text.as_str(), written.span))
        }
        _ => None,
    }
}

/// Adds a note if an operand is a vertex, where its position is probably meant.
fn place_note(error: Diagnostic, operands: &[(&tree::Expr, &Expr)]) -> Diagnostic {
    let vertex = operands.iter().find_map(|(written, value)| vertex_named(written, value));
    error.with(vertex, |error, (name, _)| {
        error.note(format!("the point at which a vertex lies is `{name}.position`"))
    })
}

/// Adds the comparison that an alternative lacks, as in `x == 3 or 4`.
fn compared_again(error: Diagnostic, [left, right]: [(&tree::Expr, &Expr); 2]) -> Diagnostic {
    let tree::ExprKind::Binary(BinaryOp::Equal, first, _) = &left.0.kind else { return error };
    let ExprKind::Binary(_, compared, _) = &left.1.kind else { return error };
    let is_compared = equal([compared.ty, right.1.ty]).is_some();
    let name = short(first, 3).filter(|name| is_compared && !name.ends_with(')'));
    let Some(name) = name else { return error };
    let again = format!("{name} == ");
    error.fix(format!("write `{again}…`"), right.0.span.before(), again)
}

/// Adds the fix that vertices are replaced by their positions, if the operator takes these.
fn with_places(
    mut error: Diagnostic,
    op: BinaryOp,
    operands: [(&tree::Expr, &Expr); 2],
) -> Diagnostic {
    let vertices = operands.into_iter().filter(|(_, value)| value.ty == Type::Vertex);
    let named: Option<Vec<_>> =
        vertices.map(|(written, value)| vertex_named(written, value)).collect();
    let point = |ty: Type| if ty == Type::Vertex { Type::Vec3 } else { ty };
    let fits = join(op, operands.map(|(_, value)| point(value.ty))).is_some();
    let Some(named) = named.filter(|named| fits && !named.is_empty()) else { return error };
    let places: Vec<String> = named.iter().map(|(name, _)| format!("`{name}.position`")).collect();
    let text = || ".position".to_owned();
    let edits = named.iter().map(|(_, span)| Edit { span: span.after(), text: text() }).collect();
    error.fixes.push(Fix { title: format!("write {}", places.join(" and ")), edits });
    error
}
