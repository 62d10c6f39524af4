//! Computations with vectors and matrices that a mesh class may have no type for.
//!
//! Their types need only a default value and `[]`: a component of a vector, a column of a matrix.

use super::super::language::Spelled;
use super::super::term::Operation;
use super::function::Printer;
use crate::diagram::{Binary, Builtin, Type};

impl Printer<'_> {
    /// A call of a support template: `hedgerow::dot<4>(x, y)`.
    fn sized(&self, name: &str, size: u8, args: &[String]) -> String {
        self.templated(name, &[size.to_string()], args)
    }

    fn templated(&self, name: &str, of: &[String], args: &[String]) -> String {
        format!("hedgerow::{name}<{}>({})", of.join(", "), args.join(", "))
    }

    /// A sum or mean of values of the type.
    pub(super) fn total(&self, name: &str, ty: Type, args: &[String]) -> String {
        let of = [ty.size().to_string(), self.ty(ty)];
        self.templated(name, &of, args)
    }

    /// A vector of three components as an array of its parts, which can be indexed.
    fn parts(&self, ty: Type, vector: String) -> String {
        match ty {
            Type::Vec3 => self.support("parts", vec![vector]),
            _ => vector,
        }
    }

    pub(super) fn of_type(&self, operation: Operation, ty: Type, mut args: Vec<String>) -> Spelled {
        let size = ty.size();
        let text = match operation {
            Operation::Operator(Binary::Transform) if ty == Type::Mat3 => {
                args[1] = self.parts(Type::Vec3, args[1].clone());
                let image = self.sized("transform", size, &args);
                self.support("vector_of", vec![image])
            }
            Operation::Operator(operator) => {
                let name = match operator {
                    Binary::AddVector => "add",
                    Binary::SubtractVector => "subtract",
                    Binary::MultiplyVector => "times",
                    Binary::ScaleVector => "scale",
                    Binary::DivideVector => "divide",
                    Binary::MultiplyMatrices => "multiply_matrices",
                    Binary::Transform => "transform",
                    _ => "equal",
                };
                self.sized(name, size, &args)
            }
            Operation::Negate => self.sized("negate", size, &args),
            Operation::Part(part) => format!("{}[{part}]", args.join("")),
            Operation::Column(column) => {
                args.push(column.to_string());
                let name = if size == 3 { "column3" } else { "column4" };
                self.support(name, args)
            }
            Operation::First(result) => {
                let name = match (ty, result) {
                    (Type::Vec3, _) => "first2",
                    (_, Type::Vec2) => "first2_of_4",
                    _ => "first3",
                };
                self.support(name, args)
            }
            Operation::Extend => {
                let name = if size == 3 { "extended2" } else { "extended" };
                self.support(name, args)
            }
            Operation::Make if ty.is_matrix() => {
                if ty == Type::Mat3 {
                    args = args.into_iter().map(|arg| self.parts(Type::Vec3, arg)).collect();
                }
                self.templated("columns", &[self.ty(ty)], &args)
            }
            Operation::Make => self.templated("made", &[self.ty(ty)], &args),
            Operation::Builtin(builtin) => self.builtin_of(builtin, ty, args),
        };
        Spelled::whole(text)
    }

    fn builtin_of(&self, builtin: Builtin, ty: Type, mut args: Vec<String>) -> String {
        let size = ty.size();
        let name = match builtin {
            Builtin::Dot => "dot",
            Builtin::Normalize => "normalize",
            Builtin::LengthVector => "length",
            Builtin::Distance => {
                args = vec![self.sized("subtract", size, &args)];
                "length"
            }
            Builtin::MixVector => "blend",
            Builtin::CrossPlane => return self.support("cross_plane", args),
            Builtin::IsNan => {
                args = vec![self.parts(ty, args.join(""))];
                "is_nan"
            }
            Builtin::IsFinite => "is_finite",
            Builtin::Diagonal => {
                let of = [size.to_string(), self.ty(ty)];
                return self.templated("diagonal", &of, &args);
            }
            Builtin::UpperLeft => return self.support("upper_left", args),
            Builtin::Outer => {
                args = args.into_iter().map(|arg| self.parts(ty, arg)).collect();
                let matrix = if size == 3 { Type::Mat3 } else { Type::Mat4 };
                let of = [size.to_string(), self.ty(matrix)];
                return self.templated("outer", &of, &args);
            }
            Builtin::Transpose => "transpose",
            Builtin::Inverse => "inverse",
            Builtin::Determinant if size == 3 => return self.support("determinant3", args),
            Builtin::Determinant => return self.support("determinant4", args),
            Builtin::Solve if size == 3 => {
                args[1] = self.parts(Type::Vec3, args[1].clone());
                let solution = self.sized("solve", size, &args);
                return self.support("vector_of", vec![solution]);
            }
            // No other builtin has such arguments.
            _ => "solve",
        };
        self.sized(name, size, &args)
    }
}
