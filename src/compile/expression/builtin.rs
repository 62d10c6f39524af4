//! Calls of what is part of the language.

use crate::diagram::Builtin;
use crate::rewrite::{Assembler, ElementField, HalfedgeField, Inst, Math, Reg};

/// A call with its arguments in registers.
pub(super) fn call(asm: &mut Assembler, place: u32, builtin: Builtin, args: &[Reg], to: Reg) {
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

/// No such builtin takes so many arguments; a typed program has no such call.
fn unknown(asm: &mut Assembler, place: u32) {
    let text = asm.text("this call has the wrong number of arguments");
    asm.trap_at(place, Inst::Fail { text });
}

/// What takes more than one instruction; false for the rest.
fn with_steps(asm: &mut Assembler, place: u32, builtin: Builtin, from: Reg, to: Reg) -> bool {
    let load = |field, to, halfedge| Inst::Load {
        field,
        to,
        halfedge,
    };
    match builtin {
        Builtin::BoundaryHalfedge => {
            asm.trap_at(place, load(HalfedgeField::Face, to, from));
            asm.trap_at(place, Inst::LoadHole { to, face: to });
        }
        Builtin::LengthHalfedge => {
            asm.trap_at(place, load(HalfedgeField::Edge, to, from));
            asm.trap_at(place, Inst::LengthEdge { to, edge: to });
        }
        Builtin::CentroidEdge => {
            let (halfedge, other) = (asm.reg(), asm.vec());
            let (of, element) = (ElementField::Edge, from);
            let first = Inst::LoadHalfedge {
                of,
                to: halfedge,
                element,
            };
            asm.trap_at(place, first);
            asm.trap_at(place, load(HalfedgeField::Vertex, to, halfedge));
            asm.trap_at(place, Inst::LoadPosition { to, vertex: to });
            asm.trap_at(place, load(HalfedgeField::Twin, halfedge, halfedge));
            asm.trap_at(place, load(HalfedgeField::Vertex, halfedge, halfedge));
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
        Builtin::DegreeVertex => Inst::Degree { to, vertex: from },
        Builtin::DegreeFace => Inst::FaceSize { to, face: from },
        Builtin::BoundaryVertex => Inst::BoundaryVertex { to, vertex: from },
        Builtin::BoundaryEdge => Inst::BoundaryEdge { to, edge: from },
        Builtin::IsHole => Inst::LoadHole { to, face: from },
        Builtin::LinkCondition => Inst::LinkCondition { to, edge: from },
        Builtin::StarShaped => Inst::StarShaped { to, edge: from },
        Builtin::KernelCentroid => Inst::KernelCentroid { to, edge: from },
        Builtin::LengthEdge => Inst::LengthEdge { to, edge: from },
        Builtin::LengthVec3 => Inst::LengthVec { to, from },
        Builtin::Area => Inst::Area { to, face: from },
        Builtin::NormalFace => Inst::NormalFace { to, face: from },
        Builtin::NormalVertex => Inst::NormalVertex { to, vertex: from },
        Builtin::CentroidFace => Inst::CentroidFace { to, face: from },
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
        _ => Inst::Fail {
            text: asm.text("this call has the wrong number of arguments"),
        },
    }
}

fn of_two(asm: &mut Assembler, place: u32, builtin: Builtin, [left, right]: [Reg; 2], to: Reg) {
    let inst = match builtin {
        Builtin::Adjacent => Inst::Adjacent { to, left, right },
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
            asm.emit(Inst::SubVec {
                to: between,
                left,
                right,
            });
            Inst::LengthVec { to, from: between }
        }
        Builtin::Angle => {
            // The arc tangent of sine over cosine is exact near 0 and a half turn, where
            // the arc cosine is not.
            let (cross, sine, cosine) = (asm.vec(), asm.reg(), asm.reg());
            asm.emit(Inst::Cross {
                to: cross,
                left,
                right,
            });
            asm.emit(Inst::LengthVec {
                to: sine,
                from: cross,
            });
            asm.emit(Inst::Dot {
                to: cosine,
                left,
                right,
            });
            Inst::Atan2Real {
                to,
                left: sine,
                right: cosine,
            }
        }
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
        Builtin::MixVec3 => asm.emit(Inst::MixVec { to, left, right, t }),
        Builtin::MixReal => {
            // left * (1 - t) + right * t, as for vectors.
            let (one, rest, part) = (asm.constant_real(1.0), asm.reg(), asm.reg());
            asm.emit(Inst::SubReal {
                to: rest,
                left: one,
                right: t,
            });
            asm.emit(Inst::MulReal {
                to: rest,
                left,
                right: rest,
            });
            asm.emit(Inst::MulReal {
                to: part,
                left: right,
                right: t,
            });
            asm.emit(Inst::AddReal {
                to,
                left: rest,
                right: part,
            });
        }
        _ => unknown(asm, place),
    }
}
