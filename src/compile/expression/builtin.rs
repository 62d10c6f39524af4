//! Calls of what is part of the language.

use super::angle;
use super::operator::{matrix, wide};
use super::pointer::{ask, first, load};
use crate::diagram::{Builtin, Type};
use crate::rewrite::{
    Assembler, ElementField, HalfedgeField, Inst, Lanes, Math, Matrix, Question, Reg,
};

/// The value that a call makes: of a first argument of what type, a value of what type, where.
#[derive(Clone, Copy)]
pub(super) struct Made {
    pub(super) of: Type,
    pub(super) result: Type,
    pub(super) to: Reg,
}

/// A call with its arguments in registers.
pub(super) fn call(asm: &mut Assembler, place: u32, builtin: Builtin, args: &[Reg], made: Made) {
    if of_any_width(asm, builtin, args, made) {
        return;
    }
    let to = made.to;
    match *args {
        [from] => {
            if !with_steps(asm, place, builtin, from, to) {
                let inst = of_one(asm, builtin, to, from);
                asm.trap_at(place, inst);
            }
        }
        [left, right] => of_two(asm, place, builtin, [left, right], to),
        [left, right, t] => of_three(asm, place, builtin, [left, right, t], to),
        _ => unknown(asm, place),
    }
}

/// The computations with vectors and matrices of any width; false for the rest.
fn of_any_width(asm: &mut Assembler, builtin: Builtin, args: &[Reg], made: Made) -> bool {
    let Made { of, result, to } = made;
    let Some(&left) = args.first() else {
        return false;
    };
    let right = args.get(1).copied().unwrap_or(left);
    let all = [to, left, right];
    // Vectors of three components have instructions of their own.
    let short = of != Type::Vec3;
    match builtin {
        Builtin::Dot if short => asm.emit(wide(Lanes::Dot, of, all)),
        Builtin::Normalize if short => asm.emit(wide(Lanes::Normalize, of, all)),
        Builtin::LengthVector if short => length(asm, of, to, left),
        Builtin::Distance if short => {
            let between = asm.block(super::width(of));
            asm.emit(wide(Lanes::Subtract, of, [between, left, right]));
            length(asm, of, to, between);
        }
        Builtin::MixVector if short => {
            let (Some(&t), one) = (args.get(2), asm.constant_real(1.0)) else {
                return false;
            };
            // left * (1 - t) + right * t
            let (rest, part) = (asm.reg(), asm.block(super::width(of)));
            asm.emit(Inst::SubReal { to: rest, left: one, right: t });
            asm.emit(wide(Lanes::Scale, of, [part, right, t]));
            asm.emit(wide(Lanes::Scale, of, [to, left, rest]));
            asm.emit(wide(Lanes::Add, of, [to, to, part]));
        }
        Builtin::CrossPlane => {
            let (first, second) = (asm.reg(), asm.reg());
            for (to, at) in [(first, 0), (second, 1)] {
                let (left, right) = (left.part(at), right.part(1 - at));
                asm.emit(Inst::MulReal { to, left, right });
            }
            let (left, right) = (first, second);
            asm.emit(Inst::SubReal { to, left, right });
        }
        Builtin::IsNan => asm.emit(wide(Lanes::IsNan, of, all)),
        Builtin::IsFinite => asm.emit(wide(Lanes::IsFinite, of, all)),
        Builtin::Diagonal => asm.emit(matrix(Matrix::Diagonal, result, all)),
        Builtin::UpperLeft => asm.emit(matrix(Matrix::UpperLeft, result, all)),
        Builtin::Outer => asm.emit(matrix(Matrix::Outer, result, all)),
        Builtin::Transpose => asm.emit(matrix(Matrix::Transpose, of, all)),
        Builtin::Inverse => asm.emit(matrix(Matrix::Inverse, of, all)),
        Builtin::Determinant => asm.emit(matrix(Matrix::Determinant, of, all)),
        Builtin::Solve => asm.emit(matrix(Matrix::Solve, of, all)),
        _ => return false,
    }
    true
}

fn length(asm: &mut Assembler, ty: Type, to: Reg, from: Reg) {
    let square = asm.reg();
    asm.emit(wide(Lanes::Dot, ty, [square, from, from]));
    let (math, from) = (Math::Sqrt, square);
    asm.emit(Inst::MathReal { math, to, from });
}

/// No such builtin takes so many arguments; a typed program has no such call.
fn unknown(asm: &mut Assembler, place: u32) {
    let text = asm.text("this call has the wrong number of arguments");
    asm.trap_at(place, Inst::Fail { text });
}

