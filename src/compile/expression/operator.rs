//! Operators: one instruction each, but for the two that may skip their right side.

use super::Scope;
use super::value::{lower, lower_into};
use crate::diagram::{Binary, Expr, Unary};
use crate::rewrite::{Assembler, Inst, Math, Reg};
use crate::source::Span;

/// An operator with one operand.
pub(super) fn unary(asm: &mut Assembler, place: u32, operator: Unary, to: Reg, from: Reg) {
    let math = Math::Negate;
    match operator {
        Unary::NegateInt => asm.trap_at(place, Inst::NegInt { to, from }),
        Unary::NegateReal => asm.emit(Inst::MathReal { math, to, from }),
        Unary::NegateVec3 => asm.emit(Inst::NegVec { to, from }),
        Unary::Not => asm.emit(Inst::Not { to, from }),
        Unary::ToReal => asm.emit(Inst::IntToReal { to, from }),
    }
}

/// An operator with two operands.
pub(super) fn binary(
    asm: &mut Assembler,
    scope: &mut dyn Scope,
    span: Span,
    operator: Binary,
    [left, right]: [&Expr; 2],
    to: Reg,
) {
    if matches!(operator, Binary::And | Binary::Or) {
        let end = asm.label();
        lower_into(asm, scope, left, to);
        let condition = to;
        asm.emit(match operator {
            Binary::And => Inst::JumpUnless { condition, to: end },
            _ => Inst::JumpIf { condition, to: end },
        });
        lower_into(asm, scope, right, to);
        asm.bind(end);
        return;
    }
    let left = lower(asm, scope, left);
    let right = lower(asm, scope, right);
    let place = scope.place(span);
    let inst = operation(operator, to, left, right);
    asm.trap_at(place, inst);
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
        Binary::AddVec3 => Inst::AddVec { to, left, right },
        Binary::SubtractVec3 => Inst::SubVec { to, left, right },
        Binary::MultiplyVec3 => Inst::MulVec { to, left, right },
        Binary::ScaleVec3 => Inst::ScaleVec { to, left, right },
        Binary::DivideVec3 => Inst::DivVec { to, left, right },
        Binary::EqualInt | Binary::EqualBool | Binary::EqualText | Binary::EqualElement => {
            Inst::Equal { to, left, right }
        }
        Binary::EqualReal => Inst::EqualReal { to, left, right },
        Binary::EqualVec3 => Inst::EqualVec { to, left, right },
        Binary::LessInt => Inst::LessInt { to, left, right },
        Binary::LessEqualInt => Inst::LessEqualInt { to, left, right },
        Binary::LessReal => Inst::LessReal { to, left, right },
        Binary::LessEqualReal => Inst::LessEqualReal { to, left, right },
        // Lowered with jumps above; the meaning is the same.
        Binary::And => Inst::And { to, left, right },
        Binary::Or => Inst::Or { to, left, right },
    }
}
