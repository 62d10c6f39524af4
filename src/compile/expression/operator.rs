//! Operators: one instruction each.

use super::width;
use crate::diagram::{Binary, Type, Unary};
use crate::rewrite::{Assembler, Inst, Lanes, Math, Matrix, Reg};

/// An operator with one operand.
pub(super) fn unary(
    asm: &mut Assembler,
    place: u32,
    (operator, ty): (Unary, Type),
    to: Reg,
    from: Reg,
) {
    let math = Math::Negate;
    match operator {
        Unary::NegateInt => asm.trap_at(place, Inst::NegInt { to, from }),
        Unary::NegateReal => asm.emit(Inst::MathReal { math, to, from }),
        Unary::NegateVector if ty == Type::Vec3 => asm.emit(Inst::NegVec { to, from }),
        Unary::NegateVector => {
            let right = asm.constant_real(-1.0);
            asm.emit(wide(Lanes::Scale, ty, [to, from, right]));
        }
        Unary::Not => asm.emit(Inst::Not { to, from }),
        Unary::ToReal => asm.emit(Inst::IntToReal { to, from }),
    }
}

/// An operator with two operands, of which the left one is of type `ty`.
pub(super) fn binary(operator: Binary, ty: Type, [to, left, right]: [Reg; 3]) -> Inst {
    match ty {
        Type::Vec3 => operation(operator, to, left, right),
        _ if ty.is_vector() || ty.is_matrix() => wide_operation(operator, ty, [to, left, right]),
        _ => operation(operator, to, left, right),
    }
}

/// A computation of a value of any width, given by `ty`.
pub(super) fn wide(operation: Lanes, ty: Type, [to, left, right]: [Reg; 3]) -> Inst {
    Inst::Wide {
        operation,
        // No value is as wide as 256.
        width: width(ty) as u8,
        to,
        left,
        right,
    }
}

/// A computation of matrices of this type, or with vectors of as many components.
pub(super) fn matrix(operation: Matrix, ty: Type, [to, left, right]: [Reg; 3]) -> Inst {
    Inst::Matrix { operation, size: ty.size(), to, left, right }
}

/// An operator whose left operand is a vector or matrix of this type.
fn wide_operation(operator: Binary, ty: Type, registers: [Reg; 3]) -> Inst {
    let lanes = |operation| wide(operation, ty, registers);
    match operator {
        Binary::AddVector => lanes(Lanes::Add),
        Binary::SubtractVector => lanes(Lanes::Subtract),
        Binary::MultiplyVector => lanes(Lanes::Multiply),
        Binary::ScaleVector => lanes(Lanes::Scale),
        Binary::DivideVector => lanes(Lanes::Divide),
        Binary::EqualVector => lanes(Lanes::Equal),
        Binary::MultiplyMatrices => matrix(Matrix::Multiply, ty, registers),
        Binary::Transform => matrix(Matrix::Transform, ty, registers),
        _ => {
            let [to, left, right] = registers;
            operation(operator, to, left, right)
        }
    }
}

fn operation(operator: Binary, to: Reg, left: Reg, right: Reg) -> Inst {
    match operator {
        Binary::AddInt => Inst::AddInt { to, left, right },
        Binary::SubtractInt => Inst::SubInt { to, left, right },
        Binary::MultiplyInt => Inst::MulInt { to, left, right },
        Binary::Div => Inst::DivInt { to, left, right },
        Binary::Mod => Inst::ModInt { to, left, right },
        Binary::AddReal => Inst::AddReal { to, left, right },
        Binary::SubtractReal => Inst::SubReal { to, left, right },
        Binary::MultiplyReal => Inst::MulReal { to, left, right },
        Binary::DivideReal => Inst::DivReal { to, left, right },
        Binary::AddVector => Inst::AddVec { to, left, right },
        Binary::SubtractVector => Inst::SubVec { to, left, right },
        Binary::MultiplyVector => Inst::MulVec { to, left, right },
        Binary::ScaleVector => Inst::ScaleVec { to, left, right },
        Binary::DivideVector => Inst::DivVec { to, left, right },
        Binary::EqualInt | Binary::EqualBool | Binary::EqualText | Binary::EqualElement => {
            Inst::Equal { to, left, right }
        }
        Binary::EqualReal => Inst::EqualReal { to, left, right },
        Binary::EqualVector => Inst::EqualVec { to, left, right },
        Binary::LessInt => Inst::LessInt { to, left, right },
        Binary::LessEqualInt => Inst::LessEqualInt { to, left, right },
        Binary::LessReal => Inst::LessReal { to, left, right },
        Binary::LessEqualReal => Inst::LessEqualReal { to, left, right },
        // Only for matrices, which `wide_operation` handles.
        Binary::MultiplyMatrices => matrix(Matrix::Multiply, Type::Mat4, [to, left, right]),
        Binary::Transform => matrix(Matrix::Transform, Type::Mat4, [to, left, right]),
        // Lowered with jumps; the meaning is the same.
        Binary::And => Inst::And { to, left, right },
        Binary::Or => Inst::Or { to, left, right },
    }
}
