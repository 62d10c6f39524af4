//! Calls of built-in functions.

use super::angle;
use super::fold::better;
use super::operator::{matrix, wide};
use super::pointer::{ask, first, load};
use crate::diagram::{Builtin, FoldFunction, Type};
use crate::rewrite::{
    Assembler, ElementField, HalfedgeField, Inst, Lanes, Math, Matrix, Question, Reg,
};

/// The value of a call: the type of the first argument, the type of the value, and its register.
#[derive(Clone, Copy)]
pub(super) struct Made {
    pub(super) of: Type,
    pub(super) result: Type,
    pub(super) to: Reg,
}

/// Appends a call whose arguments are in registers; in a typed program they fit the builtin.
pub(super) fn call(asm: &mut Assembler, place: u32, builtin: Builtin, args: &[Reg], made: Made) {
    let Made { of, result, to } = made;
    let at = |at: usize| args.get(at).or(args.first()).copied().unwrap_or(to);
    let [from, right, t] = [0, 1, 2].map(at);
    let (left, all) = (from, [to, from, right]);
    // Vectors of three components have instructions of their own.
    let is_wide = of != Type::Vec3;
    let math = |math| Inst::MathReal { math, to, from };
    let inst = match builtin {
        Builtin::DegreeVertex => ask(Question::Degree, to, from),
        Builtin::DegreeFace => ask(Question::FaceSize, to, from),
        Builtin::BoundaryVertex => ask(Question::BoundaryVertex, to, from),
        Builtin::BoundaryHalfedge => {
            load(asm, place, HalfedgeField::Face, [to, from]);
            Inst::LoadHole { to, face: to }
        }
        Builtin::BoundaryEdge => ask(Question::BoundaryEdge, to, from),
        Builtin::IsHole => Inst::LoadHole { to, face: from },
        Builtin::Adjacent => {
            Inst::Ask { question: Question::Adjacent, to, elements: [left, right] }
        }
        Builtin::LinkCondition => ask(Question::LinkCondition, to, from),
        Builtin::StarShaped => ask(Question::StarShaped, to, from),
        Builtin::KernelCentroid => ask(Question::KernelCentroid, to, from),
        Builtin::LengthEdge => ask(Question::LengthEdge, to, from),
        Builtin::LengthHalfedge => {
            load(asm, place, HalfedgeField::Edge, [to, from]);
            ask(Question::LengthEdge, to, to)
        }
        Builtin::LengthVector if is_wide => length(asm, of, to, from),
        Builtin::LengthVector => Inst::LengthVec { to, from },
        Builtin::Area => ask(Question::Area, to, from),
        Builtin::NormalFace => ask(Question::NormalFace, to, from),
        Builtin::NormalVertex => ask(Question::NormalVertex, to, from),
        Builtin::CentroidFace => ask(Question::CentroidFace, to, from),
        Builtin::CentroidEdge => middle(asm, place, from, to),
        Builtin::MixReal => {
            // left * (1 - t) + right * t, as for vectors.
            let (rest, part) = (less_than_one(asm, t), asm.reg());
            asm.emit(Inst::MulReal { to: rest, left, right: rest });
            asm.emit(Inst::MulReal { to: part, left: right, right: t });
            Inst::AddReal { to, left: rest, right: part }
        }
        Builtin::MixVector if is_wide => {
            let (rest, part) = (less_than_one(asm, t), asm.block(super::width(of)));
            asm.emit(wide(Lanes::Scale, of, [part, right, t]));
            asm.emit(wide(Lanes::Scale, of, [to, left, rest]));
            wide(Lanes::Add, of, [to, to, part])
        }
        Builtin::MixVector => Inst::MixVec { to, left, right, t },
        Builtin::Dot if is_wide => wide(Lanes::Dot, of, all),
        Builtin::Dot => Inst::Dot { to, left, right },
        Builtin::Cross => Inst::Cross { to, left, right },
        Builtin::CrossPlane => {
            let (first, second) = (asm.reg(), asm.reg());
            for (to, at) in [(first, 0), (second, 1)] {
                let (left, right) = (left.part(at), right.part(1 - at));
                asm.emit(Inst::MulReal { to, left, right });
            }
            Inst::SubReal { to, left: first, right: second }
        }
        Builtin::Normalize if is_wide => wide(Lanes::Normalize, of, all),
        Builtin::Normalize => Inst::Normalize { to, from },
        Builtin::Distance if is_wide => {
            let between = asm.block(super::width(of));
            asm.emit(wide(Lanes::Subtract, of, [between, left, right]));
            length(asm, of, to, between)
        }
        Builtin::Distance => {
            let between = asm.vec();
            asm.emit(Inst::SubVec { to: between, left, right });
            Inst::LengthVec { to, from: between }
        }
        Builtin::Angle => angle::between(asm, left, right, to),
        Builtin::AngleCorner | Builtin::Cotangent | Builtin::DihedralAngle => {
            return angle::lower(asm, place, builtin, from, to);
        }
        Builtin::AbsInt => Inst::AbsInt { to, from },
        Builtin::AbsReal => math(Math::Abs),
        Builtin::MinInt | Builtin::MinReal | Builtin::MinVector => {
            return better(asm, FoldFunction::Min, result, all);
        }
        Builtin::MaxInt | Builtin::MaxReal | Builtin::MaxVector => {
            return better(asm, FoldFunction::Max, result, all);
        }
        Builtin::ClampInt | Builtin::ClampReal => {
            let least = asm.reg();
            better(asm, FoldFunction::Max, result, [least, left, right]);
            return better(asm, FoldFunction::Min, result, [to, least, t]);
        }
        Builtin::Sqrt => math(Math::Sqrt),
        Builtin::Sin => math(Math::Sin),
        Builtin::Cos => math(Math::Cos),
        Builtin::Tan => math(Math::Tan),
        Builtin::Asin => math(Math::Asin),
        Builtin::Acos => math(Math::Acos),
        Builtin::Atan2 => Inst::Atan2Real { to, left, right },
        Builtin::Exp => math(Math::Exp),
        Builtin::Log => math(Math::Log),
        Builtin::Pow => Inst::PowReal { to, left, right },
        Builtin::Floor => math(Math::Floor),
        Builtin::Ceil => math(Math::Ceil),
        Builtin::Round => Inst::RoundReal { to, from },
        Builtin::Random => Inst::Random { to },
        Builtin::RandomInt => Inst::RandomInt { to, below: from },
        Builtin::Diagonal => matrix(Matrix::Diagonal, result, all),
        Builtin::UpperLeft => matrix(Matrix::UpperLeft, result, all),
        Builtin::Outer => matrix(Matrix::Outer, result, all),
        Builtin::Transpose => matrix(Matrix::Transpose, of, all),
        Builtin::Inverse => matrix(Matrix::Inverse, of, all),
        Builtin::Determinant => matrix(Matrix::Determinant, of, all),
        Builtin::Solve => matrix(Matrix::Solve, of, all),
        Builtin::IsNan => wide(Lanes::IsNan, of, all),
        Builtin::IsFinite => wide(Lanes::IsFinite, of, all),
    };
    asm.trap_at(place, inst);
}