/// The functions that take more than one instruction; false for the rest.
fn with_steps(asm: &mut Assembler, place: u32, builtin: Builtin, from: Reg, to: Reg) -> bool {
    match builtin {
        Builtin::BoundaryHalfedge => {
            load(asm, place, HalfedgeField::Face, [to, from]);
            asm.trap_at(place, Inst::LoadHole { to, face: to });
        }
        Builtin::LengthHalfedge => {
            load(asm, place, HalfedgeField::Edge, [to, from]);
            asm.trap_at(place, ask(Question::LengthEdge, to, to));
        }
        Builtin::AngleCorner | Builtin::Cotangent | Builtin::DihedralAngle => {
            angle::lower(asm, place, builtin, from, to);
        }
        Builtin::CentroidEdge => {
            let (halfedge, other) = (asm.reg(), asm.vec());
            first(asm, place, ElementField::Edge, [halfedge, from]);
            load(asm, place, HalfedgeField::Vertex, [to, halfedge]);
            asm.trap_at(place, Inst::LoadPosition { to, vertex: to });
            load(asm, place, HalfedgeField::Twin, [halfedge, halfedge]);
            load(asm, place, HalfedgeField::Vertex, [halfedge, halfedge]);
            let vertex = halfedge;
            asm.trap_at(place, Inst::LoadPosition { to: other, vertex });
            let t = asm.constant_real(0.5);
            let (left, right) = (to, other);
            asm.emit(Inst::MixVec { to, left, right, t });
        }
        _ => return false,
    }
    true
}

fn of_one(asm: &mut Assembler, builtin: Builtin, to: Reg, from: Reg) -> Inst {
    let math = |math| Inst::MathReal { math, to, from };
    match builtin {
        Builtin::DegreeVertex => ask(Question::Degree, to, from),
        Builtin::DegreeFace => ask(Question::FaceSize, to, from),
        Builtin::BoundaryVertex => ask(Question::BoundaryVertex, to, from),
        Builtin::BoundaryEdge => ask(Question::BoundaryEdge, to, from),
        Builtin::IsHole => Inst::LoadHole { to, face: from },
        Builtin::LinkCondition => ask(Question::LinkCondition, to, from),
        Builtin::StarShaped => ask(Question::StarShaped, to, from),
        Builtin::KernelCentroid => ask(Question::KernelCentroid, to, from),
        Builtin::LengthEdge => ask(Question::LengthEdge, to, from),
        Builtin::LengthVector => Inst::LengthVec { to, from },
        Builtin::Area => ask(Question::Area, to, from),
        Builtin::NormalFace => ask(Question::NormalFace, to, from),
        Builtin::NormalVertex => ask(Question::NormalVertex, to, from),
        Builtin::CentroidFace => ask(Question::CentroidFace, to, from),
        Builtin::Normalize => Inst::Normalize { to, from },
        Builtin::AbsInt => Inst::AbsInt { to, from },
        Builtin::Round => Inst::RoundReal { to, from },
        Builtin::AbsReal => math(Math::Abs),
        Builtin::Sqrt => math(Math::Sqrt),
        Builtin::Sin => math(Math::Sin),
        Builtin::Cos => math(Math::Cos),
        Builtin::Tan => math(Math::Tan),
        Builtin::Asin => math(Math::Asin),
        Builtin::Acos => math(Math::Acos),
        Builtin::Exp => math(Math::Exp),
        Builtin::Log => math(Math::Log),
        Builtin::Floor => math(Math::Floor),
        Builtin::Ceil => math(Math::Ceil),
        _ => Inst::Fail { text: asm.text("this call has the wrong number of arguments") },
    }
}

fn of_two(asm: &mut Assembler, place: u32, builtin: Builtin, [left, right]: [Reg; 2], to: Reg) {
    let inst = match builtin {
        Builtin::Adjacent => {
            Inst::Ask { question: Question::Adjacent, to, elements: [left, right] }
        }
        Builtin::Dot => Inst::Dot { to, left, right },
        Builtin::Cross => Inst::Cross { to, left, right },
        Builtin::MinInt => Inst::MinInt { to, left, right },
        Builtin::MaxInt => Inst::MaxInt { to, left, right },
        Builtin::MinReal => Inst::MinReal { to, left, right },
        Builtin::MaxReal => Inst::MaxReal { to, left, right },
        Builtin::Atan2 => Inst::Atan2Real { to, left, right },
        Builtin::Pow => Inst::PowReal { to, left, right },
        Builtin::Distance => {
            let between = asm.vec();
            asm.emit(Inst::SubVec { to: between, left, right });
            Inst::LengthVec { to, from: between }
        }
        Builtin::Angle => angle::between(asm, left, right, to),
        _ => return unknown(asm, place),
    };
    asm.trap_at(place, inst);
}

fn of_three(
    asm: &mut Assembler,
    place: u32,
    builtin: Builtin,
    [left, right, t]: [Reg; 3],
    to: Reg,
) {
    match builtin {
        Builtin::MixVector => asm.emit(Inst::MixVec { to, left, right, t }),
        Builtin::MixReal => {
            // left * (1 - t) + right * t, as for vectors.
            let (one, rest, part) = (asm.constant_real(1.0), asm.reg(), asm.reg());
            asm.emit(Inst::SubReal { to: rest, left: one, right: t });
            asm.emit(Inst::MulReal { to: rest, left, right: rest });
            asm.emit(Inst::MulReal { to: part, left: right, right: t });
            asm.emit(Inst::AddReal { to, left: rest, right: part });
        }
        _ => unknown(asm, place),
    }
}
