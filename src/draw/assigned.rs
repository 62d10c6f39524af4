//! The positions that assignments determine: `m.position = (v0.position + v1.position) / 2`.
//!
//! Only what the picture determines is computed; numbers that come from outside count as one half.

use glam::DVec2;

use super::curve::mean;
use super::figure::Figure;
use crate::diagram::{Access, Binary, Builtin, Expr, ExprKind, NameId, Unary};

/// The value assumed for a number from outside.
const SOME: f64 = 0.5;
/// The maximum depth of expressions that are evaluated.
const DEPTH: usize = 64;

/// The vertex and the place of each assignment of a position that can be evaluated.
pub(super) fn assigned(figure: &Figure, places: &[Option<DVec2>]) -> Vec<(NameId, DVec2)> {
    let scene = Scene { figure, places };
    let assignments = figure.drawing.rule.assignments.iter();
    assignments
        .filter(|assignment| assignment.attribute == Access::Position)
        .filter_map(|assignment| {
            let at = scene.vector(&assignment.value, DEPTH)?;
            at.is_finite().then_some((assignment.target.name, at))
        })
        .collect()
}

struct Scene<'a> {
    figure: &'a Figure<'a>,
    places: &'a [Option<DVec2>],
}

impl Scene<'_> {
    fn vector(&self, expr: &Expr, depth: usize) -> Option<DVec2> {
        let depth = depth.checked_sub(1)?;
        match &expr.kind {
            ExprKind::Read(Access::Position, of) => match of.kind {
                ExprKind::Element(name) => self.places[self.figure.vertex(name)?],
                _ => None,
            },
            ExprKind::Unary(Unary::NegateVector, of) => Some(-self.vector(of, depth)?),
            ExprKind::Binary(operator, a, b) => match operator {
                Binary::AddVector => Some(self.vector(a, depth)? + self.vector(b, depth)?),
                Binary::SubtractVector => Some(self.vector(a, depth)? - self.vector(b, depth)?),
                Binary::ScaleVector => Some(self.vector(a, depth)? * self.real(b, depth)?),
                Binary::DivideVector => Some(self.vector(a, depth)? / self.real(b, depth)?),
                _ => None,
            },
            ExprKind::Call(function, of) => match (function, &of[..]) {
                (Builtin::MixVector, [a, b, t]) => {
                    let (a, b) = (self.vector(a, depth)?, self.vector(b, depth)?);
                    Some(a.lerp(b, self.real(t, depth)?))
                }
                (Builtin::CentroidEdge | Builtin::CentroidFace, [of]) => self.middle(of),
                _ => None,
            },
            _ => None,
        }
    }

    fn real(&self, expr: &Expr, depth: usize) -> Option<f64> {
        let depth = depth.checked_sub(1)?;
        match &expr.kind {
            ExprKind::Int(value) => Some(*value as f64),
            ExprKind::Real(value) => Some(*value),
            ExprKind::Local(_) => Some(SOME),
            ExprKind::Unary(Unary::ToReal, of) => self.real(of, depth),
            ExprKind::Unary(Unary::NegateReal | Unary::NegateInt, of) => {
                Some(-self.real(of, depth)?)
            }
            ExprKind::Binary(operator, a, b) => {
                let (a, b) = (self.real(a, depth)?, self.real(b, depth)?);
                match operator {
                    Binary::AddReal | Binary::AddInt => Some(a + b),
                    Binary::SubtractReal | Binary::SubtractInt => Some(a - b),
                    Binary::MultiplyReal | Binary::MultiplyInt => Some(a * b),
                    Binary::DivideReal => Some(a / b),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The centroid of an edge or face of `before`.
    fn middle(&self, of: &Expr) -> Option<DVec2> {
        let ExprKind::Element(name) = of.kind else { return None };
        let side = &self.figure.before;
        let strand = side.strands.iter().find(|strand| strand.edge == Some(name));
        let orbit = side.loops.iter().find(|orbit| orbit.face == name);
        let nodes = match (strand, orbit) {
            (Some(strand), _) => strand.ends().to_vec(),
            (None, Some(orbit)) => side.around(&orbit.darts),
            (None, None) => return None,
        };
        let places: Vec<_> = nodes.iter().filter_map(|&node| self.places[node]).collect();
        Some(mean(&places))
    }
}
