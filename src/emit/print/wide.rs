//! Computations with vectors and matrices in Rust and C++, side by side.
//!
//! In C++ their types need only a default value and `[]`: a component of a vector, a column of a
//! matrix. A vector of three components has other types; `parts` makes an array of it.
//!
//! `{T}` stands for the type of the operands, `{N}` for its size, `{M}` for the matrices of that
//! size; `{P}` and `{X}` for the number of a part or column and its axis.

use crate::diagram::{Binary, Builtin, Type};
use crate::emit::term::Operation;

/// The call of an operation on values of a type in Rust, except for operators, and in C++.
pub(super) fn spelled(operation: Operation, ty: Type) -> [&'static str; 2] {
    match operation {
        Operation::Operator(operator) => ["", by_parts(operator, ty)],
        Operation::Negate => ["-{0}", "negate<{N}>({0})"],
        Operation::Part(_) => ["{0}.{X}", "{0}[{P}]"],
        Operation::Column(_) => ["{0}.{X}_axis", "column{N}({0}, {P})"],
        Operation::First(Type::Vec2) if ty == Type::Vec4 => {
            ["{0}.truncate().truncate()", "first2_of_4({0})"]
        }
        Operation::First(Type::Vec2) => ["{0}.truncate()", "first2({0})"],
        Operation::First(_) => ["{0}.truncate()", "first3({0})"],
        Operation::Extend if ty == Type::Vec3 => ["{0}.extend({1})", "extended2({0}, {1})"],
        Operation::Extend => ["{0}.extend({1})", "extended({0}, {1})"],
        Operation::Make => match ty {
            Type::Mat3 => [
                "{T}::from_cols({0}, {1}, {2})",
                "columns<{T}>(parts({0}), parts({1}), parts({2}))",
            ],
            Type::Mat4 => {
                ["{T}::from_cols({0}, {1}, {2}, {3})", "columns<{T}>({0}, {1}, {2}, {3})"]
            }
            Type::Vec4 => ["{T}::new({0}, {1}, {2}, {3})", "made<{T}>({0}, {1}, {2}, {3})"],
            _ => ["{T}::new({0}, {1})", "made<{T}>({0}, {1})"],
        },
        Operation::Builtin(builtin) => match (builtin, ty) {
            (Builtin::Normalize, _) => ["direction{N}({0})", "normalize<{N}>({0})"],
            (Builtin::LengthVector, _) => ["{0}.length()", "length<{N}>({0})"],
            (Builtin::Distance, _) => {
                ["{T}::distance({0}, {1})", "length<{N}>(subtract<{N}>({0}, {1}))"]
            }
            (Builtin::MixVector, _) => ["{T}::lerp({0}, {1}, {2})", "blend<{N}>({0}, {1}, {2})"],
            (Builtin::CrossPlane, _) => ["{T}::perp_dot({0}, {1})", "cross_plane({0}, {1})"],
            (Builtin::IsNan, Type::Vec3) => ["{0}.is_nan()", "is_nan<{N}>(parts({0}))"],
            (Builtin::IsNan, _) => ["{0}.is_nan()", "is_nan<{N}>({0})"],
            (Builtin::IsFinite, _) => ["{0}.is_finite()", "is_finite<{N}>({0})"],
            (Builtin::Diagonal, _) => {
                ["{T}::from_diagonal(DVec{N}::splat({0}))", "diagonal<{N}, {T}>({0})"]
            }
            (Builtin::UpperLeft, _) => ["{T}::from_mat4({0})", "upper_left({0})"],
            (Builtin::Outer, Type::Vec3) => {
                ["outer{N}({0}, {1})", "outer<{N}, {M}>(parts({0}), parts({1}))"]
            }
            (Builtin::Outer, _) => ["outer{N}({0}, {1})", "outer<{N}, {M}>({0}, {1})"],
            (Builtin::Transpose, _) => ["{0}.transpose()", "transpose<{N}>({0})"],
            (Builtin::Inverse, _) => ["inverse{N}({0})", "inverse<{N}>({0})"],
            (Builtin::Determinant, _) => ["{0}.determinant()", "determinant{N}({0})"],
            (Builtin::Solve, Type::Mat3) => {
                ["solve{N}({0}, {1})", "vector_of(solve<{N}>({0}, parts({1})))"]
            }
            (Builtin::Solve, _) => ["solve{N}({0}, {1})", "solve<{N}>({0}, {1})"],
            // No other builtin has such arguments.
            _ => ["{T}::dot({0}, {1})", "dot<{N}>({0}, {1})"],
        },
    }
}

/// An operator in C++.
fn by_parts(operator: Binary, ty: Type) -> &'static str {
    match operator {
        Binary::AddVector => "add<{N}>({0}, {1})",
        Binary::SubtractVector => "subtract<{N}>({0}, {1})",
        Binary::MultiplyVector => "times<{N}>({0}, {1})",
        Binary::ScaleVector => "scale<{N}>({0}, {1})",
        Binary::DivideVector => "divide<{N}>({0}, {1})",
        Binary::MultiplyMatrices => "multiply_matrices<{N}>({0}, {1})",
        Binary::Transform if ty == Type::Mat3 => "vector_of(transform<{N}>({0}, parts({1})))",
        Binary::Transform => "transform<{N}>({0}, {1})",
        _ => "equal<{N}>({0}, {1})",
    }
}

/// A call with the names of types, sizes and parts filled in.
pub(super) fn with_types(
    call: &str,
    operation: Operation,
    ty: Type,
    name: impl Fn(Type) -> String,
) -> String {
    let matrix = if ty.size() == 3 { Type::Mat3 } else { Type::Mat4 };
    let part = match operation {
        Operation::Part(part) | Operation::Column(part) => part.min(3),
        _ => 0,
    };
    let axis = ["x", "y", "z", "w"][usize::from(part)];
    call.replace("{T}", &name(ty))
        .replace("{N}", &ty.size().to_string())
        .replace("{M}", &name(matrix))
        .replace("{P}", &part.to_string())
        .replace("{X}", axis)
}
