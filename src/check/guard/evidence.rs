//! Evidence: the conditions that a `require` proves.

use super::sketch::Sketch;
use crate::diagram::{
    Binary, Builtin, Drawing, Expr, ExprKind, Kind, Loop, LoopKind, NameId, Unary,
};

const REQUIRED: &str = "it is required that no edge joins its ends";
const LINK: &str = "the link condition is required";

/// The required conditions, with conjunctions taken apart.
fn required<'a>(sketch: &'a Sketch) -> Vec<&'a Expr> {
    let mut open: Vec<_> =
        sketch.drawing.rule.requires.iter().map(|require| &require.condition).collect();
    let mut all = Vec::new();
    while let Some(expr) = open.pop() {
        match &expr.kind {
            ExprKind::Binary(Binary::And, left, right) => open.extend([&**left, &**right]),
            _ => all.push(expr),
        }
    }
    all
}

/// True if a function of these elements, in any order, is required to be `holds`.
fn requires(sketch: &Sketch, function: Builtin, of: &[NameId], holds: bool) -> bool {
    let is_call = |expr: &Expr| match &expr.kind {
        ExprKind::Call(called, arguments) => {
            *called == function
                && of.len() == arguments.len()
                && of.iter().all(|&name| {
                    arguments.iter().any(|argument| argument.kind == ExprKind::Element(name))
                })
        }
        _ => false,
    };
    required(sketch).into_iter().any(|expr| match &expr.kind {
        ExprKind::Unary(Unary::Not, inner) => !holds && is_call(inner),
        _ => holds && is_call(expr),
    })
}

/// `require not adjacent(v, w)`: then an edge of `after` between them is drawn.
pub(super) fn not_adjacent(sketch: &Sketch, ends: [NameId; 2]) -> Option<&'static str> {
    let as_before = |&end: &NameId| {
        let from = sketch.arcs(end);
        sketch.drawing.survives(end) && from.iter().all(|&source| source == end)
    };
    let holds = ends.iter().all(as_before) && requires(sketch, Builtin::Adjacent, &ends, false);
    holds.then_some(REQUIRED)
}

/// `require link_condition(e)`, where the star of one end of `e` goes to the other: no
/// neighbor is shared but the tips of the triangles at `e`.
pub(super) fn neighbors(sketch: &Sketch, vertex: NameId, from: &[NameId]) -> Option<&'static str> {
    let drawing = sketch.drawing;
    let mut spokes = sketch.halfedges();
    let is_extra = |half| drawing.origin_after(half) == Some(vertex) && sketch.is_new(half);
    (!spokes.any(is_extra) && is_collapse(sketch, from)).then_some(LINK)
}

/// The same: not both ends of an edge between two faces lie on the boundary.
pub(super) fn one_hole(sketch: &Sketch, vertex: NameId, from: &[NameId]) -> Option<&'static str> {
    let none_drawn = sketch.holes_after(vertex).is_empty();
    (none_drawn && is_collapse(sketch, from)).then_some(LINK)
}

/// True if the two vertices are the ends of an erased edge, each triangle at the edge vanishes, so
/// that its other two edges become one, and the link condition of the edge is required.
fn is_collapse(sketch: &Sketch, from: &[NameId]) -> bool {
    let drawing = sketch.drawing;
    let [v, w] = from else { return false };
    let goes = |half: NameId| {
        let orbit = drawing.before.loop_of_item(half);
        orbit.is_some_and(|orbit| orbit.kind == LoopKind::Hole || vanishes(drawing, orbit, half))
    };
    let mut edges = drawing.rule.names_of(Kind::Edge);
    edges.any(|edge| {
        let Some(statement) = drawing.before.edge_statement(edge) else { return false };
        let halves = statement.halfedge_names();
        let ends = halves.map(|half| drawing.origin_before(half));
        (ends == [Some(*v), Some(*w)] || ends == [Some(*w), Some(*v)])
            && drawing.erased(edge).is_some()
            && halves.into_iter().all(goes)
            && requires(sketch, Builtin::LinkCondition, &[edge], true)
    })
}

/// True if the two other edges of a triangle become one.
fn vanishes(drawing: &Drawing, triangle: &Loop, half: NameId) -> bool {
    let others: Vec<_> = triangle.item_names().filter(|&item| item != half).collect();
    let [b, c] = others.as_slice() else { return false };
    let across = |half: NameId| drawing.before.twin(half);
    let (Some(b), Some(c)) = (across(*b), across(*c)) else { return false };
    triangle.kind == LoopKind::Face && drawing.after.twin(b) == Some(c)
}
