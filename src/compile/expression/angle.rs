//! Angles on a mesh: of corners, opposite to halfedges, and across edges.

use crate::diagram::Builtin;
use crate::rewrite::{Assembler, ElementField, HalfedgeField, Inst, Label, Question, Reg};

use super::pointer::{ask, first, load};

/// The angle between two vectors; zero if one of them is.
pub(super) fn between(asm: &mut Assembler, left: Reg, right: Reg, to: Reg) -> Inst {
    let [sine, cosine] = sine_and_cosine(asm, left, right);
    arc(asm, sine, cosine, to)
}

/// The angle with this sine and cosine, times a positive number.
///
/// The arc tangent of sine over cosine is exact near 0 and a half turn, where the arc cosine is
/// not.
fn arc(asm: &mut Assembler, sine: Reg, cosine: Reg, to: Reg) -> Inst {
    // Negative zero would be half a turn.
    let zero = asm.constant_real(0.0);
    asm.emit(Inst::AddReal { to: cosine, left: cosine, right: zero });
    Inst::Atan2Real { to, left: sine, right: cosine }
}

/// The sine and cosine of the angle between two vectors, times a positive number.
fn sine_and_cosine(asm: &mut Assembler, left: Reg, right: Reg) -> [Reg; 2] {
    let [left, right] = [left, right].map(|from| {
        let to = asm.vec();
        asm.emit(Inst::Balance { to, from });
        to
    });
    let (cross, sine, cosine) = (asm.vec(), asm.reg(), asm.reg());
    let to = cross;
    asm.emit(Inst::Cross { to, left, right });
    let (to, from) = (sine, cross);
    asm.emit(Inst::LengthVec { to, from });
    let to = cosine;
    asm.emit(Inst::Dot { to, left, right });
    [sine, cosine]
}

/// The angles of halfedges and edges, in radians:
///
/// ```text
///        apex                     N1  N2      turned by the dihedral angle
///       / c \    cotangent(h)     \  /
///      /     \      of c        ___\/___
///     a       \   angle(h) is a  f1  e  f2
///    v ---h--> w
/// ```
pub(super) fn lower(asm: &mut Assembler, place: u32, builtin: Builtin, from: Reg, to: Reg) {
    match builtin {
        Builtin::AngleCorner => {
            let around = Triangle::at(asm, place, from);
            let [left, right] = [around.end, around.apex].map(|far| {
                let to = asm.vec();
                let (left, right) = (far, around.start);
                asm.emit(Inst::SubVec { to, left, right });
                to
            });
            let angle = between(asm, left, right, to);
            asm.emit(angle);
        }
        Builtin::Cotangent => {
            let (face, in_hole) = (asm.reg(), asm.reg());
            load(asm, place, HalfedgeField::Face, [face, from]);
            asm.trap_at(place, Inst::LoadHole { to: in_hole, face });
            let end = zero_if(asm, in_hole, to);
            let around = Triangle::at(asm, place, from);
            let [left, right] = [around.start, around.end].map(|far| {
                let to = asm.vec();
                let (left, right) = (far, around.apex);
                asm.emit(Inst::SubVec { to, left, right });
                to
            });
            let [sine, cosine] = sine_and_cosine(asm, left, right);
            let (left, right) = (cosine, sine);
            asm.emit(Inst::DivReal { to, left, right });
            asm.bind(end);
        }
        _ => dihedral(asm, place, from, to),
    }
}

/// The corners of the triangle at a halfedge; in a larger face, its start and the corners after and
/// before that.
struct Triangle {
    start: Reg,
    end: Reg,
    apex: Reg,
}

impl Triangle {
    fn at(asm: &mut Assembler, place: u32, halfedge: Reg) -> Self {
        Self {
            start: position(asm, place, &[], halfedge),
            end: position(asm, place, &[HalfedgeField::Next], halfedge),
            apex: position(asm, place, &[HalfedgeField::Prev], halfedge),
        }
    }
}

/// The position of the start of the halfedge that some pointers lead to.
fn position(asm: &mut Assembler, place: u32, path: &[HalfedgeField], halfedge: Reg) -> Reg {
    let (vertex, to) = (asm.reg(), asm.vec());
    follow(asm, place, &[path, &[HalfedgeField::Vertex]].concat(), [vertex, halfedge]);
    asm.trap_at(place, Inst::LoadPosition { to, vertex });
    to
}

/// The element that pointers lead to from a halfedge.
fn follow(asm: &mut Assembler, place: u32, path: &[HalfedgeField], [to, from]: [Reg; 2]) {
    asm.emit(Inst::Copy { to, from });
    for &field in path {
        load(asm, place, field, [to, to]);
    }
}

/// Sets a value to zero, and jumps to the label if the condition holds.
fn zero_if(asm: &mut Assembler, condition: Reg, to: Reg) -> Label {
    let (from, end) = (asm.constant_real(0.0), asm.label());
    asm.emit(Inst::Copy { to, from });
    asm.emit(Inst::JumpIf { condition, to: end });
    end
}

/// The angle between the normals on both sides, positive at a convex edge: the arc tangent of the
/// sine, which has the sign of the turn along the edge, over the cosine. It is zero on the boundary.
fn dihedral(asm: &mut Assembler, place: u32, edge: Reg, to: Reg) {
    let on_boundary = asm.reg();
    asm.trap_at(place, ask(Question::BoundaryEdge, on_boundary, edge));
    let end = zero_if(asm, on_boundary, to);
    let halfedge = asm.reg();
    first(asm, place, ElementField::Edge, [halfedge, edge]);
    let [first, second] = [&[][..], &[HalfedgeField::Twin]].map(|side| {
        let (face, to) = (asm.reg(), asm.vec());
        follow(asm, place, &[side, &[HalfedgeField::Face]].concat(), [face, halfedge]);
        asm.trap_at(place, ask(Question::NormalFace, to, face));
        to
    });
    let right = position(asm, place, &[], halfedge);
    let left = position(asm, place, &[HalfedgeField::Next], halfedge);
    let along = asm.vec();
    asm.emit(Inst::SubVec { to: along, left, right });
    let (cross, sine, cosine) = (asm.vec(), asm.reg(), asm.reg());
    let (turn, is_concave, concave) = (asm.reg(), asm.reg(), asm.reg());
    let (left, right) = (first, second);
    asm.emit(Inst::Cross { to: cross, left, right });
    asm.emit(Inst::Dot { to: cosine, left, right });
    // Normals of faces that are not flat need not be perpendicular to the edge.
    let zero = asm.constant_real(0.0);
    asm.emit(Inst::LengthVec { to: sine, from: cross });
    asm.emit(Inst::SubReal { to: concave, left: zero, right: sine });
    let (left, right) = (along, cross);
    asm.emit(Inst::Dot { to: turn, left, right });
    asm.emit(Inst::LessReal { to: is_concave, left: turn, right: zero });
    let condition = is_concave;
    asm.emit(Inst::Select { to: sine, condition, then: concave, otherwise: sine });
    let angle = arc(asm, sine, cosine, to);
    asm.emit(angle);
    asm.bind(end);
}