fn length(asm: &mut Assembler, ty: Type, to: Reg, from: Reg) -> Inst {
    let square = asm.reg();
    asm.emit(wide(Lanes::Dot, ty, [square, from, from]));
    Inst::MathReal { math: Math::Sqrt, to, from: square }
}

/// `1 - t`
fn less_than_one(asm: &mut Assembler, t: Reg) -> Reg {
    let (left, to) = (asm.constant_real(1.0), asm.reg());
    asm.emit(Inst::SubReal { to, left, right: t });
    to
}

/// The middle of an edge.
fn middle(asm: &mut Assembler, place: u32, edge: Reg, to: Reg) -> Inst {
    let (halfedge, other) = (asm.reg(), asm.vec());
    first(asm, place, ElementField::Edge, [halfedge, edge]);
    load(asm, place, HalfedgeField::Vertex, [to, halfedge]);
    asm.trap_at(place, Inst::LoadPosition { to, vertex: to });
    load(asm, place, HalfedgeField::Twin, [halfedge, halfedge]);
    load(asm, place, HalfedgeField::Vertex, [halfedge, halfedge]);
    asm.trap_at(place, Inst::LoadPosition { to: other, vertex: halfedge });
    let t = asm.constant_real(0.5);
    Inst::MixVec { to, left: to, right: other, t }
}
