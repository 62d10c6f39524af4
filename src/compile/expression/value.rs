//! The value of an expression in a register.

use super::builtin::call;
use super::fold::fold;
use super::operator::{binary, unary};
use super::{Scope, width};
use crate::diagram::{Access, Expr, ExprKind, Pointer, Type};
use crate::rewrite::{Assembler, ElementField, HalfedgeField, Inst, Reg};

/// Appends the code of an expression; its value is in the register, or the three from it
/// on, until that is released. The register may be that of a variable: it is not to be
/// written to.
pub fn lower(asm: &mut Assembler, scope: &mut dyn Scope, expr: &Expr) -> Reg {
    match &expr.kind {
        ExprKind::Bool(value) => asm.constant_bool(*value),
        ExprKind::Int(value) => asm.constant_int(*value),
        ExprKind::Real(value) => asm.constant_real(*value),
        ExprKind::Text(value) => asm.constant_text(value),
        // What is compiled has been unrolled, so members have names of their own.
        ExprKind::Element(name) | ExprKind::Member(name, _) => scope.element(*name),
        ExprKind::Local(variable) => scope.local(*variable),
        ExprKind::Component(part, vector) => {
            lower(asm, scope, vector).part(u16::from(*part).min(2))
        }
        _ => {
            let to = asm.block(width(expr.ty));
            lower_into(asm, scope, expr, to);
            to
        }
    }
}

/// Appends the code of an expression and puts its value into a register, which nothing
/// in the expression reads.
pub fn lower_into(asm: &mut Assembler, scope: &mut dyn Scope, expr: &Expr, to: Reg) {
    let mark = asm.mark();
    match &expr.kind {
        ExprKind::Bool(_)
        | ExprKind::Int(_)
        | ExprKind::Real(_)
        | ExprKind::Text(_)
        | ExprKind::Element(_)
        | ExprKind::Member(..)
        | ExprKind::Local(_)
        | ExprKind::Component(..) => {
            let from = lower(asm, scope, expr);
            copy(asm, expr.ty, to, from);
        }
        ExprKind::Follow(pointer, base) => {
            let element = lower(asm, scope, base);
            let place = scope.place(expr.span);
            follow(asm, place, *pointer, element, to);
        }
        ExprKind::Read(Access::Position, base) => {
            let vertex = lower(asm, scope, base);
            let place = scope.place(expr.span);
            asm.trap_at(place, Inst::LoadPosition { to, vertex });
        }
        ExprKind::Vector(parts) => {
            for (part, value) in (0..).zip(parts.iter()) {
                lower_into(asm, scope, value, to.part(part));
            }
        }
        ExprKind::Unary(operator, operand) => {
            let from = lower(asm, scope, operand);
            let place = scope.place(expr.span);
            unary(asm, place, *operator, to, from);
        }
        ExprKind::Binary(operator, left, right) => {
            binary(asm, scope, expr.span, *operator, [left, right], to);
        }
        ExprKind::Call(builtin, args) => {
            let args: Vec<Reg> = args.iter().map(|arg| lower(asm, scope, arg)).collect();
            let place = scope.place(expr.span);
            call(asm, place, *builtin, &args, to);
        }
        ExprKind::If(condition, then, otherwise) => {
            let (second, end) = (asm.label(), asm.label());
            let condition = lower(asm, scope, condition);
            asm.emit(Inst::JumpUnless {
                condition,
                to: second,
            });
            lower_into(asm, scope, then, to);
            asm.emit(Inst::Jump { to: end });
            asm.bind(second);
            lower_into(asm, scope, otherwise, to);
            asm.bind(end);
        }
        ExprKind::Fold(it) => fold(asm, scope, it, expr, to),
    }
    asm.release(mark);
}

/// Copies a value of a type.
pub(super) fn copy(asm: &mut Assembler, ty: Type, to: Reg, from: Reg) {
    asm.emit(match ty {
        Type::Vec3 => Inst::CopyVec { to, from },
        _ => Inst::Copy { to, from },
    });
}

/// `element.pointer`
fn follow(asm: &mut Assembler, place: u32, pointer: Pointer, element: Reg, to: Reg) {
    let (field, halfedge) = match pointer {
        Pointer::Next => (HalfedgeField::Next, element),
        Pointer::Prev => (HalfedgeField::Prev, element),
        Pointer::Twin => (HalfedgeField::Twin, element),
        Pointer::Vertex => (HalfedgeField::Vertex, element),
        Pointer::Edge => (HalfedgeField::Edge, element),
        Pointer::Face => (HalfedgeField::Face, element),
        Pointer::Target => {
            let twin = Inst::Load {
                field: HalfedgeField::Twin,
                to,
                halfedge: element,
            };
            asm.trap_at(place, twin);
            (HalfedgeField::Vertex, to)
        }
        Pointer::VertexHalfedge => return first(asm, place, ElementField::Vertex, element, to),
        Pointer::EdgeHalfedge => return first(asm, place, ElementField::Edge, element, to),
        Pointer::FaceHalfedge => return first(asm, place, ElementField::Face, element, to),
    };
    asm.trap_at(
        place,
        Inst::Load {
            field,
            to,
            halfedge,
        },
    );
}

fn first(asm: &mut Assembler, place: u32, of: ElementField, element: Reg, to: Reg) {
    asm.trap_at(place, Inst::LoadHalfedge { of, to, element });
}
