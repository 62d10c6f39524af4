//! Computations with vectors and matrices: those of `glam`, except where it rounds differently.

use super::super::language::{Level, Spelled};
use super::super::term::Operation;
use super::function::{Printer, ty as name_of};
use crate::diagram::{Binary, Builtin, Type};

impl Printer {
    /// A call of a support function.
    pub(super) fn support(&self, name: &str, args: &[String]) -> Spelled {
        Spelled::whole(format!("{name}({})", args.join(", ")))
    }

    pub(super) fn of_type(&self, operation: Operation, ty: Type, args: Vec<Spelled>) -> Spelled {
        match (operation, <[Spelled; 2]>::try_from(args)) {
            (Operation::Operator(operator), Ok([left, right])) => {
                let (symbol, level, behind) = match operator {
                    Binary::AddVector => ("+", Level::Sum, Level::Product),
                    Binary::SubtractVector => ("-", Level::Sum, Level::Product),
                    Binary::DivideVector => ("/", Level::Product, Level::Prefix),
                    Binary::EqualVector => ("==", Level::Compare, Level::Sum),
                    _ => ("*", Level::Product, Level::Prefix),
                };
                let before = if level == Level::Compare { behind } else { level };
                let (left, right) = (left.at(before), right.at(behind));
                Spelled::new(format!("{left} {symbol} {right}"), level)
            }
            (Operation::Extend, Ok([vector, part])) => {
                let vector = vector.at(Level::Whole);
                Spelled::whole(format!("{vector}.extend({})", part.text))
            }
            (Operation::Builtin(builtin), Ok(args)) => self.builtin_of(builtin, ty, args.into()),
            (operation, Ok(args)) => self.of_parts(operation, ty, args.into()),
            (operation, Err(args)) => self.of_parts(operation, ty, args),
        }
    }

    fn of_parts(&self, operation: Operation, ty: Type, mut args: Vec<Spelled>) -> Spelled {
        let parts = |args: Vec<Spelled>| {
            let texts = args.into_iter().map(|arg| arg.text);
            texts.collect::<Vec<_>>().join(", ")
        };
        let name = match operation {
            Operation::Make if ty.is_matrix() => "from_cols",
            Operation::Make => "new",
            Operation::Builtin(builtin) => return self.builtin_of(builtin, ty, args),
            operation => {
                let of = args.pop().unwrap_or_else(|| Spelled::whole(""));
                if operation == Operation::Negate {
                    return Spelled::new(format!("-{}", of.at(Level::Whole)), Level::Prefix);
                }
                let of = of.at(Level::Whole);
                let axis = |at: u8| ["x", "y", "z", "w"][usize::from(at.min(3))];
                return Spelled::whole(match operation {
                    Operation::Part(part) => format!("{of}.{}", axis(part)),
                    Operation::Column(column) => format!("{of}.{}_axis", axis(column)),
                    Operation::First(Type::Vec2) if ty == Type::Vec4 => {
                        format!("{of}.truncate().truncate()")
                    }
                    _ => format!("{of}.truncate()"),
                });
            }
        };
        Spelled::whole(format!("{}::{name}({})", name_of(ty), parts(args)))
    }

    fn builtin_of(&self, builtin: Builtin, ty: Type, args: Vec<Spelled>) -> Spelled {
        let of_one = args.first().cloned().filter(|_| args.len() == 1);
        let args: Vec<_> = args.into_iter().map(|arg| arg.text).collect();
        let is_short = ty.size() < 4;
        let name = match builtin {
            Builtin::Normalize if ty == Type::Vec2 => return self.support("direction2", &args),
            Builtin::Normalize => return self.support("direction4", &args),
            Builtin::Outer if is_short => return self.support("outer3", &args),
            Builtin::Outer => return self.support("outer4", &args),
            Builtin::Inverse if is_short => return self.support("inverse3", &args),
            Builtin::Inverse => return self.support("inverse4", &args),
            Builtin::Solve if is_short => return self.support("solve3", &args),
            Builtin::Solve => return self.support("solve4", &args),
            Builtin::Diagonal => {
                let vector = if is_short { "DVec3" } else { "DVec4" };
                let diagonal = format!("{vector}::splat({})", args.join(""));
                let text = format!("{}::from_diagonal({diagonal})", name_of(ty));
                return Spelled::whole(text);
            }
            Builtin::UpperLeft => "from_mat4",
            Builtin::LengthVector => "length",
            Builtin::Distance => "distance",
            Builtin::MixVector => "lerp",
            Builtin::CrossPlane => "perp_dot",
            Builtin::IsNan => "is_nan",
            Builtin::IsFinite => "is_finite",
            Builtin::Transpose => "transpose",
            Builtin::Determinant => "determinant",
            // No other builtin has such arguments.
            _ => "dot",
        };
        Spelled::whole(match of_one {
            Some(of) if name != "from_mat4" => format!("{}.{name}()", of.at(Level::Whole)),
            _ => format!("{}::{name}({})", name_of(ty), args.join(", ")),
        })
    }
}
